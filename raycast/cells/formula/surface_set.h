// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// An ordered set of some surfaces of a scene, with the place of each. This is a sparse set: it keeps a number for each
/// surface of the scene, and clearing it costs nothing.
class SurfaceSet {
 public:
  /// Makes an empty set. `count` is the number of surfaces of the scene.
  explicit SurfaceSet(std::size_t count) : place_(count, 0) {}

  /// Becomes the set of a formula's surfaces, in the order of their first occurrence.
  void gather(const Formula& formula);
  /// Puts the surfaces into an order.
  template <class Less>
  void sort(Less&& less) {
    std::sort(list_.begin(), list_.end(), less);
    number();
  }
  /// Keeps the surfaces in the given places and drops the others. The places must ascend.
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
  std::vector<std::uint32_t> place_;  // by surface; arbitrary for surfaces that are not in the list
};

}  // namespace csgcast::detail
