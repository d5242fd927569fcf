// SPDX-License-Identifier: MIT
#include "measure/section_polylines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "measure/section_json.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

double distance(PlanePoint p, PlanePoint a, PlanePoint b) {
  const double du = b.u - a.u, dv = b.v - a.v;
  const double along = std::clamp(((p.u - a.u) * du + (p.v - a.v) * dv) / (du * du + dv * dv), 0.0, 1.0);
  return std::hypot(p.u - a.u - along * du, p.v - a.v - along * dv);
}

double distance(PlanePoint p, const std::vector<PlanePoint>& line) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) least = std::min(least, distance(p, line[i], line[i + 1]));
  return least;
}

/// A section of one arc of a conic, and a straight one back.
Section section_of(const std::array<double, 6>& conic, PlanePoint from, PlanePoint middle, PlanePoint to) {
  Section section;
  section.loops.push_back({{conic, from, middle, to, SurfaceId(0)}, {{}, to, {}, from, SurfaceId(1)}});
  return section;
}

}  // namespace

TEST_CASE("polylines are within the tolerance of every kind of conic, far round and flat alike") {
  for (const double tolerance : {0.3, 1e-2, 1e-5}) {
    CAPTURE(tolerance);
    // A thin ellipse, nearly all of it.
    const auto ellipse = [](double t) { return PlanePoint{50 + 4 * std::cos(t), -20 + 0.05 * std::sin(t)}; };
    const double a = 1 / 16.0, c = 400;
    const std::array<double, 6> conic{a, 0, c, -100 * a, 40 * c, 2500 * a + 400 * c - 1};
    const auto lines = section_polylines(section_of(conic, ellipse(0.1), ellipse(2), ellipse(6.1)), tolerance);
    for (int i = 0; i <= 3000; ++i) CHECK(distance(ellipse(0.1 + i * 0.002), lines[0]) <= tolerance + 1e-9);
    // A parabola about its apex, v = u².
    const std::array<double, 6> parabola{1, 0, 0, 0, -1, 0};
    const auto bent = section_polylines(section_of(parabola, {-3, 9}, {2, 4}, {30, 900}), tolerance);
    for (double u = -3; u <= 30; u += 0.01) CHECK(distance({u, u * u}, bent[0]) <= tolerance + 1e-9);
    // A branch of u² - v² = 1, whose other branch is near.
    const std::array<double, 6> hyperbola{1, 0, -1, 0, 0, -1};
    const auto branch = [](double t) { return PlanePoint{-std::cosh(t), std::sinh(t)}; };
    const auto wide = section_polylines(section_of(hyperbola, branch(-3), branch(2.5), branch(4)), tolerance);
    for (double t = -3; t <= 4; t += 0.003) CHECK(distance(branch(t), wide[0]) <= tolerance + 1e-9);
    for (const PlanePoint& p : wide[0]) CHECK(p.u < 0);
  }
}

TEST_CASE("a finer tolerance takes about the square root of its points, and straight arcs none") {
  const Section ring = section(compile(sphere(1) - sphere(0.5)), {{0, 0, 1}, 0});
  const auto count = [&](double tolerance) { return section_polylines(ring, tolerance)[0].size(); };
  CHECK(count(1e-2) < 100);
  CHECK(count(1e-6) < 150 * count(1e-2));
  CHECK(count(1e-6) > 20 * count(1e-2));
  const Section square = section(compile(box({1, 1, 1}, Centering::centered)), {{0, 0, 1}, 0});
  const auto lines = section_polylines(square, 1e-9);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].size() == 5);
  CHECK(lines[0].front().u == lines[0].back().u);
}

TEST_CASE("polylines refuse what makes no sense") {
  const Scene ball = compile(sphere(1));
  const Section round = section(ball, {{0, 0, 1}, 0});
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    CHECK_THROWS_AS(section_polylines(round, tolerance), Error);
  CHECK_THROWS_AS(section_polylines(round, 1e-300), Error);  // as many points as there are doubles
  // An arc of few doubles takes few points.
  const auto short_one = section_of({1, 0, 1, 0, 0, -1}, {1, 0}, {1, 1e-9}, {1, 2e-9});
  CHECK(section_polylines(short_one, 1e-300)[0].size() < 10);
  const Section unbounded = section(compile(halfspace({0, 0, 1}, 0)), {{1, 0, 0}, 0});
  CHECK_THROWS_AS(section_polylines(unbounded, 1), Error);
  CHECK(section_polylines(section(ball, {{0, 0, 1}, 9}), 1).empty());
}

TEST_CASE("the JSON of a section is whole where it has no loops and where numbers are infinite") {
  const std::string empty = section_json(section(compile(sphere(1)), {{0, 0, 1}, 9}));
  CHECK(empty.find("\"loops\": []\n}\n") != std::string::npos);
  const std::string unbounded = section_json(section(compile(halfspace({0, 0, 1}, 0)), {{1, 0, 0}, 0}));
  CHECK(unbounded.find("\"unbounded\": true") != std::string::npos);
  CHECK(unbounded.find("\"area\": null") != std::string::npos);
}
