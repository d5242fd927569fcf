// SPDX-License-Identifier: MIT
// The sides of surfaces from which rays never come back to the solid (Scene::leads_away).
#include <cmath>
#include <optional>
#include <vector>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/at.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::at;
using test::RandomSolids;

namespace {

Solid centered_box(double side) { return box({side, side, side}, Centering::centered); }

// Whether the first face that a ray meets leads away on the ray's side, and on the other one.
struct Seen {
  bool here, beyond;
  friend bool operator==(const Seen&, const Seen&) = default;
};

Seen seen(const Solid& solid, Point origin, Vector direction) {
  const Scene scene = compile(solid, Welding::derived());
  Caster caster(scene);
  caster.begin(Ray(origin, direction));
  const std::optional<Hit> hit = caster.first_hit();
  REQUIRE(hit);
  const Sense front = caster.attribute(*hit).front;
  const SurfaceId surface = hit->crossing.surface;
  return {scene.leads_away(surface, front), scene.leads_away(surface, opposite(front))};
}

constexpr Seen away{true, false};
constexpr Seen neither{false, false};

constexpr Vector down{0, 0, -1};
constexpr Vector up{0, 0, 1};

// A direction that rises from a plane by a cosine: any one by 1.
Vector rising(RandomSolids& random, Vector normal, double rise) {
  const Vector any = random.direction();
  if (rise == 1) return any;
  const Vector across = normalised(any - dot(any, normal) * normal);
  return across - dot(across, normal) * normal + rise * normal;
}

// Sends rays to the sides that lead away, from where others meet the solid: how many there were.
int check_departures(const Solid& solid, RandomSolids& random, Point center, double radius, int rays) {
  const Scene scene = compile(solid, Welding::derived());
  if (scene.sides_that_lead_away().empty()) return 0;
  Caster caster(scene);
  int sent = 0;
  const auto depart = [&](SurfaceId surface, const Attribution& face, bool outwards) {
    const Sense outside = outwards ? face.front : opposite(face.front);
    if (!scene.leads_away(surface, outside) || !is_finite(face.point)) return;
    const Vector normal = as_vector(face.normal);
    for (const double rise : {1.0, 1e-2, 1.01 * clear_departure}) {
      const Vector direction = rising(random, normal, rise);
      if (!(dot(normal, normalised(direction)) > clear_departure)) continue;
      caster.begin(Ray(face.point, direction), Departure{surface, outside});
      const bool meets_something = caster.any_hit();
      CAPTURE(rise, face.point.x, face.point.y, face.point.z, direction.x, direction.y, direction.z);
      REQUIRE(!meets_something);
      ++sent;
    }
  };
  IntervalList list;
  std::vector<std::pair<Crossing, Attribution>> ends;
  for (int i = 0; i < rays; ++i) {
    const Ray ray(center + radius * as_vector(random.point(1)), random.direction());
    caster.begin(ray);
    caster.intervals(list, Span::line());
    ends.clear();
    for (const Interval& interval : list) {
      for (const Hit& end : {Hit{interval.entry, Passage::entry}, Hit{interval.exit, Passage::exit}}) {
        if (end.crossing.surface.valid()) ends.emplace_back(end.crossing, caster.attribute(end));
      }
    }
    for (const auto& [crossing, face] : ends)
      depart(crossing.surface, face, dot(as_vector(face.normal), ray.direction()) < 0);
  }
  return sent;
}

}  // namespace

TEST_CASE("the faces of a convex solid lead away on the outside, whatever is cut out of it or it is cut to") {
  CHECK(seen(centered_box(2), {0.3, 0.2, 9}, down) == away);
  CHECK(seen(centered_box(2) - sphere(0.5), {0.3, 0.2, 9}, down) == away);
  CHECK(seen(sphere(1), {0.3, 0.2, 9}, down) == away);
  CHECK(seen(sphere(1), {0.3, 0.2, 0}, up) == Seen{false, true});
  CHECK(seen(centered_box(2) & sphere(1.2), {0, 0, 9}, down) == away);
  CHECK(seen(centered_box(2) & sphere(1.2), {0.75, 0.7, 9}, down) == away);
  CHECK(seen(cylinder(2, 1, 1), {9, 0.2, 1}, {-1, 0, 0}) == away);
  CHECK(seen(cylinder(2, 1, 1), {0.1, 0.2, 9}, down) == away);
  CHECK(seen(paraboloid(2, 1), {9, 0.1, 1}, {-1, 0, 0}) == away);
  CHECK(seen(halfspace({1, 2, 3}, 1), {9, 9, 9}, {-1, -2, -3}) == away);
}

