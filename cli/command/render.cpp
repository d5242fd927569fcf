// SPDX-License-Identifier: MIT
#include "shade/trace/render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/scene_input.h"
#include "cli/input/tile_file.h"
#include "cli/output/output.h"
#include "cli/output/render_stats.h"
#include "cli/output/stopwatch.h"
#include "csg/base/number_text.h"
#include "raycast/packets/threads.h"
#include "shade/picture/image_file.h"

namespace csgcast::cli {
namespace {

constexpr int largest_side = 65536;
constexpr int most_samples = 1024;
constexpr std::array<std::pair<const char*, Mode>, 6> modes{{{"shaded", Mode::shaded},
                                                             {"edges", Mode::edges},
                                                             {"xray", Mode::xray},
                                                             {"depth", Mode::depth},
                                                             {"normal", Mode::normal},
                                                             {"id", Mode::id}}};

struct RenderCommandOptions {
  SceneOptions scene;
  RenderOptions render;
  std::string size = "800x600";
  std::string samples = "1";
  bool adaptive = false;
  std::string camera;
  std::string tiles;
  std::string trace_pixel;
  std::string output;
  std::string stats;
};

/// The options, checked as far as they can be before the scene is read.
struct Job {
  RenderOptions render;
  std::optional<CameraDescription> camera;
  std::optional<std::pair<int, int>> pixel;
  std::optional<std::pair<int, int>> tile;  ///< which of how many
};

std::uint64_t memory_available() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page_size = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page_size > 0 ? std::uint64_t(pages) * std::uint64_t(page_size) : ~std::uint64_t(0);
}

/// The film itself, and the bytes that a file of it is made from.
void check_film_memory(const RenderOptions& options) {
  const std::uint64_t pixels = std::uint64_t(options.width) * std::uint64_t(options.height);
  const std::uint64_t needed = 2 * pixels * std::uint64_t(channels(content(options.mode))) * sizeof(float);
  if (needed > memory_available()) {
    throw UsageError(fmt::format("--size {}x{} needs {} GB of memory (this machine has {}); make the picture smaller",
                                 options.width, options.height, needed >> 30, memory_available() >> 30));
  }
}

void check_files(const RenderCommandOptions& options) {
  std::vector<NamedFile> outputs;
  if (!options.output.empty()) outputs.push_back({"-o", options.output});
  if (!options.stats.empty()) outputs.push_back({"--stats", options.stats});
  if (!options.trace_pixel.empty()) outputs.push_back({"--trace-pixel", ""});
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}}, outputs);
}

Sampling adaptive_sampling(const RenderOptions& options) {
  if (options.mode != Mode::shaded) {
    throw UsageError("--adaptive needs --mode shaded (pixels are compared by their light)");
  }
  if (options.samples == 1) {
    throw UsageError("--adaptive needs --samples of more than 1 (it takes fewer where pixels look alike)");
  }
  return Sampling::adaptive;
}

Job check(const RenderCommandOptions& options) {
  Job job{options.render, {}, {}};
  std::tie(job.render.width, job.render.height) = parse_pair("--size", options.size, 'x', 1, largest_side);
  job.render.samples = parse_count("--samples", options.samples, 1, most_samples);
  if (options.adaptive) job.render.sampling = adaptive_sampling(job.render);
  check_film_memory(job.render);
  if (!options.camera.empty()) job.camera = camera_from_numbers(parse_numbers("--camera", options.camera));
  if (!options.trace_pixel.empty()) {
    if (job.render.mode != Mode::shaded) {
      throw UsageError("--trace-pixel needs --mode shaded (it prints the rays that bring a pixel's light)");
    }
    const auto [x, y] = parse_pair("--trace-pixel", options.trace_pixel, ',', 0, largest_side - 1);
    if (x >= job.render.width || y >= job.render.height) {
      throw UsageError(fmt::format("--trace-pixel {},{} is outside the picture of {}x{}", x, y, job.render.width,
                                   job.render.height));
    }
    job.pixel = {x, y};
  }
  check_files(options);
  if (!options.tiles.empty()) {
    job.tile = parse_pair("--tiles", options.tiles, '/', 0, largest_side);
    if (options.output.empty()) throw UsageError("--tiles needs -o (where shall the tile go?)");
    job.render.region = band_of_picture(job.render.width, job.render.height, job.tile->first, job.tile->second);
    check_tile_path(options.output);
    return job;
  }
  if (options.output.empty()) {
    if (!job.pixel) throw UsageError("-o is needed (where shall the picture go?)");
    if (!options.stats.empty()) throw UsageError("--stats needs -o (there is no picture to count rays of)");
    return job;
  }
  check_image_path(options.output);
  return job;
}

