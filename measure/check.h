// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "csg/ids.h"
#include "csg/vector.h"
#include "measure/measure.h"
#include "raycast/scene.h"

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
  std::vector<Contact> undecided;      ///< neither shown to overlap nor not to
  std::vector<PartId> unbounded;       ///< that may be
  std::vector<PartId> empty;           ///< without an inside
  std::vector<LeafId> without_effect;  ///< the solid would be the same without them, one at a time
  bool is_unbounded = false;           ///< the whole solid may be
  bool is_empty = false;
  bool looked_at_leaves = true;  ///< false: there are too many
};

struct CheckOptions {
  std::size_t most_leaves =
      20'000;  ///< more are not searched for those without effect, which takes time by their square
  /// Called now and then with the share done; false: enough. May be empty.
  std::function<bool(double)> goes_on;
};

/// Overlaps are decided by certified rays: one is reported exactly if a ray was found on which both parts are inside at
/// once. Parts whose faces only touch, or coincide, share nothing. Unbounded leaves are never among those without
/// effect.
CheckReport check(const Scene& scene, const CheckOptions& options = {});

}  // namespace csgcast
