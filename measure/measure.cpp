// SPDX-License-Identifier: MIT
#include "measure/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/error.h"
#include "measure/detail/body.h"
#include "measure/detail/extent.h"
#include "measure/detail/refinement.h"
#include "raycast/pieces.h"

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
  m.centroid_error = m.inertia_error = m.bounds_error = infinity;
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

/// A node less others; its body is added to `sum`.
Measures measure_body(const Space& space, double density, const MeasureOptions& options, Body& sum) {
  const Totals totals = detail::refine(space, options);
  const Body body = detail::body_of(space, totals, density);
  sum += body;
  Measures result = shape_of(space, totals);
  detail::tell_mass(space.scene().frame(), body, result);
  return result;
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
  check(options);
  if (!(density >= 0) || std::isinf(density))
    throw Error(ErrorCode::bad_value, {}, "the density is negative or no number", "masses would be so, too",
                "give a positive one");
  const Space space(scene, node);
  if (!space.is_bounded() && !space.is_empty()) return unbounded();
  Body body;
  return measure_body(space, density, options, body);
}

SceneMeasures measure(const Scene& scene, const MeasureOptions& options) {
  check(options);
  SceneMeasures result;
  const auto parts = scene.parts();
  for (const Part& part : parts) result.parts.push_back(measure(scene, part.node, part.name.density, options));
  if (parts.empty() || !scene.node(scene.root()).box.is_finite()) {
    result.whole = measure(scene, scene.root(), 1, options);
    return result;
  }
  const Space whole(scene, scene.root());
  const Totals totals = detail::refine(whole, options);
  result.whole = shape_of(whole, totals);
  Body sum;
  std::vector<NodeId> before;
  for (const Part& part : parts) {
    std::vector<NodeId> others;
    for (const NodeId other : before) {
      if (may_overlap(scene, part.node, other)) others.push_back(other);
    }
    before.push_back(part.node);
    if (!scene.node(part.node).box.is_null())
      measure_body(Space(scene, part.node, others), part.name.density, options, sum);
  }
  if (has_rest(scene)) measure_body(Space(scene, scene.root(), before), 1, options, sum);
  detail::tell_mass(scene.frame(), sum, result.whole);
  return result;
}

}  // namespace csgcast
