// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/box.h"

namespace csgcast {

class ExactAffine;
class Solid;
struct LeafShape;

/// A box that holds the image of every point of a box, rounded outward: the exact extents of its corners, infinite
/// along the axes that an infinite side reaches.
Box image(const Box& box, const ExactAffine& world_from_solid);

/// A box that holds the moved leaf, rounded outward: the exact extents of polyhedra given by points, boxes, balls,
/// ellipsoids, cylinders, cones, and of quadrics that are bounded along an axis; else the image of the leaf's own box.
/// Precondition: world_from_solid is not singular.
Box world_bounds(const LeafShape& shape, const ExactAffine& world_from_solid);

/// A box that holds every point of the closed solid, rounded outward: tight for leaves, what the boxes of the children
/// give for operators. Infinite sides where the solid may be unbounded, null where it is known to be empty.
Box bounds(const Solid& solid);

}  // namespace csgcast
