// SPDX-License-Identifier: MIT
#include <optional>

#include "cli/command/commands.h"
#include "cli/manual/completion.h"
#include "cli/manual/help_text.h"
#include "cli/manual/man_page.h"
#include "cli/output/output.h"
#include "cli/output/usage.h"

namespace csgcast::cli {
namespace {

struct HelpOptions {
  std::string command;
  bool man = false;
  std::string shell;
  std::string output;
};

std::optional<Shell> shell_named(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name == "bash") return Shell::bash;
  if (name == "zsh") return Shell::zsh;
  if (name == "fish") return Shell::fish;
  throw UsageError(fmt::format("--completion '{}' is unknown (known are bash|zsh|fish)", name));
}

std::string text_of(const HelpOptions& options) {
  const std::vector<Command> commands = all_commands();
  const std::optional<Shell> shell = shell_named(options.shell);
  if ((options.man || shell) && !options.command.empty())
    throw UsageError("--man and --completion tell all commands: leave COMMAND out");
  if (options.man) return man_page(commands);
  if (shell) return completion(*shell, commands);
  if (options.command.empty()) return help_text(commands);
  return help_text(command_named(options.command, commands));
}

}  // namespace

Command help_command() {
  auto options = std::make_shared<HelpOptions>();
  Command command{.name = "help", .summary = "Explain the program, or one of its commands"};
  command.operands.push_back({.name = "COMMAND",
                              .help = "The command to explain; without it all are listed",
                              .take = into(options->command),
                              .is_required = false,
                              .completes = Completes::nothing});
  command.add({.names = "--man",
               .value = {},
               .help = "Write the manual page csgcast(1), for man",
               .take = into(options->man),
               .conflicts = {"--completion"}});
  command.add({.names = "--completion",
               .value = "bash|zsh|fish",
               .help = "Write the script that teaches a shell to complete csgcast's command lines",
               .take = into(options->shell),
               .words = {"bash", "zsh", "fish"}});
  command.add(output_option(options->output));
  command.examples = {"csgcast help render", "csgcast help --man | man -l -",
                      "csgcast help --completion bash > ~/.local/share/bash-completion/completions/csgcast"};
  command.run = [options] {
    Output output(options->output);
    output.write(text_of(*options));
    output.commit();
  };
  return command;
}

}  // namespace csgcast::cli
