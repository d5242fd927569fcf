// SPDX-License-Identifier: MIT
#include "shade/trace/detail/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "shade/film/contrast.h"
#include "shade/trace/detail/edges.h"

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

// How many samples are traced at once where pixels are refined: enough to fill packets.
constexpr std::size_t samples_at_once = 2048;

// Whether a channel of the light contrasts somewhere among `count` samples.
bool varies(const Rgb* first, std::size_t count, std::size_t stride) {
  Rgb least = *first;
  Rgb greatest = *first;
  for (std::size_t i = 1; i < count; ++i) {
    const Rgb c = first[i * stride];
    least = {std::min(least.r, c.r), std::min(least.g, c.g), std::min(least.b, c.b)};
    greatest = {std::max(greatest.r, c.r), std::max(greatest.g, c.g), std::max(greatest.b, c.b)};
  }
  const auto contrast = [](double low, double high) { return perceived(high) - perceived(low) > least_contrast; };
  return contrast(least.r, greatest.r) || contrast(least.g, greatest.g) || contrast(least.b, greatest.b);
}

// What varies along a side of a pixel, as where an edge crosses it, goes on beyond that side.
void choose_neighbours(Pixel pixel, const Rgb* colors, int k, Refinement& refinement) {
  const auto count = static_cast<std::size_t>(k);
  const std::size_t end = count - 1;
  if (varies(colors, count, 1)) refinement.choose({pixel.x, pixel.y - 1});
  if (varies(colors + count * end, count, 1)) refinement.choose({pixel.x, pixel.y + 1});
  if (varies(colors, count, count)) refinement.choose({pixel.x - 1, pixel.y});
  if (varies(colors + end, count, count)) refinement.choose({pixel.x + 1, pixel.y});
}

}  // namespace

TileRenderer::TileRenderer(const Job& job)
    : job_(job),
      caster_(job.scene),
      layers_(job.layer_cells != nullptr ? std::make_optional<LayerCaster>(*job.layer_cells, caster_, job.instructions)
                                         : std::nullopt),
      tracer_(caster_, job.view, layers_ ? &*layers_ : nullptr),
      outline_(job.camera.frame(), job.scene.node(job.scene.root()).box) {
  if (job.cells == nullptr) return;
  if (job.mode == Mode::shaded) {
    packets_.emplace(*job.cells, job.view, job.camera, tracer_, job.instructions);
  } else {
    sight_packets_.emplace(*job.cells, job.camera, job.instructions);
  }
}

RenderReport TileRenderer::report() const {
  RenderReport result = tracer_.report();
  if (packets_) result += packets_->report();
  if (sight_packets_) result += sight_packets_->report();
  if (layers_) {
    result.casts += layers_->caster_counts();
    result.packets += layers_->counts();
  }
  result.skipped.primary_beyond_bounds += beyond_bounds_;
  result.rays.primary += primary_;
  result.refined_pixels += refined_;
  result.casts += caster_.counts();
  return result;
}

