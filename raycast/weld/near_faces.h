// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "raycast/weld/coincidence.h"

namespace csgcast::detail {

/// A leaf's box and the surfaces of its faces.
struct LeafFaces {
  Box box;  ///< finite
  std::vector<std::uint32_t> surfaces;
};

/// Finds faces that are nearly the same, of one leaf or of two leaves that touch or overlap. It is made for tolerances
/// that a person sets, which may be large compared with a leaf.
class NearFaces {
 public:
  /// `forms` are the forms of all surfaces, in one region. The surfaces of a reported pair are at most `most_gap` apart
  /// over the boxes of its leaves.
  NearFaces(std::span<const RegionForm> forms, const Region& region, double most_gap)
      : forms_(forms), region_(region), most_gap_(most_gap) {}

  /// A pair of surfaces a < b, with the leaves that brought them together. The same pair may be reported again with
  /// other leaves.
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t leaf_of_a;
    std::uint32_t leaf_of_b;
    double gap;
  };
  /// Receives a pair. Returns false if it wants no more.
  using Take = std::function<bool(const Pair&)>;

  /// Hands each pair over. Returns false if `most_work` comparisons were not enough, or if `take` wanted no more.
  bool search(std::span<const LeafFaces> leaves, std::uint64_t most_work, const Take& take);

 private:
  bool compare(std::span<const LeafFaces> leaves, std::uint32_t i, std::uint32_t j, const Take& take);
  // Fills `moved` with the forms of a leaf's surfaces about a place.
  void move_to(const Region& place, const LeafFaces& leaf, std::vector<RegionForm>& moved) const;

  std::span<const RegionForm> forms_;
  Region region_;
  double most_gap_;
  std::uint64_t work_ = 0;
  std::vector<RegionForm> first_;
  std::vector<RegionForm> second_;
};

}  // namespace csgcast::detail
