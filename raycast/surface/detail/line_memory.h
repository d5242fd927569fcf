// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "raycast/surface/detail/exact_line.h"
#include "raycast/surface/line_crossings.h"

namespace csgcast {

struct LineMemory::State {
  detail::ExactMemory exact;
  // Numbers in blocks, which never move: the present block is filled up to `used`.
  std::vector<std::vector<double>> blocks;
  std::size_t block = 0;
  std::size_t used = 0;
};

}  // namespace csgcast
