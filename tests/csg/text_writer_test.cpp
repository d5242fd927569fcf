// SPDX-License-Identifier: MIT
#include "csg/text/syntax/writer.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "tests/csg/text_support.h"
#include "tests/support/catch.h"

namespace csgcast::text {

TEST_CASE("a text in OpenSCAD's own layout is written as it was read") {
  const std::string text =
      "difference() {\n"
      "\tsphere($fn = 0, $fa = 12, $fs = 2, r = 10);\n"
      "%\tcylinder($fn = 0, $fa = 12, $fs = 2, h = 30, r1 = 6, r2 = 6, center = true);\n"
      "}\n"
      "%#group() {\n"
      "\tmultmatrix([[1, 0, 0, -1.11022e-16], [0, 1, 0, 1e-07], [0, 0, 1, 1e+10], [0, 0, 0, 1]]) {\n"
      "\t\tcube(size = [25, 0.707107, 3], center = false);\n"
      "\t}\n"
      "}\n"
      "group();\n"
      "polyhedron(points = undef, faces = [[0, 1, 2], []], convexity = 1);\n"
      "text(text = \"a\\\"b\\\\c\\nd\", size = inf, spacing = -inf, font = nan);\n"
      "\n";
  CHECK(write(read_text(text)) == text);
}

TEST_CASE("an empty document is one blank line, as OpenSCAD writes it") { CHECK(write(read_text("")) == "\n"); }

TEST_CASE("every modifier and an empty block survive writing") {
  for (const char* text : {"%f();", "#f();", "!f();", "*f();", "*!%#f() {}", "g() { #f() { *h(); } }", "f() {}"}) {
    INFO(text);
    const Document document = read_text(text);
    CHECK(read_text(write(document)) == document);
  }
}

TEST_CASE("strings survive writing, control characters and broken UTF-8 included") {
  Document document = read_text("f(\"\");");
  for (const std::string& content :
       {std::string("\"\\\n\t\r\x01\x7f"), std::string("\xc3\xa9\xff"), std::string("*/ // /*")}) {
    document.nodes[0].arguments[0].value.data = content;
    CHECK(read_text(write(document)) == document);
  }
}

TEST_CASE("random doubles of all magnitudes survive writing bit for bit") {
  std::mt19937_64 random(20261122);
  Document document = read_text("f(0);");
  double& number = std::get<double>(document.nodes[0].arguments[0].value.data);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    std::memcpy(&number, &bits, sizeof number);
    if (!(std::fabs(number) <= std::numeric_limits<double>::max())) continue;
    const Document again = read_text(write(document));
    const double read_back = std::get<double>(again.nodes[0].arguments[0].value.data);
    if (std::memcmp(&read_back, &number, sizeof number) != 0) FAIL("lost " << number);
  }
}

TEST_CASE("a tree a million deep is written in little more space than it was read from") {
  constexpr std::size_t depth = 1'000'000;
  const Document document = read_text(repeated("group(){", depth) + repeated("}", depth));
  const std::string text = write(document);
  CHECK(text.size() < 200 * depth);
  CHECK(read_text(text) == document);
}

}  // namespace csgcast::text
