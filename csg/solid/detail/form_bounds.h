// SPDX-License-Identifier: MIT
#pragma once

#include "csg/exact/quadric_form.h"
#include "csg/solid/bounds.h"

namespace csgcast::detail {

/// A box that holds the closed set f <= 0, rounded outward. It is null if the set is known to be empty.
///
/// An axis gets the exact extent if f is positive definite in the other variables that occur in it. This holds for
/// ellipsoids, elliptic cylinders and paraboloids along an axis, and axis-aligned half-spaces. All other sides are
/// infinite.
Box bounds(const QuadricForm& f);

}  // namespace csgcast::detail
