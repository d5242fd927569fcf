// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/ids.h"
#include "csg/solid/bounds.h"
#include "csg/solid/look.h"
#include "csg/solid/solid.h"
#include "raycast/line/crossing.h"
#include "raycast/scene/welding.h"
#include "raycast/surface/surface.h"

namespace csgcast {

/// The closed set on one side of a surface.
struct HalfSpace {
  SurfaceId surface;
  Sense sense = Sense::negative;
};

/// One instance of a leaf: half-spaces [first, first + count) of the scene's table.
struct Leaf {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  Place place;  ///< the statement that made it
  RegionId region;
  PartId part;  ///< not valid outside every part
  LookId look;
  LeafKind kind = LeafKind::convex;
  bool holds_nothing = false;  ///< some operator subtracts it: it is never what a medium is made of
  bool shows_cut =
      false;  ///< it counts negatively and no look is set below the subtraction: its faces show what was cut
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

/// What became of a statement that joins solids, unless it is a union at the top of all, or of a part: those are
/// dissolved. Its leaves are [first_leaf, leaf_end).
struct Operation {
  Node::Op op = Node::Op::unite;  ///< that of the statement; that of its node where it is empty may be another
  NodeId node;                    ///< if only one operand of a union is left: that operand's
  std::uint32_t first_leaf = 0;
  std::uint32_t leaf_end = 0;
  Place place;
};

struct Part {
  PartName name;
  Place place;
  NodeId node;
};

/// A run of union-level solids, next to each other in file order, of one part and under one look: what counts as one
/// medium.
struct Region {
  NodeId node;
  PartId part;
  LookId look;             ///< what the statements above the solids say; leaves may say otherwise
  bool transmits = false;  ///< some leaf that is not cut away lets light through
};

/// What a ray in a transparent medium tells apart, in file order: each transmitting region by itself, and opaque
/// regions next to each other together.
struct Layer {
  NodeId node;
  RegionId region;  ///< the transmitting region; not valid for opaque ones
};

/// The cosine between a ray and the normal of the surface that it departs from, on its side, above which it is certain
/// that the ray goes to that side: computed with the normal of a face there, it is off by far less (docs/accuracy.md,
/// "Rays that lead away").
constexpr double clear_departure = 0x1p-20;

/// A solid compiled for rays: flat, read-only arrays, safe to share between threads.
class Scene {
 public:
  std::span<const Surface> surfaces() const { return surfaces_; }
  const Surface& surface(SurfaceId id) const { return surfaces_[id.index()]; }
  std::span<const Leaf> leaves() const { return leaves_; }
  const Leaf& leaf(LeafId id) const { return leaves_[id.index()]; }
  std::span<const HalfSpace> half_spaces(const Leaf& leaf) const {
    return std::span(half_spaces_).subspan(leaf.first, leaf.count);
  }
  std::span<const Node> nodes() const { return nodes_; }
  const Node& node(NodeId id) const { return nodes_[id.index()]; }
  std::span<const NodeId> children(const Node& node) const {
    return std::span(children_).subspan(node.first, node.count);
  }
  /// Operands before their operators, in file order otherwise.
  std::span<const Operation> operations() const { return operations_; }
  /// The whole solid: a union of the regions.
  NodeId root() const { return root_; }
  std::span<const Part> parts() const { return parts_; }
  std::span<const Region> regions() const { return regions_; }
  const Region& region(RegionId id) const { return regions_[id.index()]; }
  /// Empty unless some region transmits.
  std::span<const Layer> layers() const { return layers_; }
  bool transmits() const { return !layers_.empty(); }
  /// Resolved materials, without repeats.
  std::span<const Material> looks() const { return looks_; }
  const Material& look(LookId id) const { return looks_[id.index()]; }
  /// The coordinates of the surfaces' floating-point forms.
  const Frame& frame() const { return frame_; }
  /// Of the solid, rounded outward, without the margin of the nodes' boxes.
  const Box& bounds() const { return bounds_; }
  /// Whether the whole solid lies on the surface's other side, and a straight line that leaves the surface to this one
  /// does not come back: rays that depart to it by more than clear_departure meet nothing. Exact where it is true;
  /// false where that is not seen.
  bool leads_away(SurfaceId surface, Sense side) const {
    return !leads_away_.empty() && ((leads_away_[surface.index()] >> static_cast<unsigned>(side)) & 1) != 0;
  }
  /// The same of all surfaces, by index: a bit for each side, 1 << Sense. Empty if no side of any leads away.
  std::span<const std::uint8_t> sides_that_lead_away() const { return leads_away_; }
  const WeldReport& weld_report() const { return weld_report_; }
  /// Of its bounded leaves, for a default camera of an unbounded solid.
  const Box& bounded_leaves() const { return bounded_leaves_; }

 private:
  friend class SceneCompiler;
  std::vector<Surface> surfaces_;
  std::vector<HalfSpace> half_spaces_;
  std::vector<Leaf> leaves_;
  std::vector<Node> nodes_;
  std::vector<NodeId> children_;
  std::vector<Operation> operations_;
  std::vector<Part> parts_;
  std::vector<Region> regions_;
  std::vector<Layer> layers_;
  std::vector<Material> looks_;
  std::vector<std::uint8_t> leads_away_;
  NodeId root_;
  Box bounds_;
  Box bounded_leaves_;
  Frame frame_;
  WeldReport weld_report_;
};

/// The exact answer is that of the solid as it is, or of the welded one if welding is asked for. A solid that is handed
/// over (a temporary, or moved) is given up before the surfaces are made, so the two never take memory side by side.
///
/// Throws Error(limit) if exact composition of nested transforms needs numbers of more than 2^14 bits, or the tree has
/// more than 2^22 leaves; Error(usage) for a part below an intersection, difference or complement, or within a part;
/// Error(bad_value) for a tolerance out of range.
Scene compile(Solid solid, const Welding& welding = {});

}  // namespace csgcast
