// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "measure/section/section_arcs.h"

namespace csgcast::detail {
namespace {

// Ends that were computed in neighbouring pieces are nearer to each other than this, in units of the space.
constexpr double same_place = 0x1p-40;

/// The places where ends of arcs meet: sets of ends and corners.
class Junctions {
 public:
  explicit Junctions(const ArcTrace& trace) : trace_(trace), parent_(2 * trace.arcs.size() + trace.corners.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    double widest = 0;
    for (const CellBox& box : trace.corners)
      widest = std::fmax(widest, std::fmax(box.upper.x - box.lower.x, box.upper.y - box.lower.y));
    cell_ = std::fmax(widest, same_place) * 2;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) add(i);
  }

  std::uint32_t from(std::size_t arc) { return root(static_cast<std::uint32_t>(2 * arc)); }
  std::uint32_t to(std::size_t arc) { return root(static_cast<std::uint32_t>(2 * arc + 1)); }

  /// The size of the largest set that was joined.
  double widest() {
    std::unordered_map<std::uint32_t, CellBox> whole;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      const CellBox box = box_of(i);
      CellBox& all = whole.try_emplace(root(i), box).first->second;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        all.lower[axis] = std::fmin(all.lower[axis], box.lower[axis]);
        all.upper[axis] = std::fmax(all.upper[axis], box.upper[axis]);
      }
    }
    double most = 0;
    for (const auto& [id, box] : whole)
      most = std::fmax(most, std::hypot(box.upper.x - box.lower.x, box.upper.y - box.lower.y));
    return most;
  }

 private:
  CellBox box_of(std::uint32_t item) const {
    const std::size_t ends = 2 * trace_.arcs.size();
    if (item >= ends) return trace_.corners[item - ends];
    const Arc& arc = trace_.arcs[item / 2];
    const Planar& p = item % 2 == 0 ? arc.from : arc.to;
    return {{p[0], p[1], 0}, {p[0], p[1], 0}};
  }

  static bool are_near(const CellBox& a, const CellBox& b) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (a.lower[axis] > b.upper[axis] + same_place || b.lower[axis] > a.upper[axis] + same_place) return false;
    }
    return true;
  }

  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu;
  }

  void add(std::uint32_t item) {
    const CellBox box = box_of(item);
    const auto x = static_cast<std::int64_t>(std::floor(box.lower.x / cell_));
    const auto y = static_cast<std::int64_t>(std::floor(box.lower.y / cell_));
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        const auto found = grid_.find(key(i, j));
        if (found == grid_.end()) continue;
        for (const std::uint32_t other : found->second) {
          if (are_near(box, box_of(other))) parent_[root(item)] = root(other);
        }
      }
    }
    grid_[key(x, y)].push_back(item);
  }

  std::uint32_t root(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  const ArcTrace& trace_;
  std::vector<std::uint32_t> parent_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> grid_;
  double cell_ = 0;
};

/// The angle by which one arc turns left into the next, in (-pi, pi].
double turn(const Arc& a, const Arc& b) {
  const double ax = a.to[0] - a.middle[0], ay = a.to[1] - a.middle[1];
  const double bx = b.middle[0] - b.from[0], by = b.middle[1] - b.from[1];
  return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

/// A loop's arcs, with adjacent arcs of the same surface merged. The loop begins where the surface changes.
std::vector<Arc> merged(std::vector<Arc> loop) {
  const auto changes = [&](std::size_t i) {
    return loop[i].surface != loop[(i + loop.size() - 1) % loop.size()].surface;
  };
  std::size_t start = 0;
  while (start < loop.size() && !changes(start)) ++start;
  const bool is_one = start == loop.size();
  std::rotate(loop.begin(), loop.begin() + static_cast<long>(is_one ? 0 : start), loop.end());
  std::vector<Arc> result;
  for (std::size_t i = 0; i < loop.size();) {
    std::size_t end = i + 1;
    const std::size_t most = is_one ? (loop.size() + 1) / 2 : loop.size();  // a whole conic becomes two arcs
    while (end < loop.size() && end - i < most && loop[end].surface == loop[i].surface) ++end;
    const std::size_t middle = i + (end - i) / 2;
    const bool is_even = (end - i) % 2 == 0;
    result.push_back(
        {loop[i].from, is_even ? loop[middle].from : loop[middle].middle, loop[end - 1].to, loop[i].surface});
    i = end;
  }
  return result;
}

}  // namespace

JoinedArcs join_arcs(const ArcTrace& trace) {
  Junctions junctions(trace);
  JoinedArcs result;
  result.widest_corner = junctions.widest();
  const std::size_t count = trace.arcs.size();
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> leaving;
  std::vector<bool> is_used(count);
  for (std::size_t i = 0; i < count; ++i) {
    // An arc that begins and ends at the same corner is part of it.
    const Arc& arc = trace.arcs[i];
    const double size = std::hypot(arc.to[0] - arc.from[0], arc.to[1] - arc.from[1]);
    is_used[i] = junctions.from(i) == junctions.to(i) && size < 0x1p-20;
    if (!is_used[i]) leaving[junctions.from(i)].push_back(i);
  }
  for (std::size_t first = 0; first < count; ++first) {
    if (is_used[first]) continue;
    std::vector<Arc> loop;
    std::size_t at = first;
    for (;;) {
      is_used[at] = true;
      loop.push_back(trace.arcs[at]);
      const std::uint32_t place = junctions.to(at);
      if (place == junctions.from(first)) break;
      std::size_t next = count;
      double best = 0;
      for (const std::size_t other : leaving[place]) {
        if (is_used[other]) continue;
        // The next arc goes straight on along the surface. Otherwise it is the one with the sharpest turn to the left,
        // which keeps touching loops apart.
        const double rank =
            trace.arcs[other].surface == trace.arcs[at].surface ? 10 : turn(trace.arcs[at], trace.arcs[other]);
        if (next == count || rank > best) {
          next = other;
          best = rank;
        }
      }
      if (next == count) {
        result.is_closed = false;
        break;
      }
      at = next;
    }
    result.loops.push_back(merged(std::move(loop)));
  }
  return result;
}

}  // namespace csgcast::detail
