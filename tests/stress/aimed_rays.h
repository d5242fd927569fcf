// SPDX-License-Identifier: MIT
#pragma once

#include "tests/stress/families.h"

namespace csgcast::stress {

/// A ray from `distance` or so away towards a point.
Ray aimed_ray(test::RandomSolids& random, Point target, double distance);
/// The ray through the images of two of its points, rounded.
Ray moved(const Ray& ray, const Transform& transform);

/// Rays past the surfaces of the trial's solid, at first hits of random rays, off the tangent plane by up to
/// `distance`, either way.
void aim_at_tangents(test::RandomSolids& random, Trial& trial, int rays, double distance);
/// Rays between points of the grid of quarters, and along its axes.
void aim_at_grid(test::RandomSolids& random, Trial& trial, int rays);
/// Rays through a point, exactly or a few ulps off.
void aim_at_point(test::RandomSolids& random, Trial& trial, int rays, Point target);
/// A ray, its reverse, and rays that are a few ulps to 1e-6 off.
void aim_near(test::RandomSolids& random, Trial& trial, int rays, const Ray& base);
/// Rays towards the bounds of the solid from about `distance` times its size.
void aim_at_middle(test::RandomSolids& random, Trial& trial, int rays, double distance = 2);

/// When two rays see different things.
enum class Difference {
  surfaces,   ///< a list with other surfaces: an edge between faces is enough
  intervals,  ///< a list of another length: a silhouette
};
/// Rays between two neighbours that see different things, bisected down to the last bit (2^-54 of their angle); their
/// common origin is about `distance` times the solid's size away.
void aim_by_bisection(test::RandomSolids& random, Trial& trial, int rays, Difference difference, double distance = 2);

}  // namespace csgcast::stress
