// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "raycast/ray/detail/evaluator.h"
#include "raycast/ray/detail/line_cache.h"
#include "raycast/ray/detail/neighbourhood.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Finds the changes of medium along the cache's present ray, from the interval lists of the scene's layers.
class MediumChanges {
 public:
  /// The four arguments must outlive it. Evaluator and neighbourhood must look at the same scene and cache.
  MediumChanges(const Scene& scene, LineCache& cache, Evaluator& evaluator, Neighbourhood& neighbourhood)
      : scene_(scene), cache_(cache), evaluator_(evaluator), neighbourhood_(neighbourhood) {}

  /// Implements Caster::interfaces: the changes in the span, ascending, up to the first one into an opaque solid. The
  /// vector is overwritten.
  void find(Span span, std::vector<Interface>& changes);

 private:
  const Scene& scene_;
  LineCache& cache_;
  Evaluator& evaluator_;
  Neighbourhood& neighbourhood_;
  std::vector<IntervalList> lists_;               // by layer
  std::vector<std::span<const Interval>> spans_;  // the same lists as spans
  std::vector<std::size_t> passed_;               // working memory of the sweep
};

}  // namespace csgcast::detail
