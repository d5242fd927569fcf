// SPDX-License-Identifier: MIT
#include "tests/oracle/polyhedra.h"

#include <cmath>
#include <limits>

#include "csg/base/length.h"

namespace csgcast::test {
namespace {

// Two vectors that span the plane square to `axis` with it, to rounding.
struct Frame {
  Vector u;
  Vector v;
};

Frame frame_about(Vector axis) {
  const Vector n = normalised(axis);
  const Vector helper = std::fabs(n.x) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector u = normalised(cross(n, helper));
  return {u, cross(n, u)};
}

double determinant(const Transform& t) {
  return dot(Vector{t(0, 0), t(0, 1), t(0, 2)},
             cross(Vector{t(1, 0), t(1, 1), t(1, 2)}, Vector{t(2, 0), t(2, 1), t(2, 2)}));
}

double small_integer(RandomSolids& random, int limit) {
  return static_cast<double>(random.index(static_cast<std::size_t>(2 * limit + 1))) - limit;
}

void append_ring(PointCloud& points, int facets, double radius, double z) {
  for (int i = 0; i < facets; ++i) {
    const double angle = 360.0 * i / facets;
    points.push_back({radius * cos_degrees(angle), radius * sin_degrees(angle), z});
  }
}

}  // namespace

double ulps_off(double x, int steps) {
  const double towards = steps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, towards);
  return x;
}

PointCloud sphere_points(RandomSolids& random, int count) {
  PointCloud points;
  for (int i = 0; i < count; ++i) points.push_back(Point{} + normalised(random.direction()));
  return points;
}

PointCloud lattice_points(RandomSolids& random, int count) {
  PointCloud points;
  const auto coordinate = [&random] { return static_cast<double>(random.index(5)); };
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    points.push_back({x, y, coordinate()});
  }
  return points;
}

PointCloud sliver_points(RandomSolids& random, double thickness) {
  const Vector axis = normalised(random.direction());
  const auto [u, v] = frame_about(axis);
  PointCloud points;
  for (int i = 0; i < 12; ++i) {
    const double a = random.number(-1, 1), b = random.number(-1, 1);
    points.push_back(Point{} + a * u + b * v);
    points.push_back(Point{} + a * u + b * v + thickness * axis);
  }
  return points;
}

PointCloud needle_points(RandomSolids& random, double thickness) {
  const Vector axis = normalised(random.direction());
  const auto [u, v] = frame_about(axis);
  PointCloud points;
  for (const double along : {-1.0, -0.5, 0.75, 1.0}) {
    for (int i = 0; i < 5; ++i) {
      const double a = thickness * random.number(-1, 1), b = thickness * random.number(-1, 1);
      points.push_back(Point{} + along * axis + a * u + b * v);
    }
  }
  return points;
}

PointCloud rough_grid_points(RandomSolids& random) {
  const Vector u = random.direction(), v = random.direction();
  const Point corner = random.point(1);
  const auto rough = [&random](double x) { return ulps_off(x, static_cast<int>(random.index(3)) - 1); };
  PointCloud points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const Point p = corner + (i / 4.0) * u + (j / 4.0) * v;
      points.push_back({rough(p.x), rough(p.y), rough(p.z)});
    }
  }
  points.push_back(corner + cross(u, v));
  return points;
}

PointCloud faceted_sphere_points(int facets) {
  PointCloud points;
  const int rings = (facets + 1) / 2;
  for (int i = 0; i < rings; ++i) {
    const double polar = (180.0 * (i + 0.5)) / rings;
    append_ring(points, facets, sin_degrees(polar), cos_degrees(polar));
  }
  return points;
}

PointCloud faceted_cylinder_points(int facets, double bottom_radius, double top_radius) {
  PointCloud points;
  append_ring(points, facets, bottom_radius, 0);
  append_ring(points, facets, top_radius, 2);
  return points;
}

GluedPair glued_tetrahedra(RandomSolids& random) {
  const auto corner = [&random] {
    const double x = small_integer(random, 4), y = small_integer(random, 4);
    return Point{x, y, small_integer(random, 4)};
  };
  for (;;) {
    const Point a = corner(), b = corner(), c = corner(), above = corner(), below = corner();
    const Vector n = cross(b - a, c - a);  // exact, and so is the height: small integers
    if (dot(n, above - a) > 0 && dot(n, below - a) < 0) return {{a, b, c, above}, {a, b, c, below}};
  }
}

PointCloud placed(PointCloud points, double scale, Vector offset) {
  for (Point& p : points) p = Point{} + scale * as_vector(p) + offset;
  return points;
}

Transform random_affine(RandomSolids& random) {
  for (;;) {
    Transform t;
    for (double& e : t.entry) e = random.number(-2, 2);
    if (std::fabs(determinant(t)) > 0.1) return t;
  }
}

Transform integer_affine(RandomSolids& random) {
  for (;;) {
    Transform t;
    for (double& e : t.entry) e = small_integer(random, 3);
    if (determinant(t) != 0) return t;
  }
}

Transform scene_transform(RandomSolids& random) {
  const Vector v = random.direction();
  switch (random.index(5)) {
    case 0:
      return rotation({random.number(-180, 180), random.number(-180, 180), 30.0 * small_integer(random, 6)});
    case 1:
      return rotation(15.0 * small_integer(random, 12), v);
    case 2:
      return translation(100 * v);
    case 3:
      return mirroring(v);
    default:
      return scaling({v.x + 2, v.y - 2, v.z + 3});
  }
}

}  // namespace csgcast::test
