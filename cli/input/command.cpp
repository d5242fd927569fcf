// SPDX-License-Identifier: MIT
#include "cli/input/command.h"

#include <fmt/format.h>

namespace csgcast::cli {

std::string_view Option::short_name() const {
  const std::size_t comma = names.find(',');
  return comma == std::string::npos ? std::string_view() : std::string_view(names).substr(0, comma);
}

std::string_view Option::long_name() const {
  const std::size_t comma = names.find(',');
  return std::string_view(names).substr(comma == std::string::npos ? 0 : comma + 1);
}

std::string usage_line(const Command& command) {
  std::string line = fmt::format("csgcast {} [OPTIONS]", command.name);
  for (const Operand& operand : command.operands) {
    const std::string name = operand.name + (operand.is_repeatable ? " .." : "");
    line += operand.is_required ? ' ' + name : fmt::format(" [{}]", name);
  }
  return line;
}

std::string path_of(const std::string& output) { return output == "-" ? "" : output; }

std::string picture_name(const std::string& output) { return output == "-" ? "standard output.png" : output; }

Option output_option(std::string& path) {
  return {.names = "-o,--output",
          .value = "FILE",
          .help = "The file to write; - is standard output",
          .preset = "-",
          .take = [&path](const std::string& given) { path = path_of(given); },
          .completes = Completes::files};
}

}  // namespace csgcast::cli
