// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/implied_fold.h"

#include <algorithm>
#include <array>
#include <span>

#include "csg/base/truth_table.h"
#include "raycast/cells/formula/context_fold.h"

namespace csgcast::detail {

bool ImpliedFold::fold(const Formula& formula, const SurfaceSet& surfaces, const Implications& implications,
                       Formula& simpler) {
  if (!implications.any()) return false;
  set_literals(formula, surfaces);
  known_.assign(formula.terms.size(), Truth::unknown);
  const bool any = surfaces.size() <= TruthTable::most_values
                       ? find_needless(formula, surfaces, implications)
                       : ContextFold(formula, implications, literals_, known_).run();
  if (!any) return false;
  folder_.fold(
      formula, simpler, [](const Term&) { return Truth::unknown; },
      [&](const Term& term) { return known_[static_cast<std::size_t>(&term - formula.terms.data())]; });
  mark_wider(formula, simpler);
  return true;
}

void ImpliedFold::set_literals(const Formula& formula, const SurfaceSet& surfaces) {
  literals_.assign(formula.terms.size(), 0);
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    const Term& term = formula.terms[at];
    if (term.op != Term::Op::half_space) continue;
    literals_[at] = static_cast<std::uint8_t>(2 * surfaces.place_of(term.surface()) + (term.wants_positive() ? 1 : 0));
  }
}

// Finds the surfaces that may be assumed to have one sign everywhere, by the formula's values in all states. Returns
// false if there are none.
bool ImpliedFold::find_needless(const Formula& formula, const SurfaceSet& surfaces, const Implications& implications) {
  table_.tabulate(formula, surfaces);
  TruthTable table = table_.as_function();
  const TruthTable impossible = implications.impossible_states();
  std::array<Truth, TruthTable::most_values> positive;  // by surface: the sign that it may be assumed to have
  positive.fill(Truth::unknown);
  bool any = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const bool value : {false, true}) {
      const TruthTable fixed = table.with(i, value);
      if (exceeds(table ^ fixed, impossible)) continue;
      positive[i] = value ? Truth::yes : Truth::no;
      table = fixed;
      any = true;
      break;
    }
  }
  if (!any) return false;
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    if (formula.terms[at].op != Term::Op::half_space) continue;
    const Truth known = positive[literals_[at] / 2];
    if (known != Truth::unknown)
      known_[at] = (known == Truth::yes) == (literals_[at] % 2 != 0) ? Truth::yes : Truth::no;
  }
  return true;
}

// Marks leaves that lost half-spaces which need not hold where the leaf's other half-spaces do.
void ImpliedFold::mark_wider(const Formula& formula, Formula& simpler) {
  wider_.clear();
  for (std::size_t at = 0; at < formula.terms.size(); ++at) {
    const Term& leaf = formula.terms[at];
    if (leaf.op != Term::Op::leaf) continue;
    const auto sides = std::span(known_).subspan(at + 1, leaf.size - 1);
    if (std::find(sides.begin(), sides.end(), Truth::yes) != sides.end()) wider_.push_back(leaf.what);
  }
  std::sort(wider_.begin(), wider_.end());
  for (Term& term : simpler.terms) {
    if (term.op == Term::Op::leaf && std::binary_search(wider_.begin(), wider_.end(), term.what)) term.is_wider = true;
  }
}

}  // namespace csgcast::detail
