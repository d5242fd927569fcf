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
  std::optional<Shell> shell;
  std::string output;
};

std::string text_of(const HelpOptions& options) {
  const std::vector<Command> commands = all_commands();
  if ((options.man || options.shell) && !options.command.empty())
    throw UsageError("--man and --completion tell all commands: leave COMMAND out");
  if (options.man) return man_page(commands);
  if (options.shell) return completion(*options.shell, commands);
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
  command.add(choice<Shell>("--completion", options->shell,
                            "Write the script that teaches a shell to complete csgcast's command lines",
                            {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}));
  command.add(output_option(options->output));
  command.examples = {"csgcast help render", "csgcast help --man | man -l -",
                      "csgcast help --completion bash > csgcast.bash"};
  command.run = [options] {
    Output output(options->output);
    output.write(text_of(*options));
    output.commit();
  };
  return command;
}

}  // namespace csgcast::cli
