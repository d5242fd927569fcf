// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "raycast/ray/caster.h"
#include "raycast/ray/detail/evaluator.h"
#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/detail/local_tree.h"
#include "raycast/ray/detail/neighbourhood.h"

namespace csgcast {

/// What a caster keeps between queries, so that they need not allocate.
struct Caster::State {
  State(const Scene& s, const Predicates& predicates)
      : scene(s), cache(s, predicates), evaluator(s, cache), neighbourhood(s, cache) {}

  /// The crossing of the surface that bounds the node where a merged list ends, by the tie rule.
  Crossing bounding(NodeId node, const Crossing& crossing, Rounding rounding);
  /// Cuts an evaluated list to the span and settles which surfaces bound it.
  void clip_and_bound(NodeId node, IntervalList& intervals, Span span, Rounding rounding);

  const Scene& scene;
  detail::LineCache cache;
  detail::Evaluator evaluator;
  detail::Neighbourhood neighbourhood;
  detail::LocalTree near_point;
  IntervalList list;
  std::vector<IntervalList> layer_lists;
  std::vector<std::span<const Interval>> layer_spans;
  std::vector<std::size_t> layer_passed;
  std::uint64_t rays = 0;
};

}  // namespace csgcast
