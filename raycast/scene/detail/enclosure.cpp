// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/enclosure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "csg/exact/quadric_form.h"
#include "raycast/surface/cell_form.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

bool before(const HalfSpace& a, const HalfSpace& b) {
  return std::pair(a.surface, a.sense) < std::pair(b.surface, b.sense);
}

CellForm form_of(const Surface& surface) { return {surface.local, surface.center}; }

// Tells if a box certainly lies within a plane's half-space. The box must be clear of the plane by far more than the
// rounding of the numbers here and of the places where rays start.
class HeldBox {
 public:
  /// Both must outlive it.
  HeldBox(const Scene& scene, const Box& box) : scene_(scene), box_(box) {}

  bool is_held_by(const HalfSpace& half_space) {
    constexpr double clearance = 0x1p-40;
    const Surface& plane = scene_.surface(half_space.surface);
    if (!plane.is_plane || !plane.is_local || !plane.in_range || !box_.is_finite()) return false;
    if (!is_placed_) place();
    const auto& c = plane.local;
    const Vector p = middle_ - plane.center;
    const double value = c[Form::x] * p.x + c[Form::y] * p.y + c[Form::z] * p.z + c[Form::one];
    const double reach =
        std::fabs(c[Form::x]) * half_.x + std::fabs(c[Form::y]) * half_.y + std::fabs(c[Form::z]) * half_.z;
    const double most = (half_space.sense == Sense::negative ? value : -value) + reach;
    return most < -clearance * (plane.first_degree + plane.constant);
  }

 private:
  void place() {
    const CellBox place = in_frame(box_, scene_.frame());
    half_ = 0.5 * (place.upper - place.lower);
    middle_ = 0.5 * (place.upper + place.lower);
    is_placed_ = true;
  }

  const Scene& scene_;
  const Box& box_;
  bool is_placed_ = false;
  Vector middle_;
  Vector half_;
};

// True if normals computed near the solid are accurate enough to tell on which side a ray leaves such a set. The
// lengths of the normals have a lower bound if f is convex and far below 0 in the solid's middle (docs/accuracy.md,
// "Rays that lead away").
bool has_sound_normals(const Scene& scene, const Surface& surface, Sense sense) {
  constexpr double depth = 0x1p-20;
  if (!surface.is_local || !scene.bounds().is_finite()) return false;
  const Point middle = scene.bounds().center();
  const double value = local_form(form_of(surface), in_frame({middle, middle}, scene.frame())).value;
  const double size = 4 * surface.second_degree + 2 * surface.first_degree + surface.constant;
  return (sense == Sense::negative ? value : -value) < -depth * size;
}

// True if rays that leave the half-space lead away from it. Precondition: the half-space holds the whole solid.
bool leads_away(const Scene& scene, const HalfSpace& half_space) {
  const Surface& surface = scene.surface(half_space.surface);
  if (!surface.in_range) return false;
  if (surface.is_plane) return true;
  if (!has_sound_normals(scene, surface, half_space.sense)) return false;
  const QuadricForm form = surface.exact.unpacked();
  return is_convex(half_space.sense == Sense::negative ? form : -form);
}

// Finds half-spaces that hold all of a node. Not all of them are found.
class Enclosure {
 public:
  explicit Enclosure(const Scene& scene) : scene_(scene) {}

  std::vector<HalfSpace> of(NodeId root) {
    // `order` has every node before its operands, and the first operand of a node first. It is traversed backwards, so
    // the operands of a node are the last nodes that were found.
    std::vector<NodeId> order;
    std::vector<NodeId> pending{root};
    while (!pending.empty()) {
      order.push_back(pending.back());
      pending.pop_back();
      const auto children = operands(scene_.node(order.back()));
      pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    for (auto node = order.rbegin(); node != order.rend(); ++node) add(scene_.node(*node));
    return std::move(found_.front());
  }

 private:
  // The most half-spaces that are kept for an operator. More are seldom of use. The limit also keeps deep chains of
  // operators from taking time in the square of their length.
  static constexpr std::size_t most = 1024;

  // The children whose half-spaces matter to the node.
  std::span<const NodeId> operands(const Node& node) const {
    switch (node.op) {
      case Node::Op::unite:
      case Node::Op::intersect:
        return scene_.children(node);
      case Node::Op::subtract:
        return scene_.children(node).first(1);
      default:
        return {};
    }
  }

  void add(const Node& node) {
    const auto children = operands(node);
    if (children.empty()) {
      found_.emplace_back();
      if (node.op != Node::Op::leaf) return;
      const Leaf& leaf = scene_.leaf(LeafId(node.first));
      if (leaf.function != nullptr) return;  // such a leaf need not lie within any of its half-spaces
      const auto own = scene_.half_spaces(leaf);
      found_.back().assign(own.begin(), own.end());
      return;
    }
    std::vector<HalfSpace> sum = take();
    Box box = scene_.node(children.front()).box;
    for (const NodeId child : children.subspan(1)) {
      std::vector<HalfSpace> next = take();
      const Box& next_box = scene_.node(child).box;
      if (node.op == Node::Op::unite) {
        sum = common(sum, box, next, next_box);
      } else {
        sum.insert(sum.end(), next.begin(), next.end());
      }
      if (sum.size() > most) sum.resize(most);
      box = hull(box, next_box);
    }
    found_.push_back(std::move(sum));
  }

  std::vector<HalfSpace> take() {
    std::vector<HalfSpace> last = std::move(found_.back());
    found_.pop_back();
    return last;
  }

  // For two nodes, this finds the half-spaces of either one that hold the other node, too.
  std::vector<HalfSpace> common(std::vector<HalfSpace>& first, const Box& first_box, std::vector<HalfSpace>& second,
                                const Box& second_box) const {
    std::sort(second.begin(), second.end(), before);
    std::vector<HalfSpace> both;
    HeldBox held_first(scene_, first_box);
    HeldBox held_second(scene_, second_box);
    for (const HalfSpace& one : first) {
      if (std::binary_search(second.begin(), second.end(), one, before) || held_second.is_held_by(one))
        both.push_back(one);
    }
    for (const HalfSpace& one : second) {
      if (held_first.is_held_by(one)) both.push_back(one);
    }
    return both;
  }

  const Scene& scene_;
  std::vector<std::vector<HalfSpace>> found_;  // a stack with the half-spaces of the nodes that no parent has taken yet
};

}  // namespace

std::vector<std::uint8_t> sides_that_lead_away(const Scene& scene) {
  std::vector<std::uint8_t> sides;
  for (const HalfSpace& half_space : Enclosure(scene).of(scene.root())) {
    if (!leads_away(scene, half_space)) continue;
    sides.resize(scene.surfaces().size());
    sides[half_space.surface.index()] |=
        static_cast<std::uint8_t>(1u << static_cast<unsigned>(opposite(half_space.sense)));
  }
  return sides;
}

}  // namespace csgcast::detail
