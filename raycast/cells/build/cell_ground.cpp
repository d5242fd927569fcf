// SPDX-License-Identifier: MIT
#include "raycast/cells/build/cell_ground.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "raycast/cells/build/cell_box.h"
#include "raycast/cells/build/cell_data.h"
#include "raycast/cells/formula/leaf_terms.h"
#include "raycast/scene/even_looks.h"
#include "raycast/surface/kind.h"

namespace csgcast::detail {

CellGround::CellGround(const Scene& of, NodeId node) : scene(of) {
  const Box& box_of_node = scene.node(node).box;
  if (box_of_node.is_finite() && near_frame(in_frame(box_of_node, scene.frame()))) axes = common_axes(scene);
  const CellBox near{{-near_side, -near_side, -near_side}, {near_side, near_side, near_side}};
  forms.reserve(scene.surfaces().size());
  slacks.reserve(scene.surfaces().size());
  surfaces.reserve(scene.surfaces().size());
  for (const Surface& surface : scene.surfaces()) {
    forms.push_back({surface.local, surface.center});
    if (axes) forms.back() = axes->turned(forms.back());
    slacks.push_back(slack_of_lines(forms.back(), near));
    surfaces.push_back(make_lane_surface(surface, axes ? &forms.back() : nullptr));
  }
  forms.resize(literal_count(scene));
  slacks.resize(literal_count(scene));
  surfaces.resize(literal_count(scene));
  leaves_some_to_caster_ = std::any_of(surfaces.begin(), surfaces.end(), [](const LaneSurface& surface) {
    return surface.kind == LaneSurface::Kind::undecided;
  });
  even_look = even_looks(scene);
  const bool has_cuts =
      std::any_of(scene.leaves().begin(), scene.leaves().end(), [](const Leaf& leaf) { return leaf.shows_cut; });
  if (has_cuts) holders = HolderTree(scene, node);
  place_leaves(node);
}

LookId CellGround::look_of(const Leaf& leaf, bool one_region) const {
  if (!leaf.shows_cut) return leaf.look;
  const bool is_even = one_region && leaf.region.valid() && even_look[leaf.region.index()] != 0;
  return is_even ? scene.region(leaf.region).look : LookId();
}

Sides CellGround::sides_for_rays(SurfaceId id, const CellBox& b) const {
  const std::size_t surface = id.index();
  if (surfaces[surface].kind == LaneSurface::Kind::undecided)
    return is_finite(b.lower) && is_finite(b.upper) ? sides_by_kind(id, b) : Sides::both;
  const Vector half = 0.5 * (b.upper - b.lower);
  return is_finite(half) ? sides_of(form_in(surface, b), half) : sides_far_out(forms[surface], b);
}

Sides CellGround::sides_of_points(SurfaceId id, const CellBox& b) const {
  return scene.surface(id).in_range ? sides_within(forms[id.index()], b) : sides_by_kind(id, b);
}

// For a surface whose ten numbers decide nothing, or that has none, the kind may still know the sides.
Sides CellGround::sides_by_kind(SurfaceId id, const CellBox& b) const {
  const Surface& surface = scene.surface(id);
  return surface.kind->has_lanes ? Sides::both : surface.kind->sides_in(surface, scene.frame(), frame_box_of(b));
}

CellBox CellGround::frame_box_of(CellBox b) const {
  if (heights) {
    b.lower.z = heights->low;
    b.upper.z = heights->high;
  }
  return axes ? axes->turned_back(b) : b;
}

Box CellGround::scene_box_of(const CellBox& b) const {
  const CellBox straight = frame_box_of(b);
  const Frame& frame = scene.frame();
  Box result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double lower = frame.center[axis] + std::ldexp(straight.lower[axis], frame.exponent);
    const double upper = frame.center[axis] + std::ldexp(straight.upper[axis], frame.exponent);
    result.lower[axis] = std::nextafter(lower, -HUGE_VAL);
    result.upper[axis] = std::nextafter(upper, HUGE_VAL);
  }
  return result;
}

std::size_t CellGround::burden(const SurfaceSet& set) const {
  const auto is_undecided = [&](SurfaceId id) { return surfaces[id.index()].kind == LaneSurface::Kind::undecided; };
  if (!leaves_some_to_caster_ || std::none_of(set.list().begin(), set.list().end(), is_undecided)) return set.size();
  return set.size() + Cell::most_slots;
}

void CellGround::place_leaves(NodeId node) {
  leaf_boxes.resize(scene.leaves().size());
  for (const Node& at : scene.nodes()) {
    if (at.op == Node::Op::leaf) leaf_boxes[at.first] = box_of_leaf(scene.leaf(LeafId(at.first)), at.box);
  }
  is_bounded = scene.node(node).box.is_finite();
  constexpr double side = 0.5;
  box = {{-side, -side, -side}, {side, side, side}};
  if (!is_bounded || scene.node(node).box.is_null()) return;
  const CellBox solid = axes ? turned_box_of(node) : in_frame(scene.node(node).box, scene.frame());
  box = grown(solid, face_clearance);
  // Nothing beyond the solid's box is looked at, so unbounded leaves end there.
  for (CellBox& leaf : leaf_boxes) {
    if (!is_finite(leaf.upper - leaf.lower)) leaf = intersection(leaf, box);
  }
  for (const Node& cut : scene.nodes()) {
    if (cut.is_cut) end_leaves(cut);
  }
}

