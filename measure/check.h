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
  Measured volume;  ///< volume of the shared space; infinite if both parts may be unbounded
  Point witness;    ///< a place in both, rounded; a ray through it is certainly inside both at once
};

/// Two parts that may share space, but so little that it cannot be told from touching.
struct Contact {
  PartId first;
  PartId second;
  double most = 0;  ///< upper bound on the shared volume
};

/// Lists what may be wrong with a solid.
struct CheckReport {
  std::vector<Overlap> overlaps;
  std::vector<Contact> undecided;  ///< pairs for which neither overlap nor the lack of it was shown
  std::vector<PartId> unbounded;   ///< parts that may be unbounded
  std::vector<PartId> empty;       ///< parts without an inside
  /// Statements without which, one at a time, the solid would be the same. They are in file order, and none is within
  /// another.
  std::vector<Redundancy> redundant;
  std::size_t not_asked = 0;  ///< statements that were not tested, being among hundreds of others in their place
  bool is_unbounded = false;  ///< true if the whole solid may be unbounded
  bool is_empty = false;
  bool looked_for_redundancy = true;  ///< false if there are too many leaves for that search
};

struct CheckOptions {
  std::size_t most_leaves = 1'000'000;  ///< a scene with more leaves is not searched for redundant statements, because
                                        ///< each leaf takes a search
  ProgressCallback progress{};
};

/// Overlaps are decided by certified rays. An overlap is reported exactly if a ray was found that is inside both parts
/// at once. Parts whose faces only touch, or coincide, share nothing. Each redundancy is proved. A statement that may
/// have an unbounded effect, or that meets the boxes of hundreds of others, is never reported as redundant. Throws
/// Cancelled.
CheckReport check(const Scene& scene, const CheckOptions& options = {});

}  // namespace csgcast