/// The files of a picture, open from the beginning.
struct PictureFiles {
  explicit PictureFiles(const RenderCommandOptions& options) : picture(options.output) {
    if (!options.stats.empty()) stats.emplace(options.stats);
  }

  Output picture;
  std::optional<Output> stats;
};

const char* word(Mode mode) {
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const auto& m) { return m.second == mode; });
  return found->first;
}

TileHead tile_head(const RenderCommandOptions& options, const Job& job, const text::Document& document) {
  TileHead head{.index = job.tile->first,
                .count = job.tile->second,
                .width = job.render.width,
                .height = job.render.height,
                .region = *job.render.region,
                .content = content(job.render.mode),
                .label = PartLabel(document, options.scene)};
  head.label.add("mode", word(job.render.mode));
  head.label.add("samples", fmt::to_string(job.render.samples));
  head.label.add("adaptive", options.adaptive ? "yes" : "no");
  if (!options.camera.empty()) {
    std::string camera;
    for (const double value : parse_numbers("--camera", options.camera)) camera += ' ' + number(value);
    head.label.add("camera", camera.substr(1));
  }
  return head;
}

void render_picture(const RenderCommandOptions& options, Job& job, const SceneInput& input, const View& view,
                    const std::optional<TileHead>& tile, PictureFiles& files) {
  RenderReport report;
  std::optional<ProgressBar> bar(std::in_place, "render", options.scene.progress());
  job.render.progress = bar->callback();
  const Film film = render(input.scene, view, job.render, &report);
  bar.reset();
  const Stopwatch write_watch;
  if (tile) {
    write_tile(*tile, film, files.picture);
  } else {
    files.picture.write(image_bytes(film, options.output));
  }
  files.picture.commit();
  if (!files.stats) return;
  files.stats->write(render_stats(
      job.render, report,
      {input.read_seconds, input.compile_seconds, report.cells_seconds, report.seconds, write_watch.seconds()}));
  files.stats->commit();
}

void run(const RenderCommandOptions& options) {
  Job job = check(options);
  std::optional<PictureFiles> files;
  if (!options.output.empty()) files.emplace(options);
  DocumentInput document = read_document(options.scene);
  std::optional<TileHead> tile;
  if (job.tile) tile = tile_head(options, job, document.document);
  SceneInput input = compile_document(std::move(document), options.scene);
  if (job.camera) input.description.camera = job.camera;
  const View view = make_view(input.description, input.scene, double(job.render.width) / job.render.height);
  if (job.pixel) {
    Output output("");
    output.write(trace_pixel(input.scene, view, job.render, job.pixel->first, job.pixel->second));
    output.commit();
  }
  if (files) render_picture(options, job, input, view, tile, *files);
}

}  // namespace

Command render_command(CLI::App& program) {
  auto options = std::make_shared<RenderCommandOptions>();
  CLI::App* line = program.add_subcommand("render", "Make a picture");
  add_scene_options(*line, options->scene);
  line->add_option("-o,--output", options->output, "The picture to write: .png, .jpg, .tif (8 bits) or .exr (floats)")
      ->type_name("FILE");
  line->add_option("--size", options->size, "Width and height in pixels")->type_name("WxH")->capture_default_str();
  line->add_option("--samples", options->samples, "Rays a pixel, rounded up to a square number")
      ->type_name("N")
      ->capture_default_str();
  line->add_flag("--adaptive", options->adaptive, "Take all samples only in pixels that do not look like those around");
  line->add_option("--camera", options->camera,
                   "Eye and the point looked at; or seven numbers: OpenSCAD's translation, rotation and distance")
      ->type_name("ex,ey,ez,ax,ay,az");
  line->add_option("--tiles", options->tiles,
                   "Only tile i of n, bands of rows from 0 at the top, as .csgtile; join makes the picture of all")
      ->type_name("i/n");
  add_choice(*line, "--mode", options->render.mode, "What the picture shows", {modes.begin(), modes.end()});
  line->add_option("--stats", options->stats, "Count rays and tests, and time each stage, into this file")
      ->type_name("FILE.json");
  line->add_option("--trace-pixel", options->trace_pixel,
                   "Print the rays of one pixel, counted from the top left; -o may then be left out")
      ->type_name("x,y");
  line->footer(
      "Example:\n"
      "  csgcast render part.csg -o part.png\n"
      "  csgcast render part.csg -o part.exr --size 1920x1080 --samples 9 --camera 80,-120,60,0,0,0 --stats part.json");
  return {line, [options] { on_threads(options->scene.threads, [&] { run(*options); }); }};
}

}  // namespace csgcast::cli
