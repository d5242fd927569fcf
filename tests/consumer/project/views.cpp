// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <csg/solid/primitives.h>
#include <query/eigen_views.h>

/// The chord of a ball along a ray through its middle.
int main() {
  csgcast::TripleRows origins(1, 3), directions(1, 3);
  origins << 0, 0, 5;
  directions << 0, 0, -1;
  const csgcast::RayQueries model(csgcast::sphere(2));
  const csgcast::IntervalTable table = model.intervals(csgcast::rays_of(origins, directions));
  const csgcast::IntervalViews views(table);
  return views.t.rows() == 1 && views.t.row(0) == Eigen::RowVector2d(3, 7) ? EXIT_SUCCESS : EXIT_FAILURE;
}
