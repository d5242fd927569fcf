// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/flattener.h"

#include <map>
#include <memory>
#include <span>
#include <utility>

#include "raycast/scene/detail/leaf_builder.h"
#include "raycast/scene/detail/node_builder.h"

namespace csgcast::detail {
namespace {

constexpr std::size_t most_bits = std::size_t{1} << 14;

Node::Op operation_of(Solid::Kind kind) {
  switch (kind) {
    case Solid::Kind::intersect:
      return Node::Op::intersect;
    case Solid::Kind::subtract:
      return Node::Op::subtract;
    case Solid::Kind::complement:
      return Node::Op::complement;
    default:
      return Node::Op::unite;
  }
}

// The looks of a scene. Each is resolved and listed once.
class LookTable {
 public:
  explicit LookTable(std::vector<Material>& looks) : looks_(looks) {}

  LookId id(const LookContext& context) {
    const Material material = context.resolve();
    const auto [it, is_new] = ids_.try_emplace(key(material), LookId(static_cast<std::uint32_t>(looks_.size())));
    if (is_new) looks_.push_back(material);
    return it->second;
  }

 private:
  static std::vector<double> key(const Material& m) {
    return {m.color.r,    m.color.g,      m.color.b,      m.ambient,     m.diffuse,    m.specular,
            m.shininess,  m.reflection,   m.transmission, m.ior,         m.emission.r, m.emission.g,
            m.emission.b, m.absorption.r, m.absorption.g, m.absorption.b};
  }

  std::vector<Material>& looks_;
  std::map<std::vector<double>, LookId> ids_;
};

class Flattener {
 public:
  Flattener(Flattened& flat, Welding::Mode mode)
      : flat_(flat),
        tables_(flat.tables),
        nodes_(tables_),
        origins_(mode == Welding::Mode::off ? nullptr : &flat.origins.emplace()),
        leaves_(tables_, flat.surfaces, origins_),
        looks_(tables_.looks) {}

  void run(const Solid& solid);

 private:
  // What the nodes above a node mean for that node.
  struct Context {
    Placement placement;
    std::shared_ptr<const LookContext> looks;
    LookId look;
    PartId part;
    bool at_union_level = true;   // true if only unions, transforms, looks and parts stand above
    bool negative = false;        // true if an odd number of subtractions and complements stand above
    bool below_cut = false;       // true if at least one of them stands above
    bool look_below_cut = false;  // true if a look also stands between the outermost of them and here
  };
  // A solid on the way from the root to the solid that is visited now.
  struct OpenSolid {
    Solid solid;
    Context context;            // the context of the solid itself
    std::size_t first_operand;  // the index of its first child's node in operands_
    std::uint32_t first_leaf;   // the number of leaves when it was opened
    std::uint32_t next = 0;     // the child to visit next
  };

  void visit(const Solid& solid, const Context& context);
  void close();
  void deliver(NodeId node, const Context& context, std::uint32_t first_leaf);
  Context child_context(const OpenSolid& open);
  Placement moved(const Placement& placement, const Solid& solid);
  NodeId add_leaf(const Solid& solid, const Context& context);
  NodeId add_operator(Node::Op op, std::span<const NodeId> operands);
  PartId add_part(const Solid& solid, const Context& context);
  std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(tables_.leaves.size()); }

