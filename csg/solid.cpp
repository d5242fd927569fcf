// SPDX-License-Identifier: MIT
#include "csg/solid.h"

#include <cassert>
#include <utility>
#include <variant>

namespace csgcast {

struct Solid::Node {
  Kind kind = Kind::empty;
  std::vector<Solid> children;
  std::variant<std::monostate, LeafShape, Transform, PartName, LookStatement> payload;
  Place place;

  Node() = default;
  Node(Kind k, std::vector<Solid> c) : kind(k), children(std::move(c)) {}
  Node(const Node&) = default;
  Node(Node&&) noexcept = default;
  Node& operator=(const Node&) = delete;
  Node& operator=(Node&&) = delete;

  // Takes the tree apart with a list of its own: a chain of a million nodes must not recurse. No node is made const
  // (see make).
  ~Node() {
    std::vector<Solid> orphans = std::move(children);
    while (!orphans.empty()) {
      Solid last = std::move(orphans.back());
      orphans.pop_back();
      if (!last.node_ || last.node_.use_count() > 1) continue;
      // The only owner may take the children out of the node before it goes.
      auto& grandchildren = const_cast<Node&>(*last.node_).children;
      for (Solid& child : grandchildren) orphans.push_back(std::move(child));
      grandchildren.clear();
    }
  }
};

Solid::Solid() {
  static const auto nothing = std::make_shared<const Node>();
  node_ = nothing;
}

Solid::Solid(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

Solid Solid::make(Node node) { return Solid(std::make_shared<Node>(std::move(node))); }

Solid Solid::everything() { return make(Node(Kind::everything, {})); }

Solid Solid::leaf(LeafShape shape) {
  assert(!shape.forms.empty());
  Node node(Kind::leaf, {});
  node.payload = std::move(shape);
  return make(std::move(node));
}

Solid::Kind Solid::kind() const { return node_->kind; }
std::span<const Solid> Solid::children() const { return node_->children; }
const LeafShape& Solid::shape() const { return std::get<LeafShape>(node_->payload); }
const Transform& Solid::transform() const { return std::get<Transform>(node_->payload); }
const PartName& Solid::part() const { return std::get<PartName>(node_->payload); }
const LookStatement& Solid::look() const { return std::get<LookStatement>(node_->payload); }
const Place& Solid::place() const { return node_->place; }
const void* Solid::identity() const { return node_.get(); }

Solid Solid::at(Place place) const {
  Node copy = *node_;
  copy.place = std::move(place);
  return make(std::move(copy));
}

Solid unite(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Node(Solid::Kind::unite, std::move(children)));
}

Solid intersect(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Node(Solid::Kind::intersect, std::move(children)));
}

Solid subtract(std::vector<Solid> children) {
  if (children.empty()) return {};
  if (children.size() == 1) return std::move(children.front());
  return Solid::make(Solid::Node(Solid::Kind::subtract, std::move(children)));
}

Solid complement(Solid solid) {
  std::vector<Solid> child{std::move(solid)};
  return Solid::make(Solid::Node(Solid::Kind::complement, std::move(child)));
}

Solid transformed(Solid solid, const Transform& world_from_solid) {
  assert(world_from_solid.is_finite());
  if (ExactAffine(world_from_solid).is_singular()) return {};
  std::vector<Solid> child{std::move(solid)};
  Solid::Node node(Solid::Kind::transform, std::move(child));
  node.payload = world_from_solid;
  return Solid::make(std::move(node));
}

Solid named(Solid solid, PartName name) {
  std::vector<Solid> child{std::move(solid)};
  Solid::Node node(Solid::Kind::part, std::move(child));
  node.payload = std::move(name);
  return Solid::make(std::move(node));
}

Solid with_look(Solid solid, LookStatement look) {
  std::vector<Solid> child{std::move(solid)};
  Solid::Node node(Solid::Kind::look, std::move(child));
  node.payload = std::move(look);
  return Solid::make(std::move(node));
}

}  // namespace csgcast
