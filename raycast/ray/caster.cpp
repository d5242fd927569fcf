// SPDX-License-Identifier: MIT
#include "raycast/ray/caster.h"

#include <cassert>

#include "raycast/ray/detail/caster_state.h"
#include "raycast/ray/interval_list.h"

namespace csgcast {

CasterCounts& CasterCounts::operator+=(const CasterCounts& other) {
  rays += other.rays;
  surface_tests += other.surface_tests;
  box_tests += other.box_tests;
  leaf_tests += other.leaf_tests;
  twofold_calls += other.twofold_calls;
  exact_calls += other.exact_calls;
  rays_flagged += other.rays_flagged;
  return *this;
}

Caster::Caster(const Scene& scene, const Predicates& predicates) : state_(std::make_unique<State>(scene, predicates)) {}
Caster::~Caster() = default;
Caster::Caster(Caster&&) noexcept = default;

const Scene& Caster::scene() const { return state_->scene; }

void Caster::begin(const Ray& ray, std::optional<Departure> departure) {
  const Departure from = departure.value_or(Departure{});
  state_->cache.begin(ray, from.surface, from.side);
  ++state_->rays;
}

void Caster::intervals(NodeId node, IntervalList& list, Span span, Rounding rounding) {
  list = state_->evaluator.evaluate(node, span, detail::Want::all);
  state_->clip_and_bound(node, list, span, rounding);
}

std::optional<Hit> Caster::first_hit(NodeId node, Span span, Rounding rounding) {
  State& state = *state_;
  // The first entry is right as soon as nothing nearer can come. A ray that starts inside has its first boundary at the
  // exit, which takes the whole list.
  for (const detail::Want want : {detail::Want::first, detail::Want::all}) {
    IntervalList& list = state.list;
    list = state.evaluator.evaluate(node, span, want);
    clip(list, span, [&](const Crossing& a, double t) { return state.cache.order(a, t); });
    if (list.empty()) return std::nullopt;
    const Interval& first = list.front();
    if (first.entry.surface.valid()) return Hit{state.bounding(node, first.entry, rounding), Passage::entry};
    if (want == detail::Want::all && first.exit.surface.valid())
      return Hit{state.bounding(node, first.exit, rounding), Passage::exit};
  }
  return std::nullopt;
}

Crossing Caster::reported(const Crossing& crossing) { return state_->cache.reported(crossing); }

std::weak_ordering Caster::order(const Crossing& a, const Crossing& b) { return state_->cache.order(a, b); }

bool Caster::any_hit(NodeId node, Span span) {
  State& state = *state_;
  for (const Interval& interval : state.evaluator.evaluate(node, span, detail::Want::any)) {
    if (state.cache.order(interval.exit, span.from) > 0 && state.cache.order(interval.entry, span.to) < 0) return true;
  }
  return false;
}

CasterCounts Caster::counts() const {
  const State& state = *state_;
  return {state.rays,
          state.cache.surface_tests(),
          state.evaluator.box_tests(),
          state.evaluator.leaf_tests(),
          state.cache.exact_calls().twofold,
          state.cache.exact_calls().structural(),
          state.cache.rays_flagged()};
}

Crossing Caster::State::bounding(NodeId node, const Crossing& crossing, Rounding rounding) {
  neighbourhood.move_to(node, crossing);
  const Crossing bounding = neighbourhood.bounding_crossing();
  return rounding == Rounding::nearest ? cache.reported(bounding) : bounding;
}

void Caster::State::clip_and_bound(NodeId node, IntervalList& intervals, Span span, Rounding rounding) {
  clip(intervals, span, [&](const Crossing& a, double t) { return cache.order(a, t); });
  for (Interval& interval : intervals) {
    if (interval.entry.surface.valid()) interval.entry = bounding(node, interval.entry, rounding);
    if (interval.exit.surface.valid()) interval.exit = bounding(node, interval.exit, rounding);
  }
}

}  // namespace csgcast
