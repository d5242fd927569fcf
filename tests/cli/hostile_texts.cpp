// SPDX-License-Identifier: MIT
#include "tests/cli/hostile.h"

namespace csgcast::test {

using namespace std::string_literals;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::vector<Hostile> hostile_texts() {
  constexpr std::size_t million = 1'000'000;
  return {
      {"an empty file", "", 0, " warning: the scene is empty"},
      {"nothing but blanks", " \n\t\r\n", 0, " warning: the scene is empty"},
      {"the text ends in a name", "cube", 2, "1:5: error: "},
      {"the text ends in a list", "cube(size = [1, 2", 2, "1:13: error: '[' is never closed"},
      {"the text ends in arguments", "cube(size = 1", 2, "1:5: error: '(' is never closed"},
      {"the text ends in a block", "union() {\n  cube(1);\n", 2, "1:9: error: '{' is never closed"},
      {"a comment that is never closed", "cube(1);\n  /* cube(2);\n", 2, "2:3: error: this comment is never closed"},
      {"a string that is never closed", "color(\"red) { cube(1); }", 2, "1:7: error: this string is never closed"},
      {"a brace too many", "cube(1);\n}", 2, "2:1: error: "},
      {"a wrong bracket", "cube([1, 2, 3)};", 2, "1:14: error: "},
      {"a zero byte", "cube(1);\ncube(\0);"s, 2, "2:6: error: this is not a text"},
      {"a PNG file", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s, 2, "3:1: error: this is not a text"},
      {"bytes that are no text", "\xff\xfe\xfd", 2, "1:1: error: byte 0xff is not UTF-8"},
      {"broken UTF-8 in a string", "part(\"\xc3(\") { cube(1); }", 0, ""},
      {"a control character", "cube(\x01);", 2, "1:6: error: unexpected character U+0001"},
      {"letters of another alphabet", "cube(size = \u03c0);", 2, "1:13: error: unexpected character U+03C0"},
      {"a million braces that never close", repeated("union() {", million), 2, "1:9000000: error: '{' is never closed"},
      {"a million braces that never opened", repeated("}", million), 2, "1:1: error: "},
      {"a million nested unions", repeated("union() {", million) + "cube(1);" + repeated("}", million), 0, ""},
      {"a million nested differences", repeated("difference() {", million) + "cube(1);" + repeated("}", million), 0,
       ""},
      {"a million nested complements", repeated("complement() {", million) + "cube(1);" + repeated("}", million), 0,
       ""},
      {"a million nested lists", "cube(" + repeated("[", million), 2, "1:1006: error: this list is nested too deeply"},
      {"a list of five million numbers", "cube([" + repeated("1,", 5 * million) + "1]);", 2,
       "1:8388615: error: this list is too long"},
      {"a thousand and one arguments", "cube(" + repeated("1,", 1001) + ");", 2, "1:2006: error: "},
      {"a number beyond double", "cube(1e400);", 2, "1:6: error: the number 1e400 is too large"},
      {"a number of a million digits", "cube(" + repeated("9", million) + ");", 2, "1:6: error: "},
      {"letters in a number", "cube(1x);", 2, "1:7: error: "},
      {"a name of a million letters", repeated("a", million) + "();", 2, "1:1: error: there is no statement"},
      {"an expression", "cube(1 + 2);", 2, "1:8: error: "},
      {"a variable", "x = 5;\ncube(x);", 2, "1:1: error: 'x' is a variable"},
      {"a module", "module a() { cube(1); }", 2, "1:1: error: "},
      {"a loop", "cube(1);\nfor (i = [0 : 5]) { cube(i); }", 2, "2:1: error: "},
      {"modifiers of nothing", "cube(1); #%!*", 2, "1:14: error: "},
  };
}

}  // namespace csgcast::test
