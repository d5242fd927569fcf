// SPDX-License-Identifier: MIT
#include "model/ray_thickness.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/base/error.h"
#include "measure/thickness.h"
#include "raycast/line/ray.h"

namespace csgcast {
namespace {

/// Rays by axis, as ThicknessProbe takes them.
struct RayColumns {
  std::array<std::vector<double>, 6> numbers;

  /// `origins` and `directions`: three numbers a ray. Throws Error naming the ray for one that cannot be cast.
  RayColumns(std::span<const double> origins, std::span<const double> directions) {
    const std::size_t count = origins.size() / 3;
    for (auto& column : numbers) column.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point o{origins[3 * i], origins[3 * i + 1], origins[3 * i + 2]};
      const Vector d{directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]};
      if (!std::isfinite(o.x + o.y + o.z) || !std::isfinite(d.x + d.y + d.z) || d == Vector{} || !Ray::in_range(o, d)) {
        throw Error(ErrorCode::bad_value, {}, fmt::format("ray {} (counted from 0) cannot be cast", i),
                    "its direction is zero, or its numbers are not finite or out of range",
                    "correct the ray or leave it out");
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        numbers[axis][i] = o[axis];
        numbers[3 + axis][i] = d[axis];
      }
    }
  }

  RayArrays part(std::size_t first, std::size_t count) const {
    RayArrays rays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.origin[axis] = std::span(numbers[axis]).subspan(first, count);
      rays.direction[axis] = std::span(numbers[3 + axis]).subspan(first, count);
    }
    return rays;
  }
};

}  // namespace

std::vector<double> ray_thickness(const Cells& cells, const Rays& rays, const QueryOptions& options) {
  if (rays.origins.size() % 3 != 0 || rays.origins.size() != rays.directions.size()) {
    throw Error(ErrorCode::usage, {},
                fmt::format("there are {} coordinates of origins, but {} of directions", rays.origins.size(),
                            rays.directions.size()),
                "each ray has three of either", "give 3 x count numbers of both");
  }
  if (options.span.from != 0 || options.span.to != HUGE_VAL) {
    throw Error(ErrorCode::usage, {}, "thickness on a part of a ray", "rays go from t = 0 to infinity",
                "leave the span as it is");
  }
  const RayColumns columns(rays.origins, rays.directions);
  std::vector<double> result(rays.count());
  constexpr std::size_t run = 2048;
  const std::size_t runs = (result.size() + run - 1) / run;
  ProgressTeller progress(options.progress, runs);
  tbb::enumerable_thread_specific<ThicknessProbe> probes([&] { return ThicknessProbe(cells); });
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t i) {
    const std::size_t first = i * run;
    const std::size_t count = std::min(run, result.size() - first);
    probes.local().first_faces(columns.part(first, count), std::span(result).subspan(first, count));
    progress.step();
  });
  progress.finish();
  return result;
}

}  // namespace csgcast
