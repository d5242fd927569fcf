// SPDX-License-Identifier: MIT
#include "measure/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "csg/base/error.h"
#include "measure/search/body.h"
#include "measure/search/extent.h"
#include "measure/search/refinement.h"
#include "raycast/cells/pieces.h"

namespace csgcast {
namespace {

using detail::Body;
using detail::Totals;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

void check(const MeasureOptions& options) {
  if (options.relative_error > 0 && options.relative_area_error > 0) return;
  throw Error(ErrorCode::bad_value, {}, "the relative error asked for is not positive", "it can only be approached",
              "give a number such as 1e-6");
}

Measures unbounded() {
  Measures m;
  m.is_bounded = m.is_as_asked = false;
  m.volume = m.area = m.mass = {infinity, infinity};
  m.centroid = {none, none, none};
  m.inertia.fill(none);
  m.principal_moments.fill(none);
  m.principal_axes.fill({none, none, none});
  m.principal_angles.fill(infinity);
  m.centroid_error = m.inertia_error = m.principal_error = m.bounds_error = infinity;
  m.bounds = Box::everything();
  return m;
}

/// All but what depends on the density.
Measures shape_of(const Space& space, const Totals& totals) {
  Measures m;
  const double s = space.scale();
  m.volume = detail::scaled(s * s * s, totals.moments.volume, totals.volume_error);
  m.area = detail::scaled(s * s, totals.area, totals.area_error);
  const detail::Extent extent = detail::extent_of(space);
  m.bounds = extent.box;
  m.bounds_error = extent.error;
  m.centroid = {none, none, none};
  m.pieces = totals.pieces;
  m.is_as_asked = totals.is_as_asked;
  return m;
}

/// A part of a call's work, and what is told of it.
struct Stretch {
  ProgressTeller& teller;
  double from = 0;
  double to = 1;

  void operator()(Progress progress) const {
    progress.share = from + (to - from) * progress.share;
    teller.tell(progress);
  }
};

/// A node and its body, nothing of one that may be unbounded.
struct Measurement {
  Measures measures;
  Body body;
};

Measurement measure_node(const Scene& scene, NodeId node, double density, const MeasureOptions& options,
                         const Stretch& stretch) {
  check(options);
  if (!(density >= 0) || std::isinf(density))
    throw Error(ErrorCode::bad_value, {}, "the density is negative or no number", "masses would be so, too",
                "give a positive one");
  const Space space(scene, node);
  if (!space.is_bounded() && !space.is_empty()) return {unbounded(), {}};
  const Totals totals = detail::refine(space, options, stretch);
  Measurement result{shape_of(space, totals), detail::body_of(space, totals, density)};
  detail::tell_mass(scene.frame(), result.body, result.measures);
  return result;
}

/// Of a node less others.
Body body_of_rest(const Scene& scene, NodeId node, std::span<const NodeId> less, double density,
                  const MeasureOptions& options, const Stretch& stretch) {
  const Space space(scene, node, less);
  return detail::body_of(space, detail::refine(space, options, stretch), density);
}

bool may_overlap(const Scene& scene, NodeId a, NodeId b) {
  return !intersection(scene.node(a).box, scene.node(b).box).is_null();
}

/// Whether something is outside every part.
bool has_rest(const Scene& scene) {
  return std::any_of(scene.leaves().begin(), scene.leaves().end(), [](const Leaf& leaf) { return !leaf.part.valid(); });
}

}  // namespace

Measures measure(const Scene& scene, NodeId node, double density, const MeasureOptions& options) {
  ProgressTeller teller(options.progress);
  const Measures measures = measure_node(scene, node, density, options, {teller}).measures;
  teller.finish();
  return measures;
}

SceneMeasures measure(const Scene& scene, const MeasureOptions& options) {
  SceneMeasures result;
  const auto parts = scene.parts();
  const bool has_mass = !parts.empty() && scene.node(scene.root()).box.is_finite();
  ProgressTeller teller(options.progress);
  // Each part and the whole take an equal stretch; half of it what a part adds to the mass, and what is in no part.
  const double step = 1 / (static_cast<double>(parts.size()) + 1);
  double done = 0;
  const auto half = [&] {
    done += step / 2;
    return Stretch{teller, done - step / 2, done};
  };
  Body sum;
  std::vector<NodeId> before;
  for (const Part& part : parts) {
    const Stretch first = half(), second = half();
    const Measurement alone = measure_node(scene, part.node, part.name.density, options, first);
    result.parts.push_back(alone.measures);
    std::vector<NodeId> others;
    for (const NodeId other : before) {
      if (may_overlap(scene, part.node, other)) others.push_back(other);
    }
    before.push_back(part.node);
    if (!has_mass) continue;
    sum += others.empty() ? alone.body : body_of_rest(scene, part.node, others, part.name.density, options, second);
  }
  const Stretch first = half(), second = half();
  if (has_mass) {
    if (has_rest(scene)) sum += body_of_rest(scene, scene.root(), before, 1, options, first);
    const Space whole(scene, scene.root());
    result.whole = shape_of(whole, detail::refine(whole, options, second));
    detail::tell_mass(scene.frame(), sum, result.whole);
  } else {
    result.whole = measure_node(scene, scene.root(), 1, options, {teller, first.from, second.to}).measures;
  }
  teller.finish();
  return result;
}

}  // namespace csgcast
