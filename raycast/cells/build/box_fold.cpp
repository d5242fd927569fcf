// SPDX-License-Identifier: MIT
#include "raycast/cells/build/box_fold.h"

#include "raycast/cells/build/cell_box.h"

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

Known BoxFold::known_of(LeafId id) {
  if (apart(ground_.leaf_boxes[id.index()], box_)) return Known::no;
  bool is_open = false;
  for (const HalfSpace& half_space : ground_.scene.half_spaces(ground_.scene.leaf(id))) {
    const Known known = known_of(half_space.surface, half_space.sense == Sense::positive);
    if (known == Known::no) return Known::no;
    is_open = is_open || known == Known::open;
  }
  return is_open ? Known::open : Known::yes;
}

void BoxFold::fold(const Formula& from, const CellBox& box, Formula& result) {
  enter(box);
  folder_.fold(
      from, result,
      [&](const Term& leaf) {
        // A leaf that lacks half-spaces goes on beyond its box.
        return !leaf.is_wider && apart(ground_.leaf_boxes[leaf.what], box_) ? Known::no : Known::open;
      },
      [&](const Term& term) { return known_of(term.surface(), term.wants_positive()); });
}

}  // namespace csgcast::detail
