// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "csg/exact/quadric_form.h"
#include "raycast/scene.h"
#include "raycast/surface.h"

namespace csgcast::detail {

/// The surfaces of a scene, one for each canonical form: proportional forms share an id, and the sign of the factor is
/// the sense.
class SurfaceTable {
 public:
  /// The half-space f <= 0. `center` is near the leaf. Precondition: f is not constant.
  HalfSpace half_space(const QuadricForm& f, Point center);

  std::vector<Surface> take() { return std::move(surfaces_); }

 private:
  std::vector<Surface> surfaces_;
  std::unordered_multimap<std::size_t, SurfaceId> by_hash_;
};

}  // namespace csgcast::detail
