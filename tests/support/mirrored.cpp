// SPDX-License-Identifier: MIT
#include "tests/support/mirrored.h"

#include <algorithm>
#include <vector>

namespace csgcast::test {
namespace {

struct End {
  double t;
  SurfaceId surface;
  LeafId leaf;
  friend bool operator==(const End&, const End&) = default;
};

// The ends along a line in ascending order of t.
std::vector<End> ends_of(Caster& caster, const Ray& ray) {
  caster.begin(ray);
  IntervalList list;
  caster.intervals(list, Span::line());
  std::vector<End> ends;
  const auto add = [&](const Crossing& end, Passage passage) {
    const LeafId leaf = end.surface.valid() ? caster.attribute({end, passage}).leaf : LeafId();
    ends.push_back({end.t, end.surface, leaf});
  };
  for (const Interval& interval : list) {
    add(interval.entry, Passage::entry);
    add(interval.exit, Passage::exit);
  }
  return ends;
}

}  // namespace

bool mirrors(Caster& caster, const Ray& ray) {
  const std::vector<End> forward = ends_of(caster, ray);
  std::vector<End> backward = ends_of(caster, Ray(ray.origin(), -ray.direction()));
  std::reverse(backward.begin(), backward.end());
  for (End& end : backward) end.t = -end.t;
  return forward == backward;
}

}  // namespace csgcast::test
