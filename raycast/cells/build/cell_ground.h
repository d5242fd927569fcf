// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "csg/base/length.h"
#include "raycast/cells/build/cell_axes.h"
#include "raycast/cells/build/cut_look.h"
#include "raycast/cells/build/lane_surface.h"
#include "raycast/cells/formula/surface_set.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/form_range.h"

namespace csgcast::detail {

/// What is known of a scene's node before its space is cut: all that build its cells read it, side by side. Boxes and
/// forms are in the frame's coordinates, turned to `axes` if there are any.
struct CellGround {
  /// The scene must outlive the ground.
  CellGround(const Scene& scene, NodeId node);

  const Scene& scene;
  std::optional<CellAxes> axes;  ///< the axes of the cells, if they are not the frame's
  /// Of the ground of a section, whose forms do not depend on z: where it lies on that axis.
  struct Heights {
    double low;
    double high;
  };
  std::optional<Heights> heights;
  std::vector<CellForm> forms;          ///< by surface; by leaf with a function after them (leaf_terms.h)
  std::vector<double> slacks;           ///< by surface: a slack for lines of its form in any box near the frame's cube
  std::vector<LaneSurface> surfaces;    ///< by surface and leaf likewise
  std::vector<CellBox> leaf_boxes;      ///< by leaf
  std::vector<std::uint8_t> even_look;  ///< by region: 1 if all that it is made of, and its faces, look the same
  HolderTree holders;                   ///< empty if no leaf shows cuts
  CellBox box{};                        ///< holds the node; if that is unbounded, it is the frame's cube
  bool is_bounded = true;               ///< false if the node's box has an infinite side

  /// What a leaf's faces show wherever they are; not valid if that depends on the place. `one_region` says that
  /// everything else there belongs to the leaf's own region.
  LookId look_of(const Leaf& leaf, bool one_region) const;

  /// A surface's form about the middle of a box, with a slack that covers the places of lines, which may be off.
  /// Precondition: the box is finite.
  LocalForm form_in(std::size_t surface, const CellBox& b) const {
    CSGCAST_PRECONDITION(is_finite(b.lower) && is_finite(b.upper));
    const CellForm& form = forms[surface];
    return local_form(form, b, is_near(b) ? slacks[surface] : slack_of_lines(form, b));
  }
  /// The sides of a surface that rays may meet in a box, which may be infinite; `both` if its numbers decide nothing.
  Sides sides_for_rays(SurfaceId id, const CellBox& b) const;
  /// The sides of a surface that the exact points of a box may have; `both` if its numbers decide nothing.
  /// Precondition: the box is finite.
  Sides sides_of_points(SurfaceId id, const CellBox& b) const;

  /// A box, in the axes of the cells, that holds a box of the scene and has room beside faces in its sides.
  /// Precondition: the box is finite.
  CellBox box_of(const Box& world) const;
  /// The same box without that room.
  CellBox tight_box_of(const Box& world) const;
  /// A box of the frame that holds a box of the cells.
  CellBox frame_box_of(CellBox b) const;
  /// The same of the scene, rounded outward.
  Box scene_box_of(const CellBox& b) const;

  /// What a cell that these cross costs, as a number of surfaces: more than a cell may have if rays are left to the
  /// caster there.
  std::size_t burden(const SurfaceSet& set) const;

 private:
  static constexpr double near_side = 1.125;  // the frame's cube, and room

  bool leaves_some_to_caster_ = false;  // some of `surfaces` are undecided

  static bool is_near(const CellBox& b) { return longest(b.lower) <= near_side && longest(b.upper) <= near_side; }
  Sides sides_by_kind(SurfaceId id, const CellBox& b) const;
  void place_leaves(NodeId node);
  CellBox box_of_leaf(const Leaf& leaf, const Box& world) const;
  CellBox turned_box_of(NodeId node) const;
};

}  // namespace csgcast::detail
