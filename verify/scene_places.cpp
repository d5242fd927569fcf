// SPDX-License-Identifier: MIT
#include "verify/scene_places.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/surface_geometry.h"

namespace csgcast::verify {
namespace {

constexpr int tries = 8;

Point point_in(Random& random, const Box& box) {
  Point p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = box.lower[i] + random.number(0, 1) * (box.upper[i] - box.lower[i]);
  return p;
}

}  // namespace

ScenePlaces::ScenePlaces(const Scene& scene) : caster_(scene), size_(std::ldexp(1.0, scene.frame().exponent)) {
  const Point center = scene.frame().center;
  const Vector half{size_, size_, size_};
  region_ = {center - half, center + half};
  for (const Surface& surface : scene.surfaces()) (surface.is_plane ? has_flat_ : has_curved_) = true;
}

// Leaf nodes are at least a third of all nodes.
const Leaf* ScenePlaces::some_leaf(Random& random, Box* box) const {
  const Scene& scene = caster_.scene();
  for (int i = 0; i < tries && !scene.nodes().empty(); ++i) {
    const Node& node = scene.nodes()[random.index(scene.nodes().size())];
    if (node.op != Node::Op::leaf) continue;
    if (box != nullptr) *box = node.box;
    return &scene.leaf(LeafId(node.first));
  }
  return nullptr;
}

std::optional<SurfaceId> ScenePlaces::some_surface(Random& random) const {
  const Leaf* leaf = some_leaf(random, nullptr);
  if (leaf == nullptr || leaf->count == 0) return std::nullopt;
  return caster_.scene().half_spaces(*leaf)[random.index(leaf->count)].surface;
}

Point ScenePlaces::anywhere(Random& random) const {
  Box box;
  if (random.index(2) == 0 && some_leaf(random, &box) != nullptr) {
    box = intersection(box, region_);
    if (!box.is_null()) return point_in(random, box);
  }
  return point_in(random, region_);
}

std::optional<SurfacePlace> ScenePlaces::hit(Random& random) {
  const Point target = anywhere(random);
  const Vector d = size_ * random.direction();
  const Point origin = target - random.number(0, 3) * d;
  if (!Ray::in_range(origin, d)) return std::nullopt;
  const Ray ray(origin, d);
  caster_.begin(ray);
  const std::optional<Hit> found = caster_.first_hit();
  if (!found || !std::isfinite(found->crossing.t)) return std::nullopt;
  return SurfacePlace{found->crossing.surface, ray.at(found->crossing.t), {}};
}

std::optional<SurfacePlace> ScenePlaces::on_surface(Random& random, std::optional<Shape> shape) {
  if (shape && !has(*shape)) return std::nullopt;
  for (int i = 0; i < tries; ++i) {
    std::optional<SurfacePlace> place;
    if (random.index(2) == 0) {
      place = hit(random);
    } else if (const std::optional<SurfaceId> surface = some_surface(random)) {
      place = SurfacePlace{*surface, anywhere(random), {}};
    }
    if (!place || (shape && scene().surface(place->surface).is_plane != (*shape == Shape::flat))) continue;
    const std::optional<Point> settled = meeting_point(scene(), std::span(&place->surface, 1), place->point);
    if (!settled) continue;
    return SurfacePlace{place->surface, *settled, normal_at(scene(), place->surface, *settled)};
  }
  return std::nullopt;
}

// Up to `count` different surfaces, and a point to look from for where they meet.
std::size_t ScenePlaces::pick_surfaces(Random& random, std::size_t count, SurfaceId* picked, Point& start) {
  std::size_t found = 0;
  const auto pick = [&](SurfaceId id) {
    if (found < count && id.valid() && std::find(picked, picked + found, id) == picked + found) picked[found++] = id;
  };
  start = anywhere(random);
  Box box;
  const Leaf* leaf = some_leaf(random, &box);
  if (leaf == nullptr) return 0;
  const std::span<const HalfSpace> half_spaces = scene().half_spaces(*leaf);
  if (random.index(2) == 0) {
    box = intersection(box, region_);
    if (!box.is_null()) start = point_in(random, box);
    for (int i = 0; i < tries; ++i) pick(half_spaces[random.index(half_spaces.size())].surface);
    return found;
  }
  const Vector d = size_ * random.direction();
  const Point origin = start - 2 * d;
  if (!Ray::in_range(origin, d)) return 0;
  caster_.begin(Ray(origin, d));
  caster_.intervals(list_, Span::line());
  if (!list_.empty()) {
    const Interval& interval = list_[random.index(list_.size())];
    if (std::isfinite(interval.entry.t)) start = Ray(origin, d).at(interval.entry.t);
    pick(interval.entry.surface);
    pick(interval.exit.surface);
  }
  pick(half_spaces[random.index(half_spaces.size())].surface);
  return found;
}

std::optional<Corner> ScenePlaces::corner(Random& random, std::size_t count) {
  if (scene().surfaces().size() < count) return std::nullopt;
  std::array<SurfaceId, 3> picked;
  for (int i = 0; i < tries; ++i) {
    Point start;
    if (pick_surfaces(random, count, picked.data(), start) < count) continue;
    const std::span<SurfaceId> surfaces = std::span(picked).first(count);
    // Planes come first, because the step onto an axis-parallel plane is not changed by the steps after it.
    std::stable_partition(surfaces.begin(), surfaces.end(), [&](SurfaceId id) { return scene().surface(id).is_plane; });
    const std::optional<Point> p = meeting_point(scene(), surfaces, start);
    if (!p) continue;
    return Corner{*p, cross(normal_at(scene(), picked[0], *p), normal_at(scene(), picked[1], *p))};
  }
  return std::nullopt;
}

std::optional<Point> ScenePlaces::center(Random& random) {
  if (!has_curved_) return std::nullopt;
  for (int i = 0; i < tries; ++i) {
    const std::optional<SurfaceId> surface = some_surface(random);
    if (!surface) continue;
    if (const std::optional<Point> p = center_of(scene(), *surface)) return p;
  }
  return std::nullopt;
}

}  // namespace csgcast::verify
