// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "tests/bench/accuracy/measure.h"
#include "tests/bench/accuracy/sample.h"

namespace csgcast::bench {

/// First hits of unions of balls by Embree's spheres, in single precision, with its robust flag. Nothing for other
/// solids, or for numbers that are no floats.
std::optional<FirstHits> ask_embree(std::span<const Sample> samples);

}  // namespace csgcast::bench
