// SPDX-License-Identifier: MIT
#include "csg/solid/detail/growing_solid.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "csg/base/precondition.h"

namespace csgcast::detail {
namespace {

using Kind = Solid::Kind;

// True if an empty or full child changes nothing in the operator.
bool changes_nothing(Kind op, std::size_t index, const GrowingSolid& child) {
  if (op == Kind::intersect) return child.is(Kind::everything);
  return child.is(Kind::empty) && (op == Kind::unite || index > 0);
}

bool decides_all(Kind op, std::size_t index, const GrowingSolid& child) {
  if (op == Kind::intersect || (op == Kind::subtract && index == 0)) return child.is(Kind::empty);
  return child.is(Kind::everything);
}

// The operator of a child that may hand its own children to the parent.
Kind splices_from(Kind op) { return op == Kind::subtract ? Kind::unite : op; }

Solid made(Kind op, std::vector<Solid> children) {
  switch (op) {
    case Kind::unite:
      return unite(std::move(children));
    case Kind::intersect:
      return intersect(std::move(children));
    default:
      return subtract(std::move(children));
  }
}

bool has_children(const Solid& solid, const std::list<Solid>& children) {
  const auto original = solid.children();
  return std::equal(original.begin(), original.end(), children.begin(), children.end(),
                    [](const Solid& a, const Solid& b) { return a.identity() == b.identity(); });
}

}  // namespace

void GrowingSolid::append(const Solid& origin, std::size_t index, GrowingSolid child) {
  CSGCAST_PRECONDITION(index < origin.children().size());
  const Kind op = origin.kind();
  if (changes_nothing(op, index, child)) return;
  const bool decides = is_absorbed_ || decides_all(op, index, child);
  if (!is_started_) {
    *this = std::move(child);
  } else {
    open_as(origin);
    has_part_ = has_part_ || child.has_part_;
    if (child.opens_as(splices_from(op))) {
      children_.splice(children_.end(), child.children_);
    } else {
      children_.push_back(std::move(child).finished());
    }
  }
  is_started_ = true;
  is_absorbed_ = decides;
}

// Continues from a first child with the same operator. Any other child becomes the first of a new list.
void GrowingSolid::open_as(const Solid& origin) {
  if (!opens_as(origin.kind())) {
    Solid first = std::move(*this).finished();
    children_.clear();
    children_.push_back(std::move(first));
    solid_ = Solid();
    kind_ = origin.kind();
    is_open_ = true;
    negated_ = false;
  }
  origin_ = &origin;
}

void GrowingSolid::close(const Solid& origin) {
  const bool is_union = origin.kind() == Kind::unite;
  if (!is_started_) {  // every child changed nothing
    *this = GrowingSolid(is_union ? Solid() : Solid::everything(), false);
  } else if (is_absorbed_ && !has_part_) {
    *this = GrowingSolid(is_union ? Solid::everything() : Solid(), false);
  }
  is_started_ = false;
  is_absorbed_ = false;
}

GrowingSolid GrowingSolid::complemented(const Solid& origin) && {
  if (is(Kind::empty)) return {Solid::everything(), false};
  if (is(Kind::everything)) return {Solid(), false};
  if (!has_part_ && is(Kind::complement)) return {solid_.children()[0], false};
  negated_ = !negated_;
  complement_origin_ = &origin;
  if (!has_part_) return std::move(*this);
  return {std::move(*this).finished(), true};  // a part keeps both of two complements above it
}

Solid GrowingSolid::finished() && {
  Solid inner = is_open_ ? finished_list() : std::move(solid_);
  if (!negated_) return inner;
  const Solid& origin = *complement_origin_;
  if (origin.children()[0].identity() == inner.identity()) return origin;
  return complement(std::move(inner)).at(origin.place());
}

Solid GrowingSolid::finished_list() {
  if (has_children(*origin_, children_)) return *origin_;
  std::vector<Solid> children(std::make_move_iterator(children_.begin()), std::make_move_iterator(children_.end()));
  return made(kind_, std::move(children)).at(origin_->place());
}

}  // namespace csgcast::detail
