// SPDX-License-Identifier: MIT
#include "measure/section.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "csg/exact/quadric_form.h"
#include "measure/search/refinement.h"
#include "measure/section/section_arcs.h"
#include "raycast/cells/pieces.h"

namespace csgcast {
namespace {

using detail::Arc;
using detail::Planar;

void check(const Plane& plane) {
  const bool is_sound = is_finite(plane.normal) && longest(plane.normal) > 0 && std::isfinite(plane.distance);
  if (is_sound) return;
  throw Error(ErrorCode::bad_value, {}, "the plane has a normal that is zero, or numbers that are none",
              "it does not say where to cut", "give nx,ny,nz,d such as 0,0,1,2.5");
}

/// From the coordinates of the space of a section to those of its plane.
class PlaneFrame {
 public:
  PlaneFrame(const Space& space, const Plane& plane, Section& section) : scale_(space.scale()) {
    const auto axes = space.axes();
    section.u = axes[0];
    section.v = axes[1];
    const Vector unit = normalised(plane.normal);
    const double away = plane.distance / length(plane.normal);
    section.origin = {away * unit.x, away * unit.y, away * unit.z};
    const Vector center = space.scene().frame().center - section.origin;
    u_ = dot(center, axes[0]);
    v_ = dot(center, axes[1]);
  }

  PlanePoint operator()(const Planar& p) const { return {u_ + scale_ * p[0], v_ + scale_ * p[1]}; }

  /// A form of the space, in the plane's coordinates, its greatest coefficient 1.
  std::array<double, 6> conic(const CellForm& form) const {
    using Form = QuadricForm;
    const double s = 1 / scale_;
    const double u0 = u_ + scale_ * form.center.x;
    const double v0 = v_ + scale_ * form.center.y;
    const double a = form.c[Form::xx] * s * s, b = form.c[Form::xy] * s * s, c = form.c[Form::yy] * s * s;
    const double d = form.c[Form::x] * s, e = form.c[Form::y] * s;
    std::array<double, 6> result{a,
                                 b,
                                 c,
                                 d - 2 * a * u0 - b * v0,
                                 e - 2 * c * v0 - b * u0,
                                 form.c[Form::one] + (a * u0 + b * v0 - d) * u0 + (c * v0 - e) * v0};
    double greatest = 0;
    for (const double x : result) greatest = std::fmax(greatest, std::fabs(x));
    for (double& x : result) x /= greatest;
    return result;
  }

 private:
  double scale_, u_, v_;
};

Section cut(const Scene& scene, const Plane& plane, const SectionOptions& options, ProgressTeller& teller) {
  const Space whole(scene);
  Section result;
  if (!whole.is_bounded() && !whole.is_empty()) {
    result.is_bounded = false;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    result.area = result.perimeter = {infinity, infinity};
    return result;
  }
  if (whole.is_empty()) return result;
  const Space space = whole.section(plane.normal, plane.distance);
  MeasureOptions job;
  job.relative_error = job.relative_area_error = options.relative_error;
  job.most_pieces = options.most_pieces;
  // The arcs are taken for half of the work; how far they are is not known.
  const auto tell = [&](double share) { teller.tell({share, {}}); };
  const detail::Totals totals = detail::refine(space, job, [&](const Progress& now) { tell(0.5 * now.share); });
  const double s = space.scale();
  // Its height is 1: what is a volume there is an area here, an area a length.
  result.area = detail::scaled(s * s, totals.moments.volume, totals.volume_error);
  result.perimeter = detail::scaled(s, totals.area, totals.area_error);
  const detail::ArcTrace trace = detail::trace_arcs(space, options.most_pieces, [&] { tell(0.5); });
  const PlaneFrame frame(space, plane, result);
  const detail::JoinedArcs joined = detail::join_arcs(trace);
  result.is_closed = joined.is_closed;
  for (const std::vector<Arc>& arcs : joined.loops) {
    SectionLoop loop;
    for (const Arc& arc : arcs)
      loop.push_back({frame.conic(space.form(arc.surface)), frame(arc.from), frame(arc.middle), frame(arc.to),
                      SurfaceId(arc.surface)});
    result.loops.push_back(std::move(loop));
  }
  const double off = s * (joined.widest_corner + trace.displaced + 0x1p-40) + 0x1p-50 * longest(scene.frame().center);
  if (!result.loops.empty()) result.place_error = off;
  return result;
}

}  // namespace

Section section(const Scene& scene, const Plane& plane, const SectionOptions& options) {
  check(plane);
  ProgressTeller teller(options.progress);
  Section result = cut(scene, plane, options, teller);
  teller.finish();
  return result;
}

void require_bounded(const Section& section) {
  if (section.is_bounded) return;
  throw Error(ErrorCode::usage, {}, "there is no picture of the section", "the solid may be unbounded",
              "intersect it with a box, or take parts of it alone");
}

}  // namespace csgcast
