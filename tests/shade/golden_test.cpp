// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/shade/models.h"

// Pictures as text, every second row (characters are about twice as high as wide). tests/golden/*.txt hold what they
// should be.

using namespace csgcast;
using namespace csgcast::test;

namespace {

constexpr int size = 64;

template <class Symbol>
std::string as_text(const Film& film, Symbol&& symbol) {
  std::string text;
  for (int y = 1; y < size; y += 2) {
    for (int x = 0; x < size; ++x) text += symbol(film, x, y);
    text += '\n';
  }
  return text;
}

// A letter for each leaf in file order, a dot for nothing.
std::string leaf_mask(const Solid& solid, const View& view) {
  const auto letter = [](const Film& film, int x, int y) {
    const int id = static_cast<int>(film.value(x, y));
    return id < 0 ? '.' : static_cast<char>('a' + id % 26);
  };
  return as_text(render(compile(solid), view, picture(size, size, Mode::id)), letter);
}

// A digit for the lightness: tenths of 1 in the 8-bit picture.
std::string grey_levels(const Solid& solid, const View& view) {
  const auto digit = [](const Film& film, int x, int y) {
    const Rgb c = film.rgb(x, y);
    const double grey = srgb_from_linear(std::clamp(0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b, 0.0, 1.0));
    return static_cast<char>('0' + std::min(9, static_cast<int>(10 * grey)));
  };
  return as_text(render(compile(solid), view, picture(size, size)), digit);
}

std::string golden(const std::string& name) {
  std::ifstream file(std::string(CSGCAST_SOURCE_DIR) + "/tests/golden/" + name + ".txt");
  return {std::istreambuf_iterator<char>(file), {}};
}

Solid unbounded_quadrics() {
  const Solid saddle = quadric({1, -1, 0, 0, 0, 0}, {0, 0, 1}, 0);       // z <= y² - x²
  const Solid double_cone = quadric({1, 1, -1, 0, 0, 0}, {0, 0, 0}, 0);  // x² + y² <= z²
  return intersect({saddle, box({3, 3, 3}, Centering::centered)}) +
         (double_cone & at(box({1.6, 1.6, 2.4}, Centering::centered), {0, 0, 0.4}));
}

}  // namespace

TEST_CASE("golden: which leaf each pixel of box and ball less cylinders shows") {
  REQUIRE(leaf_mask(angel(), standard_view()) == golden("angel_leaves"));
}

TEST_CASE("golden: which leaf each pixel shows where all faces coincide") {
  REQUIRE(leaf_mask(flush(3), standard_view({1.5, 1.5, 0.5}, 9)) == golden("flush_leaves"));
}

TEST_CASE("golden: which leaf each pixel of a saddle and a double cone shows") {
  REQUIRE(leaf_mask(unbounded_quadrics(), standard_view({0, 0, 0}, 9)) == golden("quadrics_leaves"));
}

TEST_CASE("golden: the greys of mirrors, glass and shadows") {
  const std::string is = grey_levels(still_life(), standard_view({0, 0, 0}, 14));
  const std::string should_be = golden("still_life_greys");
  CAPTURE(is);
  REQUIRE(is.size() == should_be.size());
  // Another pow() may move a grey across a tenth, here and there and by one.
  std::size_t differing = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    REQUIRE(std::abs(is[i] - should_be[i]) <= 1);
    differing += is[i] != should_be[i] ? 1 : 0;
  }
  REQUIRE(differing <= is.size() / 200);
}
