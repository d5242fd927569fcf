// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
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

/// One instance of a leaf: the intersection of half-spaces [first, first + count) of the scene's table, or another
/// truth function of them.
struct Leaf {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  const LeafFunction* function = nullptr;  ///< null: the intersection. The scene owns it
  Place place;                             ///< the statement that made it
  RegionId region;
  PartId part;  ///< not valid outside every part
  LookId look;
  LeafKind kind = LeafKind::convex;
  bool holds_nothing = false;  ///< some operator subtracts it, so no medium is ever made of it
  /// It counts negatively and no look is set below the subtraction: its faces have the look of what was cut.
  bool shows_cut = false;
};

/// A Boolean node over children [first, first + count) of the scene's list of children; a leaf node has its LeafId in
/// `first`.
struct Node {
  enum class Op : std::uint8_t { empty, everything, leaf, unite, intersect, subtract, complement };
  Op op = Op::empty;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Box box;  ///< holds the closed set, with a margin; for culling only
};

/// What became of a statement that joins solids. Unions at the top of everything, or at the top of a part, have none:
/// they are dissolved. Its leaves are [first_leaf, leaf_end).
struct Operation {
  Node::Op op = Node::Op::unite;  ///< of the statement; if the result is empty its node may have another
  NodeId node;                    ///< if only one operand of a union is left: the node of that operand
  std::uint32_t first_leaf = 0;
  std::uint32_t leaf_end = 0;
  Place place;
};

struct Part {
  PartName name;
  Place place;
  NodeId node;
};

/// A run of solids above which there are only unions, next to each other in file order, of one part and of one look. It
/// counts as one medium.
struct Region {
  NodeId node;
  PartId part;             ///< not valid outside every part
  LookId look;             ///< that of each solid's first leaf that nothing subtracts; other leaves may have others
  bool transmits = false;  ///< some leaf that nothing subtracts lets light through
};

/// What a ray in a transparent medium tells apart: one transmitting region, or a run of opaque regions next to each
/// other. Layers are in file order.
struct Layer {
  NodeId node;
  RegionId region;  ///< the transmitting region; not valid for a run of opaque ones
};

/// A ray certainly goes to a side of the surface that it departs from if its cosine with the normal on that side is
/// above this. A cosine that is computed with the normal of a face there is off by far less (docs/accuracy.md, "Rays
/// that lead away").
constexpr double clear_departure = 0x1p-20;

/// What a scene is made of, as compile() fills it in. The id of a thing is its index in the table of its kind.
struct SceneTables {
  std::vector<Surface> surfaces;
  std::vector<HalfSpace> half_spaces;                          ///< leaf by leaf
  std::vector<Leaf> leaves;                                    ///< in file order
  std::vector<std::shared_ptr<const LeafFunction>> functions;  ///< those of the leaves
  std::vector<Node> nodes;                                     ///< operands before their operators
  std::vector<NodeId> children;                                ///< node by node
  std::vector<Operation> operations;
  std::vector<Part> parts;
  std::vector<Region> regions;
  std::vector<Layer> layers;
  std::vector<Material> looks;
  NodeId root;
  Box bounds;
  Box bounded_leaves;
  Frame frame;
  WeldReport weld_report;
};

/// A solid compiled for rays: flat, read-only arrays, safe to share between threads.
class Scene {
 public:
  /// A scene without even a root, only good to be assigned to.
  Scene() = default;
  /// Precondition: the tables are complete, as those that compile() makes.
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
  /// Operands before their operators, in file order otherwise.
  std::span<const Operation> operations() const { return tables_.operations; }
  /// The whole solid: a union of the regions.
  NodeId root() const { return tables_.root; }
  std::span<const Part> parts() const { return tables_.parts; }
  std::span<const Region> regions() const { return tables_.regions; }
  const Region& region(RegionId id) const { return tables_.regions[id.index()]; }
  /// Empty unless some region transmits.
  std::span<const Layer> layers() const { return tables_.layers; }
  bool transmits() const { return !tables_.layers.empty(); }
  /// Resolved materials, without repeats.
  std::span<const Material> looks() const { return tables_.looks; }
  const Material& look(LookId id) const { return tables_.looks[id.index()]; }
  /// The coordinates of the surfaces' floating-point forms.
  const Frame& frame() const { return tables_.frame; }
  /// The bounds of the solid, rounded outward, without the margin of the nodes' boxes.
  const Box& bounds() const { return tables_.bounds; }
  /// True if a ray that departs from the surface to that side, by more than clear_departure, meets nothing. Then the
  /// whole solid lies on the surface's other side, and no straight line that leaves the surface to this side comes
  /// back. False may mean that this was not seen.
  bool leads_away(SurfaceId surface, Sense side) const {
    return !leads_away_.empty() && ((leads_away_[surface.index()] >> static_cast<unsigned>(side)) & 1) != 0;
  }
  /// leads_away() of all surfaces, by index: a bit for each side, 1 << Sense. Empty if no side of any surface leads
  /// away.
  std::span<const std::uint8_t> sides_that_lead_away() const { return leads_away_; }
  const SceneTables& tables() const { return tables_; }
  const WeldReport& weld_report() const { return tables_.weld_report; }
  /// The bounds of the bounded leaves, for a default camera of an unbounded solid.
  const Box& bounded_leaves() const { return tables_.bounded_leaves; }

 private:
  SceneTables tables_;
  std::vector<LeafId> function_leaves_;
  std::vector<std::uint8_t> leads_away_;
};

/// Compiles a solid. The scene's exact answer is that of the solid as it is, or of the welded one if welding is asked
/// for. A solid that is handed over (a temporary, or moved) is given up before the surfaces are made, so the two never
/// take memory side by side.
///
/// Throws Error(limit) if exact composition of nested transforms needs numbers of more than 2^14 bits, or the tree has
/// more than 2^22 leaves, or a leaf is too large, too small or too far away (coordinates up to 2^400 and sizes from
/// 2^-400 work); Error(usage) for a part below an intersection, difference or complement, or within a part;
/// Error(bad_value) for a tolerance out of range.
Scene compile(Solid solid, const Welding& welding = {});

}  // namespace csgcast
