// SPDX-License-Identifier: MIT
#pragma once

#include "tests/stress/families.h"

namespace csgcast::stress {

/// A ray from `distance` or so away towards a point.
Ray aimed_ray(test::RandomSolids& random, Point target, double distance);
/// The ray through the images of two of its points, rounded.
Ray moved(const Ray& ray, const Transform& transform);

/// Rays past the surfaces of the trial's solid, at first hits of random rays, off the tangent plane by about
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
/// Rays between two neighbours of different lists, bisected down to the last bit: onto edges and silhouettes.
void aim_by_bisection(test::RandomSolids& random, Trial& trial, int rays);

}  // namespace csgcast::stress
