// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "measure/measure.h"
#include "tests/support/catch.h"

// Principal moments and axes of solids with closed forms, straight and turned: the truth is within what is told, and
// that is little.

namespace {

using namespace csgcast;

constexpr double pi = std::numbers::pi;

struct Case {
  std::string name;
  Solid solid;
  /// About the centroid, along x, y and z, which are principal.
  std::array<double, 3> moment;
};

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }

std::array<double, 3> box_moments(Vector s) {
  const double v = s.x * s.y * s.z;
  return {v * (s.y * s.y + s.z * s.z) / 12, v * (s.z * s.z + s.x * s.x) / 12, v * (s.x * s.x + s.y * s.y) / 12};
}

/// Of a body with the moment `own` of mass v, whose centroid is `by` away from the axes (Steiner).
std::array<double, 3> away(std::array<double, 3> own, double v, Vector by) {
  own[0] += v * (by.y * by.y + by.z * by.z);
  own[1] += v * (by.z * by.z + by.x * by.x);
  own[2] += v * (by.x * by.x + by.y * by.y);
  return own;
}

std::array<double, 3> sum(const std::array<double, 3>& a, double factor, const std::array<double, 3>& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

std::array<double, 3> ball_moments(double r) {
  const double moment = 0.4 * 4.0 / 3 * pi * std::pow(r, 5);
  return {moment, moment, moment};
}

/// Along z, of height h.
std::array<double, 3> cylinder_moments(double h, double r) {
  const double v = pi * r * r * h;
  const double across = v * (3 * r * r + h * h) / 12;
  return {across, across, v * r * r / 2};
}

std::vector<Case> cases() {
  const auto centered = Centering::centered;
  std::vector<Case> all;
  all.push_back({"box", box({1, 2, 3}, centered), box_moments({1, 2, 3})});
  all.push_back({"square rod", box({1, 1, 3}, centered), box_moments({1, 1, 3})});
  all.push_back({"plate", box({3, 2, 0.01}, centered), box_moments({3, 2, 0.01})});
  all.push_back({"ball", sphere(1), ball_moments(1)});
  all.push_back({"cylinder", cylinder(2, 0.5, 0.5, centered), cylinder_moments(2, 0.5)});
  const double cone = pi * 2 / 3;  // of height 2 and radius 1
  all.push_back({"cone", cylinder(2, 1, 0), {cone * 0.15 * 2, cone * 0.15 * 2, cone * 0.3}});
  const double ellipsoid_volume = 4.0 / 3 * pi * 0.5 * 1 * 1.5;
  all.push_back(
      {"ellipsoid",
       ellipsoid({0.5, 1, 1.5}),
       {ellipsoid_volume * (1 + 2.25) / 5, ellipsoid_volume * (2.25 + 0.25) / 5, ellipsoid_volume * (0.25 + 1) / 5}});
  all.push_back({"shell", sphere(1) - sphere(0.75), sum(ball_moments(1), -1, ball_moments(0.75))});
  all.push_back({"tube", cylinder(2, 1, 1, centered) - cylinder(4, 0.5, 0.5, centered),
                 sum(cylinder_moments(2, 1), -1, cylinder_moments(2, 0.5))});
  all.push_back({"box with an elliptic bore",
                 box({4, 3, 1}, centered) - (quadric({1, 4, 0, 0, 0, 0}, {0, 0, 0}, -1) & box({9, 9, 9}, centered)),
                 sum(box_moments({4, 3, 1}), -pi / 2, {0.25 / 4 + 1.0 / 12, 1.0 / 4 + 1.0 / 12, 1.25 / 4})});
  const double ball = 4.0 / 3 * pi;
  all.push_back({"dumb-bell of two balls", shifted(sphere(1), {-2, 0, 0}) + shifted(sphere(1), {2, 0, 0}),
                 sum({}, 2, away(ball_moments(1), ball, {2, 0, 0}))});
  all.push_back({"cross of rods", box({4, 1, 1}, centered) + box({1, 3, 1}, centered),
                 sum(sum(box_moments({4, 1, 1}), 1, box_moments({1, 3, 1})), -1, box_moments({1, 1, 1}))});
  all.push_back({"box and two ends",
                 unite({box({2, 1, 1}, centered), shifted(box({1, 2, 3}, centered), {1.5, 0, 0}),
                        shifted(box({1, 2, 3}, centered), {-1.5, 0, 0})}),
                 sum(box_moments({2, 1, 1}), 2, away(box_moments({1, 2, 3}), 6, {1.5, 0, 0}))});
  all.push_back(
      {"far frame of four balls",
       unite({shifted(sphere(0.5), {3, 0, 0}), shifted(sphere(0.5), {-3, 0, 0}), shifted(sphere(0.5), {0, 2, 0}),
              shifted(sphere(0.5), {0, -2, 0})}),
       sum(sum({}, 2, away(ball_moments(0.5), ball / 8, {3, 0, 0})), 2, away(ball_moments(0.5), ball / 8, {0, 2, 0}))});
  return all;
}

double sine_between(Vector a, Vector b) { return length(cross(normalised(a), normalised(b))); }

Vector turned(const Transform& t, std::size_t axis) { return {t(0, axis), t(1, axis), t(2, axis)}; }

void check_one(const Case& c, const Transform& placed) {
  INFO(c.name);
  const Scene scene = compile(transformed(c.solid, placed));
  MeasureOptions options;
  options.relative_error = 1e-6;
  options.relative_area_error = HUGE_VAL;
  const Measures m = measure(scene, scene.root(), 1, options);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return c.moment[a] < c.moment[b]; });
  const double greatest = c.moment[order[2]];
  CHECK(m.principal_error < 1e-4 * greatest);
  // Closed forms and the entries of rotations round themselves.
  constexpr double own = 1e-14;
  for (std::size_t i = 0; i < 3; ++i) {
    const double known = c.moment[order[i]];
    CHECK(std::fabs(m.principal_moments[i] - known) <= m.principal_error + own * greatest);
    double gap = HUGE_VAL;  // to the nearest of the others
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != i) gap = std::fmin(gap, std::fabs(c.moment[order[k]] - known));
    }
    if (gap < 1e-12 * greatest) {
      CHECK(std::isinf(m.principal_angles[i]));
    } else {
      CHECK(m.principal_angles[i] < 4 * m.principal_error / gap + 1e-12);
      CHECK(m.principal_angles[i] < 0.01);
      CHECK(sine_between(m.principal_axes[i], turned(placed, order[i])) <= m.principal_angles[i] + own);
    }
  }
  CHECK(dot(cross(m.principal_axes[0], m.principal_axes[1]), m.principal_axes[2]) == Approx(1).epsilon(1e-14));
}

}  // namespace