  Flattened& flat_;
  SceneTables& tables_;
  NodeBuilder nodes_;
  SurfaceOrigins* origins_;  // null if surfaces are not to be welded
  LeafBuilder leaves_;
  LookTable looks_;
  std::vector<OpenSolid> open_;   // a stack, the root first
  std::vector<NodeId> operands_;  // finished nodes that no operator has taken yet
};

void Flattener::run(const Solid& solid) {
  Context outermost;
  outermost.looks = std::make_shared<LookContext>();
  outermost.look = looks_.id(*outermost.looks);
  visit(solid, outermost);
  while (!open_.empty()) {
    OpenSolid& open = open_.back();
    const std::span<const Solid> children = open.solid.children();
    if (open.next == children.size()) {
      close();
      continue;
    }
    const Context context = child_context(open);
    visit(children[open.next++], context);
  }
}

void Flattener::visit(const Solid& solid, const Context& context) {
  const std::uint32_t first_leaf = leaf_count();
  switch (solid.kind()) {
    case Solid::Kind::empty:
      return deliver(nodes_.add(Node::Op::empty, {}), context, first_leaf);
    case Solid::Kind::everything:
      return deliver(nodes_.add(Node::Op::everything, {}), context, first_leaf);
    case Solid::Kind::leaf:
      return deliver(add_leaf(solid, context), context, first_leaf);
    default:
      open_.push_back({solid, context, operands_.size(), first_leaf});
      if (solid.kind() == Solid::Kind::part) open_.back().context.part = add_part(solid, context);
  }
}

// Takes a finished node. At union level the node is a body of its own, otherwise an operand of the node above.
void Flattener::deliver(NodeId node, const Context& context, std::uint32_t first_leaf) {
  if (context.at_union_level) {
    flat_.bodies.push_back(body_of(tables_, node, context.part, context.look, first_leaf));
  } else {
    operands_.push_back(node);
  }
}

Flattener::Context Flattener::child_context(const OpenSolid& open) {
  Context below = open.context;
  switch (open.solid.kind()) {
    case Solid::Kind::transform:
      below.placement = moved(below.placement, open.solid);
      break;
    case Solid::Kind::look:
      below.looks = std::make_shared<LookContext>(below.looks->with(open.solid.look()));
      below.look = looks_.id(*below.looks);
      below.look_below_cut = below.below_cut;
      break;
    case Solid::Kind::complement:
    case Solid::Kind::subtract:
      below.at_union_level = false;
      if (open.solid.kind() == Solid::Kind::subtract && open.next == 0) break;
      below.negative = !below.negative;
      below.below_cut = true;
      break;
    case Solid::Kind::intersect:
      below.at_union_level = false;
      break;
    default:
      break;
  }
  return below;
}

// The placement of the solids below a transform.
Placement Flattener::moved(const Placement& placement, const Solid& solid) {
  const ExactAffine inner(solid.transform());
  auto product =
      std::make_shared<ExactAffine>(placement.world_from_solid ? *placement.world_from_solid * inner : inner);
  if (product->bits() > most_bits) {
    throw Error(ErrorCode::limit, solid.place(), "too many transforms inside each other",
                "composing them exactly takes numbers of more than 16,384 bits", "combine them into one multmatrix");
  }
  Placement result = placement;
  if (origins_) result.chain = origins_->provenance.chain(placement.chain, solid.transform(), *product);
  result.world_from_solid = std::move(product);
  return result;
}

// Closes the solid on top of the stack. All its children are done.
void Flattener::close() {
  const OpenSolid open = std::move(open_.back());
  open_.pop_back();
  const Solid::Kind kind = open.solid.kind();
  // These kinds have no node of their own. The nodes of their children have been delivered in their place.
  const bool hands_on = kind == Solid::Kind::transform || kind == Solid::Kind::look || kind == Solid::Kind::part ||
                        (kind == Solid::Kind::unite && open.context.at_union_level);
  if (hands_on) return;
  const Node::Op op = operation_of(kind);
  const NodeId node = add_operator(op, std::span<const NodeId>(operands_).subspan(open.first_operand));
  operands_.resize(open.first_operand);
  tables_.operations.push_back({op, node, open.first_leaf, leaf_count(), open.solid.place()});
  deliver(node, open.context, open.first_leaf);
}

NodeId Flattener::add_operator(Node::Op op, std::span<const NodeId> operands) {
  if (op == Node::Op::unite) return nodes_.add_union({operands.begin(), operands.end()});
  if (op == Node::Op::subtract) return nodes_.add_difference(operands);
  return nodes_.add(op, operands);
}

NodeId Flattener::add_leaf(const Solid& solid, const Context& context) {
  Leaf leaf;
  leaf.kind = solid.shape().kind;
  leaf.place = solid.place();
  leaf.part = context.part;
  leaf.look = context.look;
  leaf.holds_nothing = context.below_cut;
  leaf.shows_cut = context.negative && !context.look_below_cut;
  const std::optional<Box> box = leaves_.add(solid, context.placement, std::move(leaf));
  return box ? nodes_.add_leaf(LeafId(leaf_count() - 1), *box) : nodes_.add(Node::Op::empty, {});
}

PartId Flattener::add_part(const Solid& solid, const Context& context) {
  if (!context.at_union_level || context.part.valid()) {
    throw Error(
        ErrorCode::usage, solid.place(), "a part cannot stand here",
        context.part.valid() ? "parts do not nest" : "only unions, groups, transforms and looks may stand above a part",
        "move the part up, above the operators");
  }
  tables_.parts.push_back({solid.part(), solid.place(), {}});
  return PartId(static_cast<std::uint32_t>(tables_.parts.size() - 1));
}

}  // namespace

Flattened flatten(const Solid& solid, Welding::Mode mode) {
  Flattened flat;
  Flattener(flat, mode).run(solid);
  return flat;
}

}  // namespace csgcast::detail
