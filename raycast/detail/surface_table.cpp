// SPDX-License-Identifier: MIT
#include "raycast/detail/surface_table.h"

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

}  // namespace

HalfSpace SurfaceTable::half_space(const QuadricForm& f, Point center) {
  CanonicalForm canonical_form = canonical(f);
  const Sense sense = canonical_form.flipped ? Sense::positive : Sense::negative;
  const std::size_t h = hash(canonical_form.form);
  const auto [first, last] = by_hash_.equal_range(h);
  for (auto it = first; it != last; ++it) {
    if (surfaces_[it->second.index()].exact == canonical_form.form) return {it->second, sense};
  }
  const SurfaceId id(static_cast<std::uint32_t>(surfaces_.size()));
  surfaces_.push_back(make_surface(std::move(canonical_form.form), center));
  by_hash_.emplace(h, id);
  return {id, sense};
}

}  // namespace csgcast::detail
