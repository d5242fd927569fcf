// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// The part of the list that the caller wants.
enum class Want : std::uint8_t {
  all,    ///< every interval in the span
  first,  ///< correct up to the first entry after the span's start, and so correct about the start; arbitrary beyond
  any,    ///< if some interval has an inside in the span, at least one such interval
};

/// The definition of the engine: interval lists of leaves, merged bottom-up by union, intersection and difference.
///
/// Parts that cannot matter are not evaluated. These are nodes whose box the ray misses within the span, the right side
/// of a difference whose left side is empty, the rest of an intersection once it is empty, and children beyond the
/// extent of what they are combined with.
///
/// The walk keeps a stack of its own and does not recurse, because trees may be a million deep.
class Evaluator {
 public:
  Evaluator(const Scene& scene, LineCache& cache);

  /// The list of a node along the cache's ray. It is correct within the span, unclipped, and valid until the next call.
  /// If several surfaces tie at an end, the reported crossing may be that of any of them.
  const IntervalList& evaluate(NodeId node, Span span, Want want);
  /// The same list, clipped to the span. `list` is overwritten.
  void evaluate_clipped(NodeId node, Span span, Want want, IntervalList& list);

  std::uint64_t box_tests() const { return box_tests_; }
  std::uint64_t leaf_tests() const { return leaf_tests_; }

 private:
  // A node on the way from the root to the node that is evaluated now.
  struct OpenNode {
    const Node* node;
    std::uint32_t next;  // the child to evaluate next
    Span span;           // the part of the line in which its list matters
    Want want;
  };

  bool may_meet_box(const Box& box, Span& reach) const;
  void enter(NodeId id, Span span, Want want);
  void deliver();
  Span child_span(const OpenNode& open);
  bool decided(const OpenNode& open);
  void merge_into_parent(const OpenNode& parent);
  std::optional<Interval> run_inside_planes(const Leaf& leaf);
  void leaf_intervals(const Leaf& leaf, bool is_bounded, Span reach, IntervalList& list);
  void conjunction_intervals(const Leaf& leaf, IntervalList& list);
  IntervalList& push_list();

  const Scene& scene_;
  LineCache& cache_;
  std::vector<OpenNode> open_;  // a stack, the root first
  // A stack of lists whose memory stays: one for each open node that has a result so far, and the one on its way to its
  // parent.
  std::vector<IntervalList> lists_;
  std::size_t list_count_ = 0;
  IntervalList scratch_;
  IntervalList half_space_;
  std::vector<IntervalList> of_function_;  // what a leaf's function uses
  std::uint64_t box_tests_ = 0;
  std::uint64_t leaf_tests_ = 0;
};

}  // namespace csgcast::detail
