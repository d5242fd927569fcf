// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "csg/solid/primitives.h"
#include "measure/measure.h"
#include "tests/measure/revolved.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

// Solids whose measures have closed forms: what is printed must hold the truth within its error, every time.

namespace {

using namespace csgcast;
using namespace csgcast::test;

constexpr double pi = std::numbers::pi;

struct Case {
  std::string name;
  Solid solid;
  Known known;
};

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }

Known known_box(Vector size) {
  const double v = size.x * size.y * size.z;
  const auto across = [&](double a, double b) { return v * (a * a + b * b) / 12; };
  return {v,
          2 * (size.x * size.y + size.y * size.z + size.z * size.x),
          {},
          {across(size.y, size.z), across(size.z, size.x), across(size.x, size.y), 0, 0, 0}};
}

Known known_ellipsoid(Vector a) {
  const double v = 4.0 / 3 * pi * a.x * a.y * a.z;
  const auto across = [&](double b, double c) { return v * (b * b + c * c) / 5; };
  return {v, 0, {}, {across(a.y, a.z), across(a.z, a.x), across(a.x, a.y), 0, 0, 0}};
}

/// The corner of the cube [0, s]³ below x + y + z <= s.
Known known_corner(double s) {
  const double v = s * s * s / 6;
  const double square = 3.0 / 80 * v * s * s;  // of a coordinate about the centroid
  const double product = -v * s * s / 80;
  return {v,
          1.5 * s * s + std::sqrt(3.0) / 2 * s * s,
          {s / 4, s / 4, s / 4},
          {2 * square, 2 * square, 2 * square, -product, -product, -product}};
}

