// SPDX-License-Identifier: MIT
#include "tests/bench/peers/part_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "csg/exact/composition.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/simplify.h"

namespace csgcast::bench {
namespace {

using Kind = Solid::Kind;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("the other programs are not asked about " + what);
}

Point operator*(const Transform& m, Point p) {
  Point image;
  for (std::size_t row = 0; row < 3; ++row)
    image[row] = m(row, 0) * p.x + m(row, 1) * p.y + m(row, 2) * p.z + m(row, 3);
  return image;
}

// Whether it turns by quarters or mirrors, and moves: then each column of its linear part has one entry, 1 or -1.
bool permutes_axes(const Transform& m) {
  for (std::size_t column = 0; column < 3; ++column) {
    double sum = 0;
    for (std::size_t row = 0; row < 3; ++row) sum += std::fabs(m(row, column));
    const double largest = std::max({std::fabs(m(0, column)), std::fabs(m(1, column)), std::fabs(m(2, column))});
    if (sum != 1 || largest != 1) return false;
  }
  return true;
}

Frustum moved_frustum(Disc bottom, Disc top, const Transform& m) {
  std::size_t axis = 0;
  while (m(axis, 2) == 0) ++axis;
  if (m(axis, 2) < 0) std::swap(bottom, top);
  return {m * Point{0, 0, bottom.z}, axis, std::fabs(top.z - bottom.z), bottom.radius, top.radius};
}

Part moved_part(const LeafShape& shape, const Transform& m) {
  if (!permutes_axes(m)) refuse("solids turned by less than a quarter");
  if (shape.kind == LeafKind::sphere) return Ball{m * Point{}, shape.semi_axes->x};
  if (shape.kind == LeafKind::cylinder) return moved_frustum(shape.discs[0], shape.discs[1], m);
  if (shape.kind != LeafKind::cube) refuse(std::string("a ") + word(shape.kind));
  const Point a = m * shape.bounds.lower, b = m * shape.bounds.upper;
  return Brick{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
               {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

class Builder {
 public:
  // The node of a solid. The standard scenes are a few levels deep.
  std::uint32_t add(const Solid& solid, const Transform& world_from_solid) {
    switch (solid.kind()) {
      case Kind::transform:
        return add(solid.children()[0], world_from_solid * solid.transform());
      case Kind::part:
      case Kind::look:
        return add(solid.children()[0], world_from_solid);
      case Kind::unite:
        return add_operation(PartNode::Op::unite, solid, world_from_solid);
      case Kind::intersect:
        return add_operation(PartNode::Op::intersect, solid, world_from_solid);
      case Kind::subtract:
        return add_operation(PartNode::Op::subtract, solid, world_from_solid);
      case Kind::leaf:
        tree_.parts.push_back(moved_part(solid.shape(), world_from_solid));
        return add_node({PartNode::Op::part, static_cast<std::uint32_t>(tree_.parts.size() - 1), {}});
      default:
        refuse("complements, or solids that are empty or everything");
    }
  }

  PartTree take() { return std::move(tree_); }

 private:
  std::uint32_t add_operation(PartNode::Op op, const Solid& solid, const Transform& world_from_solid) {
    PartNode node{op, 0, {}};
    for (const Solid& child : solid.children()) node.children.push_back(add(child, world_from_solid));
    return add_node(std::move(node));
  }

  std::uint32_t add_node(PartNode node) {
    tree_.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }

  PartTree tree_;
};

Box bounds(const Ball& ball) {
  const Vector reach{ball.radius, ball.radius, ball.radius};
  return {ball.center - reach, ball.center + reach};
}

Box bounds(const Brick& brick) { return {brick.lower, brick.upper}; }

Box bounds(const Frustum& frustum) {
  const double radius = std::max(frustum.bottom_radius, frustum.top_radius);
  Vector reach{radius, radius, radius};
  reach[frustum.axis] = 0;
  Vector along;
  along[frustum.axis] = frustum.height;
  return {frustum.bottom - reach, frustum.bottom + along + reach};
}

}  // namespace

Box bounds_of(const Part& part) {
  return std::visit([](const auto& known) { return bounds(known); }, part);
}

bool PartTree::is_union_of_parts() const {
  return nodes.size() == 1 || (root().op == PartNode::Op::unite && nodes.size() == parts.size() + 1);
}

bool PartTree::is_union_of_balls() const {
  return is_union_of_parts() &&
         std::all_of(parts.begin(), parts.end(), [](const Part& part) { return std::holds_alternative<Ball>(part); });
}

PartTree part_tree(const Solid& solid) {
  Builder builder;
  builder.add(simplified(solid), {});
  return builder.take();
}

}  // namespace csgcast::bench
