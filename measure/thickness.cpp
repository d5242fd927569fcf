// SPDX-License-Identifier: MIT
#include "measure/thickness.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "raycast/packets/packet_caster.h"

namespace csgcast {
namespace {

/// Arrays with one number of each kind for each ray.
struct Faces {
  std::array<std::vector<double>, 3> place;
  std::array<std::vector<double>, 3> inwards;
  std::vector<std::uint32_t> surface;
  std::vector<std::uint8_t> goes_positive;
  std::vector<std::uint32_t> leaf;
  std::vector<std::uint32_t> ray;  ///< the rays that met the faces

  void clear() { *this = {}; }
  void add(Point p, Normal n, SurfaceId id, bool positive, LeafId of, std::uint32_t index) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis].push_back(p[axis]);
      inwards[axis].push_back(-n[axis]);
    }
    surface.push_back(id.index());
    goes_positive.push_back(positive ? 1 : 0);
    leaf.push_back(of.index());
    ray.push_back(index);
  }
  std::size_t count() const { return surface.size(); }
  RayArrays rays() const {
    RayArrays arrays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrays.origin[axis] = place[axis];
      arrays.direction[axis] = inwards[axis];
    }
    arrays.departure = surface;
    arrays.departs_positive = goes_positive;
    return arrays;
  }
};

}  // namespace

struct ThicknessProbe::State {
  explicit State(const Cells& of) : cells(of), caster(of) {}

  /// Casts rays inwards from the faces, and calls `tell(face, thickness)` for each.
  template <class Tell>
  void cast_inwards(Tell&& tell) {
    const std::size_t count = faces.count();
    state.resize(count);
    t.resize(count);
    hit.resize(count);
    caster.first_hits(faces.rays(), {state, t, hit}, Rounding::close);
    for (std::size_t i = 0; i < count; ++i) {
      const double thickness = state[i] == HitArrays::none ? HUGE_VAL : t[i];
      tell(i, thickness);
      if (!(thickness > 0) || (thinnest && thickness >= thinnest->thickness)) continue;
      const Point p{faces.place[0][i], faces.place[1][i], faces.place[2][i]};
      const Vector d{faces.inwards[0][i], faces.inwards[1][i], faces.inwards[2][i]};
      if (std::isfinite(thickness) && is_corner(p + thickness * d, d, SurfaceId(hit[i]))) continue;
      const Normal n = as_normal(-d);
      thinnest = ThinPlace{thickness, p, n, LeafId(faces.leaf[i])};
    }
  }

  /// True if the far face leans so much that the two faces form a corner and not a wall.
  bool is_corner(Point p, Vector d, SurfaceId id) const {
    const Scene& scene = cells.scene();
    const Vector slope = normalised(gradient(scene.surface(id), scene.frame(), p));
    return std::fabs(dot(slope, d)) < 0.5;
  }

  const Cells& cells;
  PacketCaster caster;
  IntervalBatch batch;
  Faces faces;
  std::vector<std::uint8_t> state;
  std::vector<double> t;
  std::vector<std::uint32_t> hit;
  std::optional<ThinPlace> thinnest;
};

ThicknessProbe::ThicknessProbe(const Cells& cells) : state_(std::make_unique<State>(cells)) {}
ThicknessProbe::~ThicknessProbe() = default;
ThicknessProbe::ThicknessProbe(ThicknessProbe&&) noexcept = default;

const std::optional<ThinPlace>& ThicknessProbe::thinnest() const { return state_->thinnest; }

