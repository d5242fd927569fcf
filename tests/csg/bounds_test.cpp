// SPDX-License-Identifier: MIT
#include "csg/solid/bounds.h"

#include <cmath>
#include <limits>

#include "csg/exact/hull.h"
#include "tests/csg/membership.h"
#include "tests/support/catch.h"

using namespace csgcast;
using csgcast::testing::contains;
using csgcast::testing::Random;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool holds(const Box& outer, const Box& inner) { return inner.is_null() || hull(outer, inner) == outer; }

bool has_nan(const Box& b) {
  return std::isnan(b.lower.x + b.lower.y + b.lower.z) || std::isnan(b.upper.x + b.upper.y + b.upper.z);
}

// The outer box is no more than a share of its size beyond the inner one.
bool is_close(const Box& outer, const Box& inner, double share) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double slack = share * (std::fabs(outer.lower[axis]) + std::fabs(outer.upper[axis]));
    if (inner.lower[axis] - outer.lower[axis] > slack || outer.upper[axis] - inner.upper[axis] > slack) return false;
  }
  return true;
}

const Transform turned = rotation(37, {1, 2, 3});

}  // namespace

TEST_CASE("null, degenerate, finite and infinite boxes are told apart") {
  CHECK(Box{}.is_null());
  CHECK_FALSE(Box{}.is_finite());
  const Box point{{1, 2, 3}, {1, 2, 3}};
  CHECK_FALSE(point.is_null());
  CHECK(point.is_finite());
  CHECK(point.contains({1, 2, 3}));
  CHECK_FALSE(Box::everything().is_finite());
  CHECK(Box::everything().contains({1e308, -1e308, 0}));
  CHECK_FALSE(Box{}.contains({0, 0, 0}));
}

TEST_CASE("hulls and intersections of boxes, null ones among them") {
  const Box a{{0, 0, 0}, {1, 1, 1}}, b{{1, 0, 0}, {2, 3, 1}}, c{{5, 5, 5}, {6, 6, 6}};
  CHECK(hull(a, b) == Box{{0, 0, 0}, {2, 3, 1}});
  CHECK(hull(a, Box{}) == a);
  CHECK(hull(Box{}, a) == a);
  CHECK(intersection(a, b) == Box{{1, 0, 0}, {1, 1, 1}});
  CHECK(intersection(a, c) == Box{});
  CHECK(intersection(a, Box::everything()) == a);
  CHECK(intersection(a, Box{}).is_null());
}

TEST_CASE("the centre of a box lies in it without overflow") {
  CHECK(Box{{1, 2, 3}, {3, 2, 5}}.center() == Point{2, 2, 4});
  CHECK(Box{{1e308, 0, 0}, {1.7e308, 0, 0}}.center().x == 1.35e308);
  CHECK(Box::everything().center() == Point{0, 0, 0});
}

TEST_CASE("the image of a box has the extents of its corners, and infinite sides stay infinite where they reach") {
  const ExactAffine quarter(rotation({0, 0, 90}));
  CHECK(image(Box{{0, 0, 0}, {1, 2, 3}}, quarter) == Box{{-2, 0, 0}, {0, 1, 3}});
  const Box half_infinite{{0, 0, 0}, {infinity, 2, 3}};
  CHECK(image(half_infinite, quarter) == Box{{-2, 0, 0}, {0, infinity, 3}});
  const ExactAffine shear(Transform{{1, -1, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}});
  CHECK(image(Box{{0, 0, 0}, {infinity, infinity, 1}}, shear) == Box{{-infinity, 0, 0}, {infinity, infinity, 1}});
  CHECK(image(Box{}, quarter).is_null());
  CHECK(image(Box::everything(), ExactAffine(turned)) == Box::everything());
}

TEST_CASE("a turned ball keeps its size to the rounding of its matrix") {
  const Box box = bounds(transformed(sphere(2), turned));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CHECK(std::fabs(box.upper[axis] - 2) <= 8 * 0x1p-52);
    CHECK(std::fabs(box.lower[axis] + 2) <= 8 * 0x1p-52);
  }
  CHECK(bounds(transformed(sphere(2), translation({1, 2, 3}))) == Box{{-1, 0, 1}, {3, 4, 5}});
}

