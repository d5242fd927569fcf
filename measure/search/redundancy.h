// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "raycast/scene/scene.h"

namespace csgcast {

/// A statement (a leaf, or one that joins solids) without which the solid would be the same.
struct Redundancy {
  enum class Why {
    is_empty,       ///< the statement holds nothing
    has_no_effect,  ///< other solids take its place, or there is nothing to cut
    holds_all,      ///< it is an operand of an intersection, and the others are all within it
  };
  Why why = Why::has_no_effect;
  Node::Op op = Node::Op::leaf;
  std::uint32_t first_leaf = 0;  ///< its leaves are [first_leaf, leaf_end); a leaf has itself only
  std::uint32_t leaf_end = 0;
  Place place;
};

/// The scene text's word for it: `sphere`, `difference`; in code made `a + b` is a union.
const char* word(const Scene& scene, const Redundancy& redundancy);
/// That and where it stands: `sphere at part.csg:3:5`; the word alone if it was made in code.
std::string name_of(const Scene& scene, const Redundancy& redundancy);
/// `without it the shape is the same`.
const char* reason(Redundancy::Why why);

}  // namespace csgcast
