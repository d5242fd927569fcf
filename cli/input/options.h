// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/output/format.h"
#include "cli/output/usage.h"

namespace csgcast::cli {

/// One command: its part of the command line, and what it does once that has been read.
struct Command {
  CLI::App* line = nullptr;
  std::function<void()> run;
};

/// An option that takes one of a few words; `value` holds the default, which must be among them.
template <class Enum>
CLI::Option* add_choice(CLI::App& line, const std::string& name, Enum& value, const std::string& help,
                        const std::vector<std::pair<std::string, Enum>>& choices) {
  std::string words;
  std::string preset;
  for (const auto& [word, choice] : choices) {
    words += (words.empty() ? "" : "|") + word;
    if (choice == value) preset = word;
  }
  const auto choose = [&value, choices, name, words](const std::string& given) {
    for (const auto& [word, choice] : choices) {
      if (word == given) {
        value = choice;
        return;
      }
    }
    throw UsageError(fmt::format("{} '{}' is unknown (known are {})", name, given, words));
  };
  return line.add_option_function<std::string>(name, choose, help)->type_name(words)->default_str(preset);
}

/// `count` numbers separated by commas, as `--ray 0,0,9,0,0,-1` gives them. Throws UsageError, naming the option, for
/// another count, and for what is no number or not finite.
std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count);
/// The same for any count.
std::vector<double> parse_numbers(const std::string& option, const std::string& text);

/// One number, maybe infinite. Throws UsageError.
double parse_parameter(const std::string& option, const std::string& text);

/// A whole number in [low, high]. Throws UsageError.
int parse_count(const std::string& option, const std::string& text, int low, int high);

/// Two whole numbers in [low, high] with a mark between them: `800x600`. Throws UsageError.
std::pair<int, int> parse_pair(const std::string& option, const std::string& text, char mark, int low, int high);

}  // namespace csgcast::cli
