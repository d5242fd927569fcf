// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/ray/caster.h"
#include "shade/film/camera.h"
#include "shade/film/film.h"
#include "shade/film/outline.h"
#include "shade/film/refinement.h"
#include "shade/film/samples.h"
#include "shade/film/tile.h"
#include "shade/trace/detail/packet_sights.h"
#include "shade/trace/detail/packet_tracer.h"
#include "shade/trace/detail/sight.h"
#include "shade/trace/render.h"
#include "shade/trace/tracer.h"

namespace csgcast::detail {

/// What all threads share, read-only.
struct Job {
  const Scene& scene;
  const View& view;
  const Camera& camera;
  Mode mode;
  int width, height;  ///< of the whole picture
  Pixel origin;       ///< the pixel of the picture where the film begins
  int grid;           ///< k of k x k samples a pixel
  Sampling sampling;
  const Cells* cells;             ///< null: rays go one by one
  const LayerCells* layer_cells;  ///< of scenes that transmit; null: without cells
  std::string_view instructions;
};

/// A row or column of the samples of a pixel, along the pixel next to it.
struct PixelSide {
  Pixel pixel;      ///< maybe beyond the film
  Pixel neighbour;  ///< left, right, above or below
};

/// The working memory of one thread. Tiles, and pixels without another word, are those of the film.
class TileRenderer {
 public:
  explicit TileRenderer(const Job& job);
  TileRenderer(const TileRenderer&) = delete;
  TileRenderer& operator=(const TileRenderer&) = delete;

  /// Fills the tile's pixels, if samples are adaptive with what their centres see. What they get depends on the job
  /// alone.
  void render(const Tile& tile, Film& film);

  /// Gives all their samples to the tile's pixels that are chosen, and chooses those that what varies in them reaches
  /// into; these get theirs, too, if they are in the tile. Whether there were any.
  bool refine(const Tile& tile, Refinement& refinement, Film& film);

  /// Whether something varies along each of these sides: reaches into the neighbours of pixels that get all samples.
  void look_along_sides(std::span<const PixelSide> sides, std::vector<bool>& varies);

  /// What the pixel and the 8 around it see by one sample each; it chooses itself by that, or not.
  bool contrasts(Pixel pixel);

  RenderReport report() const;

 private:
  void shade(const Tile& tile, int k, Film& film);
  void shade_in_packets(const Tile& tile, int k, Film& film);
  void trace_all_samples(std::span<const Pixel> pixels);
  void place_all_samples(std::span<const Pixel> pixels);
  void see(const Tile& rectangle, int k);
  void draw_edges(const Tile& tile, Film& film);
  void measure(const Tile& tile, Film& film);
  void show_sights(const Tile& tile, Film& film);
  template <class Place>
  void add_samples(const Tile& rectangle, int k, Place&& place);
  Ray sample_ray(int column, int row, int k) const;  ///< columns and rows of samples: k times those of pixels
  Rgb edge_pixel(std::size_t first, std::size_t stride);
  bool on_edge(const Sight& here, const Sight& other) const;

  Job job_;
  Caster caster_;
  std::optional<LayerCaster> layers_;
  Tracer tracer_;
  std::optional<PacketTracer> packets_;        // of shaded pictures
  std::optional<PacketSights> sight_packets_;  // of others
  Outline outline_;                            // of the solid; beyond it packets see the background
  std::uint64_t beyond_bounds_ = 0;
  std::uint64_t primary_ = 0;
  std::uint64_t refined_ = 0;
  IntervalList intervals_;
  std::vector<Sight> sights_;    // by place
  std::vector<double> lengths_;  // by place
  std::vector<Pixel> pixels_;
  Samples samples_;
  std::vector<Rgb> colors_;  // by place
};

}  // namespace csgcast::detail
