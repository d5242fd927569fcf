// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "csg/exact/affine.h"
#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/detail/weld/provenance.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// Flattens a solid into a scene in one iterative walk over its tree, in file order.
class SceneCompiler {
 public:
  explicit SceneCompiler(const Welding& welding) : welding_(welding) {}
  Scene compile(Solid solid);

 private:
  // What the nodes above a node mean for it.
  struct Context {
    std::shared_ptr<const ExactAffine> world_from_solid;  // null: the identity
    detail::Provenance::ChainId chain = 0;                // the same as the scene writes it; only for welding
    std::shared_ptr<const LookContext> looks;
    LookId look;
    PartId part;
    bool at_union_level = true;   // only unions, transforms, looks and parts above
    bool negative = false;        // an odd number of subtractions and complements above
    bool below_cut = false;       // any number of them but none
    bool look_below_cut = false;  // and a look between the outermost of them and here
  };
  struct Frame {
    Solid solid;
    Context context;           // of the node itself
    std::size_t results;       // where the children's nodes start in results_
    std::uint32_t first_leaf;  // the number of leaves when it was opened
    std::uint32_t next = 0;    // the child to visit next
  };
  // A solid at union level, before such solids are gathered into regions.
  struct Body {
    NodeId node;
    PartId part;
    LookId look;
    std::uint32_t first_leaf;
    std::uint32_t leaf_end;
    bool transmits;
  };

  // What sorting the children of a wide union takes, side by side.
  struct UnionChild {
    NodeId node;
    Point middle;
  };

  void visit(const Solid& solid, const Context& context);
  void close();
  void deliver(NodeId node, const Context& context, std::uint32_t first_leaf);
  Context child_context(const Frame& frame);
  void add_body(NodeId node, const Context& context, std::uint32_t first_leaf);
  NodeId add_leaf(const Solid& solid, const Context& context);
  bool add_half_spaces(const Solid& solid, const Context& context, Leaf& leaf, const Box& box);
  NodeId add_node(Node::Op op, std::span<const NodeId> children);
  NodeId add_union(std::vector<NodeId> children);
  NodeId add_hierarchy(std::span<UnionChild> children);
  static std::size_t longest_axis(std::span<const UnionChild> children);
  NodeId add_subtract(std::span<const NodeId> children);
  Box box_of(Node::Op op, std::span<const NodeId> children) const;
  LookId look_id(const LookContext& looks);
  PartId add_part(const Solid& solid, const Context& context);
  void gather_regions();
  void gather_parts();
  void gather_layers();
  void flatten(const Solid& solid);
  void weld();
  void replace_surfaces(std::span<const HalfSpace> positive_side);
  void widen_boxes();

  Welding welding_;
  detail::Provenance provenance_;
  // That a leaf owns a surface, in the order of the leaves; only for welding.
  struct Ownership {
    SurfaceId surface;
    detail::Provenance::Source source;
  };
  std::vector<Ownership> ownerships_;
  Scene scene_;
  detail::SurfaceTable surfaces_;
  std::vector<Frame> frames_;
  std::vector<NodeId> results_;
  std::vector<Body> bodies_;
  std::map<std::vector<double>, LookId> look_ids_;
};

}  // namespace csgcast
