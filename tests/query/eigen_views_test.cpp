// SPDX-License-Identifier: MIT
#include "query/eigen_views.h"

#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;

struct Down {
  TripleRows origins{4, 3};
  TripleRows directions{4, 3};
  Down() {
    origins << 0, 0, 5, 0.5, 0, 5, 3, 0, 5, 0, 0.25, 5;
    directions.rowwise() = Eigen::RowVector3d(0, 0, -1);
  }
};

/// A ball of radius 1 over a plate.
RayQueries ball_over_plate() {
  return RayQueries(sphere(1) + transformed(box({2, 2, 1}, Centering::centered), translation({0, 0, -3})));
}

}  // namespace

TEST_CASE("Rays from matrices are those from spans, without a copy") {
  const Down down;
  const Rays rays = rays_of(down.origins, down.directions);
  CHECK(rays.origins.data() == down.origins.data());
  CHECK(rays.count() == 4);
  const Rays rows = rays_of(down.origins.middleRows(1, 2), down.directions.middleRows(1, 2));
  CHECK(rows.origins.data() == down.origins.data() + 3);
  CHECK(rows.count() == 2);
  const Eigen::Ref<const TripleRows> reference = down.origins;
  CHECK(rays_of(reference, reference).origins.data() == down.origins.data());
  CHECK_THROWS_AS(rays_of(down.origins, down.directions.topRows(3)), Error);
  const Eigen::Matrix<double, 4, 6, Eigen::RowMajor> wide = Eigen::Matrix<double, 4, 6, Eigen::RowMajor>::Zero();
  CHECK_THROWS_AS(numbers_of(wide.leftCols<3>()), Error);
}

TEST_CASE("A table of intervals is seen as matrices of two columns") {
  const RayQueries model = ball_over_plate();
  const Down down;
  QueryOptions options;
  options.faces = options.normals = true;
  const IntervalTable table = model.intervals(rays_of(down.origins, down.directions), options);
  const IntervalViews views(table);
  REQUIRE(views.t.rows() == 6);
  CHECK(views.t.data() == table.t.data());
  CHECK(views.offsets[4] == 6);
  CHECK(views.t(0, 0) == 4);
  CHECK(views.t(0, 1) == 6);
  CHECK(views.t(1, 0) == 7.5);
  CHECK(views.surfaces(0, 0) == views.surfaces(0, 1));
  CHECK(views.surfaces(1, 0) != views.surfaces(1, 1));
  CHECK(views.leaves(0, 0) != views.leaves(1, 0));
  CHECK(views.parts.rows() == 6);
  CHECK(views.entry_normals.row(0) == Eigen::RowVector3d(0, 0, 1));
  CHECK(views.exit_normals.row(0) == Eigen::RowVector3d(0, 0, -1));
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(6 * i + k);
      CHECK(views.entry_normals(i, k) == table.normals[at]);
      CHECK(views.exit_normals(i, k) == table.normals[at + 3]);
    }
  }
  // The chord of a ray at distance 1/2 from the middle.
  CHECK((views.t.col(1) - views.t.col(0))[2] == Approx(std::sqrt(3.0)));
}

TEST_CASE("Views of tables without faces, normals or rays have no rows") {
  const RayQueries model = ball_over_plate();
  const Down down;
  const IntervalTable plain = model.intervals(rays_of(down.origins, down.directions));
  const IntervalViews views(plain);
  CHECK(views.t.rows() == 6);
  CHECK(views.leaves.rows() == 0);
  CHECK(views.entry_normals.rows() == 0);
  CHECK(views.exit_normals.rows() == 0);
  const IntervalTable empty = model.intervals(rays_of(TripleRows(0, 3), TripleRows(0, 3)));
  CHECK(IntervalViews(empty).t.rows() == 0);
}

TEST_CASE("First hits are seen as vectors, and lie on the solid") {
  const RayQueries model = ball_over_plate();
  const Down down;
  const HitTable table = model.first_hits(rays_of(down.origins, down.directions));
  const HitViews hits(table);
  REQUIRE(hits.t.size() == 4);
  CHECK(hits.t[0] == 4);
  CHECK(std::isinf(hits.t[2]));
  CHECK(hits.surfaces[2] == no_id);
  CHECK(hits.is_entry[3] == 1);
  const TripleRows found = points_at(down.origins.topRows(2), down.directions.topRows(2), hits.t.head(2));
  CHECK(found.row(0) == Eigen::RowVector3d(0, 0, 1));
  CHECK(found.row(1).norm() == Approx(1).epsilon(1e-15));
  CHECK_THROWS_AS(points_at(down.origins, down.directions, hits.t.head(2)), Error);
}
