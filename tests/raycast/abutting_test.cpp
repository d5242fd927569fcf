// SPDX-License-Identifier: MIT
// Parts that touch: never an overlap, never a gap, rays in the shared face included.
#include <algorithm>
#include <string>
#include <vector>

#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "raycast/ray/part_overlaps.h"
#include "tests/support/at.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/scene_rays.h"

using namespace csgcast;
using test::at;

namespace {

// Two solids that touch in a face and share no inner point, and a core: a solid in their union that holds the inner
// points of the face.
struct Neighbours {
  std::string name;
  Solid first;
  Solid second;
  Solid core;
  std::vector<Ray> along_curved_face{};  // generators of the face and tangents to it
};

std::vector<Neighbours> neighbours() {
  const std::vector<Point> wedge{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1}, {0, 2, 1}};
  const std::vector<Point> opposite{{2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}, {2, 0, 1}, {0, 2, 1}};
  const Solid lid = at(cylinder(1, 0.75, 0.75), {1, 1, 1});
  const Solid block = box({2, 2, 1});
  const Solid rod = cylinder(3, 0.5, 0.5);
  const Solid tapered_plug = cylinder(2, 1, 0.25);
  return {
      {"boxes with equal faces", box({1, 2, 1}), at(box({1, 2, 1}), {1, 0, 0}), box({2, 2, 1})},
      {"a small box on a large one", block, at(box({1, 1, 2}), {0.5, 0.5, 1}), at(box({1, 1, 3}), {0.5, 0.5, 0})},
      {"a cylinder on a box", block, lid, at(cylinder(2, 0.75, 0.75), {1, 1, 0})},
      {"cylinders end to end", rod, at(cylinder(1, 0.5, 0.5), {0, 0, 3}), cylinder(4, 0.5, 0.5)},
      {"a cylinder in its bore",
       at(box({2, 2, 3}), {-1, -1, 0}) - rod,
       rod,
       at(box({2, 2, 3}), {-1, -1, 0}),
       {Ray({0.5, 0, -1}, {0, 0, 1}), Ray({0, -0.5, 4}, {0, 0, -1}), Ray({0.5, -2, 1}, {0, 1, 0}),
        Ray({-0.5, 2, 0.5}, {0, -2, 0.25}), Ray({-2, 0.5, 3}, {1, 0, 0})}},
      {"a cone in its seat",
       at(box({4, 4, 2}), {-2, -2, 0}) - tapered_plug,
       tapered_plug,
       at(box({4, 4, 2}), {-2, -2, 0}),
       {Ray({1, 0, 0}, {-0.75, 0, 2}), Ray({0, -1, 0}, {0, 0.75, 2}), Ray({1, -2, 0}, {0, 1, 0}),
        Ray({0.625, -2, 1}, {0, 1, 0}), Ray({0.625, -2, 1}, {-0.375, 2, 1})}},
      {"a ball in its cavity",
       box({4, 4, 4}, Centering::centered) - sphere(1),
       sphere(1),
       box({4, 4, 4}, Centering::centered),
       {Ray({1, -2, 0}, {0, 1, 0}), Ray({1, -2, -3}, {0, 1, 1.5}), Ray({-3, 0, -1}, {0.5, 0, 0})}},
      {"two wedges of a box", convex_from_points(wedge), convex_from_points(opposite), box({2, 2, 1})},
  };
}

struct Placement {
  std::string name;
  Transform transform;
  bool is_exact;  // takes small numbers to doubles without rounding
};

std::vector<Placement> placements() {
  // Three times a rotation: the rows are square to each other, and whole numbers.
  const Transform whole{{2, -1, 2, 5, 2, 2, -1, -7, -1, 2, 2, 3}};
  return {{"as they stand", {}, true},
          {"turned by whole numbers", whole, true},
          {"mirrored, shrunk and far away", {{0, -0x1p-10, 0, 4096, 0x1p-10, 0, 0, 8192, 0, 0, -0x1p-10, -1024}}, true},
          {"turned anyhow", rotation(37.0, {1, -2, 3}), false},
          {"scaled by 1/1000", scaling({1e-3, 1e-3, 1e-3}), false}};
}

Point moved(const Transform& m, Point p) {
  const auto row = [&](std::size_t r) { return m(r, 0) * p.x + m(r, 1) * p.y + m(r, 2) * p.z + m(r, 3); };
  return {row(0), row(1), row(2)};
}

Ray moved(const Transform& m, const Ray& ray) {
  const Vector d = ray.direction();
  const auto row = [&](std::size_t r) { return m(r, 0) * d.x + m(r, 1) * d.y + m(r, 2) * d.z; };
  return Ray(moved(m, ray.origin()), {row(0), row(1), row(2)});
}

