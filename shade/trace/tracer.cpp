// SPDX-License-Identifier: MIT
#include "shade/trace/tracer.h"

#include <cmath>
#include <limits>

#include "csg/base/length.h"

namespace csgcast {
namespace {

// More rays than this for one sample (mirrors that return more than they get): the rest is background.
constexpr std::uint64_t most_rays_of_a_sample = 1u << 12;

constexpr Rgb white{1, 1, 1};

bool is_direction(Vector v) { return is_finite(v) && v != Vector{}; }

std::uint64_t& count_of(RayCounts& counts, RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return counts.primary;
    case RayKind::shadow:
      return counts.shadow;
    case RayKind::reflection:
      return counts.reflection;
    case RayKind::transmission:
      return counts.transmission;
  }
  return counts.primary;
}

}  // namespace

Tracer::Tracer(Caster& caster, const View& view, LayerCaster* layers)
    : scene_(caster.scene()), view_(view), caster_(caster), layers_(layers) {}

Rgb Tracer::trace(const Ray& ray, RayTree* tree) {
  tree_ = tree;
  sum_ = {};
  pending_.clear();
  pending_.push_back({RayKind::primary, 0, ray, std::nullopt, {}, white});
  return run_all(0);
}

Rgb Tracer::trace_on(const Reflected& reflected) {
  tree_ = nullptr;
  sum_ = reflected.brought;
  pending_.clear();
  pending_.push_back({RayKind::reflection, reflected.depth, reflected.ray, reflected.departure, {}, reflected.weight});
  return run_all(static_cast<std::uint64_t>(reflected.depth));
}

// `rays`: how many the sample had before.
Rgb Tracer::run_all(std::uint64_t rays) {
  for (; !pending_.empty(); ++rays) {
    const Task task = pending_.back();
    pending_.pop_back();
    if (task.depth >= view_.settings.max_depth || rays >= most_rays_of_a_sample) {
      ++report_.skipped.depth_limit;
      leave(task, Fate::at_depth_limit);
    } else {
      run(task);
    }
  }
  return sum_;
}

void Tracer::leave(const Task& task, Fate fate) {
  const bool endless = fate == Fate::left;
  const Rgb weight =
      endless ? task.weight * absorbed(task.medium, std::numeric_limits<double>::infinity()) : task.weight;
  const Rgb brings = weight * view_.sky(task.ray.direction());
  sum_ = sum_ + brings;
  if (tree_ != nullptr) {
    tree_->push_back({.kind = task.kind,
                      .fate = fate,
                      .depth = task.depth,
                      .weight = weight,
                      .total = task.total,
                      .brings = brings});
  }
}

void Tracer::run(const Task& arriving) {
  if (arriving.departure &&
      leads_away(arriving.ray.origin(), *arriving.departure, normalised(arriving.ray.direction()))) {
    ++(arriving.kind == RayKind::reflection ? report_.skipped.reflection_leading_away
                                            : report_.skipped.transmission_leading_away);
    return leave(arriving, Fate::left);
  }
  ++count_of(report_.rays, arriving.kind);
  const std::optional<Boundary> boundary = next_boundary(arriving);
  if (!boundary) return leave(arriving, Fate::left);
  Task task = arriving;
  task.medium = boundary->before;
  task.weight = task.weight * absorbed(task.medium, boundary->t);

  const Vector d = task.ray.direction();
  const Vector out = as_vector(boundary->face.normal);
  const Spot spot{*boundary, scene_.look(boundary->face.look), boundary->face.point, dot(out, d) > 0 ? -out : out, -d};
  std::size_t record = 0;
  if (tree_ != nullptr) {
    record = tree_->size();
    tree_->push_back({.kind = task.kind,
                      .fate = Fate::hit,
                      .depth = task.depth,
                      .weight = task.weight,
                      .t = boundary->t,
                      .leaf = boundary->face.leaf,
                      .surface = boundary->surface,
                      .look = boundary->face.look,
                      .total = task.total});
  }
  const Rgb brings = task.weight * local(spot, task);
  sum_ = sum_ + brings;
  if (tree_ != nullptr) (*tree_)[record].brings = brings;
  if (is_finite(spot.point)) spawn(spot, task);
}

