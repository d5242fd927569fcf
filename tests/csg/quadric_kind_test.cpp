// SPDX-License-Identifier: MIT
#include "csg/exact/quadric_kind.h"

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/base/transform.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;
using Kind = QuadricKind;

/// xx, yy, zz, xy, xz, yz, x, y, z, one.
QuadricForm form(const std::array<double, 10>& c) {
  QuadricForm f;
  for (std::size_t i = 0; i < c.size(); ++i) f.coefficient[i] = c[i];
  return f;
}

struct Case {
  Kind kind;
  std::array<double, 10> form;
};

/// One or more of each kind.
std::vector<Case> cases() {
  return {
      {Kind::sphere, {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::sphere, {-3, -3, -3, 0, 0, 0, 1, 2, 3, 1}},
      {Kind::spheroid, {1, 1, 2, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::spheroid, {2, 2, 2, 1, 1, 1, 0, 0, 0, -1}},  // about (1, 1, 1)
      {Kind::ellipsoid, {1, 3, 2, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::ellipsoid, {1, std::nextafter(1.0, 2.0), 2, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::circular_cylinder, {1, 1, 0, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::circular_cylinder, {2, 2, 2, -2, -2, -2, 0, 0, 0, -1}},  // about (1, 1, 1)
      {Kind::elliptic_cylinder, {1, 2, 0, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::elliptic_cylinder, {1, std::nextafter(1.0, 0.0), 0, 0, 0, 0, 4, 0, 0, -1}},
      {Kind::parabolic_cylinder, {1, 0, 0, 0, 0, 0, 0, 0, -1, 0}},
      {Kind::parabolic_cylinder, {-1, 0, 0, 0, 0, 0, 3, -2, -1, 7}},
      {Kind::hyperbolic_cylinder, {1, -1, 0, 0, 0, 0, 0, 0, 0, 1}},
      {Kind::hyperbolic_cylinder, {0, 0, 0, 1, 0, 0, 0, 0, 0, -1}},
      {Kind::circular_cone, {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}},
      {Kind::circular_cone, {0, 0, 0, 1, 1, 1, 0, 0, 0, 0}},
      {Kind::elliptic_cone, {-1, -2, 1, 0, 0, 0, 0, 0, 0, 0}},
      {Kind::circular_paraboloid, {1, 1, 0, 0, 0, 0, 0, 0, -1, 0}},
      {Kind::elliptic_paraboloid, {-1, -4, 0, 0, 0, 0, 0, 0, -1, 5}},
      {Kind::hyperbolic_paraboloid, {0, 0, 0, 1, 0, 0, 0, 0, -1, 0}},
      {Kind::circular_hyperboloid_of_one_sheet, {1, 1, -1, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::elliptic_hyperboloid_of_one_sheet, {-1, -2, 1, 0, 0, 0, 0, 0, 0, 1}},
      {Kind::circular_hyperboloid_of_two_sheets, {1, 1, -1, 0, 0, 0, 0, 0, 0, 1}},
      {Kind::elliptic_hyperboloid_of_two_sheets, {-1, -2, 1, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::plane, {0, 0, 0, 0, 0, 0, 1, 0, 0, 2}},
      {Kind::crossing_planes, {1, -4, 0, 0, 0, 0, 0, 0, 0, 0}},
      {Kind::crossing_planes, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0}},
      {Kind::parallel_planes, {0, 0, 1, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::double_plane, {1, 1, 1, 2, 2, 2, 0, 0, 0, 0}},
      {Kind::line, {1, 2, 0, 0, 0, 0, 0, 0, 0, 0}},
      {Kind::point, {1, 2, 3, 0, 0, 0, 0, 0, 0, 0}},
      {Kind::none, {1, 2, 3, 0, 0, 0, 0, 0, 0, 1}},
      {Kind::none, {1, 2, 0, 0, 0, 0, 0, 0, 0, 1}},
      {Kind::none, {-1, 0, 0, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::none, {0, 0, 0, 0, 0, 0, 0, 0, 0, -1}},
      {Kind::everything, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
  };
}

/// A turn by 3-4-5 angles: 25 times a rotation, in integers.
Transform exact_turn() {
  Transform t;
  // Rz by 3/5, 4/5 after Rx by 3/5, 4/5.
  t.entry = {15, -12, 16, 7, 20, 9, -12, -1000, 0, 20, 15, 0.125};
  return t;
}

Vector applied(const Transform& t, Vector v, double divisor) {
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i) sum[i] = (t(i, 0) * v.x + t(i, 1) * v.y + t(i, 2) * v.z) / divisor;
  return sum;
}

/// sin of the angle between two lines.
double between(Vector a, Vector b) { return length(cross(normalised(a), normalised(b))); }

QuadricShape turned_shape(const std::array<double, 10>& c) {
  return shape_of_quadric(transformed(form(c), ExactAffine(exact_turn())));
}

void check_length(double found, double known, const QuadricShape& shape) {
  CHECK(std::fabs(found - known) <= (shape.relative_error + 0x1p-52) * known);
  CHECK(shape.relative_error < 1e-12);
}

}  // namespace

TEST_CASE("The kind of a quadric is told exactly") {
  for (const Case& c : cases()) {
    INFO(word(c.kind));
    CHECK(std::string(word(kind_of_quadric(form(c.form)))) == word(c.kind));
    CHECK(kind_of_quadric(-form(c.form)) == c.kind);
  }
}

TEST_CASE("The kind of a quadric stays if it is moved exactly, however far or large") {
  Transform far = exact_turn();
  far.entry[3] = 0x1p200;
  Transform small = exact_turn();
  for (double& entry : small.entry) entry *= 0x1p-300;
  for (const Case& c : cases()) {
    if (form(c.form).is_constant()) continue;
    INFO(word(c.kind));
    for (const Transform& t : {exact_turn(), far, small})
      CHECK(std::string(word(kind_of_quadric(transformed(form(c.form), ExactAffine(t))))) == word(c.kind));
  }
}

TEST_CASE("A sheared quadric keeps its class, and what was circular is elliptic") {
  Transform shear;
  shear.entry = {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const auto sheared = [&](const std::array<double, 10>& c) {
    return kind_of_quadric(transformed(form(c), ExactAffine(shear)));
  };
  CHECK(sheared({1, 1, 1, 0, 0, 0, 0, 0, 0, -1}) == Kind::ellipsoid);
  CHECK(sheared({1, 1, 0, 0, 0, 0, 0, 0, 0, -1}) == Kind::elliptic_cylinder);
  CHECK(sheared({1, 1, -1, 0, 0, 0, 0, 0, 0, 0}) == Kind::elliptic_cone);
  CHECK(sheared({1, 1, 0, 0, 0, 0, 0, 0, -1, 0}) == Kind::elliptic_paraboloid);
}

TEST_CASE("An ellipsoid tells its center, axes and semi-axes") {
  // Semi-axes 4, 2, 1 about (1, 2, 3).
  const std::array<double, 10> c{1, 4, 16, 0, 0, 0, -2, -16, -96, 1 + 16 + 144 - 16};
  const QuadricShape plain = shape_of_quadric(form(c));
  CHECK(plain.kind == Kind::ellipsoid);
  CHECK(plain.center == Point{1, 2, 3});
  CHECK(plain.semi_axes == std::array<double, 3>{4, 2, 1});
  CHECK(plain.axes == std::array<Vector, 3>{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}});
  const QuadricShape turned = turned_shape(c);
  const Vector center = applied(exact_turn(), {1, 2, 3}, 1);
  CHECK(turned.center == Point{center.x + 7, center.y - 1000, center.z + 0.125});
  const std::array<Vector, 3> unit{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    check_length(turned.semi_axes[i], 25 * plain.semi_axes[i], turned);
    CHECK(turned.axes_error[i] < 1e-13);
    CHECK(between(turned.axes[i], applied(exact_turn(), unit[i], 25)) <= turned.axes_error[i] + 1e-15);
  }
  CHECK(dot(cross(turned.axes[0], turned.axes[1]), turned.axes[2]) > 0.999);
}

TEST_CASE("A ball far away tells its center and radius: nothing cancels") {
  // Radius 3 about (1e8 + 0.25, -1e9, 0).
  QuadricForm f = form({1, 1, 1, 0, 0, 0, 0, 0, 0, -9});
  f = transformed(f, ExactAffine(translation({1e8 + 0.25, -1e9, 0})));
  const QuadricShape ball = shape_of_quadric(f);
  CHECK(ball.kind == Kind::sphere);
  CHECK(ball.center == Point{1e8 + 0.25, -1e9, 0});
  CHECK(ball.semi_axes == std::array<double, 3>{3, 3, 3});
  for (const double angle : ball.axes_error) CHECK(std::isinf(angle));
}

TEST_CASE("Cylinders, cones and hyperboloids have their axis last") {
  const Vector axis = applied(exact_turn(), {0, 0, 1}, 25);
  const QuadricShape cylinder = turned_shape({4, 1, 0, 0, 0, 0, 0, 0, 0, -4});
  CHECK(cylinder.kind == Kind::elliptic_cylinder);
  check_length(cylinder.semi_axes[0], 50, cylinder);
  check_length(cylinder.semi_axes[1], 25, cylinder);
  CHECK(std::isinf(cylinder.semi_axes[2]));
  CHECK(between(cylinder.axes[2], axis) <= cylinder.axes_error[2] + 1e-15);
  // The center is the point of the axis next to the origin.
  CHECK(std::fabs(dot(as_vector(cylinder.center), axis)) < 1e-10);

  const QuadricShape cone = turned_shape({1, 1, -3, 0, 0, 0, 0, 0, 0, 0});
  CHECK(cone.kind == Kind::circular_cone);
  CHECK(cone.center == Point{7, -1000, 0.125});
  for (const double angle : cone.half_angles) CHECK(angle == Approx(std::numbers::pi / 3).epsilon(1e-14));
  CHECK(between(cone.axes[2], axis) <= cone.axes_error[2] + 1e-15);
  CHECK(cone.axes_error[2] < 1e-13);
  CHECK(std::isinf(cone.axes_error[0]));

  const QuadricShape waist = shape_of_quadric(form({1, 4, -16, 0, 0, 0, 0, 0, 0, -16}));
  CHECK(waist.semi_axes == std::array<double, 3>{4, 2, 1});
  const QuadricShape cups = shape_of_quadric(form({1, 4, -16, 0, 0, 0, 0, 0, 0, 16}));
  CHECK(cups.kind == Kind::elliptic_hyperboloid_of_two_sheets);
  CHECK(cups.semi_axes == std::array<double, 3>{4, 2, 1});
}

TEST_CASE("Paraboloids tell their vertex, the way they open and their focal lengths") {
  // z - 5 = -(x - 1)²/4 - y²: it opens downward; focal lengths 1 and 1/4.
  const std::array<double, 10> c{0.25, 1, 0, 0, 0, 0, -0.5, 0, 1, 0.25 - 5};
  for (const bool is_negated : {false, true}) {
    const QuadricShape bowl = shape_of_quadric(is_negated ? -form(c) : form(c));
    CHECK(bowl.kind == Kind::elliptic_paraboloid);
    CHECK(bowl.center == Point{1, 0, 5});
    CHECK(bowl.axes[2] == Vector{0, 0, -1});
    CHECK(bowl.focal_lengths == std::array<double, 2>{1, 0.25});
    CHECK(dot(cross(bowl.axes[0], bowl.axes[1]), bowl.axes[2]) == 1);
  }
  const QuadricShape turned = turned_shape(c);
  check_length(turned.focal_lengths[0], 25, turned);
  check_length(turned.focal_lengths[1], 25 * 0.25, turned);
  CHECK(dot(turned.axes[2], applied(exact_turn(), {0, 0, -1}, 25)) > 1 - 1e-14);
  const Vector vertex = applied(exact_turn(), {1, 0, 5}, 1);
  CHECK(turned.center == Point{vertex.x + 7, vertex.y - 1000, vertex.z + 0.125});

  // y = x²/8 + 3 along z.
  const QuadricShape trough = shape_of_quadric(form({0.125, 0, 0, 0, 0, 0, 0, -1, 0, 3}));
  CHECK(trough.kind == Kind::parabolic_cylinder);
  CHECK(trough.center == Point{0, 3, 0});
  CHECK(trough.axes[1] == Vector{0, 1, 0});
  CHECK(trough.focal_lengths[0] == 2);
  CHECK(dot(cross(trough.axes[0], trough.axes[1]), trough.axes[2]) == 1);

  const QuadricShape saddle = shape_of_quadric(form({1, -1, 0, 0, 0, 0, 0, 0, -4, 0}));
  CHECK(saddle.kind == Kind::hyperbolic_paraboloid);
  CHECK(saddle.focal_lengths == std::array<double, 2>{1, 1});
}

TEST_CASE("Planes in a pair and hyperbolic cylinders tell where they are") {
  // 2 <= x + y <= 4 times sqrt 2: normals (1, 1, 0), half the distance 1/sqrt 2.
  const QuadricShape slab = shape_of_quadric(form({1, 1, 0, 2, 0, 0, -6, -6, 0, 8}));
  CHECK(slab.kind == Kind::parallel_planes);
  CHECK(slab.center == Point{1.5, 1.5, 0});
  check_length(slab.semi_axes[0], std::sqrt(0.5), slab);
  CHECK(between(slab.axes[0], {1, 1, 0}) <= slab.axes_error[0] + 1e-15);
  CHECK(slab.axes_error[0] < 1e-14);

  const QuadricShape roof = shape_of_quadric(form({3, 0, -1, 0, 0, 0, 0, 0, 2, -1}));
  CHECK(roof.kind == Kind::crossing_planes);
  CHECK(roof.center == Point{0, 0, 1});
  CHECK(roof.half_angles[0] == Approx(std::numbers::pi / 3).epsilon(1e-14));

  for (const double sign : {1.0, -1.0}) {
    const QuadricShape sheets = shape_of_quadric(form({sign, -4 * sign, 0, 0, 0, 0, 0, 0, 0, -4}));
    CHECK(sheets.kind == Kind::hyperbolic_cylinder);
    CHECK(sheets.semi_axes[0] == (sign > 0 ? 2 : 1));
    CHECK(between(sheets.axes[0], sign > 0 ? Vector{1, 0, 0} : Vector{0, 1, 0}) == 0);
  }
}

TEST_CASE("Random ellipsoids have the semi-axes and axes that they were made with, within what they say") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 200; ++i) {
    std::array<double, 3> a{};
    for (double& x : a) x = std::exp2(10 * uniform(random));
    QuadricForm f = form({1, 1, 1, 0, 0, 0, 0, 0, 0, -1});
    f = transformed(f, ExactAffine(scaling({a[0], a[1], a[2]})));
    const Vector at{1e3 * uniform(random), uniform(random), uniform(random)};
    const Transform turn = rotation(360 * uniform(random), {uniform(random), uniform(random), 1});
    f = transformed(f, ExactAffine(turn));
    f = transformed(f, ExactAffine(translation(at)));
    const QuadricShape shape = shape_of_quadric(f);
    CHECK(shape.kind == Kind::ellipsoid);
    std::array<double, 3> sorted = a;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(shape.center[k] == at[k]);
      // The turn's entries are rounded: that changes the semi-axes themselves by some 1e-16.
      CHECK(std::fabs(shape.semi_axes[k] - sorted[k]) <=
            (shape.relative_error + 1e-15 * sorted[0] / sorted[k]) * sorted[k]);
    }
  }
}
