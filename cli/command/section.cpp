// SPDX-License-Identifier: MIT
#include <array>
#include <optional>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/scene_input.h"
#include "cli/output/output.h"
#include "cli/output/usage.h"
#include "measure/section.h"
#include "measure/section_json.h"
#include "measure/section_svg.h"
#include "model/section_image.h"
#include "raycast/packets/threads.h"
#include "shade/picture/image_file.h"

namespace csgcast::cli {
namespace {

struct SectionCommand {
  SceneOptions scene;
  std::string plane;
  std::string relative_error = "1e-6";
  std::optional<std::string> size;
  std::string output;
};

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void run(const SectionCommand& command) {
  const std::vector<double> numbers = parse_numbers("--plane", command.plane, 4);
  const Plane plane{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  if (plane.normal == Vector{}) throw UsageError("--plane has a zero normal: give nx,ny,nz,d such as 0,0,1,2.5");
  SectionOptions job;
  job.relative_error = parse_numbers("--relative-error", command.relative_error, 1)[0];
  if (!(job.relative_error > 0 && job.relative_error < 1))
    throw UsageError(fmt::format("--relative-error {} is not between 0 and 1", command.relative_error));
  const int pixels = parse_count("--size", command.size.value_or("1024"), 1, 16384);
  const bool is_drawing = ends_with(command.output, ".svg");
  const bool is_image = ends_with(command.output, ".png");
  if (!is_drawing && !is_image && !command.output.empty() && !ends_with(command.output, ".json"))
    throw UsageError(fmt::format("-o {} has an unknown ending (known are .svg, .png, .json)", command.output));
  if (command.size && !is_image) throw UsageError("--size needs -o with a .png (it is the pixels of one)");
  check_distinct(std::array{NamedFile{"the scene", command.scene.path}}, std::array{NamedFile{"-o", command.output}});
  Output output(command.output);
  const SceneInput input = read_scene(command.scene);
  Section cut;
  {
    ProgressBar bar("cutting", command.scene.progress());
    job.progress = bar.callback();
    cut = section(input.scene, plane, job);
  }
  if ((is_drawing || is_image) && !cut.is_bounded)
    throw UsageError(
        "the solid may be unbounded: there is no picture of its section; intersect it with a box, or take parts of it "
        "alone (--part)");
  if (is_image) {
    output.write(image_bytes(section_image(input.scene, plane, cut, pixels), command.output));
  } else {
    output.write(is_drawing ? section_svg(cut, unseen_tolerance(cut)) : section_json(cut));
  }
  output.commit();
}

}  // namespace

Command section_command() {
  auto options = std::make_shared<SectionCommand>();
  Command command{.name = "section", .summary = "Cut the solid with a plane: exact curves, area and perimeter"};
  command.add({.names = "--plane",
               .value = "nx,ny,nz,d",
               .help = "The plane n . p = d",
               .take = into(options->plane),
               .is_required = true});
  command.add({.names = "--relative-error",
               .value = "E",
               .help = "The error of area and perimeter that is asked for, divided by the value",
               .preset = options->relative_error,
               .take = into(options->relative_error)});
  Option output = output_option(options->output);
  output.help = "The file to write: .svg, .png or .json; - is standard output, as JSON";
  command.add(output);
  command.add({.names = "--size",
               .value = "N",
               .help = "Pixels of the longer side of a .png (default 1024)",
               .take = into(options->size)});
  add_scene_options(command, options->scene);
  command.details =
      "Curves are runs of lines and conics, in loops around the inside. If a face lies in the cutting plane, the plane "
      "is moved a tiny bit along its normal.";
  command.examples = {"csgcast section part.csg --plane 0,0,1,2.5 -o cut.svg",
                      "csgcast section part.csg --plane 1,0,0,0 -o cut.json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
