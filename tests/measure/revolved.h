// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "csg/base/transform.h"
#include "csg/base/vector.h"

namespace csgcast::test {

/// What a solid is known to come to.
struct Known {
  double volume = 0;
  double area = 0;  ///< 0: not known in closed form
  Point centroid{};
  std::array<double, 6> inertia{};  ///< about the centroid, density 1: xx, yy, zz, xy, xz, yz
};

/// c0 + c1 z + c2 z², the square of a radius.
struct Square {
  double c0 = 0, c1 = 0, c2 = 0;
  long double at(long double z) const { return c0 + (c1 + c2 * z) * z; }
};

/// A solid of revolution about the z axis, of slices between two radii.
struct Profile {
  struct Slice {
    double from, to;
    Square outer;
    Square inner{};
    bool outer_is_face = true;  ///< its sides are part of the boundary
    bool inner_is_face = true;
  };
  std::vector<Slice> slices;
  double flat_area = 0;  ///< of discs and rings square to the axis

  /// Integrals over z, by a rule that is exact for the moments' polynomials.
  Known known() const;
};

/// Of a moved solid; the transform must be rigid.
Known moved(const Known& known, const Transform& transform);

}  // namespace csgcast::test
