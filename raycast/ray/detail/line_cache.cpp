// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/line_cache.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"

namespace csgcast::detail {

LineCache::LineCache(const Scene& scene, const Predicates& predicates)
    : scene_(scene), predicates_(predicates), line_(Ray({}, {0, 0, 1}), scene.frame()) {}

void LineCache::begin(const Ray& ray, SurfaceId departure, Sense side) {
  // The memory is taken only now, because many casters never get a ray.
  if (entries_.empty()) entries_.resize(scene_.surfaces().size());
  line_ = Line(ray, scene_.frame(), departure, side);
  line_.memory = &memory_;
  // Places are a few roundings off, of their coordinates and of the scene's size.
  departure_margin_ =
      departure.valid() ? 0x1p-40 * (longest(ray.origin() - Point{}) + std::ldexp(1.0, scene_.frame().exponent)) : 0;
  memory_.forget();
  rays_flagged_ = rays_flagged();
  calls_at_begin_ = exact_calls_.beyond_double();
  ++ray_number_;
}

const LineCrossings& LineCache::found(SurfaceId id) {
  Entry& entry = entries_[id.index()];
  if (entry.ray_number != ray_number_) {
    entry.crossings = predicates_.crossings(line_, id, scene_.surface(id), exact_calls_);
    entry.ray_number = ray_number_;
    ++surface_tests_;
  }
  return entry.crossings;
}

Crossing LineCache::reported(const Crossing& crossing) {
  if (!crossing.surface.valid()) return crossing;
  return {predicates_.reported_t(line_, view(crossing), exact_calls_), crossing.surface, crossing.root};
}

Point LineCache::point(const Crossing& crossing) {
  CSGCAST_PRECONDITION(crossing.surface.valid());
  // Without a bounded leaf the frame is the world's own. Its center is then no nearer to the place than the ray's
  // start.
  if (!scene_.bounded_leaves().is_finite()) return line_.ray.at(crossing.t);
  const LineFrame& line = line_.in_frame;
  const double tau = found(crossing.surface).tau(crossing.root);
  const Frame& frame = scene_.frame();
  Point p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double q = line.near[axis] + (line.near_low[axis] + tau * line.direction[axis]);
    p[axis] = frame.center[axis] + std::ldexp(q, frame.exponent);
  }
  return p;
}

std::weak_ordering LineCache::order(const Crossing& a, const Crossing& b) {
  if (!a.surface.valid() && !b.surface.valid()) {
    return a.t < b.t   ? std::weak_ordering::less
           : a.t > b.t ? std::weak_ordering::greater
                       : std::weak_ordering::equivalent;
  }
  if (!b.surface.valid()) return order(a, b.t);
  if (!a.surface.valid()) return 0 <=> order(b, a.t);
  return predicates_.order(line_, view(a), view(b), exact_calls_);
}

std::weak_ordering LineCache::order(const Crossing& a, double t) {
  if (!a.surface.valid()) {
    return a.t < t ? std::weak_ordering::less : a.t > t ? std::weak_ordering::greater : std::weak_ordering::equivalent;
  }
  return predicates_.order_with(line_, view(a), t, exact_calls_);
}

// With knows_cube, tau of the closest approach to the frame's center is off by less than 1/4, and so is each coordinate
// of the place there. The cube's corners are less than 0.87 from its center, and so is the way to them in tau.
void LineCache::keep_within_cube(IntervalList& list) {
  const LineFrame& line = line_.in_frame;
  if (!line.knows_cube || list.empty()) return;
  constexpr double far = 2;
  const double approach = -dot(line.near, line.direction) * line.inverse_squared;
  if (!(longest(line.near + approach * line.direction) <= far)) return list.clear();
  const auto order = [&](const Crossing& at, double tau) {
    if (!at.surface.valid()) return at.t < 0 ? std::weak_ordering::less : std::weak_ordering::greater;  // infinite
    return predicates_.order_in_frame(line_, view(at), tau, exact_calls_);
  };
  std::erase_if(list, [&](const Interval& interval) {
    return order(interval.entry, approach + far) > 0 || order(interval.exit, approach - far) < 0;
  });
}

LineCache::Rank LineCache::rank(SurfaceId id, const Crossing& at) {
  const LineCrossings& list = found(id);
  Rank rank;
  for (std::uint8_t root = 0; root < list.count; ++root) {
    const auto side = order(crossing(id, root), at);
    if (side > 0) break;
    if (side == 0) {
      rank.ties = true;
      break;
    }
    ++rank.before;
  }
  return rank;
}

}  // namespace csgcast::detail