TEST_CASE("turned cylinders and cones have the extents of their rims") {
  CHECK(bounds(transformed(cylinder(3, 1, 1), rotation({90, 0, 0}))) == Box{{-1, -3, -1}, {1, 0, 1}});
  const double s = std::sqrt(0.5);
  const Box cone = bounds(transformed(cylinder(3, 1, 0), rotation({45, 0, 0})));
  CHECK(holds(cone, Box{{-1, -3 * s, -s}, {1, s, 3 * s}}));
  CHECK(is_close(cone, Box{{-1, -3 * s, -s}, {1, s, 3 * s}}, 4 * 0x1p-53));
}

TEST_CASE("a turned box has the extents of its corners") {
  const double s = std::sqrt(0.5);
  const Box box_45 = bounds(transformed(box({1, 2, 3}), rotation({0, 0, 45})));
  CHECK(is_close(box_45, Box{{-2 * s, 0, 0}, {s, 3 * s, 3}}, 4 * 0x1p-53));
}

TEST_CASE("quadrics are bounded on every axis on which they are") {
  CHECK(bounds(quadric({1, 1, 1, 0, 0, 0}, {-2, 0, 0}, 0)) == Box{{0, -1, -1}, {2, 1, 1}});
  CHECK(bounds(quadric({1, 1, 0, 0, 0, 0}, {-2, 0, 0}, 0)) == Box{{0, -1, -infinity}, {2, 1, infinity}});
  CHECK(bounds(quadric({1, 0, 0, 0, 0, 0}, {}, -4)) == Box{{-2, -infinity, -infinity}, {2, infinity, infinity}});
  CHECK(bounds(quadric({1, 1, 0, 0, 0, 0}, {0, 0, -1}, 0)) ==
        Box{{-infinity, -infinity, 0}, {infinity, infinity, infinity}});
  CHECK(bounds(quadric({-1, -1, -1, 0, 0, 0}, {}, 1)) == Box::everything());
  CHECK(bounds(quadric({1, 1, -1, 0, 0, 0}, {}, -1)) == Box::everything());
  const Box irrational = bounds(quadric({1, 1, 1, 0, 0, 0}, {}, -2));
  const double root = irrational.upper.x, below = std::nextafter(root, 0);
  CHECK(Dyadic(root) * Dyadic(root) > Dyadic(2.0));
  CHECK(Dyadic(below) * Dyadic(below) < Dyadic(2.0));
}

TEST_CASE("an ellipsoid as a quadric and by its semi-axes is bounded alike under any transform") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Solid named_one = ellipsoid({2, 1, 0.5});
    const Solid general = quadric({0.25, 1, 4, 0, 0, 0}, {}, -1);
    Transform t = random.transform();
    const Box a = bounds(transformed(named_one, t)), b = bounds(transformed(general, t));
    CHECK(a == b);
  }
}

TEST_CASE("a moved half-space keeps one finite side while it is axis-aligned") {
  const Solid below = halfspace({0, 0, 3}, 6);
  CHECK(bounds(below) == Box{{-infinity, -infinity, -infinity}, {infinity, infinity, 2}});
  CHECK(bounds(transformed(below, rotation({90, 0, 0}))) ==
        Box{{-infinity, -2, -infinity}, {infinity, infinity, infinity}});
  CHECK(bounds(transformed(below, turned)) == Box::everything());
}

