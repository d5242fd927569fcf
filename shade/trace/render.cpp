// SPDX-License-Identifier: MIT
#include "shade/trace/render.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/precondition.h"
#include "raycast/packets/threads.h"
#include "shade/film/camera.h"
#include "shade/trace/detail/shading_lanes.h"
#include "shade/trace/detail/tiles.h"

namespace csgcast {
namespace {

constexpr int longest_side = 65536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 27;
constexpr int most_samples = 1024;

}  // namespace

void check(const RenderOptions& options) {
  const auto refuse = [](const std::string& problem, const std::string& why, const std::string& remedy) {
    throw Error(ErrorCode::limit, {}, problem, why, remedy);
  };
  const std::int64_t pixels = std::int64_t{options.width} * options.height;
  const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
  if (options.width < 1 || options.height < 1)
    refuse("a picture of " + size, "it has no pixels", "give positive sizes");
  if (options.width > longest_side || options.height > longest_side || pixels > most_pixels) {
    refuse("a picture of " + size, "at most 65536 pixels a side and 134217728 in all fit", "give a smaller size");
  }
  if (options.samples < 1 || options.samples > most_samples) {
    refuse(std::to_string(options.samples) + " samples a pixel", "1 to 1024 are possible",
           "give a number in that range");
  }
  if (options.sampling == Sampling::adaptive && options.mode != Mode::shaded) {
    throw Error(ErrorCode::usage, {}, "adaptive samples in a mode other than shaded",
                "pixels are compared by their light", "take regular ones");
  }
  PacketCaster::check_instructions(options.instructions);
}

namespace {

// Samples a pixel along each axis.
int grid_of(const RenderOptions& options) {
  const bool averages = options.mode == Mode::shaded || options.mode == Mode::edges || options.mode == Mode::xray;
  int grid = 1;
  while (averages && grid * grid < options.samples) ++grid;
  return grid;
}

std::vector<detail::Tile> tiles_of(int width, int height) {
  std::vector<detail::Tile> tiles;
  constexpr int side = detail::tile_side;
  for (int y = 0; y < height; y += side) {
    for (int x = 0; x < width; x += side) {
      tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
    }
  }
  return tiles;
}

// Of the whole process, all threads.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The threads of a picture's tiles, each with a renderer of its own.
class Workers {
 public:
  Workers(const detail::Job& job, int width, int height) : job_(job), tiles_(tiles_of(width, height)) {}

  std::size_t tiles() const { return tiles_.size(); }

  // Calls work(renderer, tile) for each tile.
  template <class Work>
  void each_tile(Work&& work) {
    // A small picture is done before a scheduler is at work.
    if (tiles_.size() == 1 || thread_count() == 1) {
      for (const detail::Tile& tile : tiles_) work(renderer(), tile);
      return;
    }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tiles_.size(), 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) work(renderer(), tiles_[i]);
        },
        tbb::simple_partitioner());
  }

  RenderReport report() const {
    RenderReport report;
    for (const auto& renderer : renderers_) report += renderer->report();
    return report;
  }

 private:
  detail::TileRenderer& renderer() {
    std::unique_ptr<detail::TileRenderer>& own = renderers_.local();
    if (!own) own = std::make_unique<detail::TileRenderer>(job_);
    return *own;
  }

  const detail::Job& job_;
  std::vector<detail::Tile> tiles_;
  tbb::enumerable_thread_specific<std::unique_ptr<detail::TileRenderer>> renderers_;
};

// All pixels with one sample, then those again that this is not enough for. Each step ends before the next begins.
void fill_adaptively(Workers& workers, Film& film, const ProgressCallback& callback) {
  using detail::Tile;
  using detail::TileRenderer;
  ProgressTeller progress(callback, 2 * workers.tiles());
  workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
    renderer.render(tile, film);
    progress.step();
  });
  detail::Refinement refinement(film.width(), film.height());
  workers.each_tile([&](TileRenderer&, const Tile& tile) { refinement.choose_contrasts(film, tile); });
  workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
    renderer.refine(tile, refinement, film);
    progress.step();
  });
  // What a tile chose in another one that was done by then.
  std::atomic<bool> again = true;
  while (again.exchange(false)) {
    workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
      if (renderer.refine(tile, refinement, film)) again = true;
    });
  }
  progress.finish();
}

void fill(Workers& workers, Film& film, const ProgressCallback& callback) {
  ProgressTeller progress(callback, workers.tiles());
  workers.each_tile([&](detail::TileRenderer& renderer, const detail::Tile& tile) {
    renderer.render(tile, film);
    progress.step();
  });
  progress.finish();
}

