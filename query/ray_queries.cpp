// SPDX-License-Identifier: MIT
#include "query/ray_queries.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "raycast/packets/packet_caster.h"

namespace csgcast {
namespace {

constexpr std::size_t rays_at_once = 4096;

void check_triples(std::span<const double> numbers, const char* what) {
  if (numbers.size() % 3 == 0) return;
  throw Error(ErrorCode::usage, {}, fmt::format("there are {} {}, no multiple of 3", numbers.size(), what),
              "x, y and z follow one another", "give 3 x count numbers");
}

/// Some rays next to each other, a number an array.
class RayBuffer {
 public:
  /// Throws as Ray does, naming the ray.
  RayArrays load(const Rays& rays, std::size_t first, std::size_t count, const Span& span) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      numbers_[axis].resize(count);
      numbers_[3 + axis].resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        numbers_[axis][i] = rays.origins[3 * (first + i) + axis];
        numbers_[3 + axis][i] = rays.directions[3 * (first + i) + axis];
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_sound(i)) refuse(first + i, i);
    }
    RayArrays arrays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = numbers_[axis];
      arrays.direction[axis] = numbers_[3 + axis];
    }
    arrays.whole_line = span.from != 0;
    if (span.to != HUGE_VAL) {
      ends_.assign(count, span.to);
      arrays.end = ends_;
    }
    return arrays;
  }

  Ray ray(std::size_t i) const { return Ray(origin(i), direction(i)); }

 private:
  Point origin(std::size_t i) const { return {numbers_[0][i], numbers_[1][i], numbers_[2][i]}; }
  Vector direction(std::size_t i) const { return {numbers_[3][i], numbers_[4][i], numbers_[5][i]}; }
  bool is_sound(std::size_t i) const {
    const Point o = origin(i);
    const Vector d = direction(i);
    return is_finite(o) && is_finite(d) && Ray::in_range(o, d);
  }
  [[noreturn]] void refuse(std::size_t index, std::size_t i) const {
    const Vector d = direction(i);
    if (!is_finite(origin(i)) || !is_finite(d) || d == Vector{}) {
      const bool is_zero = d == Vector{};
      throw Error(ErrorCode::bad_value, {},
                  fmt::format("ray {} (counted from 0) has {}", index,
                              is_zero ? "the direction zero" : "a number that is not finite"),
                  "it does not say where to look", "correct the ray or leave it out");
    }
    throw Error(ErrorCode::limit, {}, fmt::format("ray {} (counted from 0) is out of range", index),
                "coordinates up to 2^400 and directions from 2^-400 to 2^400 work", "choose another unit of length");
  }

  std::array<std::vector<double>, 6> numbers_;
  std::vector<double> ends_;
};

/// What one thread works with.
struct Worker {
  explicit Worker(const Cells& cells) : packets(cells) {}

  PacketCaster packets;
  RayBuffer rays;
};

/// Calls `work(worker, first, count)` for runs of up to rays_at_once of `total`, side by side.
template <class Work>
void in_runs(const Cells& cells, std::size_t total, const QueryOptions& options, Work&& work) {
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(cells); });
  const std::size_t runs = (total + rays_at_once - 1) / rays_at_once;
  ProgressTeller progress(options.progress, runs);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, runs, 1), [&](const auto& range) {
    Worker& worker = workers.local();
    for (std::size_t run = range.begin(); run != range.end(); ++run) {
      const std::size_t first = run * rays_at_once;
      work(worker, run, first, std::min(rays_at_once, total - first));
      progress.step();
    }
  });
  progress.finish();
}

void check(const Rays& rays, const QueryOptions& options) {
  check_triples(rays.origins, "coordinates of origins");
  check_triples(rays.directions, "coordinates of directions");
  if (rays.origins.size() != rays.directions.size()) {
    throw Error(ErrorCode::usage, {},
                fmt::format("there are {} origins, but {} directions", rays.count(), rays.directions.size() / 3),
                "each ray has one of either", "give as many of both");
  }
  if (!(options.span.from < options.span.to)) {
    throw Error(ErrorCode::usage, {},
                fmt::format("nothing of a ray is between t = {} and t = {}", options.span.from, options.span.to),
                "the span must go upwards", "give a lesser number first");
  }
}

bool fits_lanes(const Span& span) { return span.from == 0 || span.from == -HUGE_VAL; }

/// The intervals of a run, as its part of the table.
struct Run {
  std::vector<Interval> intervals;
  std::vector<EndFace> faces;
};

}  // namespace

struct RayQueries::State {
  explicit State(Scene of) : scene(std::move(of)), cells(scene) {}

  Scene scene;
  Cells cells;
};

RayQueries::RayQueries(Solid solid, const Welding& welding) : RayQueries(compile(std::move(solid), welding)) {}
RayQueries::RayQueries(Scene scene) : state_(std::make_unique<const State>(std::move(scene))) {}
RayQueries::~RayQueries() = default;
RayQueries::RayQueries(RayQueries&&) noexcept = default;

const Scene& RayQueries::scene() const { return state_->scene; }
const Cells& RayQueries::cells() const { return state_->cells; }

