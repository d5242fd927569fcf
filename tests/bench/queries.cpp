// SPDX-License-Identifier: MIT
// Millions of queries per second on one thread: 512 x 512 parallel rays across each scene, the best of five passes.
// Usage: bench_queries SCENE.csg ..
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/ray/caster.h"
#include "tests/bench/rays_across.h"

namespace csgcast {
namespace {

constexpr int rays_per_side = 512;
constexpr int passes = 5;

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

void report(const std::string& file) {
  const Scene scene = compile(text::build(text::read_file(file)).solid, Welding::derived());
  const std::vector<Ray> rays =
      bench::rays_across(scene.bounded_leaves(), normalised({-0.61, 0.37, -0.29}), rays_per_side);
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
    for (int i = 1; i < argc; ++i) csgcast::report(argv[i]);
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
