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

/// What is known of a scene's node before its space is cut. All threads that build its cells read it. Boxes and forms
/// are in the frame's coordinates, turned to `axes` if there are any.
struct CellGround {
  /// The scene must outlive the ground.
  CellGround(const Scene& scene, NodeId node);

  const Scene& scene;
  std::optional<CellAxes> axes;  ///< the axes of the cells, if they are not the frame's
  /// Set for the ground of a section, whose forms do not depend on z: its extent on that axis.
  struct Heights {
    double low;
    double high;
  };
  std::optional<Heights> heights;
  std::vector<CellForm> forms;        ///< by surface, and after these by leaf with a function (leaf_terms.h)
  std::vector<double> slacks;         ///< by surface: the slack of its form for lines, in any box near the frame's cube
  std::vector<LaneSurface> surfaces;  ///< by surface, and after these by leaf with a function
  std::vector<CellBox> leaf_boxes;    ///< by leaf
  std::vector<std::uint8_t> even_look;  ///< by region: 1 if all its leaves, and its faces, look the same
  HolderTree holders;                   ///< empty if no leaf shows cuts
  CellBox box{};                        ///< holds the node; it is the frame's cube if the node is unbounded
  bool is_bounded = true;               ///< false if the node's box has an infinite side

  /// The look of a leaf's faces, if it is the same everywhere; not valid if it depends on the place. `one_region` says
  /// that everything else there belongs to the leaf's own region.
  LookId look_of(const Leaf& leaf, bool one_region) const;

  /// A surface's form about the middle of a box. Its slack also covers errors of places along lines. Precondition: the
  /// box is finite.
  LocalForm form_in(std::size_t surface, const CellBox& b) const {
    CSGCAST_PRECONDITION(is_finite(b.lower) && is_finite(b.upper));
    const CellForm& form = forms[surface];
    return local_form(form, b, is_near(b) ? slacks[surface] : slack_of_lines(form, b));
  }
  /// The sides of a surface that rays may meet in a box, which may be infinite. The answer is `both` if the surface's
  /// numbers decide nothing.
  Sides sides_for_rays(SurfaceId id, const CellBox& b) const;
  /// The sides of a surface that the exact points of a box may have. The answer is `both` if the surface's numbers
  /// decide nothing. Precondition: the box is finite.
  Sides sides_of_points(SurfaceId id, const CellBox& b) const;

  /// A box in the axes of the cells that holds a box of the scene. It leaves some room around faces in the sides of
  /// that box. Precondition: the box is finite.
  CellBox box_of(const Box& world) const;
  /// The same box without that room.
  CellBox tight_box_of(const Box& world) const;
  /// A box of the frame that holds a box of the cells.
  CellBox frame_box_of(CellBox b) const;
  /// A box of the scene that holds a box of the cells, rounded outward.
  Box scene_box_of(const CellBox& b) const;

  /// The cost of a cell that these surfaces cross, as a number of surfaces. If rays are left to the caster there, it is
  /// more than a cell may have.
  std::size_t burden(const SurfaceSet& set) const;

 private:
  static constexpr double near_side = 1.125;  // the frame's cube, with some room

  bool leaves_some_to_caster_ = false;  // true if some of `surfaces` are undecided

  static bool is_near(const CellBox& b) { return longest(b.lower) <= near_side && longest(b.upper) <= near_side; }
  Sides sides_by_kind(SurfaceId id, const CellBox& b) const;
  void place_leaves(NodeId node);
  void end_leaves(const Node& cut);
  CellBox box_of_leaf(const Leaf& leaf, const Box& world) const;
  CellBox turned_box_of(NodeId node) const;
};

}  // namespace csgcast::detail
