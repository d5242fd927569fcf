// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raycast/line/ray.h"
#include "tests/oracle/polyhedron.h"
#include "tests/support/random_solid.h"

namespace csgcast::oracle {

/// Points and rays that are hard for given polyhedra: on corners, edges, faces and their planes, an ulp or a few off
/// them, along edges and in faces. Where the exact place is no double the nearest one stands for it. A share is plain
/// random, in the inflated box.
class Queries {
 public:
  Queries(const std::vector<Polyhedron>& operands, test::RandomSolids& random);

  Point point();
  Ray ray();

 private:
  struct Facet {
    Point a, b, c;
  };

  static Facet triangle_in(const RationalPlane& plane);
  const Facet& facet();
  Point random_point();
  Point special_point();
  Point nudged(Point p);
  Vector direction();
  Vector rescaled(Vector d);

  test::RandomSolids& random_;
  std::vector<Facet> facets_;
  Point center_;
  Vector reach_;
};

}  // namespace csgcast::oracle
