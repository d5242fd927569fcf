// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/csg/text_support.h"
#include "tests/support/catch.h"

namespace csgcast::text {
namespace {

/// The only value of `f(<value>);`.
Value value_of(const std::string& spelling) {
  const Document document = read_text("f(" + spelling + ");");
  REQUIRE(document.nodes.size() == 1);
  REQUIRE(document.nodes[0].arguments.size() == 1);
  return document.nodes[0].arguments[0].value;
}

double number_of(const std::string& spelling) { return std::get<double>(value_of(spelling).data); }
std::string string_of(const std::string& spelling) { return std::get<std::string>(value_of(spelling).data); }
std::string word_of(const std::string& spelling) { return std::get<Value::Word>(value_of(spelling).data).name; }

}  // namespace

TEST_CASE("numbers read to the nearest double in every spelling of OpenSCAD") {
  CHECK(number_of("1") == 1);
  CHECK(number_of(".5") == 0.5);
  CHECK(number_of("1.") == 1);
  CHECK(number_of("1.e3") == 1000);
  CHECK(number_of("1e-07") == 1e-7);
  CHECK(number_of("1E+10") == 1e10);
  CHECK(number_of("+2") == 2);
  CHECK(number_of("- 2") == -2);
  CHECK(std::signbit(number_of("-0")));
  CHECK(number_of("0.1") == 0.1);
  CHECK(number_of("9007199254740993") == 9007199254740992.0);  // halfway: to even
  CHECK(number_of("9007199254740993.0000000000000000001") == 9007199254740994.0);
  CHECK(number_of("1.7976931348623157e308") == std::numeric_limits<double>::max());
}

TEST_CASE("numbers too small for a double become subnormal or zero") {
  CHECK(number_of("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(number_of("1e-999") == 0);
  CHECK(number_of("0.0000001e-99999999999999999999999") == 0);
  CHECK(number_of("0e99999999999999999999999") == 0);
}

TEST_CASE("words, booleans, undef and lists read to their kinds") {
  CHECK(std::get<bool>(value_of("true").data));
  CHECK_FALSE(std::get<bool>(value_of("false").data));
  CHECK(std::holds_alternative<Undef>(value_of("undef").data));
  CHECK(word_of("inf") == "inf");
  CHECK(word_of("-inf") == "-inf");
  CHECK(word_of("+inf") == "inf");
  CHECK(word_of("nan") == "nan");
  CHECK(std::get<List>(value_of("[]").data).empty());
  const List list = std::get<List>(value_of("[1, [true, \"a\"], ]").data);
  REQUIRE(list.size() == 2);
  CHECK(std::get<double>(list[0].data) == 1);
  CHECK(std::get<List>(list[1].data).size() == 2);
}

TEST_CASE("strings read with their escapes, UTF-8 and line ends") {
  CHECK(string_of(R"("a\"b\\c\nd\te\rf")") == "a\"b\\c\nd\te\rf");
  CHECK(string_of(R"("\x41\u00e9\U01F600")") == "A\xc3\xa9\xf0\x9f\x98\x80");
  CHECK(string_of("\"gr\xc3\xbc\xc3\x9f\"") == "gr\xc3\xbc\xc3\x9f");
  CHECK(string_of("\"two\nlines\"") == "two\nlines");
  CHECK(string_of("\"// no comment /* \"") == "// no comment /* ");
  CHECK(string_of("\"\xff\"") == "\xff");
}

TEST_CASE("a statement keeps its name, modifiers, arguments, block and place") {
  const Document document = read_text("// top\n  %#group(1, name = 2,) {\n\t!*leaf();\n}\n");
  REQUIRE(document.nodes.size() == 1);
  const Node& group = document.nodes[0];
  CHECK(group.name == "group");
  CHECK(group.modifiers == (background | highlight));
  CHECK(group.has_block);
  CHECK(group.line == 2);
  CHECK(group.column == 5);
  REQUIRE(group.arguments.size() == 2);
  CHECK(group.arguments[0].name.empty());
  CHECK(group.arguments[1].name == "name");
  CHECK(group.arguments[1].column == 14);
  CHECK(group.arguments[1].value.column == 21);
  REQUIRE(group.children.size() == 1);
  CHECK(group.children[0].modifiers == (root_only | disabled));
  CHECK_FALSE(group.children[0].has_block);
  CHECK(group.children[0].line == 3);
  CHECK(group.children[0].column == 4);
}

TEST_CASE("comments, white space, line ends and a byte order mark do not matter") {
  const Document plain = read_text("group($fn = 3) { cube(1); }");
  CHECK(read_text("\xef\xbb\xbfgroup\r\n(\t$fn\v=\f3/**/)/* { */{cube(1);// }\n}").nodes == plain.nodes);
  CHECK(read_text("").nodes.empty());
  CHECK(read_text(" \n// only a comment").nodes.empty());
  CHECK(read_text("\xef\xbb\xbf"
                  "cube();")
            .nodes[0]
            .column == 1);
}

TEST_CASE("a million nested statements read, compare, copy and go without recursion") {
  constexpr std::size_t depth = 1'000'000;
  const Document document = read_text(repeated("group(){", depth) + "cube();" + repeated("}", depth));
  const Document copy = document;
  CHECK(copy == document);
  std::size_t seen = 0;
  for (const Node* node = &copy.nodes[0]; !node->children.empty(); node = &node->children[0]) ++seen;
  CHECK(seen == depth);
}

TEST_CASE("lists may nest a thousand deep") {
  CHECK(read_text("f(" + repeated("[", 1000) + repeated("]", 1000) + ");").nodes.size() == 1);
}

TEST_CASE("a file reads like its text, under its own name") {
  const auto path = std::filesystem::temp_directory_path() / "csgcast_text_reader_test.csg";
  std::ofstream(path, std::ios::binary) << "cube(3);\n";
  const Document document = read_file(path.string());
  std::filesystem::remove(path);
  CHECK(document == read_text("cube(3);"));
  CHECK(document.file.string() == path.string());
}

TEST_CASE("equality of statements looks at everything but places") {
  const auto equal = [](std::string_view a, std::string_view b) { return read_text(a) == read_text(b); };
  CHECK(equal("f(a = [1, \"x\"]) { g(); }", "f(a=[1,\"x\"]){\n\ng();}"));
  CHECK_FALSE(equal("f();", "g();"));
  CHECK_FALSE(equal("f();", "%f();"));
  CHECK_FALSE(equal("f();", "f() {}"));
  CHECK_FALSE(equal("f(1);", "f(2);"));
  CHECK_FALSE(equal("f(a = 1);", "f(1);"));
  CHECK_FALSE(equal("f() { g(); }", "f() { h(); }"));
  CHECK_FALSE(equal("f() { g(); }", "f() { g(); g(); }"));
}

}  // namespace csgcast::text
