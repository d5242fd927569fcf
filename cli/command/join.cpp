// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/row_parts.h"
#include "cli/input/tile_file.h"
#include "cli/output/output.h"
#include "cli/output/usage.h"
#include "shade/picture/image_file.h"

namespace csgcast::cli {
namespace {

struct JoinOptions {
  std::vector<std::string> parts;
  std::string output;
  std::optional<std::string> bits;
};

void run(const JoinOptions& options) {
  std::vector<NamedFile> inputs;
  for (const std::string& part : options.parts) inputs.push_back({"a part", part});
  const std::vector<NamedFile> outputs{{"-o", path_of(options.output)}};
  const bool is_picture = is_tile(options.parts.front());
  if (is_picture && options.output.empty()) throw UsageError("-o is needed (where shall the picture go?)");
  if (!is_picture && options.bits) throw UsageError("--bits is for pictures (these are parts of intervals)");
  check_distinct(inputs, outputs);
  PictureOptions picture;
  if (options.bits) picture.bits = parse_count("--bits", *options.bits, 8, 32);
  if (is_picture) check_image_path(picture_name(options.output), picture);
  Output output(path_of(options.output));
  if (is_picture) {
    JoinedPicture joined = join_tiles(options.parts);
    picture.notes = std::move(joined.notes);
    output.write(image_bytes(joined.film, picture_name(options.output), picture));
  } else {
    join_rows(options.parts, output);
  }
  output.commit();
}

}  // namespace

Command join_command() {
  auto options = std::make_shared<JoinOptions>();
  Command command{.name = "join", .summary = "Put parts of a result together"};
  command.operands.push_back({.name = "PART",
                              .help = "All parts, in any order: of render --tiles, or of intervals --rows",
                              .take = into(options->parts),
                              .is_repeatable = true});
  command.add({.names = "-o,--output",
               .value = "FILE",
               .help = "The file to write: a picture, or intervals; - is standard output, the default for intervals",
               .take = into(options->output),
               .completes = Completes::files});
  command.add({.names = "--bits",
               .value = "8|16|32",
               .help = "Bits of a number in a picture, 32 for floats (default: what is usual for its kind)",
               .take = into(options->bits),
               .words = {"8", "16", "32"}});
  command.details = "The output is byte for byte what one run makes.";
  command.examples = {"csgcast join -o whole.png tile-*.csgtile", "csgcast join -o whole.csv rows-*.csv"};
  command.run = [options] { run(*options); };
  return command;
}

}  // namespace csgcast::cli
