// SPDX-License-Identifier: MIT
// Solids as programs write them that print six digits: what was flush is flush, what was not stays so.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"
#include "tests/support/rounded_leaves.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

std::string printed(double value) { return fmt::format("{:g}", value); }

std::string printed(Vector v) { return fmt::format("[{}, {}, {}]", printed(v.x), printed(v.y), printed(v.z)); }

std::string printed(const Transform& t) {
  std::string rows;
  for (std::size_t i = 0; i < 3; ++i)
    rows += fmt::format("[{}, {}, {}, {}], ", printed(t(i, 0)), printed(t(i, 1)), printed(t(i, 2)), printed(t(i, 3)));
  return "multmatrix([" + rows + "[0, 0, 0, 1]]) ";
}

Scene compiled(const std::string& text) {
  return compile(text::build(text::read(text, "export.csg")).solid, Welding::derived());
}

std::size_t intervals_on(const Scene& scene, Point from, Vector direction) {
  Caster caster(scene);
  caster.begin(Ray(from, direction));
  IntervalList list;
  caster.intervals(list, Span::line());
  return list.size();
}

/// A block, turned by one matrix a leaf, or by one about all, or by two nested ones.
struct Export {
  Export(RandomSolids& random, int axes)
      : scale(std::pow(10.0, random.number(0, 2.2))),
        size{scale * random.number(2, 5), scale * random.number(2, 5), scale * random.number(1, 4)},
        turn(rotation(Vector{angle(random, axes > 2), angle(random, axes > 1), angle(random, true)})),
        moved(translation({random.number(-3, 3) * scale, random.number(-3, 3) * scale, 0})) {}

  static double angle(RandomSolids& random, bool is_turned) {
    return is_turned ? std::round(random.number(1, 359) * 10) / 10 : 0;
  }

  /// What turns a leaf that is moved by `offset` in the block.
  std::string leaf(Vector offset, const std::string& solid, int way) const {
    const Transform whole = moved * turn;
    if (way == 0) return printed(whole * translation(offset)) + solid;
    // As OpenSCAD prints translate(..) rotate(..), with the offset turned already.
    const Transform inner = turn * translation(offset);
    const Transform outer = translation({inner(0, 3), inner(1, 3), inner(2, 3)});
    return printed(moved) + printed(outer) + printed(turn) + solid;
  }

  Point at(Point p) const { return test::image(moved * turn, p); }
  Vector along(Vector d) const { return at(as_point(d)) - at({0, 0, 0}); }
  static Point as_point(Vector v) { return {v.x, v.y, v.z}; }

  double scale;
  Vector size;
  Transform turn;
  Transform moved;
};

}  // namespace

TEST_CASE("bores, slots and pads that six digits leave a hundred-thousandth off are flush") {
  RandomSolids random(24);
  for (int i = 0; i < 600; i += test::stride) {
    const Export e(random, 1 + i % 3);
    const auto [a, b, c] = std::array{e.size.x, e.size.y, e.size.z};
    const auto way = [&](int leaf) { return (i / 3 + leaf) % 2; };
    const double r = 0.1 * std::fmin(a, b);
    const Vector bore{0.25 * a, 0.3 * b, 0}, slot{0.6 * a, 0, 0.5 * c}, pad{0.45 * a, 0.6 * b, c};
    const std::string text = "union() { difference() { " + e.leaf({}, "cube(" + printed(e.size) + ");", way(0)) +
                             e.leaf(bore, fmt::format("cylinder(h = {}, r = {});", printed(c), printed(r)), way(1)) +
                             e.leaf(slot, "cube(" + printed(Vector{0.2 * a, b, 0.5 * c}) + ");", way(2)) + "} " +
                             e.leaf(pad, "cube(" + printed(Vector{0.1 * a, 0.1 * b, 0.2 * c}) + ");", way(3)) + "}";
    INFO(i << '\n' << text);
    const Scene scene = compiled(text);
    const Vector up = e.along({0, 0, 1});
    CHECK(intervals_on(scene, e.at({bore.x, bore.y, -c}), up) == 0);
    CHECK(intervals_on(scene, e.at({bore.x + 0.3 * r, bore.y - 0.4 * r, -c}), up) == 0);
    CHECK(intervals_on(scene, e.at({0.7 * a, -b, 0.75 * c}), e.along({0, 1, 0})) == 0);
    CHECK(intervals_on(scene, e.at({0.7 * a, 0.5 * b, -c}), up) == 1);
    CHECK(intervals_on(scene, e.at({0.5 * a, 0.65 * b, -c}), up) == 1);
  }
}

