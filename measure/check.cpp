// SPDX-License-Identifier: MIT
#include "measure/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "measure/search/redundancies.h"
#include "measure/search/shared_space.h"
#include "raycast/cells/pieces.h"
#include "raycast/line/interval_list.h"
#include "raycast/ray/caster.h"

namespace csgcast {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Finds the places on a line where two nodes are both inside.
class CommonLine {
 public:
  explicit CommonLine(const Scene& scene) : caster_(scene) {}

  std::optional<Point> operator()(NodeId a, NodeId b, Point through, Vector along) {
    // The direction is turned off the axes by arbitrary numbers. So no surface holds such a line; on a surface, the
    // side would be a mere convention.
    along = along + Vector{0x1.3a7f1p-12, 0x1.91c5dp-12, -0x1.6e0b3p-12};
    if (!Ray::in_range(through, along)) return std::nullopt;
    const Ray ray(through, along);
    caster_.begin(ray);
    caster_.intervals(a, of_a_, Span::line());
    caster_.intervals(b, of_b_, Span::line());
    combine<Intersection>(of_a_, of_b_, common_,
                          [&](const Crossing& x, const Crossing& y) { return caster_.order(x, y); });
    if (common_.empty()) return std::nullopt;
    const auto width = [](const Interval& interval) { return interval.exit.t - interval.entry.t; };
    const Interval widest = *std::max_element(common_.begin(), common_.end(),
                                              [&](const auto& x, const auto& y) { return width(x) < width(y); });
    const double from = std::fmax(caster_.reported(widest.entry).t, -0x1p100);
    const double to = std::fmin(caster_.reported(widest.exit).t, 0x1p100);
    return ray.at(0.5 * (from + to));
  }

 private:
  Caster caster_;
  IntervalList of_a_, of_b_, common_;
};

class Checker {
 public:
  Checker(const Scene& scene, const CheckOptions& options)
      : scene_(scene), options_(options), progress_(options.progress), space_(scene), lines_(scene) {}

  CheckReport operator()() {
    const Box& whole = scene_.node(scene_.root()).box;
    report_.is_unbounded = !whole.is_null() && !whole.is_finite();
    report_.is_empty = is_empty(scene_.root());
    check_parts();
    check_pairs();
    report_.looked_for_redundancy = scene_.leaves().size() <= options_.most_leaves;
    if (report_.looked_for_redundancy) {
      auto [found, not_asked] = detail::redundancies(
          space_, [&](NodeId node) { return is_empty(node); }, [&](double done) { tell(0.5 + 0.5 * done); });
      report_.redundant = std::move(found);
      report_.not_asked = not_asked;
    }
    progress_.finish();
    return std::move(report_);
  }

 private:
  bool is_empty(NodeId node) {
    const Box& box = scene_.node(node).box;
    if (box.is_null()) return true;
    if (!box.is_finite()) return false;
    const Space space = space_.common(node, node);
    const detail::SearchResult found =
        detail::find_place(space, [&](Point through, Vector along) { return lines_(node, node, through, along); });
    return !found.witness && (found.is_empty || detail::is_nothing(space));
  }

  void check_parts() {
    for (std::uint32_t i = 0; i < scene_.parts().size(); ++i) {
      const NodeId node = scene_.parts()[i].node;
      const Box& box = scene_.node(node).box;
      if (!box.is_null() && !box.is_finite()) report_.unbounded.emplace_back(i);
      if (is_empty(node)) report_.empty.emplace_back(i);
    }
  }

  void check_pairs() {
    const auto parts = scene_.parts();
    // Parts are sorted by their lower sides along x. All parts after one that begins behind a part's end share nothing
    // with that part.
    std::vector<std::uint32_t> order(parts.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto box = [&](std::uint32_t i) -> const Box& { return scene_.node(parts[i].node).box; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return box(a).lower.x != box(b).lower.x ? box(a).lower.x < box(b).lower.x : a < b;
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
      tell(0.5 * static_cast<double>(k) / static_cast<double>(order.size()));
      for (std::size_t l = k + 1; l < order.size() && box(order[l]).lower.x <= box(order[k]).upper.x; ++l) {
        if (intersection(box(order[k]), box(order[l])).is_null()) continue;
        check_pair(PartId(std::min(order[k], order[l])), PartId(std::max(order[k], order[l])));
      }
    }
    const auto by_parts = [](const auto& a, const auto& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    };
    std::sort(report_.overlaps.begin(), report_.overlaps.end(), by_parts);
    std::sort(report_.undecided.begin(), report_.undecided.end(), by_parts);
  }

  void check_pair(PartId first, PartId second) {
    const NodeId a = scene_.parts()[first.index()].node;
    const NodeId b = scene_.parts()[second.index()].node;
    const auto test = [&](Point through, Vector along) { return lines_(a, b, through, along); };
    const Space common = space_.common(a, b);
    if (!common.is_bounded()) {
      const std::optional<Point> witness = test(scene_.frame().center, {1, 0, 0});
      if (witness)
        report_.overlaps.push_back({first, second, {infinity, infinity}, *witness});
      else
        report_.undecided.push_back({first, second, infinity});
      return;
    }
    const detail::SearchResult found = detail::find_place(common, test);
    if (found.witness) {
      report_.overlaps.push_back({first, second, detail::volume_of(common), *found.witness});
    } else if (!found.is_empty) {
      report_.undecided.push_back({first, second, found.most_volume});
    }
  }

  void tell(double done) { progress_.tell({done, {}}); }

  const Scene& scene_;
  const CheckOptions& options_;
  ProgressTeller progress_;
  Space space_;
  CommonLine lines_;
  CheckReport report_;
};

}  // namespace

const char* word(const Scene& scene, const Redundancy& redundancy) {
  switch (redundancy.op) {
    case Node::Op::leaf:
      return word(scene.leaf(LeafId(redundancy.first_leaf)).kind);
    case Node::Op::intersect:
      return "intersection";
    case Node::Op::subtract:
      return "difference";
    case Node::Op::complement:
      return "complement";
    default:
      return "union";
  }
}

std::string name_of(const Scene& scene, const Redundancy& redundancy) {
  const std::string kind = word(scene, redundancy);
  return redundancy.place.line > 0 ? kind + " at " + to_string(redundancy.place) : kind;
}

const char* reason(Redundancy::Why why) {
  switch (why) {
    case Redundancy::Why::is_empty:
      return "nothing is in it";
    case Redundancy::Why::holds_all:
      return "the intersection is the same without it";
    default:
      return "without it the shape is the same";
  }
}

CheckReport check(const Scene& scene, const CheckOptions& options) { return Checker(scene, options)(); }

}  // namespace csgcast
