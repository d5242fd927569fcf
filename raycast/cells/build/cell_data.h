// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/cells/build/lane_surface.h"
#include "raycast/cells/formula/form_range.h"

namespace csgcast::detail {

/// The most by which events in a cell may be off: rays with less certain ones are left to the caster.
constexpr double greatest_slack = 0x1p-32;

/// Slack that covers every sphere, and cylinder along an axis, whose discriminant is above its threshold.
constexpr double round_slack = 0x1p-36;

/// Slack that covers other quadrics about an axis where they are certain.
constexpr double revolved_slack = 0x1p-33;

/// A node of the kd-tree: the child below the split follows it.
struct CellNode {
  static constexpr std::uint32_t no_axis = 3;

  double split = 0;         ///< of an end the bits of its cell's first slot
  std::uint32_t above = 0;  ///< the index of the other child; of an end its cell
  std::uint32_t axis = no_axis;

  bool is_end() const { return axis == no_axis; }
  /// Of an end: told before its cell is in the cache.
  std::uint64_t first_slot() const { return std::bit_cast<std::uint64_t>(split); }
  void set_first_slot(std::uint64_t slot) { split = std::bit_cast<double>(slot); }
};

/// A surface that crosses a cell, and the face that it makes there: a line of the cache, next to the cell's others.
struct alignas(64) Slot {
  Slot() = default;
  Slot(const LaneSurface& shape, SurfaceId id, LeafId owner, LookId face)
      : c(shape.c), surface(id.index()), leaf(owner.index()), look(face.index()), kind(shape.kind) {}

  std::array<double, 6> c{};  ///< as of a LaneSurface
  std::uint32_t surface = 0;
  std::uint32_t leaf = 0;  ///< the only one that owns the surface in the cell; not valid if there are more
  std::uint32_t look = 0;  ///< what every face on this surface shows in the cell; not valid if that depends
  LaneSurface::Kind kind = LaneSurface::Kind::undecided;
};

/// One step of the value of a formula over more surfaces than a table holds.
struct Step {
  enum class Op : std::uint8_t { leaf, unite, intersect, subtract, complement };
  Op op = Op::leaf;
  std::uint64_t mask = 0;  ///< of a leaf: the slots of its half-spaces
  std::uint64_t want = 0;  ///< and those whose positive side they take
};

/// A part of space with what the tree comes to there: bit i of a state says that slot i's surface is positive. Half a
/// line of the cache.
struct alignas(32) Cell {
  static constexpr unsigned table_slots = 6;  ///< up to these many `table` is the value by state
  static constexpr unsigned most_slots = 62;  ///< and beyond, `steps`; more cells hold none: `is_undecided`

  static constexpr std::size_t most_operands = 32;  ///< that the steps may have waiting
  static constexpr std::size_t most_steps = 0xfffe;

  std::uint64_t table = 0;
  Tolerance tolerance;  ///< of its surfaces
  std::uint32_t first_slot = 0;
  std::uint32_t first_step = 0;
  std::uint16_t step_count = 0;
  std::uint8_t slot_count = 0;
  std::uint8_t plane_count = 0;       ///< the first slots, whose surfaces a line crosses but once
  std::uint8_t axis_plane_count = 0;  ///< the first of these: square to an axis of the cells
  bool is_undecided = false;          ///< rays through it are left to the caster
  bool is_far = false;                ///< infinite, crossed by planes alone

  bool value() const { return (table & 1) != 0; }  ///< of a cell that no surface crosses
};
static_assert(sizeof(Cell) == 32);

/// By what lanes know how certain events with planes square to an axis of the cells are, and with cylinders along one
/// (docs/accuracy.md, "Lanes").
struct AxisBounds {
  double slack = 96 * 0x1p-53;   ///< of a plane, times the axis' part of the direction
  double guard = 128 * 0x1p-53;  ///< the distance from a plane below which its side is open
  double steep = 0x1p-14;        ///< below this the square of the part across an axis makes a ray go along it
  double off_axis = 0x1p-42;     ///< what a distance squared from an axis may be off, of rays along it
};

/// Eight boxes side by side, rounded outward. There is none where the lower side is above the upper one.
struct alignas(64) BoxNode {
  static constexpr std::size_t width = 8;
  // Bits of `child`. Without any of them the rest is a node.
  static constexpr std::uint32_t conjunction = 0x80000000u;  ///< the rest is the conjunction in the box
  static constexpr std::uint32_t ball = 0xc0000000u;        ///< both: the rest is the slot of a sphere, whose inside is
                                                            ///< the conjunction, and which no other one has
  static constexpr std::uint32_t subtracted = 0x20000000u;  ///< and this: what is in the sphere is
  static constexpr std::uint32_t most_slots = subtracted;

  float side[2][3][width];  ///< the lower ones, and the upper ones, by axis
  std::uint32_t child[width];
};

/// The side of a surface that a conjunction takes.
struct BoxedSide {
  std::uint32_t slot = 0;
  bool wants_positive = false;
  bool is_shared = false;  ///< other conjunctions have the surface, too
};

/// A leaf, or leaves that an intersection joins: sides [first, first + count).
struct Conjunction {
  static constexpr std::uint32_t no_brick = 0xffffffffu;

  std::uint32_t first = 0;
  std::uint32_t brick = no_brick;  ///< what it is, if it is one
  std::uint16_t count = 0;
  bool is_subtracted = false;
};

/// A conjunction of two planes square to each axis of the cells, which no other one has. The fourth numbers are out of
/// every line's way.
struct alignas(32) Brick {
  double lower[4];
  double upper[4];
  std::uint32_t lower_slot[3];
  std::uint32_t upper_slot[3];
};

/// A solid that is a union of conjunctions less others, in a hierarchy of boxes: what rays ask who want to know all
/// that they meet. A packet's lines gather the few conjunctions whose boxes they meet, and what the tree comes to along
/// them is that of one cell with these (docs/architecture.md).
struct BoxTree {
  std::vector<BoxNode> nodes;  ///< none: the solid is not like that, or cells are better
  std::vector<Conjunction> conjunctions;
  std::vector<BoxedSide> sides;
  std::vector<Brick> bricks;
  Tolerance tolerance;  ///< of all surfaces
};

/// Space in cells, in the frame's coordinates, turned.
struct CellData {
  bool is_turned = false;
  std::array<Vector, 3> axes{};  ///< of the cells, in the frame, if turned: unit, square to each other but for rounding
  AxisBounds axis_bounds;
  CellBox box{};          ///< beyond it there is nothing, unless `reaches_beyond`
  Point middle;           ///< of the solid's box, unless `reaches_beyond`; in the scene's coordinates, or, if turned,
                          ///< in its units along the axes, from the frame's center
  Vector half_size;       ///< of that box, more than it is off
  bool is_empty = false;  ///< there is nothing at all
  bool reaches_beyond = false;
  std::vector<CellNode> nodes;
  std::vector<Cell> cells;
  std::vector<Slot> slots;
  std::vector<Step> steps;
  double cost = 0;  ///< of a line through all its cells, in tests of a surface, as far as is expected; bounded ones
  BoxTree boxes;
  std::array<bool, 3> has_cylinders{};  ///< along each axis of the frame
  bool has_axis_planes = false;         ///< square to an axis
  bool has_quadrics = false;            ///< spheres and others
};

}  // namespace csgcast::detail