TEST_CASE("Principal moments and axes of solids with closed forms are within their bounds") {
  for (const Case& c : cases()) check_one(c, Transform{});
}

TEST_CASE("Principal moments and axes of turned and moved solids are within their bounds") {
  Transform placed = rotation(30, Vector{1, 2, 3});
  for (std::size_t i = 0; i < 3; ++i) placed.entry[4 * i + 3] = 5.0 - 3.0 * static_cast<double>(i);
  for (const Case& c : cases()) check_one(c, placed);
}

TEST_CASE("An empty solid has no principal axes, of an unbounded one nothing is known") {
  const Scene empty = compile(box({1, 1, 1}) & transformed(box({1, 1, 1}), translation({3, 0, 0})));
  const Measures nothing = measure(empty, empty.root(), 1);
  CHECK(nothing.principal_moments == std::array<double, 3>{});
  CHECK(nothing.principal_error == 0);
  for (const double angle : nothing.principal_angles) CHECK(std::isinf(angle));
  const Scene unbounded = compile(halfspace({0, 0, 1}, 0));
  const Measures unknown = measure(unbounded, unbounded.root(), 1);
  CHECK(std::isnan(unknown.principal_moments[0]));
  CHECK(std::isinf(unknown.principal_error));
  CHECK(std::isnan(unknown.principal_axes[2].x));
  CHECK(std::isinf(unknown.principal_angles[2]));
}
