// SPDX-License-Identifier: MIT
#include "raycast/cells/build/box_fold.h"

#include <algorithm>

#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/formula/leaf_terms.h"

namespace csgcast::detail {

BoxFold::BoxFold(const CellGround& ground, Places places)
    : ground_(ground), places_(places), asked_in_(ground.forms.size(), 0), answer_(ground.forms.size(), Sides::both) {}

void BoxFold::enter(const CellBox& box) {
  ++box_number_;
  box_ = places_ == Places::of_rays ? inflated(box) : box;
}

Sides BoxFold::find_sides(SurfaceId id) const {
  return places_ == Places::of_rays ? ground_.sides_for_rays(id, box_) : ground_.sides_of_points(id, box_);
}

Truth BoxFold::known_of(LeafId id) {
  if (apart(ground_.leaf_boxes[id.index()], box_)) return Truth::no;
  const Leaf& leaf = ground_.scene.leaf(id);
  if (leaf.function != nullptr) return folded(id).value;
  Truth all = Truth::yes;
  for (const HalfSpace& half_space : ground_.scene.half_spaces(leaf)) {
    all = std::min(all, known_of(half_space.surface, half_space.sense == Sense::positive));
    if (all == Truth::no) break;
  }
  return all;
}

// Folds a leaf that is not a conjunction, for the present box.
FoldedTerm BoxFold::folded(LeafId id) {
  const Leaf& leaf = ground_.scene.leaf(id);
  switch (leaf.function->in_box(ground_.scene.half_spaces(leaf), *this, leaf_terms_)) {
    case LeafFunction::Content::empty:
      return {Truth::no};
    case LeafFunction::Content::full:
      return {Truth::yes};
    case LeafFunction::Content::open:
      return {Truth::unknown};
    case LeafFunction::Content::terms:
      break;
  }
  leaf_whole_.terms.clear();
  append_leaf_terms(ground_.scene, id, leaf_terms_, leaf_whole_.terms);
  leaf_folder_.fold(
      leaf_whole_, leaf_folded_, [](const Term&) { return Truth::unknown; },
      [&](const Term& term) { return known_of(term.surface(), term.wants_positive()); });
  if (leaf_folded_.is_constant()) return {truth(leaf_folded_.value)};
  return {Truth::unknown, leaf_folded_.terms};
}

FoldedTerm BoxFold::folded(const Term& half_space) {
  const LeafId leaf = leaf_of(ground_.scene, half_space.surface());
  if (leaf.valid()) return folded(leaf);
  return {known_of(half_space.surface(), half_space.wants_positive())};
}

void BoxFold::fold(const Formula& from, const CellBox& box, Formula& result) {
  enter(box);
  const auto known_of_leaf = [&](const Term& leaf) {
    // If the leaf lacks half-spaces, it goes on beyond its box.
    return !leaf.is_wider && apart(ground_.leaf_boxes[leaf.what], box_) ? Truth::no : Truth::unknown;
  };
  if (ground_.scene.function_leaves().empty()) {
    folder_.fold(from, result, known_of_leaf,
                 [&](const Term& term) { return known_of(term.surface(), term.wants_positive()); });
  } else {
    folder_.fold(from, result, known_of_leaf, [&](const Term& term) { return folded(term); });
  }
}

}  // namespace csgcast::detail
