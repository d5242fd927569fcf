// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "csg/base/ids.h"
#include "csg/base/progress.h"
#include "csg/base/vector.h"
#include "measure/search/redundancy.h"
#include "measure/sheet/measures.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// Two parts that share space.
struct Overlap {
  PartId first;  ///< in file order
  PartId second;
  Measured volume;  ///< of what they share; infinite if both may be unbounded
  Point witness;    ///< a place in both, rounded: a ray through it is inside both at once, exactly
};

/// Two parts that may share space so little that it could not be told from touching.
struct Contact {
  PartId first;
  PartId second;
  double most = 0;  ///< of the shared volume
};

/// What may be wrong with a solid.
struct CheckReport {
  std::vector<Overlap> overlaps;
  std::vector<Contact> undecided;  ///< neither shown to overlap nor not to
  std::vector<PartId> unbounded;   ///< that may be
  std::vector<PartId> empty;       ///< without an inside
  /// The solid would be the same without these, one at a time: in file order, none within another.
  std::vector<Redundancy> redundant;
  std::size_t not_asked = 0;  ///< statements of which that was not asked: among hundreds of others in their place
  bool is_unbounded = false;  ///< the whole solid may be
  bool is_empty = false;
  bool looked_for_redundancy = true;  ///< false: there are too many leaves
};

struct CheckOptions {
  std::size_t most_leaves = 1'000'000;  ///< with more it is not looked for what is redundant, which takes a search each
  ProgressCallback progress{};
};

/// Overlaps are decided by certified rays: one is reported exactly if a ray was found on which both parts are inside at
/// once. Parts whose faces only touch, or coincide, share nothing. What is redundant is proved; of what may have an
/// unbounded effect, or meets the boxes of hundreds of others, nothing is. Throws Cancelled.
CheckReport check(const Scene& scene, const CheckOptions& options = {});

}  // namespace csgcast
