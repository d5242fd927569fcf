// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <vector>

#include "raycast/line/crossing.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// One ray's crossings with the surfaces of a scene, each computed when first asked for. Turning to another ray costs
/// nothing per surface.
class LineCache {
 public:
  LineCache(const Scene& scene, const Predicates& predicates);

  void begin(const Ray& ray, SurfaceId departure, Sense side);
  const Ray& ray() const { return line_.ray; }
  /// How often a surface was met, how often exact arithmetic decided, and for how many rays it had to, since the cache
  /// was made.
  std::uint64_t surface_tests() const { return surface_tests_; }
  const ExactCalls& exact_calls() const { return exact_calls_; }
  std::uint64_t rays_flagged() const {
    return rays_flagged_ + (exact_calls_.beyond_double() != calls_at_begin_ ? 1 : 0);
  }

  const LineCrossings& found(SurfaceId id);
  Crossing crossing(SurfaceId id, std::uint8_t root) {
    return {finite(line_.in_frame.t(found(id).tau(root))), id, root};
  }
  /// The crossing with the t to report.
  Crossing reported(const Crossing& crossing);
  /// Its place in the world, rounded. Precondition: a surface makes it.
  Point point(const Crossing& crossing);
  /// Numbers that no exact t of a crossing is below, or above; of an infinite end, itself. For culling.
  double earliest(const Crossing& crossing) {
    if (!crossing.surface.valid()) return crossing.t;
    const double off = slack(crossing);
    return std::isinf(off) ? -off : crossing.t - off;  // t may be infinite, too: it lies beyond the doubles
  }
  double latest(const Crossing& crossing) {
    if (!crossing.surface.valid()) return crossing.t;
    const double off = slack(crossing);
    return std::isinf(off) ? off : crossing.t + off;
  }

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

  static double finite(double t) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::clamp(t, -most, most);
  }
  double slack(const Crossing& crossing) {
    return 2 * found(crossing.surface).error * line_.in_frame.unit + 0x1p-50 * std::fabs(crossing.t);
  }

  const Scene& scene_;
  const Predicates predicates_;
  Line line_;
  LineMemory memory_;
  ExactCalls exact_calls_;
  std::uint64_t calls_at_begin_ = 0;
  std::uint64_t rays_flagged_ = 0;
  std::vector<Entry> entries_;
  std::uint64_t ray_number_ = 0;
  std::uint64_t surface_tests_ = 0;
};

}  // namespace csgcast::detail