std::optional<Tracer::Boundary> Tracer::next_boundary(const Task& task) {
  if (scene_.transmits()) return next_interface(task);
  caster_.begin(task.ray, task.departure);
  const std::optional<Hit> hit = caster_.first_hit({}, Rounding::close);
  if (!hit) return std::nullopt;
  const bool enters = hit->passage == Passage::entry;
  return Boundary{hit->crossing.t, hit->crossing.surface, caster_.attribute(*hit), {}, {}, enters, !enters};
}

std::optional<Tracer::Boundary> Tracer::next_interface(const Task& task) {
  if (layers_ != nullptr) {
    const LayerCaster::Outcome outcome = layers_->look(task.ray, task.departure);
    if (outcome == LayerCaster::Outcome::none) return std::nullopt;
    if (outcome == LayerCaster::Outcome::found) return boundary(layers_->change(), layers_->face(), task);
  }
  caster_.begin(task.ray, task.departure);
  caster_.interfaces(interfaces_);
  if (interfaces_.empty()) return std::nullopt;
  const Interface& first = interfaces_.front();
  return boundary(first, caster_.attribute(first.node, first.hit), task);
}

Tracer::Boundary Tracer::boundary(const Interface& first, const Attribution& face, const Task& task) {
  const auto is_even = [&](RegionId region) { return !region.valid() || layers_->cells().looks_even(region); };
  if (layers_ != nullptr && !(is_even(first.before) && is_even(first.after))) caster_.begin(task.ray, task.departure);
  const Medium before = medium(first.before, Passage::exit, first, task.medium);
  const Medium after = medium(first.after, Passage::entry, first, {});
  const bool out_of_opaque = !first.before.valid() && first.hit.passage == Passage::exit;
  return Boundary{first.hit.crossing.t, first.hit.crossing.surface, face, before, after, first.into_opaque,
                  out_of_opaque};
}

// The medium on one side of an interface; `known` saves the search if it is still that one.
Tracer::Medium Tracer::medium(RegionId region, Passage passage, const Interface& where, Medium known) {
  if (!region.valid()) return {};
  if (region == known.region) return known;
  if (layers_ != nullptr && layers_->cells().looks_even(region)) return {region, scene_.region(region).look};
  const LookId look = caster_.look_inside(scene_.region(region).node, {where.hit.crossing, passage});
  return {region, look.valid() ? look : scene_.region(region).look};
}

Rgb Tracer::local(const Spot& spot, const Task& task) {
  Rgb result = unlit(spot.material);
  if (!is_finite(spot.point)) return result;
  for (std::size_t i = 0; i < view_.lights.size(); ++i) result = result + lit(spot, i, task);
  return result;
}

// What one light adds at the spot, shadows included.
Rgb Tracer::lit(const Spot& spot, std::size_t light, const Task& task) {
  RayRecord record{.kind = RayKind::shadow, .fate = Fate::without_effect, .depth = task.depth + 1, .light = light};
  Rgb result;
  const std::optional<Illumination> from = illuminate(view_.lights[light], spot.point);
  const Rgb unshadowed = from ? phong(spot.material, spot.normal, spot.to_viewer, *from) : Rgb{};
  if (from && !(dot(spot.normal, from->to_light) > 0)) {
    record.fate = Fate::facing_away;
    ++report_.skipped.shadow_facing_away;
  } else if (!(brightest(unshadowed) > 0) || !(brightest(task.weight) > 0)) {
    ++report_.skipped.shadow_without_effect;
  } else {
    record.weight = passing(spot, *from);
    result = unshadowed * record.weight;
    record.fate = brightest(record.weight) > 0 ? Fate::arrived : Fate::blocked;
    record.brings = task.weight * result;
  }
  if (tree_ != nullptr) tree_->push_back(record);
  return result;
}

// Whether a ray in a unit direction meets nothing because the solid is behind the surface that it departs from.
bool Tracer::leads_away(Point from, const Departure& departure, Vector direction) const {
  if (!scene_.leads_away(departure.surface, departure.side)) return false;
  const Vector normal = normalised(gradient(scene_.surface(departure.surface), scene_.frame(), from));
  const double rise = dot(normal, direction);
  return (departure.side == Sense::positive ? rise : -rise) > clear_departure;
}

