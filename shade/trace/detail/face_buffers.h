// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/packets/ray_arrays.h"

namespace csgcast::detail {

using Numbers = std::vector<double>;
/// Vectors or points, by coordinate.
using Vectors = std::array<Numbers, 3>;

inline std::array<double*, 3> pointers(Vectors& v) { return {v[0].data(), v[1].data(), v[2].data()}; }

/// The memory of FaceArrays.
struct FaceBuffers {
  static constexpr std::size_t more = 8;  ///< stores of whole registers reach beyond

  Numbers t;
  Vectors point, normal;
  std::vector<std::uint8_t> state, comes_positive;
  std::vector<std::uint32_t> surface, look;

  void resize(std::size_t count) {
    for (Vectors* vectors : {&point, &normal})
      for (Numbers& numbers : *vectors) numbers.resize(count + more);
    t.resize(count + more);
    for (auto* list : {&state, &comes_positive}) list->resize(count);
    surface.resize(count);
    look.resize(count + more);
  }

  /// Without leaves.
  FaceArrays arrays() {
    FaceArrays faces;
    faces.state = state;
    faces.t = t;
    faces.surface = surface;
    faces.look = look;
    faces.comes_positive = comes_positive;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      faces.point[axis] = point[axis];
      faces.normal[axis] = normal[axis];
    }
    return faces;
  }
};

}  // namespace csgcast::detail
