// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/medium_changes.h"

#include "raycast/ray/layer_sweep.h"

namespace csgcast::detail {

void MediumChanges::find(Span span, std::vector<Interface>& changes) {
  changes.clear();
  const std::span<const Layer> layers = scene_.layers();
  lists_.resize(layers.size());
  spans_.clear();
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    evaluator_.evaluate_clipped(layers[layer].node, span, Want::all, lists_[layer]);
    spans_.emplace_back(lists_[layer]);
  }
  const auto order = [this](const Crossing& a, const Crossing& b) { return cache_.order(a, b); };
  LayerSweep sweep(spans_, passed_, order);
  each_change(scene_, sweep, [&](Interface change, std::size_t, std::size_t) {
    neighbourhood_.move_to(change.node, change.hit.crossing);
    change.hit.crossing = neighbourhood_.bounding_crossing();
    changes.push_back(change);
  });
}

}  // namespace csgcast::detail
