// SPDX-License-Identifier: MIT
#include "tests/support/brute_force.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/exact/dyadic.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::test {
namespace {

using Form = QuadricForm;

mpq_class fraction(double value) { return mpq_class(value); }

mpq_class fraction(const Dyadic& value) {
  return mpq_class(value.mantissa() << static_cast<mp_bitcnt_t>(value.exponent()));
}

// A half-space of a leaf whose sign is turned round in a thought experiment: every copy of a surface, or one leaf's.
struct Flip {
  SurfaceId surface;
  LeafId leaf;  // not valid: in every leaf
};

class Definition {
 public:
  Definition(const Scene& scene, const Ray& ray) : scene_(scene), positive_(scene.surfaces().size()) {
    for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i) add_surface(SurfaceId(i), ray);
  }

  std::vector<DefinedInterval> run() {
    std::vector<DefinedInterval> list;
    std::optional<DefinedEnd> entry;
    if (value({})) entry = DefinedEnd{};
    for (const auto& [t, group] : groups_) {
      const std::vector<bool> before = positive_;
      const bool was = value({});
      for (const SurfaceId id : group) positive_[id.index()] = !positive_[id.index()];
      const std::vector<bool> after = positive_;
      const bool is = value({});
      if (was == is) continue;
      const DefinedEnd end = bounding_end(t, group, before, after);
      positive_ = after;
      if (is) {
        entry = end;
      } else {
        list.push_back({*entry, end});
        entry.reset();
      }
    }
    if (entry) list.push_back({*entry, {}});
    return list;
  }

 private:
  void add_surface(SurfaceId id, const Ray& ray) {
    const auto c = scene_.surface(id).exact.unpacked().coefficient;
    mpq_class slope = 0;
    mpq_class value = fraction(c[Form::one]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      slope += fraction(c[Form::x + axis]) * fraction(ray.direction()[axis]);
      value += fraction(c[Form::x + axis]) * fraction(ray.origin()[axis]);
    }
    positive_[id.index()] = slope == 0 ? value >= 0 : slope < 0;
    if (slope != 0) groups_[mpq_class(-value / slope)].push_back(id);
  }

  bool value(const std::vector<Flip>& flips) const { return node_value(scene_.root(), flips); }

  bool node_value(NodeId id, const std::vector<Flip>& flips) const {
    const Node& node = scene_.node(id);
    if (node.op == Node::Op::empty) return false;
    if (node.op == Node::Op::everything) return true;
    if (node.op == Node::Op::leaf) return leaf_value(LeafId(node.first), flips);
    std::optional<bool> value;
    for (const NodeId child : scene_.children(node)) {
      const bool in_child = node_value(child, flips);
      if (!value) {
        value = node.op == Node::Op::complement ? !in_child : in_child;
      } else {
        value =
            node.op == Node::Op::unite ? *value || in_child : *value && (in_child == (node.op == Node::Op::intersect));
      }
    }
    return *value;
  }

  bool leaf_value(LeafId id, const std::vector<Flip>& flips) const {
    bool inside = true;
    for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaf(id))) {
      bool positive = positive_[half_space.surface.index()];
      for (const Flip& flip : flips) {
        if (flip.surface == half_space.surface && (!flip.leaf.valid() || flip.leaf == id)) positive = !positive;
      }
      inside = inside && positive == (half_space.sense == Sense::positive);
    }
    return inside;
  }

  bool changes(const std::vector<bool>& state, std::vector<Flip> flips, const Flip& last) {
    positive_ = state;
    const bool was = value(flips);
    flips.push_back(last);
    return value(flips) != was;
  }

  enum class Walk { no, yes };

  // The first leaf whose own copy of a surface, flipped alone or after those of all leaves before it, changes the
  // value.
  LeafId first_leaf(const std::vector<bool>& state, const std::vector<Flip>& base, SurfaceId surface, Walk walk) {
    positive_ = state;
    const bool start = value(base);
    std::vector<Flip> flips = base;
    for (std::uint32_t i = 0; i < scene_.leaves().size(); ++i) {
      if (walk == Walk::no) flips = base;
      flips.push_back({surface, LeafId(i)});
      if (value(flips) != start) return LeafId(i);
    }
    return {};
  }

  // The rule of docs/answer.md, once for surfaces and once for the leaves that own the chosen one.
  DefinedEnd bounding_end(const mpq_class& t, std::vector<SurfaceId> group, const std::vector<bool>& before,
                          const std::vector<bool>& after) {
    std::sort(group.begin(), group.end());
    struct Base {
      const std::vector<bool>* state;
      std::vector<Flip> flips;
    };
    std::vector<Base> bases;
    SurfaceId chosen;
    for (const SurfaceId id : group) {
      for (const auto* state : {&before, &after}) {
        if (changes(*state, {}, {id, {}})) bases.push_back({state, {}});
      }
      if (bases.empty()) continue;
      chosen = id;
      break;
    }
    for (const auto* state : {&before, &after}) {
      if (chosen.valid() && (bases.empty() || bases.front().flips.empty()) && !bases.empty()) break;
      std::vector<Flip> flips;
      for (const SurfaceId id : group) {
        if (changes(*state, flips, {id, {}})) {
          if (!chosen.valid() || id < chosen) {
            bases.clear();
            chosen = id;
          }
          if (id == chosen) bases.push_back({state, flips});
          break;
        }
        flips.push_back({id, {}});
      }
    }
    positive_ = after;
    const auto* inside = value({}) ? &after : &before;
    LeafId leaf;
    for (const auto* side : {inside, inside == &after ? &before : &after}) {
      for (const Base& base : bases) {
        if (base.state == side) leaf = std::min(leaf, first_leaf(*base.state, base.flips, chosen, Walk::no));
      }
      if (leaf.valid()) break;
    }
    if (!leaf.valid()) {
      for (const Base& base : bases) leaf = std::min(leaf, first_leaf(*base.state, base.flips, chosen, Walk::yes));
    }
    return {t, chosen, leaf};
  }

  const Scene& scene_;
  std::vector<bool> positive_;
  std::map<mpq_class, std::vector<SurfaceId>> groups_;
};

}  // namespace

std::vector<DefinedInterval> intervals_by_definition(const Scene& scene, const Ray& ray) {
  return Definition(scene, ray).run();
}

}  // namespace csgcast::test
