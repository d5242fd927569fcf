// SPDX-License-Identifier: MIT
#include "cli/input/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "cli/output/printable.h"
#include "csg/text/syntax/suggestion.h"

namespace csgcast::cli {
namespace {

/// CLI11 finds out what is an option, a value and an operand; values are taken afterwards, in their order.
class Parser {
 public:
  explicit Parser(const Command& command) : command_(command), line_("", command.name) {
    line_.set_help_flag();
    line_.allow_extras();
    line_.add_flag("-h,--help", asks_for_help_);
    for (const Option& option : command.options) add(option);
  }

  bool parse(std::span<const std::string> arguments) {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
      line_.parse(std::move(reversed));
    } catch (const CLI::ArgumentMismatch& error) {
      const std::string text = error.what();
      throw UsageError(text.substr(0, text.find(':')) + " needs a value");
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    if (asks_for_help_) return false;
    const std::vector<std::string> operands = operands_among(line_.remaining());
    for (const Option& option : command_.options) check(option);
    for (std::size_t i = operands.size(); i < command_.operands.size(); ++i) {
      if (command_.operands[i].is_required) throw UsageError(command_.operands[i].name + " is missing");
    }
    for (const Option& option : command_.options) take(option);
    for (std::size_t i = 0; i < operands.size(); ++i)
      command_.operands[std::min(i, command_.operands.size() - 1)].take(operands[i]);
    return true;
  }

 private:
  void add(const Option& option) {
    if (option.value.empty()) {
      line_.add_flag(option.names, switches_[&option]);
      return;
    }
    line_.add_option(option.names, texts_[&option])
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }

  std::size_t times(const Option& option) {
    return option.value.empty() ? (switches_[&option] ? 1 : 0) : texts_[&option].size();
  }

  /// All arguments that no option took are operands. Before `--` none of them may look like an option.
  std::vector<std::string> operands_among(const std::vector<std::string>& rest) const {
    std::vector<std::string> operands;
    bool may_be_options = true;
    for (const std::string& argument : rest) {
      if (may_be_options && argument == "--") {
        may_be_options = false;
        continue;
      }
      if (may_be_options && argument.size() > 1 && argument[0] == '-') refuse_option(argument);
      operands.push_back(argument);
    }
    const std::vector<Operand>& known = command_.operands;
    if (operands.size() > known.size() && (known.empty() || !known.back().is_repeatable)) {
      throw UsageError(fmt::format("{} is one argument too many (the command is {})", in_quotes(operands[known.size()]),
                                   usage_line(command_)));
    }
    return operands;
  }

  [[noreturn]] void refuse_option(const std::string& argument) const {
    const std::string name = argument.substr(0, argument.find('='));
    std::vector<std::string> known{"--help"};
    for (const Option& option : command_.options) known.emplace_back(option.long_name());
    throw UsageError(fmt::format("there is no option {}{}", in_quotes(name), suggestion(name, known)));
  }

  void check(const Option& option) {
    if (times(option) == 0) {
      if (option.is_required) throw UsageError(fmt::format("{} is missing", option.long_name()));
      return;
    }
    if (times(option) > 1 && !option.is_repeatable)
      throw UsageError(fmt::format("{} is given more than once", option.long_name()));
    for (const Option& other : command_.options) {
      const auto& conflicts = option.conflicts;
      if (times(other) > 0 && std::find(conflicts.begin(), conflicts.end(), other.long_name()) != conflicts.end())
        throw UsageError(fmt::format("{} cannot be given beside {}", option.long_name(), other.long_name()));
    }
  }

  void take(const Option& option) {
    if (option.value.empty() && times(option) > 0) option.take("");
    for (const std::string& text : texts_[&option]) option.take(text);
  }

  const Command& command_;
  CLI::App line_;
  bool asks_for_help_ = false;
  std::map<const Option*, bool> switches_;
  std::map<const Option*, std::vector<std::string>> texts_;
};

}  // namespace

bool read_command_line(const Command& command, std::span<const std::string> arguments) {
  return Parser(command).parse(arguments);
}

std::string suggestion(const std::string& word, std::span<const std::string> known) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string question = text::did_you_mean(word, words, "");
  return question.empty() ? "" : fmt::format(" ({})", question);
}

}  // namespace csgcast::cli
