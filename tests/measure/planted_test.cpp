// SPDX-License-Identifier: MIT
// Pieces of leaves that are truth functions, and of a kind of surface of which only its sides in boxes are known.
#include <cmath>

#include "csg/base/transform.h"
#include "csg/solid/primitives.h"
#include "measure/measure.h"
#include "measure/section.h"
#include "raycast/scene/detail/compile.h"
#include "tests/support/catch.h"
#include "tests/support/planted.h"

using namespace csgcast;
using test::cut_cube;
using test::cut_cube_of_boxes;
using test::l_prism;

namespace {

Scene compiled(const Solid& solid) { return detail::compile(solid, {}, test::planted_kinds()); }

bool holds(const Measured& measured, double exact) { return std::fabs(measured.value - exact) <= measured.error; }

Solid turned(const Solid& solid) {
  return transformed(transformed(solid, rotation({20, 30, 40})), translation({3, -1, 2}));
}

}  // namespace

TEST_CASE("Volume and area of truth functions of planes are as certain as those of boxes") {
  for (const bool is_turned : {false, true}) {
    const Solid l = is_turned ? turned(l_prism(true)) : l_prism(true);
    const Scene scene = compiled(l);
    const Measures m = measure(scene, scene.root(), 1);
    CHECK(m.is_as_asked);
    CHECK(holds(m.volume, 3));
    CHECK(holds(m.area, 2 * 3 + 8));
    const Scene cut = compiled(l - (is_turned ? turned(sphere(1)) : sphere(1)));
    const Measures of_cut = measure(cut, cut.root(), 1);
    CHECK(of_cut.is_as_asked);
    CHECK(holds(of_cut.volume, 3 - M_PI / 6));
  }
}

TEST_CASE("Leaves that tell more in smaller boxes are measured all the same") {
  const Scene l = compiled(l_prism(true) - sphere(1));
  MeasureOptions options;
  options.relative_error = 0.02;
  options.most_pieces = 40000;
  for (const bool tells_terms : {false, true}) {
    const Scene reluctant = test::with_reluctant_leaves(l, 1.2, tells_terms);
    const Measures m = measure(reluctant, reluctant.root(), 1, options);
    CHECK(m.is_as_asked == tells_terms);  // or the part beside the faces stays open, and with it the area
    CHECK(holds(m.volume, 3 - M_PI / 6));
    CHECK(m.volume.error < 0.1 * m.volume.value);
    CHECK(m.area.value + m.area.error >= 2 * 3 + 8 - 3 * M_PI / 4 + M_PI / 2);
    CHECK(m.area.value - m.area.error <= 2 * 3 + 8 - 3 * M_PI / 4 + M_PI / 2);
  }
}

TEST_CASE("The volume of a surface of which only the sides of boxes are known has a bound that closes in") {
  const Scene scene = compiled(cut_cube(0.25, 0.5, 0.75));
  const Scene boxes = compiled(cut_cube_of_boxes(0.25, 0.5, 0.75));
  const double exact = measure(boxes, boxes.root(), 1).volume.value;
  double last = 1;
  for (const std::size_t pieces : {std::size_t{1000}, std::size_t{100000}}) {
    MeasureOptions options;
    options.most_pieces = pieces;
    const Measures m = measure(scene, scene.root(), 1, options);
    CHECK(holds(m.volume, exact));
    CHECK(m.volume.error < 0.5 * last);
    last = m.volume.error;
    CHECK(std::isfinite(m.area.error));
  }
}

TEST_CASE("Sections of planted solids have the areas of the same sets of boxes") {
  for (const Vector normal : {Vector{0, 0, 1}, Vector{1, 2, 3}}) {
    const Plane plane{normal, normal.x == 0 ? 0.3 : 1};
    const Solid both = l_prism(true) - transformed(cut_cube(0.25, 0.5, 0.75), translation({0.5, 0.5, -0.2}));
    const Solid boxes =
        test::l_prism_of_boxes() - transformed(cut_cube_of_boxes(0.25, 0.5, 0.75), translation({0.5, 0.5, -0.2}));
    const SectionOptions coarse{1e-3};
    const Section exact = section(compiled(boxes), plane);
    const Section found = section(compiled(both), plane, coarse);
    CHECK(std::fabs(found.area.value - exact.area.value) <= found.area.error + exact.area.error);
    CHECK(found.area.error < 0.2 * found.area.value);
    const Section of_reluctant = section(test::with_reluctant_leaves(compiled(both), 1.2, true), plane, coarse);
    CHECK(std::fabs(of_reluctant.area.value - exact.area.value) <= of_reluctant.area.error + exact.area.error);
  }
}
