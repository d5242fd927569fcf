// SPDX-License-Identifier: MIT
#include <cstddef>

#include "raycast/caster.h"
#include "raycast/detail/caster_state.h"
#include "raycast/interval_list.h"

// The changes of medium along a ray, from the interval lists of the layers: one sweep over the ends of all lists at
// once.

namespace csgcast {
namespace {

constexpr std::size_t no_layer = static_cast<std::size_t>(-1);

// Walks along the ray from stop to stop; ends of lists that tie make one stop.
class LayerSweep {
 public:
  // `passed[i]` counts the ends of list i that lie behind; ends that no surface makes at the start do from the
  // beginning.
  LayerSweep(const std::vector<IntervalList>& lists, std::vector<std::size_t>& passed, detail::LineCache& cache)
      : lists_(lists), passed_(passed), cache_(cache) {
    passed_.assign(lists.size(), 0);
    for (std::size_t layer = 0; layer < lists.size(); ++layer) {
      if (!lists[layer].empty() && !lists[layer].front().entry.surface.valid()) passed_[layer] = 1;
    }
  }

  // Passes the next stop; false if no surface makes one any more.
  bool advance() {
    std::size_t first = no_layer;
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (done(layer)) continue;
      if (first == no_layer || cache_.order(next_end(layer), next_end(first)) < 0) first = layer;
    }
    if (first == no_layer || !next_end(first).surface.valid()) return false;
    stop_ = next_end(first);
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (!done(layer) && cache_.order(next_end(layer), stop_) == 0) ++passed_[layer];
    }
    return true;
  }

  // The first layer that holds the ray right after the present stop.
  std::size_t holder() const {
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (passed_[layer] % 2 == 1) return layer;
    }
    return no_layer;
  }

  // The last end of a layer's list that was passed.
  const Crossing& last_end(std::size_t layer) const { return end(layer, passed_[layer] - 1); }
  bool begins_here(std::size_t layer) { return passed_[layer] > 0 && cache_.order(last_end(layer), stop_) == 0; }

 private:
  const Crossing& end(std::size_t layer, std::size_t i) const {
    const Interval& interval = lists_[layer][i / 2];
    return i % 2 == 0 ? interval.entry : interval.exit;
  }
  const Crossing& next_end(std::size_t layer) const { return end(layer, passed_[layer]); }
  bool done(std::size_t layer) const { return passed_[layer] == 2 * lists_[layer].size(); }

  const std::vector<IntervalList>& lists_;
  std::vector<std::size_t>& passed_;
  detail::LineCache& cache_;
  Crossing stop_;
};

// Both transmit and look the same: no light turns or dims in between.
bool same_medium(const Scene& scene, std::size_t a, std::size_t b) {
  if (a == no_layer || b == no_layer) return false;
  const RegionId region_a = scene.layers()[a].region;
  const RegionId region_b = scene.layers()[b].region;
  return region_a.valid() && region_b.valid() && scene.region(region_a).look == scene.region(region_b).look;
}

RegionId region_of(const Scene& scene, std::size_t layer) {
  return layer == no_layer ? RegionId() : scene.layers()[layer].region;
}

}  // namespace

void Caster::interfaces(std::vector<Interface>& list, Span span) {
  list.clear();
  State& state = *state_;
  const Scene& scene = state.scene;
  state.layer_lists.resize(scene.layers().size());
  for (std::size_t layer = 0; layer < scene.layers().size(); ++layer) {
    IntervalList& intervals = state.layer_lists[layer];
    intervals = state.evaluator.evaluate(scene.layers()[layer].node, span, detail::Want::all);
    clip(intervals, span, [&](const Crossing& a, double t) { return state.cache.order(a, t); });
  }
  LayerSweep sweep(state.layer_lists, state.layer_passed, state.cache);
  std::size_t from = sweep.holder();
  while (sweep.advance()) {
    const std::size_t to = sweep.holder();
    if (to == from) continue;
    const bool into_opaque = to != no_layer && !scene.layers()[to].region.valid();
    if (!same_medium(scene, from, to)) {
      // The new medium's own face where it begins here; else it was hidden by the old one, whose face ends here.
      const bool enters = to != no_layer && sweep.begins_here(to);
      const std::size_t layer = enters ? to : from;
      Interface change{{sweep.last_end(layer), enters ? Passage::entry : Passage::exit},
                       region_of(scene, from),
                       region_of(scene, to),
                       into_opaque,
                       scene.layers()[layer].node};
      change.hit.crossing = state.bounding(change.node, change.hit.crossing, Rounding::close);
      list.push_back(change);
    }
    if (into_opaque) return;
    from = to;
  }
}

}  // namespace csgcast
