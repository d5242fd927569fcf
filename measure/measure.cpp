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

/// A node and its body, nothing of one that may be unbounded.
struct Measurement {
  Measures measures;
  Body body;
};

Measurement measure_node(const Scene& scene, NodeId node, double density, const MeasureOptions& options) {
  check(options);
  if (!(density >= 0) || std::isinf(density))
    throw Error(ErrorCode::bad_value, {}, "the density is negative or no number", "masses would be so, too",
                "give a positive one");
  const Space space(scene, node);
  if (!space.is_bounded() && !space.is_empty()) return {unbounded(), {}};
  const Totals totals = detail::refine(space, options);
  Measurement result{shape_of(space, totals), detail::body_of(space, totals, density)};
  detail::tell_mass(scene.frame(), result.body, result.measures);
  return result;
}

/// Of a node less others.
Body body_of_rest(const Scene& scene, NodeId node, std::span<const NodeId> less, double density,
                  const MeasureOptions& options) {
  const Space space(scene, node, less);
  return detail::body_of(space, detail::refine(space, options), density);
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
  return measure_node(scene, node, density, options).measures;
}

SceneMeasures measure(const Scene& scene, const MeasureOptions& options) {
  SceneMeasures result;
  const auto parts = scene.parts();
  const bool has_mass = !parts.empty() && scene.node(scene.root()).box.is_finite();
  Body sum;
  std::vector<NodeId> before;
  for (const Part& part : parts) {
    const Measurement alone = measure_node(scene, part.node, part.name.density, options);
    result.parts.push_back(alone.measures);
    std::vector<NodeId> others;
    for (const NodeId other : before) {
      if (may_overlap(scene, part.node, other)) others.push_back(other);
    }
    before.push_back(part.node);
    if (!has_mass) continue;
    sum += others.empty() ? alone.body : body_of_rest(scene, part.node, others, part.name.density, options);
  }
  if (!has_mass) {
    result.whole = measure(scene, scene.root(), 1, options);
    return result;
  }
  if (has_rest(scene)) sum += body_of_rest(scene, scene.root(), before, 1, options);
  const Space whole(scene, scene.root());
  result.whole = shape_of(whole, detail::refine(whole, options));
  detail::tell_mass(scene.frame(), sum, result.whole);
  return result;
}

}  // namespace csgcast
