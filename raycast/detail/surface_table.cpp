// SPDX-License-Identifier: MIT
#include "raycast/detail/surface_table.h"

#include <cmath>
#include <utility>

namespace csgcast::detail {
namespace {

std::size_t hash(const QuadricForm& form) {
  std::size_t h = 0;
  for (const Dyadic& c : form.coefficient) {
    h = (h ^ c.hash()) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

// The middle of the box; the frame's center on the axes along which it is infinite.
Point point_near(const Box& box, const Frame& frame) {
  Point p = frame.center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = box.lower[axis];
    const double high = box.upper[axis];
    if (std::isfinite(low) && std::isfinite(high)) p[axis] = low + 0.5 * (high - low);
  }
  return is_finite(p) ? p : frame.center;
}

}  // namespace

HalfSpace SurfaceTable::half_space(const QuadricForm& f, const Box& leaf) {
  CanonicalForm canonical_form = canonical(f);
  const Sense sense = canonical_form.flipped ? Sense::positive : Sense::negative;
  const std::size_t h = hash(canonical_form.form);
  const auto [first, last] = by_hash_.equal_range(h);
  for (auto it = first; it != last; ++it) {
    Entry& known = entries_[it->second.index()];
    if (known.form != canonical_form.form) continue;
    known.is_local = known.is_local && leaf.is_finite();
    return {it->second, sense};
  }
  const SurfaceId id(static_cast<std::uint32_t>(entries_.size()));
  entries_.push_back({std::move(canonical_form.form), leaf, leaf.is_finite()});
  by_hash_.emplace(h, id);
  return {id, sense};
}

std::vector<HalfSpace> SurfaceTable::merge(std::span<const Replacement> replacements) {
  std::vector<HalfSpace> now(entries_.size());
  std::vector<SurfaceId> id_of(entries_.size());
  std::vector<Entry> merged;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto [surface, flipped] = replacements[i];
    SurfaceId& id = id_of[surface];
    if (!id.valid()) {
      id = SurfaceId(static_cast<std::uint32_t>(merged.size()));
      merged.push_back({{}, entries_[surface].leaf, true});
    }
    merged[id.index()].is_local = merged[id.index()].is_local && entries_[i].is_local;
    now[i] = {id, flipped ? Sense::negative : Sense::positive};
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (replacements[i].surface == i) merged[id_of[i].index()].form = std::move(entries_[i].form);
  }
  entries_ = std::move(merged);
  by_hash_.clear();
  return now;
}

std::vector<Surface> SurfaceTable::take(const Frame& frame) {
  std::vector<Surface> surfaces;
  surfaces.reserve(entries_.size());
  for (Entry& entry : entries_)
    surfaces.push_back(make_surface(std::move(entry.form), frame, point_near(entry.leaf, frame), entry.is_local));
  entries_.clear();
  by_hash_.clear();
  return surfaces;
}

}  // namespace csgcast::detail
