// SPDX-License-Identifier: MIT
#include "tests/support/brute_force.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/exact/dyadic.h"
#include "csg/exact/quadric_form.h"
#include "tests/support/catch.h"
#include "tests/support/planted.h"

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
  Definition(const Scene& scene, const Ray& ray, const DefinedLeaf& function_leaf,
             const std::optional<Departure>& departure)
      : scene_(scene), function_leaf_(function_leaf), positive_(scene.surfaces().size()) {
    for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i) {
      if (departure && departure->surface == SurfaceId(i)) {
        add_departed(SurfaceId(i), ray, departure->side);
      } else {
        add_surface(SurfaceId(i), ray);
      }
    }
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
  // A plane's form along the ray: value + slope t.
  struct Along {
    mpq_class value;
    mpq_class slope;
  };

  static Along along(const QuadricForm& plane, const Ray& ray) {
    const auto& c = plane.coefficient;
    Along result{fraction(c[Form::one]), 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.slope += fraction(c[Form::x + axis]) * fraction(ray.direction()[axis]);
      result.value += fraction(c[Form::x + axis]) * fraction(ray.origin()[axis]);
    }
    return result;
  }

  // A surface's form along the ray is the product of these.
  std::vector<Along> factors(SurfaceId id, const Ray& ray) const {
    const Surface& surface = scene_.surface(id);
    if (surface.other == nullptr) return {along(surface.exact.unpacked(), ray)};
    std::vector<Along> result;
    for (const QuadricForm& plane : dynamic_cast<const ThreePlanes&>(*surface.other).planes())
      result.push_back(along(plane, ray));
    return result;
  }

  void add_surface(SurfaceId id, const Ray& ray) {
    std::map<mpq_class, int> roots;
    bool positive = true;
    bool vanishes = false;
    for (const Along& f : factors(id, ray)) {
      vanishes = vanishes || (f.slope == 0 && f.value == 0);
      positive = positive == (f.slope == 0 ? f.value > 0 : f.slope < 0);
      if (f.slope != 0) ++roots[mpq_class(-f.value / f.slope)];
    }
    positive_[id.index()] = vanishes || positive;
    for (const auto& [t, count] : roots) {
      if (!vanishes && count % 2 != 0) groups_[t].push_back(id);
    }
  }

  // The form is 0 at the start: one of its factors is t, and after the start it changes its sign at the others' roots.
  void add_departed(SurfaceId id, const Ray& ray, Sense side) {
    std::map<mpq_class, int> roots;
    bool positive_at_end = true;
    std::size_t sloped = 0;
    bool vanishes = false;
    for (const Along& f : factors(id, ray)) {
      vanishes = vanishes || (f.slope == 0 && f.value == 0);
      positive_at_end = positive_at_end == (f.slope == 0 ? f.value > 0 : f.slope > 0);
      if (f.slope == 0) continue;
      ++sloped;
      if (-f.value / f.slope > 0) ++roots[mpq_class(-f.value / f.slope)];
    }
    const bool is_linear = vanishes || sloped <= 1;
    const bool positive = is_linear && !vanishes && sloped == 1 ? positive_at_end : side == Sense::positive;
    positive_[id.index()] = positive;
    if (is_linear) return;
    bool is_odd = false;
    for (const auto& [t, count] : roots) {
      if (count % 2 == 0) continue;
      groups_[t].push_back(id);
      is_odd = !is_odd;
    }
    if (is_odd != (positive != positive_at_end)) groups_[mpq_class(0)].push_back(id);
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
    std::vector<bool> holds;
    for (const HalfSpace& half_space : scene_.half_spaces(scene_.leaf(id))) {
      bool positive = positive_[half_space.surface.index()];
      for (const Flip& flip : flips) {
        if (flip.surface == half_space.surface && (!flip.leaf.valid() || flip.leaf == id)) positive = !positive;
      }
      holds.push_back(positive == (half_space.sense == Sense::positive));
    }
    if (scene_.leaf(id).function != nullptr) return function_leaf_(holds);
    return std::find(holds.begin(), holds.end(), false) == holds.end();
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
  const DefinedLeaf& function_leaf_;
  std::vector<bool> positive_;
  std::map<mpq_class, std::vector<SurfaceId>> groups_;
};

void check_end(Caster& caster, const Crossing& end, Passage passage, const DefinedEnd& defined) {
  CHECK(end.surface == defined.surface);
  if (!end.surface.valid()) return;
  // A few roundings of numbers up to about 8, and of t itself where a face is met at a flat angle.
  CHECK(end.t == Approx(defined.t.get_d()).epsilon(1e-12).margin(64 * 8 * 0x1p-53 / 0.25));
  CHECK(caster.attribute({end, passage}).leaf == defined.leaf);
}

}  // namespace

std::vector<DefinedInterval> intervals_by_definition(const Scene& scene, const Ray& ray,
                                                     const DefinedLeaf& function_leaf,
                                                     const std::optional<Departure>& departure) {
  return Definition(scene, ray, function_leaf, departure).run();
}

void check_list(Caster& caster, const IntervalList& list, const std::vector<DefinedInterval>& defined) {
  REQUIRE(list.size() == defined.size());
  for (std::size_t k = 0; k < list.size(); ++k) {
    check_end(caster, list[k].entry, Passage::entry, defined[k].entry);
    check_end(caster, list[k].exit, Passage::exit, defined[k].exit);
  }
}

Ray grid_ray(RandomSolids& random) {
  for (;;) {
    const Point origin{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)};
    const Vector direction{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
    if (random.index(8) == 0) return Ray(random.point(2), random.direction());
    if (direction != Vector{}) return Ray(origin, direction);
  }
}

}  // namespace csgcast::test
