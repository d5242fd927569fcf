// SPDX-License-Identifier: MIT
#include "tests/oracle/queries.h"

#include <algorithm>
#include <cmath>

#include "csg/base/box.h"
#include "csg/base/length.h"
#include "tests/oracle/polyhedra.h"

namespace csgcast::oracle {
namespace {

double longest(Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// What a ray takes: raycast/line/ray.h.
bool is_direction(Vector d) {
  return is_finite(d) && longest(d) >= Ray::least_direction && longest(d) <= Ray::greatest;
}
bool is_origin(Point p) { return is_finite(p) && longest(as_vector(p)) <= Ray::greatest; }

}  // namespace

Queries::Queries(const std::vector<Polyhedron>& operands, test::RandomSolids& random) : random_(random) {
  for (const Polyhedron& operand : operands) {
    std::vector<Point> corners;
    for (const RationalPoint& corner : operand.corners()) corners.push_back(nearest(corner));
    for (const auto& [a, b, c] : operand.triangles()) facets_.push_back({corners[a], corners[b], corners[c]});
    if (!corners.empty()) continue;
    for (const RationalPlane& plane : operand.planes()) facets_.push_back(triangle_in(plane));
  }
  Box box;
  for (const auto& [a, b, c] : facets_) {
    for (const Point& p : {a, b, c}) box = hull(box, Box{p, p});
  }
  center_ = box.center();
  reach_ = 0.75 * box.size();
}

// About the foot of the origin, of size 1.
Queries::Facet Queries::triangle_in(const RationalPlane& plane) {
  const auto& c = plane.coefficient;
  const RationalPoint normal{c[0], c[1], c[2]};
  const Rational height = c[3] / plane.along(normal);
  const Point foot = nearest({-height * normal[0], -height * normal[1], -height * normal[2]});
  const Vector n = normalised(as_vector(nearest(normal)));
  const Vector u = normalised(cross(n, std::fabs(n.x) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0}));
  return {foot, foot + u, foot + cross(n, u)};
}

const Queries::Facet& Queries::facet() { return facets_[random_.index(facets_.size())]; }

Point Queries::random_point() {
  return {center_.x + reach_.x * random_.number(-1, 1), center_.y + reach_.y * random_.number(-1, 1),
          center_.z + reach_.z * random_.number(-1, 1)};
}

// Multiples of 1/8 of the facet's edges: exact where the corners have a few bits to spare.
Point Queries::special_point() {
  const Facet f = facet();
  const double s = static_cast<double>(1 + random_.index(6)) / 8;
  switch (random_.index(7)) {
    case 0:
      return f.a;
    case 1:  // within an edge
      return f.a + s * (f.b - f.a);
    case 2:  // within the facet
      return f.a + s * (f.b - f.a) + (random_.number(0, 1) < 0.5 ? (1 - s) / 2 : 0.125) * (f.c - f.a);
    case 3:  // on an edge's line, beyond it
      return f.a + 16 * (s - 0.4375) * (f.b - f.a);
    case 4:  // in the plane, anywhere
      return f.a + 8 * (s - 0.25) * (f.b - f.a) + (random_.number(0, 1) < 0.5 ? s : -1.0) * (f.c - f.a);
    case 5:  // between two corners: across the inside, or on a face
      return f.a + 0.5 * (facet().a - f.a);
    default: {  // close to the surface, seen from the middle
      const double gap = random_.number(-1, 1) * std::exp2(-20.0 - static_cast<double>(random_.index(33)));
      return center_ + (1 + gap) * (f.a + s * (f.b - f.a) - center_);
    }
  }
}

Point Queries::nudged(Point p) {
  const auto steps = [this] {
    const int count = random_.index(3) != 0 ? 1 : 1 << random_.index(5);
    return random_.index(2) == 0 ? count : -count;
  };
  if (random_.index(3) != 0) {
    const std::size_t axis = random_.index(3);
    p[axis] = test::ulps_off(p[axis], steps());
    return p;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = test::ulps_off(p[axis], steps());
  return p;
}

Point Queries::point() {
  const std::size_t kind = random_.index(10);
  if (kind == 0) return random_point();
  return kind < 5 ? special_point() : nudged(special_point());
}

Vector Queries::direction() {
  const Facet f = facet();
  const auto small = [this] { return static_cast<double>(random_.index(7)) - 3; };
  // Powers of two keep small integers exact whatever the size of the scene.
  const double size = std::exp2(std::floor(std::log2(std::max({reach_.x, reach_.y, reach_.z}))));
  switch (random_.index(7)) {
    case 0: {
      Vector axis;
      axis[random_.index(3)] = random_.index(2) == 0 ? size : -size;
      return axis;
    }
    case 1: {
      const double x = small(), y = small();
      return size * Vector{x, y, small()};
    }
    case 2:  // along an edge
      return f.b - f.a;
    case 3: {  // in a face
      const double i = small();
      return i * (f.b - f.a) + small() * (f.c - f.a);
    }
    case 4:  // across
      return special_point() - f.a;
    case 5:
      return special_point() - random_point();
    default:
      return size * random_.direction();
  }
}

Vector Queries::rescaled(Vector d) {
  const std::size_t kind = random_.index(8);
  if (kind > 1) return d;
  const double factor = std::exp2(std::floor(kind == 0 ? random_.number(-300, 300) : random_.number(-60, 60)));
  return is_direction(factor * d) ? factor * d : d;
}

Ray Queries::ray() {
  for (;;) {
    const Point target = random_.index(2) == 0 ? special_point() : point();
    Vector d = direction();
    if (random_.index(6) == 0) d = Vector{} + (nudged(Point{} + d) - Point{});
    if (!is_direction(d)) continue;
    constexpr double backs[] = {0, 0, 0, 0.5, 1, 1, 2, 3, -1};
    Point origin = target - backs[random_.index(std::size(backs))] * d;
    if (random_.index(6) == 0) origin = nudged(origin);
    if (random_.index(5) == 0) {  // from anywhere towards the target
      origin = random_point();
      d = target - origin;
    }
    d = rescaled(d);
    if (is_direction(d) && is_origin(origin)) return Ray(origin, d);
  }
}

}  // namespace csgcast::oracle
