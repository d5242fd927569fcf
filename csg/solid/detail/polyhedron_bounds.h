// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "csg/base/box.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::detail {

/// A box that holds the polyhedron where every plane form is <= 0, rounded outward. It is null exactly if the
/// polyhedron holds no point.
///
/// Linear programming gives the exact extents, which are infinite where the polyhedron is unbounded. If that would cost
/// too much (thousands of planes, or numbers of thousands of digits), the box comes from the axis-aligned planes alone,
/// and an empty polyhedron may not be noticed.
Box polyhedron_bounds(std::span<const QuadricForm> planes);

}  // namespace csgcast::detail
