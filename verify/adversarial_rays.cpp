// SPDX-License-Identifier: MIT
#include "verify/adversarial_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "csg/base/length.h"
#include "verify/surface_geometry.h"

namespace csgcast::verify {
namespace {

constexpr int tries = 4;

// The numbers have few bits, so products and sums with other short numbers are exact.
Vector short_direction(Random& random) {
  for (;;) {
    Vector v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = 0.25 * (static_cast<double>(random.index(9)) - 4);
    if (v != Vector{}) return v;
  }
}

Vector axis_direction(Random& random) {
  Vector v;
  v[random.index(3)] = random.sign();
  return v;
}

double longest(Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// Moves x by up to two ulps. A zero moves by up to an ulp of `beside`, and sometimes by the least double.
double moved_by_ulps(Random& random, double x, double beside) {
  const double steps = static_cast<double>(random.index(5)) - 2;
  if (x == 0) return steps * (random.index(8) == 0 ? std::numeric_limits<double>::denorm_min() : 0x1p-52 * beside);
  const double towards = std::copysign(std::numeric_limits<double>::infinity(), steps);
  for (int i = 0; i < static_cast<int>(std::fabs(steps)); ++i) x = std::nextafter(x, towards);
  return x;
}

template <class Tag>
Triple<Tag> moved_by_ulps(Random& random, Triple<Tag> t) {
  const double beside = longest({t.x, t.y, t.z});
  for (std::size_t i = 0; i < 3; ++i) t[i] = moved_by_ulps(random, t[i], beside);
  return t;
}

}  // namespace

struct AdversarialRays::Kind {
  std::string_view name;
  void (AdversarialRays::*make)(Random&);
};

namespace {

// Of the kinds, the first so many stand by themselves; the others change one of these.
constexpr std::size_t base_kinds = 11;

}  // namespace

const std::span<const AdversarialRays::Kind> AdversarialRays::table = [] {
  static constexpr std::array rows{
      Kind{"random", &AdversarialRays::random_rays},
      Kind{"edges", &AdversarialRays::edges},
      Kind{"vertices", &AdversarialRays::vertices},
      Kind{"along axes", &AdversarialRays::along_axes},
      Kind{"in faces", &AdversarialRays::in_faces},
      Kind{"tangents", &AdversarialRays::tangents},
      Kind{"grazing", &AdversarialRays::grazing},
      Kind{"generators", &AdversarialRays::generators},
      Kind{"apexes and centers", &AdversarialRays::centers},
      Kind{"starting on surfaces", &AdversarialRays::starting_on_surfaces},
      Kind{"bisected", &AdversarialRays::bisected},
      Kind{"from far away", &AdversarialRays::from_far_away},
      Kind{"off by ulps", &AdversarialRays::nudged},
      Kind{"reversed", &AdversarialRays::reversed},
      Kind{"long and short directions", &AdversarialRays::scaled},
  };
  return std::span<const Kind>(rows);
}();

std::span<const std::string_view> AdversarialRays::kinds() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Kind& kind : table) list.push_back(kind.name);
    return list;
  }();
  return names;
}

void AdversarialRays::make(std::size_t kind, Random& random, std::size_t most, std::vector<Ray>& rays) {
  made_.clear();
  for (std::size_t i = 0; i < tries * most && made_.size() < most; ++i) (this->*table[kind].make)(random);
  if (made_.size() > most) made_.resize(most, made_.front());
  rays.insert(rays.end(), made_.begin(), made_.end());
}

void AdversarialRays::add(Point origin, Vector direction) {
  if (is_finite(origin) && is_finite(direction) && Ray::in_range(origin, direction))
    made_.emplace_back(origin, direction);
}

void AdversarialRays::random_rays(Random& random) {
  const Vector d = places_.size() * random.direction();
  add(places_.anywhere(random) - random.number(0, 3) * d, d);
}

// Chooses some direction through a point, and an origin that is exact if the numbers are short.
void AdversarialRays::through(Random& random, Point p, Vector along) {
  Vector d;
  switch (random.index(5)) {
    case 0:
      d = random.direction();
      break;
    case 1:
      d = short_direction(random);
      break;
    case 2:
      d = axis_direction(random);
      break;
    case 3:
      d = along;
      break;
    default:  // and through another such point
      if (const std::optional<Point> q = special_point(random)) add(p, *q - p);
      return;
  }
  d = places_.size() * d;
  add(p - 0.25 * static_cast<double>(random.index(13)) * d, d);
}

// A point on an edge, at a corner, at a center or on a face, depending on what the scene has.
std::optional<Point> AdversarialRays::special_point(Random& random) {
  const std::size_t kind = random.index(4);
  if (kind == 0) return places_.center(random);
  if (kind < 3) {
    const std::optional<Corner> corner = places_.corner(random, kind + 1);
    return corner ? std::optional(corner->point) : std::nullopt;
  }
  const std::optional<SurfacePlace> place = places_.on_surface(random);
  return place ? std::optional(place->point) : std::nullopt;
}

void AdversarialRays::through_corner(Random& random, std::size_t count) {
  if (const std::optional<Corner> corner = places_.corner(random, count)) through(random, corner->point, corner->along);
}

void AdversarialRays::edges(Random& random) { through_corner(random, 2); }
void AdversarialRays::vertices(Random& random) { through_corner(random, 3); }

void AdversarialRays::centers(Random& random) {
  if (const std::optional<Point> center = places_.center(random)) through(random, *center, random.direction());
}

void AdversarialRays::along_axes(Random& random) {
  const std::optional<Point> p = random.index(2) == 0 ? special_point(random) : places_.anywhere(random);
  const Vector d = places_.size() * axis_direction(random);
  if (p) add(*p - 0.5 * static_cast<double>(random.index(9)) * d, d);
}