void ThicknessProbe::first_faces(const RayArrays& rays, std::span<double> thickness) {
  CSGCAST_PRECONDITION(thickness.size() == rays.count());
  State& s = *state_;
  const std::size_t count = rays.count();
  std::vector<std::uint8_t> state(count), front(count);
  std::vector<double> numbers(7 * count);
  std::vector<std::uint32_t> ids(3 * count);
  const auto column = [count](auto& table, std::size_t i) { return std::span(table).subspan(i * count, count); };
  FaceArrays arrays;
  arrays.state = state;
  arrays.t = column(numbers, 0);
  arrays.surface = column(ids, 0);
  arrays.look = column(ids, 1);
  arrays.leaf = column(ids, 2);
  arrays.comes_positive = front;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    arrays.point[axis] = column(numbers, 1 + axis);
    arrays.normal[axis] = column(numbers, 4 + axis);
  }
  s.caster.first_faces(rays, arrays);
  s.faces.clear();
  for (std::size_t i = 0; i < count; ++i) {
    thickness[i] = 0;
    if (state[i] != HitArrays::entry) continue;
    s.faces.add({arrays.point[0][i], arrays.point[1][i], arrays.point[2][i]},
                {arrays.normal[0][i], arrays.normal[1][i], arrays.normal[2][i]}, SurfaceId(arrays.surface[i]),
                front[i] == 0, LeafId(arrays.leaf[i]), static_cast<std::uint32_t>(i));
  }
  s.cast_inwards([&](std::size_t face, double value) { thickness[s.faces.ray[face]] = value; });
}

void ThicknessProbe::all_faces(const RayArrays& rays) {
  State& s = *state_;
  const Scene& scene = s.cells.scene();
  s.caster.intervals(rays, s.batch, Rounding::close, PacketCaster::Ends::faces);
  s.faces.clear();
  for (std::size_t ray = 0; ray < rays.count(); ++ray) {
    for (std::size_t i = s.batch.offsets[ray]; i < s.batch.offsets[ray + 1]; ++i) {
      for (const std::size_t end : {2 * i, 2 * i + 1}) {
        const Crossing& crossing = end % 2 == 0 ? s.batch.intervals[i].entry : s.batch.intervals[i].exit;
        const EndFace& face = s.batch.faces[end];
        if (!crossing.surface.valid() || !face.leaf.valid()) continue;
        Point p;
        for (std::size_t axis = 0; axis < 3; ++axis)
          p[axis] = rays.origin[axis][ray] + crossing.t * rays.direction[axis][ray];
        // The inside is where the form falls, or rises, against the normal.
        const Vector slope = gradient(scene.surface(crossing.surface), scene.frame(), p);
        const double out = dot(slope, as_vector(face.normal));
        if (out != 0)
          s.faces.add(p, face.normal, crossing.surface, out < 0, face.leaf, static_cast<std::uint32_t>(ray));
      }
    }
  }
  s.cast_inwards([](std::size_t, double) {});
}

std::optional<ThinPlace> find_thinnest(const Cells& cells, std::size_t samples, const ProgressCallback& callback) {
  const Box& bounds = cells.scene().bounds();
  ProgressTeller progress(callback, 3 * samples);
  if (bounds.is_null() || !bounds.is_finite()) {
    progress.finish();
    return std::nullopt;
  }
  std::vector<std::optional<ThinPlace>> found(3 * samples);  // by row
  const Vector size = bounds.size();
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t row) {
    const std::size_t axis = row / samples;
    const std::size_t j = (axis + 1) % 3;
    const std::size_t k = (axis + 2) % 3;
    std::array<std::vector<double>, 6> numbers;
    for (auto& column : numbers) column.assign(samples, 0);
    const auto place = [&](std::size_t on, std::size_t i) {
      return bounds.lower[on] + size[on] * (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
    };
    for (std::size_t i = 0; i < samples; ++i) {
      numbers[axis][i] = bounds.lower[axis] - size[axis];
      numbers[j][i] = place(j, i);
      numbers[k][i] = place(k, row % samples);
      numbers[3 + axis][i] = 1;
    }
    RayArrays rays;
    for (std::size_t on = 0; on < 3; ++on) {
      rays.origin[on] = numbers[on];
      rays.direction[on] = numbers[3 + on];
    }
    ThicknessProbe probe(cells);
    probe.all_faces(rays);
    found[row] = probe.thinnest();
    progress.step();
  });
  progress.finish();
  std::optional<ThinPlace> best;
  for (const std::optional<ThinPlace>& place : found) {
    if (place && (!best || place->thickness < best->thickness)) best = place;
  }
  return best;
}

}  // namespace csgcast
