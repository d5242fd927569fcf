// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/detail/neighbourhood.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Tells where a hit of the cache's present ray belongs: leaf, region, part, look and normal.
class Attributor {
 public:
  /// The three must outlive it. The neighbourhood must look at the same scene and cache.
  Attributor(const Scene& scene, LineCache& cache, Neighbourhood& neighbourhood)
      : scene_(scene), cache_(cache), neighbourhood_(neighbourhood) {}

  /// Implements Caster::attribute: describes the hit as a boundary crossing of a node. Throws Error(usage) if the node
  /// has no boundary there.
  Attribution attribute(NodeId node, const Hit& hit);
  /// Implements Caster::look_inside: the look of what is inside the node next to the hit. It is not valid if there is
  /// none.
  LookId look_inside(NodeId node, const Hit& hit);

 private:
  const Scene& scene_;
  LineCache& cache_;
  Neighbourhood& neighbourhood_;
};

}  // namespace csgcast::detail
