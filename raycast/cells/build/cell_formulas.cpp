// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>

#include "csg/base/truth_table.h"
#include "raycast/cells/build/cell_builder.h"

// The ends of the kd-tree: a formula becomes a table or steps, its surfaces slots with the faces that they make.

namespace csgcast::detail {
namespace {

constexpr std::size_t most_tabled = 10;  // more surfaces than that are not searched for those that do not matter

bool bit(std::span<const std::uint64_t> table, std::size_t state) {
  return ((table[state / 64] >> (state % 64)) & 1) != 0;
}

// Whether the value ever depends on one surface.
bool matters(std::span<const std::uint64_t> table, std::size_t surface) {
  const std::size_t flip = std::size_t{1} << surface;
  for (std::size_t w = 0; w < table.size(); ++w) {
    const std::uint64_t other = surface < 6 ? table[w] >> flip : table[w | flip / 64];
    if (((table[w] ^ other) & ~TruthTable::states_of_word(surface, w)) != 0) return true;
  }
  return false;
}

// The table over some of the surfaces, those that matter: the others may have any sign.
std::uint64_t narrowed(std::span<const std::uint64_t> table, std::span<const std::size_t> kept) {
  std::uint64_t result = 0;
  for (std::size_t state = 0; state < 64; ++state) {
    std::size_t wide = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) wide |= ((state >> i) & 1) << kept[i];
    result |= static_cast<std::uint64_t>(bit(table, wide)) << state;
  }
  return result;
}

}  // namespace

// The value in each state of the surfaces, 64 states a word: surface i is positive in states with bit i.
std::vector<std::uint64_t> CellBuilder::table_of(const Formula& formula, std::span<const SurfaceId> surfaces) {
  const std::size_t words = surfaces.size() <= 6 ? 1 : std::size_t{1} << (surfaces.size() - 6);
  std::vector<std::uint64_t> table(words);
  for (std::size_t word = 0; word < words; ++word) {
    table[word] = value_(formula.terms, [&](const Term& term) {
      const auto at = std::find(surfaces.begin(), surfaces.end(), term.surface());
      const auto i = static_cast<std::size_t>(at - surfaces.begin());
      const std::uint64_t positive = TruthTable::states_of_word(i, word);
      return term.wants_positive() ? positive : ~positive;
    });
  }
  return table;
}

// Leaves out the surfaces that do not matter; false if too many do for a table.
bool CellBuilder::add_table(const Formula& formula, std::vector<SurfaceId>& surfaces, Cell& cell) {
  if (surfaces.size() > most_tabled) return false;
  const std::vector<std::uint64_t> table = table_of(formula, surfaces);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (matters(table, i)) kept.push_back(i);
  }
  if (kept.size() > Cell::table_slots) return false;
  if (kept.size() == surfaces.size()) {
    cell.table = table.front();
    return true;
  }
  cell.table = narrowed(table, kept);
  std::vector<SurfaceId> that_matter;
  that_matter.reserve(kept.size());
  for (const std::size_t i : kept) that_matter.push_back(surfaces[i]);
  surfaces = std::move(that_matter);
  return true;
}

// The formula in postfix order, a leaf a step.
void CellBuilder::add_steps(const Formula& formula, Cell& cell) {
  struct Open {
    std::size_t end;
    std::size_t operands;
    Step::Op op;
  };
  static constexpr std::array op_of{Step::Op::unite, Step::Op::intersect, Step::Op::subtract, Step::Op::complement};
  cell.first_step = static_cast<std::uint32_t>(data_.steps.size());
  std::vector<Open> open;
  std::size_t height = 0;  // operands that wait for another
  for (std::size_t i = 0; i < formula.terms.size();) {
    const Term& term = formula.terms[i];
    if (term.op != Term::Op::leaf) {
      open.push_back({i + term.size, 0, op_of[static_cast<std::size_t>(term.op)]});
      ++i;
      continue;
    }
    Step leaf;
    for (const Term& side : std::span(formula.terms).subspan(i + 1, term.size - 1)) {
      const std::uint64_t slot = std::uint64_t{1} << slot_of_surface_[side.surface().index()];
      leaf.mask |= slot;
      if (side.wants_positive()) leaf.want |= slot;
    }
    data_.steps.push_back(leaf);
    if (++height > Cell::most_operands) cell.is_undecided = true;
    i += term.size;
    while (!open.empty()) {
      Open& above = open.back();
      const bool joins = above.op == Step::Op::complement || above.operands > 0;
      if (joins) data_.steps.push_back({above.op, 0, 0});
      if (above.operands > 0) --height;
      ++above.operands;
      if (above.end != i) break;
      open.pop_back();
    }
  }
  const std::size_t count = data_.steps.size() - cell.first_step;
  if (count > Cell::most_steps) cell.is_undecided = true;
  cell.step_count = static_cast<std::uint16_t>(count);
}

