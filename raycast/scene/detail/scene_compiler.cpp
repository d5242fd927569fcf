// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/scene_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "csg/solid/leaf_shape.h"
#include "csg/solid/simplify.h"
#include "raycast/scene/detail/enclosure.h"

namespace csgcast {
namespace {

constexpr std::uint64_t most_leaves = std::uint64_t{1} << 22;
constexpr std::size_t most_bits = std::size_t{1} << 14;

// A transform, look or part hands its child's node on; so does a union above which there are only unions.
bool passes_through(const Solid& solid) {
  return solid.kind() == Solid::Kind::transform || solid.kind() == Solid::Kind::look ||
         solid.kind() == Solid::Kind::part;
}

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

// Within these nothing in the engine over- or underflows.
constexpr double greatest = 0x1p400;
constexpr double least = 0x1p-400;

void check_range(const Box& box, bool is_bounded, const Place& place) {
  if (box.is_null()) return;
  double farthest = is_bounded && !box.is_finite() ? std::numeric_limits<double>::infinity() : 0;
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {box.lower[axis], box.upper[axis]}) {
      if (std::isfinite(side)) farthest = std::fmax(farthest, std::fabs(side));
    }
    longest = std::fmax(longest, box.upper[axis] - box.lower[axis]);
  }
  if (farthest <= greatest && longest >= least) return;
  throw Error(ErrorCode::limit, place,
              farthest > greatest ? "this solid is too large or too far away" : "this solid is too small",
              "coordinates up to 2^400 and sizes from 2^-400 work", "choose another unit of length");
}

std::vector<double> look_key(const Material& m) {
  return {m.color.r,    m.color.g,      m.color.b,      m.ambient,     m.diffuse,    m.specular,
          m.shininess,  m.reflection,   m.transmission, m.ior,         m.emission.r, m.emission.g,
          m.emission.b, m.absorption.r, m.absorption.g, m.absorption.b};
}

}  // namespace

Scene compile(Solid solid, const Welding& welding) {
  if (welding.mode == Welding::Mode::by_hand &&
      !(welding.tolerance > 0 && welding.tolerance <= Welding::greatest_tolerance)) {
    throw Error(ErrorCode::bad_value, {}, "the tolerance of welding is out of range",
                "it is a share of the size of the scene, above 0 and at most 1/128", "choose a smaller one, or none");
  }
  solid = simplified(solid);
  if (solid.leaf_count() > most_leaves) {
    throw Error(ErrorCode::limit, solid.place(), "the scene has more than 4,194,304 leaves",
                "each use of a shared solid counts", "render it in pieces");
  }
  return SceneCompiler(welding).compile(std::move(solid));
}

Scene SceneCompiler::compile(Solid solid) {
  flatten(solid);
  weld();
  // From here on the scene itself needs the memory.
  provenance_ = {};
  solid = {};
  gather_regions();
  std::vector<Body>().swap(bodies_);
  scene_.bounds_ = scene_.node(scene_.root_).box;
  widen_boxes();
  scene_.frame_ = csgcast::Frame::around(scene_.bounded_leaves_);
  scene_.leaves_.shrink_to_fit();
  scene_.half_spaces_.shrink_to_fit();
  scene_.nodes_.shrink_to_fit();
  scene_.children_.shrink_to_fit();
  scene_.operations_.shrink_to_fit();
  scene_.surfaces_ = surfaces_.take(scene_.frame_);
  scene_.leads_away_ = detail::sides_that_lead_away(scene_);
  return std::move(scene_);
}

// One walk over the tree, in file order.
void SceneCompiler::flatten(const Solid& solid) {
  Context outermost;
  outermost.looks = std::make_shared<LookContext>();
  outermost.look = look_id(*outermost.looks);
  visit(solid, outermost);
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    const std::span<const Solid> children = frame.solid.children();
    if (frame.next == children.size()) {
      close();
      continue;
    }
    const Context context = child_context(frame);
    visit(children[frame.next++], context);
  }
}

