// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/ids.h"
#include "csg/solid/bounds.h"
#include "csg/solid/look.h"
#include "csg/solid/solid.h"
#include "raycast/line/crossing.h"
#include "raycast/surface/surface.h"
#include "raycast/weld/welding.h"

namespace csgcast {

/// The closed set on one side of a surface.
struct HalfSpace {
  SurfaceId surface;
  Sense sense = Sense::negative;
};

class LeafFunction;

/// One instance of a leaf. It is the intersection of the half-spaces [first, first + count) in the scene's table, or
/// another truth function of them.
struct Leaf {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  const LeafFunction* function = nullptr;  ///< null for the intersection; owned by the scene
  Place place;                             ///< the statement that made the leaf
  RegionId region;
  PartId part;  ///< not valid outside every part
  LookId look;
  LeafKind kind = LeafKind::convex;
  bool holds_nothing = false;  ///< true if some operator subtracts the leaf; then no medium is ever made of it
  /// True if the leaf counts negatively and no look is set below the subtraction. Then its faces have the look of the
  /// solid that was cut.
  bool shows_cut = false;
};

/// A Boolean node over the children [first, first + count) in the scene's list of children. A leaf node has its LeafId
/// in `first`.
struct Node {
  enum class Op : std::uint8_t { empty, everything, leaf, unite, intersect, subtract, complement };
  Op op = Op::empty;
  /// True if the node is bounded though its leaves are not. What its list has outside the frame's cube is cut out:
  /// crossings of local surfaces may be missing there.
  bool is_cut = false;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Box box;  ///< holds the closed set, with a margin; used for culling only
};

/// The result of a statement that joins solids. It has the leaves [first_leaf, leaf_end). Unions at the top of
/// everything, or at the top of a part, are dissolved, so they have no entry.
struct Operation {
  Node::Op op = Node::Op::unite;  ///< the statement's operator; the node of an empty result may have another one
  NodeId node;                    ///< if only one operand of a union is left, the node of that operand
  std::uint32_t first_leaf = 0;
  std::uint32_t leaf_end = 0;
  Place place;
};

struct Part {
  PartName name;
  Place place;
  NodeId node;
};

/// A run of solids, next to each other in file order, with only unions above them, the same part and the same look. It
/// counts as one medium.
struct Region {
  NodeId node;
  PartId part;  ///< not valid outside every part
  LookId look;  ///< the look of each solid's first leaf that nothing subtracts; other leaves may have other looks
  bool transmits = false;  ///< true if some leaf that nothing subtracts lets light through
};

/// A unit that a ray in a transparent medium distinguishes: one transmitting region, or a run of opaque regions next to
/// each other. Layers are in file order.
struct Layer {
  NodeId node;
  RegionId region;  ///< the transmitting region; not valid for a run of opaque regions
};

/// Where a solid reaches to infinity, or may.
struct Opening {
  Vector direction{};       ///< the longest coordinate is 1 or -1; 0 if nothing is known
  bool is_certain = false;  ///< false: it is not known that the solid is bounded there
  Place place;              ///< of the first leaf of the part of the solid that does
};

/// A ray certainly goes to one side of the surface that it departs from, if its cosine with the normal on that side is
/// above this number. The error of a cosine that is computed with a face's normal is far smaller (docs/accuracy.md,
/// "Rays that lead away").
constexpr double clear_departure = 0x1p-20;

/// The tables of a scene, as compile() fills them in. The id of a thing is its index in the table of its kind.
struct SceneTables {
  std::vector<Surface> surfaces;
  std::vector<HalfSpace> half_spaces;                          ///< in the order of the leaves
  std::vector<Leaf> leaves;                                    ///< in file order
  std::vector<std::shared_ptr<const LeafFunction>> functions;  ///< the functions of the leaves
  std::vector<Node> nodes;                                     ///< operands before their operators
  std::vector<NodeId> children;                                ///< in the order of the nodes
  std::vector<Operation> operations;
  std::vector<Part> parts;
  std::vector<Region> regions;
  std::vector<Layer> layers;
  std::vector<Material> looks;
  NodeId root;
  Box bounds;
  Box bounded_leaves;  ///< holds solids at union level that are bounded, too, though their leaves are not
  std::optional<Opening> opening;
  Frame frame;
  WeldReport weld_report;
};

/// A solid compiled for rays: flat, read-only arrays, safe to share between threads.
class Scene {
 public:
  /// An empty object without a root. It can only be assigned to.
  Scene() = default;
  /// Precondition: the tables are complete, like those of compile().
  explicit Scene(SceneTables tables);

