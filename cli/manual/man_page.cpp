// SPDX-License-Identifier: MIT
#include "cli/manual/man_page.h"

#include <fmt/format.h>

#include <sstream>

#include "cli/manual/help_text.h"

namespace csgcast::cli {
namespace {

/// A text as troff takes it: backslashes and hyphens are escaped, and no line begins with a control character.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

void append_option(std::string& out, const Option& option) {
  const std::string_view brief = option.short_name();
  out += ".TP\n";
  if (!brief.empty()) out += fmt::format("\\fB{}\\fR, ", escaped(brief));
  out += fmt::format("\\fB{}\\fR", escaped(option.long_name()));
  if (!option.value.empty()) out += fmt::format(" \\fI{}\\fR", escaped(option.value));
  out += '\n' + escaped(explained(option)) + ".\n";
}

void append_command(std::string& out, const Command& command) {
  out += fmt::format(".SS {}\n{}.\n.PP\n.B {}\n", escaped(command.name), escaped(command.summary),
                     escaped(usage_line(command)));
  for (const Operand& operand : command.operands)
    out += fmt::format(".TP\n\\fI{}\\fR\n{}.\n", escaped(operand.name), escaped(operand.help));
  for (const Option& option : command.options) append_option(out, option);
  std::istringstream details(command.details);
  for (std::string paragraph; std::getline(details, paragraph);) out += ".PP\n" + escaped(paragraph) + '\n';
  if (command.examples.empty()) return;
  out += ".PP\nExample:\n.PP\n.nf\n.RS\n";
  for (const std::string& example : command.examples) out += escaped(example) + '\n';
  out += ".RE\n.fi\n";
}

}  // namespace

std::string man_page(std::span<const Command> commands) {
  std::string out = fmt::format(
      ".TH CSGCAST 1 \"\" \"csgcast {}\" \"User Commands\"\n.SH NAME\ncsgcast \\- render and measure solids along "
      "rays\n.SH SYNOPSIS\n.B csgcast\n.I COMMAND\n.RI [ OPTIONS ]\n.SH DESCRIPTION\n{}.\n.SH COMMANDS\n",
      CSGCAST_VERSION, escaped(program_summary()));
  for (const Command& command : commands) append_command(out, command);
  out +=
      ".SH EXIT STATUS\n"
      ".TP\n.B 0\nThe work is done, maybe with warnings.\n"
      ".TP\n.B 1\nThe machine failed, or\n.B csgcast verify\nfound a wrong answer.\n"
      ".TP\n.B 2\nThe input or the command line is wrong.\n";
  return out;
}

}  // namespace csgcast::cli
