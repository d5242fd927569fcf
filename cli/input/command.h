// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/output/usage.h"

namespace csgcast::cli {

/// What a shell offers for a value.
enum class Completes { nothing, files };

/// Takes the text of a value from the command line. Throws UsageError if it makes no sense.
using Take = std::function<void(const std::string& text)>;

/// An option of a command. The parser, the help, the manual page and the completion of shells all read this.
struct Option {
  std::string names;                 ///< `--size`, or `-o,--output`: the short name first
  std::string value;                 ///< what the help calls the value, such as `FILE`; empty: the option is a switch
  std::string help;                  ///< one or two sentences, without a full stop at the end
  std::string preset{};              ///< the default value; empty: there is none, or the help tells it
  Take take{};                       ///< is called once for each time that the option is given; with "" for a switch
  std::vector<std::string> words{};  ///< the values that there are; empty: any text
  std::vector<std::string> conflicts{};  ///< the options, as `--line`, that must not be given beside it
  bool is_required = false;
  bool is_repeatable = false;
  Completes completes = Completes::nothing;

  std::string_view short_name() const;  ///< `-o`, or nothing
  std::string_view long_name() const;   ///< `--output`
};

/// An argument that stands for itself, such as the scene.
struct Operand {
  std::string name;  ///< `SCENE`
  std::string help;
  Take take;
  bool is_required = true;
  bool is_repeatable = false;  ///< as often as wanted; only the last operand may be
  Completes completes = Completes::files;
};

/// A command: what the command line says of it, and what it does once that has been read.
struct Command {
  std::string name;
  std::string summary;  ///< one sentence, without a full stop
  std::vector<Operand> operands{};
  std::vector<Option> options{};
  std::string details{};                ///< paragraphs, a line each
  std::vector<std::string> examples{};  ///< whole command lines
  std::function<void()> run{};

  void add(Option option) { options.push_back(std::move(option)); }
};

/// `csgcast render [OPTIONS] SCENE`.
std::string usage_line(const Command& command);

/// Take functions that keep the text, or that the switch was given.
inline Take into(std::string& text) {
  return [&text](const std::string& given) { text = given; };
}
inline Take into(std::optional<std::string>& text) {
  return [&text](const std::string& given) { text = given; };
}
inline Take into(std::vector<std::string>& texts) {
  return [&texts](const std::string& given) { texts.push_back(given); };
}
inline Take into(bool& is_given) {
  return [&is_given](const std::string&) { is_given = true; };
}

/// An option that takes one of a few words. `value` is an Enum that holds the default, or an optional one for none. It
/// must live as long as the option.
template <class Enum, class Value>
Option choice(const std::string& name, Value& value, const std::string& help,
              const std::vector<std::pair<std::string, Enum>>& choices) {
  Option option{.names = name, .value = {}, .help = help};
  for (const auto& [word, choice] : choices) {
    option.words.push_back(word);
    option.value += (option.value.empty() ? "" : "|") + word;
    if (choice == value) option.preset = word;
  }
  option.take = [&value, choices, name, words = option.value](const std::string& given) {
    for (const auto& [word, choice] : choices) {
      if (word == given) {
        value = choice;
        return;
      }
    }
    throw UsageError(fmt::format("{} '{}' is unknown (known are {})", name, given, words));
  };
  return option;
}

/// The path of an output as Output takes it: `-` is standard output, for which the path is empty.
std::string path_of(const std::string& output);
/// The name that tells a picture's format: standard output gets a .png.
std::string picture_name(const std::string& output);

/// The file that a command writes its report to; `path` is empty for standard output.
Option output_option(std::string& path);

}  // namespace csgcast::cli
