// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "csg/solid/solid.h"

namespace csgcast::bench {

/// Whether faces within a union at the top of the tree can be seen from where the rays start.
enum class InnerFaces { hidden, seen };

/// A solid as a POV-Ray object; one that nothing hits if it is empty or everything. Spheres, boxes, cylinders and cones
/// are POV-Ray's own, other leaves intersections of `plane` and `quadric`; transforms are `matrix`. A union is a
/// `merge`, but for one at the top whose inner faces are hidden: that is the faster `union`. Numbers read back to the
/// same doubles; where a coefficient is none, it is the nearest. Recurses: for trees a few thousand deep at most.
std::string pov_object(const Solid& solid, InnerFaces inner_faces);

/// <x, y, z> so that it reads back to the same doubles.
std::string pov_vector(double x, double y, double z);

}  // namespace csgcast::bench
