// SPDX-License-Identifier: MIT
#include <cmath>

#include "tests/shade/models.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

bool is_ink(const Film& film, int x, int y) { return film.value(x, y, 0) < 0.1F; }

int ink(const Film& film) {
  int count = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) count += is_ink(film, x, y) ? 1 : 0;
  }
  return count;
}

// Seen along y, a picture of 100 x 100 pixels of size 1/10.
View front_view() {
  View view = standard_view();
  view.camera = {{0, -20, 0}, {0, 0, 0}, {0, 0, 1}, 30, 10.0};
  return view;
}

}  // namespace

TEST_CASE("the outline of a ball is a closed line one pixel wide and nothing is drawn within") {
  const Film film = render(compile(sphere(4)), front_view(), picture(100, 100, Mode::edges));
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const double radius = std::hypot(x + 0.5 - 50, y + 0.5 - 50) / 10;
      if (std::fabs(radius - 4) > 0.15) REQUIRE_FALSE(is_ink(film, x, y));
    }
  }
  // Steps right and down cross an outline at least once for each row and column that it spans, on both sides.
  REQUIRE(ink(film) >= 2 * 80 * 0.7);
  REQUIRE(ink(film) <= 4 * 80);
}

TEST_CASE("touching bricks with faces in one plane have no line between them, a step of a hundredth has") {
  const auto line_at_middle = [](double step) {
    const Solid bricks = block({-3, 0, -3}, {0, 1, 3}) + block({0, step, -3}, {3, 1, 3});
    const Film film = render(compile(bricks), front_view(), picture(100, 100, Mode::edges));
    return is_ink(film, 49, 50) || is_ink(film, 50, 50);
  };
  REQUIRE_FALSE(line_at_middle(0));
  REQUIRE(line_at_middle(0.01));
}

TEST_CASE("where a surface hides itself there is a line") {
  // A bowl, and in its left half the ball that fits it: left of the middle one sees the near side of the sphere, right
  // of it the far side.
  const Solid ball = sphere(4);
  const Solid scene = (block({-5, 0, -5}, {5, 5, 5}) - ball) + (ball & halfspace({1, 0, 0}, 0));
  const Film film = render(compile(scene), front_view(), picture(100, 100, Mode::edges));
  for (int y = 20; y < 80; ++y) {
    REQUIRE(is_ink(film, 49, y));
    REQUIRE_FALSE(is_ink(film, 40, y));
    REQUIRE_FALSE(is_ink(film, 60, y));
  }
}

TEST_CASE("lines keep their width when samples are averaged") {
  RenderOptions options = picture(100, 100, Mode::edges);
  const auto darkness = [&](int samples) {
    options.samples = samples;
    const Film film = render(compile(block({-3, 0, -3}, {3, 1, 3})), front_view(), options);
    double sum = 0;
    for (int y = 20; y < 80; ++y) {
      for (int x = 15; x < 25; ++x) sum += film.value(x, y, 0) < 0.9F ? 0.95 - film.value(x, y, 0) : 0;
    }
    return sum;
  };
  REQUIRE(darkness(4) == Approx(darkness(1)).epsilon(0.1));
  REQUIRE(darkness(16) == Approx(darkness(1)).epsilon(0.1));
}
