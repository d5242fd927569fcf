// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/scene_input.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/labelled_row.h"
#include "cli/output/output.h"
#include "cli/output/printable.h"
#include "cli/output/weld_lines.h"
#include "csg/base/number_text.h"
#include "measure/check.h"
#include "raycast/packets/threads.h"

namespace csgcast::cli {
namespace {

struct CheckCommand {
  SceneOptions scene;
  Format format = Format::table;
  std::string output;
};

std::string part_name(const Scene& scene, PartId part) { return printable(scene.parts()[part.index()].name.name); }

std::string place(const Place& place) { return fmt::format("{}:{}", place.line, place.column); }

/// Whether two parts share next to nothing of what either is: they touch, as assemblies do.
bool is_touch(const Scene& scene, const Contact& contact) {
  const auto volume = [&](PartId part) {
    const Vector size = scene.node(scene.parts()[part.index()].node).box.size();
    return size.x * size.y * size.z;
  };
  return contact.most <= 0x1p-30 * std::fmin(volume(contact.first), volume(contact.second));
}

std::string as_text(const Scene& scene, const CheckReport& report) {
  std::string out;
  for (const Overlap& overlap : report.overlaps) {
    append_row(out, "overlap",
               fmt::format("{} and {}  volume {:.4g} ± {:.2g}  at {},{},{}", part_name(scene, overlap.first),
                           part_name(scene, overlap.second), overlap.volume.value, overlap.volume.error,
                           number(overlap.witness.x), number(overlap.witness.y), number(overlap.witness.z)));
  }
  for (const Contact& contact : report.undecided) {
    if (is_touch(scene, contact)) continue;
    append_row(out, "undecided",
               fmt::format("{} and {} share no more than {:.2g}, or nothing", part_name(scene, contact.first),
                           part_name(scene, contact.second), contact.most));
  }
  if (report.is_unbounded) append_row(out, "unbounded", "the whole solid may be");
  for (const PartId part : report.unbounded) append_row(out, "unbounded", "part " + part_name(scene, part) + " may be");
  if (report.is_empty) append_row(out, "empty", "the whole solid");
  for (const PartId part : report.empty) append_row(out, "empty", "part " + part_name(scene, part));
  for (const Redundancy& redundancy : report.redundant) {
    append_row(out, "no effect",
               fmt::format("{} at {}: {}", word(scene, redundancy), place(redundancy.place), reason(redundancy.why)));
  }
  if (report.not_asked > 0)
    append_row(
        out, "no effect",
        fmt::format("not looked for in {}: each is among hundreds of others", counted(report.not_asked, "statement")));
  if (!report.looked_for_redundancy) append_row(out, "no effect", "not looked for: there are too many leaves");
  append_welding(out, scene.weld_report());
  append_row(out, "found",
             fmt::format("{} among {}; {} without effect", counted(report.overlaps.size(), "overlap"),
                         counted(scene.parts().size(), "part"), counted(report.redundant.size(), "statement")));
  return out;
}

void json_parts(Json& json, const Scene& scene, PartId first, PartId second) {
  json.key("parts").begin_array(Json::Layout::compact);
  for (const PartId part : {first, second}) json.value(scene.parts()[part.index()].name.name);
  json.end_array();
}

std::string as_json(const Scene& scene, const CheckReport& report) {
  std::string out;
  Json json(out);
  json.begin_object().key("overlaps").begin_array();
  for (const Overlap& overlap : report.overlaps) {
    json.begin_object(Json::Layout::compact);
    json_parts(json, scene, overlap.first, overlap.second);
    json.member("volume", overlap.volume.value).member("volume_error", overlap.volume.error);
    json.member("witness", overlap.witness).end_object();
  }
  json.end_array().key("undecided").begin_array();
  for (const Contact& contact : report.undecided) {
    json.begin_object(Json::Layout::compact);
    json_parts(json, scene, contact.first, contact.second);
    json.member("most_volume", contact.most).end_object();
  }
  json.end_array().member("unbounded", report.is_unbounded).member("empty", report.is_empty);
  for (const auto& [name, parts] :
       {std::pair("unbounded_parts", &report.unbounded), std::pair("empty_parts", &report.empty)}) {
    json.key(name).begin_array(Json::Layout::compact);
    for (const PartId part : *parts) json.value(scene.parts()[part.index()].name.name);
    json.end_array();
  }
  json.key("without_effect").begin_array();
  for (const Redundancy& redundancy : report.redundant) {
    json.begin_object(Json::Layout::compact).member("kind", word(scene, redundancy));
    json.member("place", place(redundancy.place)).member("why", reason(redundancy.why)).end_object();
  }
  json.end_array().member("not_asked", std::uint64_t(report.not_asked));
  json.member("looked_for_redundancy", report.looked_for_redundancy);
  json_welding(json, scene.weld_report());
  json.end_object();
  return out + '\n';
}

void run(const CheckCommand& command) {
  check_distinct(std::array{NamedFile{"the scene", command.scene.path}}, std::array{NamedFile{"-o", command.output}});
  Output output(command.output);
  SceneOptions scene_options = command.scene;
  scene_options.welding.lists_near_misses = scene_options.welding.mode != Welding::Mode::off;
  const SceneInput input = read_scene(scene_options);
  CheckReport report;
  {
    ProgressBar bar("checking", command.scene.progress());
    CheckOptions job;
    job.progress = bar.callback();
    report = check(input.scene, job);
  }
  output.write(command.format == Format::json ? as_json(input.scene, report) : as_text(input.scene, report));
  output.commit();
}

}  // namespace

Command check_command() {
  auto options = std::make_shared<CheckCommand>();
  Command command{.name = "check",
                  .summary = "Look for parts that overlap, statements without effect, and unbounded solids"};
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.details =
      "Two parts overlap if a ray was found that is inside both at once, exactly. Faces that only touch do not "
      "overlap. Findings are no errors: the exit code is 0.";
  command.examples = {"csgcast check assembly.csg", "csgcast check assembly.csg --format json -o report.json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