void SceneCompiler::visit(const Solid& solid, const Context& context) {
  const auto leaf_count = static_cast<std::uint32_t>(scene_.leaves_.size());
  switch (solid.kind()) {
    case Solid::Kind::empty:
      return deliver(add_node(Node::Op::empty, {}), context, leaf_count);
    case Solid::Kind::everything:
      return deliver(add_node(Node::Op::everything, {}), context, leaf_count);
    case Solid::Kind::leaf:
      return deliver(add_leaf(solid, context), context, leaf_count);
    default:
      frames_.push_back({solid, context, results_.size(), leaf_count});
      if (solid.kind() == Solid::Kind::part) frames_.back().context.part = add_part(solid, context);
  }
}

// A finished node: a body of its own at union level, else an operand of the node above.
void SceneCompiler::deliver(NodeId node, const Context& context, std::uint32_t first_leaf) {
  if (context.at_union_level) {
    add_body(node, context, first_leaf);
  } else {
    results_.push_back(node);
  }
}

SceneCompiler::Context SceneCompiler::child_context(const Frame& frame) {
  Context below = frame.context;
  switch (frame.solid.kind()) {
    case Solid::Kind::transform: {
      const ExactAffine inner(frame.solid.transform());
      auto product = std::make_shared<ExactAffine>(below.world_from_solid ? *below.world_from_solid * inner : inner);
      if (product->bits() > most_bits) {
        throw Error(ErrorCode::limit, frame.solid.place(), "too many transforms inside each other",
                    "composing them exactly takes numbers of more than 16,384 bits",
                    "combine them into one multmatrix");
      }
      if (welding_.mode != Welding::Mode::off)
        below.chain = provenance_.chain(below.chain, frame.solid.transform(), *product);
      below.world_from_solid = std::move(product);
      break;
    }
    case Solid::Kind::look:
      below.looks = std::make_shared<LookContext>(below.looks->with(frame.solid.look()));
      below.look = look_id(*below.looks);
      below.look_below_cut = below.below_cut;
      break;
    case Solid::Kind::complement:
    case Solid::Kind::subtract:
      below.at_union_level = false;
      if (frame.solid.kind() == Solid::Kind::subtract && frame.next == 0) break;
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

// All children of the frame on top are done.
void SceneCompiler::close() {
  const Frame frame = std::move(frames_.back());
  frames_.pop_back();
  const bool hands_on =
      passes_through(frame.solid) || (frame.solid.kind() == Solid::Kind::unite && frame.context.at_union_level);
  if (hands_on) return;
  const auto children = std::span<const NodeId>(results_).subspan(frame.results);
  const Node::Op op = operation_of(frame.solid.kind());
  const NodeId node = op == Node::Op::unite      ? add_union({children.begin(), children.end()})
                      : op == Node::Op::subtract ? add_subtract(children)
                                                 : add_node(op, children);
  results_.resize(frame.results);
  scene_.operations_.push_back(
      {op, node, frame.first_leaf, static_cast<std::uint32_t>(scene_.leaves_.size()), frame.solid.place()});
  deliver(node, frame.context, frame.first_leaf);
}

PartId SceneCompiler::add_part(const Solid& solid, const Context& context) {
  if (!context.at_union_level || context.part.valid()) {
    throw Error(
        ErrorCode::usage, solid.place(), "a part cannot stand here",
        context.part.valid() ? "parts do not nest" : "only unions, groups, transforms and looks may stand above a part",
        "move the part up, above the operators");
  }
  scene_.parts_.push_back({solid.part(), solid.place(), {}});
  return PartId(static_cast<std::uint32_t>(scene_.parts_.size() - 1));
}

LookId SceneCompiler::look_id(const LookContext& looks) {
  const Material material = looks.resolve();
  const auto [it, is_new] =
      look_ids_.try_emplace(look_key(material), LookId(static_cast<std::uint32_t>(scene_.looks_.size())));
  if (is_new) scene_.looks_.push_back(material);
  return it->second;
}

NodeId SceneCompiler::add_leaf(const Solid& solid, const Context& context) {
  static const ExactAffine identity;
  const ExactAffine* moved = context.world_from_solid.get();
  const Box box = world_bounds(solid.shape(), moved ? *moved : identity);
  check_range(box, solid.shape().bounds.is_finite(), solid.place());
  Leaf leaf;
  leaf.first = static_cast<std::uint32_t>(scene_.half_spaces_.size());
  leaf.kind = solid.shape().kind;
  leaf.place = solid.place();
  leaf.part = context.part;
  leaf.look = context.look;
  leaf.holds_nothing = context.below_cut;
  leaf.shows_cut = context.negative && !context.look_below_cut;
  const bool has_inside = add_half_spaces(solid, context, leaf, box);
  if (!has_inside || box.is_null()) {
    scene_.half_spaces_.resize(leaf.first);
    return add_node(Node::Op::empty, {});
  }
  const LeafId id(static_cast<std::uint32_t>(scene_.leaves_.size()));
  scene_.leaves_.push_back(std::move(leaf));
  if (box.is_finite()) scene_.bounded_leaves_ = hull(scene_.bounded_leaves_, box);
  scene_.nodes_.push_back({Node::Op::leaf, id.index(), 0, box});
  return NodeId(static_cast<std::uint32_t>(scene_.nodes_.size() - 1));
}

// False if two of the half-spaces face each other on one surface: then the leaf has no inside.
bool SceneCompiler::add_half_spaces(const Solid& solid, const Context& context, Leaf& leaf, const Box& box) {
  const LeafShape& shape = solid.shape();
  std::optional<FormMover> mover;
  if (context.world_from_solid) mover.emplace(*context.world_from_solid);
  const bool keeps_sources = welding_.mode != Welding::Mode::off;
  const std::uint32_t source = keeps_sources ? provenance_.add_leaf(solid, context.chain, box) : 0;
  const auto begin = static_cast<std::ptrdiff_t>(leaf.first);
  for (std::uint32_t i = 0; i < shape.forms.size(); ++i) {
    const QuadricForm form = shape.forms[i];
    const HalfSpace half_space = surfaces_.half_space(mover ? mover->moved(form) : form, box);
    if (keeps_sources) ownerships_.push_back({half_space.surface, {source, i}});
    const auto same = std::find_if(scene_.half_spaces_.begin() + begin, scene_.half_spaces_.end(),
                                   [&](const HalfSpace& other) { return other.surface == half_space.surface; });
    if (same == scene_.half_spaces_.end()) {
      scene_.half_spaces_.push_back(half_space);
    } else if (same->sense != half_space.sense) {
      return false;
    }
  }
  leaf.count = static_cast<std::uint32_t>(scene_.half_spaces_.size()) - leaf.first;
  return true;
}

Box SceneCompiler::box_of(Node::Op op, std::span<const NodeId> children) const {
  if (op == Node::Op::empty) return {};
  if (op == Node::Op::everything || op == Node::Op::complement) return Box::everything();
  Box box = scene_.node(children.front()).box;
  if (op == Node::Op::subtract) return box;
  for (const NodeId child : children.subspan(1)) {
    const Box& other = scene_.node(child).box;
    box = op == Node::Op::unite ? hull(box, other) : intersection(box, other);
  }
  return box;
}

NodeId SceneCompiler::add_node(Node::Op op, std::span<const NodeId> children) {
  const Box box = box_of(op, children);
  const bool empty =
      op == Node::Op::empty || (op != Node::Op::complement && op != Node::Op::everything && box.is_null());
  Node node{empty ? Node::Op::empty : op, 0, 0, box};
  if (!empty) {
    node.first = static_cast<std::uint32_t>(scene_.children_.size());
    node.count = static_cast<std::uint32_t>(children.size());
    scene_.children_.insert(scene_.children_.end(), children.begin(), children.end());
  }
  scene_.nodes_.push_back(node);
  return NodeId(static_cast<std::uint32_t>(scene_.nodes_.size() - 1));
}

NodeId SceneCompiler::add_subtract(std::span<const NodeId> children) {
  std::vector<NodeId> subtrahends(children.begin() + 1, children.end());
  const std::array<NodeId, 2> pair{children.front(), add_union(std::move(subtrahends))};
  return add_node(Node::Op::subtract, pair);
}

}  // namespace csgcast