std::vector<Case> solids_of_revolution() {
  const Square ball{1, 0, -1};
  const auto constant = [](double r) { return Square{r * r, 0, 0}; };
  const auto ring = [](double outer, double inner) { return pi * (outer * outer - inner * inner); };
  const auto centered = Centering::centered;
  std::vector<Case> cases;
  const auto add = [&](const char* name, const Solid& solid, Profile profile) {
    cases.push_back({name, solid, profile.known()});
  };
  add("ball", sphere(1), {{{-1, 1, ball}}});
  add("cylinder", cylinder(2, 0.5, 0.5, centered), {{{-1, 1, constant(0.5)}}, 2 * ring(0.5, 0)});
  add("cone", cylinder(2, 1, 0), {{{0, 2, {1, -1, 0.25}}}, ring(1, 0)});
  add("frustum", cylinder(2, 1, 0.5), {{{0, 2, {1, -0.5, 0.0625}}}, ring(1, 0) + ring(0.5, 0)});
  add("spheroid", ellipsoid({0.5, 0.5, 1.5}), {{{-1.5, 1.5, {0.25, 0, -0.25 / 2.25}}}});
  add("paraboloid", paraboloid(2, 1), {{{0, 2, {0, 0.5, 0}}}, ring(1, 0)});
  add("hyperboloid", hyperboloid(2, 1, 0.5), {{{-1, 1, {0.25, 0, 0.75}}}, 2 * ring(1, 0)});
  add("barrel", hyperboloid(2, 0.5, 1), {{{-1, 1, {1, 0, -0.75}}}, 2 * ring(0.5, 0)});
  add("double cone", hyperboloid(2, 1, 0), {{{-1, 0, {0, 0, 1}}, {0, 1, {0, 0, 1}}}, 2 * ring(1, 0)});
  add("cap of a ball", sphere(1) & halfspace({0, 0, -1}, -0.5), {{{0.5, 1, ball}}, pi * 0.75});
  add("zone of a ball", sphere(1) & box({4, 4, 0.5}, centered), {{{-0.25, 0.25, ball}}, 2 * pi * (1 - 0.0625)});
  const double high = std::sqrt(1 - 0.36);
  add("ball with a bore", sphere(1) - cylinder(4, 0.6, 0.6, centered), {{{-high, high, ball, constant(0.6)}}});
  add("shell", sphere(1) - sphere(0.75), {{{-1, -0.75, ball}, {-0.75, 0.75, ball, {0.5625, 0, -1}}, {0.75, 1, ball}}});
  add("thin shell", sphere(1) - sphere(0.999),
      {{{-1, -0.999, ball}, {-0.999, 0.999, ball, {0.999 * 0.999, 0, -1}}, {0.999, 1, ball}}});
  add("tube", cylinder(2, 1, 1, centered) - cylinder(4, 0.9, 0.9, centered),
      {{{-1, 1, constant(1), constant(0.9)}}, 2 * ring(1, 0.9)});
  add("lens", shifted(sphere(1), {0, 0, -0.5}) & shifted(sphere(1), {0, 0, 0.5}),
      {{{-0.5, 0, {0.75, 1, -1}}, {0, 0.5, {0.75, -1, -1}}}});
  add("two balls", shifted(sphere(1), {0, 0, -0.5}) + shifted(sphere(1), {0, 0, 0.5}),
      {{{-1.5, 0, {0.75, -1, -1}}, {0, 1.5, {0.75, 1, -1}}}});
  add("capsule", cylinder(2, 1, 1, centered) + shifted(sphere(1), {0, 0, -1}) + shifted(sphere(1), {0, 0, 1}),
      {{{-2, -1, {0, -2, -1}}, {-1, 1, constant(1)}, {1, 2, {0, 2, -1}}}});
  add("countersunk disc",
      cylinder(1, 1, 1) - shifted(cylinder(2, 0.25, 0.25, centered), {0, 0, 0}) -
          shifted(cylinder(0.25, 0.25, 0.5), {0, 0, 0.75}),
      {{{0, 0.75, constant(1), constant(0.25)}, {0.75, 1, constant(1), {0.25, -1, 1}}}, ring(1, 0.25) + ring(1, 0.5)});
  add("ball in a cylinder that it touches", cylinder(2, 1, 1, centered) - sphere(1),
      {{{-1, 1, constant(1), ball}}, 2 * ring(1, 0)});
  add("bowl", paraboloid(2, 1) - shifted(paraboloid(1, 0.5), {0, 0, 1}),
      {{{0, 1, {0, 0.5, 0}}, {1, 2, {0, 0.5, 0}, {-0.25, 0.25, 0}}}, ring(1, 0.5)});
  add("cylinder less the hourglass that touches it", cylinder(2, 1, 1, centered) - hyperboloid(2, 1, 0.5),
      {{{-1, 1, constant(1), {0.25, 0, 0.75}}}});
  add("zone of a spheroid", ellipsoid({0.5, 0.5, 1.5}) & box({4, 4, 1.5}, centered),
      {{{-0.75, 0.75, {0.25, 0, -0.25 / 2.25}}}, 2 * pi * 0.25 * 0.75});
  add("spool",
      unite({cylinder(2, 0.5, 0.5, centered), shifted(cylinder(0.25, 1, 1), {0, 0, -1}),
             shifted(cylinder(0.25, 1, 1), {0, 0, 0.75})}),
      {{{-1, -0.75, constant(1)}, {-0.75, 0.75, constant(0.5)}, {0.75, 1, constant(1)}},
       2 * ring(1, 0) + 2 * ring(1, 0.5)});
  add("disc with a dome", shifted(cylinder(1, 1, 1), {0, 0, -1}) + sphere(0.5),
      {{{-1, 0, constant(1)}, {0, 0.5, {0.25, 0, -1}}}, ring(1, 0) + ring(1, 0.5)});
  add("drilled cone", cylinder(2, 1, 0) - cylinder(9, 0.25, 0.25, centered),
      {{{0, 1.5, {1, -1, 0.25}, constant(0.25)}}, ring(1, 0.25)});
  add("cone on a ball that it touches in a circle",
      // A ball of radius 1, and the cone of tangents from (0, 0, 2) down to its circle at z = 1/2.
      sphere(1) + shifted(cylinder(1.5, std::sqrt(0.75), 0), {0, 0, 0.5}),
      {{{-1, 0.5, ball}, {0.5, 2, {4.0 / 3, -4.0 / 3, 1.0 / 3}}}});
  return cases;
}

