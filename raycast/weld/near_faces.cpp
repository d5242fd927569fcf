// SPDX-License-Identifier: MIT
#include "raycast/weld/near_faces.h"

#include <algorithm>
#include <numeric>

namespace csgcast::detail {
namespace {

bool touch(const Box& a, const Box& b, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] - slack > b.upper[axis] || b.lower[axis] - slack > a.upper[axis]) return false;
  }
  return true;
}

}  // namespace

bool NearFaces::search(std::span<const LeafFaces> leaves, std::uint64_t most_work, const Take& take) {
  std::vector<std::uint32_t> by_lower(leaves.size());
  std::iota(by_lower.begin(), by_lower.end(), 0u);
  std::sort(by_lower.begin(), by_lower.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double x = leaves[i].box.lower.x, y = leaves[j].box.lower.x;
    return x != y ? x < y : i < j;
  });
  // This is a sweep along x. `open` has the leaves whose range in x is not over yet.
  std::vector<std::uint32_t> open;
  for (const std::uint32_t i : by_lower) {
    const double front = leaves[i].box.lower.x - most_gap_;
    std::erase_if(open, [&](std::uint32_t j) { return leaves[j].box.upper.x < front; });
    if (!compare(leaves, i, i, take)) return false;
    for (const std::uint32_t j : open) {
      ++work_;
      const bool near = touch(leaves[i].box, leaves[j].box, most_gap_);
      if (near && !compare(leaves, std::min(i, j), std::max(i, j), take)) return false;
      if (work_ > most_work) return false;
    }
    open.push_back(i);
  }
  return true;
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
