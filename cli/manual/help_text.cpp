// SPDX-License-Identifier: MIT
#include "cli/manual/help_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace csgcast::cli {
namespace {

constexpr std::size_t width = 80;
constexpr std::size_t widest_name = 26;  // a longer one stands on a line of its own

using Row = std::pair<std::string, std::string>;

/// Adds the words to `out`, which is in column `column` of its line, in lines that begin at `indent`.
void append_wrapped(std::string& out, const std::string& text, std::size_t column, std::size_t indent) {
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false) {
    if (!first && column + 1 + word.size() > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
  }
  out += '\n';
}

/// Two columns: names, and what they are.
void append_rows(std::string& out, const std::vector<Row>& rows) {
  std::size_t indent = 0;
  for (const Row& row : rows) {
    if (row.first.size() <= widest_name) indent = std::max(indent, 2 + row.first.size() + 2);
  }
  indent = indent == 0 ? 2 + widest_name : indent;
  for (const auto& [name, text] : rows) {
    out += "  " + name;
    if (name.size() <= widest_name) {
      out += std::string(indent - 2 - name.size(), ' ');
    } else {
      out += '\n' + std::string(indent, ' ');
    }
    append_wrapped(out, text, indent, indent);
  }
}

/// `-o, --output FILE`; the long names stand below each other.
std::string shown(const Option& option) {
  const std::string_view brief = option.short_name();
  return fmt::format("{:<4}{}{}{}", brief.empty() ? "" : std::string(brief) + ",", option.long_name(),
                     option.value.empty() ? "" : " ", option.value);
}

}  // namespace

std::string_view program_summary() {
  return "csgcast looks at constructive solid geometry along rays: pictures, and exact answers about solids";
}

std::string explained(const Option& option) {
  std::string text = option.help;
  if (!option.preset.empty()) text += fmt::format(" (default {})", option.preset);
  return text;
}

std::string help_text(std::span<const Command> commands) {
  std::string out;
  append_wrapped(out, std::string(program_summary()) + '.', 0, 0);
  out += "\nUsage: csgcast COMMAND ..\n\nCommands:\n";
  std::vector<Row> rows;
  for (const Command& command : commands) rows.emplace_back(command.name, command.summary);
  append_rows(out, rows);
  out += "\nOptions:\n";
  append_rows(out, {{"-h, --help", "Print this"}, {"-V, --version", "Print the version"}});
  out += "\ncsgcast help COMMAND tells more of a command, with examples.\n";
  return out;
}

std::string help_text(const Command& command) {
  std::string out;
  append_wrapped(out, command.summary + '.', 0, 0);
  out += "\nUsage: " + usage_line(command) + '\n';
  std::vector<Row> rows;
  for (const Operand& operand : command.operands) rows.emplace_back(operand.name, operand.help);
  if (!rows.empty()) out += '\n';
  append_rows(out, rows);
  rows.clear();
  for (const Option& option : command.options) rows.emplace_back(shown(option), explained(option));
  rows.emplace_back("-h, --help", "Print this");
  out += "\nOptions:\n";
  append_rows(out, rows);
  std::istringstream details(command.details);
  for (std::string paragraph; std::getline(details, paragraph);) {
    out += '\n';
    append_wrapped(out, paragraph, 0, 0);
  }
  if (!command.examples.empty()) out += "\nExample:\n";
  for (const std::string& example : command.examples) out += "  " + example + '\n';
  return out;
}

}  // namespace csgcast::cli