void TileRenderer::render(const Tile& tile, Film& film) {
  switch (job_.mode) {
    case Mode::shaded:
      return shade(tile, job_.sampling == Sampling::adaptive ? 1 : job_.grid, film);
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

Ray TileRenderer::sample_ray(int column, int row, int k) const {
  return job_.camera.ray((column + k * job_.origin.x + 0.5) / k, (row + k * job_.origin.y + 0.5) / k);
}

// Appends the samples of a rectangle of them; place(column, row) says where what they see belongs.
template <class Place>
void TileRenderer::add_samples(const Tile& rectangle, int k, Place&& place) {
  const int x = k * job_.origin.x;
  const int y = k * job_.origin.y;
  append({rectangle.x0 + x, rectangle.y0 + y, rectangle.x1 + x, rectangle.y1 + y}, k, samples_,
         [&](int column, int row) { return place(column - x, row - y); });
}

void TileRenderer::shade(const Tile& tile, int k, Film& film) {
  if (packets_) return shade_in_packets(tile, k, film);
  each_pixel(tile, [&](int x, int y) {
    Rgb sum;
    for (int i = 0; i < k * k; ++i) sum = sum + tracer_.trace(sample_ray(k * x + i % k, k * y + i / k, k));
    film.set(x, y, (1.0 / (k * k)) * sum);
  });
}

void TileRenderer::shade_in_packets(const Tile& tile, int k, Film& film) {
  const int height = std::max(8 / k, 1);
  const double share = 1.0 / (k * k);
  Rgb empty;  // a pixel of background: the average, rounded like any other
  for (int i = 0; i < k * k; ++i) empty = empty + job_.view.background;
  empty = share * empty;
  for (int y0 = tile.y0; y0 < tile.y1; y0 += height) {
    const Tile strip{tile.x0, y0, tile.x1, std::min(y0 + height, tile.y1)};
    const int columns = k * (strip.x1 - strip.x0);
    const int rows = k * (strip.y1 - strip.y0);
    const Outline::Columns seen = outline_.columns(strip.y0 + job_.origin.y, strip.y1 + job_.origin.y);
    const int film_x = strip.x0 + job_.origin.x;
    const auto column = [&](double x) { return static_cast<int>(std::clamp<double>(k * (x - film_x), 0, columns)); };
    // Beyond the outline there is the background: of one colour, unless it is a picture.
    const bool is_even = job_.view.environment == nullptr;
    const int first = is_even ? column(std::floor(seen.first)) : 0;
    const int last = is_even ? std::max(first, column(std::ceil(seen.last))) : columns;
    beyond_bounds_ += static_cast<std::uint64_t>(rows * (columns - (last - first)));
    const auto in_a_row = static_cast<std::size_t>(strip.x1 - strip.x0);
    if (first == last) {
      colors_.assign(in_a_row, empty);
      for (int y = strip.y0; y < strip.y1; ++y) film.set(strip.x0, y, colors_);
      continue;
    }
    const int left = k * strip.x0;
    const int top = k * strip.y0;
    samples_.clear();
    add_samples({left + first, top, left + last, top + rows}, k,
                [&](int x, int y) { return (y - top) * columns + (x - left); });
    colors_.resize(static_cast<std::size_t>(columns * rows));
    if (last - first < columns) std::fill(colors_.begin(), colors_.end(), job_.view.background);
    packets_->trace(samples_, colors_);
    if (k == 1) {
      std::span<const Rgb> rest = colors_;
      for (int y = strip.y0; y < strip.y1; ++y, rest = rest.subspan(in_a_row)) {
        film.set(strip.x0, y, rest.first(in_a_row));
      }
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

bool TileRenderer::refine(const Tile& tile, Refinement& refinement, Film& film) {
  const int k = job_.grid;
  const double share = 1.0 / (k * k);
  const auto samples = static_cast<std::size_t>(k * k);
  const std::size_t at_once = std::max<std::size_t>(samples_at_once / samples, 1);
  bool any = false;
  while (refinement.take(tile, pixels_)) {
    any = true;
    refined_ += pixels_.size();
    for (std::size_t first = 0; first < pixels_.size(); first += at_once) {
      const std::span<const Pixel> pixels =
          std::span(pixels_).subspan(first, std::min(at_once, pixels_.size() - first));
      trace_all_samples(pixels);
      const Rgb* colors = colors_.data();
      for (const Pixel pixel : pixels) {
        Rgb sum;
        for (std::size_t i = 0; i < samples; ++i) sum = sum + colors[i];
        film.set(pixel.x, pixel.y, share * sum);
        choose_neighbours(pixel, colors, k, refinement);
        colors += samples;
      }
    }
  }
  return any;
}

// Leaves k x k colours for each pixel, row by row.
void TileRenderer::trace_all_samples(std::span<const Pixel> pixels) {
  const int k = job_.grid;
  colors_.resize(pixels.size() * static_cast<std::size_t>(k * k));
  if (packets_) {
    place_all_samples(pixels);
    packets_->trace(samples_, colors_);
    return;
  }
  Rgb* color = colors_.data();
  for (const Pixel pixel : pixels)
    for (int i = 0; i < k * k; ++i) *color++ = tracer_.trace(sample_ray(k * pixel.x + i % k, k * pixel.y + i / k, k));
}

// Pixels next to each other in a row make one rectangle of samples.
void TileRenderer::place_all_samples(std::span<const Pixel> pixels) {
  const int k = job_.grid;
  samples_.clear();
  for (std::size_t first = 0, last = 0; first < pixels.size(); first = last) {
    const int y = pixels[first].y;
    for (last = first + 1; last < pixels.size() && pixels[last].y == y && pixels[last].x == pixels[last - 1].x + 1;)
      ++last;
    const int left = k * pixels[first].x;
    const Tile rectangle{left, k * y, left + k * static_cast<int>(last - first), k * y + k};
    add_samples(rectangle, k, [&](int column, int row) {
      const int pixel = static_cast<int>(first) + (column - left) / k;
      return (pixel * k + row - k * y) * k + (column - left) % k;
    });
  }
}

void TileRenderer::look_along_sides(std::span<const PixelSide> sides, std::vector<bool>& varies_along) {
  const int k = job_.grid;
  const auto samples = static_cast<std::size_t>(k);
  const std::size_t at_once = std::max<std::size_t>(samples_at_once / samples, 1);
  varies_along.clear();
  for (std::size_t first = 0; first < sides.size(); first += at_once) {
    const std::span<const PixelSide> some = sides.subspan(first, std::min(at_once, sides.size() - first));
    colors_.resize(some.size() * samples);
    samples_.clear();
    Rgb* color = colors_.data();
    for (std::size_t i = 0; i < some.size(); ++i) {
      const auto [pixel, neighbour] = some[i];
      const int left = k * pixel.x + (neighbour.x > pixel.x ? k - 1 : 0);
      const int top = k * pixel.y + (neighbour.y > pixel.y ? k - 1 : 0);
      const bool is_row = neighbour.y != pixel.y;
      const Tile line{left, top, is_row ? left + k : left + 1, is_row ? top + 1 : top + k};
      const int start = static_cast<int>(i) * k;
      if (packets_) {
        add_samples(line, k, [&](int column, int row) { return start + (column - left) + (row - top); });
      } else {
        each_pixel(line, [&](int column, int row) { *color++ = tracer_.trace(sample_ray(column, row, k)); });
      }
    }
    if (packets_) packets_->trace(samples_, colors_);
    for (std::size_t i = 0; i < some.size(); ++i)
      varies_along.push_back(varies(colors_.data() + i * samples, samples, 1));
  }
}

bool TileRenderer::contrasts(Pixel pixel) {
  // Where the picture ends, its border goes on.
  const auto within = [](int place, int origin, int size) { return std::clamp(place + origin, 0, size - 1) - origin; };
  Film centers(3, 3, FilmContent::color);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int column = within(pixel.x + x - 1, job_.origin.x, job_.width);
      const int row = within(pixel.y + y - 1, job_.origin.y, job_.height);
      centers.set(x, y, tracer_.trace(sample_ray(column, row, 1)));
    }
  }
  Refinement alone(3, 3);
  alone.choose_contrasts(centers, {1, 1, 2, 2});
  return alone.is_chosen({1, 1});
}

void TileRenderer::measure(const Tile& tile, Film& film) {
  const int k = job_.grid;
  const auto samples = static_cast<std::size_t>(k * k);
  const int columns = k * (tile.x1 - tile.x0);
  // A row of pixels at a time: there may be many samples.
  lengths_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(k));
  for (int y = tile.y0; y < tile.y1; ++y) {
    const Tile rectangle{k * tile.x0, k * y, k * tile.x1, k * y + k};
    const auto place = [&](int column, int row) {  // pixel by pixel
      const int across = column - rectangle.x0;
      return (across / k * k + row - rectangle.y0) * k + across % k;
    };
    if (sight_packets_) {
      samples_.clear();
      add_samples(rectangle, k, place);
      sight_packets_->measure(samples_, lengths_);
    } else {
      each_pixel(rectangle, [&](int column, int row) {
        const Ray ray = sample_ray(column, row, k);
        lengths_[static_cast<std::size_t>(place(column, row))] = length_inside(caster_, ray, intervals_);
        ++primary_;
      });
    }
    const double* length = lengths_.data();
    for (int x = tile.x0; x < tile.x1; ++x, length += samples) {
      const double sum = std::accumulate(length, length + samples, 0.0);
      film.value(x, y) = static_cast<float>(sum / static_cast<double>(samples));
    }
  }
}

// What all samples of a rectangle of them see, row by row.
void TileRenderer::see(const Tile& rectangle, int k) {
  const int columns = rectangle.x1 - rectangle.x0;
  const int rows = rectangle.y1 - rectangle.y0;
  sights_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (sight_packets_) {
    samples_.clear();
    add_samples(rectangle, k,
                [&](int column, int row) { return (row - rectangle.y0) * columns + (column - rectangle.x0); });
    sight_packets_->look(samples_, sights_);
    return;
  }
  Sight* sight = sights_.data();
  each_pixel(rectangle, [&](int column, int row) { *sight++ = look_along(caster_, sample_ray(column, row, k)); });
  primary_ += sights_.size();
}

void TileRenderer::show_sights(const Tile& tile, Film& film) {
  see(tile, 1);
  const Sight* next = sights_.data();
  each_pixel(tile, [&](int x, int y) {
    const Sight& sight = *next++;
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
  see({k * tile.x0, k * tile.y0, k * (tile.x1 + 1), k * (tile.y1 + 1)}, k);
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
