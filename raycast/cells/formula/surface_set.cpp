// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

void SurfaceSet::gather(const Formula& formula) {
  list_.clear();
  for (const Term& term : formula.terms) {
    if (term.op != Term::Op::half_space) continue;
    const SurfaceId id = term.surface();
    if (contains(id)) continue;
    place_[id.index()] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(id);
  }
}

void SurfaceSet::keep(std::span<const std::size_t> places) {
  for (std::size_t i = 0; i < places.size(); ++i) list_[i] = list_[places[i]];
  list_.resize(places.size());
  number();
}

void SurfaceSet::number() {
  for (std::size_t i = 0; i < list_.size(); ++i) place_[list_[i].index()] = static_cast<std::uint32_t>(i);
}

}  // namespace csgcast::detail
