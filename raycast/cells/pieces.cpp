// SPDX-License-Identifier: MIT
#include "raycast/cells/pieces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "csg/base/precondition.h"
#include "raycast/cells/detail/space_content.h"

namespace csgcast {

namespace {

// Leaves with more half-spaces in a box are not searched for those that others imply.
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
  explicit State(const Space& of) : space(of), ground(*of.content().ground) {
    asked_in.assign(ground.forms.size(), 0);
    answer.assign(ground.forms.size(), detail::Sides::both);
  }

  detail::Sides sides_of(std::uint32_t surface, const CellBox& box) {
    if (!space.is_known(surface)) return detail::Sides::both;
    return detail::sides_within(ground.forms[surface], box);
  }

  detail::Sides remembered_sides(std::uint32_t surface, const CellBox& box) {
    if (asked_in[surface] != question) {
      asked_in[surface] = question;
      answer[surface] = sides_of(surface, box);
    }
    return answer[surface];
  }

  Piece fold(const detail::Formula& from, const CellBox& box);
  Piece fold_table(const Piece& from, const CellBox& box);
  bool tabulate(const detail::Formula& formula, Piece& piece);
  std::uint32_t distinct_surfaces(const detail::Formula& formula);
  bool drop_implied(detail::Formula& formula, const CellBox& box);
  bool find_implied(const detail::Formula& formula, std::size_t leaf, const CellBox& box);

  const Space& space;
  const detail::CellGround& ground;
  detail::Folder folder;
  detail::FormulaValue value;
  // What is known of the surfaces in the box that is being folded.
  std::vector<std::uint32_t> asked_in;
  std::vector<detail::Sides> answer;
  std::uint32_t question = 0;
  std::vector<std::uint32_t> surfaces;
  std::vector<bool> implied;  // by term
  std::vector<LocalForm> forms;
};

// A piece of a formula that is folded. False if too many surfaces are left.
bool PieceCutter::State::tabulate(const detail::Formula& formula, Piece& piece) {
  surfaces.clear();
  for (const detail::Term& term : formula.terms) {
    if (term.op != detail::Term::Op::half_space) continue;
    const std::uint32_t id = term.surface().index();
    if (std::find(surfaces.begin(), surfaces.end(), id) != surfaces.end()) continue;
    if (surfaces.size() == Piece::most_surfaces) return false;
    surfaces.push_back(id);
  }
  std::sort(surfaces.begin(), surfaces.end());
  const std::size_t words = surfaces.size() <= 6 ? 1 : TruthTable::words;
  for (std::size_t w = 0; w < TruthTable::words; ++w) {
    if (w >= words) {
      piece.table.word(w) = piece.table.word(0);
      continue;
    }
    piece.table.word(w) = value(formula.terms, [&](const detail::Term& term) {
      const auto at = std::lower_bound(surfaces.begin(), surfaces.end(), term.surface().index());
      const auto i = static_cast<std::size_t>(at - surfaces.begin());
      const std::uint64_t positive = TruthTable::states_of_word(i, w);
      return term.wants_positive() ? positive : ~positive;
    });
  }
  piece.count = static_cast<std::uint32_t>(surfaces.size());
  std::copy(surfaces.begin(), surfaces.end(), piece.surfaces.begin());
  return true;
}

std::uint32_t PieceCutter::State::distinct_surfaces(const detail::Formula& formula) {
  ++question;
  std::uint32_t count = 0;
  for (const detail::Term& term : formula.terms) {
    if (term.op != detail::Term::Op::half_space) continue;
    std::uint32_t& asked = asked_in[term.surface().index()];
    if (asked != question) ++count;
    asked = question;
  }
  return count;
}

// The half-spaces of a leaf that others of it imply in the box: most of a finely faceted solid's are, beside the few
// facets that cross the box. False if there are none.
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
      formula, rest, [](const detail::Term&) { return detail::Known::open; },
      [&](const detail::Term& term) {
        return implied[static_cast<std::size_t>(&term - formula.terms.data())] ? detail::Known::yes
                                                                               : detail::Known::open;
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
    // Turned so that it is at most 0 inside.
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
  ++question;
  detail::Formula folded;
  folder.fold(
      from, folded,
      [&](const detail::Term& leaf) {
        return detail::apart(ground.leaf_boxes[leaf.what], box) ? detail::Known::no : detail::Known::open;
      },
      [&](const detail::Term& term) {
        const detail::Sides sides = remembered_sides(term.surface().index(), box);
        if (sides == detail::Sides::both) return detail::Known::open;
        return (sides == detail::Sides::positive) == term.wants_positive() ? detail::Known::yes : detail::Known::no;
      });
  if (folded.is_constant()) {
    piece.table = TruthTable::constant(folded.value);
  } else if (tabulate(folded, piece) || (drop_implied(folded, box) && tabulate(folded, piece))) {
    return fold_table(piece, box);  // leaves out what does not matter
  } else {
    piece.count = distinct_surfaces(folded);
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
    const detail::Sides sides = sides_of(from.surfaces[i], box);
    stays[i] = sides == detail::Sides::both;
    if (!stays[i]) table = table.with(i, sides == detail::Sides::positive);
  }
  for (std::size_t i = 0; i < from.count; ++i) {
    // Another one's side may have settled that it does not matter either.
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
