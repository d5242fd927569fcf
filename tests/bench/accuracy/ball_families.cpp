// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/ball_families.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"

namespace csgcast::bench {
namespace {

using stress::Family;
using stress::Trial;
using test::RandomSolids;

double to_float(double value) { return static_cast<double>(static_cast<float>(value)); }

Vector to_float(Vector v) { return {to_float(v.x), to_float(v.y), to_float(v.z)}; }

bool is_float(double value) { return to_float(value) == value; }

// From `distance` towards a target, in floats.
Ray float_ray(RandomSolids& random, Point target, double distance) {
  const Vector d = to_float(normalised(random.direction()));
  return Ray(Point{} + to_float(target - distance * d - Point{}), d);
}

std::vector<Ball> random_balls(RandomSolids& random, int count) {
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
    balls.push_back({Point{} + to_float(random.point(1) - Point{}), to_float(random.number(0.1, 0.3))});
  return balls;
}

Solid united(const std::vector<Ball>& balls) {
  std::vector<Solid> solids;
  solids.reserve(balls.size());
  for (const Ball& ball : balls) solids.push_back(transformed(sphere(ball.radius), translation(ball.center - Point{})));
  return unite(std::move(solids));
}

Trial union_of_balls(RandomSolids& random, int rays, double distance) {
  Trial trial{united(random_balls(random, 200)), {}};
  for (int i = 0; i < rays; ++i) trial.rays.push_back(float_ray(random, random.point(1), distance));
  return trial;
}

// Past a ball at 1e-7 to 1e-2 of its radius, inside or outside.
Trial silhouettes(RandomSolids& random, int rays) {
  const std::vector<Ball> balls = random_balls(random, 5);
  Trial trial{united(balls), {}};
  for (int i = 0; i < rays; ++i) {
    const Ball& ball = balls[random.index(balls.size())];
    const Vector d = to_float(normalised(random.direction()));
    const Vector aside = normalised(cross(d, random.direction()));
    const double off = std::pow(10.0, -random.number(2, 7)) * (random.index(2) == 0 ? 1 : -1);
    const Point touch = ball.center + ball.radius * (1 + off) * aside;
    trial.rays.emplace_back(Point{} + to_float(touch - 4 * d - Point{}), d);
  }
  return trial;
}

}  // namespace

std::span<const Family> ball_families() {
  static const std::vector<Family> list{
      {"union of balls", [](RandomSolids& random, int rays) { return union_of_balls(random, rays, 4); }},
      {"balls' silhouettes", silhouettes},
      {"balls from 1e4 away", [](RandomSolids& random, int rays) { return union_of_balls(random, rays, 1e4); }},
  };
  return list;
}

std::optional<std::vector<Ball>> balls_of(const Solid& solid) {
  if (solid.kind() != Solid::Kind::unite) return std::nullopt;
  std::vector<Ball> balls;
  for (const Solid& moved : solid.children()) {
    if (moved.kind() != Solid::Kind::transform) return std::nullopt;
    const Transform& place = moved.transform();
    const Vector offset{place(0, 3), place(1, 3), place(2, 3)};
    const Solid& child = moved.children()[0];
    if (place != translation(offset) || child.kind() != Solid::Kind::leaf || child.shape().kind != LeafKind::sphere)
      return std::nullopt;
    const Ball ball{Point{} + offset, child.shape().semi_axes->x};
    if (!is_float(ball.center.x) || !is_float(ball.center.y) || !is_float(ball.center.z) || !is_float(ball.radius))
      return std::nullopt;
    balls.push_back(ball);
  }
  return balls;
}

}  // namespace csgcast::bench
