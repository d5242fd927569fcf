// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "raycast/packets/ray_arrays.h"

namespace csgcast::detail {

/// RayArrays as the hot loops take them: null instead of empty.
struct RayPointers {
  std::size_t count = 0;
  const double* origin[3] = {};
  const double* direction[3] = {};
  const std::uint32_t* departure = nullptr;
  const std::uint8_t* departs_positive = nullptr;
  bool whole_line = false;
  const double* end = nullptr;
};

/// HitArrays, likewise.
struct HitPointers {
  std::uint8_t* state = nullptr;
  double* t = nullptr;
  std::uint32_t* surface = nullptr;
  std::uint8_t* root = nullptr;
  std::uint8_t* is_inside = nullptr;
};

/// FaceArrays, likewise.
struct FacePointers : HitPointers {
  double* point[3] = {};
  double* normal[3] = {};
  std::uint32_t* look = nullptr;
  std::uint8_t* comes_positive = nullptr;
  std::uint32_t* leaf = nullptr;
};

/// Preconditions: what RayArrays says of lengths.
RayPointers pointers_of(const RayArrays& rays);
/// Preconditions: what HitArrays and FaceArrays say of lengths, for that many rays. `rounds`: t is to be rounded.
HitPointers pointers_of(const HitArrays& hits, std::size_t rays, bool rounds);
FacePointers pointers_of(const FaceArrays& faces, std::size_t rays);

}  // namespace csgcast::detail
