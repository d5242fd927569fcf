// SPDX-License-Identifier: MIT
#include "raycast/cells/build/detail/face_owners.h"

namespace csgcast::detail {

std::span<const FaceOwners::Owner> FaceOwners::find(const Formula& formula, const SurfaceSet& surfaces,
                                                    const CellBox& box) {
  constexpr auto none = static_cast<std::size_t>(-1);
  cut_look_.reset();
  owners_.assign(surfaces.size(), Owner());
  last_term_.assign(surfaces.size(), none);
  const bool one_region = has_one_region(formula);
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    const Term& term = formula.terms[at];
    if (term.op != Term::Op::leaf) continue;
    const LeafId leaf(term.what);
    std::optional<LookId> look;
    for (const Term& side : std::span(formula.terms).subspan(at + 1, term.size - 1)) {
      if (!surfaces.contains(side.surface())) continue;  // the value does not depend on this surface
      const std::size_t place = surfaces.place_of(side.surface());
      if (last_term_[place] == at) continue;  // the leaf has both sides of the surface
      if (!look) look = face_look(ground_.scene.leaf(leaf), one_region, box);
      Owner& owner = owners_[place];
      const bool is_first = last_term_[place] == none;
      if (is_first) owner.leaf = leaf;
      if (owner.leaf != leaf) owner.leaf = LeafId();  // if it is the same leaf, the leaf has several terms
      owner.look = is_first || owner.look == *look ? *look : LookId();
      last_term_[place] = at;
    }
  }
  return owners_;
}

bool FaceOwners::has_one_region(const Formula& formula) const {
  RegionId region;
  for (const Term& term : formula.terms) {
    if (term.op != Term::Op::leaf) continue;
    const RegionId of_leaf = ground_.scene.leaf(LeafId(term.what)).region;
    if (region.valid() && region != of_leaf) return false;
    region = of_leaf;
  }
  return true;
}

// The look of a leaf's faces, if it is the same everywhere in the cell. A cut shows the look of the first leaf that
// holds the place. If no other region has a part in the cell, this leaf is one of the same region.
LookId FaceOwners::face_look(const Leaf& leaf, bool one_region, const CellBox& box) {
  const LookId everywhere = ground_.look_of(leaf, one_region);
  if (everywhere.valid() || !leaf.shows_cut) return everywhere;
  const HolderTree::Shown& shown = cut_look(box);
  if (!shown.is_one || (shown.may_be_none && !leaf.region.valid())) return {};
  if (!shown.may_be_none) return shown.look;
  const LookId own = ground_.scene.region(leaf.region).look;
  return !shown.look.valid() || shown.look == own ? own : LookId();
}

const HolderTree::Shown& FaceOwners::cut_look(const CellBox& box) {
  if (!cut_look_) {
    fold_.enter(box);
    cut_look_ = ground_.holders.shown(ground_.scene, holder_search_, [&](LeafId id) { return fold_.known_of(id); });
  }
  return *cut_look_;
}

}  // namespace csgcast::detail
