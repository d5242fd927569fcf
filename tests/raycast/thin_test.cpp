// SPDX-License-Identifier: MIT
// Plates, discs and shells 1e-13 thick are seen from every angle. What a ray must see of them is computed here from the
// geometry, in numbers of 2,000 bits.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"
#include "tests/support/rounded_leaves.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

constexpr double thin = 1e-13;

struct Big : mpf_class {
  Big(double value = 0) : mpf_class(value, 2000) {}  // NOLINT(google-explicit-constructor)
  template <class T, class U>
  Big(const __gmp_expr<T, U>& value) : mpf_class(value, 2000) {}  // NOLINT(google-explicit-constructor)
};

struct BigVector {
  Big x, y, z;
  Big operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

Big dot(const BigVector& a, const BigVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// A ray in the coordinates of the plate: M is undone by Cramer's rule.
struct PlateRay {
  BigVector origin, direction;
};

BigVector solve(const Transform& m, const BigVector& v) {
  const auto column = [&](std::size_t c) { return BigVector{m(0, c), m(1, c), m(2, c)}; };
  const auto crossed = [](const BigVector& a, const BigVector& b) {
    return BigVector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const BigVector a = column(0), b = column(1), c = column(2);
  const Big determinant = dot(a, crossed(b, c));
  return {dot(v, crossed(b, c)) / determinant, dot(v, crossed(c, a)) / determinant,
          dot(v, crossed(a, b)) / determinant};
}

PlateRay undone(const Transform& m, const Ray& ray) {
  const Point o = ray.origin();
  const Vector d = ray.direction();
  const BigVector from{Big(o.x) - Big(m(0, 3)), Big(o.y) - Big(m(1, 3)), Big(o.z) - Big(m(2, 3))};
  return {solve(m, from), solve(m, {d.x, d.y, d.z})};
}

// The outward normal of a face in the plate's coordinates, where the ray meets it at t.
struct End {
  Big t;
  Vector normal;
};
struct Chord {
  End entry, exit;
};

// The part of a ray in 0 <= p[axis] <= width. None if it runs beside the slab.
std::optional<Chord> in_slab(const PlateRay& ray, std::size_t axis, double width) {
  const Big o = ray.origin[axis], d = ray.direction[axis];
  Vector up;
  up[axis] = 1;
  if (sgn(d) == 0) {
    if (o <= 0 || o >= width) return std::nullopt;
    return Chord{{-1e30, {}}, {1e30, {}}};
  }
  const End low{-o / d, -up}, high{(Big(width) - o) / d, up};
  return sgn(d) > 0 ? Chord{low, high} : Chord{high, low};
}

// The part within `radius` of the origin, in x and y alone or in all axes.
std::optional<Chord> in_round(const PlateRay& ray, double radius, bool ball) {
  BigVector o = ray.origin, d = ray.direction;
  if (!ball) o.z = d.z = 0;
  const Big a = dot(d, d), b = dot(o, d);
  const Big discriminant = b * b - a * (dot(o, o) - Big(radius) * Big(radius));
  if (sgn(discriminant) <= 0) return std::nullopt;
  const Big root = sqrt(discriminant);
  const auto end = [&](const Big& t) {
    const auto coordinate = [&](std::size_t axis) { return Big(o[axis] + t * d[axis]).get_d(); };
    return End{t, normalised({coordinate(0), coordinate(1), coordinate(2)})};
  };
  return Chord{end((-b - root) / a), end((-b + root) / a)};
}

std::optional<Chord> common(const std::optional<Chord>& a, const std::optional<Chord>& b) {
  if (!a || !b) return std::nullopt;
  const Chord chord{a->entry.t > b->entry.t ? a->entry : b->entry, a->exit.t < b->exit.t ? a->exit : b->exit};
  return chord.entry.t < chord.exit.t ? std::optional(chord) : std::nullopt;
}

std::vector<Chord> list_of(const std::optional<Chord>& chord) {
  return chord ? std::vector<Chord>{*chord} : std::vector<Chord>{};
}

std::vector<Chord> plate_list(const PlateRay& ray) {
  return list_of(common(common(in_slab(ray, 0, 2), in_slab(ray, 1, 2)), in_slab(ray, 2, thin)));
}

std::vector<Chord> disc_list(const PlateRay& ray) {
  return list_of(common(in_round(ray, 1, false), in_slab(ray, 2, thin)));
}

std::vector<Chord> shell_list(const PlateRay& ray) {
  const auto outer = in_round(ray, 1, true);
  const auto inner = in_round(ray, 1 - thin, true);
  if (!outer || !inner) return list_of(outer);
  return {{outer->entry, {inner->entry.t, -inner->entry.normal}}, {{inner->exit.t, -inner->exit.normal}, outer->exit}};
}

struct Thin {
  std::string name;
  Solid solid;
  std::vector<Chord> (*list)(const PlateRay&);
  Point middle;  // of the plate
  double reach;  // targets are within this of the middle, on x and y
};

std::vector<Thin> thin_solids() {
  return {{"plate", box({2, 2, thin}), plate_list, {1, 1, thin / 2}, 0.9},
          {"disc", cylinder(thin, 1, 1), disc_list, {0, 0, thin / 2}, 0.6},
          {"shell", sphere(1) - sphere(1 - thin), shell_list, {0, 0, 0}, 0.6}};
}

std::vector<Transform> placements() {
  Transform turned = rotation(53.0, {2, 1, -2});
  Transform moved = turned;
  for (std::size_t row = 0; row < 3; ++row) moved.entry[4 * row + 3] = 10.0 * (1.0 + static_cast<double>(row));
  return {{}, turned, moved, {{0, -3, 0, 0.5, 2, 0, 0, 7, 0, 0, -1, 4}}};
}

// Any direction; every third one within 1e-12 of the plate's plane, or in it.
Vector direction(RandomSolids& random) {
  Vector d = normalised(random.direction());
  switch (random.index(6)) {
    case 0:
      d.z = std::pow(10.0, -random.number(12, 18)) * (random.index(2) == 0 ? 1 : -1);
      break;
    case 1:
      d.z = 0;
      break;
    default:
      break;
  }
  return d;
}

Vector linear_image(const Transform& m, Vector v) {
  const auto row = [&](std::size_t r) { return m(r, 0) * v.x + m(r, 1) * v.y + m(r, 2) * v.z; };
  return {row(0), row(1), row(2)};
}

// A ray of the plate's coordinates, moved; its numbers are rounded.
Ray moved(const Transform& m, Point through, Vector d) {
  return Ray(test::image(m, through - 3 * d), linear_image(m, d));
}

Ray towards(const Thin& shape, const Transform& m, RandomSolids& random) {
  const Vector aside{shape.reach * random.number(-1, 1), shape.reach * random.number(-1, 1), 0};
  return moved(m, shape.middle + aside, direction(random));
}

// A ray that touches the unit sphere but for `depth`.
Ray past_silhouette(const Transform& m, double depth, RandomSolids& random) {
  const Vector up = normalised(random.direction());
  const Vector d = normalised(cross(up, random.direction()));
  return moved(m, Point{} + (1 - depth) * up, d);
}

// Whether a normal is that of the moved face: the transposed inverse of M takes normals along.
bool faces(const Normal& normal, const Vector& expected, const Transform& m) {
  const Vector n = as_vector(normal);
  const auto column = [&](std::size_t c) { return m(0, c) * n.x + m(1, c) * n.y + m(2, c) * n.z; };
  const Vector back = normalised({column(0), column(1), column(2)});
  return dot(back, expected) > 0.999;
}

bool is_seen(Caster& caster, const std::vector<Chord>& expected, const Transform& m) {
  IntervalList list;
  caster.intervals(list, Span::line());
  const auto right = [&](const Crossing& end, Passage passage, const End& should_be) {
    const double off = Big(end.t - should_be.t).get_d();
    return std::fabs(off) <= 0x1p-53 * std::fabs(end.t) &&
           faces(caster.attribute({end, passage}).normal, should_be.normal, m);
  };
  return std::equal(list.begin(), list.end(), expected.begin(), expected.end(), [&](const Interval& i, const Chord& c) {
    return right(i.entry, Passage::entry, c.entry) && right(i.exit, Passage::exit, c.exit);
  });
}

}  // namespace

TEST_CASE("a plate, a disc and a shell of 1e-13 are seen from every angle, and by the right faces") {
  const int rays = test::long_run() ? 300'000 : test::times(2000);
  for (const Thin& shape : thin_solids()) {
    for (const Transform& placement : placements()) {
      const Scene scene = compile(transformed(shape.solid, placement));
      Caster caster(scene);
      RandomSolids random(61);
      int unseen = 0, wrong = 0;
      for (int i = 0; i < rays; ++i) {
        const Ray ray = towards(shape, placement, random);
        const std::vector<Chord> expected = shape.list(undone(placement, ray));
        unseen += expected.empty();
        caster.begin(ray);
        wrong += !is_seen(caster, expected, placement);
      }
      CAPTURE(shape.name, placement.entry);
      CHECK(unseen == 0);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("a ray past the silhouette of a shell of 1e-13 passes through its wall alone, its cavity, or neither") {
  const int rays = test::long_run() ? 300'000 : test::times(2000);
  for (const Transform& placement : placements()) {
    const Scene scene = compile(transformed(sphere(1) - sphere(1 - thin), placement));
    Caster caster(scene);
    RandomSolids random(62);
    std::array<int, 3> intervals{};
    int wrong = 0;
    for (int i = 0; i < rays; ++i) {
      const Ray ray = past_silhouette(placement, thin * random.number(-0.5, 1.5), random);
      const std::vector<Chord> expected = shell_list(undone(placement, ray));
      ++intervals[expected.size()];
      caster.begin(ray);
      wrong += !is_seen(caster, expected, placement);
    }
    CAPTURE(placement.entry);
    CHECK(wrong == 0);
    CHECK(*std::min_element(intervals.begin(), intervals.end()) > rays / 8);
  }
}
