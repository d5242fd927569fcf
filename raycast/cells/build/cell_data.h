// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/cells/build/lane_surface.h"
#include "raycast/surface/form_range.h"

namespace csgcast::detail {

/// Events in a cell may be off by this much at most. Rays with less certain events are left to the caster.
constexpr double greatest_slack = 0x1p-32;

/// This slack covers the events of every sphere, and of every cylinder along an axis, whose discriminant is above its
/// threshold.
constexpr double round_slack = 0x1p-36;

/// This slack covers the certain events of other quadrics about an axis.
constexpr double revolved_slack = 0x1p-33;

/// A node of the kd-tree. It is a split, which the child below it follows in the list of nodes, or an end.
struct CellNode {
  static constexpr std::uint32_t no_axis = 3;

  double split = 0;              ///< the place of a split on its axis; in an end, the bits of its cell's first slot
  std::uint32_t above = 0;       ///< the index of a split's child above it; in an end, the index of its cell
  std::uint32_t axis = no_axis;  ///< the axis of a split; `no_axis` in an end

  bool is_end() const { return axis == no_axis; }
  /// The first slot of an end's cell: it is known here before the cell is in the cache.
  std::uint64_t first_slot() const { return std::bit_cast<std::uint64_t>(split); }
  void set_first_slot(std::uint64_t slot) { split = std::bit_cast<double>(slot); }
};

/// A surface that crosses a cell, and the face that it makes there. A slot fills a line of the cache, and lies next to
/// the other slots of its cell.
struct alignas(64) Slot {
  Slot() = default;
  Slot(const LaneSurface& shape, SurfaceId id, LeafId owner, LookId face)
      : c(shape.c), surface(id.index()), leaf(owner.index()), look(face.index()), kind(shape.kind) {}

  std::array<double, 6> c{};  ///< the numbers of the LaneSurface
  std::uint32_t surface = 0;  ///< SurfaceId
  std::uint32_t leaf = 0;  ///< LeafId of the only leaf that owns the surface in the cell; not valid if there are more
  std::uint32_t look = 0;  ///< LookId that every face on the surface shows in the cell; not valid if that depends
  LaneSurface::Kind kind = LaneSurface::Kind::undecided;
};

/// One step of computing a formula over more surfaces than a table holds. Steps are in postfix order: a leaf brings a
/// value, an operator joins the last two (`complement` changes the last one).
struct Step {
  enum class Op : std::uint8_t { leaf, unite, intersect, subtract, complement };
  Op op = Op::leaf;
  std::uint64_t mask = 0;  ///< a leaf's half-spaces: a bit for the slot of each
  std::uint64_t want = 0;  ///< the bits of those that are the positive side of their surface
};

/// A part of space with what the solid comes to there, as a function of the state of the surfaces that cross it: bit i
/// of a state says that the surface of the i-th slot is positive. Slots with planes come first. A cell fills half a
/// line of the cache.
struct alignas(32) Cell {
  static constexpr unsigned table_slots = 6;  ///< with up to this many slots `table` has the value of each state
  static constexpr unsigned most_slots = 62;  ///< with up to this many there are steps; a cell with more `is_undecided`

  static constexpr std::size_t most_operands = 32;  ///< steps leave at most this many values waiting to be joined
  static constexpr std::size_t most_steps = 0xfffe;

  std::uint64_t table = 0;  ///< a bit for each state, unless there are steps
  Tolerance tolerance;      ///< what the events of the cell's surfaces need
  std::uint32_t first_slot = 0;
  std::uint32_t first_step = 0;
  std::uint16_t step_count = 0;
  std::uint8_t slot_count = 0;
  std::uint8_t plane_count = 0;       ///< this many of the first slots are planes: a line crosses each but once
  std::uint8_t axis_plane_count = 0;  ///< this many of the first planes are square to an axis of the cells
  bool is_undecided = false;          ///< rays through the cell are left to the caster
  bool is_far = false;                ///< the cell is infinite, and only planes cross it

