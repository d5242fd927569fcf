// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/precondition.h"
#include "raycast/cells/build/cell_axes.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/build/cut_look.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/implications.h"

namespace csgcast::detail {

/// A cell's box as wide as it is taken to be.
inline CellBox inflated(const CellBox& box) {
  const Vector m{cell_margin, cell_margin, cell_margin};
  return {box.lower - m, box.upper + m};
}

inline bool apart(const CellBox& a, const CellBox& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (a.lower[axis] > b.upper[axis] || a.upper[axis] < b.lower[axis]) return true;
  }
  return false;
}

inline CellBox intersection(const CellBox& a, const CellBox& b) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::fmax(a.lower[axis], b.lower[axis]);
    result.upper[axis] = std::fmin(a.upper[axis], b.upper[axis]);
  }
  return result;
}

/// Half the surface of a box.
inline double area(const CellBox& box) {
  const Vector s = box.upper - box.lower;
  return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// What is known of a scene before its space is cut: read by all who build its cells.
struct CellGround {
  CellGround(const Scene& scene, NodeId node);

  const Scene& scene;
  std::optional<CellAxes> axes;         ///< if they are not the frame's
  std::vector<CellForm> forms;          ///< by surface
  std::vector<double> slacks;           ///< by surface: of its form in any box that is_near, for lines
  std::vector<LaneSurface> surfaces;    ///< by surface
  std::vector<CellBox> leaf_boxes;      ///< by leaf
  std::vector<std::uint8_t> even_look;  ///< by region: all that it is made of, and its faces, look the same
  HolderTree holders;
  CellBox box{};  ///< of the node; of an unbounded one the frame's cube
  bool is_bounded = true;

  /// What a leaf's faces show wherever they are; not valid if that depends on the place. `one_region`: of whatever else
  /// is there nothing belongs to another region.
  LookId look_of(const Leaf& leaf, bool one_region) const;
  static bool is_near(const CellBox& b) { return longest(b.lower) <= near_side && longest(b.upper) <= near_side; }
  /// A surface's form about the middle of a box, with a slack that covers lines' places. Precondition: it is finite.
  LocalForm form_in(std::size_t surface, const CellBox& b) const {
    CSGCAST_PRECONDITION(is_finite(b.lower) && is_finite(b.upper));
    const CellForm& form = forms[surface];
    return local_form(form, b, is_near(b) ? slacks[surface] : slack_of_lines(form, b));
  }
  /// The box, in the axes of the cells, that holds a box of the scene. Precondition: it is finite.
  CellBox box_of(const Box& world) const;
  /// The same without room beside faces in its sides.
  CellBox tight_box_of(const Box& world) const;

 private:
  static constexpr double near_side = 1.125;  ///< the frame's cube, and room

  void place_leaves(NodeId node);
  CellBox box_of_leaf(const Leaf& leaf, const Box& world) const;
  CellBox turned_box_of(NodeId node) const;
};

/// Whether a box is where turned forms are told (CellAxes::turned): all but solids that half-spaces bound far beyond
/// every bounded leaf are.
inline bool near_frame(const CellBox& box) { return longest(box.lower) <= 1 && longest(box.upper) <= 1; }

/// Cuts the space of a scene's node into cells, each with the formula of the surfaces that cross it.
///
/// From the top down: a child's formula is its parent's, folded by what interval arithmetic shows to be constant in the
/// child. Splits minimise the expected cost of a ray (the surface area heuristic); parts that turned out no cheaper
/// than one cell become one. Large parts are built side by side, by a builder each; what comes out does not depend on
/// how many threads there are.
class CellBuilder {
 public:
  CellBuilder(const CellGround& ground, std::size_t leaves);

  /// The cells of the node, as if it were cut by one builder. `whole`: its formula.
  CellData build(NodeId node, const Formula& whole);

  /// How far beside a face a split is clear of it: more than what cells and the boxes of leaves are widened by.
  static constexpr double beside = 0x1p-26;
  /// Formulas with more terms are not folded to see what a split brings, nor searched for what others imply.
  static constexpr std::size_t most_terms_tried = 2048;

 private:
  struct Split {
    std::size_t axis = 0;
    double at = 0;
    double cost = 0;
  };
  // Of a surface in the cell that is being made: the last leaf that was found to own it, whether it is the only one,
  // and whether the faces of all show the same.
  struct Owner {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t term = none;  // of the leaf
    LeafId leaf;
    LookId look;
    bool is_one = false;
    bool is_one_look = false;
  };
  // What the tree comes to in a box.
  struct Content {
    const Formula& formula;
    const Formula* with_all = nullptr;  // of the box or one around it, if surfaces were left out: whose their faces are
  };
  struct Marks {
    std::size_t nodes, cells, slots, steps;
  };

  static double cost_of_cell(std::size_t surfaces);
  void build_outside(const Formula& whole);
  double build_parts(const Content& content, const CellBox& box, const Split& split, std::size_t leaves, int depth,
                     int hopes);
  void append(CellData&& part);
  double build(const Content& content, const CellBox& box, int depth, int hopes);
  double add_cell(const Content& content, const CellBox& box);
  bool leave_out_implied(const Formula& formula, std::span<const SurfaceId> surfaces, const CellBox& box,
                         Formula& simpler);
  void set_literals(const Formula& formula, std::span<const SurfaceId> surfaces);
  void mark_wider(const Formula& formula, Formula& simpler);
  bool find_needless(const Formula& formula, std::span<const SurfaceId> surfaces);
  void fold(const Formula& from, const CellBox& box, Formula& result);
  Sides sides_of(SurfaceId id, const CellBox& inflated);
  void gather_surfaces(const Formula& formula, std::vector<SurfaceId>& surfaces);
  void gather_leaves(const Formula& formula, std::vector<LeafId>& leaves) const;
  static bool is_sliver(const Split& split, const CellBox& box);
  static Split split_in_half(const CellBox& box);
  Split split_by_bins(std::span<const LeafId> leaves, const CellBox& box) const;
  Split split_by_trial(const Formula& formula, std::span<const LeafId> leaves, const CellBox& box);
  void find_candidates(std::span<const LeafId> leaves, const CellBox& box);
  double trial_cost(const Formula& formula, const CellBox& box);
  std::vector<std::uint64_t> table_of(const Formula& formula, std::span<const SurfaceId> surfaces);
  bool add_table(const Formula& formula, std::vector<SurfaceId>& surfaces, Cell& cell);
  void add_steps(const Formula& formula, Cell& cell);
  void add_slots(const Content& content, std::span<const SurfaceId> surfaces, const CellBox& box, Cell& cell);
  void find_owners(const Formula& formula, std::span<const SurfaceId> surfaces, const CellBox& box);
  LookId face_look(const Leaf& leaf, bool one_region, const CellBox& box);
  const HolderTree::Shown& cut_look(const CellBox& box);
  Marks marks() const { return {data_.nodes.size(), data_.cells.size(), data_.slots.size(), data_.steps.size()}; }
  bool spend(const Formula& formula);
  bool is_one_constant(const Marks& marks) const;
  void forget_since(const Marks& marks);

  const CellGround& ground_;
  const Scene& scene_;
  CellData data_;
  std::size_t most_crowded_splits_;  // that promise nothing
  std::size_t crowded_splits_ = 0;
  std::size_t spare_terms_;  // of formulas that may still be tried more than usual
  bool is_outside_ = false;  // the cells that are being made are infinite
  Folder folder_;
  FormulaValue value_;
  // What is known of the surfaces in the box that is being folded.
  std::vector<std::uint32_t> asked_in_;
  std::vector<Sides> answer_;
  std::uint32_t question_ = 0;
  std::vector<std::uint32_t> seen_in_;
  std::uint32_t sighting_ = 0;
  std::vector<std::uint32_t> slot_of_surface_;  // in the cell that is being made
  std::vector<Owner> owners_;                   // of its surfaces
  std::optional<HolderTree::Shown> cut_look_;   // in the cell that is being made, once it is known
  HolderTree::Search holder_search_;
  std::vector<double> places_;  // of candidates on an axis
  std::vector<Split> candidates_;
  Formula trial_;
  std::vector<SurfaceId> trial_surfaces_;
  // What is known where half-spaces are left out of a formula, by term.
  Implications implications_;
  std::vector<std::uint8_t> literals_;
  std::vector<Known> known_;
  std::vector<std::uint32_t> wider_;
  Formula with_all_;  // what is in the cell that is being made, nothing left out
};

}  // namespace csgcast::detail
