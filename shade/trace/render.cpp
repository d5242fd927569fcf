// SPDX-License-Identifier: MIT
#include "shade/trace/render.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "csg/base/error.h"
#include "shade/film/camera.h"
#include "shade/trace/detail/shading_lanes.h"
#include "shade/trace/detail/tiles.h"

namespace csgcast {
namespace {

constexpr int longest_side = 65536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 27;
constexpr int most_samples = 1024;

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

// More than there are tiles would have nothing to do.
int threads_of(const RenderOptions& options, std::size_t tiles) {
  constexpr int most_threads = 1024;
  const int wanted = options.threads > 0 ? std::min(options.threads, most_threads) : tbb::info::default_concurrency();
  return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(wanted), tiles));
}

// Of the whole process, all threads.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Tells how much is done, ascending, one thread at a time.
class Progress {
 public:
  Progress(const std::function<void(double)>& tell, std::size_t total) : tell_(tell), total_(total) {}

  void add_one() {
    if (!tell_) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    tell_(static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  const std::function<void(double)>& tell_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

// The threads of a picture, and its tiles.
class Threads {
 public:
  explicit Threads(const RenderOptions& options)
      : tiles_(tiles_of(options.width, options.height)), count_(threads_of(options, tiles_.size())), arena_(count_) {
    // More threads than cores need leave; fewer are the arena's own business.
    if (count_ > tbb::info::default_concurrency()) {
      more_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count_));
    }
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }
  std::span<const detail::Tile> tiles() const { return tiles_; }

  template <class Work>
  void run(Work&& work) {
    arena_.execute(work);
  }

  // Calls work(thread, tile) for each tile; threads count from 0.
  template <class Work>
  void each_tile(Work&& work) {
    // A small picture is done before a scheduler is at work.
    if (count_ == 1) {
      for (const detail::Tile& tile : tiles_) work(std::size_t{0}, tile);
      return;
    }
    run([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, tiles_.size(), 1),
          [&](const auto& range) {
            const auto thread = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
            for (std::size_t i = range.begin(); i < range.end(); ++i) work(thread, tiles_[i]);
          },
          tbb::simple_partitioner());
    });
  }

 private:
  std::vector<detail::Tile> tiles_;
  int count_;
  std::optional<tbb::global_control> more_;
  tbb::task_arena arena_;
};

// These threads, each with a renderer of its own.
class Workers {
 public:
  Workers(Threads& threads, const detail::Job& job) : threads_(threads), job_(job), renderers_(threads.count()) {}

  std::size_t tiles() const { return threads_.tiles().size(); }

  // Calls work(renderer, tile) for each tile.
  template <class Work>
  void each_tile(Work&& work) {
    threads_.each_tile([&](std::size_t thread, const detail::Tile& tile) {
      std::unique_ptr<detail::TileRenderer>& renderer = renderers_[thread];
      if (!renderer) renderer = std::make_unique<detail::TileRenderer>(job_);
      work(*renderer, tile);
    });
  }

  RenderReport report() const {
    RenderReport report;
    for (const auto& renderer : renderers_) {
      if (renderer) report += renderer->report();
    }
    return report;
  }

 private:
  Threads& threads_;
  const detail::Job& job_;
  std::vector<std::unique_ptr<detail::TileRenderer>> renderers_;  // null until the thread has a tile
};

// All pixels with one sample, then those again that this is not enough for. Each step ends before the next begins.
void fill_adaptively(Workers& workers, Film& film, const std::function<void(double)>& tell) {
  using detail::Tile;
  using detail::TileRenderer;
  Progress progress(tell, 2 * workers.tiles());
  workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
    renderer.render(tile, film);
    progress.add_one();
  });
  detail::Refinement refinement(film.width(), film.height());
  workers.each_tile([&](TileRenderer&, const Tile& tile) { refinement.choose_contrasts(film, tile); });
  workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
    renderer.refine(tile, refinement, film);
    progress.add_one();
  });
  // What a tile chose in another one that was done by then.
  std::atomic<bool> again = true;
  while (again.exchange(false)) {
    workers.each_tile([&](TileRenderer& renderer, const Tile& tile) {
      if (renderer.refine(tile, refinement, film)) again = true;
    });
  }
}

void fill(Workers& workers, Film& film, const std::function<void(double)>& tell) {
  Progress progress(tell, workers.tiles());
  workers.each_tile([&](detail::TileRenderer& renderer, const detail::Tile& tile) {
    renderer.render(tile, film);
    progress.add_one();
  });
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

Film render(const Scene& scene, const View& view, const RenderOptions& options, RenderReport* report) {
  using Clock = std::chrono::steady_clock;
  check(options);
  const Camera camera(view.camera, options.width, options.height);
  Threads threads(options);
  // What is there before the first ray: memory for the picture, and the code for this machine. Before the cells, which
  // are to be in the cache then.
  Film film(options.width, options.height, content(options.mode));
  detail::shading_code(options.instructions);
  const auto before_cells = Clock::now();
  std::optional<Cells> cells;
  const bool suits_packets =
      options.mode == Mode::shaded ? detail::PacketTracer::suits(scene, view, camera) : camera.rays_are_in_range();
  if (options.engine == Engine::packets && suits_packets) threads.run([&] { cells.emplace(scene); });
  std::optional<LayerCells> layer_cells;
  const bool suits_layers = options.mode == Mode::shaded && LayerCells::suits(scene) && view.settings.max_depth > 0;
  if (options.engine == Engine::packets && suits_layers) threads.run([&] { layer_cells.emplace(scene); });
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
                        .cells = cells ? &*cells : nullptr,
                        .layer_cells = layer_cells ? &*layer_cells : nullptr,
                        .instructions = options.instructions};
  Workers workers(threads, job);
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