class LineOf {
 public:
  explicit LineOf(const Solid& solid) : scene_(compile(solid)), caster_(scene_) {}
  const IntervalList& operator()(const Ray& ray) {
    caster_.begin(ray);
    caster_.intervals(list_, Span::line());
    return list_;
  }

 private:
  Scene scene_;
  Caster caster_;
  IntervalList list_;
};

bool overlap(const IntervalList& a, const IntervalList& b) {
  return std::any_of(a.begin(), a.end(), [&](const Interval& i) {
    return std::any_of(b.begin(), b.end(),
                       [&](const Interval& j) { return i.entry.t < j.exit.t && j.entry.t < i.exit.t; });
  });
}

struct Range {
  double from, to;
  friend bool operator==(const Range&, const Range&) = default;
};

// Both lists in one, joined where they touch.
std::vector<Range> joined(const IntervalList& a, const IntervalList& b) {
  std::vector<Range> all, result;
  for (const IntervalList* list : {&a, &b})
    for (const Interval& i : *list) all.push_back({i.entry.t, i.exit.t});
  std::sort(all.begin(), all.end(), [](const Range& i, const Range& j) { return i.from < j.from; });
  for (const Range& range : all) {
    if (!result.empty() && range.from <= result.back().to) {
      result.back().to = std::max(result.back().to, range.to);
    } else {
      result.push_back(range);
    }
  }
  return result;
}

// All that must hold of two neighbours along a ray.
class Laws {
 public:
  Laws(const Neighbours& pair, const Transform& m)
      : scene_(compile(transformed(named(pair.first, {"first", 1}) + named(pair.second, {"second", 1}), m))),
        caster_(scene_),
        common_(transformed(pair.first & pair.second, m)),
        gap_(transformed(pair.core - (pair.first + pair.second), m)) {}

  const Scene& scene() const { return scene_; }

  void check(const Ray& ray) {
    caster_.begin(ray);
    caster_.intervals(scene_.parts()[0].node, first_, Span::line());
    caster_.intervals(scene_.parts()[1].node, second_, Span::line());
    caster_.intervals(both_, Span::line());
    overlaps += overlap(first_, second_) || !common_(ray).empty();
    overlaps += part_overlaps_.find(caster_, Span::line(), 1, listed_) != 0;
    gaps += !gap_(ray).empty() || joined(first_, second_) != joined(both_, {});
    shared += !first_.empty() && !second_.empty();
  }

  int overlaps = 0;
  int gaps = 0;
  int shared = 0;  // rays that meet both

 private:
  Scene scene_;
  Caster caster_;
  LineOf common_;
  LineOf gap_;
  IntervalList first_, second_, both_;
  PartOverlaps part_overlaps_;
  std::vector<PartOverlap> listed_;
};

}  // namespace

TEST_CASE("parts that touch never overlap and leave no gap: rays through, in and along the edges of the shared face") {
  const int rays = test::long_run() ? 100'000 : test::times(3000);
  for (const Neighbours& pair : neighbours()) {
    const Scene unmoved = compile(pair.first + pair.second);
    for (const Placement& placement : placements()) {
      Laws laws(pair, placement.transform);
      // Rays that are exactly in faces of the unmoved pair; where moving rounds them they are an ulp beside.
      test::SceneRays source(unmoved, 51);
      for (int i = 0; i < rays; ++i) laws.check(moved(placement.transform, source.next()));
      for (const Ray& ray : pair.along_curved_face) laws.check(moved(placement.transform, ray));
      CAPTURE(pair.name, placement.name);
      CHECK(laws.overlaps == 0);
      CHECK(laws.gaps == 0);
      CHECK(laws.shared > rays / 20);
    }
  }
}

TEST_CASE("a ray in the face that two boxes share is in exactly one of them, and in their union without a gap") {
  const Solid first = box({1, 2, 1}), second = at(box({1, 2, 1}), {1, 0, 0});
  for (const Placement& placement : placements()) {
    if (!placement.is_exact) continue;
    const Scene scene =
        compile(transformed(named(first, {"first", 1}) + named(second, {"second", 1}), placement.transform));
    Caster caster(scene);
    test::RandomSolids random(52);
    for (int i = 0; i < 2000; ++i) {
      // Through the inside of the face x = 1, in it: in quarters, so moving rounds nothing.
      const Point inner{1, random.quarter(0.25, 1.75), random.quarter(0.25, 0.75)};
      const Vector d{0, random.quarter(-2, 2), random.quarter(-2, 2)};
      if (d == Vector{}) continue;
      caster.begin(moved(placement.transform, Ray(inner - 4 * d, d)));
      IntervalList a, b, both;
      caster.intervals(scene.parts()[0].node, a, Span::line());
      caster.intervals(scene.parts()[1].node, b, Span::line());
      caster.intervals(both, Span::line());
      REQUIRE(a.size() + b.size() == 1);
      REQUIRE(both.size() == 1);
      REQUIRE(joined(a, b) == joined(both, {}));
    }
  }
}
