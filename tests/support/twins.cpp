// SPDX-License-Identifier: MIT
#include "tests/support/twins.h"

#include <algorithm>
#include <cmath>

namespace csgcast::test {
namespace {

bool same_attribution(const Attribution& a, const Attribution& b) {
  return a.leaf == b.leaf && a.region == b.region && a.part == b.part && a.look == b.look && a.normal == b.normal &&
         a.front == b.front;
}

}  // namespace

Solid scaled(const Solid& solid, double factor) { return transformed(solid, scaling({factor, factor, factor})); }

Point scaled(Point p, double factor) { return {factor * p.x, factor * p.y, factor * p.z}; }

bool Twins::agree(const Ray& ray, bool direction_grows) {
  const Vector d = direction_grows ? factor_ * ray.direction() : ray.direction();
  times_ = direction_grows ? 1 : factor_;
  plain_.begin(ray);
  large_.begin(Ray(scaled(ray.origin(), factor_), d));
  return same_lists(Span::line()) && same_lists({}) && same_first_hit() && plain_.any_hit() == large_.any_hit();
}

bool Twins::agree(Point p) {
  const Point q = scaled(p, factor_);
  return plain_.locate(p) == large_.locate(q) && plain_.part_at(p) == large_.part_at(q);
}

bool Twins::worked_alike() const {
  const CasterCounts a = plain_.counts(), b = large_.counts();
  return a.rays == b.rays && a.surface_tests == b.surface_tests && a.box_tests == b.box_tests &&
         a.leaf_tests == b.leaf_tests && a.twofold_calls == b.twofold_calls && a.exact_calls == b.exact_calls &&
         a.rays_flagged == b.rays_flagged;
}

bool Twins::same(const Crossing& a, const Crossing& b) const {
  return a.surface == b.surface && a.root == b.root && times_ * a.t == b.t;
}

bool Twins::same_face(const Crossing& a, const Crossing& b, Passage passage) {
  return !a.surface.valid() || same_attribution(plain_.attribute({a, passage}), large_.attribute({b, passage}));
}

bool Twins::same_lists(Span span) {
  plain_.intervals(list_, span);
  large_.intervals(large_list_, span);
  return std::equal(list_.begin(), list_.end(), large_list_.begin(), large_list_.end(),
                    [this](const Interval& a, const Interval& b) {
                      return same(a.entry, b.entry) && same(a.exit, b.exit) &&
                             same_face(a.entry, b.entry, Passage::entry) && same_face(a.exit, b.exit, Passage::exit);
                    });
}

bool Twins::same_first_hit() {
  const auto a = plain_.first_hit();
  const auto b = large_.first_hit();
  if (!a || !b) return a.has_value() == b.has_value();
  return a->passage == b->passage && same(a->crossing, b->crossing);
}

}  // namespace csgcast::test
