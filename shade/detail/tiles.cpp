// SPDX-License-Identifier: MIT
#include "shade/detail/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shade/detail/edges.h"

namespace csgcast::detail {
namespace {

constexpr Rgb ink{0.01, 0.01, 0.02};

// Calls f(x, y) for each pixel.
template <class F>
void each_pixel(const Tile& tile, F&& f) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) f(x, y);
  }
}

}  // namespace

TileRenderer::TileRenderer(const Job& job)
    : job_(job),
      caster_(job.scene),
      tracer_(caster_, job.view),
      outline_(job.camera.frame(), job.scene.node(job.scene.root()).box) {
  if (job.cells != nullptr) packets_.emplace(*job.cells, job.view, job.camera, tracer_);
}

RenderReport TileRenderer::report() const {
  RenderReport result = tracer_.report();
  if (packets_) result += packets_->report();
  result.skipped.primary_beyond_bounds += beyond_bounds_;
  result.rays.primary += primary_;
  result.casts += caster_.counts();
  return result;
}

void TileRenderer::render(const Tile& tile, Film& film) {
  switch (job_.mode) {
    case Mode::shaded:
      return shade(tile, film);
    case Mode::edges:
      return draw_edges(tile, film);
    case Mode::xray:
      return measure(tile, film);
    case Mode::depth:
    case Mode::normal:
    case Mode::id:
      return show_sights(tile, film);
  }
}

Ray TileRenderer::sample_ray(int column, int row) const {
  return job_.camera.ray((column + 0.5) / job_.grid, (row + 0.5) / job_.grid);
}

void TileRenderer::shade(const Tile& tile, Film& film) {
  if (packets_) return shade_in_packets(tile, film);
  const int k = job_.grid;
  each_pixel(tile, [&](int x, int y) {
    Rgb sum;
    for (int i = 0; i < k * k; ++i) sum = sum + tracer_.trace(sample_ray(k * x + i % k, k * y + i / k));
    film.set(x, y, (1.0 / (k * k)) * sum);
  });
}

// The samples of a strip in columns [first, last), four by two at a time, so that those of a packet are neighbours.
void TileRenderer::place_samples(const Tile& strip, int first, int last) {
  const int k = job_.grid;
  const int columns = k * (strip.x1 - strip.x0);
  const int rows = k * (strip.y1 - strip.y0);
  const auto room = static_cast<std::size_t>(columns * rows);
  sample_x_.resize(room);
  sample_y_.resize(room);
  sample_place_.resize(room);
  std::size_t count = 0;
  for (int row = 0; row < rows; row += 2) {
    for (int column = first; column < last; column += 4) {
      for (int y = row; y < std::min(row + 2, rows); ++y) {
        for (int x = column; x < std::min(column + 4, last); ++x) {
          sample_x_[count] = (k * strip.x0 + x + 0.5) / k;
          sample_y_[count] = (k * strip.y0 + y + 0.5) / k;
          sample_place_[count++] = static_cast<std::uint32_t>(y * columns + x);
        }
      }
    }
  }
  sample_x_.resize(count);
  sample_y_.resize(count);
}