// The share of a light that reaches the spot: all or nothing, or dimmed by what it passes through.
Rgb Tracer::passing(const Spot& spot, const Illumination& from) {
  const Departure departure{spot.boundary.surface, spot.boundary.face.front};
  if (!spot.boundary.before.region.valid() && leads_away(spot.point, departure, from.to_light)) {
    ++report_.skipped.shadow_leading_away;
    return white;
  }
  ++report_.rays.shadow;
  const Ray ray(spot.point, from.path);
  const Span span{0, from.is_finite ? 1 : std::numeric_limits<double>::infinity()};
  if (scene_.transmits() && !spot.boundary.out_of_opaque) return passing_media(spot, ray, length(from.path), span);
  caster_.begin(ray, departure);
  // Seen from inside, the opaque solid is a shell: what blocks light is a boundary, not the inside.
  if (spot.boundary.out_of_opaque) return caster_.first_hit(span) ? Rgb{} : white;
  return caster_.any_hit(span) ? Rgb{} : white;
}

// The same in a scene with transparent media; `unit` is the length of the shadow ray's direction.
Rgb Tracer::passing_media(const Spot& spot, const Ray& ray, double unit, Span span) {
  const Departure departure{spot.boundary.surface, spot.boundary.face.front};
  if (layers_ != nullptr) {
    layers_->look_through(ray, departure, span.to, interfaces_, looks_);
    if (!layers_->cells().all_look_even()) caster_.begin(ray, departure);  // media may have to be asked for
    return passing_changes(spot, unit, span, [&](std::size_t i) { return looks_[i]; });
  }
  caster_.begin(ray, departure);
  caster_.interfaces(interfaces_, span);
  return passing_changes(
      spot, unit, span, [&](std::size_t i) { return caster_.attribute(interfaces_[i].node, interfaces_[i].hit).look; });
}

// By the changes of medium on the way; look_of(i) is what the face of one shows.
template <class LookOf>
Rgb Tracer::passing_changes(const Spot& spot, double unit, Span span, LookOf&& look_of) {
  Rgb share = white;
  Medium now = spot.boundary.before;
  double from = 0;
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    const Interface& next = interfaces_[i];
    if (next.into_opaque) return {};
    const double t = next.hit.crossing.t;
    now = medium(next.before, Passage::exit, next, now);
    share = share * absorbed(now, (t - from) * unit);
    share = scene_.look(look_of(i)).transmission * share;
    if (!(brightest(share) > 0)) return {};
    now = medium(next.after, Passage::entry, next, {});
    from = t;
  }
  return share * absorbed(now, (span.to - from) * unit);
}

void Tracer::spawn(const Spot& spot, const Task& task) {
  const Vector d = task.ray.direction();
  const Boundary& at = spot.boundary;
  const bool lets_through = !at.into_opaque && !at.out_of_opaque;
  double reflection = spot.material.reflection;
  double transmission = lets_through ? spot.material.transmission : 0;
  bool total = false;
  if (transmission > 0) {
    const std::optional<Vector> direction = refracted(d, spot.normal, ior(at.before) / ior(at.after));
    if (direction) {
      push(RayKind::transmission, spot, task, *direction, transmission, false);
    } else {
      ++report_.total_reflections;
      reflection += transmission;
      total = true;
    }
  }
  // Pushed last, so traced first.
  if (reflection > 0) push(RayKind::reflection, spot, task, normalised(mirrored(d, spot.normal)), reflection, total);
}

void Tracer::push(RayKind kind, const Spot& spot, const Task& parent, Vector direction, double share, bool total) {
  const Rgb weight = share * parent.weight;
  if (brightest(weight) < view_.settings.min_contribution || !(brightest(weight) > 0) || !is_direction(direction)) {
    ++(kind == RayKind::reflection ? report_.skipped.reflection_below_cutoff
                                   : report_.skipped.transmission_below_cutoff);
    if (tree_ != nullptr) {
      tree_->push_back(
          {.kind = kind, .fate = Fate::below_cutoff, .depth = parent.depth + 1, .weight = weight, .total = total});
    }
    return;
  }
  const bool reflects = kind == RayKind::reflection;
  const Boundary& at = spot.boundary;
  const Departure departure{at.surface, reflects ? at.face.front : opposite(at.face.front)};
  pending_.push_back(
      {kind, parent.depth + 1, {spot.point, direction}, departure, reflects ? at.before : at.after, weight, total});
}

}  // namespace csgcast
