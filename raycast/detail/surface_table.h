// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "csg/exact/quadric_form.h"
#include "raycast/detail/welder.h"
#include "raycast/scene.h"
#include "raycast/surface.h"

namespace csgcast::detail {

/// The surfaces of a scene, one for each canonical form: proportional forms share an id, and the sign of the factor is
/// the sense.
class SurfaceTable {
 public:
  /// The half-space f <= 0 of a leaf with these bounds. Precondition: f is not constant.
  HalfSpace half_space(const QuadricForm& f, const Box& leaf);

  std::size_t size() const { return entries_.size(); }
  const QuadricForm& form(SurfaceId id) const { return entries_[id.index()].form; }

  /// Makes surfaces one: each becomes replacements[id], which is itself or one that stays. Ids close up in the order of
  /// first appearance. Returns what the positive side of each old surface is now.
  std::vector<HalfSpace> merge(std::span<const Replacement> replacements);

  /// All surfaces with their floating-point forms in a frame. Leaves the table empty.
  std::vector<Surface> take(const Frame& frame);

 private:
  struct Entry {
    QuadricForm form;
    Box leaf;       // of one leaf that owns the surface
    bool is_local;  // all such leaves are bounded
  };
  std::vector<Entry> entries_;
  std::unordered_multimap<std::size_t, SurfaceId> by_hash_;
};

}  // namespace csgcast::detail
