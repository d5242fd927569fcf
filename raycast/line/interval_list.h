// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <limits>
#include <utility>
#include <vector>

#include "raycast/line/crossing.h"
#include "raycast/line/ray.h"

namespace csgcast {

/// An interval of t in which the ray is inside the solid. The entry comes before the exit.
struct Interval {
  Crossing entry;
  Crossing exit;
};

/// Sorted, disjoint, non-touching intervals.
using IntervalList = std::vector<Interval>;

/// The infinite ends of a line.
constexpr Crossing line_start() { return {-std::numeric_limits<double>::infinity(), {}, 0}; }
constexpr Crossing line_end() { return {std::numeric_limits<double>::infinity(), {}, 1}; }

struct Union {
  static constexpr bool keeps(bool in_a, bool in_b) { return in_a || in_b; }
};
struct Intersection {
  static constexpr bool keeps(bool in_a, bool in_b) { return in_a && in_b; }
};
struct Difference {
  static constexpr bool keeps(bool in_a, bool in_b) { return in_a && !in_b; }
};

/// The regularised Boolean combination of two lists along one line, in one sweep over their ends. Ends that tie are
/// passed together, so intervals that touch are joined, and none has zero length. `order(a, b)` orders two crossings.
/// `result` is overwritten; it must not be a or b.
template <class Operation, class Order>
void combine(const IntervalList& a, const IntervalList& b, IntervalList& result, Order&& order) {
  result.clear();
  const auto end = [](const IntervalList& list, std::size_t i) -> const Crossing& {
    return i % 2 == 0 ? list[i / 2].entry : list[i / 2].exit;
  };
  std::size_t i = 0;
  std::size_t j = 0;
  bool inside = false;
  Crossing entry;
  while (i < 2 * a.size() || j < 2 * b.size()) {
    const auto side = i == 2 * a.size()   ? std::weak_ordering::greater
                      : j == 2 * b.size() ? std::weak_ordering::less
                                          : order(end(a, i), end(b, j));
    const Crossing at = side <= 0 ? end(a, i) : end(b, j);
    if (side <= 0) ++i;
    if (side >= 0) ++j;
    const bool now = Operation::keeps(i % 2 == 1, j % 2 == 1);
    if (now == inside) continue;
    if (now) {
      entry = at;
    } else {
      result.push_back({entry, at});
    }
    inside = now;
  }
}

/// Cuts a list to a span. An end that is cut off gets the span's t and no surface. An interval that starts exactly at
/// span.from or ends exactly at span.to keeps that crossing. One that only touches the span vanishes. `order(crossing,
/// t)` orders a crossing and a number.
template <class Order>
void clip(IntervalList& list, Span span, Order&& order) {
  std::size_t kept = 0;
  for (Interval interval : list) {
    if (order(interval.exit, span.from) <= 0 || order(interval.entry, span.to) >= 0) continue;
    if (order(interval.entry, span.from) < 0) interval.entry = {span.from, {}, 0};
    if (order(interval.exit, span.to) > 0) interval.exit = {span.to, {}, 1};
    list[kept++] = interval;
  }
  list.resize(kept);
}

}  // namespace csgcast
