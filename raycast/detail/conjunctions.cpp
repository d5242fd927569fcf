// SPDX-License-Identifier: MIT
#include "raycast/detail/conjunctions.h"

#include <algorithm>
#include <cmath>

namespace csgcast::detail {

bool Conjunctions::read(const Formula& formula, BoxTree& tree) {
  std::vector<Open> open;
  bool joins = false;
  for (std::size_t i = 0; i < formula.terms.size();) {
    const Term& term = formula.terms[i];
    while (!open.empty() && open.back().end == i) open.pop_back();
    Open own{i + term.size, term.op, true, false, false};
    bool in_intersection = false;
    if (!open.empty()) {
      Open& above = open.back();
      const bool is_first = !above.has_first;
      above.has_first = true;
      in_intersection = above.op == Term::Op::intersect;
      const bool is_only = is_first && own.end == above.end;
      own.is_top = above.is_top && (above.op == Term::Op::subtract ? is_first : is_only && !in_intersection);
      own.is_subtracted = above.is_subtracted || (above.op == Term::Op::subtract && !is_first);
    }
    if (term.op == Term::Op::leaf) {
      if (!add_leaf(std::span(formula.terms).subspan(i, term.size), joins && in_intersection, own.is_subtracted, tree))
        return false;
      joins = true;
      i += term.size;
      continue;
    }
    const bool fits = term.op == Term::Op::unite      ? !in_intersection
                      : term.op == Term::Op::subtract ? own.is_top
                                                      : term.op == Term::Op::intersect;
    if (!fits) return false;
    // One intersection within another goes on with its conjunction.
    if (term.op == Term::Op::intersect && !in_intersection) joins = false;
    open.push_back(own);
    ++i;
  }
  return true;
}

bool Conjunctions::add_leaf(std::span<const Term> leaf, bool joins, bool is_subtracted, BoxTree& tree) {
  const LeafId id(leaf.front().what);
  CellBox box = intersection(ground_.leaf_boxes[id.index()], everything_);
  if (joins) {
    box = intersection(box, boxes_.back());
  } else {
    tree.conjunctions.push_back({static_cast<std::uint32_t>(tree.sides.size()), 0, is_subtracted});
    boxes_.emplace_back();
  }
  boxes_.back() = box;
  if (tree.conjunctions.back().count + leaf.size() - 1 > Cell::most_slots) return false;
  for (const Term& side : leaf.subspan(1)) {
    if (ground_.surfaces[side.surface().index()].kind == LaneSurface::Kind::undecided) return false;
    const auto begin = owners_.begin() + tree.conjunctions.back().first;
    const auto same =
        std::find_if(begin, owners_.end(), [&](const auto& own) { return own.surface == side.surface(); });
    if (same != owners_.end()) {
      // Of both sides there is nothing, but for a face without a thickness.
      const auto at = static_cast<std::size_t>(same - owners_.begin());
      if (tree.sides[at].wants_positive != side.wants_positive()) boxes_.back().upper.x = -HUGE_VAL;
      same->is_one = same->is_one && same->leaf == id;
      continue;
    }
    tree.sides.push_back({0, side.wants_positive(), false});
    owners_.push_back({side.surface(), id});
    ++tree.conjunctions.back().count;
  }
  return true;
}

}  // namespace csgcast::detail
