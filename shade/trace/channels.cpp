// SPDX-License-Identifier: MIT
#include "shade/trace/channels.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "csg/base/error.h"
#include "csg/base/precondition.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/packets/threads.h"
#include "shade/film/camera.h"
#include "shade/film/samples.h"
#include "shade/trace/detail/packet_sights.h"
#include "shade/trace/detail/sight.h"

namespace csgcast {
namespace {

using detail::Sight;

FilmContent content_of(Channel channel) {
  switch (channel) {
    case Channel::depth:
      return FilmContent::depth;
    case Channel::normal:
    case Channel::position:
      return FilmContent::position;
    case Channel::id:
    case Channel::part:
    case Channel::leaf:
      break;
  }
  return FilmContent::id;
}

float number_of(bool is_valid, std::uint32_t index) { return is_valid ? static_cast<float>(index) : -1; }

void show(Channel channel, const Sight& sight, Film& film, int x, int y) {
  const bool sees = sight.leaf.valid();
  constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
  switch (channel) {
    case Channel::depth:
      film.value(x, y) = sees ? static_cast<float>(sight.t) : std::numeric_limits<float>::infinity();
      break;
    case Channel::normal:
      for (int c = 0; c < 3; ++c) film.value(x, y, c) = sees ? static_cast<float>(sight.normal[std::size_t(c)]) : 0;
      break;
    case Channel::position:
      for (int c = 0; c < 3; ++c)
        film.value(x, y, c) = sees ? static_cast<float>(sight.point[std::size_t(c)]) : nothing;
      break;
    case Channel::id:
      film.value(x, y) = number_of(sees, sight.surface.index());
      break;
    case Channel::part:
      film.value(x, y) = number_of(sees && sight.part.valid(), sight.part.index());
      break;
    case Channel::leaf:
      film.value(x, y) = number_of(sees, sight.leaf.index());
      break;
  }
}

/// What the rays of whole rows of pixels see, on one thread.
class RowSights {
 public:
  RowSights(const Scene& scene, const Cells* cells, const Camera& camera, const RenderOptions& options)
      : camera_(camera), width_(options.width), caster_(scene) {
    if (cells != nullptr) packets_.emplace(*cells, camera, options.instructions);
  }

  std::span<const Sight> look(int y) {
    const auto count = static_cast<std::size_t>(width_);
    sights_.assign(count, {});
    if (!packets_) {
      for (int x = 0; x < width_; ++x)
        sights_[static_cast<std::size_t>(x)] = detail::look_along(caster_, camera_.ray(x + 0.5, y + 0.5));
      return sights_;
    }
    samples_.clear();
    append({0, y, width_, y + 1}, 1, samples_, [](int x, int) { return x; });
    packets_->look(samples_, sights_);
    return sights_;
  }

 private:
  const Camera& camera_;
  int width_;
  Caster caster_;
  std::optional<detail::PacketSights> packets_;
  detail::Samples samples_;
  std::vector<Sight> sights_;
};

/// Calls work(worker, y) for each row, on the present threads.
template <class MakeWorker, class Work>
void each_row(int height, const ProgressCallback& callback, MakeWorker&& make_worker, Work&& work) {
  tbb::enumerable_thread_specific<std::invoke_result_t<MakeWorker&>> workers(make_worker);
  ProgressTeller progress(callback, static_cast<std::size_t>(height));
  tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      work(workers.local(), y);
      progress.step();
    }
  });
  progress.finish();
}

/// The cells of packets: those kept, else new ones in `own`. Null where rays are cast one by one.
const Cells* cells_for(const Scene& scene, const Camera& camera, const RenderOptions& options, const KeptCells& kept,
                       std::optional<Cells>& own) {
  if (options.engine != Engine::packets || !camera.rays_are_in_range()) return nullptr;
  return kept.cells != nullptr ? kept.cells : &own.emplace(scene);
}

/// Whether each of a row's samples meets the solid.
class RowHits {
 public:
  RowHits(const Scene& scene, const Cells* cells, const RenderOptions& options) : caster_(scene) {
    if (cells != nullptr) packets_.emplace(*cells, PacketCaster::Width::packet, options.instructions);
  }

  /// Of the rays that stand in `rays`.
  std::span<const std::uint8_t> look() {
    hits_.resize(rays.size());
    if (!packets_) {
      for (std::size_t i = 0; i < rays.size(); ++i) {
        caster_.begin(rays[i]);
        hits_[i] = caster_.first_hit() ? 1 : 0;
      }
      return hits_;
    }
    found_.resize(rays.size());
    packets_->first_hits(rays, found_, Rounding::close);
    std::transform(found_.begin(), found_.end(), hits_.begin(),
                   [](const std::optional<Hit>& hit) { return static_cast<std::uint8_t>(hit ? 1 : 0); });
    return hits_;
  }

  std::vector<Ray> rays;

