// SPDX-License-Identifier: MIT
#include "raycast/cells/pieces.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "csg/base/precondition.h"
#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/detail/space_content.h"
#include "raycast/cells/formula/formula_table.h"
#include "raycast/cells/formula/leaf_terms.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast {
namespace {

// If a leaf has more half-spaces in a box, half-spaces that others imply are not searched for.
constexpr std::uint32_t most_compared = 128;

LocalForm multiple(LocalForm form, double s) {
  form.value *= s;
  form.gradient = s * form.gradient;
  for (double& bend : form.bend) bend *= s;
  return form;
}

}  // namespace

struct Piece::Crowd {
  detail::Formula formula;
};

struct PieceCutter::State {
  explicit State(const Space& of)
      : space(of),
        ground(*of.content().ground),
        box_fold(ground, detail::BoxFold::Places::exact),
        surfaces(ground.forms.size()) {}

  Piece fold(const detail::Formula& from, const CellBox& box);
  Piece fold_table(const Piece& from, const CellBox& box);
  bool tabulate(const detail::Formula& formula, Piece& piece);
  bool drop_implied(detail::Formula& formula, const CellBox& box);
  bool find_implied(const detail::Formula& formula, std::size_t leaf, const CellBox& box);

  const Space& space;
  const detail::CellGround& ground;
  detail::BoxFold box_fold;
  detail::Folder folder;
  detail::SurfaceSet surfaces;
  detail::FormulaTable formula_table;
  std::vector<bool> implied;  // by term
  std::vector<LocalForm> forms;
};

// Makes a piece of a folded formula. Returns false if the formula has a leaf's own literal, or too many surfaces for a
// table. Then only the number of surfaces is set.
bool PieceCutter::State::tabulate(const detail::Formula& formula, Piece& piece) {
  surfaces.gather(formula);
  piece.count = static_cast<std::uint32_t>(surfaces.size());
  bool is_told = true;
  if (!ground.scene.function_leaves().empty()) {
    for (const SurfaceId id : surfaces.list()) {
      const LeafId leaf = detail::leaf_of(ground.scene, id);
      if (!leaf.valid()) continue;
      is_told = false;
      piece.count += ground.scene.leaf(leaf).count - 1;  // any surface of the leaf may cross the box
    }
  }
  if (!is_told || surfaces.size() > Piece::most_surfaces) return false;
  surfaces.sort(std::less<>());
  formula_table.tabulate(formula, surfaces);
  piece.table = formula_table.as_function();
  std::transform(surfaces.list().begin(), surfaces.list().end(), piece.surfaces.begin(),
                 [](SurfaceId id) { return id.index(); });
  return true;
}

// Drops half-spaces of leaves that other half-spaces of the same leaf imply in the box. For a finely faceted solid
// these are nearly all, except for the few facets that cross the box. Returns false if there are none.
bool PieceCutter::State::drop_implied(detail::Formula& formula, const CellBox& box) {
  implied.assign(formula.terms.size(), false);
  bool any = false;
  for (std::size_t i = 0; i < formula.terms.size();) {
    const detail::Term& leaf = formula.terms[i];
    if (leaf.op == detail::Term::Op::leaf && leaf.size > 2 && leaf.size <= most_compared)
      any = find_implied(formula, i, box) || any;
    i += leaf.op == detail::Term::Op::leaf ? leaf.size : 1;
  }
  if (!any) return false;
  detail::Formula rest;
  folder.fold(
      formula, rest, [](const detail::Term&) { return Truth::unknown; },
      [&](const detail::Term& term) {
        return implied[static_cast<std::size_t>(&term - formula.terms.data())] ? Truth::yes : Truth::unknown;
      });
  formula = std::move(rest);
  return true;
}

bool PieceCutter::State::find_implied(const detail::Formula& formula, std::size_t leaf, const CellBox& box) {
  const std::size_t first = leaf + 1;
  const std::size_t end = leaf + formula.terms[leaf].size;
  forms.clear();
  for (std::size_t i = first; i < end; ++i) {
    forms.push_back(local_form(ground.forms[formula.terms[i].surface().index()], box));
    // The sign of the form is chosen so that it is at most 0 inside.
    if (formula.terms[i].wants_positive()) forms.back() = multiple(forms.back(), -1);
  }
  const Vector half = 0.5 * (box.upper - box.lower);
  bool any = false;
  for (std::size_t b = 0; b < forms.size(); ++b) {
    for (std::size_t a = 0; a < forms.size() && !implied[first + b]; ++a) {
      if (a == b || implied[first + a]) continue;
      if (!space.is_known(formula.terms[first + a].surface().index())) continue;
      if (!space.is_known(formula.terms[first + b].surface().index())) continue;
      implied[first + b] = detail::implies(forms[a], forms[b], half);
      any = any || implied[first + b];
    }
  }
  return any;
}

Piece PieceCutter::State::fold(const detail::Formula& from, const CellBox& box) {
  Piece piece;
  piece.box = box;
  detail::Formula folded;
  box_fold.fold(from, box, folded);
  if (folded.is_constant()) {
    piece.table = TruthTable::constant(folded.value);
  } else if (tabulate(folded, piece) || (drop_implied(folded, box) && tabulate(folded, piece))) {
    return fold_table(piece, box);  // this removes what does not matter
  } else {
    for (const SurfaceId id : surfaces.list()) piece.crowd_crossings += space.most_crossings(id.index());
    piece.crowd = std::make_shared<const Piece::Crowd>(Piece::Crowd{std::move(folded)});
  }
  return piece;
}

Piece PieceCutter::State::fold_table(const Piece& from, const CellBox& box) {
  Piece piece;
  piece.box = box;
  TruthTable table = from.table;
  std::array<bool, Piece::most_surfaces> stays{};
  for (std::size_t i = 0; i < from.count; ++i) {
    if (!table.depends_on(i)) continue;
    const detail::Sides sides = ground.sides_of_points(SurfaceId(from.surfaces[i]), box);
    stays[i] = sides == detail::Sides::both;
    if (!stays[i]) table = table.with(i, sides == detail::Sides::positive);
  }
  for (std::size_t i = 0; i < from.count; ++i) {
    // The sign of another surface may already make this one irrelevant.
    if (stays[i] && table.depends_on(i)) {
      table = table.renamed(i, piece.count);
      piece.surfaces[piece.count++] = from.surfaces[i];
    }
  }
  piece.table = table;
  return piece;
}

PieceCutter::PieceCutter(const Space& space) : state_(std::make_unique<State>(space)) {}
PieceCutter::~PieceCutter() = default;
PieceCutter::PieceCutter(PieceCutter&&) noexcept = default;

Piece PieceCutter::whole() {
  CSGCAST_PRECONDITION(state_->space.is_bounded() || state_->space.is_empty());
  const Space& space = state_->space;
  const detail::Formula& formula = space.content().formula;
  if (!formula.is_constant()) return state_->fold(formula, space.box());
  Piece piece;
  piece.box = space.box();
  piece.table = TruthTable::constant(formula.value);
  return piece;
}

std::pair<Piece, Piece> PieceCutter::cut(const Piece& piece, std::size_t axis, double at) {
  CellBox lower = piece.box;
  CellBox upper = piece.box;
  lower.upper[axis] = at;
  upper.lower[axis] = at;
  if (piece.is_crowded()) return {state_->fold(piece.crowd->formula, lower), state_->fold(piece.crowd->formula, upper)};
  return {state_->fold_table(piece, lower), state_->fold_table(piece, upper)};
}

}  // namespace csgcast
