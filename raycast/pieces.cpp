// SPDX-License-Identifier: MIT
#include "raycast/pieces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "raycast/detail/cell_builder.h"
#include "raycast/truth_table.h"

namespace csgcast {

Space::Space(const Scene& scene, NodeId node, std::vector<NodeId> less)
    : node_(node), less_(std::move(less)), ground_(std::make_unique<const detail::CellGround>(scene, node)) {}

Space::~Space() = default;
Space::Space(Space&&) noexcept = default;

const Scene& Space::scene() const { return ground_->scene; }
bool Space::is_bounded() const { return ground_->is_bounded; }
bool Space::is_empty() const { return scene().node(node_).box.is_null(); }
const CellBox& Space::box() const { return ground_->box; }
const CellForm& Space::form(std::uint32_t surface) const { return ground_->forms[surface]; }
bool Space::is_known(std::uint32_t surface) const { return scene().surfaces()[surface].in_range; }
bool Space::is_plane(std::uint32_t surface) const { return scene().surfaces()[surface].kind == SurfaceKind::plane; }
double Space::scale() const { return std::ldexp(1.0, scene().frame().exponent); }

std::array<Vector, 3> Space::axes() const {
  if (ground_->axes) return ground_->axes->rounded();
  return {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
}

Vector Space::turned_back(Vector v) const {
  const auto rows = axes();
  return v.x * rows[0] + v.y * rows[1] + v.z * rows[2];
}

Point Space::in_scene(Vector u) const { return scene().frame().center + scale() * turned_back(u); }

struct PieceCutter::State {
  explicit State(const Space& of) : space(of), ground(of.ground()) {
    asked_in.assign(ground.forms.size(), 0);
    answer.assign(ground.forms.size(), detail::Sides::both);
  }

  detail::Sides sides_of(std::uint32_t surface, const CellBox& box) {
    if (!space.is_known(surface)) return detail::Sides::both;
    return detail::sides_in(ground.forms[surface], box);
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

  const Space& space;
  const detail::CellGround& ground;
  detail::Folder folder;
  detail::FormulaValue value;
  // What is known of the surfaces in the box that is being folded.
  std::vector<std::uint32_t> asked_in;
  std::vector<detail::Sides> answer;
  std::uint32_t question = 0;
  std::vector<std::uint32_t> surfaces;
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
  piece.table = value(formula.terms, [&](const detail::Term& term) {
    const auto at = std::lower_bound(surfaces.begin(), surfaces.end(), term.surface().index());
    const std::uint64_t positive = positive_states(static_cast<std::size_t>(at - surfaces.begin()));
    return term.wants_positive() ? positive : ~positive;
  });
  piece.count = static_cast<std::uint32_t>(surfaces.size());
  std::copy(surfaces.begin(), surfaces.end(), piece.surfaces.begin());
  return true;
}

Piece PieceCutter::State::fold(const detail::Formula& from, const CellBox& box) {
  Piece piece;
  piece.box = box;
  ++question;
  detail::Formula folded;
  folder.fold(
      from, folded,
      [&](LeafId leaf) {
        return detail::apart(ground.leaf_boxes[leaf.index()], box) ? detail::Known::no : detail::Known::open;
      },
      [&](const detail::Term& term) {
        const detail::Sides sides = remembered_sides(term.surface().index(), box);
        if (sides == detail::Sides::both) return detail::Known::open;
        return (sides == detail::Sides::positive) == term.wants_positive() ? detail::Known::yes : detail::Known::no;
      });
  if (folded.is_constant()) {
    piece.table = folded.value ? ~std::uint64_t{0} : 0;
  } else if (tabulate(folded, piece)) {
    return fold_table(piece, box);  // leaves out what does not matter
  } else {
    piece.count = static_cast<std::uint32_t>(folded.terms.size());
    piece.formula = std::make_shared<const detail::Formula>(std::move(folded));
  }
  return piece;
}

Piece PieceCutter::State::fold_table(const Piece& from, const CellBox& box) {
  Piece piece;
  piece.box = box;
  std::uint64_t table = from.table;
  std::array<bool, Piece::most_surfaces> stays{};
  for (std::size_t i = 0; i < from.count; ++i) {
    if (!depends_on(table, i)) continue;
    const detail::Sides sides = sides_of(from.surfaces[i], box);
    stays[i] = sides == detail::Sides::both;
    if (!stays[i]) table = restricted(table, i, sides == detail::Sides::positive);
  }
  for (std::size_t i = 0; i < from.count; ++i) {
    // Another one's side may have settled that it does not matter either.
    if (stays[i] && depends_on(table, i)) {
      table = renamed(table, i, piece.count);
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
  const Space& space = state_->space;
  const detail::Formula formula = detail::formula_of_difference(space.scene(), space.node(), space.less());
  if (!formula.is_constant() && !space.is_empty()) return state_->fold(formula, space.box());
  Piece piece;
  piece.box = space.box();
  piece.table = formula.is_constant() && formula.value && !space.is_empty() ? ~std::uint64_t{0} : 0;
  return piece;
}

std::pair<Piece, Piece> PieceCutter::cut(const Piece& piece, std::size_t axis, double at) {
  CellBox lower = piece.box;
  CellBox upper = piece.box;
  lower.upper[axis] = at;
  upper.lower[axis] = at;
  if (piece.is_crowded()) return {state_->fold(*piece.formula, lower), state_->fold(*piece.formula, upper)};
  return {state_->fold_table(piece, lower), state_->fold_table(piece, upper)};
}

}  // namespace csgcast
