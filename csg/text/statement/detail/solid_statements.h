// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "csg/solid/solid.h"
#include "csg/text/statement/detail/call.h"

namespace csgcast::text {

// One function a solid. Sizes that leave no interior give the empty solid and a warning.

/// The solid as it is, with the warning that it is empty, and why, if it is.
Solid warn_if_empty(const Call& call, Solid solid, std::string_view why);

Solid make_cube(const Call& call);
Solid make_sphere(const Call& call);
Solid make_cylinder(const Call& call);

// quadric_statements.cpp
Solid make_ellipsoid(const Call& call);
Solid make_paraboloid(const Call& call);
Solid make_hyperboloid(const Call& call);
Solid make_quadric(const Call& call);
Solid make_halfspace(const Call& call);

// convex_statements.cpp
Solid make_convex(const Call& call);
Solid make_polyhedron(const Call& call);

}  // namespace csgcast::text
