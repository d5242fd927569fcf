// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tests/oracle/check.h"
#include "tests/oracle/families.h"
#include "tests/support/catch.h"

namespace csgcast::oracle {
namespace {

/// Runs a family's workload and demands that nothing is wrong, and that inside, outside and boundary all came up.
void require_agreement(const std::string& family, const ModelMaker& make, std::uint64_t seed) {
  const Workload work = workload();
  const Tally tally = check_family(make, seed, work);
  fmt::print("{}\n", summary(family, tally));
  for (const std::string& complaint : tally.complaints) UNSCOPED_INFO(complaint);
  CHECK(tally.wrong == 0);
  CHECK(tally.points >= work.points);
  CHECK(tally.rays >= work.rays);
  CHECK(tally.ends > work.rays / 10);
  for (const std::uint64_t count : tally.located) CHECK(count > work.points / 5000);
}

TEST_CASE("hulls of points on a sphere agree with CGAL") {
  require_agreement("sphere points", hull_of_sphere_points, 1'000'000);
}
TEST_CASE("hulls of lattice points agree with CGAL") {
  require_agreement("lattice points", hull_of_lattice_points, 2'000'000);
}
TEST_CASE("boxes agree with CGAL") { require_agreement("boxes", some_box, 3'000'000); }
TEST_CASE("slivers agree with CGAL") { require_agreement("slivers", sliver, 4'000'000); }
TEST_CASE("needles agree with CGAL") { require_agreement("needles", needle, 5'000'000); }
TEST_CASE("hulls of nearly coplanar points agree with CGAL") {
  require_agreement("nearly coplanar", hull_of_rough_grid, 6'000'000);
}
TEST_CASE("faceted spheres and cylinders agree with CGAL") {
  require_agreement("faceted rounds", faceted_round, 7'000'000);
}
TEST_CASE("hulls far from the origin agree with CGAL") { require_agreement("far away", far_hull, 8'000'000); }
TEST_CASE("huge and tiny hulls agree with CGAL") {
  require_agreement("2^100, 2^-100, 2^400, 2^-400", scaled_hull, 9'000'000);
}
TEST_CASE("hulls of points of mixed magnitude agree with CGAL") {
  require_agreement("mixed magnitudes", hull_of_mixed_magnitudes, 19'000'000);
}
TEST_CASE("affine images agree with CGAL") { require_agreement("affine images", affine_image, 10'000'000); }
TEST_CASE("rotated, mirrored and scaled solids agree with CGAL") {
  require_agreement("scene transforms", scene_image, 11'000'000);
}
TEST_CASE("intersections of half-spaces agree with CGAL") {
  require_agreement("half-spaces", intersection_of_planes, 12'000'000);
}
TEST_CASE("unbounded and flat sets of half-spaces agree with exact signs") {
  require_agreement("loose half-spaces", loose_planes, 13'000'000);
}

TEST_CASE("Booleans of boxes with common faces agree with CGAL") {
  require_agreement("flush boxes", flush_boxes, 14'000'000);
}
TEST_CASE("Booleans of boxes moved together agree with CGAL") {
  require_agreement("moved flush boxes", moved_flush_boxes, 15'000'000);
}
TEST_CASE("Booleans of tetrahedra that share a face agree with CGAL") {
  require_agreement("glued tetrahedra", glued_pair, 16'000'000);
}
TEST_CASE("Booleans of lattice hulls agree with CGAL") {
  require_agreement("lattice hulls", lattice_hulls, 17'000'000);
}
TEST_CASE("Booleans of hulls an ulp apart agree with CGAL") {
  require_agreement("an ulp apart", almost_equal_pair, 18'000'000);
}

}  // namespace
}  // namespace csgcast::oracle
