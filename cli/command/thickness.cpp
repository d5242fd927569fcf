// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>

#include <array>
#include <optional>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/scene_input.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/leaf_name.h"
#include "cli/output/output.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"
#include "measure/thickness.h"
#include "raycast/packets/threads.h"
#include "shade/film/camera.h"
#include "shade/film/view.h"
#include "shade/picture/image_file.h"

namespace csgcast::cli {
namespace {

constexpr int largest_side = 16384;

struct ThicknessCommand {
  SceneOptions scene;
  std::optional<std::string> size;
  std::string grid = "512";
  std::string camera;
  Format format = Format::table;
  std::string output;
};

/// How thick the solid is where each pixel's ray meets it.
Film thickness_map(const Cells& cells, const View& view, int width, int height) {
  const Camera camera(view.camera, width, height);
  Film film(width, height, FilmContent::length);
  tbb::parallel_for(0, height, [&](int y) {
    const auto count = static_cast<std::size_t>(width);
    std::array<std::vector<double>, 6> numbers;
    for (auto& column : numbers) column.resize(count);
    RayArrays rays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.origin[axis] = numbers[axis];
      rays.direction[axis] = numbers[3 + axis];
    }
    for (int x = 0; x < width; ++x) {
      const Ray ray = camera.ray(x + 0.5, y + 0.5);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        numbers[axis][static_cast<std::size_t>(x)] = ray.origin()[axis];
        numbers[3 + axis][static_cast<std::size_t>(x)] = ray.direction()[axis];
      }
    }
    std::vector<double> thickness(count);
    ThicknessProbe probe(cells);
    probe.first_faces(rays, thickness);
    for (int x = 0; x < width; ++x) film.value(x, y) = static_cast<float>(thickness[static_cast<std::size_t>(x)]);
  });
  return film;
}

std::string as_text(const Scene& scene, const std::optional<ThinPlace>& thinnest) {
  if (!thinnest) return "thinnest    none: the solid is empty, or may be unbounded (--part NAME takes a part alone)\n";
  const auto& [thickness, p, n, leaf] = *thinnest;
  return fmt::format("thinnest    {}  at {},{},{}  normal {},{},{}  face of {}\n", number(thickness), number(p.x),
                     number(p.y), number(p.z), number(n.x), number(n.y), number(n.z), leaf_name(scene, leaf));
}

std::string as_json(const Scene& scene, const std::optional<ThinPlace>& thinnest) {
  std::string out;
  Json json(out);
  json.begin_object().key("thinnest");
  if (!thinnest) {
    json.null();
  } else {
    json.begin_object(Json::Layout::compact).member("thickness", thinnest->thickness).member("place", thinnest->place);
    json.member("normal", thinnest->normal).member("leaf", leaf_name(scene, thinnest->leaf)).end_object();
  }
  json.end_object();
  return out + '\n';
}

void run(const ThicknessCommand& command) {
  const auto [width, height] = parse_pair("--size", command.size.value_or("800x600"), 'x', 1, largest_side);
  const int grid = parse_count("--grid", command.grid, 1, largest_side);
  if (command.output.empty() && (command.size || !command.camera.empty()))
    throw UsageError(fmt::format("{} needs -o (it is about the map)", command.size ? "--size" : "--camera"));
  std::optional<CameraDescription> camera;
  if (!command.camera.empty()) camera = camera_from_numbers(parse_numbers("--camera", command.camera));
  if (!command.output.empty()) {
    check_image_path(picture_name(command.output), {.content = FilmContent::length});
    check_distinct(std::array{NamedFile{"the scene", command.scene.path}},
                   std::array{NamedFile{"-o", path_of(command.output)}});
  }
  std::optional<Output> map;
  if (!command.output.empty()) map.emplace(path_of(command.output));
  SceneInput input = read_scene(command.scene);
  if (camera) input.description.camera = camera;
  const Cells cells(input.scene);
  if (map) {
    const View view = make_view(input.description, input.scene, static_cast<double>(width) / height);
    map->write(image_bytes(thickness_map(cells, view, width, height), picture_name(command.output)));
    map->commit();
  }
  std::optional<ThinPlace> thinnest;
  {
    ProgressBar bar("looking for the thinnest place", command.scene.progress());
    thinnest = find_thinnest(cells, static_cast<std::size_t>(grid), bar.callback());
  }
  const std::string text =
      command.format == Format::json ? as_json(input.scene, thinnest) : as_text(input.scene, thinnest);
  if (command.output == "-") {
    fmt::print(stderr, "{}", text);
    return;
  }
  Output output("");
  output.write(text);
  output.commit();
}

}  // namespace

Command thickness_command() {
  auto options = std::make_shared<ThicknessCommand>();
  Command command{.name = "thickness", .summary = "Tell how thick the solid is: a map, and the thinnest place"};
  command.add({.names = "-o,--output",
               .value = "FILE",
               .help = "Draw a map into this picture; .exr holds the lengths. - is standard output, as PNG; the text "
                       "then goes to standard error",
               .take = into(options->output),
               .completes = Completes::files});
  command.add({.names = "--size",
               .value = "WxH",
               .help = "Width and height of the map in pixels (default 800x600)",
               .take = into(options->size)});
  command.add({.names = "--camera",
               .value = "ex,ey,ez,ax,ay,az",
               .help = "The camera of the map, as for render",
               .take = into(options->camera)});
  command.add({.names = "--grid",
               .value = "N",
               .help = "N x N rays along each axis look for the thinnest place",
               .preset = options->grid,
               .take = into(options->grid)});
  command.add(choice<Format>("--format", options->format, "The format of the text",
                             {{"table", Format::table}, {"json", Format::json}}));
  add_scene_options(command, options->scene);
  command.details =
      "The thickness at a place on the boundary is the way from there straight in, against the normal, to the boundary "
      "again. A place counts for the thinnest one if its far face is at most 60 degrees from square: corners are no "
      "walls.";
  command.examples = {"csgcast thickness part.csg", "csgcast thickness part.csg -o thickness.exr --size 1920x1080"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