 private:
  Caster caster_;
  std::optional<PacketCaster> packets_;
  std::vector<std::optional<Hit>> found_;
  std::vector<std::uint8_t> hits_;
};

Film with_alpha(const Scene& scene, const View& view, const Camera& camera, const Cells* cells,
                const RenderOptions& options, const Film& film, const ProgressCallback& progress) {
  const int k = grid(options);
  const double share = 1.0 / (k * k);
  Film result(film.width(), film.height(), FilmContent::color_alpha);
  const auto row = [&](RowHits& worker, int y) {
    worker.rays.clear();
    for (int x = 0; x < film.width(); ++x) {
      for (int i = 0; i < k * k; ++i)
        worker.rays.push_back(camera.ray((k * x + i % k + 0.5) / k, (k * y + i / k + 0.5) / k));
    }
    const std::span<const std::uint8_t> hits = worker.look();
    for (int x = 0; x < film.width(); ++x) {
      int count = 0;
      Rgb beyond;
      for (int i = 0; i < k * k; ++i) {
        const auto at = static_cast<std::size_t>(x) * static_cast<std::size_t>(k * k) + static_cast<std::size_t>(i);
        count += hits[at];
        if (hits[at] == 0) beyond = beyond + view.sky(worker.rays[at].direction());
      }
      const Rgb all = film.rgb(x, y);
      const Rgb own = count == 0 ? Rgb{} : all + -share * beyond;
      const Rgb color{std::max(own.r, 0.0), std::max(own.g, 0.0), std::max(own.b, 0.0)};
      result.value(x, y, 0) = static_cast<float>(color.r);
      result.value(x, y, 1) = static_cast<float>(color.g);
      result.value(x, y, 2) = static_cast<float>(color.b);
      result.value(x, y, 3) = static_cast<float>(view.settings.max_depth > 0 ? share * count : 0);
    }
  };
  each_row(
      film.height(), progress, [&] { return RowHits(scene, cells, options); }, row);
  return result;
}

}  // namespace

std::vector<std::string> names_in_file(Channel channel) {
  switch (channel) {
    case Channel::depth:
      return {"Z"};
    case Channel::normal:
      return {"N.X", "N.Y", "N.Z"};
    case Channel::position:
      return {"P.X", "P.Y", "P.Z"};
    case Channel::id:
      return {"id"};
    case Channel::part:
      return {"part"};
    case Channel::leaf:
      break;
  }
  return {"leaf"};
}

std::vector<Film> channel_films(const Scene& scene, const View& view, const RenderOptions& options,
                                std::span<const Channel> channels, const KeptCells& kept) {
  CSGCAST_PRECONDITION(kept.cells == nullptr || &kept.cells->scene() == &scene);
  check(options);
  std::vector<Film> films;
  for (const Channel channel : channels) films.emplace_back(options.width, options.height, content_of(channel));
  on_threads(options.threads, [&] {
    const Camera camera(view.camera, options.width, options.height);
    std::optional<Cells> own;
    const Cells* cells = cells_for(scene, camera, options, kept, own);
    each_row(
        options.height, options.progress, [&] { return RowSights(scene, cells, camera, options); },
        [&](RowSights& worker, int y) {
          const std::span<const Sight> sights = worker.look(y);
          for (int x = 0; x < options.width; ++x) {
            for (std::size_t i = 0; i < channels.size(); ++i)
              show(channels[i], sights[static_cast<std::size_t>(x)], films[i], x, y);
          }
        });
  });
  return films;
}

Film render_with_alpha(const Scene& scene, const View& view, const RenderOptions& options, RenderReport* report,
                       const KeptCells& kept) {
  CSGCAST_PRECONDITION(kept.cells == nullptr || &kept.cells->scene() == &scene);
  if (options.mode != Mode::shaded || options.sampling != Sampling::regular) {
    throw Error(ErrorCode::usage, {}, "alpha in a picture of another mode than shaded, or of adaptive samples",
                "it is the share of a pixel's rays that meet the solid", "take regular samples, or leave alpha out");
  }
  // The picture and its alpha are half of the work each.
  const auto half = [&](double done) -> ProgressCallback {
    if (!options.progress) return {};
    return [&callback = options.progress, done](const Progress& p) { return callback({done + p.share / 2}); };
  };
  check(options);
  std::optional<Film> result;
  on_threads(options.threads, [&] {
    using Clock = std::chrono::steady_clock;
    const Camera camera(view.camera, options.width, options.height);
    const auto start = Clock::now();
    std::optional<Cells> own;
    const Cells* cells = cells_for(scene, camera, options, kept, own);
    if (report != nullptr) report->cells_seconds += std::chrono::duration<double>(Clock::now() - start).count();
    RenderOptions first = options;
    first.threads = 0;  // the present ones
    first.progress = half(0);
    const Film film = render(scene, view, first, report, {cells, kept.layer_cells});
    result = with_alpha(scene, view, camera, cells, options, film, half(0.5));
  });
  return std::move(*result);
}

}  // namespace csgcast
