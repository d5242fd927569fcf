// SPDX-License-Identifier: MIT
#include "raycast/weld/near_faces.h"

#include "raycast/weld/touching_boxes.h"

namespace csgcast::detail {

bool NearFaces::search(std::span<const LeafFaces> leaves, std::uint64_t most_work, const Take& take) {
  std::vector<Box> boxes;
  boxes.reserve(leaves.size());
  for (const LeafFaces& leaf : leaves) boxes.push_back(leaf.box);
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    if (!compare(leaves, i, i, take)) return false;
  }
  return TouchingBoxes(boxes).search(
      most_gap_, [&](std::uint32_t i, std::uint32_t j) { return compare(leaves, i, j, take) && work_ <= most_work; });
}

void NearFaces::move_to(const Region& place, const LeafFaces& leaf, std::vector<RegionForm>& moved) const {
  moved.clear();
  for (const std::uint32_t surface : leaf.surfaces) moved.push_back(seen_from(forms_[surface], region_, place));
}

bool NearFaces::compare(std::span<const LeafFaces> leaves, std::uint32_t i, std::uint32_t j, const Take& take) {
  const LeafFaces& a = leaves[i];
  const LeafFaces& b = leaves[j];
  const Box both = hull(a.box, b.box);
  const Region place{both.center(), region_.exponent};
  move_to(place, a, first_);
  move_to(place, b, second_);
  work_ += a.surfaces.size() * b.surfaces.size();
  for (std::size_t k = 0; k < first_.size(); ++k) {
    for (std::size_t l = i == j ? k + 1 : 0; l < second_.size(); ++l) {
      const std::uint32_t s = a.surfaces[k], t = b.surfaces[l];
      if (s == t) continue;
      const double apart = gap(first_[k], second_[l], place, both);
      if (!(apart <= most_gap_)) continue;
      if (!take(s < t ? Pair{s, t, i, j, apart} : Pair{t, s, j, i, apart})) return false;
    }
  }
  return true;
}

}  // namespace csgcast::detail
