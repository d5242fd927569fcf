// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "csg/solid/primitives.h"
#include "tests/oracle/polyhedra.h"
#include "tests/oracle/subject.h"

namespace csgcast::oracle {

/// A convex solid built twice from the same doubles, to be moved twice by the same transforms: by the product, and
/// exactly by CGAL's numbers.
class Part {
 public:
  /// `build` makes the oracle's polyhedron under the composition of the transforms.
  Part(Solid solid, std::function<Polyhedron(const RationalAffine&)> build)
      : solid_(std::move(solid)), build_(std::move(build)) {}

  void move(const Transform& transform);
  const Solid& solid() const { return solid_; }
  Polyhedron polyhedron() const { return build_(motion_); }

 private:
  Solid solid_;
  std::function<Polyhedron(const RationalAffine&)> build_;
  RationalAffine motion_;
};

/// Precondition: the points do not all lie in one plane.
Part hull_part(const test::PointCloud& points);
/// The hull of some lattice points that do not all lie in one plane.
Part lattice_part(test::RandomSolids& random, int count);
Part box_part(Vector size, Centering centering);
/// Bounded, the origin strictly inside.
Part planes_part(const std::vector<PlaneEquation>& planes);
/// No surface on the oracle's side: half-spaces only.
Part loose_planes_part(const std::vector<PlaneEquation>& planes);

Model single(const Part& part);
Model combination(Operation operation, const std::vector<Part>& parts);

}  // namespace csgcast::oracle
