// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/box.h"

namespace csgcast {

class ExactAffine;
class Solid;
struct LeafShape;

/// A box that holds the image of every point of a box, rounded outward. It has the exact extents of the corners. It is
/// infinite along the axes that an infinite side reaches.
Box image(const Box& box, const ExactAffine& world_from_solid);

/// A box that holds the moved leaf, rounded outward. The extents are exact for polyhedra given by points, boxes, balls,
/// ellipsoids, cylinders, cones, and quadrics that are bounded along an axis. Otherwise it is the image of the leaf's
/// own box. Precondition: world_from_solid is not singular.
Box world_bounds(const LeafShape& shape, const ExactAffine& world_from_solid);

/// A box that holds every point of the closed solid, rounded outward. It is tight for leaves. For operators it follows
/// from the boxes of the children. It has infinite sides where the solid may be unbounded, and is null where the solid
/// is known to be empty.
Box bounds(const Solid& solid);

}  // namespace csgcast
