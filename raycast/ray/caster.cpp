// SPDX-License-Identifier: MIT
#include "raycast/ray/caster.h"

#include "csg/base/add_members.h"
#include "raycast/ray/detail/attributor.h"
#include "raycast/ray/detail/evaluator.h"
#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/detail/medium_changes.h"
#include "raycast/ray/detail/neighbourhood.h"
#include "raycast/ray/detail/point_locator.h"

namespace csgcast {

CasterCounts& CasterCounts::operator+=(const CasterCounts& other) {
  return add_members<&CasterCounts::rays, &CasterCounts::surface_tests, &CasterCounts::box_tests,
                     &CasterCounts::leaf_tests, &CasterCounts::twofold_calls, &CasterCounts::exact_calls,
                     &CasterCounts::rays_flagged>(*this, other);
}

// The parts of a caster. Each keeps its memory between queries.
struct Caster::State {
  State(const Scene& s, const Predicates& predicates)
      : scene(s),
        cache(s, predicates),
        evaluator(s, cache),
        neighbourhood(s, cache),
        attributor(s, cache, neighbourhood),
        medium_changes(s, cache, evaluator, neighbourhood),
        locator(s) {}

  // The crossing of the surface that bounds the node where a merged list ends, by the tie rule. An end that no surface
  // makes stays as it is.
  Crossing bounding(NodeId node, const Crossing& end, Rounding rounding) {
    if (!end.surface.valid()) return end;
    neighbourhood.move_to(node, end);
    const Crossing bounding = neighbourhood.bounding_crossing();
    return rounding == Rounding::nearest ? cache.reported(bounding) : bounding;
  }

  const Scene& scene;
  detail::LineCache cache;
  detail::Evaluator evaluator;
  detail::Neighbourhood neighbourhood;
  detail::Attributor attributor;
  detail::MediumChanges medium_changes;
  detail::PointLocator locator;
  IntervalList list;
  std::uint64_t rays = 0;
};

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
  state_->evaluator.evaluate_clipped(node, span, detail::Want::all, list);
  for (Interval& interval : list) {
    interval.entry = state_->bounding(node, interval.entry, rounding);
    interval.exit = state_->bounding(node, interval.exit, rounding);
  }
}

std::optional<Hit> Caster::first_hit(NodeId node, Span span, Rounding rounding) {
  State& state = *state_;
  // The first entry is right as soon as nothing nearer can come. A ray that starts inside has its first boundary at the
  // exit, which takes the whole list.
  for (const detail::Want want : {detail::Want::first, detail::Want::all}) {
    state.evaluator.evaluate_clipped(node, span, want, state.list);
    if (state.list.empty()) return std::nullopt;
    const Interval& first = state.list.front();
    if (first.entry.surface.valid()) return Hit{state.bounding(node, first.entry, rounding), Passage::entry};
    if (want == detail::Want::all && first.exit.surface.valid())
      return Hit{state.bounding(node, first.exit, rounding), Passage::exit};
  }
  return std::nullopt;
}

bool Caster::any_hit(NodeId node, Span span) {
  State& state = *state_;
  for (const Interval& interval : state.evaluator.evaluate(node, span, detail::Want::any)) {
    if (state.cache.order(interval.exit, span.from) > 0 && state.cache.order(interval.entry, span.to) < 0) return true;
  }
  return false;
}

Crossing Caster::reported(const Crossing& crossing) { return state_->cache.reported(crossing); }

std::weak_ordering Caster::order(const Crossing& a, const Crossing& b) { return state_->cache.order(a, b); }

void Caster::interfaces(std::vector<Interface>& list, Span span) { state_->medium_changes.find(span, list); }

Attribution Caster::attribute(NodeId node, const Hit& hit) { return state_->attributor.attribute(node, hit); }

LookId Caster::look_inside(NodeId node, const Hit& hit) { return state_->attributor.look_inside(node, hit); }

Location Caster::locate(NodeId node, Point p) { return state_->locator.locate(node, p); }

PartId Caster::part_at(Point p) { return state_->locator.part_at(p); }

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

}  // namespace csgcast
