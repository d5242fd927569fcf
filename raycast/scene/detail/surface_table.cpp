// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/surface_table.h"

#include <algorithm>
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

// Replaces NaN coordinates by those of the frame's center.
Point completed(Point p, const Frame& frame) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::isnan(p[axis])) p[axis] = frame.center[axis];
  }
  return is_finite(p) ? p : frame.center;
}

}  // namespace

// Finds the surface with this entry, for which same(other, entry) is true. If there is none, the entry is added.
template <class Same>
SurfaceId SurfaceTable::find_or_add(std::uint64_t hash, Entry entry, Same&& same) {
  const auto next = static_cast<std::uint32_t>(entries_.size());
  const std::uint32_t number =
      by_form_.find_or_add(hash, next, [&](std::uint32_t other) { return same(entries_[other], entry); });
  if (number == next) {
    entries_.push_back(std::move(entry));
  } else {
    entries_[number].is_local = entries_[number].is_local && entry.is_local;
  }
  return SurfaceId(number);
}

HalfSpace SurfaceTable::half_space(const QuadricForm& f, const Box& leaf) {
  CSGCAST_PRECONDITION(!f.is_constant());
  const CanonicalForm canonical_form = canonical(f);
  Entry entry{PackedForm(canonical_form.form), nullptr, middle_of(leaf), leaf.is_finite()};
  const std::uint64_t hash = entry.form.hash();
  const SurfaceId id = find_or_add(
      hash, std::move(entry), [](const Entry& a, const Entry& b) { return a.other == nullptr && a.form == b.form; });
  return {id, canonical_form.flipped ? Sense::positive : Sense::negative};
}

HalfSpace SurfaceTable::half_space(const OtherForm& f, const Box& leaf) {
  auto [form, flipped] = f.canonical();
  const SurfaceId id =
      find_or_add(form->hash(), {{}, form, middle_of(leaf), leaf.is_finite()},
                  [](const Entry& a, const Entry& b) { return a.other != nullptr && a.other->equals(*b.other); });
  return {id, flipped ? Sense::positive : Sense::negative};
}

void SurfaceTable::set_local(const std::vector<bool>& is_local) {
  for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i].is_local = is_local[i];
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
      merged.push_back({{}, {}, entries_[surface].near, true});
    }
    merged[id.index()].is_local = merged[id.index()].is_local && entries_[i].is_local;
    now[i] = {id, flipped ? Sense::negative : Sense::positive};
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (replacements[i].surface != i) continue;
    Entry& entry = merged[id_of[i].index()];
    entry.form = std::move(entries_[i].form);
    entry.other = std::move(entries_[i].other);
  }
  entries_ = std::move(merged);
  by_form_.clear();
  return now;
}

std::vector<Surface> SurfaceTable::take(const Frame& frame, SurfaceKinds kinds) {
  by_form_.clear();
  std::vector<Surface> surfaces;
  surfaces.reserve(entries_.size());
  for (Entry& entry : entries_) {
    if (entry.other == nullptr) {
      surfaces.push_back(make_surface(std::move(entry.form), frame, completed(entry.near, frame), entry.is_local));
      continue;
    }
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const SurfaceKind* of) {
      return of->takes_other != nullptr && of->takes_other(*entry.other);
    });
    CSGCAST_PRECONDITION(kind != kinds.end());
    surfaces.push_back(make_surface(std::move(entry.other), **kind, entry.is_local));
  }
  *this = SurfaceTable();
  return surfaces;
}

}  // namespace csgcast::detail
