// SPDX-License-Identifier: MIT
#include "tests/oracle/building.h"
#include "tests/oracle/families.h"

namespace csgcast::oracle {
namespace {

using test::PointCloud;
using test::RandomSolids;

Operation some_operation(RandomSolids& random) {
  constexpr Operation operations[] = {Operation::unite, Operation::intersect, Operation::subtract};
  return operations[random.index(3)];
}

Part integer_box(RandomSolids& random) {
  Vector size, corner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<double>(1 + random.index(3));
    corner[axis] = static_cast<double>(random.index(3));
  }
  Part part = box_part(size, Centering::corner);
  part.move(translation(corner));
  return part;
}

std::vector<Part> some_integer_boxes(RandomSolids& random) {
  std::vector<Part> parts;
  for (std::size_t i = 2 + random.index(2); i > 0; --i) parts.push_back(integer_box(random));
  return parts;
}

}  // namespace

Model flush_boxes(RandomSolids& random) {
  const std::vector<Part> parts = some_integer_boxes(random);
  return combination(some_operation(random), parts);
}

Model moved_flush_boxes(RandomSolids& random) {
  std::vector<Part> parts = some_integer_boxes(random);
  for (std::size_t i = 1 + random.index(2); i > 0; --i) {
    const Transform motion = random.index(2) == 0 ? test::random_affine(random) : test::scene_transform(random);
    for (Part& part : parts) part.move(motion);
  }
  return combination(some_operation(random), parts);
}

Model glued_pair(RandomSolids& random) {
  const test::GluedPair pair = test::glued_tetrahedra(random);
  return combination(some_operation(random), {hull_part(pair.first), hull_part(pair.second)});
}

Model lattice_hulls(RandomSolids& random) {
  std::vector<Part> parts;
  for (std::size_t i = 2 + random.index(2); i > 0; --i) parts.push_back(lattice_part(random, 8));
  return combination(some_operation(random), parts);
}

Model almost_equal_pair(RandomSolids& random) {
  PointCloud points = test::sphere_points(random, 8);
  const Part first = hull_part(points);
  Point& moved = points[random.index(points.size())];
  const std::size_t axis = random.index(3);
  moved[axis] = test::ulps_off(moved[axis], random.index(2) == 0 ? 1 : -1);
  return combination(some_operation(random), {first, hull_part(points)});
}

}  // namespace csgcast::oracle
