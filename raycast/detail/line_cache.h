// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "raycast/hit.h"
#include "raycast/predicates.h"
#include "raycast/scene.h"

namespace csgcast::detail {

/// One ray's crossings with the surfaces of a scene, each computed when first asked for. Turning to another ray costs
/// nothing per surface.
class LineCache {
 public:
  explicit LineCache(const Scene& scene);

  void begin(const Ray& ray, SurfaceId departure, Sense side);
  const Ray& ray() const { return line_.ray; }
  /// How often a surface was met, and how often exact arithmetic decided, since the cache was made.
  std::uint64_t surface_tests() const { return surface_tests_; }
  std::uint64_t exact_calls() const { return line_.exact_calls; }

  const LineCrossings& found(SurfaceId id);
  Crossing crossing(SurfaceId id, std::uint8_t root) { return {found(id).t[root], id, root}; }

  /// Orders crossings that may be infinite ends (no surface, t = ±infinity).
  std::weak_ordering order(const Crossing& a, const Crossing& b);
  std::weak_ordering order(const Crossing& a, double t);
  /// How many crossings of the surface come before `at`, and whether the next one ties with it.
  struct Rank {
    std::uint8_t before = 0;
    bool ties = false;
  };
  Rank rank(SurfaceId id, const Crossing& at);

 private:
  struct Entry {
    std::uint64_t ray_number = 0;
    LineCrossings crossings;
  };
  CrossingView view(const Crossing& crossing) {
    return {crossing.surface, &scene_.surface(crossing.surface), &found(crossing.surface), crossing.root};
  }

  const Scene& scene_;
  Line line_;
  std::vector<Entry> entries_;
  std::uint64_t ray_number_ = 0;
  std::uint64_t surface_tests_ = 0;
};

}  // namespace csgcast::detail
