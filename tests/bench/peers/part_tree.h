// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/vector.h"
#include "csg/solid/solid.h"

namespace csgcast::bench {

struct Ball {
  Point center;
  double radius = 0;
};

struct Brick {
  Point lower;
  Point upper;
};

/// A cylinder or a truncated cone, from the centre of its bottom along +axis.
struct Frustum {
  Point bottom;
  std::size_t axis = 2;
  double height = 0;
  double bottom_radius = 0;
  double top_radius = 0;
};

using Part = std::variant<Ball, Brick, Frustum>;

Box bounds_of(const Part& part);

struct PartNode {
  enum class Op : std::uint8_t { part, unite, intersect, subtract };
  Op op = Op::part;
  std::uint32_t part = 0;               ///< of Op::part: an index into PartTree::parts
  std::vector<std::uint32_t> children;  ///< of the others: two or more nodes; subtract: the first less all others
};

/// A solid as programs know it that have no exact numbers: parts in world coordinates, as doubles, and a tree of them.
struct PartTree {
  std::vector<PartNode> nodes;  ///< children before their parents; the last one is the root
  std::vector<Part> parts;

  const PartNode& root() const { return nodes.back(); }
  /// Whether the solid is one part, or a union of parts and no more.
  bool is_union_of_parts() const;
  bool is_union_of_balls() const;
};

/// Of a solid of cubes, spheres and cylinders, moved and turned by quarters. Throws std::runtime_error for any other.
PartTree part_tree(const Solid& solid);

}  // namespace csgcast::bench