TEST_CASE("planes and points of the same polyhedron give the same box") {
  Random random(2);
  for (int round = 0; round < 30; ++round) {
    std::vector<Point> points;
    const auto coordinate = [&] { return static_cast<double>(random.below(41)) - 20; };
    for (int i = 0; i < 12; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
    std::vector<PlaneEquation> planes;
    for (const auto& [a, b, c] : convex_hull(points)) {
      const Vector n = cross(points[b] - points[a], points[c] - points[a]);  // small integers: exact
      planes.push_back({n, dot(n, points[a])});
    }
    CHECK(bounds(convex_from_planes(planes)) == bounds(convex_from_points(points)));
  }
}

TEST_CASE("operators combine the boxes of their children") {
  const Solid a = box({2, 2, 2}), b = transformed(box({2, 2, 2}), translation({1, 0, 0})),
              far = transformed(a, translation({9, 0, 0}));
  CHECK(bounds(a + b) == Box{{0, 0, 0}, {3, 2, 2}});
  CHECK(bounds(a & b) == Box{{1, 0, 0}, {2, 2, 2}});
  CHECK(bounds(a - b) == bounds(a));
  CHECK(bounds(a & far).is_null());
  CHECK(bounds(complement(a)) == Box::everything());
  CHECK(bounds(complement(Solid::everything())).is_null());
  CHECK(bounds(complement(Solid())) == Box::everything());
  CHECK(bounds(Solid()).is_null());
  CHECK(bounds(Solid::everything()) == Box::everything());
  CHECK(bounds(named(with_look(a, {}), {"a", 1})) == bounds(a));
  CHECK(bounds(transformed(b, rotation({0, 0, 90}))) == Box{{-2, 1, 0}, {0, 3, 2}});
}

TEST_CASE("nested transforms compose exactly before anything is rounded") {
  // Scaling by 0.1 and then by 10 is off by the rounding of 0.1; a box of boxes would also round the step between.
  const Solid solid = transformed(transformed(box({1, 1, 1}), scaling({0.1, 0.1, 0.1})), scaling({10, 10, 10}));
  CHECK(bounds(solid).upper.x == std::nextafter(1.0, 2));
  CHECK(bounds(transformed(transformed(sphere(1), turned), translation({1e16, 0, 0}))).upper.y < 1.0001);
}

TEST_CASE("bounds hold every sampled point of random leaves under random transforms") {
  Random random(3);
  std::size_t inside = 0;
  for (int i = 0; i < 300; ++i) {
    const Solid solid = transformed(transformed(random.bounded_leaf(), random.transform()), random.transform());
    const Box box = bounds(solid);
    CHECK(box.is_finite());
    for (int k = 0; k < 40; ++k) {
      const Vector size = box.size();  // from a fifth beyond one side to a fifth beyond the other
      const Point p =
          box.center() + Vector{random.number(0.6) * size.x, random.number(0.6) * size.y, random.number(0.6) * size.z};
      if (!contains(solid, p).value_or(false)) continue;
      ++inside;
      CHECK(box.contains(p));
    }
  }
  CHECK(inside > 2000);
}

TEST_CASE("bounds hold every sampled point of random trees, unbounded ones among them, and are never NaN") {
  Random random(4);
  std::size_t inside = 0;
  for (int i = 0; i < 400; ++i) {
    const Solid solid = random.tree(6);
    const Box box = bounds(solid);
    CHECK_FALSE(has_nan(box));
    for (int k = 0; k < 20; ++k) {
      const Point p = random.point(3);
      if (!contains(solid, p).value_or(false)) continue;
      ++inside;
      CHECK(box.contains(p));
    }
  }
  CHECK(inside > 500);
}

TEST_CASE("extreme numbers give wide bounds, never NaN") {
  const Transform blow_up = scaling({1e300, 1e300, 1e300}), shrink = scaling({1e-300, 1e-300, 1e-300});
  Solid huge = sphere(1), tiny = box({1, 1, 1}), lost = cylinder(1, 1, 2);
  for (int i = 0; i < 20; ++i) {
    huge = transformed(huge, blow_up);
    tiny = transformed(tiny, shrink);
    lost = transformed(transformed(lost, shrink), translation({1, 1, 1}));
  }
  CHECK(bounds(huge) == Box::everything());
  CHECK(bounds(tiny) == Box{{0, 0, 0}, {5e-324, 5e-324, 5e-324}});
  CHECK(bounds(lost).contains({1, 1, 1}));
  CHECK(bounds(lost).size().x < 1e-15);
}

TEST_CASE("bounds of very deep trees and of sharing that unfolds without end take a moment") {
  constexpr int depth = 100'000;
  Solid booleans = sphere(1), turns = sphere(1), shared = sphere(1), shared_turns = sphere(1);
  for (int i = 0; i < depth; ++i) booleans = i % 2 == 0 ? booleans + box({2, 2, 2}) : booleans - sphere(1);
  CHECK(bounds(booleans) == Box{{-1, -1, -1}, {2, 2, 2}});
  for (int i = 0; i < depth / 5; ++i) turns = transformed(turns, turned);
  CHECK(holds(bounds(turns), Box{{-0.9, -0.9, -0.9}, {0.9, 0.9, 0.9}}));
  for (int i = 0; i < 200; ++i) shared = shared + shared;
  CHECK(bounds(shared) == bounds(sphere(1)));
  for (int i = 0; i < 60; ++i) shared_turns = shared_turns + transformed(shared_turns, translation({1, 0, 0}));
  const Box row = bounds(shared_turns);
  CHECK(row.contains({60.5, 0, 0}));
  CHECK(row.lower.x == -1);
}
