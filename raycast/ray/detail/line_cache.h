// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <vector>

#include "raycast/line/crossing.h"
#include "raycast/line/interval_list.h"
#include "raycast/scene/leaf_function.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// One ray's crossings with the surfaces of a scene, each computed when first asked for. Turning to another ray costs
/// nothing per surface.
class LineCache final : public LeafLine {
 public:
  LineCache(const Scene& scene, const Predicates& predicates);

  /// Turns to another ray. `departure` is the surface that the ray starts on, and `side` the side that the ray goes to.
  /// The departure is not valid if the ray starts on no surface.
  void begin(const Ray& ray, SurfaceId departure, Sense side);
  const Ray& ray() const override { return line_.ray; }
  /// How far from the surface that it starts on, by definition, the rounded start may be on each axis; 0 for a ray that
  /// departs from none. Boxes count as so much larger: the start lies in that of a needle as well.
  double departure_margin() const { return departure_margin_; }
  /// The number of times that the crossings of a ray and a surface were computed since the cache was made.
  std::uint64_t surface_tests() const { return surface_tests_; }
  /// The decisions that double left open since the cache was made.
  const ExactCalls& exact_calls() const { return exact_calls_; }
  /// The number of rays with such a decision. Rounding of a reported t does not count.
  std::uint64_t rays_flagged() const {
    return rays_flagged_ + (exact_calls_.beyond_double() != calls_at_begin_ ? 1 : 0);
  }

  /// The crossings of the present ray's line with a surface.
  const LineCrossings& found(SurfaceId id) override;
  /// One of these crossings. Its t is off by a few roundings. Precondition: root < found(id).count.
  Crossing crossing(SurfaceId id, std::uint8_t root) override {
    return {finite(line_.in_frame.t(found(id).tau(root))), id, root};
  }
  /// The crossing with the t to report. An end that no surface makes stays as it is.
  Crossing reported(const Crossing& crossing);
  /// The crossing's place in the world, rounded. Precondition: a surface makes it.
  Point point(const Crossing& crossing);
  /// Lower bound on the exact t of a crossing, for culling; for an end that no surface makes, its t itself.
  double earliest(const Crossing& crossing) {
    if (!crossing.surface.valid()) return crossing.t;
    const double off = slack(crossing);
    return std::isinf(off) ? -off : crossing.t - off;  // t may be infinite, too: the crossing is beyond the doubles
  }
  /// Upper bound on the exact t, with the same exception.
  double latest(const Crossing& crossing) {
    if (!crossing.surface.valid()) return crossing.t;
    const double off = slack(crossing);
    return std::isinf(off) ? off : crossing.t + off;
  }

  /// Orders two crossings. Either may be an end that no surface makes, such as an infinite one.
  std::weak_ordering order(const Crossing& a, const Crossing& b) override;
  /// Orders a crossing and a number, which may be infinite.
  std::weak_ordering order(const Crossing& a, double t);
  /// Cuts intervals that lie wholly outside the frame's unit cube out of a list.
  void keep_within_cube(IntervalList& list);
  /// The number of crossings of the surface before `at`, and whether the next one ties with it.
  struct Rank {
    std::uint8_t before = 0;
    bool ties = false;
  };
  Rank rank(SurfaceId id, const Crossing& at);

 private:
  struct Entry {
    std::uint64_t ray_number = 0;  // the number of the ray that the crossings belong to; 0 if there is none
    LineCrossings crossings;
  };
  CrossingView view(const Crossing& crossing) {
    return {crossing.surface, &scene_.surface(crossing.surface), &found(crossing.surface), crossing.root};
  }

  static double finite(double t) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::clamp(t, -most, most);
  }
  // Bound on the error of a crossing's t.
  double slack(const Crossing& crossing) {
    return 2 * found(crossing.surface).error * line_.in_frame.unit + 0x1p-50 * std::fabs(crossing.t);
  }

  const Scene& scene_;
  const Predicates predicates_;
  Line line_;
  double departure_margin_ = 0;
  LineMemory memory_;
  ExactCalls exact_calls_;
  std::uint64_t calls_at_begin_ = 0;
  std::uint64_t rays_flagged_ = 0;
  std::vector<Entry> entries_;
  std::uint64_t ray_number_ = 0;
  std::uint64_t surface_tests_ = 0;
};

}  // namespace csgcast::detail
