// SPDX-License-Identifier: MIT
#include "raycast/ray/caster.h"
#include "raycast/ray/detail/caster_state.h"
#include "raycast/ray/interval_list.h"
#include "raycast/ray/layer_sweep.h"

namespace csgcast {

// The changes of medium along a ray, from the interval lists of the layers: one sweep over the ends of all lists at
// once.
void Caster::interfaces(std::vector<Interface>& list, Span span) {
  list.clear();
  State& state = *state_;
  const Scene& scene = state.scene;
  state.layer_lists.resize(scene.layers().size());
  state.layer_spans.clear();
  for (std::size_t layer = 0; layer < scene.layers().size(); ++layer) {
    IntervalList& intervals = state.layer_lists[layer];
    intervals = state.evaluator.evaluate(scene.layers()[layer].node, span, detail::Want::all);
    clip(intervals, span, [&](const Crossing& a, double t) { return state.cache.order(a, t); });
    state.layer_spans.emplace_back(intervals);
  }
  const auto order = [&](const Crossing& a, const Crossing& b) { return state.cache.order(a, b); };
  detail::LayerSweep sweep(state.layer_spans, state.layer_passed, order);
  detail::each_change(scene, sweep, [&](Interface change, std::size_t, std::size_t) {
    change.hit.crossing = state.bounding(change.node, change.hit.crossing, Rounding::close);
    list.push_back(change);
  });
}

}  // namespace csgcast
