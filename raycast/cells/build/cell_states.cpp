// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "csg/base/length.h"
#include "csg/base/truth_table.h"
#include "raycast/cells/build/cell_builder.h"
#include "raycast/cells/formula/implications.h"

// What a formula comes to in a box, by where its surfaces are; and the states that these can be in: of two balls of
// which one is within the other there, or apart from it, one state never is. A formula need not depend on a surface
// whose sign changes nothing in all others.

namespace csgcast::detail {

Sides CellBuilder::sides_of(SurfaceId id, const CellBox& box) {
  const std::size_t i = id.index();
  if (asked_in_[i] != question_) {
    asked_in_[i] = question_;
    const Vector half = 0.5 * (box.upper - box.lower);
    answer_[i] = ground_.surfaces[i].kind == LaneSurface::Kind::undecided ? Sides::both
                 : is_finite(half) ? detail::sides_of(ground_.form_in(i, box), half)
                                   : sides_far_out(ground_.forms[i], box);
  }
  return answer_[i];
}

void CellBuilder::fold(const Formula& from, const CellBox& box, Formula& result) {
  ++question_;
  const CellBox wide = inflated(box);
  folder_.fold(
      from, result,
      [&](const Term& leaf) {
        return !leaf.is_wider && apart(ground_.leaf_boxes[leaf.what], wide) ? Known::no : Known::open;
      },
      [&](const Term& term) {
        const Sides sides = sides_of(term.surface(), wide);
        if (sides == Sides::both) return Known::open;
        return (sides == Sides::positive) == term.wants_positive() ? Known::yes : Known::no;
      });
}

void CellBuilder::gather_surfaces(const Formula& formula, std::vector<SurfaceId>& surfaces) {
  surfaces.clear();
  ++sighting_;
  for (const Term& term : formula.terms) {
    if (term.op != Term::Op::half_space) continue;
    std::uint32_t& seen = seen_in_[term.surface().index()];
    if (seen == sighting_) continue;
    seen = sighting_;
    surfaces.push_back(term.surface());
  }
}

void CellBuilder::gather_leaves(const Formula& formula, std::vector<LeafId>& leaves) const {
  leaves.clear();
  for (const Term& term : formula.terms) {
    if (term.op == Term::Op::leaf) leaves.emplace_back(term.what);
  }
}

// Leaves out of a formula half-spaces on which it does not depend in any state that is possible in a box; false if
// there are none, or more surfaces than are looked at.
bool CellBuilder::leave_out_implied(const Formula& formula, std::span<const SurfaceId> surfaces, const CellBox& box,
                                    Formula& simpler) {
  if (surfaces.size() < 2 || surfaces.size() > Implications::most || formula.terms.size() > most_terms_tried ||
      is_outside_)
    return false;
  const CellBox wide = inflated(box);
  const Vector half = 0.5 * (wide.upper - wide.lower);
  implications_.begin(surfaces.size(), half);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const bool is_decided = ground_.surfaces[surfaces[i].index()].kind != LaneSurface::Kind::undecided;
    if (!is_decided) continue;
    LocalForm form = ground_.form_in(surfaces[i].index(), wide);
    // A ray that departs from a surface is on the side that it departs to, even if its start is not quite.
    form.slack += cell_margin * steepness(form, half);
    implications_.add(i, form);
  }
  if (!implications_.any()) return false;
  set_literals(formula, surfaces);
  known_.assign(formula.terms.size(), Known::open);
  const bool any = surfaces.size() <= TruthTable::most_values
                       ? find_needless(formula, surfaces)
                       : ContextFold(formula, implications_, literals_, known_).run();
  if (!any) return false;
  folder_.fold(
      formula, simpler, [](const Term&) { return Known::open; },
      [&](const Term& term) { return known_[static_cast<std::size_t>(&term - formula.terms.data())]; });
  mark_wider(formula, simpler);
  return true;
}

void CellBuilder::set_literals(const Formula& formula, std::span<const SurfaceId> surfaces) {
  literals_.assign(formula.terms.size(), 0);
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    const Term& term = formula.terms[at];
    if (term.op != Term::Op::half_space) continue;
    const auto i = std::find(surfaces.begin(), surfaces.end(), term.surface()) - surfaces.begin();
    literals_[at] = static_cast<std::uint8_t>(2 * i + (term.wants_positive() ? 1 : 0));
  }
}

// Leaves of which half-spaces were left out that are not known to hold where the others do.
void CellBuilder::mark_wider(const Formula& formula, Formula& simpler) {
  wider_.clear();
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    const Term& leaf = formula.terms[at];
    if (leaf.op != Term::Op::leaf) continue;
    const auto sides = std::span(known_).subspan(at + 1, leaf.size - 1);
    if (std::find(sides.begin(), sides.end(), Known::yes) != sides.end()) wider_.push_back(leaf.what);
  }
  std::sort(wider_.begin(), wider_.end());
  for (Term& term : simpler.terms) {
    if (term.op == Term::Op::leaf && std::binary_search(wider_.begin(), wider_.end(), term.what)) term.is_wider = true;
  }
}

// By the values in all states: surfaces that may be taken to have one sign everywhere.
bool CellBuilder::find_needless(const Formula& formula, std::span<const SurfaceId> surfaces) {
  TruthTable table;
  const std::vector<std::uint64_t> words = table_of(formula, surfaces);
  for (std::size_t w = 0; w < words.size(); ++w) table.word(w) = words[w];
  const TruthTable impossible = implications_.impossible_states();
  std::array<Known, TruthTable::most_values> positive;
  positive.fill(Known::open);
  bool any = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const bool value : {false, true}) {
      const TruthTable fixed = table.with(i, value);
      if (exceeds(table ^ fixed, impossible)) continue;
      positive[i] = value ? Known::yes : Known::no;
      table = fixed;
      any = true;
      break;
    }
  }
  if (!any) return false;
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    if (formula.terms[at].op != Term::Op::half_space) continue;
    const Known known = positive[literals_[at] / 2];
    if (known != Known::open) known_[at] = (known == Known::yes) == (literals_[at] % 2 != 0) ? Known::yes : Known::no;
  }
  return true;
}

}  // namespace csgcast::detail
