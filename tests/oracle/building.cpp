// SPDX-License-Identifier: MIT
#include "tests/oracle/building.h"

#include <stdexcept>

namespace csgcast::oracle {
namespace {

Part moved_hull(Solid solid, std::vector<RationalPoint> points) {
  return {std::move(solid), [points = std::move(points)](const RationalAffine& motion) {
            std::vector<RationalPoint> moved;
            for (const RationalPoint& p : points) moved.push_back(motion(p));
            auto hull = Polyhedron::hull(moved);
            if (!hull) throw std::logic_error("flat points in a family of solids");
            return std::move(*hull);
          }};
}

std::vector<RationalPlane> moved_planes(const std::vector<PlaneEquation>& planes, const RationalAffine& motion) {
  std::vector<RationalPlane> moved;
  for (const auto& [n, distance] : planes) {
    moved.push_back(motion(RationalPlane{{Rational(n.x), Rational(n.y), Rational(n.z), Rational(-distance)}}));
  }
  return moved;
}

bool is_flat(const test::PointCloud& points) {
  std::vector<RationalPoint> exact_points;
  for (const Point& p : points) exact_points.push_back(exact(p));
  return !Polyhedron::hull(exact_points);
}

}  // namespace

void Part::move(const Transform& transform) {
  solid_ = transformed(solid_, transform);
  motion_ = motion_.then(transform);
}

Part hull_part(const test::PointCloud& points) {
  std::vector<RationalPoint> exact_points;
  for (const Point& p : points) exact_points.push_back(exact(p));
  return moved_hull(convex_from_points(points), std::move(exact_points));
}

Part lattice_part(test::RandomSolids& random, int count) {
  for (;;) {
    const test::PointCloud points = test::lattice_points(random, count);
    if (!is_flat(points)) return hull_part(points);
  }
}

Part box_part(Vector size, Centering centering) {
  std::vector<RationalPoint> corners;
  const RationalPoint extent = exact(Point{} + size);
  for (int i = 0; i < 8; ++i) {
    RationalPoint corner;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1) != 0) corner[axis] = extent[axis];
      if (centering == Centering::centered) corner[axis] -= extent[axis] / 2;
    }
    corners.push_back(corner);
  }
  return moved_hull(box(size, centering), std::move(corners));
}

Part planes_part(const std::vector<PlaneEquation>& planes) {
  return {convex_from_planes(planes), [planes](const RationalAffine& motion) {
            return Polyhedron::intersection(moved_planes(planes, motion), motion(RationalPoint{}));
          }};
}

Part loose_planes_part(const std::vector<PlaneEquation>& planes) {
  return {convex_from_planes(planes),
          [planes](const RationalAffine& motion) { return Polyhedron::half_spaces(moved_planes(planes, motion)); }};
}

Model single(const Part& part) { return {part.solid(), {part.polyhedron()}, Operation::unite}; }

Model combination(Operation operation, const std::vector<Part>& parts) {
  Model model;
  std::vector<Solid> solids;
  for (const Part& part : parts) {
    solids.push_back(part.solid());
    model.operands.push_back(part.polyhedron());
  }
  model.operation = operation;
  model.solid = operation == Operation::unite       ? unite(std::move(solids))
                : operation == Operation::intersect ? intersect(std::move(solids))
                                                    : subtract(std::move(solids));
  return model;
}

}  // namespace csgcast::oracle
