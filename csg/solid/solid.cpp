// SPDX-License-Identifier: MIT
#include "csg/solid/solid.h"

#include <array>
#include <limits>
#include <utility>

#include "csg/base/precondition.h"
#include "csg/exact/affine.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/rules/rules.h"

namespace csgcast {

const char* word(LeafKind kind) {
  static constexpr std::array words{"cube",        "sphere",  "cylinder",  "ellipsoid", "paraboloid",
                                    "hyperboloid", "quadric", "halfspace", "convex"};
  return words[static_cast<std::size_t>(kind)];
}

struct Solid::Node : Counted {
  static constexpr std::uint64_t most_leaves = std::numeric_limits<std::uint64_t>::max();

  Kind kind = Kind::empty;
  Place place;
  std::vector<Solid> children;
  std::uint64_t leaf_count = 0;

  Node() = default;
  Node(Kind k, std::vector<Solid> c) : kind(k), children(std::move(c)), leaf_count(kind == Kind::leaf ? 1 : 0) {
    for (const Solid& child : children) {
      const std::uint64_t more = child.leaf_count();
      leaf_count = more > most_leaves - leaf_count ? most_leaves : leaf_count + more;
    }
  }
  // Takes the tree apart with a list of its own: a chain of a million nodes must not recurse.
  ~Node() override {
    std::vector<Solid> orphans = std::move(children);
    while (!orphans.empty()) {
      Solid last = std::move(orphans.back());
      orphans.pop_back();
      Node* const node = last.node_.if_only_owner();
      if (node == nullptr) continue;
      for (Solid& child : node->children) orphans.push_back(std::move(child));
      node->children.clear();
    }
  }
};

// A node of a kind that has more to say; that kind alone pays for it.
template <class Payload>
struct Solid::NodeWith : Node {
  Payload payload;

  NodeWith(Kind k, std::vector<Solid> c, Payload p) : Node(k, std::move(c)), payload(std::move(p)) {}
};

Solid::Solid() {
  static const Shared<Node> nothing = Shared<Node>::make();
  node_ = nothing;
}

Solid::Solid(Shared<Node> node) : node_(std::move(node)) {}

Solid Solid::make(Kind kind, std::vector<Solid> children) {
  return Solid(Shared<Node>::make(kind, std::move(children)));
}

template <class Payload>
Solid Solid::make(Kind kind, std::vector<Solid> children, Payload payload) {
  return Solid(Shared<Node>::make<NodeWith<Payload>>(kind, std::move(children), std::move(payload)));
}

template <class Payload>
const Payload& Solid::payload(Kind of) const {
  CSGCAST_PRECONDITION(kind() == of);
  return static_cast<const NodeWith<Payload>&>(*node_).payload;
}

Solid Solid::everything() { return make(Kind::everything, {}); }

Solid Solid::leaf(LeafShape shape) {
  CSGCAST_PRECONDITION(shape.form_count() > 0);
  CSGCAST_PRECONDITION(shape.inside == nullptr || is_well_formed(*shape.inside, shape.form_count()));
  return make(Kind::leaf, {}, std::move(shape));
}

Solid::Kind Solid::kind() const { return node_->kind; }
std::span<const Solid> Solid::children() const { return node_->children; }
const LeafShape& Solid::shape() const { return payload<LeafShape>(Kind::leaf); }
const Transform& Solid::transform() const { return payload<Transform>(Kind::transform); }
const PartName& Solid::part() const { return payload<PartName>(Kind::part); }
const LookStatement& Solid::look() const { return payload<LookStatement>(Kind::look); }
const Place& Solid::place() const { return node_->place; }
const void* Solid::identity() const { return &*node_; }
std::uint64_t Solid::leaf_count() const { return node_->leaf_count; }

Solid Solid::copy() const {
  std::vector<Solid> children = node_->children;
  switch (kind()) {
    case Kind::leaf:
      return make(kind(), {}, shape());
    case Kind::transform:
      return make(kind(), std::move(children), transform());
    case Kind::part:
      return make(kind(), std::move(children), part());
    case Kind::look:
      return make(kind(), std::move(children), look());
    default:
      return make(kind(), std::move(children));
  }
}

Solid Solid::at(Place place) const& { return Solid(*this).at(std::move(place)); }

Solid Solid::at(Place place) && {
  Solid result = node_.if_only_owner() != nullptr ? std::move(*this) : copy();
  result.node_.if_only_owner()->place = std::move(place);
  return result;
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): the analyzer does not follow counted owners

Solid unite(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Kind::unite, std::move(children));
}

Solid intersect(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Kind::intersect, std::move(children));
}

Solid subtract(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Kind::subtract, std::move(children));
}

Solid complement(Solid solid) { return Solid::make(Solid::Kind::complement, {std::move(solid)}); }

Solid transformed(Solid solid, const Transform& world_from_solid) {
  CSGCAST_PRECONDITION(world_from_solid.is_finite());
  if (ExactAffine(world_from_solid).is_singular()) return {};
  return Solid::make(Solid::Kind::transform, {std::move(solid)}, world_from_solid);
}

Solid named(Solid solid, PartName name) {
  require(broken_rule(name), "part");
  return Solid::make(Solid::Kind::part, {std::move(solid)}, std::move(name));
}

Solid with_look(Solid solid, LookStatement look) {
  if (look.material) require(broken_rule(*look.material), "material");
  if (look.paint) require(broken_rule(*look.paint), "color");
  return Solid::make(Solid::Kind::look, {std::move(solid)}, std::move(look));
}

}  // namespace csgcast