// A picture, on the threads of the present arena.
Film render_here(const Scene& scene, const View& view, const RenderOptions& options, RenderReport* report,
                 const KeptCells& kept) {
  using Clock = std::chrono::steady_clock;
  const Camera camera(view.camera, options.width, options.height);
  // What is there before the first ray: memory for the picture, and the code for this machine. Before the cells, which
  // are to be in the cache then.
  Film film(options.width, options.height, content(options.mode));
  detail::shading_code(options.instructions);
  const auto before_cells = Clock::now();
  std::optional<Cells> own_cells;
  const Cells* cells = nullptr;
  const bool suits_packets =
      options.mode == Mode::shaded ? detail::PacketTracer::suits(scene, view, camera) : camera.rays_are_in_range();
  if (options.engine == Engine::packets && suits_packets)
    cells = kept.cells != nullptr ? kept.cells : &own_cells.emplace(scene);
  std::optional<LayerCells> own_layer_cells;
  const LayerCells* layer_cells = nullptr;
  if (asks_layers(scene, view, options))
    layer_cells = kept.layer_cells != nullptr ? kept.layer_cells : &own_layer_cells.emplace(scene);
  const auto start = Clock::now();
  const double cpu_start = cpu_seconds();
  const int grid = grid_of(options);
  const Sampling sampling = grid > 1 ? options.sampling : Sampling::regular;
  const detail::Job job{.scene = scene,
                        .view = view,
                        .camera = camera,
                        .mode = options.mode,
                        .grid = grid,
                        .sampling = sampling,
                        .cells = cells,
                        .layer_cells = layer_cells,
                        .instructions = options.instructions};
  Workers workers(job, options.width, options.height);
  const bool adaptive = sampling == Sampling::adaptive;
  adaptive ? fill_adaptively(workers, film, options.progress) : fill(workers, film, options.progress);
  if (report != nullptr) {
    RenderReport cost = workers.report();
    const auto pixels = static_cast<std::uint64_t>(options.width) * static_cast<std::uint64_t>(options.height);
    if (adaptive) {
      cost.skipped.primary_like_neighbours = (pixels - cost.refined_pixels) * static_cast<unsigned>(grid * grid - 1);
    }
    cost.cells_seconds = std::chrono::duration<double>(start - before_cells).count();
    cost.cpu_seconds = cpu_seconds() - cpu_start;
    cost.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    *report += cost;
  }
  return film;
}

}  // namespace

FilmContent content(Mode mode) {
  switch (mode) {
    case Mode::shaded:
    case Mode::edges:
      return FilmContent::color;
    case Mode::xray:
      return FilmContent::length;
    case Mode::depth:
      return FilmContent::depth;
    case Mode::normal:
      return FilmContent::normal;
    case Mode::id:
      return FilmContent::id;
  }
  return FilmContent::color;
}

bool asks_layers(const Scene& scene, const View& view, const RenderOptions& options) {
  return options.engine == Engine::packets && options.mode == Mode::shaded && LayerCells::suits(scene) &&
         view.settings.max_depth > 0;
}

Film render(const Scene& scene, const View& view, const RenderOptions& options, RenderReport* report,
            const KeptCells& kept) {
  CSGCAST_PRECONDITION(kept.cells == nullptr || &kept.cells->scene() == &scene);
  CSGCAST_PRECONDITION(kept.layer_cells == nullptr || &kept.layer_cells->scene() == &scene);
  check(options);
  std::optional<Film> film;
  on_threads(options.threads, [&] { film = render_here(scene, view, options, report, kept); });
  return std::move(*film);
}

std::string trace_pixel(const Scene& scene, const View& view, const RenderOptions& options, int x, int y) {
  check(options);
  if (options.mode != Mode::shaded) {
    throw Error(ErrorCode::usage, {}, "the rays of a pixel are those that bring its light", "other modes cast one ray",
                "use Mode::shaded");
  }
  if (x < 0 || y < 0 || x >= options.width || y >= options.height) {
    throw Error(ErrorCode::usage, {},
                "pixel " + std::to_string(x) + "," + std::to_string(y) + " is outside the picture",
                "columns and rows count from 0 at the top left",
                "give one below " + std::to_string(options.width) + "," + std::to_string(options.height));
  }
  const Camera camera(view.camera, options.width, options.height);
  Caster caster(scene);
  Tracer tracer(caster, view);
  RayTree tree;
  const Rgb color = tracer.trace(camera.ray(x + 0.5, y + 0.5), &tree);
  return fmt::format("pixel {},{}: linear [{:.6g} {:.6g} {:.6g}]\n", x, y, color.r, color.g, color.b) +
         to_string(tree, scene);
}

}  // namespace csgcast
