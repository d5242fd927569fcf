// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "tests/bench/peers/part_tree.h"
#include "tests/support/ray_batch.h"

namespace csgcast::bench {

using test::RayBatch;

/// Rays side by side, and what is computed once for all parts.
template <std::size_t lanes>
struct LaneRays {
  alignas(64) double origin[3][lanes];
  alignas(64) double direction[3][lanes];
  alignas(64) double inverse[3][lanes];   ///< of the direction; huge where that is zero, so that no 0 * inf comes up
  alignas(64) double over_square[lanes];  ///< 1 / |direction|²

  LaneRays(const RayBatch& rays, std::size_t first) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        origin[axis][lane] = rays.origin(axis, first)[lane];
        direction[axis][lane] = rays.direction(axis, first)[lane];
        inverse[axis][lane] = 1 / (direction[axis][lane] == 0 ? 1e-200 : direction[axis][lane]);
      }
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      over_square[lane] = 1 / (direction[0][lane] * direction[0][lane] + direction[1][lane] * direction[1][lane] +
                               direction[2][lane] * direction[2][lane]);
    }
  }
};

/// Where a line is in a convex part: between two t, nowhere if they are out of order.
struct Stretch {
  double entry;
  double exit;
};

inline double lesser(double a, double b) { return a < b ? a : b; }
inline double greater(double a, double b) { return a > b ? a : b; }

// One function for each kind of part, without branches, so that a loop over lanes becomes vector code.

template <std::size_t lanes>
Stretch stretch(const Ball& ball, const LaneRays<lanes>& rays, std::size_t lane) {
  const double x = rays.origin[0][lane] - ball.center.x, dx = rays.direction[0][lane];
  const double y = rays.origin[1][lane] - ball.center.y, dy = rays.direction[1][lane];
  const double z = rays.origin[2][lane] - ball.center.z, dz = rays.direction[2][lane];
  const double over_square = rays.over_square[lane];
  const double middle = -(x * dx + y * dy + z * dz) * over_square;
  // From the centre to the line: squares of this do not cancel as those of the usual discriminant do.
  const double px = x + middle * dx, py = y + middle * dy, pz = z + middle * dz;
  const double left = ball.radius * ball.radius - (px * px + py * py + pz * pz);
  const double half = std::sqrt(greater(left, 0) * over_square);
  return {middle - half, left > 0 ? middle + half : -std::numeric_limits<double>::infinity()};
}

template <std::size_t lanes>
Stretch slab(double lower, double upper, std::size_t axis, const LaneRays<lanes>& rays, std::size_t lane) {
  const double a = (lower - rays.origin[axis][lane]) * rays.inverse[axis][lane];
  const double b = (upper - rays.origin[axis][lane]) * rays.inverse[axis][lane];
  return {lesser(a, b), greater(a, b)};
}

inline Stretch overlap(Stretch a, Stretch b) { return {greater(a.entry, b.entry), lesser(a.exit, b.exit)}; }

template <std::size_t lanes>
Stretch stretch(const Brick& brick, const LaneRays<lanes>& rays, std::size_t lane) {
  return overlap(
      overlap(slab(brick.lower.x, brick.upper.x, 0, rays, lane), slab(brick.lower.y, brick.upper.y, 1, rays, lane)),
      slab(brick.lower.z, brick.upper.z, 2, rays, lane));
}

/// A frustum of one radius.
struct Rod {
  Frustum frustum;
};

template <std::size_t lanes>
Stretch stretch(const Rod& rod, const LaneRays<lanes>& rays, std::size_t lane) {
  const Frustum& f = rod.frustum;
  const std::size_t u = (f.axis + 1) % 3, v = (f.axis + 2) % 3;
  const double x = rays.origin[u][lane] - f.bottom[u], dx = rays.direction[u][lane];
  const double y = rays.origin[v][lane] - f.bottom[v], dy = rays.direction[v][lane];
  // Along the axis the line is in or out for good: tiny stands for zero.
  const double over_square = 1 / greater(dx * dx + dy * dy, 1e-200);
  const double middle = -(x * dx + y * dy) * over_square;
  const double px = x + middle * dx, py = y + middle * dy;
  const double left = f.bottom_radius * f.bottom_radius - (px * px + py * py);
  const double half = std::sqrt(greater(left, 0) * over_square);
  const Stretch round{middle - half, left > 0 ? middle + half : -std::numeric_limits<double>::infinity()};
  return overlap(round, slab(f.bottom[f.axis], f.bottom[f.axis] + f.height, f.axis, rays, lane));
}

/// The rest of frustums, cones: few, and with branches.
template <std::size_t lanes>
Stretch stretch(const Frustum& f, const LaneRays<lanes>& rays, std::size_t lane) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t u = (f.axis + 1) % 3, v = (f.axis + 2) % 3, w = f.axis;
  const double x = rays.origin[u][lane] - f.bottom[u], dx = rays.direction[u][lane];
  const double y = rays.origin[v][lane] - f.bottom[v], dy = rays.direction[v][lane];
  const double slope = (f.top_radius - f.bottom_radius) / f.height;
  const double radius = f.bottom_radius + slope * (rays.origin[w][lane] - f.bottom[w]);
  const double widening = slope * rays.direction[w][lane];
  // a t² + 2 b t + c <= 0 is the cone with both its nappes; only one of them is between bottom and top.
  const double a = dx * dx + dy * dy - widening * widening;
  const double b = x * dx + y * dy - radius * widening;
  const double c = x * x + y * y - radius * radius;
  const double left = b * b - a * c;
  const Stretch between = slab(f.bottom[w], f.bottom[w] + f.height, w, rays, lane);
  if (left < 0) return a < 0 ? between : Stretch{infinity, -infinity};
  const double q = -(b + std::copysign(std::sqrt(left), b));
  const double first = a == 0 ? infinity : q / a, second = q == 0 ? first : c / q;
  const double lower = lesser(first, second), upper = greater(first, second);
  if (a > 0) return overlap({lower, upper}, between);
  if (a == 0) return overlap(b > 0 ? Stretch{-infinity, second} : Stretch{second, infinity}, between);
  return overlap(widening > 0 ? Stretch{upper, infinity} : Stretch{-infinity, lower}, between);
}

}  // namespace csgcast::bench
