// SPDX-License-Identifier: MIT
#include "measure/search/redundancies.h"

#include <algorithm>
#include <unordered_map>

#include "measure/search/shared_space.h"

namespace csgcast::detail {
namespace {

using Op = Node::Op;

/// Searches from the root down, with a box of everything that a change below could alter. The other operands of an
/// intersection hold all of that; so does the operand that others are subtracted from.
class RedundancySearch {
 public:
  RedundancySearch(const Space& whole, const std::function<bool(NodeId)>& is_empty,
                   const std::function<void(double)>& tell)
      : whole_(whole), scene_(whole.scene()), is_empty_(is_empty), tell_(tell) {}

  Redundancies operator()() {
    const auto operations = scene_.operations();
    for (std::size_t i = operations.size(); i > 0; --i) {
      const Operation& operation = operations[i - 1];
      operation_of_.try_emplace(operation.node.index(), &operation);
      const bool has_leaves = operation.first_leaf < operation.leaf_end;
      if (has_leaves && scene_.node(operation.node).op == Op::empty) add(operation, Redundancy::Why::is_empty);
    }
    open_.push_back({scene_.root(), Box::everything(), Role::operand});
    while (!open_.empty()) {
      const Visit visit = open_.back();
      open_.pop_back();
      if (!look_at(visit)) descend(visit);
      if (scene_.node(visit.node).op == Op::leaf)
        tell_(static_cast<double>(++leaves_seen_) / static_cast<double>(scene_.leaves().size()));
    }
    return {outermost(), not_asked_};
  }

 private:
  enum class Role { operand, of_intersection, subtracted_from };

  struct Visit {
    NodeId node;
    Box reach;
    Role role;
  };

  void add(const Operation& operation, Redundancy::Why why) {
    found_.push_back({why, operation.op, operation.first_leaf, operation.leaf_end, operation.place});
  }

  /// True if the node is a redundant statement; then it is reported.
  bool look_at(const Visit& visit) {
    const Node& node = scene_.node(visit.node);
    const auto operation = operation_of_.find(visit.node.index());
    const bool is_statement = node.op == Op::leaf || operation != operation_of_.end();
    // Without the operand that all others are subtracted from, the difference is empty, which was tested before.
    if (!is_statement || visit.role == Role::subtracted_from) return false;
    const bool as_everything = visit.role == Role::of_intersection;
    const Box reach = as_everything ? visit.reach : intersection(visit.reach, node.box);
    const Space effect = whole_.effect_of(visit.node, as_everything, reach);
    if (reach.is_finite() && !effect.is_bounded()) ++not_asked_;
    if (!effect.is_bounded() || !is_nothing(effect)) return false;
    const Redundancy::Why why = as_everything ? Redundancy::Why::holds_all : Redundancy::Why::has_no_effect;
    if (operation != operation_of_.end()) {
      add(*operation->second, !as_everything && is_empty_(visit.node) ? Redundancy::Why::is_empty : why);
    } else {
      found_.push_back({why, Op::leaf, node.first, node.first + 1, scene_.leaf(LeafId(node.first)).place});
    }
    return true;
  }

  std::vector<Redundancy> outermost() {
    std::ranges::sort(found_, [](const Redundancy& a, const Redundancy& b) {
      return a.first_leaf != b.first_leaf ? a.first_leaf < b.first_leaf : a.leaf_end > b.leaf_end;
    });
    std::vector<Redundancy> result;
    for (const Redundancy& r : found_) {
      if (result.empty() || r.first_leaf >= result.back().leaf_end) result.push_back(r);
    }
    return result;
  }

  void descend(const Visit& visit) {
    const Node& node = scene_.node(visit.node);
    if (node.op == Op::leaf || node.op == Op::empty || node.op == Op::everything) return;
    const auto children = scene_.children(node);
    if (node.op == Op::intersect) return descend_intersection(visit, children);
    for (std::size_t i = 0; i < children.size(); ++i) {
      const bool is_cutter = node.op == Op::subtract && i > 0;
      const Role role = node.op == Op::subtract && i == 0 ? Role::subtracted_from : Role::operand;
      const Box reach = is_cutter ? intersection(visit.reach, scene_.node(children.front()).box) : visit.reach;
      open_.push_back({children[i], reach, role});
    }
  }

  void descend_intersection(const Visit& visit, std::span<const NodeId> children) {
    std::vector<Box> behind(children.size() + 1, Box::everything());
    for (std::size_t i = children.size(); i > 0; --i)
      behind[i - 1] = intersection(behind[i], scene_.node(children[i - 1]).box);
    Box before = visit.reach;
    for (std::size_t i = 0; i < children.size(); ++i) {
      open_.push_back({children[i], intersection(before, behind[i + 1]), Role::of_intersection});
      before = intersection(before, scene_.node(children[i]).box);
    }
  }

  const Space& whole_;
  const Scene& scene_;
  const std::function<bool(NodeId)>& is_empty_;
  const std::function<void(double)>& tell_;
  std::unordered_map<std::uint32_t, const Operation*> operation_of_;  // by node: its outermost operation
  std::vector<Visit> open_;
  std::size_t leaves_seen_ = 0;
  std::size_t not_asked_ = 0;
  std::vector<Redundancy> found_;
};

}  // namespace

Redundancies redundancies(const Space& whole, const std::function<bool(NodeId)>& is_empty,
                          const std::function<void(double)>& tell) {
  return RedundancySearch(whole, is_empty, tell)();
}

}  // namespace csgcast::detail
