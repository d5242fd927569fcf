// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

Vector grid_vector(RandomSolids& random, double most) {
  for (;;) {
    const Vector v{random.quarter(-most, most), random.quarter(-most, most), random.quarter(-most, most)};
    if (v != Vector{}) return v;
  }
}

// A point of a box with `exact` coordinates on its faces, on axes chosen at random: 1 in a face, 2 on an edge, 3 a
// corner.
Point point_of(RandomSolids& random, const Box& box, std::size_t exact) {
  const std::size_t first = random.index(3);
  Point p;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = (first + i) % 3;
    const double share = i < exact ? static_cast<double>(random.index(2)) : random.number(0, 1);
    p[axis] = box.lower[axis] + share * (box.upper[axis] - box.lower[axis]);
  }
  return p;
}

Point point_of(RandomSolids& random, const GridBoxes& grid, std::size_t exact) {
  return point_of(random, grid.boxes[random.index(grid.boxes.size())], exact);
}

// Rays that meet the planes of `exact` axes in one point without any rounding.
Trial through_grid(RandomSolids& random, int rays, std::size_t exact) {
  const GridBoxes grid = grid_boxes(random, 5);
  Trial trial{grid.solid, {}};
  for (int i = 0; i < rays; ++i) {
    const Vector d = grid_vector(random, 1);
    add(trial, point_of(random, grid, exact) - random.quarter(0, 4) * d, d);
  }
  return trial;
}

Trial edges(RandomSolids& random, int rays) { return through_grid(random, rays, 2); }
Trial vertices(RandomSolids& random, int rays) { return through_grid(random, rays, 3); }

Trial in_faces(RandomSolids& random, int rays) {
  const GridBoxes grid = grid_boxes(random, 5);
  Trial trial{grid.solid, {}};
  for (int i = 0; i < rays; ++i) {
    const Box& box = grid.boxes[random.index(grid.boxes.size())];
    const std::size_t axis = random.index(3);
    Point p = point_of(random, box, 3 * random.index(2));
    Vector d = random.index(2) == 0 ? random.direction() : grid_vector(random, 1);
    p[axis] = random.index(2) == 0 ? box.lower[axis] : box.upper[axis];
    d[axis] = 0;
    add(trial, p - random.quarter(0, 3) * d, d);
  }
  return trial;
}

Trial between_grid_points(RandomSolids& random, int rays) {
  Trial trial{grid_boxes(random, 6).solid, {}};
  aim_at_grid(random, trial, rays);
  return trial;
}

Trial starting_on_faces(RandomSolids& random, int rays) {
  const GridBoxes grid = grid_boxes(random, 5);
  Trial trial{grid.solid, {}};
  for (int i = 0; i < rays; ++i) {
    const Point o = point_of(random, grid, 1 + random.index(3));
    add(trial, o, random.index(2) == 0 ? random.direction() : grid_vector(random, 1));
  }
  return trial;
}

// Hulls of points on a fine lattice; the rays go through corners, through middles of lines between two, and along
// these.
Trial polyhedra(RandomSolids& random, int rays) {
  const auto lattice = [&] { return (static_cast<double>(random.index(129)) - 64) / 64; };
  std::vector<Point> points(12);
  for (Point& p : points) p = {lattice(), lattice(), lattice()};
  Trial trial{convex_from_points(points), {}};
  if (random.index(2) == 0) trial.solid = trial.solid - box({1, 1, 1});
  for (int i = 0; i < rays; ++i) {
    const Point a = points[random.index(points.size())];
    const Vector to_b = points[random.index(points.size())] - a;
    const Vector across = random.index(2) == 0 ? grid_vector(random, 1) : random.direction();
    const std::size_t kind = random.index(3);
    const Point p = kind == 0 ? a : a + 0.5 * to_b;
    const Vector d = kind == 2 ? to_b : across;
    add(trial, p - random.quarter(0, 3) * d, d);
  }
  return trial;
}

// A solid of some kind with faces on planes z = quarter, and on others of the grid where it has flat sides.
Solid flat_ended(RandomSolids& random) {
  const double r = random.quarter(0.25, 1);
  const double h = random.quarter(0.25, 1);
  const Vector offset{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)};
  switch (random.index(5)) {
    case 0:
      return at(cylinder(h, r, r), offset);
    case 1:
      return at(cylinder(h, r, random.quarter(0, 1)), offset);
    case 2: {
      const std::vector<Point> prism{{0, 0, 0}, {r, 0, 0}, {0, r, 0}, {0, 0, h}, {r, 0, h}, {0, r, h}};
      return at(convex_from_points(prism), offset);
    }
    case 3:
      return halfspace({0, 0, random.index(2) == 0 ? 1.0 : -1.0}, h);
    default:
      return random.grid_box();
  }
}

Trial coincident_faces(RandomSolids& random, int rays) {
  Trial trial{random.tree(8, [&] { return flat_ended(random); }) & box({8, 8, 8}, Centering::centered), {}};
  aim_at_grid(random, trial, rays / 2);
  aim_at_middle(random, trial, rays - rays / 2);
  return trial;
}

// Boxes in a row, each sharing a whole face with the next, as union or difference of all.
Trial glued_boxes(RandomSolids& random, int rays) {
  std::vector<Solid> row;
  double end = 0;
  for (int i = 0; i < 6; ++i) {
    const double width = random.quarter(0.25, 1);
    row.push_back(at(box({width, 1, random.quarter(0.5, 1)}), {end, 0, 0}));
    end += width;
  }
  const Solid around = box({end, 1, 1});
  Trial trial{random.index(2) == 0 ? unite(row) : around - unite({row[0], row[2], row[4]}), {}};
  for (int i = 0; i < rays; ++i) {
    const Point p{random.quarter(0, end), random.quarter(0, 1), random.quarter(0, 1)};
    Vector d = grid_vector(random, 1);
    if (random.index(2) == 0) d[random.index(3)] = 0;
    add(trial, p - random.quarter(0, 3) * d, d);
  }
  return trial;
}

Trial plates(RandomSolids& random, int rays) {
  Trial trial{at(box({2, 2, power_of_tenth(random, 6, 16)}), random.direction()), {}};
  aim_at_middle(random, trial, rays);
  return trial;
}

}  // namespace

std::vector<Family> box_families() {
  std::vector<Family> list;
  const std::vector<std::pair<std::string, Trial (*)(RandomSolids&, int)>> both_ways{
      {"box edges", edges},
      {"box vertices", vertices},
      {"in box faces", in_faces},
      {"between grid points", between_grid_points},
      {"starting on faces", starting_on_faces},
      {"corners and lines of polyhedra", polyhedra},
      {"coincident faces", coincident_faces},
      {"glued boxes", glued_boxes}};
  for (const auto& [name, make] : both_ways) {
    list.push_back({name, make});
    list.push_back({name + ", turned",
                    [make = make](RandomSolids& random, int rays) { return turned(random, make(random, rays)); }});
  }
  list.push_back({"plates of 1e-6 to 1e-16", plates});
  return list;
}

}  // namespace csgcast::stress
