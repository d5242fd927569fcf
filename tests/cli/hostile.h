// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace csgcast::test {

/// One malformed or hostile input and how the program must answer it.
struct Hostile {
  std::string name;
  std::string text;  ///< of scene.csg, or of rows.csv
  int exit_code = 2;
  std::string message;  ///< how the one line on standard error begins, empty if nothing is said; a warning
                        ///< that leaves the scene empty is followed by a line that says so
  std::vector<std::string> arguments{};  ///< empty: render scene.csg
  RunOptions run{};
};

/// Scene texts; the message is what follows `scene.csg:`.
std::vector<Hostile> hostile_texts();
/// Scene texts of good grammar that mean nothing, or too much.
std::vector<Hostile> hostile_scenes();
/// Files of rays and points.
std::vector<Hostile> hostile_rows();
/// Command lines and places to write to.
std::vector<Hostile> hostile_command_lines();

/// A text many times over.
std::string repeated(const std::string& text, std::size_t times);

}  // namespace csgcast::test
