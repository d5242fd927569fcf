// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/csg/text_support.h"
#include "tests/support/catch.h"

namespace csgcast::text {
namespace {

struct BadText {
  std::string text;
  ErrorCode code;
  int line;
  int column;
  std::string fragment;  ///< of the message
};

void check(const BadText& bad) {
  INFO(bad.text.substr(0, 200));
  const auto error = error_of(bad.text);
  REQUIRE(error);
  const std::string message = error->what();
  INFO(message);
  CHECK(error->code() == bad.code);
  CHECK(error->place() == Place{"test.csg", bad.line, bad.column});
  CHECK(message.find(bad.fragment) != std::string::npos);
  CHECK(message.find("; ") != std::string::npos);  // every message says what to do
}

void check_all(const std::vector<BadText>& texts) {
  for (const BadText& bad : texts) check(bad);
}

using enum ErrorCode;
const std::string language = "openscad -o x.csg x.scad";

}  // namespace

TEST_CASE("what is never closed is reported where it was opened") {
  check_all({
      {"cube();\n /* abc", syntax, 2, 2, "comment is never closed"},
      {"text(\"abc", syntax, 1, 6, "string is never closed"},
      {"text(\"abc\\", syntax, 1, 6, "string is never closed"},
      {"text(\"abc\\x4", syntax, 1, 6, "string is never closed"},
      {"union() {\n cube();", syntax, 1, 9, "'{' is never closed"},
      {"union() {\n group() {\n cube();\n}\n", syntax, 1, 9, "'{' is never closed"},
      {"cube(1", syntax, 1, 5, "'(' is never closed"},
      {"cube(", syntax, 1, 5, "'(' is never closed"},
      {"cube([1, [2", syntax, 1, 10, "'[' is never closed"},
      {"cube([", syntax, 1, 6, "'[' is never closed"},
  });
}

TEST_CASE("the first character that does not fit is named") {
  check_all({
      {"cube(1)", syntax, 1, 8, "found the end of the text"},
      {"cube(1)\n", syntax, 2, 1, "expected ';' or '{'"},
      {"cube(1)\nsphere(1);", bad_value, 2, 1, "end 'cube(..)' with ';'"},
      {"translate([1, 0, 0])", syntax, 1, 21, "block { .. }"},
      {"cube(1);}", syntax, 1, 9, "closes nothing"},
      {"{ cube(); } }", syntax, 1, 13, "expected a statement"},
      {"cube;", syntax, 1, 5, "expected '(' after 'cube'"},
      {"cube{}", syntax, 1, 5, "expected '('"},
      {"5;", syntax, 1, 1, "found the number 5"},
      {"\"a\"();", syntax, 1, 1, "found a string"},
      {"%", syntax, 1, 2, "found the end of the text"},
      {"cube(size = );", syntax, 1, 13, "expected a value"},
      {"cube(, 1);", syntax, 1, 6, "expected a value"},
      {"cube(1 2);", syntax, 1, 8, "',' or ')'"},
      {"cube(1, , 2);", syntax, 1, 9, "expected a value"},
      {"cube([1 2]);", syntax, 1, 9, "',' or ']'"},
      {"cube([1, 2);", syntax, 1, 11, "',' or ']'"},
      {"cube(1];", syntax, 1, 7, "',' or ')'"},
      {"cube(-);", syntax, 1, 7, "a number after '-'"},
      {"cube(--1);", syntax, 1, 7, "a number after '-'"},
      {"cube(1mm);", syntax, 1, 7, "no units"},
      {"cube(1.2.3);", syntax, 1, 9, "at most one point"},
      {"cube(0x10);", syntax, 1, 7, "'x' cannot follow"},
      {"cube(1e);", syntax, 1, 7, "'e' cannot follow"},
      {"text(\"a\\q\");", syntax, 1, 8, "unknown escape"},
      {"text(\"\\x9f\");", syntax, 1, 7, "no character"},
      {"text(\"\\ud800\");", syntax, 1, 7, "no character"},
      {"text(\"\\u12\");", syntax, 1, 7, "no character"},
  });
}

TEST_CASE("bytes that no text has are named where they stand") {
  check_all({
      {std::string("cube();\n \0", 10), syntax, 2, 2, "zero byte"},
      {std::string("text(\"a\0\");", 11), syntax, 1, 8, "zero byte"},
      {"cube();\xff", syntax, 1, 8, "0xff is not UTF-8"},
      {"\xc0\x80", syntax, 1, 1, "0xc0 is not UTF-8"},
      {"cube(\xe2\x82", syntax, 1, 6, "0xe2 is not UTF-8"},
      {"\xc2\xa0"
       "cube();",
       syntax, 1, 1, "U+00A0"},
      {"w\xc3\xbcrfel();", syntax, 1, 2, "U+00FC"},
      {"cube();\x01", syntax, 1, 8, "U+0001"},
      {"\x7f"
       "ELF\x02\x01\x01",
       syntax, 1, 1, "U+007F"},
  });
}

TEST_CASE("OpenSCAD's programming language is told from a scene") {
  check_all({
      {"x = 5;", syntax, 1, 1, language},
      {"fn = 50;", syntax, 1, 1, language},
      {"module a() { cube(); }", syntax, 1, 1, language},
      {"cube();\n function f(x) = x;", syntax, 2, 2, language},
      {"for (i = [0 : 3]) cube(i);", syntax, 1, 1, language},
      {"union() { if (true) cube(); }", syntax, 1, 11, language},
      {"include <a.scad>", syntax, 1, 1, language},
      {"use <a.scad>", syntax, 1, 1, language},
      {"echo(1);", syntax, 1, 1, language},
      {"cube(a);", syntax, 1, 6, "'a' is no value"},
      {"cube(-a);", syntax, 1, 7, language},
      {"cube([0 : 1e9]);", syntax, 1, 9, language},
      {"cube(2 * 3);", syntax, 1, 8, language},
      {"cube(size = (1));", syntax, 1, 13, language},
      {"cube(sqrt(2));", syntax, 1, 6, language},
      {"cube(!true);", syntax, 1, 6, language},
      {"cube([for (i = [1, 2, 3]) i]);", syntax, 1, 7, language},
      {"my_module(3);", unknown_name, 1, 1, language},
  });
}

TEST_CASE("numbers and lists beyond the limits are refused") {
  check_all({
      {"cube(1e999);", bad_value, 1, 6, "too large"},
      {"cube([1, -1e309]);", bad_value, 1, 10, "too large"},
      {"cube(1e99999999999999999999);", bad_value, 1, 6, "too large"},
      {"cube(1.8e308);", bad_value, 1, 6, "too large"},
      {"f(" + repeated("[", 1001) + repeated("]", 1001) + ");", limit, 1, 1003, "nested too deeply"},
      {"f(" + repeated("[", 1'000'000), limit, 1, 1003, "nested too deeply"},
      {"f([" + repeated("1,", 5'000'000) + "]);", limit, 1, 4 + 2 * 4'194'304, "list is too long"},
      {"f(" + repeated("1,", 1001) + ");", limit, 1, 2003, "too many arguments"},
  });
}

TEST_CASE("a million braces that nobody closes end at once, at the last one") {
  check({repeated("group(){", 1'000'000), syntax, 1, 8'000'000, "'{' is never closed"});
  check({repeated("}", 1'000'000), syntax, 1, 1, "closes nothing"});
  check({repeated("{", 1'000'000), syntax, 1, 1'000'000, "'{' is never closed"});
}

TEST_CASE("unknown names come with a guess at what was meant") {
  check_all({
      {"cube();\n  spere(r = 1);", unknown_name, 2, 3, "did you mean 'sphere'?"},
      {"Cube();", unknown_name, 1, 1, "did you mean 'cube'?"},
      {"cyilnder();", unknown_name, 1, 1, "did you mean 'cylinder'?"},
      {"cube(sise = 1);", unknown_name, 1, 6, "did you mean 'size'?"},
      {"cube(1, centre = true);", unknown_name, 1, 9, "did you mean 'center'?"},
      {"sphere(quality = 1);", unknown_name, 1, 8, "it takes r, d, $fn, $fa, $fs"},
      {"group(x = 1);", unknown_name, 1, 7, "it takes $fn, $fa, $fs"},
      {"union($f = 9) { sphere(); }", unknown_name, 1, 7, "'union' has no argument '$f'"},
      {"color(\"rde\") { cube(); }", unknown_name, 1, 7, "did you mean 'red'?"},
      {"color(c = \"fuliginous\") { cube(); }", unknown_name, 1, 7, "CSS name"},
  });
}

TEST_CASE("arguments of the wrong type, number or count are refused where they stand") {
  check_all({
      {"cube(\"big\");", wrong_type, 1, 6, "'size' of 'cube' must be a number or a list"},
      {"cube(size = [1, 2]);", wrong_type, 1, 6, "a list with 2 entries"},
      {"cube([1, 2, \"x\"]);", wrong_type, 1, 6, "list of three numbers"},
      {"cube(1, center = 1);", wrong_type, 1, 9, "true or false"},
      {"sphere(r = true);", wrong_type, 1, 8, "must be a number (it is true)"},
      {"sphere([1]);", wrong_type, 1, 8, "a list with 1 entry"},
      {"sphere(1, $fn = \"6\");", wrong_type, 1, 11, "'$fn'"},
      {"cylinder(h = 1,\n r = \"a\");", wrong_type, 2, 2, "'r' of 'cylinder'"},
      {"cube(1, true, 3);", bad_value, 1, 15, "too many arguments"},
      {"group(1);", bad_value, 1, 7, "too many arguments"},
      {"cube(1, size = 2);", bad_value, 1, 9, "given twice"},
      {"render(convexity = \"a\");", wrong_type, 1, 8, "'convexity'"},
      {"scale(true) { cube(); }", wrong_type, 1, 7, "two or three numbers"},
      {"translate([1]) { cube(); }", wrong_type, 1, 11, "two or three numbers"},
      {"rotate(\"x\") { cube(); }", wrong_type, 1, 8, "must be a number"},
      {"rotate(1, 2) { cube(); }", wrong_type, 1, 11, "'v' of 'rotate'"},
      {"multmatrix(1) { cube(); }", wrong_type, 1, 12, "must be a list"},
      {"multmatrix([1]) { cube(); }", wrong_type, 1, 13, "a row of the matrix"},
      {"multmatrix([[1, 0, \"a\"]]) { cube(); }", wrong_type, 1, 20, "a matrix entry"},
      {"multmatrix([[], [], [], [], []]) { cube(); }", bad_value, 1, 12, "has 5 rows"},
      {"multmatrix([[1, 0, 0, 0, 0]]) { cube(); }", bad_value, 1, 13, "has 5 columns"},
      {"color(5) { cube(); }", wrong_type, 1, 7, "a string or a list"},
      {"color([1, 0]) { cube(); }", wrong_type, 1, 7, "it has 2"},
      {"color([1, 0, \"a\"]) { cube(); }", wrong_type, 1, 14, "a channel"},
      {"color(\"#12345\") { cube(); }", bad_value, 1, 7, "'#12345' is no colour"},
      {"color(\"#ggg\") { cube(); }", bad_value, 1, 7, "hexadecimal digits"},
      {"color(\"red\", 2) { cube(); }", bad_value, 1, 14, "'alpha' of 'color' must be between 0 and 1 (it is 2)"},
  });
}

TEST_CASE("arguments that a statement cannot do without are asked for") {
  check_all({
      {"\n ellipsoid();", bad_value, 2, 2, "'ellipsoid' needs the argument 'r'"},
      {"paraboloid(h = 1);", bad_value, 1, 1, "needs the argument 'r'"},
      {"hyperboloid(h = 1, r = 1);", bad_value, 1, 1, "needs the argument 'waist'"},
      {"quadric(b = [0, 0, 0], c = 1);", bad_value, 1, 1, "needs the argument 'A'"},
      {"halfspace(n = [0, 0, 1]);", bad_value, 1, 1, "needs the argument 'd'"},
      {"halfspace(n = [0, nan, 1], d = 0);", bad_value, 1, 1, "needs the argument 'n'"},
      {"convex();", bad_value, 1, 1, "neither is given"},
      {"multmatrix() { cube(); }", bad_value, 1, 1, "needs the argument 'm'"},
      {"translate() { cube(); }", bad_value, 1, 1, "needs the argument 'v'"},
      {"rotate(v = [0, 0, 1]) { cube(); }", bad_value, 1, 1, "needs the argument 'a'"},
      {"rotate([nan, 0, 0]) { cube(); }", bad_value, 1, 1, "needs the argument 'a'"},
      {"scale() { cube(); }", bad_value, 1, 1, "needs the argument 'v'"},
      {"mirror() { cube(); }", bad_value, 1, 1, "needs the argument 'v'"},
      {"part() { cube(); }", bad_value, 1, 1, "needs the argument 'name'"},
      {"camera(eye = [1, 1, 1]);", bad_value, 1, 1, "needs the argument 'look_at'"},
      {"background();", bad_value, 1, 1, "needs the argument 'color'"},
      {"light();", bad_value, 1, 1, "neither is given"},
  });
}

TEST_CASE("impossible values are refused with the rule they break") {
  check_all({
      {"halfspace(n = [0, 0, 0], d = 1);", bad_value, 1, 11, "must not be the zero vector"},
      {"quadric(A = [[1, 2, 0], [3, 1, 0], [0, 0, 1]], b = [0, 0, 0], c = 1);", bad_value, 1, 26, "not symmetric"},
      {"quadric(A = [[1, 0, 0]], b = [0, 0, 0], c = 1);", bad_value, 1, 9, "three rows"},
      {"quadric(A = [1, 0, 0], b = [0, 0, 0], c = 1);", wrong_type, 1, 14, "a row of the matrix"},
      {"convex(points = [], planes = []);", bad_value, 1, 1, "both are given"},
      {"convex(points = [[1, 2]]);", wrong_type, 1, 18, "a point of 'convex'"},
      {"convex(points = [[1, 2, inf]]);", wrong_type, 1, 18, "list of three numbers"},
      {"convex(planes = []);", bad_value, 1, 8, "at least one plane"},
      {"convex(planes = [[1, 0, 0]]);", wrong_type, 1, 18, "four numbers"},
      {"convex(planes = [5]);", wrong_type, 1, 18, "a plane of 'convex' must be a list"},
      {"convex(planes = [[0, 0, 0, 1]]);", bad_value, 1, 18, "has no normal"},
      {"part(\"\") { cube(); }", bad_value, 1, 6, "must not be empty"},
      {"part(\"a\", density = -1) { cube(); }", bad_value, 1, 11, "not be negative"},
      {"part(5) { cube(); }", wrong_type, 1, 6, "a \"string\""},
      {"material(diffuse = -1) { cube(); }", bad_value, 1, 10, "'diffuse' of 'material' must not be negative"},
      {"material(reflection = 2) { cube(); }", bad_value, 1, 10, "between 0 and 1"},
      {"material(ior = 0) { cube(); }", bad_value, 1, 10, "greater than 0"},
      {"material(color = [1, -1, 0]) { cube(); }", bad_value, 1, 10, "negative channel"},
      {"material(color = 5) { cube(); }", wrong_type, 1, 10, "must be a string or a list of three numbers"},
      {"material(color = [1, 0]) { cube(); }", wrong_type, 1, 10, "list of three numbers"},
      {"material(color = \"rde\") { cube(); }", unknown_name, 1, 10, "did you mean 'red'?"},
      {"light(direction = [0, 0, 1], color = \"#12345\");", bad_value, 1, 30, "'#12345' is no colour"},
      {"light(direction = [0, 0, 1], color = \"#12345678\");", bad_value, 1, 30, "must be an opaque colour"},
      {"background(\"transparent\");", bad_value, 1, 12, "must be an opaque colour"},
      {"material(emission = \"red\") { cube(); }", wrong_type, 1, 10, "list of three numbers"},
      {"camera(eye = [1, 1, 1], look_at = [1, 1, 1]);", bad_value, 1, 25, "differ from 'eye'"},
      {"camera(eye = [0, 0, 1], look_at = [0, 0, 0]);", bad_value, 1, 1, "'up' of 'camera' must not be zero nor along"},
      {"camera(eye = [1, 0, 0], look_at = [0, 0, 0], fov = 180);", bad_value, 1, 46, "less than 180"},
      {"camera(eye = [1, 0, 0], look_at = [0, 0, 0], height = 0);", bad_value, 1, 46, "greater than 0"},
      {"camera(eye = [1, 0, 0], look_at = [0, 0, 0], fov = 9, height = 1);", bad_value, 1, 46, "parallel"},
      {"light(position = [1, 0, 0], direction = [1, 0, 0]);", bad_value, 1, 1, "both are given"},
      {"light(direction = [0, 0, 0]);", bad_value, 1, 7, "zero vector"},
      {"light(position = [1, 0, 0], intensity = -1);", bad_value, 1, 29, "not be negative"},
      {"light(position = [1, 0, 0], falloff = 0);", bad_value, 1, 29, "greater than 0"},
      {"light(direction = [1, 0, 0], falloff = 1);", bad_value, 1, 30, "with a 'position'"},
      {"background([1, 0, -1]);", bad_value, 1, 12, "negative channel"},
      {"settings(max_depth = 101);", bad_value, 1, 10, "from 0 to 100"},
      {"settings(max_depth = 1.5);", bad_value, 1, 10, "whole number"},
      {"settings(min_contribution = 2);", bad_value, 1, 10, "between 0 and 1"},
  });
}

TEST_CASE("what a message quotes is cut after forty bytes, between two characters") {
  const std::string forty = repeated("x", 40);
  const std::string quoted = "'" + forty + "...'";
  check_all({
      {forty + "();", unknown_name, 1, 1, "'" + forty + "'"},
      {forty + "x();", unknown_name, 1, 1, quoted},
      {forty + "x = 1;", syntax, 1, 1, quoted},
      {forty + "x;", syntax, 1, 42, "'(' after " + quoted},
      {forty + "x() 5;", syntax, 1, 45, "after '" + forty + "...(..)'"},
      {"cube(1 " + forty + "x);", syntax, 1, 8, "the word " + quoted},
      {"cube(" + forty + "x);", syntax, 1, 6, quoted + " is no value"},
      {"cube(-" + forty + "x);", syntax, 1, 7, quoted + " is no number"},
      {"cube(" + forty + "x = 1);", unknown_name, 1, 6, quoted},
      {"cube(" + repeated("9", 400) + ");", bad_value, 1, 6, "number " + repeated("9", 40) + "... is too large"},
      {"color(\"" + forty + "x\") { cube(); }", unknown_name, 1, 7, quoted},
      {"color(\"#" + forty + "\") { cube(); }", bad_value, 1, 7, fmt::format("'#{:x>39}...'", "")},
      {"color(\"" + repeated("x", 39) + "\xc3\xbc\") { cube(); }", unknown_name, 1, 7, repeated("x", 39) + "...'"},
      {"color(\"" + repeated("\xf0\x9f\x8e\xa8", 20) + "\") { cube(); }", unknown_name, 1, 7,
       fmt::format("\'{}...\'", repeated("\xf0\x9f\x8e\xa8", 10))},
  });
}

TEST_CASE("statements that stand where they cannot are refused") {
  check_all({
      {"group() { camera(eye = [1, 0, 0], look_at = [0, 0, 0]); }", bad_value, 1, 11, "outside all { }"},
      {"color(\"red\") { light(direction = [1, 0, 0]); }", bad_value, 1, 16, "whole picture"},
      {"background([1, 1, 1]);\nbackground([1, 1, 1]);", bad_value, 2, 1, "a second 'background'"},
      {"settings();settings();", bad_value, 1, 12, "a second 'settings'"},
      {"camera(eye = [1, 0, 0], look_at = [0, 0, 0]);\ncamera(eye = [1, 0, 0], look_at = [0, 0, 0]);", bad_value, 2, 1,
       "a second 'camera'"},
      {"difference() {\n part(\"a\") { cube(); } }", bad_value, 2, 2, "below 'difference'"},
      {"intersection() { group() { part(\"a\") { cube(); } } }", bad_value, 1, 28, "below 'intersection'"},
      {"complement() { part(\"a\") { cube(); } }", bad_value, 1, 16, "below 'complement'"},
      {"part(\"a\") { part(\"b\") { cube(); } }", bad_value, 1, 13, "below 'part'"},
      {"cube() { sphere(); }", bad_value, 1, 10, "'cube' takes no children"},
      {"light(direction = [1, 0, 0]) { cube(); }", bad_value, 1, 32, "'light' takes no children"},
  });
}

TEST_CASE("polyhedra that bound no solid are refused") {
  const std::string points = "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],\n faces = ";
  check_all({
      {points + "[[0, 1, 2], [0, 3, 1], [0, 2, 3]]);", bad_value, 1, 1, "not closed"},
      {points + "[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 2, 3]]);", bad_value, 1, 1, "not closed"},
      {points + "[[0, 1, 4]]);", bad_value, 2, 18, "names point 4"},
      {points + "[[0, 1, -1]]);", bad_value, 2, 18, "names point -1"},
      {points + "[[0, 1, 0.5]]);", bad_value, 2, 18, "names point 0.5"},
      {points + "[0]);", wrong_type, 2, 11, "a face of 'polyhedron' must be a list"},
      {points + "[[0, \"a\", 1]]);", wrong_type, 2, 15, "a face's corner"},
      {"polyhedron(points = [5], faces = []);", wrong_type, 1, 22, "a point of 'polyhedron'"},
  });
}

TEST_CASE("what is not supported yet is named, first in the order of the file") {
  for (const char* name : {"hull", "minkowski", "linear_extrude", "rotate_extrude", "text", "square", "circle",
                           "polygon", "import", "surface", "projection", "offset", "resize"}) {
    check({fmt::format("cube();\n{}(whatever = [1]);", name), unsupported, 2, 1,
           fmt::format("'{}' is not supported", name)});
  }
  check_all({
      {"union() {\n\tcube();\n\tlinear_extrude(height = 1) {\n\t\tsquare();\n\t}\n\thull();\n}", unsupported, 3, 2,
       "'linear_extrude'"},
      {"%hull();\n*text();\n group() { resize(); }\nhull();", unsupported, 3, 12, "'resize'"},
      {"sphere(r = \"a\"); hull();", wrong_type, 1, 8, "'r' of 'sphere'"},
      {"hull(); sphere(r = \"a\");", unsupported, 1, 1, "'hull'"},
  });
}

TEST_CASE("what is not supported yet is left out if asked for, with a warning, and what is below it with it") {
  const SceneDescription scene = build(
      read("cube(2);\nunion() { hull() { cube(9); } translate([5, 0, 0]) linear_extrude(1) { square(1); } }", "a.csg"),
      {.skips_unsupported = true});
  CHECK(scene.solid.leaf_count() == 1);
  REQUIRE(scene.warnings.size() == 2);
  CHECK(to_string(scene.warnings[0]) == "a.csg:2:11: warning: 'hull' is left out: it is not supported yet");
  CHECK(to_string(scene.warnings[1]) == "a.csg:2:52: warning: 'linear_extrude' is left out: it is not supported yet");
  check({"hull();\ntext(\"a\");", unsupported, 1, 1, "nor those of 1 more"});
}

TEST_CASE("files that cannot be read are refused") {
  const auto code_of = [](const std::string& path) -> std::optional<ErrorCode> {
    try {
      read_file(path);
    } catch (const Error& error) {
      return error.code();
    }
    return std::nullopt;
  };
  const auto folder = std::filesystem::temp_directory_path();
  CHECK(code_of((folder / "csgcast_no_such_file.csg").string()) == input_output);
  CHECK(code_of(folder.string()) == input_output);
  const auto path = folder / "csgcast_text_errors_test.csg";
  std::ofstream(path, std::ios::binary) << std::string("cube();\n\0", 9);
  CHECK(code_of(path.string()) == input_output);
  std::filesystem::remove(path);
}

}  // namespace csgcast::text
