// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/row_parts.h"
#include "cli/input/tile_file.h"
#include "cli/output/output.h"
#include "shade/picture/image_file.h"

namespace csgcast::cli {
namespace {

struct JoinOptions {
  std::vector<std::string> parts;
  std::string output;
};

void run(const JoinOptions& options) {
  std::vector<NamedFile> inputs;
  for (const std::string& part : options.parts) inputs.push_back({"a part", part});
  const std::vector<NamedFile> outputs{{"-o", options.output}};
  const bool is_picture = is_tile(options.parts.front());
  if (is_picture && options.output.empty()) throw UsageError("-o is needed (where shall the picture go?)");
  check_distinct(inputs, outputs);
  if (is_picture) check_image_path(options.output);
  Output output(options.output);
  if (is_picture) {
    output.write(image_bytes(join_tiles(options.parts), options.output));
  } else {
    join_rows(options.parts, output);
  }
  output.commit();
}

}  // namespace

Command join_command(CLI::App& program) {
  auto options = std::make_shared<JoinOptions>();
  CLI::App* line = program.add_subcommand("join", "Put parts of a result together");
  line->add_option("parts", options->parts, "All parts, in any order: of render --tiles, or of intervals --rows")
      ->required()
      ->type_name("")
      ->option_text("PART ..");
  line->add_option("-o,--output", options->output,
                   "The file to write: a picture, or intervals (default: standard output)")
      ->type_name("FILE");
  line->footer(
      "What is written is byte for byte what one run makes.\n\n"
      "Example:\n"
      "  csgcast join -o whole.png tile-*.csgtile\n"
      "  csgcast join -o whole.csv rows-*.csv");
  return {line, [options] { run(*options); }};
}

}  // namespace csgcast::cli