TEST_CASE("turned and sheared ones do as well: that their forms are convex is decided exactly") {
  const Transform turned = rotation(31, {1, 2, 3});
  const Transform sheared{{1, 0.3, 0.1, 5, 0, 1, 0.7, 1e3, 0, 0, 0.2, 7}};
  for (const Solid& solid : {sphere(1), cylinder(2, 1, 1, Centering::centered), ellipsoid({1, 2, 0.3})}) {
    for (const Transform& moved : {turned, sheared}) {
      const Solid whole = transformed(solid, moved);
      const Box box = bounds(whole);
      CHECK(seen(whole, {box.center().x, box.center().y, box.upper.z + 1}, down) == away);
    }
  }
}

TEST_CASE("faces that the solid reaches beyond do not lead away, nor do those of holes, cones and saddles") {
  CHECK(seen(centered_box(2) - at(sphere(0.5), {0, 0, 1}), {0.1, 0.2, 9}, down) == neither);
  CHECK(seen(complement(sphere(1)), {0, 0, 0.1}, down) == neither);
  CHECK(seen(cylinder(2, 1, 0.5), {9, 0.1, 1}, {-1, 0, 0}) == neither);
  CHECK(seen(hyperboloid(2, 1, 0.5), {9, 0.1, 0.2}, {-1, 0, 0}) == neither);
  CHECK(seen(sphere(1) + at(sphere(1), {3, 0, 0}), {0, 0, 9}, down) == neither);
  CHECK(seen(centered_box(2) + at(sphere(1), {0, 0, 5}), {0.9, 0.9, 9}, down) == neither);
}

TEST_CASE("of a union those faces lead away that are flush with every part's or lie beyond the others") {
  const Solid step = box({4, 4, 1}) + box({2, 4, 3});
  CHECK(seen(step, {1, 1, 9}, down) == away);     // the top, beyond the lower part
  CHECK(seen(step, {3, 1, 9}, down) == neither);  // the tread
  CHECK(seen(step, {1, 1, -9}, up) == away);      // the base, which both have
  CHECK(seen(step, {9, 1, 0.5}, {-1, 0, 0}) == away);
  CHECK(seen(step, {9, 1, 2}, {-1, 0, 0}) == neither);  // the riser
  // A part that comes to the plane of another one's top, up to rounding, without having it: nobody knows.
  CHECK(seen(box({2, 2, 1}) + at(sphere(0.5), {4, 0, 0.5}), {1, 1, 9}, down) == neither);
  std::vector<Solid> row;
  row.reserve(101);
  for (int i = 0; i < 100; ++i) row.push_back(at(box({1, 1, 1}), {1.5 * i, 0, 0}));
  CHECK(seen(unite(row), {0.5 + 1.5 * 70, 0.5, 9}, down) == away);
  row.push_back(at(box({1, 1, 1}), {0, 0, 0.25}));
  CHECK(seen(unite(row), {0.5 + 1.5 * 70, 0.5, 9}, down) == neither);
}

TEST_CASE("rays that depart to a side that leads away meet nothing, however little they rise") {
  RandomSolids random(17);
  int sent = 0;
  for (int n = 0; n < (test::long_run() ? 20000 : test::times(1000)); ++n) {
    const Solid solid = n % 3 == 0 ? random.tree(1 + n % 7, [&] { return random.grid_box(); }) : random.tree(1 + n % 5);
    sent += check_departures(solid, random, {}, 3, 12);
    // Small, and far from the origin.
    const Vector offset{1e5, -3e4, 7e2};
    const Solid far_off = at(transformed(solid, scaling({1e-3, 1e-3, 1e-3})), offset);
    sent += check_departures(far_off, random, Point{} + offset, 3e-3, 12);
  }
  CHECK(sent > (test::is_sanitized ? 100 : 3000));
}

TEST_CASE("in the examples rays that depart to a side that leads away meet nothing") {
  RandomSolids random(18);
  int sent = 0;
  for (const std::string& name : test::example_names()) {
    INFO(name);
    const SceneDescription description = test::example(name);
    const Box box = bounds(description.solid);
    const double radius = box.is_finite() ? 0.6 * length(box.size()) : 10;
    sent += check_departures(description.solid, random, box.is_finite() ? box.center() : Point{}, radius, 1000);
  }
  CHECK(sent > 500);
}
