// SPDX-License-Identifier: MIT
#include "csg/solid/detail/bounds_walk.h"

namespace csgcast::detail {
namespace {

using Kind = Solid::Kind;

constexpr std::size_t most_composed = 1000;  // alive at a time: each holds twelve long numbers
constexpr std::size_t most_repetitions = 100'000;
constexpr std::size_t longest_entry = 4096;  // bits

// Only the first child bounds a difference.
std::span<const Solid> children_that_count(const Solid& solid) {
  return solid.kind() == Kind::subtract ? solid.children().first(1) : solid.children();
}

}  // namespace

BoundsWalk::BoundsWalk() : composed_(1) {}

Box BoundsWalk::bounds_of(const Solid& root) {
  TreeWalk<const Solid, Level> walk;
  const Level whole = walk.run(
      {&root, 1}, Level{},
      [this](const Solid& solid, Level& above) -> std::optional<Level> {
        const auto box = known_box(solid);
        if (!box) return enter(solid);
        above.add(*box);
        return std::nullopt;
      },
      children_that_count,
      [this](const Solid& solid, const Level& level, Level& above) { above.add(leave(solid, level)); });
  return whole.box;
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

BoundsWalk::Level BoundsWalk::enter(const Solid& solid) {
  Level level;
  level.outer = present_;
  if (solid.kind() == Kind::intersect) {
    level.intersects = true;
    level.box = Box::everything();
  } else if (solid.kind() == Kind::transform) {
    level.moves_box = !compose(solid);
    present_ = level.moves_box ? 0 : composed_.size() - 1;
  }
  return level;
}

bool BoundsWalk::may_compose(const Solid& transform) {
  if (!entered_.insert(transform.identity()).second) ++repetitions_;
  return composed_.size() <= most_composed && repetitions_ <= most_repetitions;
}

// Adds the transform, composed with those around it, to composed_. False if that would cost too much.
bool BoundsWalk::compose(const Solid& transform) {
  if (!may_compose(transform)) return false;
  ExactAffine product = composed_[present_].world_from_solid * ExactAffine(transform.transform());
  if (product.bits() > longest_entry) return false;
  composed_.push_back({std::move(product), ++last_name_});
  return true;
}

Box BoundsWalk::leave(const Solid& solid, const Level& level) {
  Box box = level.box;
  if (solid.kind() == Kind::transform) {
    if (!level.moves_box) composed_.pop_back();
    present_ = level.outer;
    if (level.moves_box) box = image(box, composed_[present_].world_from_solid * ExactAffine(solid.transform()));
  }
  boxes_.emplace(Key{solid.identity(), composed_[present_].name}, box);
  return box;
}

}  // namespace csgcast::detail
