// SPDX-License-Identifier: MIT
#include "cli/manual/completion.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace csgcast::cli {
namespace {

/// A text within single quotes, for any of the shells.
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

std::string names_of(std::span<const Command> commands) {
  std::string names;
  for (const Command& command : commands) names += (names.empty() ? "" : " ") + command.name;
  return names;
}

/// The names of a command's options, short and long.
std::vector<std::string> names_of(const Command& command) {
  std::vector<std::string> names{"-h", "--help"};
  for (const Option& option : command.options) {
    if (!option.short_name().empty()) names.emplace_back(option.short_name());
    names.emplace_back(option.long_name());
  }
  return names;
}

/// `-o|--output`.
std::string pattern_of(const Option& option) {
  const std::string_view brief = option.short_name();
  return (brief.empty() ? "" : std::string(brief) + '|') + std::string(option.long_name());
}

std::string bash(std::span<const Command> commands) {
  std::string out = fmt::format(R"(# bash completion of csgcast
_csgcast() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
)",
                                names_of(commands));
  for (const Command& command : commands) {
    out += fmt::format("    {})\n      case $before in\n", command.name);
    for (const Option& option : command.options) {
      if (option.value.empty()) continue;
      if (option.completes == Completes::files) {
        out += fmt::format("        {}) compopt -o default; return ;;\n", pattern_of(option));
      } else {
        out += fmt::format("        {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", pattern_of(option),
                           fmt::join(option.words, " "));
      }
    }
    out += fmt::format("      esac\n      [[ $word != -* ]] || COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n",
                       fmt::join(names_of(command), " "));
    if (command.name == "help") {
      out +=
          fmt::format("      [[ $word == -* ]] || COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n", names_of(commands));
    }
    out += "      ;;\n";
  }
  return out + R"(  esac
  ((${#COMPREPLY[@]})) || compopt -o default
}
complete -F _csgcast csgcast
)";
}

/// A text as zsh takes it within the brackets of an option's description.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '[' || c == ']' || c == ':' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out;
}

std::string zsh_option(const Option& option, std::string_view name) {
  std::string text = fmt::format("{}{}[{}]", option.is_repeatable ? "*" : "", name, zsh_text(option.help));
  if (option.value.empty()) return quoted(text);
  text += fmt::format(":{}:", zsh_text(option.value));
  if (option.completes == Completes::files) text += "_files";
  if (!option.words.empty()) text += fmt::format("({})", fmt::join(option.words, " "));
  return quoted(text);
}

std::string zsh(std::span<const Command> commands) {
  std::string out = "#compdef csgcast\n_csgcast() {\n  if ((CURRENT == 2)); then\n    local -a commands=(\n";
  for (const Command& command : commands)
    out += fmt::format("      {}\n", quoted(command.name + ':' + zsh_text(command.summary)));
  out +=
      "    )\n    _describe command commands\n    return\n  fi\n  local name=$words[2]\n  shift words\n  "
      "((CURRENT--))\n";
  out += "  case $name in\n";
  for (const Command& command : commands) {
    out += fmt::format("    {})\n      _arguments", command.name);
    for (const Option& option : command.options) {
      if (!option.short_name().empty()) out += " \\\n        " + zsh_option(option, option.short_name());
      out += " \\\n        " + zsh_option(option, option.long_name());
    }
    const bool takes_command = command.name == "help";
    out += fmt::format(" \\\n        '*:{}:{}' ;;\n", command.operands.empty() ? "" : command.operands[0].name,
                       takes_command ? fmt::format("({})", names_of(commands)) : std::string("_files"));
  }
  return out + "  esac\n}\n_csgcast \"$@\"\n";
}

std::string fish(std::span<const Command> commands) {
  std::string out = "# fish completion of csgcast\n";
  const std::string none = fmt::format("not __fish_seen_subcommand_from {}", names_of(commands));
  for (const Command& command : commands) {
    out +=
        fmt::format("complete -c csgcast -f -n {} -a {} -d {}\n", quoted(none), command.name, quoted(command.summary));
    const std::string within = "__fish_seen_subcommand_from " + command.name;
    for (const Option& option : command.options) {
      const std::string_view brief = option.short_name();
      out += fmt::format("complete -c csgcast -n {}{} -l {} -d {}", quoted(within),
                         brief.empty() ? "" : fmt::format(" -s {}", brief.substr(1)), option.long_name().substr(2),
                         quoted(option.help));
      if (!option.words.empty())
        out += fmt::format(" -xa '{}'", fmt::join(option.words, " "));
      else if (!option.value.empty())
        out += option.completes == Completes::files ? " -rF" : " -x";
      out += '\n';
    }
    if (command.name == "help")
      out += fmt::format("complete -c csgcast -f -n {} -a '{}'\n", quoted(within), names_of(commands));
  }
  return out;
}

}  // namespace

std::string completion(Shell shell, std::span<const Command> commands) {
  switch (shell) {
    case Shell::bash:
      return bash(commands);
    case Shell::zsh:
      return zsh(commands);
    case Shell::fish:
      break;
  }
  return fish(commands);
}

}  // namespace csgcast::cli