// A node that is cut has nothing outside its box. What is not taken away in it may end there, too: the node then has
// still nothing outside, and what it has inside.
void CellGround::end_leaves(const Node& cut) {
  const CellBox around = box_of(cut.box);
  std::vector<const Node*> open{&cut};
  while (!open.empty()) {
    const Node& node = *open.back();
    open.pop_back();
    if (node.op == Node::Op::leaf) {
      CellBox& leaf = leaf_boxes[node.first];
      leaf = intersection(leaf, around);
      continue;
    }
    if (node.op == Node::Op::complement || node.op == Node::Op::empty || node.op == Node::Op::everything) continue;
    const auto children = scene.children(node);
    for (const NodeId child : node.op == Node::Op::subtract ? children.first(1) : children)
      open.push_back(&scene.node(child));
  }
}

CellBox CellGround::box_of(const Box& world) const { return grown(tight_box_of(world), face_clearance); }

CellBox CellGround::tight_box_of(const Box& world) const {
  CSGCAST_PRECONDITION(world.is_finite());
  const CellBox straight = in_frame(world, scene.frame());
  return axes ? axes->holding(straight) : straight;
}

// The box of a leaf. In turned axes it is made tighter by those half-spaces of the leaf that give a box a side: planes
// square to an axis, spheres, and cylinders along an axis.
CellBox CellGround::box_of_leaf(const Leaf& leaf, const Box& world) const {
  const CellBox straight = in_frame(world, scene.frame());
  if (!axes) return straight;
  if (leaf.function != nullptr) return axes->holding(straight);  // such a leaf need not lie within its half-spaces
  CellBox result = axes->holding(straight);
  constexpr double margin = 0x1p-31;
  const auto cut = [&](std::size_t axis, double low, double high) {
    result.lower[axis] = std::fmax(result.lower[axis], low - margin);
    result.upper[axis] = std::fmin(result.upper[axis], high + margin);
  };
  for (const HalfSpace& half_space : scene.half_spaces(leaf)) {
    const LaneSurface& surface = surfaces[half_space.surface.index()];
    const bool takes_negative = half_space.sense == Sense::negative;
    const LaneSurface::Kind kind = surface.kind;
    if (kind < LaneSurface::Kind::plane) {
      const bool is_upper = takes_negative == (surface.c[1] > 0);
      cut(axis_of(kind), is_upper ? -HUGE_VAL : surface.c[0], is_upper ? surface.c[0] : HUGE_VAL);
    }
    if (!is_round(kind) || takes_negative != (surface.c[5] > 0)) continue;
    const double radius = std::sqrt(surface.c[3]);
    Vector center{surface.c[0], surface.c[1], surface.c[2]};
    if (kind == LaneSurface::Kind::sphere) center = axes->turned(center);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_axis_cylinder(kind) && axis == axis_of(kind)) continue;
      cut(axis, center[axis] - radius, center[axis] + radius);
    }
  }
  return result;
}

// The box of a node in turned axes, made from the boxes of its leaves. Children come before their nodes in the list.
CellBox CellGround::turned_box_of(NodeId node) const {
  std::vector<CellBox> boxes(node.index() + 1);
  for (std::uint32_t id = 0; id <= node.index(); ++id) {
    const Node& at = scene.node(NodeId(id));
    if (at.box.is_null() || !at.box.is_finite()) continue;  // nothing below this node is looked at
    if (at.op == Node::Op::leaf) {
      boxes[id] = leaf_boxes[at.first];
      continue;
    }
    CellBox own = axes->holding(in_frame(at.box, scene.frame()));
    const auto children = scene.children(at);
    const auto bounds = [&](NodeId child) { return scene.node(child).box.is_finite(); };
    const auto exists = [&](NodeId child) { return !scene.node(child).box.is_null(); };
    if (at.op == Node::Op::unite && std::all_of(children.begin(), children.end(), bounds)) {
      CellBox all{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
      for (const NodeId child : children) {
        if (exists(child)) all = hull(all, boxes[child.index()]);
      }
      own = intersection(own, all);
    } else if (at.op == Node::Op::subtract && bounds(children.front())) {
      own = intersection(own, boxes[children.front().index()]);
    } else if (at.op == Node::Op::intersect) {
      for (const NodeId child : children) {
        if (bounds(child) && exists(child)) own = intersection(own, boxes[child.index()]);
      }
    }
    boxes[id] = own;
  }
  return boxes[node.index()];
}

}  // namespace csgcast::detail