// A ray is exactly in the plane if that is axis-parallel and at a representable place.
void AdversarialRays::in_faces(Random& random) {
  const std::optional<SurfacePlace> place = places_.on_surface(random, ScenePlaces::Shape::flat);
  if (!place) return;
  const Vector across = random.index(2) == 0 ? random.direction() : short_direction(random);
  const Vector d = places_.size() * cross(place->normal, across);
  add(place->point - 0.5 * static_cast<double>(random.index(5)) * d, d);
}

// Rays pass a surface at 1e-6 to 1e-16 of the scene's size, on either side, or touch it.
void AdversarialRays::tangents(Random& random) {
  const std::optional<SurfacePlace> place = places_.on_surface(random);
  if (!place) return;
  const Vector d = places_.size() * normalised(cross(place->normal, random.direction()));
  const double off = random.index(4) == 0 ? 0 : random.sign() * random.power_of_tenth(6, 16) * places_.size();
  add(place->point + off * place->normal - random.number(0, 3) * d, d);
}

// Rays pass through a point of a surface with a slope of 1e-3 to 1e-17 to it.
void AdversarialRays::grazing(Random& random) {
  const std::optional<SurfacePlace> place = places_.on_surface(random);
  if (!place) return;
  const Vector level = normalised(cross(place->normal, random.direction()));
  const Vector d = places_.size() * (level + random.sign() * random.power_of_tenth(3, 17) * place->normal);
  add(place->point - 0.5 * static_cast<double>(random.index(5)) * d, d);
}

void AdversarialRays::generators(Random& random) {
  const std::optional<SurfacePlace> place = places_.on_surface(random, ScenePlaces::Shape::curved);
  if (!place) return;
  for (const Vector line : straight_lines(places_.scene(), place->surface, place->point)) {
    const Vector d = places_.size() * line;
    add(place->point - 0.5 * static_cast<double>(random.index(5)) * d, d);
  }
}

void AdversarialRays::starting_on_surfaces(Random& random) {
  const std::optional<SurfacePlace> place = places_.on_surface(random);
  if (!place) return;
  const std::optional<Corner> corner = random.index(3) == 0 ? places_.corner(random, 2) : std::nullopt;
  const Point p = corner ? corner->point : place->point;
  const Point origin = random.index(2) == 0 ? p : moved_by_ulps(random, p);
  const std::size_t kind = random.index(4);
  add(origin, kind == 0   ? random.sign() * place->normal
              : kind == 1 ? cross(place->normal, random.direction())
              : kind == 2 ? short_direction(random)
                          : random.direction());
}

// Finds the surfaces of all ends of the list. Returns false if there is no such ray.
bool AdversarialRays::see(Point eye, Vector direction, std::vector<SurfaceId>& seen) {
  seen.clear();
  if (!is_finite(eye) || !is_finite(direction) || !Ray::in_range(eye, direction)) return false;
  places_.caster().begin(Ray(eye, direction));
  places_.caster().intervals(list_, Span::line());
  for (const Interval& interval : list_) {
    seen.push_back(interval.entry.surface);
    seen.push_back(interval.exit.surface);
  }
  return true;
}

// Bisects between two rays from one origin that see different surfaces, down to the last bits.
void AdversarialRays::bisected(Random& random) {
  const Point eye = places_.anywhere(random) - 3 * places_.size() * random.direction();
  Vector a = places_.anywhere(random) - eye;
  Vector b = places_.anywhere(random) - eye;
  if (!see(eye, a, at_a_) || !see(eye, b, seen_) || seen_ == at_a_) return;
  constexpr int steps = 54;
  for (int step = 0; step < steps; ++step) {
    const Vector middle = 0.5 * (a + b);
    if (!see(eye, middle, seen_)) return;
    if (step >= steps - 2) add(eye, middle);
    (seen_ == at_a_ ? a : b) = middle;
  }
  add(eye, a);
  add(eye, b);
}

// A ray of one of the base kinds.
std::optional<Ray> AdversarialRays::base(Random& random) {
  const std::size_t before = made_.size();
  (this->*table[random.index(base_kinds)].make)(random);
  if (made_.size() == before) return std::nullopt;
  const Ray ray = made_.back();
  made_.resize(before, ray);
  return ray;
}

void AdversarialRays::from_far_away(Random& random) {
  const std::optional<Ray> ray = base(random);
  if (!ray) return;
  // Up to 2^300 sizes; from beyond 2^50 hardly a ray still meets what it aims at.
  const double far =
      random.index(4) == 0 ? std::ldexp(1, static_cast<int>(random.index(301))) : 1 / random.power_of_tenth(3, 12);
  const double distance = places_.size() * far;
  add(ray->origin() - distance * normalised(ray->direction()), ray->direction());
}

void AdversarialRays::nudged(Random& random) {
  if (const std::optional<Ray> ray = base(random))
    add(moved_by_ulps(random, ray->origin()), moved_by_ulps(random, ray->direction()));
}

void AdversarialRays::reversed(Random& random) {
  if (const std::optional<Ray> ray = base(random))
    add(ray->at(0.5 * static_cast<double>(random.index(9))), -ray->direction());
}

void AdversarialRays::scaled(Random& random) {
  const std::optional<Ray> ray = base(random);
  if (!ray) return;
  const double factor = random.index(2) == 0 ? 1 : random.number(0.1, 10);
  add(ray->origin(), std::ldexp(factor, static_cast<int>(random.index(601)) - 300) * ray->direction());
}

}  // namespace csgcast::verify
