// SPDX-License-Identifier: MIT
#include "raycast/cells/build/conjunctions.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/build/cell_data.h"

namespace csgcast::detail {
namespace {

// An operator whose operands are being read.
struct Open {
  std::size_t end;
  Term::Op op;
  bool is_top;  // true if it is the first operand of the operators above, all of which are differences
  bool is_subtracted;
  bool has_first;
};

// Adds a leaf to the last conjunction. Returns false if lanes cannot compute the result.
bool add_leaf(const CellGround& ground, std::span<const Term> leaf, Conjunctions& result) {
  const LeafId id(leaf.front().what);
  Conjunctions::Part& part = result.parts.back();
  part.box = intersection(part.box, ground.leaf_boxes[id.index()]);
  for (const Term& term : leaf.subspan(1)) {
    if (ground.surfaces[term.surface().index()].kind == LaneSurface::Kind::undecided) return false;
    const auto own = std::span(result.sides).subspan(part.first);
    const auto same =
        std::find_if(own.begin(), own.end(), [&](const auto& side) { return side.surface == term.surface(); });
    if (same != own.end()) {
      // The two sides share only a face without thickness.
      if (same->wants_positive != term.wants_positive()) part.box.upper.x = -HUGE_VAL;
      same->is_one = same->is_one && same->leaf == id;
      continue;
    }
    result.sides.push_back({term.surface(), id, term.wants_positive(), true});
    if (++part.count > Cell::most_slots) return false;
  }
  return true;
}

}  // namespace

std::optional<Conjunctions> conjunctions_of(const CellGround& ground, const Formula& formula,
                                            const CellBox& everything) {
  Conjunctions result;
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
      if (!joins || !in_intersection) {
        result.parts.push_back({everything, static_cast<std::uint32_t>(result.sides.size()), 0, own.is_subtracted});
      }
      if (!add_leaf(ground, std::span(formula.terms).subspan(i, term.size), result)) return std::nullopt;
      joins = true;
      i += term.size;
      continue;
    }
    const bool fits = term.op == Term::Op::unite      ? !in_intersection
                      : term.op == Term::Op::subtract ? own.is_top
                                                      : term.op == Term::Op::intersect;
    if (!fits) return std::nullopt;
    // An intersection within another one adds to the same conjunction.
    if (term.op == Term::Op::intersect && !in_intersection) joins = false;
    open.push_back(own);
    ++i;
  }
  return result;
}

}  // namespace csgcast::detail