std::vector<Case> other_solids() {
  const auto centered = Centering::centered;
  const Solid along_z = cylinder(4, 1, 1, centered);
  const Solid along_x = transformed(along_z, rotation(Vector{0, 90, 0}));
  const Solid along_y = transformed(along_z, rotation(Vector{90, 0, 0}));
  std::vector<Case> cases;
  cases.push_back({"box", box({1, 2, 3}, centered), known_box({1, 2, 3})});
  cases.push_back({"ellipsoid", ellipsoid({0.5, 1, 1.5}), known_ellipsoid({0.5, 1, 1.5})});
  cases.push_back({"corner", box({1, 1, 1}) & halfspace({1, 1, 1}, 1), known_corner(1)});
  const std::vector<Point> corners{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  cases.push_back({"octahedron",
                   convex_from_points(corners),
                   {4.0 / 3, 4 * std::sqrt(3.0), {}, {4.0 / 15, 4.0 / 15, 4.0 / 15, 0, 0, 0}}});
  const std::vector<Point> regular{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  cases.push_back({"tetrahedron",
                   convex_from_points(regular),
                   {8.0 / 3, 8 * std::sqrt(3.0), {}, {16.0 / 15, 16.0 / 15, 16.0 / 15, 0, 0, 0}}});
  const std::vector<Point> wedge{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  cases.push_back({"prism",
                   convex_from_points(wedge),
                   {1,
                    1 + 2 * (2 + std::sqrt(2.0)),
                    {1.0 / 3, 1.0 / 3, 1},
                    {1.0 / 18 + 1.0 / 3, 1.0 / 18 + 1.0 / 3, 1.0 / 9, 1.0 / 36, 0, 0}}});
  cases.push_back({"bicylinder", along_x & along_y, {16.0 / 3, 16, {}, {NAN, NAN, NAN, 0, 0, 0}}});
  cases.push_back({"tricylinder",
                   along_x & along_y & along_z,
                   {8 * (2 - std::sqrt(2.0)), 24 * (2 - std::sqrt(2.0)), {}, {NAN, NAN, NAN, 0, 0, 0}}});
  Known bored = known_box({2, 2, 1});
  const double hole = pi * 0.25;
  bored.volume -= hole;
  bored.area += 2 * pi * 0.5 - 2 * hole;
  bored.inertia[0] -= hole * (3 * 0.25 + 1) / 12;
  bored.inertia[1] = bored.inertia[0];
  bored.inertia[2] -= hole * 0.25 / 2;
  cases.push_back({"box with a bore", box({2, 2, 1}, centered) - cylinder(2, 0.5, 0.5, centered), bored});
  Known flush = known_box({2, 1, 1});
  cases.push_back({"two flush cubes",
                   shifted(box({1, 1, 1}, centered), {-0.5, 0, 0}) + shifted(box({1, 1, 1}, centered), {0.5, 0, 0}),
                   flush});
  // A wall of half its thickness on either side of what is cut away.
  Known frame = known_box({2, 2, 2});
  const Known cavity = known_box({1, 1, 1});
  frame.volume -= cavity.volume;
  frame.area += cavity.area;
  for (std::size_t i = 0; i < 6; ++i) frame.inertia[i] -= cavity.inertia[i];
  cases.push_back({"hollow box", box({2, 2, 2}, centered) - box({1, 1, 1}, centered), frame});
  return cases;
}

std::vector<Case> cylinders_and_saddles() {
  const auto centered = Centering::centered;
  std::vector<Case> cases;
  // x² <= z <= 1, |y| <= 1/2: a parabolic cylinder.
  cases.push_back({"parabolic cylinder",
                   quadric({1, 0, 0, 0, 0, 0}, {0, 0, -1}, 0) & shifted(box({2, 1, 1}), {-1, -0.5, 0}),
                   {4.0 / 3,
                    2 * (4.0 / 3) + 2 + std::sqrt(5.0) + std::asinh(2.0) / 2,
                    {0, 0, 0.6},
                    {1.0 / 9 + 16.0 / 175, 16.0 / 175 + 4.0 / 15, 1.0 / 9 + 4.0 / 15, 0, 0, 0}}});
  // x² - y² >= 1 on one side, x <= 2, |z| <= 1/2: a hyperbolic cylinder.
  const double half_chord = std::sqrt(3.0);
  cases.push_back({"hyperbolic cylinder",
                   quadric({-1, 1, 0, 0, 0, 0}, {0, 0, 0}, 1) & shifted(box({2, 4, 1}), {0, -2, -0.5}),
                   {2 * half_chord - std::acosh(2.0), 0, {NAN, 0, 0}, {NAN, NAN, NAN, 0, 0, 0}}});
  // x² + 4 y² <= 1, |z| <= 1/2: an elliptic cylinder.
  const double ellipse = pi / 2;
  cases.push_back({"elliptic cylinder",
                   quadric({1, 4, 0, 0, 0, 0}, {0, 0, 0}, -1) & box({4, 4, 1}, centered),
                   {ellipse,
                    0,
                    {},
                    {ellipse * (0.25 / 4 + 1.0 / 12), ellipse * (1.0 / 4 + 1.0 / 12), ellipse * (1.25 / 4), 0, 0, 0}}});
  // z between -1 and x y over the unit square: a hyperbolic paraboloid on top.
  cases.push_back({"saddle",
                   quadric({0, 0, 0, -0.5, 0, 0}, {0, 0, 1}, 0) & shifted(box({1, 1, 3}), {0, 0, -1}),
                   {1.25, 0, {0, 0, 0}, {NAN, NAN, NAN, NAN, NAN, NAN}}});
  cases.back().known.centroid = {(0.5 + 1.0 / 6) / 1.25, (0.5 + 1.0 / 6) / 1.25, (-0.5 + 1.0 / 18) / 1.25};
  return cases;
}

std::vector<Case> all_solids() {
  std::vector<Case> cases = solids_of_revolution();
  for (Case& other : other_solids()) cases.push_back(std::move(other));
  for (Case& other : cylinders_and_saddles()) cases.push_back(std::move(other));
  return cases;
}

void check_one(const std::string& name, Solid solid, const Known& known) {
  INFO(name);
  const Scene scene = compile(std::move(solid));
  MeasureOptions options;
  options.relative_error = 1e-6;
  const Measures m = measure(scene, scene.root(), 1, options);
  CHECK(m.is_as_asked);
  CHECK(m.volume.error <= 1e-6 * known.volume);
  // The closed forms, and entries of rotations, round by a few 1e-16 themselves.
  const double own = 1e-14;
  CHECK(std::fabs(m.volume.value - known.volume) <= m.volume.error + own * known.volume);
  if (known.area > 0) {
    CHECK(std::fabs(m.area.value - known.area) <= m.area.error + own * known.area);
    CHECK(m.area.error <= 1e-3 * known.area);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isnan(known.centroid[i]))
      CHECK(std::fabs(m.centroid[i] - known.centroid[i]) <=
            m.centroid_error + own * (1 + std::fabs(known.centroid[i])));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    if (!std::isnan(known.inertia[i]))
      CHECK(std::fabs(m.inertia[i] - known.inertia[i]) <= m.inertia_error + own * (1 + std::fabs(known.inertia[i])));
  }
}

}  // namespace

// Sanitizers look at some of them.
constexpr std::size_t step = test::is_sanitized ? 5 : 1;

TEST_CASE("Measures of solids with closed forms are within their errors") {
  const std::vector<Case> all = all_solids();
  for (std::size_t i = 0; i < all.size(); i += step) check_one(all[i].name, all[i].solid, all[i].known);
}

TEST_CASE("Measures of turned and moved solids with closed forms are within their errors") {
  Transform turn = rotation(30, Vector{1, 2, 3});
  for (std::size_t i = 0; i < 3; ++i) turn.entry[4 * i + 3] = 5.0 - 3.0 * static_cast<double>(i);
  const std::vector<Case> all = all_solids();
  for (std::size_t i = step / 2; i < all.size(); i += step)
    check_one(all[i].name, transformed(all[i].solid, turn), moved(all[i].known, turn));
}
