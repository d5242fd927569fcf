// SPDX-License-Identifier: MIT
#include "shade/trace/render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/scene_input.h"
#include "cli/input/tile_file.h"
#include "cli/output/camera_text.h"
#include "cli/output/output.h"
#include "cli/output/printable.h"
#include "cli/output/render_stats.h"
#include "cli/output/stopwatch.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"
#include "raycast/packets/threads.h"
#include "shade/picture/image_file.h"
#include "shade/trace/channels.h"

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
  std::optional<std::string> samples;
  bool adaptive = false;
  bool alpha = false;
  std::optional<std::string> bits;
  std::string channels;
  std::string camera;
  std::string tiles;
  std::string trace_pixel;
  std::string output;
  std::string stats;
};

/// The options, checked as far as they can be before the scene is read.
struct Job {
  RenderOptions render;
  PictureOptions picture{};
  bool has_color = true;
  bool has_alpha = false;
  std::vector<Channel> channels{};  ///< none: a plain picture
  std::optional<CameraDescription> camera{};
  std::optional<std::pair<int, int>> pixel{};
  std::optional<std::pair<int, int>> tile{};  ///< which of how many
};

/// The channels that --channels names, in its order; color and alpha apart.
void read_channels(const std::string& names, Job& job) {
  using enum Channel;
  constexpr std::array<std::pair<std::string_view, Channel>, 6> known{
      {{"depth", depth}, {"normal", normal}, {"position", position}, {"id", id}, {"part", part}, {"leaf", leaf}}};
  job.has_color = false;
  std::string_view rest = names;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = trimmed(rest.substr(0, comma));
    const auto found = std::find_if(known.begin(), known.end(), [&](const auto& row) { return row.first == name; });
    bool is_new = true;
    if (name == "color") {
      is_new = !std::exchange(job.has_color, true);
    } else if (name == "alpha") {
      is_new = !std::exchange(job.has_alpha, true);
    } else if (found == known.end()) {
      throw UsageError(
          fmt::format("--channels: {} is unknown (known are color, alpha, depth, normal, position, id, part, leaf)",
                      in_quotes(name)));
    } else {
      is_new = std::find(job.channels.begin(), job.channels.end(), found->second) == job.channels.end();
      job.channels.push_back(found->second);
    }
    if (!is_new) throw UsageError(fmt::format("--channels: {} is given more than once", in_quotes(name)));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (job.has_alpha && !job.has_color)
    throw UsageError("--channels: alpha needs color (it says how much of it there is)");
}

std::uint64_t memory_available() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page_size = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page_size > 0 ? std::uint64_t(pages) * std::uint64_t(page_size) : ~std::uint64_t(0);
}

/// The films themselves, and the bytes that a file of them is made from.
void check_film_memory(const Job& job) {
  const std::uint64_t pixels = std::uint64_t(job.render.width) * std::uint64_t(job.render.height);
  int count = job.has_color ? channels(content(job.render.mode)) : 0;
  if (job.has_alpha) count += channels(FilmContent::color_alpha);
  for (const Channel channel : job.channels) count += static_cast<int>(names_in_file(channel).size());
  const std::uint64_t needed = 2 * pixels * std::uint64_t(count) * sizeof(float);
  if (needed > memory_available()) {
    throw UsageError(fmt::format("--size {}x{} needs {} GB of memory (this machine has {}); make the picture smaller",
                                 job.render.width, job.render.height, needed >> 30, memory_available() >> 30));
  }
}

void check_files(const RenderCommandOptions& options) {
  std::vector<NamedFile> outputs;
  if (!options.output.empty()) outputs.push_back({"-o", path_of(options.output)});
  if (!options.stats.empty()) outputs.push_back({"--stats", path_of(options.stats)});
  if (!options.trace_pixel.empty()) outputs.push_back({"--trace-pixel", ""});
  if (std::count_if(outputs.begin(), outputs.end(), [](const NamedFile& f) { return f.path.empty(); }) > 1)
    throw UsageError("only one of -o, --stats and --trace-pixel can go to standard output");
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}}, outputs);
}

