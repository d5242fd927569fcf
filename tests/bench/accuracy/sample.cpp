// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/sample.h"

#include <cmath>
#include <utility>

#include "tests/bench/accuracy/error.h"

namespace csgcast::bench {
namespace {

constexpr double sideways = 1e-9;
constexpr double nearest_compared = 1e-3;

std::optional<double> first_t(Caster& caster, const Ray& ray) {
  caster.begin(ray);
  const std::optional<Hit> hit = caster.first_hit();
  return hit ? std::optional(hit->crossing.t) : std::nullopt;
}

// The exact answer of a neighbour is wanted; certified predicates give it, many times faster.
FirstHit first_hit(const Sample& sample, Caster& exact, Caster& certified, const Ray& ray) {
  FirstHit hit;
  hit.t = first_t(exact, ray);
  const double reach = sample.size_along(ray);
  hit.is_compared = !hit.t || *hit.t > nearest_compared * reach;
  const Vector d = ray.direction();
  const Vector aside = normalised(cross(d, std::fabs(d.z) < 0.7 * length(d) ? Vector{0, 0, 1} : Vector{1, 0, 0}));
  const Vector up = normalised(cross(d, aside));
  for (const Vector& offset : {aside, -aside, up, -up}) {
    const Ray neighbour(ray.origin() + sideways * sample.size * offset, d);
    hit.is_clear = hit.is_clear && is_same_hit(first_t(certified, neighbour), hit.t, reach);
  }
  return hit;
}

Sample make_sample(stress::Trial trial) {
  Sample sample;
  sample.solid = std::move(trial.solid);
  sample.rays = std::move(trial.rays);
  sample.scene = std::make_unique<const Scene>(compile(sample.solid));
  const Box& box = sample.scene->bounded_leaves();
  if (box.is_finite()) sample.size = length(box.size());
  Caster exact(*sample.scene, exact_predicates());
  Caster certified(*sample.scene);
  for (const Ray& ray : sample.rays) {
    exact.begin(ray);
    exact.intervals(sample.lists.emplace_back());
    sample.first_hits.push_back(first_hit(sample, exact, certified, ray));
  }
  return sample;
}

}  // namespace

std::vector<Sample> make_samples(const stress::Family& family, int rays, int rays_per_scene) {
  std::vector<Sample> samples;
  std::size_t made = 0;
  for (std::uint64_t seed = 1; made < static_cast<std::size_t>(rays); ++seed) {
    test::RandomSolids random(seed);
    stress::Trial trial = family.make(random, rays_per_scene);
    if (trial.rays.empty()) continue;
    made += trial.rays.size();
    samples.push_back(make_sample(std::move(trial)));
  }
  return samples;
}

}  // namespace csgcast::bench
