// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "raycast/packets/ray_arrays.h"

namespace csgcast::detail {

/// RayArrays in the form for hot loops: a pointer is null instead of an empty array.
struct RayPointers {
  std::size_t count = 0;
  const double* origin[3] = {};
  const double* direction[3] = {};
  const std::uint32_t* departure = nullptr;
  const std::uint8_t* departs_positive = nullptr;
  bool whole_line = false;
  const double* end = nullptr;
};

/// HitArrays in the same form.
struct HitPointers {
  std::uint8_t* state = nullptr;
  double* t = nullptr;
  std::uint32_t* surface = nullptr;
  std::uint8_t* root = nullptr;
  std::uint8_t* is_inside = nullptr;
};

/// FaceArrays in the same form.
struct FacePointers : HitPointers {
  double* point[3] = {};
  double* normal[3] = {};
  std::uint32_t* look = nullptr;
  std::uint8_t* comes_positive = nullptr;
  std::uint32_t* leaf = nullptr;
};

/// Preconditions: the lengths are as RayArrays requires.
RayPointers pointers_of(const RayArrays& rays);
/// Preconditions: the lengths are as HitArrays and FaceArrays require for `rays` rays. `rounds` says that t will be
/// rounded.
HitPointers pointers_of(const HitArrays& hits, std::size_t rays, bool rounds);
FacePointers pointers_of(const FaceArrays& faces, std::size_t rays);

}  // namespace csgcast::detail
