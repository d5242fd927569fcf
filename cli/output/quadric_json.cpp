// SPDX-License-Identifier: MIT
#include "cli/output/quadric_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "cli/output/scene_summary.h"
#include "csg/exact/quadric_kind.h"

namespace csgcast::cli {
namespace {

/// Infinite ones become null; all of them none: no member.
void json_numbers(Json& json, const char* name, std::span<const double> numbers, double factor = 1) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); })) return;
  json.key(name).begin_array();
  for (const double x : numbers) json.value(factor * x);
  json.end_array();
}

void json_quadric(Json& json, std::uint64_t surface, const QuadricShape& shape) {
  constexpr double degree = 180 / std::numbers::pi;
  json.begin_object(Json::Layout::compact).member("surface", surface).member("kind", word(shape.kind));
  if (shape.kind != QuadricKind::none) {
    json.member("center", shape.center).key("axes").begin_array();
    for (const Vector& axis : shape.axes) json.value(axis);
    json.end_array();
    json_numbers(json, "axes_error", shape.axes_error, degree);
    json_numbers(json, "semi_axes", shape.semi_axes);
    json_numbers(json, "half_angles", shape.half_angles, degree);
    json_numbers(json, "focal_lengths", shape.focal_lengths);
    json.member("relative_error", shape.relative_error);
  }
  json.end_object();
}

}  // namespace

void json_quadrics(Json& json, const Scene& scene) {
  json.key("quadrics").begin_array();
  const auto surfaces = scene.surfaces();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (is_quadric(surfaces[i])) json_quadric(json, i, shape_of_quadric(surfaces[i].exact.unpacked()));
  }
  json.end_array();
}

}  // namespace csgcast::cli
