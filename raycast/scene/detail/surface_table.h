// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "csg/exact/packed_form.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/kinds.h"
#include "raycast/weld/hash_index.h"
#include "raycast/weld/welder.h"

namespace csgcast::detail {

/// The surfaces of a scene, one for each canonical form. Forms that are multiples of each other share an id. The sign
/// of the factor gives the sense of the half-space.
class SurfaceTable {
 public:
  /// The half-space f <= 0 of a leaf with these bounds. Its surface is added if the table does not have it yet.
  /// Precondition: f is not constant.
  HalfSpace half_space(const QuadricForm& f, const Box& leaf);
  HalfSpace half_space(const OtherForm& f, const Box& leaf);

  std::size_t size() const { return entries_.size(); }
  /// The form, or null if the surface is neither a plane nor a quadric.
  const PackedForm* form(SurfaceId id) const {
    const Entry& entry = entries_[id.index()];
    return entry.other == nullptr ? &entry.form : nullptr;
  }

  /// Says for each surface whether it matters in the frame's cube only (Surface::is_local).
  void set_local(const std::vector<bool>& is_local);

  /// Replaces surface i by replacements[i], for all i. The replacement is surface i itself, or a surface that stays
  /// itself. The remaining ids close up, in the order of first appearance. Returns for each old surface what its
  /// positive side is now.
  std::vector<HalfSpace> merge(std::span<const Replacement> replacements);

  /// Takes all surfaces out, with their floating-point forms in a frame. The table is empty afterwards. Precondition:
  /// one of the kinds takes each of the forms.
  std::vector<Surface> take(const Frame& frame, SurfaceKinds kinds);

 private:
  struct Entry {
    PackedForm form;
    std::shared_ptr<const OtherForm> other;  // set instead, if the surface is neither a plane nor a quadric; else null
    Point near;     // the middle of one leaf that owns the surface; NaN on an axis along which that leaf is unbounded
    bool is_local;  // true if all leaves that own the surface are bounded, or set_local() said so
  };

  template <class Same>
  SurfaceId find_or_add(std::uint64_t hash, Entry entry, Same&& same);

  std::vector<Entry> entries_;
  HashIndex by_form_;
};

}  // namespace csgcast::detail
