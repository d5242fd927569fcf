// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/surface_table.h"

#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/length.h"
#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

Point middle_of(const Box& leaf) {
  Point p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = leaf.lower[axis];
    const double high = leaf.upper[axis];
    const bool has_middle = std::isfinite(low) && std::isfinite(high);
    p[axis] = has_middle ? low + 0.5 * (high - low) : std::numeric_limits<double>::quiet_NaN();
  }
  return p;
}

// Coordinates that are NaN are taken from the frame's center.
Point completed(Point p, const Frame& frame) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::isnan(p[axis])) p[axis] = frame.center[axis];
  }
  return is_finite(p) ? p : frame.center;
}

}  // namespace

HalfSpace SurfaceTable::half_space(const QuadricForm& f, const Box& leaf) {
  CSGCAST_PRECONDITION(!f.is_constant());
  const CanonicalForm canonical_form = canonical(f);
  const Sense sense = canonical_form.flipped ? Sense::positive : Sense::negative;
  PackedForm form(canonical_form.form);
  const auto next = static_cast<std::uint32_t>(entries_.size());
  const std::uint32_t number =
      by_form_.find_or_add(form.hash(), next, [&](std::uint32_t other) { return entries_[other].form == form; });
  if (number == next) {
    entries_.push_back({std::move(form), middle_of(leaf), leaf.is_finite()});
  } else {
    entries_[number].is_local = entries_[number].is_local && leaf.is_finite();
  }
  return {SurfaceId(number), sense};
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
      merged.push_back({{}, entries_[surface].near, true});
    }
    merged[id.index()].is_local = merged[id.index()].is_local && entries_[i].is_local;
    now[i] = {id, flipped ? Sense::negative : Sense::positive};
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (replacements[i].surface == i) merged[id_of[i].index()].form = std::move(entries_[i].form);
  }
  entries_ = std::move(merged);
  by_form_.clear();
  return now;
}

std::vector<Surface> SurfaceTable::take(const Frame& frame) {
  by_form_.clear();
  std::vector<Surface> surfaces;
  surfaces.reserve(entries_.size());
  for (Entry& entry : entries_)
    surfaces.push_back(make_surface(std::move(entry.form), frame, completed(entry.near, frame), entry.is_local));
  *this = SurfaceTable();
  return surfaces;
}

}  // namespace csgcast::detail
