// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "csg/solid/primitives.h"
#include "tests/stress/aimed_rays.h"
#include "tests/stress/family_lists.h"
#include "tests/stress/pieces.h"

namespace csgcast::stress {
namespace {

using test::RandomSolids;

double coefficient(RandomSolids& random) { return random.index(2) == 0 ? random.quarter(-1, 1) : random.number(-1, 1); }

Vector coefficients(RandomSolids& random) { return {coefficient(random), coefficient(random), coefficient(random)}; }

Solid general_quadric(RandomSolids& random) {
  const Vector a = coefficients(random);
  const Vector mixed = random.index(3) == 0 ? Vector{} : coefficients(random);
  return quadric({a.x, a.y, a.z, mixed.x, mixed.y, mixed.z}, coefficients(random), coefficient(random));
}

// (m . p + d)(n . p + e) <= 0 with numbers so short that the products are exact: two planes, maybe parallel or one.
Solid pair_of_planes(RandomSolids& random) {
  const auto grid = [&] { return Vector{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)}; };
  const Vector m = grid();
  const Vector n = random.index(3) == 0 ? m : grid();
  const double d = random.quarter(-0.5, 0.5);
  const double e = random.quarter(-0.5, 0.5);
  return quadric({m.x * n.x, m.y * n.y, m.z * n.z, 0.5 * (m.x * n.y + m.y * n.x), 0.5 * (m.x * n.z + m.z * n.x),
                  0.5 * (m.y * n.z + m.z * n.y)},
                 e * m + d * n, d * e);
}

// s (m . p)² + u (n . p)² + l . p + c <= 0: cylinders over ellipses, hyperbolas, parabolas, and their limits.
Solid cylindrical_quadric(RandomSolids& random) {
  const auto grid = [&] { return Vector{random.quarter(-1, 1), random.quarter(-1, 1), random.quarter(-1, 1)}; };
  const Vector m = grid();
  const Vector n = grid();
  const double s = random.quarter(-1, 1);
  const double u = random.quarter(-1, 1);
  const auto entry = [&](std::size_t i, std::size_t j) { return s * m[i] * m[j] + u * n[i] * n[j]; };
  const Vector linear = random.index(2) == 0 ? Vector{} : random.quarter(-1, 1) * m;
  return quadric({entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)}, linear,
                 random.quarter(-1, 0.5));
}

Solid cone_by_coefficients(RandomSolids& random) {
  const Vector a = coefficients(random);
  return quadric({a.x, a.y, -std::fabs(a.z), 0, coefficient(random), 0}, {}, 0);
}

// Each cut to a box, so that it has a size; complemented where it would be all outside.
template <class Make>
Trial quadrics(RandomSolids& random, int rays, Make make) {
  const auto leaf = [&] {
    const Solid solid = make(random);
    return random.index(4) == 0 ? complement(solid) : solid;
  };
  const Solid frame = box({3, 3, 3}, Centering::centered);
  Trial trial{random.index(2) == 0 ? frame & leaf() : (frame & leaf()) - leaf(), {}};
  aim_at_middle(random, trial, rays / 3);
  aim_at_grid(random, trial, rays / 3);
  aim_at_tangents(random, trial, rays / 3, power_of_tenth(random, 4, 16));
  return trial;
}

// Bounded, though none of its leaves is.
Solid between_unbounded_leaves(RandomSolids& random) {
  const auto side = [&](Vector n) {
    const Vector tilt = random.index(2) == 0 ? Vector{} : 0.2 * coefficients(random);
    return halfspace(n + tilt, random.quarter(1, 2));
  };
  const Solid low = side({0, 0, -1}), high = side({0, 0, 1});
  const Solid tube = quadric({1, random.quarter(0.5, 1), 0, 0, 0, 0}, {}, -random.quarter(1, 3));
  switch (random.index(5)) {
    case 0:
      return side({1, 0, 0}) & side({-1, 0, 0}) & side({0, 1, 0}) & side({0, -1, 0}) & low & high;
    case 1:
      return tube & low & high;
    case 2:  // paraboloids that face each other
      return quadric({1, 1, 0, 0, 0, 0}, {0, 0, -1}, -1) & quadric({1, 1, 0, 0, 0, 0}, {0, 0, 1}, -1);
    case 3:
      return complement(complement(tube) + complement(low) + complement(high));
    default:  // a double cone
      return quadric({1, 1, -1, 0, 0, 0}, {}, 0) & low & high;
  }
}

