// SPDX-License-Identifier: MIT
// Millions of queries per second on one thread: 512 x 512 parallel rays across each scene, the best of five passes.
// Usage: bench SCENE.csg ..
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "csg/text/builder.h"
#include "csg/text/reader.h"
#include "raycast/caster.h"

namespace csgcast {
namespace {

constexpr int rays_per_side = 512;
constexpr int passes = 5;

/// Parallel rays along no axis and no diagonal, from outside the box, spread over a square as wide as the box's
/// diagonal.
std::vector<Ray> rays_across(const Box& box) {
  const double diagonal = length(box.size());
  const Vector direction = normalised({-0.61, 0.37, -0.29});
  const Vector right = normalised(cross(direction, {0, 0, 1}));
  const Vector up = cross(right, direction);
  const Point corner = box.center() - diagonal * direction - (diagonal / 2) * (right + up);
  std::vector<Ray> rays;
  rays.reserve(rays_per_side * rays_per_side);
  for (int row = 0; row < rays_per_side; ++row) {
    for (int column = 0; column < rays_per_side; ++column) {
      const double step = diagonal / rays_per_side;
      rays.emplace_back(corner + step * ((column + 0.5) * right + (row + 0.5) * up), direction);
    }
  }
  return rays;
}

/// Millions of rays per second of `query(caster)`.
template <class Query>
double rate(const Scene& scene, const std::vector<Ray>& rays, const Query& query) {
  double best = std::numeric_limits<double>::infinity();
  Caster caster(scene);
  for (int pass = 0; pass < passes; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    for (const Ray& ray : rays) {
      caster.begin(ray);
      query(caster);
    }
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return static_cast<double>(rays.size()) / best * 1e-6;
}

void bench(const std::string& file) {
  const Scene scene = compile(text::build(text::read_file(file)).solid);
  const std::vector<Ray> rays = rays_across(scene.bounded_leaves());
  IntervalList list;
  fmt::print("{:32} {:7} {:10.3f} {:10.3f} {:10.3f}\n", std::filesystem::path(file).stem().string(),
             scene.leaves().size(), rate(scene, rays, [](Caster& caster) { caster.first_hit(); }),
             rate(scene, rays, [](Caster& caster) { caster.any_hit(); }),
             rate(scene, rays, [&list](Caster& caster) { caster.intervals(list); }));
}

}  // namespace
}  // namespace csgcast

int main(int argc, char** argv) {
  try {
    fmt::print("{:32} {:>7} {:>10} {:>10} {:>10}   million rays per second\n", "scene", "leaves", "first hit",
               "any hit", "intervals");
    for (int i = 1; i < argc; ++i) csgcast::bench(argv[i]);
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
