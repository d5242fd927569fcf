// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <list>

#include "csg/solid/solid.h"

namespace csgcast::detail {

/// A simplified solid that its parent may still take apart. A Boolean operator stays an open list until it is known
/// that the parent is not the same operator. So flattening a chain of any shape takes time linear in its length.
/// Complements are kept separately, so that two cancel.
///
/// A named part is never dropped. If one is below, nothing is absorbed.
class GrowingSolid {
 public:
  GrowingSolid() = default;  ///< the empty solid
  /// A finished solid; `has_part` tells whether a named part is in it.
  GrowingSolid(Solid solid, bool has_part) : solid_(std::move(solid)), has_part_(has_part) {}

  bool has_part() const { return has_part_; }
  /// True if this is a finished solid of that kind.
  bool is(Solid::Kind kind) const { return !is_open_ && !negated_ && solid_.kind() == kind; }

  /// Appends the next child of the Boolean operator that grows into this solid. Children come in order; a child that
  /// changes nothing is dropped. Preconditions: `origin` is the node of that operator and outlives this, and `index` is
  /// the child's place in it.
  void append(const Solid& origin, std::size_t index, GrowingSolid child);
  /// Call this after the last child. If one child absorbs all others, it takes over.
  void close(const Solid& origin);
  /// The complement; `origin` is the node that asks for it and outlives this.
  GrowingSolid complemented(const Solid& origin) &&;
  /// The solid; nodes that did not change are the original ones.
  Solid finished() &&;

 private:
  bool opens_as(Solid::Kind kind) const { return is_open_ && !negated_ && kind_ == kind; }
  void open_as(const Solid& origin);
  Solid finished_list();

  Solid solid_;                // unless open
  std::list<Solid> children_;  // if open: of an operator of this kind
  Solid::Kind kind_ = Solid::Kind::unite;
  bool is_open_ = false;
  bool is_started_ = false;   // true if a child was appended
  bool is_absorbed_ = false;  // true if a child decided the result
  bool negated_ = false;
  bool has_part_ = false;
  const Solid* origin_ = nullptr;             // of the open operator
  const Solid* complement_origin_ = nullptr;  // if negated
};

}  // namespace csgcast::detail
