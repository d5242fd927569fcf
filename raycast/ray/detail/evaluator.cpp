// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/evaluator.h"

#include <algorithm>

#include "raycast/line/box_line.h"
#include "raycast/line/interval_list.h"
#include "raycast/scene/half_space_runs.h"
#include "raycast/scene/leaf_function.h"

namespace csgcast::detail {

Evaluator::Evaluator(const Scene& scene, LineCache& cache) : scene_(scene), cache_(cache) {}

IntervalList& Evaluator::push_list() {
  if (list_count_ == lists_.size()) lists_.emplace_back();
  IntervalList& list = lists_[list_count_++];
  list.clear();
  return list;
}

const IntervalList& Evaluator::evaluate(NodeId node, Span span, Want want) {
  open_.clear();
  list_count_ = 0;
  enter(node, span, want);
  while (!open_.empty()) {
    OpenNode& open = open_.back();
    if (open.next == open.node->count || decided(open)) {
      if (open.node->op == Node::Op::complement) {
        const IntervalList whole{{line_start(), line_end()}};
        combine<Difference>(whole, lists_[list_count_ - 1], scratch_,
                            [this](const Crossing& a, const Crossing& b) { return cache_.order(a, b); });
        std::swap(scratch_, lists_[list_count_ - 1]);
      }
      if (open.node->is_cut) cache_.keep_within_cube(lists_[list_count_ - 1]);
      open_.pop_back();
      deliver();
      continue;
    }
    const NodeId child = scene_.children(*open.node)[open.next++];
    const bool passes_on = open.node->op == Node::Op::unite;
    enter(child, child_span(open), passes_on ? open.want : Want::all);
  }
  return lists_.front();
}

void Evaluator::evaluate_clipped(NodeId node, Span span, Want want, IntervalList& list) {
  list = evaluate(node, span, want);
  clip(list, span, [this](const Crossing& a, double t) { return cache_.order(a, t); });
}

bool Evaluator::may_meet_box(const Box& box, Span& reach) const {
  const double margin = cache_.departure_margin();
  if (margin == 0) return may_meet(box, cache_.ray(), reach);
  const Vector more{margin, margin, margin};
  return may_meet({box.lower - more, box.upper + more}, cache_.ray(), reach);
}

// Opens a node. If the node has no children, or the ray misses its box within the span, its list is delivered at once.
void Evaluator::enter(NodeId id, Span span, Want want) {
  const Node& node = scene_.node(id);
  if (node.op == Node::Op::empty) {
    push_list();
    return deliver();
  }
  if (node.op == Node::Op::everything) {
    push_list().push_back({line_start(), line_end()});
    return deliver();
  }
  ++box_tests_;
  Span reach = span;
  if (!may_meet_box(node.box, reach)) {
    push_list();
    return deliver();
  }
  if (node.op == Node::Op::leaf) {
    ++leaf_tests_;
    leaf_intervals(scene_.leaf(LeafId(node.first)), node.box.is_finite(), reach, push_list());
    return deliver();
  }
  open_.push_back({&node, 0, span, want});
}

// The list on top of the stack is the result of a child. It is combined with what the parent has so far.
void Evaluator::deliver() {
  if (open_.empty() || open_.back().next <= 1) return;
  merge_into_parent(open_.back());
}

void Evaluator::merge_into_parent(const OpenNode& parent) {
  const auto by_order = [this](const Crossing& a, const Crossing& b) { return cache_.order(a, b); };
  const IntervalList& right = lists_[list_count_ - 1];
  IntervalList& left = lists_[list_count_ - 2];
  --list_count_;
  if (parent.node->op == Node::Op::unite) {
    if (right.empty()) return;
    if (left.empty()) return std::swap(left, lists_[list_count_]);
    combine<Union>(left, right, scratch_, by_order);
  } else if (parent.node->op == Node::Op::intersect) {
    combine<Intersection>(left, right, scratch_, by_order);
  } else {
    if (right.empty()) return;
    combine<Difference>(left, right, scratch_, by_order);
  }
  std::swap(left, scratch_);
}

// True if the children evaluated so far settle what is wanted of the node.
bool Evaluator::decided(const OpenNode& open) {
  if (open.next == 0) return false;
  const IntervalList& so_far = lists_[list_count_ - 1];
  if (open.node->op != Node::Op::unite) return so_far.empty();
  if (open.want != Want::any) return false;
  return std::any_of(so_far.begin(), so_far.end(), [&](const Interval& interval) {
    return cache_.order(interval.exit, open.span.from) > 0 && cache_.order(interval.entry, open.span.to) < 0;
  });
}

// The part of the span in which the next child can change the result.
Span Evaluator::child_span(const OpenNode& open) {
  if (open.next <= 1) return open.span;  // next has been advanced to the child being entered
  const IntervalList& so_far = lists_[list_count_ - 1];
  if (open.node->op != Node::Op::unite) {
    return {std::max(open.span.from, cache_.earliest(so_far.front().entry)),
            std::min(open.span.to, cache_.latest(so_far.back().exit))};
  }
  if (open.want != Want::first) return open.span;
  // Nothing beyond the first entry after the span's start can be the first hit of the union.
  for (const Interval& interval : so_far) {
    if (cache_.order(interval.entry, open.span.from) > 0)
      return {open.span.from, std::min(open.span.to, cache_.latest(interval.entry))};
  }
  return open.span;
}

// The run of the line that is inside all planes of a leaf; none if there is no such run.
std::optional<Interval> Evaluator::run_inside_planes(const Leaf& leaf) {
  Interval run{line_start(), line_end()};
  for (const HalfSpace& half_space : scene_.half_spaces(leaf)) {
    if (!scene_.surface(half_space.surface).is_plane) continue;
    const LineCrossings& found = cache_.found(half_space.surface);
    const bool wants_positive = half_space.sense == Sense::positive;
    if (found.count == 0) {
      if (found.positive_before != wants_positive) return std::nullopt;
      continue;
    }
    const Crossing at = cache_.crossing(half_space.surface, 0);
    if (found.positive_before == wants_positive) {
      if (cache_.order(at, run.exit) < 0) run.exit = at;
    } else if (cache_.order(at, run.entry) > 0) {
      run.entry = at;
    }
    if (cache_.order(run.entry, run.exit) >= 0) return std::nullopt;
  }
  return run;
}

void Evaluator::conjunction_intervals(const Leaf& leaf, IntervalList& list) {
  const std::optional<Interval> run = run_inside_planes(leaf);
  if (!run) return;
  list.push_back(*run);
  for (const HalfSpace& half_space : scene_.half_spaces(leaf)) {
    if (scene_.surface(half_space.surface).is_plane) continue;
    half_space_runs(cache_, half_space, half_space_);
    combine<Intersection>(list, half_space_, scratch_,
                          [this](const Crossing& a, const Crossing& b) { return cache_.order(a, b); });
    std::swap(list, scratch_);
  }
}

void Evaluator::leaf_intervals(const Leaf& leaf, bool is_bounded, Span reach, IntervalList& list) {
  if (leaf.function == nullptr) {
    conjunction_intervals(leaf, list);
  } else {
    leaf.function->intervals(scene_.half_spaces(leaf), cache_, reach, list, of_function_);
  }
  // Crossings of a local surface outside the frame's cube may be missing (line_crossings.h). The intervals that this
  // makes wrong lie outside the cube.
  if (is_bounded) cache_.keep_within_cube(list);
}

}  // namespace csgcast::detail
