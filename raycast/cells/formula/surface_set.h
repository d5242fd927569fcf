// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// Some surfaces of a scene in an order, none twice, with the place of each in it. Keeps its memory, which is a number
/// for each surface of the scene: a sparse set. To clear it costs nothing.
class SurfaceSet {
 public:
  /// An empty set of surfaces out of `count`, those of the scene.
  explicit SurfaceSet(std::size_t count) : place_(count, 0) {}

  /// Becomes the set of a formula's surfaces, in the order in which they come first.
  void gather(const Formula& formula);
  /// Puts the surfaces into an order.
  template <class Less>
  void sort(Less&& less) {
    std::sort(list_.begin(), list_.end(), less);
    number();
  }
  /// Keeps the surfaces in some places, which ascend, and drops the others.
  void keep(std::span<const std::size_t> places);

  std::size_t size() const { return list_.size(); }
  bool empty() const { return list_.empty(); }
  std::span<const SurfaceId> list() const { return list_; }
  SurfaceId operator[](std::size_t place) const { return list_[place]; }
  bool contains(SurfaceId id) const {
    const std::uint32_t place = place_[id.index()];
    return place < list_.size() && list_[place] == id;
  }
  /// Precondition: the set contains the surface.
  std::size_t place_of(SurfaceId id) const { return place_[id.index()]; }

 private:
  void number();

  std::vector<SurfaceId> list_;
  std::vector<std::uint32_t> place_;  // by surface; means nothing for surfaces that are not in the list
};

}  // namespace csgcast::detail
