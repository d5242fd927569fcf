// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace csgcast {

/// Rays as arrays, a number a ray, in the scene's coordinates. They must be within Ray::in_range.
struct RayArrays {
  std::size_t count = 0;
  const double* origin[3] = {};
  const double* direction[3] = {};
  const std::uint32_t* departure = nullptr;  ///< the surface that each ray starts on (Departure); null: no ray does
  const std::uint8_t* departs_positive = nullptr;  ///< whether towards its positive side, to which it must go
  bool whole_line = false;                         ///< from -infinity on, not from 0; no ray departs then
  const double* end = nullptr;                     ///< the t up to which each ray is asked; null: infinity
};

/// Where rays first cross the solid's boundary, as arrays of as many numbers.
struct HitArrays {
  enum State : std::uint8_t { none, entry, exit };

  std::uint8_t* state = nullptr;      ///< without a hit the other numbers mean nothing
  double* t = nullptr;                ///< Crossing::t
  std::uint32_t* surface = nullptr;   ///< SurfaceId
  std::uint8_t* root = nullptr;       ///< Crossing::root; may be null where t is not rounded
  std::uint8_t* is_inside = nullptr;  ///< whether the ray starts inside the solid; may be null
};

/// And the faces there. `leaf` may be null: then it is not asked for.
struct FaceArrays : HitArrays {
  double* point[3] = {};                   ///< Attribution::point, ..
  double* normal[3] = {};                  ///< unit, out of the solid
  std::uint32_t* look = nullptr;           ///< LookId
  std::uint8_t* comes_positive = nullptr;  ///< Attribution::front is the positive side
  std::uint32_t* leaf = nullptr;           ///< LeafId
};

}  // namespace csgcast
