// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/sample.h"

#include <cmath>
#include <utility>

#include "tests/bench/accuracy/error.h"
#include "tests/bench/accuracy/stopwatch.h"

namespace csgcast::bench {
namespace {

constexpr double sideways = 1e-9;
constexpr double nearest_compared = 1e-3;

std::optional<double> first_t(Caster& caster, const Ray& ray) {
  caster.begin(ray);
  const std::optional<Hit> hit = caster.first_hit();
  return hit ? std::optional(hit->crossing.t) : std::nullopt;
}

// Whether four neighbours of the ray hit the same. Certified predicates give the exact answer, many times faster.
bool is_clear(const Sample& sample, Caster& certified, const Ray& ray, const std::optional<double>& t) {
  const Vector d = ray.direction();
  const Vector aside = normalised(cross(d, std::fabs(d.z) < 0.7 * length(d) ? Vector{0, 0, 1} : Vector{1, 0, 0}));
  const Vector up = normalised(cross(d, aside));
  for (const Vector& offset : {aside, -aside, up, -up}) {
    const Ray neighbour(ray.origin() + sideways * sample.size * offset, d);
    if (!is_same_hit(first_t(certified, neighbour), t, sample.size_along(ray))) return false;
  }
  return true;
}

void add_lists(Sample& sample) {
  Caster exact(*sample.scene, exact_predicates());
  sample.lists.resize(sample.rays.size());
  const Stopwatch watch;
  for (std::size_t i = 0; i < sample.rays.size(); ++i) {
    exact.begin(sample.rays[i]);
    exact.intervals(sample.lists[i]);
  }
  sample.exact_list_seconds = watch.seconds();
}

void add_first_hits(Sample& sample) {
  Caster exact(*sample.scene, exact_predicates());
  const Stopwatch watch;
  for (const Ray& ray : sample.rays) sample.first_hits.push_back({first_t(exact, ray)});
  sample.exact_first_seconds = watch.seconds();
  Caster certified(*sample.scene);
  for (std::size_t i = 0; i < sample.rays.size(); ++i) {
    FirstHit& hit = sample.first_hits[i];
    hit.is_compared = !hit.t || *hit.t > nearest_compared * sample.size_along(sample.rays[i]);
    hit.is_clear = is_clear(sample, certified, sample.rays[i], hit.t);
  }
}

Sample make_sample(stress::Trial trial) {
  Sample sample;
  sample.solid = std::move(trial.solid);
  sample.rays = std::move(trial.rays);
  sample.scene = std::make_unique<const Scene>(compile(sample.solid));
  const Box& box = sample.scene->bounded_leaves();
  if (box.is_finite()) sample.size = length(box.size());
  add_lists(sample);
  add_first_hits(sample);
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
