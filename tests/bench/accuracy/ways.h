// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "raycast/surface/predicates.h"

namespace csgcast::bench {

/// A way of computing crossings, their order and t. Everything else of the caster is the same for all.
struct Way {
  std::string name;
  Predicates predicates;
};

/// From the plainest to the certified one.
std::span<const Way> ways();

}  // namespace csgcast::bench