int parse_samples(const RenderCommandOptions& options) {
  const int samples = parse_count("--samples", *options.samples, 1, most_samples);
  if (!takes_samples(options.render.mode)) {
    throw UsageError(
        "--samples has no effect with --mode depth, normal or id (these take the ray through a pixel's centre)");
  }
  if (options.output.empty()) throw UsageError("--samples needs -o (--trace-pixel takes the ray through the centre)");
  return samples;
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

void check_channels(const RenderCommandOptions& options, const Job& job) {
  const char* given = options.alpha               ? "--alpha"
                      : !options.channels.empty() ? "--channels"
                      : options.bits              ? "--bits"
                                                  : nullptr;
  if (given == nullptr) return;
  if (!options.tiles.empty())
    throw UsageError(
        fmt::format("{} cannot be given beside --tiles (a tile holds colors alone; csgcast join takes --bits)", given));
  if (options.output.empty()) throw UsageError(fmt::format("{} needs -o (it is about the picture)", given));
  if (job.has_alpha && job.render.mode != Mode::shaded)
    throw UsageError("alpha needs --mode shaded (it is the share of a pixel's light that comes from the solid)");
  if (job.has_alpha && options.adaptive) throw UsageError("alpha cannot be given beside --adaptive");
  if (options.channels.empty()) return;
  if (!holds_layers(picture_name(options.output)))
    throw UsageError("--channels needs -o with an .exr (other pictures hold no channels by name)");
  if (!job.has_color && (options.samples || options.render.mode != Mode::shaded))
    throw UsageError("--samples and --mode have no effect without the channel color");
}

Job check(const RenderCommandOptions& options) {
  Job job{.render = options.render};
  std::tie(job.render.width, job.render.height) = parse_pair("--size", options.size, 'x', 1, largest_side);
  if (options.samples) job.render.samples = parse_samples(options);
  if (options.adaptive) job.render.sampling = adaptive_sampling(job.render);
  if (options.bits) job.picture.bits = parse_count("--bits", *options.bits, 8, 32);
  job.has_alpha = options.alpha;
  job.picture.content = options.alpha ? FilmContent::color_alpha : content(job.render.mode);
  if (!options.channels.empty()) read_channels(options.channels, job);
  check_channels(options, job);
  check_film_memory(job);
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
  check_image_path(picture_name(options.output), job.picture);
  return job;
}

/// The files of a picture, open from the beginning.
struct PictureFiles {
  explicit PictureFiles(const RenderCommandOptions& options) : picture(path_of(options.output)) {
    if (!options.stats.empty()) stats.emplace(path_of(options.stats));
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

/// What a picture's file says of itself.
std::vector<std::pair<std::string, std::string>> notes(const RenderCommandOptions& options, const View& view) {
  return {{"Scene", printable(std::filesystem::path(options.scene.path).filename().string())},
          {"Camera", camera_text(view.camera)}};
}

std::vector<NamedChannels> layers(const Job& job, const std::optional<Film>& color, const std::vector<Film>& films) {
  std::vector<NamedChannels> layers;
  if (color) {
    const int count = channels(color->content());
    const std::vector<std::string> names = count == 1   ? std::vector<std::string>{"Y"}
                                           : count == 3 ? std::vector<std::string>{"R", "G", "B"}
                                                        : std::vector<std::string>{"R", "G", "B", "A"};
    layers.push_back({&*color, names});
  }
  for (std::size_t i = 0; i < films.size(); ++i) layers.push_back({&films[i], names_in_file(job.channels[i])});
  return layers;
}

void render_picture(const RenderCommandOptions& options, Job& job, const SceneInput& input, const View& view,
                    std::optional<TileHead> tile, PictureFiles& files) {
  RenderReport report;
  std::optional<ProgressBar> bar(std::in_place, "render", options.scene.progress());
  job.render.progress = bar->callback();
  std::optional<Cells> cells;
  if (!job.channels.empty()) {  // for all films
    const Stopwatch cells_watch;
    cells.emplace(input.scene);
    report.cells_seconds += cells_watch.seconds();
  }
  const KeptCells kept{.cells = cells ? &*cells : nullptr};
  std::optional<Film> color;
  if (job.has_color) {
    color = job.has_alpha ? render_with_alpha(input.scene, view, job.render, &report, kept)
                          : render(input.scene, view, job.render, &report, kept);
  }
  std::vector<Film> films;
  if (!job.channels.empty()) {
    bar.emplace("channels", options.scene.progress());
    job.render.progress = bar->callback();
    films = channel_films(input.scene, view, job.render, job.channels, kept);
  }
  bar.reset();
  const Stopwatch write_watch;
  const std::vector<std::pair<std::string, std::string>> said = notes(options, view);
  if (tile) {
    for (const auto& [name, text] : said) tile->add_note(name, text);
    write_tile(*tile, *color, files.picture);
  } else {
    const PictureOptions picture{job.picture.bits, said};
    const std::string name = picture_name(options.output);
    files.picture.write(options.channels.empty() ? image_bytes(*color, name, picture)
                                                 : layer_bytes(layers(job, color, films), name, picture));
  }
  files.picture.commit();
  if (!files.stats) return;
  files.stats->write(render_stats(
      input.scene, job.render, report,
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

Command render_command() {
  auto options = std::make_shared<RenderCommandOptions>();
  Command command{.name = "render", .summary = "Make a picture"};
  command.add(
      {.names = "-o,--output",
       .value = "FILE",
       .help =
           "The picture to write. Its ending tells its kind: .png, .jpg, .tif, .webp, .exr (floats) and others; - is "
           "standard output, as PNG",
       .take = into(options->output),
       .completes = Completes::files});
  command.add({.names = "--size",
               .value = "WxH",
               .help = "Width and height in pixels",
               .preset = options->size,
               .take = into(options->size)});
  command.add({.names = "--samples",
               .value = "N",
               .help = "Rays a pixel, rounded up to a square number (default 1). For modes shaded, edges and xray",
               .take = into(options->samples)});
  command.add({.names = "--adaptive",
               .value = {},
               .help = "Take all samples only in pixels that do not look like those around",
               .take = into(options->adaptive)});
  command.add({.names = "--camera",
               .value = "ex,ey,ez,ax,ay,az",
               .help =
                   "The eye and the point looked at; or seven numbers: OpenSCAD's translation, rotation and distance. "
                   "Replaces the scene's camera; the vertical field of view is 22.5 degrees",
               .take = into(options->camera)});
  command.add({.names = "--tiles",
               .value = "i/n",
               .help = "Only tile i of n, bands of rows from 0 at the top, as .csgtile; join makes the picture of all",
               .take = into(options->tiles)});
  command.add(choice<Mode>("--mode", options->render.mode, "What the picture shows", {modes.begin(), modes.end()}));
  command.add({.names = "--bits",
               .value = "8|16|32",
               .help = "Bits of a number in the file, 32 for floats (default: what is usual for its kind)",
               .take = into(options->bits),
               .words = {"8", "16", "32"}});
  command.add(
      {.names = "--alpha",
       .value = {},
       .help = "Leave the background transparent: a fourth channel has the share of each pixel that shows the solid",
       .take = into(options->alpha),
       .conflicts = {"--channels"}});
  command.add(
      {.names = "--channels",
       .value = "NAMES",
       .help = "Several of color, alpha, depth, normal, position, id, part and leaf, separated by commas, in one .exr",
       .take = into(options->channels)});
  command.add({.names = "--stats",
               .value = "FILE.json",
               .help = "Count rays and tests, and time each stage, into this file; - is standard output",
               .take = into(options->stats),
               .completes = Completes::files});
  command.add({.names = "--trace-pixel",
               .value = "x,y",
               .help = "Print the rays of one pixel, counted from the top left; -o may then be left out",
               .take = into(options->trace_pixel)});
  add_scene_options(command, options->scene);
  command.examples = {"csgcast render part.csg -o part.png",
                      "csgcast render part.csg -o part.exr --size 1920x1080 --samples 9 --stats part.json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
