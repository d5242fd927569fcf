// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "tests/stress/families.h"

namespace csgcast::bench {

/// The first hit of one ray, as exact arithmetic has it.
struct FirstHit {
  std::optional<double> t;
  /// False where a ray starts on the solid or nearer to its first hit than a thousandth of the scene: other programs
  /// leave such hits out on purpose.
  bool is_compared = true;
  /// Whether the ray, moved sideways by 1e-9 of the scene's size, any of four ways, hits the same (is_same_hit): so no
  /// edge, silhouette or tie decides what it hits.
  bool is_clear = true;
};

/// One scene of a family, its rays, and the right answers.
struct Sample {
  Solid solid;
  std::vector<Ray> rays;
  std::unique_ptr<const Scene> scene;
  double size = 1;                   ///< the diagonal of the box of the bounded leaves, or 1 if there are none
  std::vector<IntervalList> lists;   ///< of each ray, from t = 0 on
  std::vector<FirstHit> first_hits;  ///< of each ray, from t = 0 on
  double exact_list_seconds = 0;     ///< what exact arithmetic took for all lists, once
  double exact_first_seconds = 0;    ///< and for all first hits

  /// The scene's size in units of a ray's t.
  double size_along(const Ray& ray) const { return size / length(ray.direction()); }
};

/// Scenes of a family until there are `rays` rays or more; the same ones for the same numbers.
std::vector<Sample> make_samples(const stress::Family& family, int rays, int rays_per_scene);

}  // namespace csgcast::bench
