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
#include "shade/trace/detail/surroundings.h"
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
  if (options.region) {
    const PixelRegion& r = *options.region;
    if (r.x0 < 0 || r.y0 < 0 || r.x1 > options.width || r.y1 > options.height || r.width() < 1 || r.height() < 1) {
      throw Error(ErrorCode::usage, {},
                  fmt::format("the region {},{} to {},{} of a picture of {}", r.x0, r.y0, r.x1, r.y1, size),
                  "it is empty or not within the picture",
                  "give columns and rows that are, the last ones not included");
    }
  }
  PacketCaster::check_instructions(options.instructions);
}

namespace {

using Tiles = std::vector<detail::Tile>;

Tiles tiles_of(const detail::Tile& area) {
  Tiles tiles;
  constexpr int side = detail::tile_side;
  for (int y = area.y0; y < area.y1; y += side) {
    for (int x = area.x0; x < area.x1; x += side) {
      tiles.push_back({x, y, std::min(x + side, area.x1), std::min(y + side, area.y1)});
    }
  }
  return tiles;
}

// What is asked for of a picture, and what a film has to hold for that.
struct Canvas {
  PixelRegion film;    // in the picture
  detail::Tile asked;  // in the film

  Canvas(const RenderOptions& options, Sampling sampling)
      : film(options.region.value_or(PixelRegion{0, 0, options.width, options.height})) {
    const PixelRegion region = film;
    if (sampling == Sampling::adaptive) {  // contrasts are those with the pixels around
      film = {std::max(film.x0 - 1, 0), std::max(film.y0 - 1, 0), std::min(film.x1 + 1, options.width),
              std::min(film.y1 + 1, options.height)};
    }
    asked = {region.x0 - film.x0, region.y0 - film.y0, region.x1 - film.x0, region.y1 - film.y0};
  }

  Film cut(Film whole) const {
    const int width = asked.x1 - asked.x0;
    const int height = asked.y1 - asked.y0;
    if (width == whole.width() && height == whole.height()) return whole;
    Film part(width, height, whole.content());
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (int c = 0; c < channels(whole.content()); ++c)
          part.value(x, y, c) = whole.value(x + asked.x0, y + asked.y0, c);
      }
    }
    return part;
  }
};

// Of the whole process, all threads.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The threads of a picture's tiles, each with a renderer of its own.
class Workers {
 public:
  explicit Workers(const detail::Job& job) : job_(job) {}

  // Calls work(renderer, tile) for each tile.
  template <class Work>
  void each_tile(const Tiles& tiles, Work&& work) {
    // A small picture is done before a scheduler is at work.
    if (tiles.size() == 1 || thread_count() == 1) {
      for (const detail::Tile& tile : tiles) work(renderer(), tile);
      return;
    }
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tiles.size(), 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) work(renderer(), tiles[i]);
        },
        tbb::simple_partitioner());
  }

  // The calling thread's.
  detail::TileRenderer& renderer() {
    std::unique_ptr<detail::TileRenderer>& own = renderers_.local();
    if (!own) own = std::make_unique<detail::TileRenderer>(job_);
    return *own;
  }

  RenderReport report() const {
    RenderReport report;
    for (const auto& renderer : renderers_) report += renderer->report();
    return report;
  }

 private:
  const detail::Job& job_;
  tbb::enumerable_thread_specific<std::unique_ptr<detail::TileRenderer>> renderers_;
};

// Chooses the pixels of the tile that the picture around it reaches. Whether there were any. The sides of the pixels
// around are looked along by all threads; what is farther away is rare.
bool choose_from_beyond(Workers& workers, const detail::Surroundings& surroundings, detail::Refinement& refinement) {
  using detail::PixelSide;
  const std::vector<PixelSide> sides = surroundings.open_sides(refinement);
  constexpr std::size_t at_once = 512;
  std::vector<std::vector<PixelSide>> varying((sides.size() + at_once - 1) / at_once);
  tbb::parallel_for(std::size_t{0}, varying.size(), [&](std::size_t i) {
    const auto some = std::span(sides).subspan(i * at_once, std::min(at_once, sides.size() - i * at_once));
    std::vector<bool> varies;
    workers.renderer().look_along_sides(some, varies);
    for (std::size_t j = 0; j < some.size(); ++j) {
      if (varies[j]) varying[i].push_back(some[j]);
    }
  });
  std::vector<PixelSide> reaching;
  for (const auto& some : varying) reaching.insert(reaching.end(), some.begin(), some.end());
  return !reaching.empty() && surroundings.choose(reaching, workers.renderer(), refinement);
}