TEST_CASE("gaps of four times what six digits leave open stay, and so do bores that end short") {
  RandomSolids random(25);
  for (int i = 0; i < 400; i += test::stride) {
    const Export e(random, 1 + i % 3);
    const auto [a, b, c] = std::array{e.size.x, e.size.y, e.size.z};
    // Offsets and sizes below 10 s are known to 5e-5 s, below 100 s to 5e-4 s, and entries of turns to 5e-7.
    const double far = 6 * e.scale + a + b + c;
    const double unit = std::pow(10.0, std::floor(std::log10(far)) - 5);
    const double left_open = 0.5 * unit + 3 * 0.5e-6 * far + 0.5 * unit;
    const double gap = i % 2 == 0 ? 4 * 2 * left_open : 3e-4 * c;
    if (i % 2 == 1 && gap < 8 * left_open) continue;
    const Vector bore{0.25 * a, 0.3 * b, gap};
    const std::string text =
        "difference() { " + e.leaf({}, "cube(" + printed(e.size) + ");", i / 2 % 2) +
        e.leaf(bore, fmt::format("cylinder(h = {}, r = {});", printed(c), printed(0.1 * std::fmin(a, b))), i / 2 % 2) +
        "}";
    INFO(i << " gap " << gap << '\n' << text);
    CHECK(intervals_on(compiled(text), e.at({bore.x, bore.y, -c}), e.along({0, 0, 1})) == 1);
  }
}

TEST_CASE("a text of few digits that is written and read again has the same surfaces") {
  RandomSolids random(26);
  for (int i = 0; i < 60; i += test::stride) {
    const Export e(random, 1 + i % 3);
    const std::string text =
        "difference() { " + e.leaf({}, "cube(" + printed(e.size) + ");", i % 2) +
        e.leaf({0.5 * e.size.x, 0.5 * e.size.y, 0},
               fmt::format("cylinder(h = {}, r = {}, $fn = {});", printed(e.size.z), printed(0.3 * e.size.y), i % 7),
               1 - i % 2) +
        "}";
    INFO(text);
    const Solid solid = text::build(text::read(text, "export.csg")).solid;
    const std::string written = text::write(text::document_of(solid));
    INFO(written);
    const Scene once = compile(solid, Welding::derived());
    const Scene again =
        compile(text::build(text::read(written, "again.csg"), {text::Facets::never}).solid, Welding::derived());
    CHECK(again.weld_report().surfaces == once.weld_report().surfaces);
    REQUIRE(again.surfaces().size() == once.surfaces().size());
  }
}

TEST_CASE("thin things of few digits stay: a sheet, a shell, blocks a hundred-thousandth apart in one frame") {
  const auto walls = [](const std::string& text) { return intervals_on(compiled(text), {0.5, 0.5, -9}, {0, 0, 1}); };
  const std::string turn = "multmatrix([[1, 0, 0, 0], [0, 0.838671, -0.544639, 0], [0, 0.544639, 0.838671, 0]]) ";
  CHECK(walls("cube([1.23457, 1.23457, 0.00001]);") == 1);
  CHECK(walls(turn + "{ cube([1.23457, 1, 0.00001]); translate([0, 0, 0.00002]) cube([1, 1, 0.00001]); }") == 2);
  CHECK(walls("difference() { sphere(1.23457); sphere(1.23453); }") == 2);
  CHECK(walls("translate([12.3457, 0, 0]) { translate([-12.3456, 0, 0]) { cube(1); translate([0, 0, 1.00001]) cube(1); "
              "} }") == 2);
}