void TileRenderer::shade_in_packets(const Tile& tile, Film& film) {
  const int k = job_.grid;
  const int height = std::max(8 / k, 1);
  const double share = 1.0 / (k * k);
  Rgb empty;  // a pixel of background: the average, rounded like any other
  for (int i = 0; i < k * k; ++i) empty = empty + job_.view.background;
  empty = share * empty;
  for (int y0 = tile.y0; y0 < tile.y1; y0 += height) {
    const Tile strip{tile.x0, y0, tile.x1, std::min(y0 + height, tile.y1)};
    const int columns = k * (strip.x1 - strip.x0);
    const int rows = k * (strip.y1 - strip.y0);
    const Outline::Columns seen = outline_.columns(strip.y0, strip.y1);
    const auto column = [&](double x) { return static_cast<int>(std::clamp<double>(k * (x - strip.x0), 0, columns)); };
    const int first = column(std::floor(seen.first));
    const int last = std::max(first, column(std::ceil(seen.last)));
    beyond_bounds_ += static_cast<std::uint64_t>(rows * (columns - (last - first)));
    if (first == last) {
      each_pixel(strip, [&](int x, int y) { film.set(x, y, empty); });
      continue;
    }
    place_samples(strip, first, last);
    traced_.resize(sample_x_.size());
    packets_->trace(sample_x_, sample_y_, traced_);
    colors_.assign(static_cast<std::size_t>(columns * rows), job_.view.background);
    for (std::size_t i = 0; i < traced_.size(); ++i) colors_[sample_place_[i]] = traced_[i];
    if (k == 1) {
      const Rgb* color = colors_.data();
      each_pixel(strip, [&](int x, int y) { film.set(x, y, *color++); });
      continue;
    }
    each_pixel(strip, [&](int x, int y) {
      Rgb sum;
      for (int j = k * (y - strip.y0); j < k * (y - strip.y0 + 1); ++j) {
        const auto at = static_cast<std::size_t>(j * columns + k * (x - strip.x0));
        for (int i = 0; i < k; ++i) sum = sum + colors_[at + static_cast<std::size_t>(i)];
      }
      film.set(x, y, share * sum);
    });
  }
}

void TileRenderer::measure(const Tile& tile, Film& film) {
  const int k = job_.grid;
  each_pixel(tile, [&](int x, int y) {
    double sum = 0;
    for (int i = 0; i < k * k; ++i) {
      sum += length_inside(caster_, sample_ray(k * x + i % k, k * y + i / k), intervals_);
      ++primary_;
    }
    film.value(x, y) = static_cast<float>(sum / (k * k));
  });
}

void TileRenderer::show_sights(const Tile& tile, Film& film) {
  each_pixel(tile, [&](int x, int y) {
    const Sight sight = look_along(caster_, job_.camera.ray(x + 0.5, y + 0.5));
    ++primary_;
    const bool something = sight.leaf.valid();
    if (job_.mode == Mode::depth) {
      film.value(x, y) = something ? static_cast<float>(sight.t) : std::numeric_limits<float>::infinity();
    } else if (job_.mode == Mode::id) {
      film.value(x, y) = something ? static_cast<float>(sight.leaf.index()) : -1;
    } else if (something) {
      const Vector n = sight.normal;
      film.set(x, y, {0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y, 0.5 + 0.5 * n.z});
    }
  });
}

// Every sample is compared with those one pixel further right and down, so lines are a pixel wide at any number of
// samples. The tile's samples and one more pixel of them at the right and below are seen first.
void TileRenderer::draw_edges(const Tile& tile, Film& film) {
  const int k = job_.grid;
  const int columns = k * (tile.x1 - tile.x0 + 1);
  const int rows = k * (tile.y1 - tile.y0 + 1);
  sights_.clear();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      sights_.push_back(look_along(caster_, sample_ray(k * tile.x0 + column, k * tile.y0 + row)));
    }
  }
  primary_ += sights_.size();
  const std::size_t stride = static_cast<std::size_t>(columns);
  each_pixel(tile, [&](int x, int y) {
    const std::size_t first =
        static_cast<std::size_t>(k * (y - tile.y0)) * stride + static_cast<std::size_t>(k * (x - tile.x0));
    film.set(x, y, edge_pixel(first, stride));
  });
}

Rgb TileRenderer::edge_pixel(std::size_t first, std::size_t stride) {
  const std::size_t k = static_cast<std::size_t>(job_.grid);
  Rgb sum;
  for (std::size_t j = 0; j < k; ++j) {
    for (std::size_t i = 0; i < k; ++i) {
      const std::size_t at = first + j * stride + i;
      const Sight& here = sights_[at];
      const bool edge = on_edge(here, sights_[at + k]) || on_edge(here, sights_[at + k * stride]);
      const Rgb color = here.leaf.valid() ? job_.scene.look(here.look).color : Rgb{};
      sum = sum + (edge ? ink : paper(here, color));
    }
  }
  return (1.0 / static_cast<double>(k * k)) * sum;
}

bool TileRenderer::on_edge(const Sight& here, const Sight& other) const {
  return is_edge(here, other, job_.camera.footprint(std::min(here.t, other.t)));
}

}  // namespace csgcast::detail