  std::span<const Surface> surfaces() const { return tables_.surfaces; }
  const Surface& surface(SurfaceId id) const { return tables_.surfaces[id.index()]; }
  std::span<const Leaf> leaves() const { return tables_.leaves; }
  const Leaf& leaf(LeafId id) const { return tables_.leaves[id.index()]; }
  /// The leaves with a truth function of their own, in file order.
  std::span<const LeafId> function_leaves() const { return function_leaves_; }
  std::span<const HalfSpace> half_spaces(const Leaf& leaf) const {
    return std::span(tables_.half_spaces).subspan(leaf.first, leaf.count);
  }
  std::span<const Node> nodes() const { return tables_.nodes; }
  const Node& node(NodeId id) const { return tables_.nodes[id.index()]; }
  std::span<const NodeId> children(const Node& node) const {
    return std::span(tables_.children).subspan(node.first, node.count);
  }
  /// The results of statements, operands before their operators, otherwise in file order.
  std::span<const Operation> operations() const { return tables_.operations; }
  /// The whole solid: a union of the regions.
  NodeId root() const { return tables_.root; }
  std::span<const Part> parts() const { return tables_.parts; }
  std::span<const Region> regions() const { return tables_.regions; }
  const Region& region(RegionId id) const { return tables_.regions[id.index()]; }
  /// The layers. The list is empty unless some region transmits.
  std::span<const Layer> layers() const { return tables_.layers; }
  bool transmits() const { return !tables_.layers.empty(); }
  /// The resolved materials, without repeats.
  std::span<const Material> looks() const { return tables_.looks; }
  const Material& look(LookId id) const { return tables_.looks[id.index()]; }
  /// The coordinates of the surfaces' floating-point forms.
  const Frame& frame() const { return tables_.frame; }
  /// The bounds of the solid, rounded outward, without the margin of the nodes' boxes.
  const Box& bounds() const { return tables_.bounds; }
  /// True if a ray meets nothing when it departs from the surface to that side with a cosine above clear_departure. In
  /// that case the whole solid lies on the surface's other side, and no straight line that leaves the surface to this
  /// side comes back. False may also mean that this was not noticed.
  bool leads_away(SurfaceId surface, Sense side) const {
    return !leads_away_.empty() && ((leads_away_[surface.index()] >> static_cast<unsigned>(side)) & 1) != 0;
  }
  /// leads_away() of all surfaces, by index, with a bit for each side, 1 << Sense. The list is empty if no side of any
  /// surface leads away.
  std::span<const std::uint8_t> sides_that_lead_away() const { return leads_away_; }
  const SceneTables& tables() const { return tables_; }
  const WeldReport& weld_report() const { return tables_.weld_report; }
  /// The bounds of all bounded leaves, and of solids at union level that are bounded: for a default camera of an
  /// unbounded solid.
  const Box& bounded_leaves() const { return tables_.bounded_leaves; }
  /// Where the solid is open; nothing if its bounds are finite.
  const std::optional<Opening>& opening() const { return tables_.opening; }

 private:
  SceneTables tables_;
  std::vector<LeafId> function_leaves_;
  std::vector<std::uint8_t> leads_away_;
};

/// Compiles a solid. The scene's exact answer is that of the solid as it is, or of the welded solid if welding is asked
/// for. If the solid is handed over (a temporary, or moved), it is freed before the surfaces are made, so memory never
/// holds both.
///
/// Throws Error(limit) if exact composition of nested transforms needs numbers of more than 2^14 bits, or the tree has
/// more than 2^22 leaves, or a leaf is too large, too small or too far away (coordinates up to 2^400 and sizes from
/// 2^-400 work); Error(usage) for a part below an intersection, difference or complement, or within a part;
/// Error(bad_value) for a tolerance out of range.
Scene compile(Solid solid, const Welding& welding = {});

}  // namespace csgcast