// All pixels with one sample, then those again that this is not enough for. Each step ends before the next begins.
void fill_adaptively(Workers& workers, const detail::Job& job, const Canvas& canvas, Film& film,
                     const ProgressCallback& callback) {
  using detail::Tile;
  using detail::TileRenderer;
  const Tiles tiles = tiles_of(canvas.asked);
  const Tiles with_border = tiles_of({0, 0, film.width(), film.height()});
  ProgressTeller progress(callback, with_border.size() + tiles.size());
  workers.each_tile(with_border, [&](TileRenderer& renderer, const Tile& tile) {
    renderer.render(tile, film);
    progress.step();
  });
  detail::Refinement refinement(film.width(), film.height());
  workers.each_tile(tiles, [&](TileRenderer&, const Tile& tile) { refinement.choose_contrasts(film, tile); });
  workers.each_tile(tiles, [&](TileRenderer& renderer, const Tile& tile) {
    renderer.refine(tile, refinement, film);
    progress.step();
  });
  const detail::Surroundings surroundings(job, canvas.asked);
  do {
    // What a tile chose in another one that was done by then.
    std::atomic<bool> again = true;
    while (again.exchange(false)) {
      workers.each_tile(tiles, [&](TileRenderer& renderer, const Tile& tile) {
        if (renderer.refine(tile, refinement, film)) again = true;
      });
    }
  } while (choose_from_beyond(workers, surroundings, refinement));
  progress.finish();
}

void fill(Workers& workers, const Canvas& canvas, Film& film, const ProgressCallback& callback) {
  const Tiles tiles = tiles_of(canvas.asked);
  ProgressTeller progress(callback, tiles.size());
  workers.each_tile(tiles, [&](detail::TileRenderer& renderer, const detail::Tile& tile) {
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
  const int k = grid(options);
  const Sampling sampling = k > 1 ? options.sampling : Sampling::regular;
  const Canvas canvas(options, sampling);
  Film film(canvas.film.width(), canvas.film.height(), content(options.mode));
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
  const detail::Job job{.scene = scene,
                        .view = view,
                        .camera = camera,
                        .mode = options.mode,
                        .width = options.width,
                        .height = options.height,
                        .origin = {canvas.film.x0, canvas.film.y0},
                        .grid = k,
                        .sampling = sampling,
                        .cells = cells,
                        .layer_cells = layer_cells,
                        .instructions = options.instructions};
  Workers workers(job);
  const bool adaptive = sampling == Sampling::adaptive;
  if (adaptive) {
    fill_adaptively(workers, job, canvas, film, options.progress);
  } else {
    fill(workers, canvas, film, options.progress);
  }
  if (report != nullptr) {
    RenderReport cost = workers.report();
    const auto pixels = static_cast<std::uint64_t>(film.width()) * static_cast<std::uint64_t>(film.height());
    if (adaptive) {
      cost.skipped.primary_like_neighbours = (pixels - cost.refined_pixels) * static_cast<unsigned>(k * k - 1);
    }
    cost.cells_seconds = std::chrono::duration<double>(start - before_cells).count();
    cost.cpu_seconds = cpu_seconds() - cpu_start;
    cost.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    *report += cost;
  }
  return canvas.cut(std::move(film));
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

bool takes_samples(Mode mode) { return mode == Mode::shaded || mode == Mode::edges || mode == Mode::xray; }

int grid(const RenderOptions& options) {
  int k = 1;
  while (takes_samples(options.mode) && k * k < options.samples) ++k;
  return k;
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
