// SPDX-License-Identifier: MIT
#include "tests/oracle/families.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/oracle/building.h"
#include "tests/oracle/polyhedra.h"

namespace csgcast::oracle {
namespace {

using test::PointCloud;
using test::RandomSolids;

int between(RandomSolids& random, int low, int high) {
  return low + static_cast<int>(random.index(static_cast<std::size_t>(high - low + 1)));
}

PointCloud some_points(RandomSolids& random) {
  switch (random.index(3)) {
    case 0:
      return test::sphere_points(random, between(random, 4, 16));
    case 1:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    default:
      return test::faceted_cylinder_points(between(random, 3, 8), 1, 0.5);
  }
}

Part box_or_round(RandomSolids& random) {
  if (random.index(2) == 0)
    return box_part({random.number(0.1, 3), random.number(0.1, 3), random.number(0.1, 3)}, Centering::centered);
  return hull_part(some_points(random));
}

PlaneEquation random_plane(RandomSolids& random) {
  const Vector n = random.direction();
  return {n, random.number(0.2, 1)};
}

// Through points of a coarse lattice: many planes share corners.
PlaneEquation integer_plane(RandomSolids& random) {
  const auto small = [&random] { return static_cast<double>(random.index(5)) - 2; };
  for (;;) {
    const double x = small(), y = small();
    const Vector n{x, y, small()};
    if (n != Vector{}) return {n, static_cast<double>(1 + random.index(4))};
  }
}

}  // namespace

Model hull_of_sphere_points(RandomSolids& random) {
  return single(hull_part(test::sphere_points(random, between(random, 4, 24))));
}

Model hull_of_lattice_points(RandomSolids& random) { return single(lattice_part(random, between(random, 5, 60))); }

Model some_box(RandomSolids& random) {
  const auto side = [&random] {
    return random.index(2) == 0 ? random.number(1e-3, 10) : std::exp2(between(random, -4, 4));
  };
  const double x = side(), y = side();
  Part part = box_part({x, y, side()}, random.index(2) == 0 ? Centering::corner : Centering::centered);
  if (random.index(2) == 0) part.move(translation(random.direction()));
  return single(std::move(part));
}

Model sliver(RandomSolids& random) {
  return single(hull_part(test::sliver_points(random, random.index(2) == 0 ? 1e-9 : 1e-14)));
}

Model needle(RandomSolids& random) {
  return single(hull_part(test::needle_points(random, random.index(2) == 0 ? 1e-9 : 1e-14)));
}

Model hull_of_rough_grid(RandomSolids& random) { return single(hull_part(test::rough_grid_points(random))); }

Model faceted_round(RandomSolids& random) {
  if (random.index(2) == 0) return single(hull_part(test::faceted_sphere_points(between(random, 5, 12))));
  const double top = random.index(3) == 0 ? 0 : random.number(0.5, 2);
  return single(hull_part(test::faceted_cylinder_points(between(random, 3, 24), random.number(0.5, 2), top)));
}

Model far_hull(RandomSolids& random) {
  const double away = random.index(2) == 0 ? 1e6 : 1e9;
  const double scale = random.index(2) == 0 ? 1 : 1e-3;
  return single(
      hull_part(test::placed(test::sphere_points(random, between(random, 5, 16)), scale, away * random.direction())));
}

Model scaled_hull(RandomSolids& random) {
  constexpr double scales[] = {0x1p100, 0x1p-100, 0x1p390, 0x1p-390};
  const double scale = scales[random.index(4)];
  return single(hull_part(test::placed(some_points(random), scale, scale * random.direction())));
}

Model hull_of_mixed_magnitudes(RandomSolids& random) {
  PointCloud points = test::sphere_points(random, between(random, 4, 12));
  for (Point& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = std::scalbn(p[axis], between(random, -40, 40));
  }
  return single(hull_part(points));
}

Model affine_image(RandomSolids& random) {
  Part part = random.index(2) == 0 ? hull_part(some_points(random)) : lattice_part(random, 8);
  const bool by_integers = random.index(2) == 0;
  for (int i = between(random, 1, 4); i > 0; --i)
    part.move(by_integers ? test::integer_affine(random) : test::random_affine(random));
  return single(std::move(part));
}

Model scene_image(RandomSolids& random) {
  Part part = box_or_round(random);
  for (int i = between(random, 1, 4); i > 0; --i) part.move(test::scene_transform(random));
  return single(std::move(part));
}

Model intersection_of_planes(RandomSolids& random) {
  const bool by_integers = random.index(2) == 0;
  std::vector<PlaneEquation> planes;
  for (const double sign : {-1.0, 1.0}) {
    planes.push_back({{sign, 0, 0}, 2});
    planes.push_back({{0, sign, 0}, 2});
    planes.push_back({{0, 0, sign}, 2});
  }
  for (int i = between(random, 1, 14); i > 0; --i)
    planes.push_back(by_integers ? integer_plane(random) : random_plane(random));
  Part part = planes_part(planes);
  if (random.index(2) == 0) part.move(by_integers ? test::integer_affine(random) : test::random_affine(random));
  return single(std::move(part));
}

Model loose_planes(RandomSolids& random) {
  std::vector<PlaneEquation> planes;
  for (int i = between(random, 1, 6); i > 0; --i) {
    PlaneEquation plane = random.index(2) == 0 ? integer_plane(random) : random_plane(random);
    if (random.index(4) == 0) plane.distance = 0;
    planes.push_back(plane);
    if (random.index(8) == 0) planes.push_back({-plane.normal, plane.distance});
  }
  return single(loose_planes_part(planes));
}

}  // namespace csgcast::oracle
