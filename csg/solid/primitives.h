// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "csg/base/digits.h"
#include "csg/solid/solid.h"

namespace csgcast {

enum class Centering { corner, centered };

// Sizes that leave no interior (zero or negative, as the scene text allows them) give the empty solid. All numbers must
// be finite; otherwise Error(bad_value) without a place is thrown. `digits` tells how well they are known.

/// The box [0, size] on each axis, or [-size/2, size/2].
Solid box(Vector size, Centering centering = Centering::corner, Digits digits = {});
/// A ball about the origin.
Solid sphere(double radius, Digits digits = {});
/// z is in [0, height] or [-height/2, height/2]. The radius changes linearly from bottom to top. One of the radii may
/// be 0 (a cone).
Solid cylinder(double height, double bottom_radius, double top_radius, Centering centering = Centering::corner,
               Digits digits = {});
/// An ellipsoid about the origin, with semi-axes along x, y and z.
Solid ellipsoid(Vector semi_axes, Digits digits = {});
/// The set height (x² + y²) / radius² <= z <= height.
Solid paraboloid(double height, double radius, Digits digits = {});
/// |z| <= height/2 inside the surface of revolution with radius `waist` at z = 0 and `radius` at z = ±height/2.
/// waist = 0 is a double cone, waist = radius a cylinder, waist > radius a barrel; not both zero.
Solid hyperboloid(double height, double radius, double waist, Digits digits = {});

/// The set pᵀAp + bᵀp + c <= 0. `a` holds xx, yy, zz, xy, xz, yz of the symmetric matrix; xy is the single entry, which
/// counts twice. Any of the 17 kinds is allowed. The result may be unbounded, empty, everything, or without interior
/// (then it is empty as a regular set).
Solid quadric(const std::array<double, 6>& a, Vector b, double c, Digits digits = {});
/// The set n . p <= d. Throws Error(bad_value) if n = 0.
Solid halfspace(Vector normal, double distance, Digits digits = {});

struct PlaneEquation {
  Vector normal;
  double distance = 0;
};
/// The points with n . p <= d for every plane. The set may be unbounded or empty.
Solid convex_from_planes(std::span<const PlaneEquation> planes, Digits digits = {});
/// The exact convex hull of the points. Every orientation is decided exactly; nothing is perturbed or merged. Points
/// that all lie in one plane give the empty solid. Source: Clarkson and Shor 1989 (randomised incremental), see
/// csg/exact/hull.h.
Solid convex_from_points(std::span<const Point> points, Digits digits = {});
/// The same of points computed from sizes, which are known to a share on each axis: 1 ± axes.
Solid convex_from_points(std::span<const Point> points, Vector axes);

}  // namespace csgcast
