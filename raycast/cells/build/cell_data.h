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

/// A node of the kd-tree. It is an end or a split. A split is followed by its lower child in the list of nodes.
struct CellNode {
  static constexpr std::uint32_t no_axis = 3;

  double split = 0;              ///< the place of a split on its axis; in an end, the bits of its cell's first slot
  std::uint32_t above = 0;       ///< the index of a split's child above it; in an end, the index of its cell
  std::uint32_t axis = no_axis;  ///< the axis of a split; `no_axis` in an end

  bool is_end() const { return axis == no_axis; }
  /// The first slot of an end's cell. It is stored here so that it is known before the cell is in the cache.
  std::uint64_t first_slot() const { return std::bit_cast<std::uint64_t>(split); }
  void set_first_slot(std::uint64_t slot) { split = std::bit_cast<double>(slot); }
};

/// A surface that crosses a cell, and the face that it makes there. A slot fills a line of the cache. The slots of a
/// cell lie next to each other.
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

/// One step of the evaluation of a formula over more surfaces than a table holds. Steps are in postfix order. A leaf
/// pushes a value; an operator joins the last two values (`complement` changes the last one).
struct Step {
  enum class Op : std::uint8_t { leaf, unite, intersect, subtract, complement };
  Op op = Op::leaf;
  std::uint64_t mask = 0;  ///< for a leaf, the bits of the slots of its half-spaces
  std::uint64_t want = 0;  ///< the bits of those half-spaces that are the positive side of their surface
};

/// A part of space with the solid's value in it, as a function of the state of the surfaces that cross it. Bit i of a
/// state says that the surface of the i-th slot is positive. Slots with planes come first. A cell fills half a line of
/// the cache.
struct alignas(32) Cell {
  static constexpr unsigned table_slots = 6;  ///< up to this many slots, `table` has the value of each state
  static constexpr unsigned most_slots = 62;  ///< up to this many slots, there are steps; with more `is_undecided`

  static constexpr std::size_t most_operands = 32;  ///< at most this many values wait to be joined
  static constexpr std::size_t most_steps = 0xfffe;

  std::uint64_t table = 0;  ///< one bit for each state; unused if there are steps
  Tolerance tolerance;      ///< the tolerance that the events of the cell's surfaces need
  std::uint32_t first_slot = 0;
  std::uint32_t first_step = 0;
  std::uint16_t step_count = 0;
  std::uint8_t slot_count = 0;
  std::uint8_t plane_count = 0;       ///< this many of the first slots are planes; a line crosses each only once
  std::uint8_t axis_plane_count = 0;  ///< this many of the first planes are square to an axis of the cells
  bool is_undecided = false;          ///< rays through the cell are left to the caster
  bool is_far = false;                ///< the cell is infinite, and only planes cross it

  /// The value of a cell that no surface crosses.
  bool value() const { return (table & 1) != 0; }
};
static_assert(sizeof(Cell) == 32);

/// Bounds from which lanes know how certain an event is, with a plane square to an axis of the cells or with a cylinder
/// along an axis (docs/accuracy.md, "Lanes").
struct AxisBounds {
  double slack = 96 * 0x1p-53;   ///< error of an event with a plane, times the direction's component along the axis
  double guard = 128 * 0x1p-53;  ///< a point closer to a plane than this is not certain to be on either side
  double steep = 0x1p-14;        ///< a ray goes along an axis if the square of its part across it is below this
  double off_axis = 0x1p-42;     ///< error of the squared distance between an axis and a ray along it
};

/// Eight boxes side by side, rounded outward. If a place is vacant, its lower side is above the upper one.
struct alignas(64) BoxNode {
  static constexpr std::size_t width = 8;
  // The highest bits of a child say what its other bits are. Without any of these bits it is the index of a node below.
  static constexpr std::uint32_t conjunction = 0x80000000u;  ///< the index of the conjunction in the box
  static constexpr std::uint32_t ball = 0xc0000000u;  ///< the slot of a sphere: the conjunction is its inside, and
                                                      ///< no other conjunction has the sphere
  static constexpr std::uint32_t subtracted = 0x20000000u;  ///< this bit is also set for a ball that is subtracted
  static constexpr std::uint32_t most_slots = subtracted;   ///< a child can hold only slots below this

  float side[2][3][width];  ///< by lower (0) or upper (1), axis and place
  std::uint32_t child[width];
};

/// The side of a surface that a conjunction takes.
struct BoxedSide {
  std::uint32_t slot = 0;
  bool wants_positive = false;
  bool is_shared = false;  ///< other conjunctions have the surface, too
};

/// A leaf, or the intersection of several leaves. It holds where all its sides [first, first + count) do.
struct Conjunction {
  static constexpr std::uint32_t no_brick = 0xffffffffu;

  std::uint32_t first = 0;
  std::uint32_t brick = no_brick;  ///< the index of its brick, if the conjunction is a brick
  std::uint16_t count = 0;
  bool is_subtracted = false;
};

/// A conjunction of two planes square to each axis of the cells. No other conjunction has these planes. The fourth
/// numbers fill a lane, and no line meets them.
struct alignas(32) Brick {
  double lower[4];
  double upper[4];
  std::uint32_t lower_slot[3];
  std::uint32_t upper_slot[3];
};

/// A solid that is a union of conjunctions less others, in a hierarchy of boxes. It serves rays that ask for everything
/// they meet. A packet's lines gather the few conjunctions whose boxes they meet, and treat them as the content of one
/// cell (docs/cells.md).
struct BoxTree {
  std::vector<BoxNode> nodes;  ///< the root first; empty if the solid is not such a union, or cells are faster
  std::vector<Conjunction> conjunctions;
  std::vector<BoxedSide> sides;
  std::vector<Brick> bricks;
  Tolerance tolerance;  ///< the tolerance that the events of all its surfaces need
};

/// The space of a solid in cells, in the frame's coordinates, which may be turned.
struct CellData {
  bool is_turned = false;        ///< true if the axes of the cells are not the frame's
  std::array<Vector, 3> axes{};  ///< if turned, the axes in the frame: unit, and square to each other up to rounding
  AxisBounds axis_bounds;
  CellBox box{};                ///< the solid has nothing beyond it, unless the solid `reaches_beyond`
  Point middle;                 ///< the middle of the solid's box, unless it `reaches_beyond`: in the scene's
                                ///< coordinates or, if turned, in its units along the axes from the frame's center
  Vector half_size;             ///< half the sides of that box, with room for more than rounding
  bool is_empty = false;        ///< true if the solid has nothing at all
  bool reaches_beyond = false;  ///< true if the solid is unbounded; then cells fill all of space
  std::vector<CellNode> nodes;  ///< the root first
  std::vector<Cell> cells;      ///< the first two are the constants false and true
  std::vector<Slot> slots;
  std::vector<Step> steps;
  double cost = 0;  ///< the expected cost of a line through all cells of a bounded solid, in tests of a surface
  BoxTree boxes;
  std::array<bool, 3> has_cylinders{};  ///< by axis of the cells: true if some surface is a cylinder along it
  bool has_axis_planes = false;         ///< true if some surface is a plane square to an axis of the cells
  bool has_quadrics = false;            ///< true if some surface is not a plane
};

}  // namespace csgcast::detail