IntervalTable RayQueries::intervals(const Rays& rays, const QueryOptions& options) const {
  check(rays, options);
  using Ends = PacketCaster::Ends;
  const Ends ends = options.faces || options.normals ? Ends::faces : Ends::bare;
  IntervalTable table;
  table.offsets.resize(rays.count() + 1);
  std::vector<Run> runs((rays.count() + rays_at_once - 1) / rays_at_once);
  in_runs(cells(), rays.count(), options, [&](Worker& worker, std::size_t run, std::size_t first, std::size_t count) {
    IntervalBatch batch;
    const RayArrays arrays = worker.rays.load(rays, first, count, options.span);
    if (fits_lanes(options.span)) {
      worker.packets.intervals(arrays, batch, options.rounding, ends);
    } else {
      std::vector<Ray> some;
      for (std::size_t i = 0; i < count; ++i) some.push_back(worker.rays.ray(i));
      worker.packets.intervals(some, batch, options.span, options.rounding, ends);
    }
    for (std::size_t i = 0; i < count; ++i) table.offsets[first + i + 1] = batch.offsets[i + 1];
    runs[run] = {std::move(batch.intervals), std::move(batch.faces)};
  });
  // Offsets within runs become those of all.
  std::vector<std::size_t> starts(runs.size() + 1);
  for (std::size_t run = 0; run < runs.size(); ++run) starts[run + 1] = starts[run] + runs[run].intervals.size();
  const std::size_t total = starts.back();
  table.t.resize(2 * total);
  table.surfaces.resize(2 * total);
  if (options.faces) table.leaves.resize(2 * total);
  if (options.faces) table.parts.resize(2 * total);
  if (options.normals) table.normals.resize(6 * total);
  tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t run) {
    const std::size_t last = std::min((run + 1) * rays_at_once, rays.count());
    for (std::size_t i = run * rays_at_once; i < last; ++i) table.offsets[i + 1] += starts[run];
    Run& of = runs[run];
    for (std::size_t i = 0; i < of.intervals.size(); ++i) {
      const std::size_t at = 2 * (starts[run] + i);
      const Interval& interval = of.intervals[i];
      table.t[at] = interval.entry.t;
      table.t[at + 1] = interval.exit.t;
      table.surfaces[at] = interval.entry.surface.index();
      table.surfaces[at + 1] = interval.exit.surface.index();
    }
    for (std::size_t end = 0; end < of.faces.size(); ++end) {
      const EndFace& face = of.faces[end];
      const std::size_t at = 2 * starts[run] + end;
      if (options.faces) {
        table.leaves[at] = face.leaf.index();
        table.parts[at] = face.leaf.valid() ? scene().leaf(face.leaf).part.index() : no_id;
      }
      for (std::size_t axis = 0; options.normals && axis < 3; ++axis)
        table.normals[3 * at + axis] = face.normal[axis] + 0.0;  // no -0
    }
    of = {};
  });
  return table;
}

HitTable RayQueries::first_hits(const Rays& rays, const QueryOptions& options) const {
  check(rays, options);
  HitTable table;
  table.t.resize(rays.count());
  table.surfaces.resize(rays.count());
  table.is_entry.resize(rays.count());
  in_runs(cells(), rays.count(), options, [&](Worker& worker, std::size_t, std::size_t first, std::size_t count) {
    const RayArrays arrays = worker.rays.load(rays, first, count, options.span);
    std::array<std::uint8_t, rays_at_once> state;
    std::array<std::uint8_t, rays_at_once> root;
    if (options.span.from == 0) {
      worker.packets.first_hits(
          arrays,
          {state, std::span(table.t).subspan(first, count), std::span(table.surfaces).subspan(first, count), root},
          options.rounding);
    } else {
      Caster caster(scene());
      for (std::size_t i = 0; i < count; ++i) {
        caster.begin(worker.rays.ray(i));
        const std::optional<Hit> hit = caster.first_hit(options.span, options.rounding);
        state[i] = !hit ? HitArrays::none : hit->passage == Passage::entry ? HitArrays::entry : HitArrays::exit;
        if (!hit) continue;
        table.t[first + i] = hit->crossing.t;
        table.surfaces[first + i] = hit->crossing.surface.index();
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      table.is_entry[first + i] = state[i] == HitArrays::entry ? 1 : 0;
      if (state[i] != HitArrays::none) continue;
      table.t[first + i] = HUGE_VAL;
      table.surfaces[first + i] = no_id;
    }
  });
  return table;
}

std::vector<std::uint8_t> RayQueries::any_hits(const Rays& rays, const QueryOptions& options) const {
  check(rays, options);
  std::vector<std::uint8_t> hits(rays.count());
  in_runs(cells(), rays.count(), options, [&](Worker& worker, std::size_t, std::size_t first, std::size_t count) {
    const RayArrays arrays = worker.rays.load(rays, first, count, options.span);
    if (options.span.from == 0) return worker.packets.any_hits(arrays, std::span(hits).subspan(first, count));
    Caster caster(scene());
    for (std::size_t i = 0; i < count; ++i) {
      caster.begin(worker.rays.ray(i));
      hits[first + i] = caster.any_hit(options.span) ? 1 : 0;
    }
  });
  return hits;
}

std::vector<Location> RayQueries::locate(std::span<const double> points, const QueryOptions& options) const {
  check_triples(points, "coordinates of points");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i])) continue;
    throw Error(ErrorCode::bad_value, {},
                fmt::format("point {} (counted from 0) has a coordinate that is not finite", i / 3), "it is nowhere",
                "correct it or leave it out");
  }
  std::vector<Location> locations(points.size() / 3);
  tbb::enumerable_thread_specific<Caster> casters([&] { return Caster(scene()); });
  in_runs(cells(), locations.size(), options, [&](Worker&, std::size_t, std::size_t first, std::size_t count) {
    Caster& caster = casters.local();
    for (std::size_t i = first; i < first + count; ++i)
      locations[i] = caster.locate({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
  });
  return locations;
}

}  // namespace csgcast