Trial unbounded_leaves(RandomSolids& random, int rays) {
  const Solid frame = between_unbounded_leaves(random);
  Solid solid = random.index(2) == 0 ? frame : frame - general_quadric(random);
  if (random.index(3) == 0) solid = solid + at(between_unbounded_leaves(random), {random.quarter(-3, 3), 0, 0});
  if (random.index(3) == 0) solid = solid + at(box({1, 1, 1}), {0, 0, random.quarter(-2, 2)});
  Trial trial{solid, {}};
  aim_at_middle(random, trial, rays / 3);
  aim_at_grid(random, trial, rays / 3);
  aim_at_tangents(random, trial, rays / 3, power_of_tenth(random, 4, 16));
  return random.index(2) == 0 ? trial : turned(random, std::move(trial));
}

Trial general(RandomSolids& random, int rays) { return quadrics(random, rays, general_quadric); }

Trial degenerate(RandomSolids& random, int rays) {
  return quadrics(random, rays, [](RandomSolids& source) {
    switch (source.index(3)) {
      case 0:
        return pair_of_planes(source);
      case 1:
        return cylindrical_quadric(source);
      default:
        return cone_by_coefficients(source);
    }
  });
}

// Unbounded on purpose: no box, no frame, crossings at any distance.
Trial unbounded(RandomSolids& random, int rays) {
  Trial trial{general_quadric(random) - general_quadric(random), {}};
  aim_at_grid(random, trial, rays / 2);
  aim_at_middle(random, trial, rays - rays / 2);
  return trial;
}

// Directions on the asymptotic cone, where a vanishes or nearly does.
Trial nearly_parabolic(RandomSolids& random, int rays) {
  const double turn = random.number(0, 360);
  const Solid solid = random.index(2) == 0 ? hyperboloid(4, std::sqrt(5.0), 1) : paraboloid(2, 1) - cylinder(9, 1, 0);
  Trial trial{transformed(solid, rotation(Vector{0, 0, turn})), {}};
  for (int i = 0; i < rays; ++i) {
    const double angle = random.number(0, 6.3);
    const double off = random.index(2) == 0 ? 0 : power_of_tenth(random, 6, 17);
    const Vector d = random.index(2) == 0 ? Vector{std::cos(angle), std::sin(angle), 1 + off} : Vector{off, off, 1};
    add(trial, random.point(1.5) - 2 * d, d);
  }
  return trial;
}

// a = 0 exactly: directions (3, 4, 5) and their like on x² + y² - z² = c, through points of the grid.
Trial along_asymptotes(RandomSolids& random, int rays) {
  constexpr std::array<Vector, 4> exact{Vector{3, 4, 5}, Vector{-5, 12, 13}, Vector{8, -15, 17}, Vector{1, 0, -1}};
  const double c = random.quarter(-1, 1);
  const Solid solid = quadric({1, 1, -1, 0, 0, 0}, {}, c) & box({6, 6, 6}, Centering::centered);
  Trial trial{random.index(2) == 0 ? solid : solid - at(solid, {random.quarter(0.25, 1), 0, 0}), {}};
  for (int i = 0; i < rays; ++i) {
    Vector d = exact[random.index(4)];
    if (random.index(3) == 0) d.z *= 1 + (random.index(2) == 0 ? 1 : -1) * power_of_tenth(random, 8, 16.5);
    const Point p{random.quarter(-2, 2), random.quarter(-2, 2), random.quarter(-2, 2)};
    add(trial, p - random.quarter(0, 2) * d, d);
  }
  return trial;
}

}  // namespace

std::vector<Family> quadric_families() {
  return {{"general quadrics", general},          {"degenerate quadrics", degenerate},
          {"unbounded quadrics", unbounded},      {"between unbounded leaves", unbounded_leaves},
          {"nearly parabolic", nearly_parabolic}, {"along asymptotes", along_asymptotes}};
}

}  // namespace csgcast::stress
