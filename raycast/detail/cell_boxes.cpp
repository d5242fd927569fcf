// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "raycast/detail/cell_builder.h"

// Where leaves lie, in the axes of the cells.

namespace csgcast::detail {
namespace {

CellBox hull(const CellBox& a, const CellBox& b) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::fmin(a.lower[axis], b.lower[axis]);
    result.upper[axis] = std::fmax(a.upper[axis], b.upper[axis]);
  }
  return result;
}

CellBox intersection(const CellBox& a, const CellBox& b) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::fmax(a.lower[axis], b.lower[axis]);
    result.upper[axis] = std::fmin(a.upper[axis], b.upper[axis]);
  }
  return result;
}

CellBox in_frame(const Box& box, const Frame& frame) {
  CellBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Rounds by less than 2^-50 of numbers below 4, which the boxes' own margin covers.
    result.lower[axis] = std::ldexp(box.lower[axis] - frame.center[axis], -frame.exponent);
    result.upper[axis] = std::ldexp(box.upper[axis] - frame.center[axis], -frame.exponent);
  }
  return result;
}

}  // namespace

void CellBuilder::place_leaves(NodeId node) {
  leaf_boxes_.resize(scene_.leaves().size());
  for (const Node& at : scene_.nodes()) {
    if (at.op == Node::Op::leaf) leaf_boxes_[at.first] = box_of_leaf(scene_.leaf(LeafId(at.first)), at.box);
  }
  data_.reaches_beyond = !scene_.node(node).box.is_finite();
  data_.is_empty = scene_.node(node).box.is_null();
  constexpr double side = 0.5;
  data_.box = {{-side, -side, -side}, {side, side, side}};
  if (!data_.reaches_beyond && !data_.is_empty) {
    const CellBox solid = axes_ ? turned_box_of(node) : in_frame(scene_.node(node).box, scene_.frame());
    const Vector more{beside, beside, beside};
    data_.box = {solid.lower - more, solid.upper + more};
  }
}

// Where the axes are turned, as tight as those of the half-spaces allow that boxes have sides along.
CellBox CellBuilder::box_of_leaf(const Leaf& leaf, const Box& world) const {
  const CellBox box = in_frame(world, scene_.frame());
  if (!axes_) return box;
  CellBox result = axes_->holding(box);
  constexpr double margin = 0x1p-31;
  const auto cut = [&](std::size_t axis, double low, double high) {
    result.lower[axis] = std::fmax(result.lower[axis], low - margin);
    result.upper[axis] = std::fmin(result.upper[axis], high + margin);
  };
  for (const HalfSpace& half_space : scene_.half_spaces(leaf)) {
    const LaneSurface& surface = data_.surfaces[half_space.surface.index()];
    const bool takes_negative = half_space.sense == Sense::negative;
    const LaneSurface::Kind kind = surface.kind;
    if (kind < LaneSurface::Kind::plane) {
      const bool is_upper = takes_negative == (surface.c[1] > 0);
      cut(axis_of(kind), is_upper ? -HUGE_VAL : surface.c[0], is_upper ? surface.c[0] : HUGE_VAL);
    }
    const bool is_round = kind == LaneSurface::Kind::sphere || is_axis_cylinder(kind);
    if (!is_round || takes_negative != (surface.c[5] > 0)) continue;
    const double radius = std::sqrt(surface.c[3]);
    Vector center{surface.c[0], surface.c[1], surface.c[2]};
    if (kind == LaneSurface::Kind::sphere) center = axes_->turned(center);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_axis_cylinder(kind) && axis == axis_of(kind)) continue;
      cut(axis, center[axis] - radius, center[axis] + radius);
    }
  }
  return result;
}

// The box of a node in turned axes, from those of its leaves. Children come before their parents.
CellBox CellBuilder::turned_box_of(NodeId node) const {
  std::vector<CellBox> boxes(node.index() + 1);
  for (std::uint32_t id = 0; id <= node.index(); ++id) {
    const Node& at = scene_.node(NodeId(id));
    if (at.box.is_null() || !at.box.is_finite()) continue;  // not asked for, below
    if (at.op == Node::Op::leaf) {
      boxes[id] = leaf_boxes_[at.first];
      continue;
    }
    CellBox box = axes_->holding(in_frame(at.box, scene_.frame()));
    const auto children = scene_.children(at);
    const auto bounds = [&](NodeId child) { return scene_.node(child).box.is_finite(); };
    const auto exists = [&](NodeId child) { return !scene_.node(child).box.is_null(); };
    if (at.op == Node::Op::unite && std::all_of(children.begin(), children.end(), bounds)) {
      CellBox all{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
      for (const NodeId child : children) {
        if (exists(child)) all = hull(all, boxes[child.index()]);
      }
      box = intersection(box, all);
    } else if (at.op == Node::Op::subtract && bounds(children.front())) {
      box = intersection(box, boxes[children.front().index()]);
    } else if (at.op == Node::Op::intersect) {
      for (const NodeId child : children) {
        if (bounds(child) && exists(child)) box = intersection(box, boxes[child.index()]);
      }
    }
    boxes[id] = box;
  }
  return boxes[node.index()];
}

}  // namespace csgcast::detail
