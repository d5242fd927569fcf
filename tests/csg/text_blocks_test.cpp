// SPDX-License-Identifier: MIT
#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "tests/support/catch.h"

using namespace csgcast;
using text::Facets;

namespace {

text::Document document(const std::string& text) { return text::read(text, "a.csg"); }

/// The solid as a text of its own.
std::string meaning(const std::string& text, Facets facets = Facets::automatic) {
  return text::write(text::document_of(text::build(document(text), {facets}).solid));
}

std::vector<std::string> warnings(const std::string& text) {
  std::vector<std::string> texts;
  for (const Warning& warning : text::build(document(text)).warnings) texts.push_back(to_string(warning));
  return texts;
}

}  // namespace

TEST_CASE("a child may stand without braces, and so may its child") {
  CHECK(document("translate([1, 2, 3]) cube(2);") == document("translate([1, 2, 3]) { cube(2); }"));
  CHECK(document("translate([1, 2, 3]) rotate(30) cube(2); sphere(1);") ==
        document("translate([1, 2, 3]) { rotate(30) { cube(2); } } sphere(1);"));
  CHECK(document("color(\"red\") translate([1, 0, 0]) { cube(1); sphere(1); } cube(3);") ==
        document("color(\"red\") { translate([1, 0, 0]) { cube(1); sphere(1); } } cube(3);"));
  CHECK(document("difference() { translate([1, 0, 0]) cube(1); % scale(2) # sphere(1); }") ==
        document("difference() { translate([1, 0, 0]) { cube(1); } % scale(2) { # sphere(1); } }"));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "group() ";
  CHECK(document(deep + "cube(1);").nodes.size() == 1);
}

TEST_CASE("a semicolon by itself is nothing, and a block without a statement is its statements") {
  const text::Document plain = document("difference() { cube(2); sphere(1); } cube(3);");
  CHECK(document(";;difference() { cube(2);; sphere(1); };\n;cube(3);;") == plain);
  CHECK(document("{ difference() { { cube(2); } sphere(1); } } { { cube(3); } } {}") == plain);
}

TEST_CASE("where a child is missing, or a semicolon, the error says so") {
  const auto error = [](const std::string& text) -> std::string {
    try {
      meaning(text);
    } catch (const Error& problem) {
      return problem.what();
    }
    return "";
  };
  CHECK(
      error("cube(1)\nsphere(1);") ==
      "a.csg:2:1: error: 'cube' takes no children (only operators, transforms and looks do); end 'cube(..)' with ';'");
  CHECK(error("translate([1, 0, 0])").find("a.csg:1:21: error: expected ';' or '{' after 'translate(..)'") == 0);
  CHECK(error("translate([1, 0, 0]) rotate(3)").find("a.csg:1:31: error: expected ';' or '{' after 'rotate(..)'") == 0);
  CHECK(error("group() }").find("a.csg:1:9: error: expected") == 0);
  CHECK(error("{ cube(1);") == "a.csg:1:1: error: '{' is never closed (the text ends before); add the missing '}'");
  CHECK(error("translate([1, 0, 0]) $fn = 3;").find("a.csg:1:") == 0);
  CHECK(error("$fn = 3 cube(1);").find("expected ';' after the value of '$fn'") != std::string::npos);
  CHECK(error("$fn = 2 * 3;").find("unexpected '*' in a value") != std::string::npos);
  CHECK(error("$fn = \"many\";") != "");
  CHECK(error("wall = 3;").find("'wall' is a variable") != std::string::npos);
}

TEST_CASE("$fn, $fa and $fs hold in all of their block and below, the last one counts, and own arguments win") {
  const std::string hexagon = meaning("cylinder(h = 1, r = 2, $fn = 6);");
  CHECK(meaning("$fn = 6; cylinder(h = 1, r = 2);") == hexagon);
  CHECK(meaning("cylinder(h = 1, r = 2); $fn = 6;") == hexagon);
  CHECK(meaning("$fn = 9; $fn = 6; cylinder(h = 1, r = 2);") == hexagon);
  CHECK(meaning("group() { $fn = 6; group() { cylinder(h = 1, r = 2); } }") == hexagon);
  CHECK(meaning("group($fn = 6) cylinder(h = 1, r = 2);") == hexagon);
  CHECK(meaning("$fn = 9; cylinder(h = 1, r = 2, $fn = 6);") == hexagon);
  const std::string round = meaning("cylinder(h = 1, r = 2);");
  CHECK(round != hexagon);
  CHECK(meaning("group() { $fn = 6; } cylinder(h = 1, r = 2);") == meaning("group() {} cylinder(h = 1, r = 2);"));
  CHECK(meaning("$fn = 6; cylinder(h = 1, r = 2, $fn = 0);") == round);
  CHECK(meaning("*$fn = 6; cylinder(h = 1, r = 2);") == round);
  CHECK(meaning("$fa = 60; $fs = 0.1; cylinder(h = 1, r = 2);", Facets::always) ==
        meaning("cylinder(h = 1, r = 2, $fa = 60, $fs = 0.1);", Facets::always));
  CHECK(warnings("$vpd = 140;\ncube(1);") ==
        std::vector<std::string>{"a.csg:1:1: warning: '$vpd' has no effect here: only $fn, $fa and $fs do"});
}

TEST_CASE("a text with special variables is written as it was read") {
  const std::string text = "$fn = 6;\ngroup() {\n\t$fa = 0.5;\n\tsphere(r = 1);\n}\n\n";
  CHECK(text::write(document(text)) == text);
}

TEST_CASE("the faces of a polyhedron may be called triangles, as they once were") {
  const std::string points = "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], ";
  const std::string faces = "[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);";
  CHECK(meaning(points + "triangles = " + faces) == meaning(points + "faces = " + faces));
  CHECK_THROWS_AS(meaning(points + "faces = [], triangles = " + faces), Error);
}
