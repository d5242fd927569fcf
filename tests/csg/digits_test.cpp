// SPDX-License-Identifier: MIT
#include "csg/base/digits.h"

#include <cmath>
#include <string>

#include "csg/base/transform.h"
#include "csg/exact/composition.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

Digits digits_of(const std::string& text) { return text::build(text::read(text, "a.csg")).digits; }

constexpr double u = 0x1p-53;

}  // namespace

TEST_CASE("digits of a number are counted as written, and as its shortest form has them") {
  CHECK(digits_written("0.01230") == 3);
  CHECK(digits_written("-123e4") == 3);
  CHECK(digits_written("100500.0") == 4);
  CHECK(digits_written("0.000") == 0);
  CHECK(digits_used(0) == 0);
  CHECK(digits_used(-0.0123) == 3);
  CHECK(digits_used(1e300) == 1);
  CHECK(digits_used(0.1 + 0.2) == 17);
  CHECK(digits_used(5e-324) == 1);
}

TEST_CASE("a number that uses all digits is known to half a unit of the last, a shorter one is what it says") {
  const Digits six(6);
  CHECK(six.error(0.838671) == Approx(0.5e-6).epsilon(1e-9));
  CHECK(six.error(-12.5801) == Approx(0.5e-4).epsilon(1e-9));
  CHECK(six.error(1.23457e-7) == Approx(0.5e-12).epsilon(1e-9));
  CHECK(six.error(123456) == Approx(0.5).epsilon(1e-9));
  CHECK(six.error(0.83867) == Approx(0.5e-6).epsilon(1e-9));
  CHECK(six.error(12.58) == Approx(0.5e-4).epsilon(1e-9));
  CHECK(six.error(12.5) == u * 12.5);
  CHECK(six.error(1258) == u * 1258);
  CHECK(six.error(20) == u * 20);
  CHECK(six.error(0) == 0);
  CHECK(six.error(0.8386712) == u * 0.8386712);
  CHECK(six.error_beside_longer(0.83867) == Approx(0.5e-6).epsilon(1e-9));
  CHECK(six.error_beside_longer(20) == Approx(0.5e-4).epsilon(1e-9));
  CHECK(six.error_beside_longer(0) == 0);
  CHECK(Digits().error(0.838671) == u * 0.838671);
  CHECK(Digits(16).error(0.1234567890123456) == u * 0.1234567890123456);
}

TEST_CASE("a matrix knows its entries by the longest, but for zeros and what stands alone") {
  Transform turn{.entry = {1, 0, 0, 20, 0, 0.838671, -0.54464, 12.5801, 0, 0.54464, 0.838671, 0}, .digits = Digits(6)};
  const auto errors = turn.errors();
  CHECK(errors[0] == u);
  CHECK(errors[1] == 0);
  CHECK(errors[3] == Approx(0.5e-4).epsilon(1e-9));
  CHECK(errors[5] == Approx(0.5e-6).epsilon(1e-9));
  CHECK(errors[6] == Approx(0.5e-6).epsilon(1e-9));
  CHECK(errors[11] == 0);
  turn.entry = {1, 0, 0, 20, 0, 0.8, -0.6, 12.5, 0, 0.6, 0.8, 0};
  for (std::size_t i = 0; i < 12; ++i) CHECK(turn.errors()[i] == u * std::fabs(turn.entry[i]));
}

TEST_CASE("turns by angles of few digits are known as well as the angles, about axes likewise") {
  const double half_unit = 0.5e-4 * M_PI / 180;
  CHECK(rotation(Vector{0, 0, 54.7356}, Digits(6)).linear_error == Approx(half_unit).epsilon(1e-6));
  CHECK(rotation(54.7356, {0, 0, 1}, Digits(6)).linear_error == Approx(half_unit).epsilon(1e-6));
  CHECK(rotation(30, {0.577351, 0.577351, 0.577351}, Digits(6)).linear_error == Approx(12 * 0.5e-6).epsilon(1e-3));
  CHECK(rotation(Vector{0, 0, 54.7356}).linear_error < 1e-14);
  const Transform product = translation({12.3457, 0, 0}, Digits(6)) * rotation(Vector{0, 0, 54.7356}, Digits(6));
  CHECK(product.linear_error >= half_unit);
  CHECK(product.offset_error >= 0.5e-4);
  CHECK(product.offset_error < 0.6e-4);
}

