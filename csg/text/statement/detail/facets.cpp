// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/base/precondition.h"
#include "csg/base/transform.h"

namespace csgcast::text {
namespace {

void append_ring(std::vector<Point>& vertices, double radius, double z, int sides) {
  for (int i = 0; i < sides; ++i) {
    const double angle = 360.0 * i / sides;
    vertices.push_back({radius * cos_degrees(angle), radius * sin_degrees(angle), z});
  }
}

void append_ring_or_apex(std::vector<Point>& vertices, double radius, double z, int sides) {
  if (radius > 0) {
    append_ring(vertices, radius, z, sides);
  } else {
    vertices.push_back({0, 0, z});
  }
}

}  // namespace

double side_count(double radius, const Fineness& fineness) {
  constexpr double grid = 0x1p-20;  // OpenSCAD's GRID_FINE
  constexpr double least = 0.01;    // OpenSCAD's F_MINIMUM
  if (radius < grid) return 3;
  if (fineness.fn > 0) return std::trunc(std::max(fineness.fn, 3.0));
  const double by_angle = 360.0 / std::max(fineness.fa, least);
  const double by_length = radius * 2 * std::numbers::pi / std::max(fineness.fs, least);
  return std::ceil(std::max(std::min(by_angle, by_length), 5.0));
}

std::vector<Point> sphere_vertices(double radius, int sides) {
  CSGCAST_PRECONDITION(radius > 0 && sides >= 3);
  const int rings = (sides + 1) / 2;
  std::vector<Point> vertices;
  vertices.reserve(static_cast<std::size_t>(rings) * static_cast<std::size_t>(sides));
  for (int i = 0; i < rings; ++i) {
    const double from_top = 180.0 * (i + 0.5) / rings;
    append_ring(vertices, radius * sin_degrees(from_top), radius * cos_degrees(from_top), sides);
  }
  return vertices;
}

std::vector<Point> cylinder_vertices(double bottom, double top, double bottom_radius, double top_radius, int sides) {
  CSGCAST_PRECONDITION(bottom < top && bottom_radius >= 0 && top_radius >= 0 && sides >= 3);
  std::vector<Point> vertices;
  append_ring_or_apex(vertices, bottom_radius, bottom, sides);
  append_ring_or_apex(vertices, top_radius, top, sides);
  return vertices;
}

}  // namespace csgcast::text
