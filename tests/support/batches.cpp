// SPDX-License-Identifier: MIT
#include "tests/support/batches.h"

#include <optional>

#include "tests/support/catch.h"

namespace csgcast::test {

bool same(const Crossing& a, const Crossing& b) {
  return a.t == b.t && a.surface == b.surface && (!a.surface.valid() || a.root == b.root);
}

void check_same(std::span<const Interval> found, const IntervalList& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CHECK(same(found[k].entry, expected[k].entry));
    CHECK(same(found[k].exit, expected[k].exit));
  }
}

namespace {

void check_face(Caster& scalar, const Crossing& end, Passage passage, const EndFace& face) {
  REQUIRE(face.leaf.valid() == end.surface.valid());
  if (!end.surface.valid()) return;
  const Attribution expected = scalar.attribute({end, passage});
  CHECK(face.leaf == expected.leaf);
  CHECK(face.look == expected.look);
  CHECK(face.normal == expected.normal);
}

}  // namespace

void check_lists(const Cells& cells, PacketCaster& caster, const RayArrays& asked, const RayBatch& batch) {
  Caster scalar(cells.scene());
  for (const Rounding rounding : {Rounding::nearest, Rounding::close}) {
    IntervalBatch found;
    caster.intervals(asked, found, rounding, PacketCaster::Ends::faces);
    REQUIRE(found.faces.size() == 2 * found.intervals.size());
    for (std::size_t i = 0; i < batch.size(); ++i) {
      std::optional<Departure> departure;
      if (!asked.departure.empty()) {
        const Sense side = asked.departs_positive[i] != 0 ? Sense::positive : Sense::negative;
        departure = Departure{SurfaceId(asked.departure[i]), side};
      }
      Span span = asked.whole_line ? Span::line() : Span();
      if (!asked.end.empty()) span.to = asked.end[i];
      scalar.begin(batch.list()[i], departure);
      IntervalList expected;
      scalar.intervals(cells.scene().root(), expected, span, rounding);
      check_same(found.of(i), expected);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const std::size_t face = 2 * (found.offsets[i] + k);
        check_face(scalar, expected[k].entry, Passage::entry, found.faces[face]);
        check_face(scalar, expected[k].exit, Passage::exit, found.faces[face + 1]);
      }
    }
  }
}

std::vector<Ray> rays_at(RandomSolids& random, std::size_t count) {
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Point target = random.point(1);
    const Vector d = random.direction();
    rays.emplace_back(target - random.number(0, 4) * d, d);
  }
  return rays;
}

DepartingRays::DepartingRays(const Scene& scene, RandomSolids& random, std::span<const Ray> from) {
  Caster scalar(scene);
  std::vector<Ray> list;
  for (const Ray& ray : from) {
    scalar.begin(ray);
    const std::optional<Hit> hit = scalar.first_hit();
    if (!hit) continue;
    const Attribution face = scalar.attribute(*hit);
    list.emplace_back(face.point, random.direction());
    surfaces.push_back(hit->crossing.surface.index());
    const Sense outside = hit->passage == Passage::entry ? face.front : opposite(face.front);
    const bool goes_out = dot(list.back().direction(), as_vector(face.normal)) > 0;
    sides.push_back((goes_out ? outside : opposite(outside)) == Sense::positive ? 1 : 0);
  }
  rays = RayBatch(std::move(list));
}

RayArrays DepartingRays::arrays() const {
  RayArrays result = rays.arrays();
  result.departure = surfaces;
  result.departs_positive = sides;
  return result;
}

}  // namespace csgcast::test
