// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

constexpr std::size_t no_layer = static_cast<std::size_t>(-1);

inline RegionId region_of(const Scene& scene, std::size_t layer) {
  return layer == no_layer ? RegionId() : scene.layers()[layer].region;
}

inline bool is_opaque(const Scene& scene, std::size_t layer) {
  return layer != no_layer && !scene.layers()[layer].region.valid();
}

/// True if both layers transmit and look the same. Then light neither turns nor dims between them.
inline bool same_medium(const Scene& scene, std::size_t a, std::size_t b) {
  const RegionId region_a = region_of(scene, a);
  const RegionId region_b = region_of(scene, b);
  return region_a.valid() && region_b.valid() && scene.region(region_a).look == scene.region(region_b).look;
}

/// Walks along a ray through the interval lists of the layers, from stop to stop. A stop is an end of a list; ends that
/// tie make one stop. `Order` is a weak ordering of crossings.
template <class Order>
class LayerSweep {
 public:
  using Lists = std::vector<std::span<const Interval>>;

  /// `passed[i]` counts the ends of list i that have been passed; the vector is overwritten. An entry at the start of a
  /// list that no surface makes counts as passed from the beginning.
  LayerSweep(const Lists& lists, std::vector<std::size_t>& passed, Order order)
      : lists_(lists), passed_(passed), order_(order) {
    passed_.assign(lists.size(), 0);
    for (std::size_t layer = 0; layer < lists.size(); ++layer) {
      if (!lists[layer].empty() && !lists[layer].front().entry.surface.valid()) passed_[layer] = 1;
    }
  }

  /// Passes the next stop. False if no surface makes a further stop.
  bool advance() {
    std::size_t first = no_layer;
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (done(layer)) continue;
      if (first == no_layer || order_(next_end(layer), next_end(first)) < 0) first = layer;
    }
    if (first == no_layer || !next_end(first).surface.valid()) return false;
    stop_ = next_end(first);
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (!done(layer) && order_(next_end(layer), stop_) == 0) ++passed_[layer];
    }
    return true;
  }

  /// The first layer that holds the ray right after the present stop; no_layer if none does.
  std::size_t holder() const {
    for (std::size_t layer = 0; layer < lists_.size(); ++layer) {
      if (passed_[layer] % 2 == 1) return layer;
    }
    return no_layer;
  }

  /// The index of the last end that was passed in a layer's list.
  std::size_t last_end(std::size_t layer) const { return passed_[layer] - 1; }
  const Crossing& crossing(std::size_t layer, std::size_t end) const {
    const Interval& interval = lists_[layer][end / 2];
    return end % 2 == 0 ? interval.entry : interval.exit;
  }
  bool begins_here(std::size_t layer) const {
    return passed_[layer] > 0 && order_(crossing(layer, last_end(layer)), stop_) == 0;
  }

 private:
  const Crossing& next_end(std::size_t layer) const { return crossing(layer, passed_[layer]); }
  bool done(std::size_t layer) const { return passed_[layer] == 2 * lists_[layer].size(); }

  const Lists& lists_;
  std::vector<std::size_t>& passed_;
  Order order_;
  Crossing stop_;
};

/// Calls tell(change, layer, end) for each change of medium of a sweep, up to the first one into an opaque solid. The
/// crossing of the change is the end with index `end` in the list of `layer`.
template <class Order, class Tell>
void each_change(const Scene& scene, LayerSweep<Order>& sweep, Tell&& tell) {
  std::size_t from = sweep.holder();
  while (sweep.advance()) {
    const std::size_t to = sweep.holder();
    if (to == from) continue;
    const bool into_opaque = is_opaque(scene, to);
    if (!same_medium(scene, from, to)) {
      // If the new medium begins here, the face is its own. Otherwise the old medium, which ends here, has hidden the
      // new one so far, and the old one's face is seen.
      const bool enters = to != no_layer && sweep.begins_here(to);
      const std::size_t layer = enters ? to : from;
      const std::size_t end = sweep.last_end(layer);
      const Hit hit{sweep.crossing(layer, end), enters ? Passage::entry : Passage::exit};
      tell(Interface{hit, region_of(scene, from), region_of(scene, to), into_opaque, scene.layers()[layer].node}, layer,
           end);
    }
    if (into_opaque) return;
    from = to;
  }
}

}  // namespace csgcast::detail
