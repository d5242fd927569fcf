// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/caster.h"
#include "shade/camera.h"
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
  int grid;  ///< k of k x k samples a pixel
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
  void draw_edges(const Tile& tile, Film& film);
  void measure(const Tile& tile, Film& film);
  void show_sights(const Tile& tile, Film& film);
  Ray sample_ray(int column, int row) const;  ///< columns and rows of samples: grid times those of pixels
  Rgb edge_pixel(std::size_t first, std::size_t stride);
  bool on_edge(const Sight& here, const Sight& other) const;

  Job job_;
  Caster caster_;
  Tracer tracer_;
  std::uint64_t primary_ = 0;
  IntervalList intervals_;
  std::vector<Sight> sights_;
};

}  // namespace csgcast::detail
