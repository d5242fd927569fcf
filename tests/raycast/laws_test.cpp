// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "csg/solid/simplify.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/membership.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

constexpr int solids = 150;
constexpr int rays = 20;

struct Cast {
  explicit Cast(const Solid& solid) : scene(compile(solid)), caster(scene) {}
  const IntervalList& operator()(const Ray& ray, Span span = Span::line()) {
    caster.begin(ray);
    caster.intervals(list, span);
    return list;
  }
  Scene scene;
  Caster caster;
  IntervalList list;
};

// The same structure, and ends that agree to far more digits than separate surfaces of a random scene.
bool alike(const IntervalList& a, const IntervalList& b) {
  const auto close = [](double s, double t) { return s == t || std::fabs(s - t) <= 1e-9 * (1 + std::fabs(s)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Interval& i, const Interval& j) {
    return close(i.entry.t, j.entry.t) && close(i.exit.t, j.exit.t);
  });
}

template <class Check>
void for_random_rays(RandomSolids& random, Check&& check) {
  for (int i = 0; i < rays; ++i) {
    const Point origin = random.point(3);
    check(Ray(origin, random.direction()));
  }
}

}  // namespace

TEST_CASE("between the ends of its intervals a ray is where exact evaluation of the tree says") {
  RandomSolids random(1);
  int checked = 0;
  for (int n = 0; n < solids; ++n) {
    const Solid solid = random.tree(1 + n % 9);
    Cast cast(solid);
    for_random_rays(random, [&](const Ray& ray) {
      const IntervalList list = cast(ray);
      for (int k = 0; k < 8; ++k) {
        const double t = random.number(-4, 4);
        const auto near_an_end = [&](const Interval& i) {
          return std::fabs(i.entry.t - t) < 1e-6 || std::fabs(i.exit.t - t) < 1e-6;
        };
        if (std::any_of(list.begin(), list.end(), near_an_end)) continue;
        const bool inside =
            std::any_of(list.begin(), list.end(), [&](const Interval& i) { return i.entry.t < t && t < i.exit.t; });
        const std::optional<bool> truth = test::contains(solid, ray.at(t));
        if (!truth) continue;
        ++checked;
        CHECK(inside == *truth);
      }
    });
  }
  CHECK(checked > 20000);
}

TEST_CASE("intervals are sorted, disjoint and never touch") {
  RandomSolids random(2);
  for (int n = 0; n < solids; ++n) {
    Cast cast(random.tree(8, [&] { return n % 2 ? random.grid_box() : random.leaf(); }));
    for_random_rays(random, [&](const Ray& ray) {
      const IntervalList& list = cast(ray);
      for (std::size_t i = 0; i < list.size(); ++i) {
        CHECK(list[i].entry.t < list[i].exit.t);
        if (i > 0) CHECK(list[i - 1].exit.t < list[i].entry.t);
      }
    });
  }
}

TEST_CASE("De Morgan's laws, and A - B = A and not B") {
  RandomSolids random(3);
  for (int n = 0; n < solids; ++n) {
    const Solid a = random.tree(3);
    const Solid b = random.tree(3);
    Cast not_union(complement(a + b)), not_a_not_b(complement(a) & complement(b));
    Cast not_both(complement(a & b)), either_not(complement(a) + complement(b));
    Cast difference(a - b), and_not(a & complement(b));
    for_random_rays(random, [&](const Ray& ray) {
      CHECK(alike(not_union(ray), not_a_not_b(ray)));
      CHECK(alike(not_both(ray), either_not(ray)));
      CHECK(alike(difference(ray), and_not(ray)));
    });
  }
}

TEST_CASE("a ray and its reverse give mirrored lists, surface by surface") {
  RandomSolids random(4);
  for (int n = 0; n < solids; ++n) {
    Cast cast(random.tree(8, [&] { return random.grid_box(); }));
    for (int i = 0; i < rays; ++i) {
      // Grid points and grid directions: ties and rays in faces on purpose.
      const Point origin{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
      const Vector direction{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
      if (direction == Vector{}) continue;
      const IntervalList forward = cast(Ray(origin, direction));
      const IntervalList& backward = cast(Ray(origin, -direction));
      REQUIRE(forward.size() == backward.size());
      for (std::size_t k = 0; k < forward.size(); ++k) {
        const Interval& mirrored = backward[backward.size() - 1 - k];
        CHECK(forward[k].entry.t == -mirrored.exit.t);
        CHECK(forward[k].entry.surface == mirrored.exit.surface);
        CHECK(forward[k].exit.t == -mirrored.entry.t);
        CHECK(forward[k].exit.surface == mirrored.entry.surface);
      }
    }
  }
}

TEST_CASE("first hit and any hit agree with the list") {
  RandomSolids random(5);
  for (int n = 0; n < solids; ++n) {
    Cast cast(random.tree(10, [&] { return n % 3 ? random.leaf() : random.grid_box(); }));
    for_random_rays(random, [&](const Ray& ray) {
      const IntervalList list = cast(ray, Span{});
      CHECK(cast.caster.any_hit() == !list.empty());
      const std::optional<Hit> hit = cast.caster.first_hit();
      const bool starts_inside = !list.empty() && !list[0].entry.surface.valid();
      if (list.empty() || (starts_inside && !list[0].exit.surface.valid())) {
        CHECK_FALSE(hit.has_value());
        return;
      }
      REQUIRE(hit.has_value());
      const Crossing& expected = starts_inside ? list[0].exit : list[0].entry;
      CHECK(hit->crossing.surface == expected.surface);
      CHECK(hit->crossing.t == expected.t);
      CHECK((hit->passage == Passage::exit) == starts_inside);
    });
  }
}

TEST_CASE("membership agrees with exact evaluation, and midpoints of intervals are inside") {
  RandomSolids random(6);
  for (int n = 0; n < solids; ++n) {
    const Solid solid = random.tree(6);
    Cast cast(solid);
    for (int i = 0; i < rays; ++i) {
      const Point p = random.point(1.5);
      const std::optional<bool> truth = test::contains(solid, p);
      if (truth) CHECK(cast.caster.locate(p) == (*truth ? Location::inside : Location::outside));
    }
    for_random_rays(random, [&](const Ray& ray) {
      for (const Interval& interval : cast(ray)) {
        if (!std::isfinite(interval.entry.t) || !std::isfinite(interval.exit.t) ||
            interval.exit.t - interval.entry.t < 1e-6)
          continue;
        CHECK(cast.caster.locate(ray.at(0.5 * (interval.entry.t + interval.exit.t))) == Location::inside);
      }
    });
  }
}

TEST_CASE("normals point out of the solid that the interval is in") {
  RandomSolids random(7);
  for (int n = 0; n < solids; ++n) {
    Cast cast(random.tree(6));
    for_random_rays(random, [&](const Ray& ray) {
      for (const Interval& interval : cast(ray)) {
        if (interval.entry.surface.valid()) {
          const Attribution entry = cast.caster.attribute({interval.entry, Passage::entry});
          CHECK(dot(entry.normal, ray.direction()) < 1e-6);
          CHECK(length(entry.normal) == Approx(1).epsilon(1e-12));
          CHECK(entry.leaf.valid());
        }
        if (interval.exit.surface.valid()) {
          CHECK(dot(cast.caster.attribute({interval.exit, Passage::exit}).normal, ray.direction()) > -1e-6);
        }
      }
    });
  }
}