TEST_CASE("what numbers of a text show, and what its settings say") {
  CHECK(digits_of("sphere(1.23457);") == Digits(6));
  CHECK(digits_of("translate([0.1234567, 2, 3]) sphere(1.23457);") == Digits(7));
  CHECK(digits_of("sphere(1.2346);") == Digits());
  CHECK(digits_of("sphere(1.234567890123456);") == Digits());
  CHECK(digits_of("sphere(1.2345678901234567); sphere(1.23457);") == Digits());
  CHECK(digits_of("translate([123456, 654321, 0]) cube(1234567);") == Digits());
  CHECK(digits_of("sphere(1.50000);") == Digits());
  CHECK(digits_of("sphere(1, $fs = 0.523599);") == Digits());
  CHECK(digits_of("color([0.123456, 0, 0]) part(\"a\", 1.23457) sphere(1);") == Digits());
  CHECK(digits_of("camera(eye = [1.23457, 0, 0], look_at = [0, 0, 0]); sphere(1);") == Digits());
  CHECK(digits_of("union() { difference() { cube(1); scale(0.123456) cube(1); } }") == Digits(6));
  CHECK(digits_of("sphere(1.23457); settings(digits = 17);") == Digits(17));
  CHECK(digits_of("settings(5, 0.01, 4); sphere(1.234);") == Digits(4));
  for (const char* wrong : {"0", "18", "6.5", "-1"})
    CHECK_THROWS_WITH(digits_of(std::string("settings(digits = ") + wrong + "); sphere(1);"),
                      Catch::Contains("'digits' of 'settings' must be a whole number from 1 to 17"));
}

TEST_CASE("a text keeps what is known of its numbers when it is written") {
  for (const std::string text :
       {"multmatrix([[0.838671, -0.54464, 0, 1], [0.54464, 0.838671, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]) sphere(1.5);",
        "translate([1.23457, 2, 3]) rotate([0, 0, 54.7356]) cube([1, 2, 3.45679]);",
        "rotate(12, [1, 2, 3]) cylinder(h = 2, r1 = 1, r2 = 0.5);", "cylinder(h = 12.3457, r = 5.7735, $fn = 6);",
        "convex(points = [[0, 0, 0], [1.23457, 0, 0], [0, 2, 0], [0, 0, 3]]);",
        "halfspace([0.577351, 0.577351, 0.577351], 2);", "settings(digits = 17); sphere(1.23457);",
        "settings(digits = 3); sphere(1.23);",
        "multmatrix([[2, 0, 0, 1.23457], [0, 2, 0, 1], [0, 0, 2, 0], [0, 0, 0, 2]]) sphere(1.23457);"}) {
    INFO(text);
    const SceneDescription scene = text::build(text::read(text, "a.csg"));
    const std::string written = text::write(text::document_of(scene.solid));
    INFO(written);
    const SceneDescription again = text::build(text::read(written, "b.csg"), {text::Facets::never});
    CHECK(text::write(text::document_of(again.solid)) == written);
    const Solid *a = &scene.solid, *b = &again.solid;
    for (; a->kind() != Solid::Kind::leaf; a = &a->children().front(), b = &b->children().front()) {
      REQUIRE(b->kind() == a->kind());
      if (a->kind() != Solid::Kind::transform) continue;
      const auto errors = a->transform().errors(), errors_again = b->transform().errors();
      for (std::size_t i = 0; i < 12; ++i) CHECK(errors_again[i] == Approx(errors[i]).epsilon(1e-9));
    }
    REQUIRE(b->kind() == Solid::Kind::leaf);
    CHECK(b->shape().error.axes == a->shape().error.axes);
    CHECK(b->shape().error.errors == a->shape().error.errors);
  }
}
