// SPDX-License-Identifier: MIT
#include "csg/solid/detail/bounds_walk.h"

namespace csgcast::detail {
namespace {

using Kind = Solid::Kind;

constexpr std::size_t most_composed = 1000;  // alive at a time: each holds twelve long numbers
constexpr std::size_t most_repetitions = 100'000;
constexpr std::size_t longest_entry = 4096;  // bits

// Only the first child bounds a difference.
std::size_t children_that_count(const Solid& solid) {
  return solid.kind() == Kind::subtract ? 1 : solid.children().size();
}

void absorb(const Solid& parent, bool is_first, Box& box, const Box& child) {
  if (is_first) {
    box = child;
  } else {
    box = parent.kind() == Kind::intersect ? intersection(box, child) : hull(box, child);
  }
}

}  // namespace

BoundsWalk::BoundsWalk() : composed_(1) {}

Box BoundsWalk::bounds_of(const Solid& root) {
  if (const auto box = known_box(root)) return *box;
  enter(root);
  for (;;) {
    Frame& top = frames_.back();
    if (top.next_child < children_that_count(*top.solid)) {
      const Solid& child = top.solid->children()[top.next_child++];
      if (const auto box = known_box(child)) {
        absorb(*top.solid, top.next_child == 1, top.box, *box);
      } else {
        enter(child);
      }
      continue;
    }
    const Box box = leave();
    if (frames_.empty()) return box;
    Frame& parent = frames_.back();
    absorb(*parent.solid, parent.next_child == 1, parent.box, box);
  }
}

std::optional<Box> BoundsWalk::known_box(const Solid& solid) const {
  switch (solid.kind()) {
    case Kind::empty:
      return Box{};
    case Kind::everything:
      return Box::everything();
    case Kind::leaf:
      return world_bounds(solid.shape(), composed_[present_].world_from_solid);
    case Kind::complement:
      return solid.children()[0].kind() == Kind::everything ? Box{} : Box::everything();
    default:
      break;
  }
  const auto found = boxes_.find({solid.identity(), composed_[present_].name});
  return found == boxes_.end() ? std::nullopt : std::optional(found->second);
}

void BoundsWalk::enter(const Solid& solid) {
  Frame& frame = frames_.emplace_back();
  frame.solid = &solid;
  frame.outer = present_;
  if (solid.kind() == Kind::transform) enter_transform(frame);
}

bool BoundsWalk::may_compose(const Solid& transform) {
  if (!entered_.insert(transform.identity()).second) ++repetitions_;
  return composed_.size() <= most_composed && repetitions_ <= most_repetitions;
}

void BoundsWalk::enter_transform(Frame& frame) {
  if (may_compose(*frame.solid)) {
    ExactAffine product = composed_[present_].world_from_solid * ExactAffine(frame.solid->transform());
    if (product.bits() <= longest_entry) {
      composed_.push_back({std::move(product), ++last_name_});
      present_ = composed_.size() - 1;
      return;
    }
  }
  frame.moves_box = true;
  present_ = 0;
}

Box BoundsWalk::leave() {
  const Frame frame = frames_.back();
  frames_.pop_back();
  Box box = frame.box;
  const Solid& solid = *frame.solid;
  if (solid.kind() == Kind::transform) {
    if (!frame.moves_box) composed_.pop_back();
    present_ = frame.outer;
    if (frame.moves_box) box = image(box, composed_[present_].world_from_solid * ExactAffine(solid.transform()));
  }
  boxes_.emplace(Key{solid.identity(), composed_[present_].name}, box);
  return box;
}

}  // namespace csgcast::detail
