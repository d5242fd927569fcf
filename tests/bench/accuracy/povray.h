// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "tests/bench/accuracy/measure.h"
#include "tests/bench/accuracy/sample.h"

namespace csgcast::bench {

/// POV-Ray's first hits, by `trace()` in its scene language; nothing if there is no program `povray`, or it refuses the
/// scenes. It returns points in double precision; t is the point's projection onto the ray. A ray's time is the
/// processor's, what a loop of trace() takes more than the same loop without. Files are written to `folder`.
std::optional<FirstHits> ask_povray(std::span<const Sample> samples, const std::filesystem::path& folder);

}  // namespace csgcast::bench
