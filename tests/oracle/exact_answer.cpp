// SPDX-License-Identifier: MIT
#include "tests/oracle/exact_answer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace csgcast::oracle {
namespace {

// Whether each surface is positive, in the order of Subject::surfaces().
using Signs = std::vector<bool>;

bool inside(const Subject& subject, const Signs& positive) {
  std::vector<bool> operands;
  for (const auto& half_spaces : subject.half_spaces()) {
    operands.push_back(std::all_of(half_spaces.begin(), half_spaces.end(), [&](const OracleHalfSpace& half) {
      return positive[half.surface] == half.positive;
    }));
  }
  return combined(subject.model().operation, operands);
}

// A plane that the line crosses, at t.
struct Event {
  Rational t;
  std::size_t surface;
};

struct LineStart {
  Signs positive;             // towards t = -infinity
  std::vector<Event> events;  // ascending in t, then in surface
};

LineStart follow(const Subject& subject, const Ray& ray) {
  const RationalPoint origin = exact(ray.origin());
  const RationalPoint direction = exact(ray.direction());
  LineStart line;
  for (std::size_t i = 0; i < subject.surfaces().size(); ++i) {
    const RationalPlane& plane = subject.surfaces()[i].plane;
    const Rational slope = plane.along(direction);
    const Rational value = plane.at(origin);
    if (sign_of(slope) == 0) {
      line.positive.push_back(sign_of(value) >= 0);  // a ray in a plane is on its positive side
      continue;
    }
    line.positive.push_back(sign_of(slope) < 0);
    line.events.push_back({Rational(-value / slope), i});
  }
  std::stable_sort(line.events.begin(), line.events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
  return line;
}

using Group = std::vector<std::size_t>;  // ascending

Signs flipped(Signs signs, const Group& group) {
  for (const std::size_t surface : group) signs[surface] = !signs[surface];
  return signs;
}

std::optional<std::size_t> first_change_of_walk(const Subject& subject, Signs signs, const Group& group) {
  const bool start = inside(subject, signs);
  for (const std::size_t surface : group) {
    signs[surface] = !signs[surface];
    if (inside(subject, signs) != start) return surface;
  }
  return std::nullopt;
}

// The surface that bounds the solid where a whole group is crossed and the result changes.
std::size_t bounding_surface(const Subject& subject, const Signs& before, const Group& group) {
  const Signs after = flipped(before, group);
  for (const std::size_t surface : group) {
    for (const Signs& state : {before, after}) {
      if (inside(subject, flipped(state, {surface})) != inside(subject, state)) return surface;
    }
  }
  const auto forward = first_change_of_walk(subject, before, group);
  const auto backward = first_change_of_walk(subject, after, group);
  if (!forward || !backward) throw std::logic_error("the result does not change across the group");
  return std::min(*forward, *backward);
}

ExactEnd cut(double t) { return std::isfinite(t) ? ExactEnd{Rational(t), std::nullopt} : ExactEnd{}; }

}  // namespace

ExactList exact_intervals(const Subject& subject, const Ray& ray) {
  auto [signs, events] = follow(subject, ray);
  ExactList list;
  bool is_inside = inside(subject, signs);
  ExactEnd entry;
  for (auto next = events.begin(); next != events.end();) {
    Group group;
    const Rational t = next->t;
    for (; next != events.end() && next->t == t; ++next) group.push_back(next->surface);
    const Signs after = flipped(signs, group);
    if (inside(subject, after) != is_inside) {
      const ExactEnd end{t, subject.surfaces()[bounding_surface(subject, signs, group)].id};
      if (is_inside) list.push_back({entry, end});
      entry = end;
      is_inside = !is_inside;
    }
    signs = after;
  }
  if (is_inside) list.push_back({entry, {}});
  return list;
}

ExactList clipped(const ExactList& line, Span span) {
  const ExactEnd from = cut(span.from);
  const ExactEnd to = cut(span.to);
  ExactList list;
  for (ExactInterval interval : line) {
    if (from.t && interval.exit.t && *interval.exit.t <= *from.t) continue;
    if (to.t && interval.entry.t && *interval.entry.t >= *to.t) continue;
    if (from.t && (!interval.entry.t || *interval.entry.t < *from.t)) interval.entry = from;
    if (to.t && (!interval.exit.t || *interval.exit.t > *to.t)) interval.exit = to;
    list.push_back(interval);
  }
  return list;
}

Location exact_location(const Subject& subject, Point p) {
  Signs positive(subject.surfaces().size());
  Group zero;
  std::vector<int> signs;
  for (std::size_t k = 0; k < subject.model().operands.size(); ++k) {
    subject.model().operands[k].signs(p, signs);
    // No choice of signs brings the point into an operand of which it is strictly outside.
    const bool may_hold = std::find(signs.begin(), signs.end(), 1) == signs.end();
    for (std::size_t i = 0; i < signs.size(); ++i) {
      const OracleHalfSpace& half = subject.half_spaces()[k][i];
      // The signs are of the operand's own plane, which is the surface's or the opposite. Zeros begin on the operand's
      // side.
      positive[half.surface] = signs[i] > 0 ? !half.positive : half.positive;
      if (signs[i] == 0 && may_hold) zero.push_back(half.surface);
    }
  }
  std::sort(zero.begin(), zero.end());
  zero.erase(std::unique(zero.begin(), zero.end()), zero.end());
  if (zero.size() > 26) throw std::logic_error("too many surfaces through one point for the oracle");
  const bool first = inside(subject, positive);
  for (std::uint32_t choice = 1; choice < (1u << zero.size()); ++choice) {
    // Gray code: one flip leads to the next choice.
    const auto bit = static_cast<std::size_t>(__builtin_ctz(choice));
    positive[zero[bit]] = !positive[zero[bit]];
    if (inside(subject, positive) != first) return Location::boundary;
  }
  return first ? Location::inside : Location::outside;
}

std::optional<Location> location_by_meshes(const Subject& subject, Point p) {
  std::vector<bool> low, high;  // what an operand that the point is on the boundary of may be
  bool on_boundary = false;
  for (const Polyhedron& operand : subject.model().operands) {
    const std::optional<Location> side = operand.side_of_mesh(p);
    if (!side) return std::nullopt;
    on_boundary = on_boundary || *side == Location::boundary;
    low.push_back(*side == Location::inside);
    high.push_back(*side != Location::outside);
  }
  if (subject.model().operands.size() == 1 && on_boundary) return Location::boundary;
  // Monotone in every operand but the subtracted ones: those swap their bounds.
  if (subject.model().operation == Operation::subtract) std::swap_ranges(low.begin() + 1, low.end(), high.begin() + 1);
  const bool least = combined(subject.model().operation, low);
  if (least != combined(subject.model().operation, high)) return std::nullopt;
  return least ? Location::inside : Location::outside;
}

}  // namespace csgcast::oracle
