// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/leaf_builder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "csg/solid/bounds.h"
#include "raycast/scene/detail/formula_function.h"

namespace csgcast::detail {
namespace {

// If coordinates and sizes are in this range, nothing in the engine overflows or underflows.
constexpr double greatest = 0x1p400;
constexpr double least = 0x1p-400;

// `is_bounded` says that the solid is bounded. Then an infinite side of its box means that the box overflowed.
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

}  // namespace

std::optional<Box> LeafBuilder::add(const Solid& solid, const Placement& placement, Leaf leaf) {
  static const ExactAffine identity;
  const ExactAffine* moved = placement.world_from_solid.get();
  const Box box = world_bounds(solid.shape(), moved ? *moved : identity);
  check_range(box, solid.shape().bounds.is_finite(), solid.place());
  leaf.first = static_cast<std::uint32_t>(tables_.half_spaces.size());
  leaf.function = function_of(solid.shape());
  const bool has_inside = add_half_spaces(solid, placement, leaf, box);
  if (!has_inside || box.is_null()) {
    tables_.half_spaces.resize(leaf.first);
    return std::nullopt;
  }
  tables_.leaves.push_back(std::move(leaf));
  if (box.is_finite()) tables_.bounded_leaves = hull(tables_.bounded_leaves, box);
  return box;
}

// Copies of a solid share their function. The result is null if the leaf is the intersection of its half-spaces.
const LeafFunction* LeafBuilder::function_of(const LeafShape& shape) {
  if (shape.inside == nullptr) return nullptr;
  const auto [it, is_new] = functions_.try_emplace(shape.inside.get(), nullptr);
  if (is_new) it->second = tables_.functions.emplace_back(std::make_shared<FormulaFunction>(shape.inside)).get();
  return it->second;
}

// Returns false if the leaf is an intersection that already has the other side of the surface: then it has no inside.
// For a truth function every half-space is kept in its place.
bool LeafBuilder::add_half_space(const HalfSpace& half_space, const Leaf& leaf) {
  if (leaf.function == nullptr) {
    const auto begin = tables_.half_spaces.begin() + static_cast<std::ptrdiff_t>(leaf.first);
    const auto same = std::find_if(begin, tables_.half_spaces.end(),
                                   [&](const HalfSpace& other) { return other.surface == half_space.surface; });
    if (same != tables_.half_spaces.end()) return same->sense == half_space.sense;
  }
  tables_.half_spaces.push_back(half_space);
  return true;
}

// Returns false if the leaf has no inside.
bool LeafBuilder::add_half_spaces(const Solid& solid, const Placement& placement, Leaf& leaf, const Box& box) {
  const LeafShape& shape = solid.shape();
  std::optional<FormMover> mover;
  if (placement.world_from_solid) mover.emplace(*placement.world_from_solid);
  const std::uint32_t source = origins_ ? origins_->provenance.add_leaf(solid, placement.chain, box) : 0;
  for (std::uint32_t i = 0; i < shape.forms.size(); ++i) {
    const QuadricForm form = shape.forms[i];
    const HalfSpace half_space = surfaces_.half_space(mover ? mover->moved(form) : form, box);
    if (origins_) origins_->ownerships.push_back({half_space.surface, {source, i}});
    if (!add_half_space(half_space, leaf)) return false;
  }
  for (const std::shared_ptr<const OtherForm>& form : shape.others) {
    const auto moved = placement.world_from_solid ? form->moved(*placement.world_from_solid) : form;
    if (!add_half_space(surfaces_.half_space(*moved, box), leaf)) return false;
  }
  leaf.count = static_cast<std::uint32_t>(tables_.half_spaces.size()) - leaf.first;
  return true;
}

}  // namespace csgcast::detail
