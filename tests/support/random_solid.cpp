// SPDX-License-Identifier: MIT
#include "tests/support/random_solid.h"

#include <cmath>

#include "csg/solid/primitives.h"

namespace csgcast::test {

double RandomSolids::number(double low, double high) {
  // 53 bits by hand: std::uniform_real_distribution differs between libraries.
  return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
}

double RandomSolids::quarter(double low, double high) { return std::floor(4 * number(low, high + 0.25)) / 4; }

std::size_t RandomSolids::index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

Point RandomSolids::point(double radius) {
  return {number(-radius, radius), number(-radius, radius), number(-radius, radius)};
}

Vector RandomSolids::direction() {
  for (;;) {
    const Vector v{number(-1, 1), number(-1, 1), number(-1, 1)};
    if (dot(v, v) > 0.01) return v;
  }
}

Solid RandomSolids::plain_leaf() {
  const auto size = [this] { return number(0.3, 1.2); };
  switch (index(10)) {
    case 0:
      return box({size(), size(), size()}, Centering::centered);
    case 1:
      return sphere(size());
    case 2:
      return cylinder(2 * size(), size(), size(), Centering::centered);
    case 3:
      return ellipsoid({size(), size(), size()});
    case 4:
      return paraboloid(size(), size());
    case 5:
      return hyperboloid(2 * size(), 0.5 + size(), 0.4);
    case 6: {
      const double c = number(-1, 1);
      return quadric({number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)},
                     direction(), c);
    }
    case 7: {
      const double d = number(-0.5, 0.5);
      return halfspace(direction(), d);
    }
    case 8: {
      std::vector<Point> points(8);
      for (Point& p : points) p = point(1);
      return convex_from_points(points);
    }
    default:
      return cylinder(size(), size(), 0);
  }
}

Transform RandomSolids::transform() {
  switch (index(5)) {
    case 0:
      return translation(direction());
    case 1:
      return rotation(Vector{number(0, 360), number(0, 360), number(0, 360)});
    case 2:
      return scaling({number(0.5, 1.5), number(0.5, 1.5), number(-1.5, -0.5)});
    case 3:
      return mirroring(direction());
    default: {
      Transform shear;
      shear.entry[1] = number(-0.5, 0.5);
      shear.entry[6] = number(-0.5, 0.5);
      return shear;
    }
  }
}

Solid RandomSolids::leaf() {
  Solid solid = plain_leaf();
  for (std::size_t n = index(3); n-- > 0;) solid = transformed(std::move(solid), transform());
  return solid;
}

Solid RandomSolids::grid_box() {
  const Vector size{quarter(0.25, 1.5), quarter(0.25, 1.5), quarter(0.25, 1.5)};
  const Vector corner{quarter(-1, 1), quarter(-1, 1), quarter(-1, 1)};
  return transformed(box(size), translation(corner));
}

Solid RandomSolids::combined(Solid a, Solid b) {
  switch (index(7)) {
    case 0:
    case 1:
      return a + b;
    case 2:
      return a & b;
    case 3:
    case 4:
      return a - b;
    case 5:
      return transformed(a + b, transform());
    default:
      return a & complement(b);
  }
}

}  // namespace csgcast::test
