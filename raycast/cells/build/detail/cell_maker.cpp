// SPDX-License-Identifier: MIT
#include "raycast/cells/build/detail/cell_maker.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "raycast/cells/build/detail/cell_cost.h"

namespace csgcast::detail {
namespace {

// If there are more surfaces, their relevance is not examined.
constexpr std::size_t most_tabled = 10;

}  // namespace

CellMaker::CellMaker(const CellGround& ground, BoxFold& fold, CellTree& tree)
    : ground_(ground), fold_(fold), tree_(tree), owners_(ground, fold), surfaces_(ground.forms.size()) {}

double CellMaker::add(const CellContent& content, const CellBox& box) {
  const Formula& formula = content.formula;
  if (formula.is_constant()) {
    tree_.add_constant(formula.value);
    return cost_of_cell(0);
  }
  const auto kind_of = [&](SurfaceId id) { return ground_.surfaces[id.index()].kind; };
  surfaces_.gather(formula);
  surfaces_.sort([&](SurfaceId a, SurfaceId b) {
    return kind_of(a) != kind_of(b) ? kind_of(a) < kind_of(b) : a < b;  // planes first
  });
  Cell cell;
  const bool has_table = set_table(formula, cell);
  if (surfaces_.empty()) {
    tree_.add_constant(cell.table != 0);
    return cost_of_cell(0);
  }
  cell.is_far = !is_finite(box.upper - box.lower);
  const auto is_decided = [&](SurfaceId id) {
    return cell.is_far ? is_plane(kind_of(id)) : kind_of(id) != LaneSurface::Kind::undecided;
  };
  const std::span<const SurfaceId> all = surfaces_.list();
  cell.is_undecided = all.size() > Cell::most_slots || !std::all_of(all.begin(), all.end(), is_decided);
  if (!cell.is_undecided) {
    add_slots(content, box, cell);
    if (!has_table) add_steps(formula, cell);
  }
  tree_.add_cell(cell);
  return cost_of_cell(ground_.burden(surfaces_));
}

// Gives the cell its table, and drops the surfaces that do not matter. Returns false if too many surfaces remain for a
// table.
bool CellMaker::set_table(const Formula& formula, Cell& cell) {
  if (surfaces_.size() > most_tabled) return false;
  table_.tabulate(formula, surfaces_);
  kept_.clear();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (table_.depends_on(i)) kept_.push_back(i);
  }
  if (kept_.size() > Cell::table_slots) return false;
  cell.table = table_.over(kept_);
  surfaces_.keep(kept_);
  return true;
}

void CellMaker::add_slots(const CellContent& content, const CellBox& box, Cell& cell) {
  std::vector<Slot>& slots = tree_.slots();
  cell.first_slot = static_cast<std::uint32_t>(slots.size());
  cell.slot_count = static_cast<std::uint8_t>(surfaces_.size());
  if (content.with_all != nullptr) fold_.fold(*content.with_all, box, with_all_);
  const Formula& all = content.with_all != nullptr ? with_all_ : content.formula;
  const std::span<const FaceOwners::Owner> owners = owners_.find(all, surfaces_, box);
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const LaneSurface& surface = ground_.surfaces[surfaces_[i].index()];
    if (is_plane(surface.kind)) ++cell.plane_count;
    if (surface.kind < LaneSurface::Kind::plane) ++cell.axis_plane_count;
    cell.tolerance.allow_for(surface);
    Slot& slot = slots.emplace_back(surface, surfaces_[i], owners[i].leaf, owners[i].look);
    if (is_revolved(surface.kind)) slot.c[5] = revolved_off(surface, box);
  }
}

// Adds the formula in postfix order, one step for each leaf.
void CellMaker::add_steps(const Formula& formula, Cell& cell) {
  struct Open {
    std::size_t end;
    std::size_t operands;
    Step::Op op;
  };
  static constexpr std::array op_of{Step::Op::unite, Step::Op::intersect, Step::Op::subtract, Step::Op::complement};
  std::vector<Step>& steps = tree_.steps();
  cell.first_step = static_cast<std::uint32_t>(steps.size());
  std::vector<Open> open;
  std::size_t height = 0;  // the number of operands that wait for another one
  for (std::size_t i = 0; i < formula.terms.size();) {
    const Term& term = formula.terms[i];
    if (term.op != Term::Op::leaf) {
      open.push_back({i + term.size, 0, op_of[static_cast<std::size_t>(term.op)]});
      ++i;
      continue;
    }
    Step leaf;
    for (const Term& side : std::span(formula.terms).subspan(i + 1, term.size - 1)) {
      const std::uint64_t slot = std::uint64_t{1} << surfaces_.place_of(side.surface());
      leaf.mask |= slot;
      if (side.wants_positive()) leaf.want |= slot;
    }
    steps.push_back(leaf);
    if (++height > Cell::most_operands) cell.is_undecided = true;
    i += term.size;
    while (!open.empty()) {
      Open& above = open.back();
      const bool joins = above.op == Step::Op::complement || above.operands > 0;
      if (joins) steps.push_back({above.op, 0, 0});
      if (above.operands > 0) --height;
      ++above.operands;
      if (above.end != i) break;
      open.pop_back();
    }
  }
  const std::size_t count = steps.size() - cell.first_step;
  if (count > Cell::most_steps) cell.is_undecided = true;
  cell.step_count = static_cast<std::uint16_t>(count);
}

}  // namespace csgcast::detail