  /// The value of a cell that no surface crosses.
  bool value() const { return (table & 1) != 0; }
};
static_assert(sizeof(Cell) == 32);

/// Bounds by which lanes know how certain an event with a plane square to an axis of the cells is, or with a cylinder
/// along an axis (docs/accuracy.md, "Lanes").
struct AxisBounds {
  double slack = 96 * 0x1p-53;   ///< what an event with a plane is off, times the direction's part along the axis
  double guard = 128 * 0x1p-53;  ///< a point closer to a plane than this is on neither side for certain
  double steep = 0x1p-14;        ///< a ray goes along an axis if the square of its part across it is below this
  double off_axis = 0x1p-42;     ///< what the squared distance of a ray along an axis from it may be off
};

/// Eight boxes side by side, rounded outward. A place is vacant if its lower side is above the upper one.
struct alignas(64) BoxNode {
  static constexpr std::size_t width = 8;
  // The highest bits of a child say what its other bits are: without any of these, the index of a node below.
  static constexpr std::uint32_t conjunction = 0x80000000u;  ///< the index of the conjunction in the box
  static constexpr std::uint32_t ball = 0xc0000000u;  ///< the slot of a sphere: the conjunction is its inside, and
                                                      ///< no other conjunction has the sphere
  static constexpr std::uint32_t subtracted = 0x20000000u;  ///< a ball has this bit, too, if it is subtracted
  static constexpr std::uint32_t most_slots = subtracted;   ///< only slots below this can be told by a child

  float side[2][3][width];  ///< by lower (0) or upper (1), axis and place
  std::uint32_t child[width];
};

/// The side of a surface that a conjunction takes.
struct BoxedSide {
  std::uint32_t slot = 0;
  bool wants_positive = false;
  bool is_shared = false;  ///< other conjunctions have the surface, too
};

/// A leaf, or leaves that an intersection joins: it holds where its sides [first, first + count) do.
struct Conjunction {
  static constexpr std::uint32_t no_brick = 0xffffffffu;

  std::uint32_t first = 0;
  std::uint32_t brick = no_brick;  ///< the index of the brick that the conjunction is, if it is one
  std::uint16_t count = 0;
  bool is_subtracted = false;
};

/// A conjunction of two planes square to each axis of the cells, which no other conjunction has. The fourth numbers
/// fill a lane, and are out of every line's way.
struct alignas(32) Brick {
  double lower[4];
  double upper[4];
  std::uint32_t lower_slot[3];
  std::uint32_t upper_slot[3];
};

/// A solid that is a union of conjunctions less others, in a hierarchy of boxes. Rays that want to know all that they
/// meet ask it: a packet's lines gather the few conjunctions whose boxes they meet, and take them for the content of
/// one cell (docs/cells.md).
struct BoxTree {
  std::vector<BoxNode> nodes;  ///< the root first; none if the solid is not such a union, or cells are better
  std::vector<Conjunction> conjunctions;
  std::vector<BoxedSide> sides;
  std::vector<Brick> bricks;
  Tolerance tolerance;  ///< what the events of all its surfaces need
};

/// The space of a solid in cells, in the frame's coordinates, which may be turned.
struct CellData {
  bool is_turned = false;        ///< false: the axes of the cells are the frame's
  std::array<Vector, 3> axes{};  ///< if turned, the axes in the frame: unit, square to each other but for rounding
  AxisBounds axis_bounds;
  CellBox box{};                ///< there is nothing beyond it, unless the solid `reaches_beyond`
  Point middle;                 ///< the middle of the solid's box, unless it `reaches_beyond`: in the scene's
                                ///< coordinates or, if turned, in its units along the axes from the frame's center
  Vector half_size;             ///< half the sides of that box, and more than rounding takes from them
  bool is_empty = false;        ///< there is nothing at all
  bool reaches_beyond = false;  ///< the solid is unbounded: cells fill all of space
  std::vector<CellNode> nodes;  ///< the root first
  std::vector<Cell> cells;      ///< the first two are the constants false and true
  std::vector<Slot> slots;
  std::vector<Step> steps;
  double cost = 0;  ///< what a line through all cells of a bounded solid is expected to cost, in tests of a surface
  BoxTree boxes;
  std::array<bool, 3> has_cylinders{};  ///< by axis of the cells: some surface is a cylinder along it
  bool has_axis_planes = false;         ///< some surface is a plane square to an axis of the cells
  bool has_quadrics = false;            ///< some surface is not a plane
};

}  // namespace csgcast::detail
