// SPDX-License-Identifier: MIT
#include <array>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/rows_option.h"
#include "cli/output/csv.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/printable.h"
#include "csg/base/number_text.h"
#include "raycast/packets/threads.h"
#include "raycast/ray/caster.h"

namespace csgcast::cli {
namespace {

struct LocateOptions {
  SceneOptions scene;
  RowsOption points{"--point", "--points", {"x", "y", "z"}, {}, {}};
  Format format = Format::table;
  std::string output;
};

const char* word(Location location) {
  switch (location) {
    case Location::inside:
      return "inside";
    case Location::outside:
      return "outside";
    case Location::boundary:
      break;
  }
  return "boundary";
}

const char* head(Format format) {
  switch (format) {
    case Format::csv:
      return "point,location,part\n";
    case Format::json:
      return "{\"points\": [";
    case Format::table:
      break;
  }
  return "";
}

/// What one thread needs to answer points.
class LocateWorker {
 public:
  LocateWorker(const Scene& scene, Format format) : caster_(scene), format_(format) {}

  void operator()(const NumberRow& row, std::string& text) {
    const Point p{row.values[0], row.values[1], row.values[2]};
    const Location location = caster_.locate(p);
    const PartId part = part_of(p, location);
    append(text, row.index, p, location, part.valid() ? &caster_.scene().parts()[part.index()].name.name : nullptr);
  }

 private:
  /// The first part in file order that has the point inside; if none has, the first with the point on its boundary.
  PartId part_of(Point p, Location location) {
    if (location == Location::outside) return {};
    const PartId inside = caster_.part_at(p);
    if (inside.valid()) return inside;
    const auto parts = caster_.scene().parts();
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      if (caster_.locate(parts[i].node, p) == Location::boundary) return PartId(i);
    }
    return {};
  }

  void append(std::string& text, std::uint64_t index, Point p, Location location, const std::string* part) const {
    if (format_ == Format::csv) {
      text += fmt::format("{},{},{}\n", index, word(location), part != nullptr ? csv_field(*part) : "");
      return;
    }
    if (format_ == Format::json) {
      text += index == 0 ? "\n" : ",\n";
      Json json(text);
      json.begin_object(Json::Layout::compact).member("point", index).member("at", p);
      json.member("location", word(location)).key("part");
      if (part != nullptr) {
        json.value(*part);
      } else {
        json.null();
      }
      json.end_object();
      return;
    }
    text += fmt::format("point {} at {},{},{}: {}", index, number(p.x), number(p.y), number(p.z), word(location));
    text += part != nullptr ? fmt::format(", part {}\n", printable(*part)) : "\n";
  }

  Caster caster_;
  Format format_;
};

void run(const LocateOptions& options) {
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}, NamedFile{"--points", options.points.file}},
                 std::array{NamedFile{"-o", options.output}});
  Rows rows(options.points, options.scene);
  Output output(options.output);
  const SceneInput input = read_scene(options.scene);
  output.write(head(options.format));
  answer_rows([&](NumberRow& row) { return rows.next(row); }, output,
              [&] { return LocateWorker(input.scene, options.format); });
  output.write(options.format == Format::json ? "\n]}\n" : "");
  output.commit();
}

}  // namespace

Command locate_command() {
  auto options = std::make_shared<LocateOptions>();
  Command command{.name = "locate", .summary = "Tell whether points are inside, outside or on the boundary"};
  add_rows_option(command, options->points, "One point");
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"csv", Format::csv}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.details =
      "The columns of a file of points stand in the order of --points, with a header or without. The part is the "
      "first one in the file that has the point inside, or else the first one with the point on its boundary.";
  command.examples = {"csgcast locate part.csg --point 1,2,3",
                      "csgcast locate part.csg --points points.csv --format csv -o where.csv"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