double CellBuilder::add_cell(const Content& content, const CellBox& box) {
  const Formula& formula = content.formula;
  const auto end_at = [&](std::size_t cell) {
    data_.nodes.push_back({0, static_cast<std::uint32_t>(cell), CellNode::no_axis});
    data_.nodes.back().set_first_slot(data_.cells[cell].first_slot);
  };
  if (formula.is_constant()) {
    end_at(formula.value ? 1 : 0);
    return cost_of_cell(0);
  }
  std::vector<SurfaceId> surfaces;
  gather_surfaces(formula, surfaces);
  std::sort(surfaces.begin(), surfaces.end(), [&](SurfaceId a, SurfaceId b) {
    const auto kind_a = ground_.surfaces[a.index()].kind;
    const auto kind_b = ground_.surfaces[b.index()].kind;
    return kind_a != kind_b ? kind_a < kind_b : a < b;
  });
  Cell cell;
  const bool has_table = add_table(formula, surfaces, cell);
  if (surfaces.empty()) {
    end_at(cell.table != 0 ? 1 : 0);
    return cost_of_cell(0);
  }
  cell.is_far = is_outside_;
  cell.is_undecided =
      surfaces.size() > Cell::most_slots || std::any_of(surfaces.begin(), surfaces.end(), [&](SurfaceId id) {
        const LaneSurface::Kind kind = ground_.surfaces[id.index()].kind;
        return kind == LaneSurface::Kind::undecided || (is_outside_ && kind > LaneSurface::Kind::plane);
      });
  if (!cell.is_undecided) {
    add_slots(content, surfaces, box, cell);
    if (!has_table) add_steps(formula, cell);
  }
  data_.cells.push_back(cell);
  end_at(data_.cells.size() - 1);
  return cost_of_cell(surfaces.size());
}

void CellBuilder::add_slots(const Content& content, std::span<const SurfaceId> surfaces, const CellBox& box,
                            Cell& cell) {
  cut_look_.reset();
  cell.first_slot = static_cast<std::uint32_t>(data_.slots.size());
  cell.slot_count = static_cast<std::uint8_t>(surfaces.size());
  slot_of_surface_.resize(scene_.surfaces().size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const LaneSurface& surface = ground_.surfaces[surfaces[i].index()];
    if (is_plane(surface.kind)) ++cell.plane_count;
    if (surface.kind < LaneSurface::Kind::plane) ++cell.axis_plane_count;
    cell.tolerance.allow_for(surface);
    slot_of_surface_[surfaces[i].index()] = static_cast<std::uint32_t>(i);
  }
  if (content.with_all != nullptr) fold(*content.with_all, box, with_all_);
  find_owners(content.with_all != nullptr ? with_all_ : content.formula, surfaces, box);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Owner& owner = owners_[i];
    const LaneSurface& surface = ground_.surfaces[surfaces[i].index()];
    Slot& slot = data_.slots.emplace_back(surface, surfaces[i], owner.is_one ? owner.leaf : LeafId(),
                                          owner.is_one_look ? owner.look : LookId());
    if (is_revolved(surface.kind)) slot.c[5] = revolved_off(surface, box);
  }
}

// The leaves that own each of the surfaces in the cell, and what their faces show.
void CellBuilder::find_owners(const Formula& formula, std::span<const SurfaceId> surfaces, const CellBox& box) {
  owners_.assign(surfaces.size(), Owner());
  bool one_region = true;
  RegionId region;
  for (const Term& term : formula.terms) {
    if (term.op != Term::Op::leaf) continue;
    const RegionId of_leaf = scene_.leaf(LeafId(term.what)).region;
    one_region = one_region && (!region.valid() || region == of_leaf);
    region = of_leaf;
  }
  for (std::size_t i = 0; i < formula.terms.size(); ++i) {
    const Term& term = formula.terms[i];
    if (term.op != Term::Op::leaf) continue;
    const LeafId leaf(term.what);
    std::optional<LookId> look;
    for (const Term& side : std::span(formula.terms).subspan(i + 1, term.size - 1)) {
      // What the value does not depend on has no slot.
      const std::uint32_t slot = slot_of_surface_[side.surface().index()];
      if (slot >= surfaces.size() || surfaces[slot] != side.surface()) continue;
      Owner& owner = owners_[slot];
      if (owner.term == i) continue;  // by another side
      if (!look) look = face_look(scene_.leaf(leaf), one_region, box);
      const bool is_first = owner.term == Owner::none;
      owner = {i, leaf, *look, is_first, look->valid() && (is_first || (owner.is_one_look && owner.look == *look))};
    }
  }
}

// What a leaf's faces show, if that is the same everywhere in the cell. Of a cut it is the look of the first leaf that
// holds the place: one of the same region if no other region has a part in the cell.
LookId CellBuilder::face_look(const Leaf& leaf, bool one_region, const CellBox& box) {
  const LookId everywhere = ground_.look_of(leaf, one_region);
  if (everywhere.valid() || !leaf.shows_cut) return everywhere;
  const HolderTree::Shown& shown = cut_look(box);
  if (!shown.is_one || (shown.may_be_none && !leaf.region.valid())) return {};
  if (!shown.may_be_none) return shown.look;
  const LookId own = scene_.region(leaf.region).look;
  return !shown.look.valid() || shown.look == own ? own : LookId();
}

const HolderTree::Shown& CellBuilder::cut_look(const CellBox& box) {
  if (cut_look_) return *cut_look_;
  ++question_;
  const CellBox wide = inflated(box);
  cut_look_ = ground_.holders.shown(scene_, holder_search_, [&](LeafId id) {
    if (apart(ground_.leaf_boxes[id.index()], wide)) return Known::no;
    bool is_open = false;
    for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaf(id))) {
      const Sides sides = sides_of(half_space.surface, wide);
      if (sides == Sides::both) {
        is_open = true;
      } else if ((sides == Sides::positive) != (half_space.sense == Sense::positive)) {
        return Known::no;
      }
    }
    return is_open ? Known::open : Known::yes;
  });
  return *cut_look_;
}

}  // namespace csgcast::detail
