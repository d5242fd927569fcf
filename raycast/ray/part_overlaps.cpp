// SPDX-License-Identifier: MIT
#include "raycast/ray/part_overlaps.h"

#include <algorithm>
#include <utility>

namespace csgcast {

void PartOverlaps::collect(Caster& caster, Span span) {
  ends_.clear();
  const std::span<const Part> parts = caster.scene().parts();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    caster.intervals(parts[i].node, list_, span);
    for (const Interval& interval : list_) {
      ends_.push_back({interval.entry, PartId(i), Passage::entry});
      ends_.push_back({interval.exit, PartId(i), Passage::exit});
    }
  }
  // Where ends tie, exits come first, because a part that begins there shares nothing with a part that ends there. An
  // exit of a part never ties with an entry of the same part.
  std::ranges::stable_sort(ends_, [&](const End& a, const End& b) {
    const auto side = caster.order(a.at, b.at);
    return side != 0 ? side < 0 : a.passage > b.passage;
  });
}

void PartOverlaps::enter(PartId part, std::size_t end) {
  place_[part.index()] = static_cast<std::uint32_t>(inside_.size());
  inside_.push_back({part, end});
}

PartOverlaps::Inside PartOverlaps::leave(PartId part) {
  const std::uint32_t place = place_[part.index()];
  const Inside leaving = inside_[place];
  inside_[place] = inside_.back();
  place_[inside_[place].part.index()] = place;
  inside_.pop_back();
  return leaving;
}

void PartOverlaps::list(const Inside& leaving, const Crossing& at, std::size_t most,
                        std::vector<PartOverlap>& overlaps) const {
  const std::size_t before = overlaps.size();
  for (const Inside& other : inside_) {
    if (overlaps.size() >= most) break;
    const Crossing& entry = ends_[std::max(leaving.since, other.since)].at;
    const bool leaves_first = leaving.part.index() < other.part.index();
    overlaps.push_back(
        {leaves_first ? leaving.part : other.part, leaves_first ? other.part : leaving.part, {entry, at}});
  }
  std::sort(overlaps.begin() + static_cast<std::ptrdiff_t>(before), overlaps.end(),
            [](const PartOverlap& a, const PartOverlap& b) {
              return std::pair(a.first.index(), a.second.index()) < std::pair(b.first.index(), b.second.index());
            });
}

std::uint64_t PartOverlaps::find(Caster& caster, Span span, std::size_t most, std::vector<PartOverlap>& overlaps) {
  overlaps.clear();
  inside_.clear();
  place_.resize(caster.scene().parts().size());
  collect(caster, span);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const End& end = ends_[i];
    if (end.passage == Passage::entry) {
      enter(end.part, i);
    } else {
      const Inside leaving = leave(end.part);
      count += inside_.size();
      list(leaving, end.at, most, overlaps);
    }
  }
  return count;
}

}  // namespace csgcast
