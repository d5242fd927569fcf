// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/tree_walk.h"
#include "csg/exact/affine.h"
#include "csg/solid/bounds.h"
#include "csg/solid/solid.h"

namespace csgcast::detail {

/// Finds the box of every node in world coordinates, in one walk over a tree from the bottom up. A node that is met
/// again under the same composed transform is not walked again. If exact composition would cost too much (thousands of
/// nested transforms), the box of the solids below is moved instead of the leaves. This is looser, but the cost of a
/// level stays the same.
class BoundsWalk {
 public:
  BoundsWalk();
  Box bounds_of(const Solid& root);

 private:
  struct Composed {
    ExactAffine world_from_solid;
    std::uint64_t name = 0;  // unlike its place in the stack, this number is never used again
  };
  struct Level {
    Box box;  // of the children so far
    bool intersects = false;
    bool moves_box = false;  // true for a transform that was not composed with those around it
    std::size_t outer = 0;   // the composed transform around the node, in composed_

    void add(const Box& child) { box = intersects ? intersection(box, child) : hull(box, child); }
  };
  using Key = std::pair<const void*, std::uint64_t>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return std::hash<const void*>()(key.first) ^ static_cast<std::size_t>(key.second * 0x9e3779b97f4a7c15u);
    }
  };

  std::optional<Box> known_box(const Solid& solid) const;
  Level enter(const Solid& solid);
  bool may_compose(const Solid& transform);
  bool compose(const Solid& transform);
  Box leave(const Solid& solid, const Level& level);

  std::vector<Composed> composed_;  // the first is the identity
  std::size_t present_ = 0;         // the index of the transform that leaves are now under
  std::uint64_t last_name_ = 0;
  std::unordered_set<const void*> entered_;  // the transforms met so far
  std::size_t repetitions_ = 0;              // the number of transforms that were met again, under another transform
  std::unordered_map<Key, Box, KeyHash> boxes_;
};

}  // namespace csgcast::detail
