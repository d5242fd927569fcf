// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "raycast/caster.h"
#include "shade/camera.h"
#include "shade/detail/outline.h"
#include "shade/detail/packet_tracer.h"
#include "shade/detail/sight.h"
#include "shade/film.h"
#include "shade/render.h"
#include "shade/tracer.h"

namespace csgcast::detail {

/// A rectangle of pixels [x0, x1) x [y0, y1).
struct Tile {
  int x0, y0, x1, y1;
};

/// What all threads share, read-only.
struct Job {
  const Scene& scene;
  const View& view;
  const Camera& camera;
  Mode mode;
  int grid;            ///< k of k x k samples a pixel
  const Cells* cells;  ///< null: rays go one by one
};

/// The working memory of one thread.
class TileRenderer {
 public:
  explicit TileRenderer(const Job& job);
  TileRenderer(const TileRenderer&) = delete;
  TileRenderer& operator=(const TileRenderer&) = delete;

  /// Fills the tile's pixels. What they get depends on the job alone.
  void render(const Tile& tile, Film& film);

  RenderReport report() const;

 private:
  void shade(const Tile& tile, Film& film);
  void shade_in_packets(const Tile& tile, Film& film);
  void place_samples(const Tile& strip, int first, int last);
  void draw_edges(const Tile& tile, Film& film);
  void measure(const Tile& tile, Film& film);
  void show_sights(const Tile& tile, Film& film);
  Ray sample_ray(int column, int row) const;  ///< columns and rows of samples: grid times those of pixels
  Rgb edge_pixel(std::size_t first, std::size_t stride);
  bool on_edge(const Sight& here, const Sight& other) const;

  Job job_;
  Caster caster_;
  Tracer tracer_;
  std::optional<PacketTracer> packets_;
  Outline outline_;  // of the solid; beyond it packets see the background
  std::uint64_t beyond_bounds_ = 0;
  std::uint64_t primary_ = 0;
  IntervalList intervals_;
  std::vector<Sight> sights_;
  // By sample of a strip of pixels.
  std::vector<double> sample_x_, sample_y_;
  std::vector<std::uint32_t> sample_place_;  // row by row, where its colour belongs
  std::vector<Rgb> traced_, colors_;
};

}  // namespace csgcast::detail
