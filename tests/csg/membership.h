// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "csg/exact/affine.h"
#include "csg/exact/quadric_form.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"
#include "csg/solid/solid.h"

namespace csgcast::testing {

/// Whether a point is in a leaf under an exact transform; nothing if it lies on one of its surfaces.
inline std::optional<bool> contains(const LeafShape& shape, const ExactAffine& world_from_solid, Point p) {
  const FormMover mover(world_from_solid);
  bool inside = true;
  for (const QuadricForm& f : shape.forms) {
    const int sign = mover.moved(f).at(p).sign();
    if (sign == 0) return std::nullopt;
    inside = inside && sign < 0;
  }
  return inside;
}

/// Whether a point is in a solid, by exact evaluation of its definition; nothing if the point lies on a surface of some
/// leaf. Recursive: for small trees.
inline std::optional<bool> contains(const Solid& solid, Point p, const ExactAffine& world_from_solid = {}) {
  using Kind = Solid::Kind;
  if (solid.kind() == Kind::empty) return false;
  if (solid.kind() == Kind::everything) return true;
  if (solid.kind() == Kind::leaf) return contains(solid.shape(), world_from_solid, p);
  const ExactAffine below =
      solid.kind() == Kind::transform ? world_from_solid * ExactAffine(solid.transform()) : world_from_solid;
  std::vector<bool> in;
  for (const Solid& child : solid.children()) {
    const auto inside = contains(child, p, below);
    if (!inside) return std::nullopt;
    in.push_back(*inside);
  }
  bool result = in.front();
  for (std::size_t i = 1; i < in.size(); ++i) {
    if (solid.kind() == Kind::unite) result = result || in[i];
    if (solid.kind() == Kind::intersect) result = result && in[i];
    if (solid.kind() == Kind::subtract) result = result && !in[i];
  }
  return solid.kind() == Kind::complement ? !result : result;
}

/// A seeded source of numbers, points and trees.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::size_t below(std::size_t n) { return engine_() % n; }
  double number(double reach = 1) { return std::uniform_real_distribution<double>(-reach, reach)(engine_); }
  Point point(double reach) { return {number(reach), number(reach), number(reach)}; }
  Vector vector(double reach) { return {number(reach), number(reach), number(reach)}; }

  Transform transform() {
    switch (below(5)) {
      case 0:
        return translation(vector(2));
      case 1:
        return rotation(vector(180));
      case 2:
        return mirroring(vector(1));
      case 3:
        return scaling({0.5 + static_cast<double>(below(3)), 0.75, 1.5});
      default:
        return Transform{};
    }
  }

  Solid bounded_leaf() {
    const double a = 0.1 + std::abs(number(2)), b = 0.1 + std::abs(number(2)), c = 0.1 + std::abs(number(2));
    switch (below(9)) {
      case 0:
        return box({a, b, c});
      case 1:
        return box({a, b, c}, Centering::centered);
      case 2:
        return sphere(a);
      case 3:
        return ellipsoid({a, b, c});
      case 4:
        return cylinder(a, b, c, Centering::centered);
      case 5:
        return cylinder(a, b, b);
      case 6:
        return paraboloid(a, b);
      case 7:
        return hyperboloid(a, b, c);
      default: {
        std::vector<Point> points;
        for (int i = 0; i < 8; ++i) points.push_back(point(2));
        return convex_from_points(points);
      }
    }
  }

  Solid any_leaf() {
    switch (below(10)) {
      case 0:
        return Solid();
      case 1:
        return Solid::everything();
      case 2:
        return halfspace(vector(1), number(1));
      case 3:
        return quadric({number(), number(), number(), number(), number(), number()}, vector(1), number());
      case 4: {
        std::vector<PlaneEquation> planes;
        for (int i = 0; i < 6; ++i) planes.push_back({vector(1), 1});
        return convex_from_planes(planes);
      }
      default:
        return bounded_leaf();
    }
  }

  /// A random tree with shared nodes; without parts and looks.
  Solid tree(std::size_t operators) {
    std::vector<Solid> made;
    for (int i = 0; i < 4; ++i) made.push_back(any_leaf());
    for (std::size_t i = 0; i < operators; ++i) made.push_back(operation(made));
    return made.back();
  }

 private:
  Solid operation(const std::vector<Solid>& made) {
    const auto pick = [&] {
      return below(3) == 0 ? any_leaf() : made[made.size() - 1 - below(std::min<std::size_t>(made.size(), 4))];
    };
    std::vector<Solid> children;
    for (std::size_t count = 1 + below(4); count > 0; --count) children.push_back(pick());
    switch (below(8)) {
      case 0:
      case 1:
        return unite(std::move(children));
      case 2:
      case 3:
        return intersect(std::move(children));
      case 4:
      case 5:
        return subtract(std::move(children));
      case 6:
        return complement(pick());
      default:
        return transformed(pick(), transform());
    }
  }

  std::mt19937_64 engine_;
};

}  // namespace csgcast::testing
