// SPDX-License-Identifier: MIT
#include "tests/stress/trial_run.h"

#include <fmt/format.h>

namespace csgcast::stress {
namespace {

constexpr int rays_a_trial = 50;
constexpr std::size_t most_differences = 1000;

std::string to_text(std::uint64_t seed, const verify::Mismatch& mismatch) {
  const Point o = mismatch.ray.origin();
  const Vector d = mismatch.ray.direction();
  return fmt::format("seed {}: ({:a}, {:a}, {:a}) + t ({:a}, {:a}, {:a}): {}, {}: {}", seed, o.x, o.y, o.z, d.x, d.y,
                     d.z, mismatch.engine, verify::name(mismatch.question), mismatch.difference);
}

}  // namespace

FamilyOutcome run_family(const Family& family, std::uint64_t first_seed, std::uint64_t rays) {
  FamilyOutcome outcome;
  std::vector<verify::Tally> tallies(verify::engines().size());
  std::vector<verify::Mismatch> mismatches;
  do {
    const std::uint64_t seed = first_seed + outcome.trials++;
    test::RandomSolids random(seed);
    const Trial trial = family.make(random, rays_a_trial);
    const Scene scene = compile(trial.solid);
    verify::Comparison comparison(scene);
    mismatches.clear();
    comparison.compare(trial.rays, tallies, mismatches, most_differences - outcome.differences.size());
    for (const verify::Mismatch& mismatch : mismatches) outcome.differences.push_back(to_text(seed, mismatch));
    // A family whose trials have no rays would go on for ever.
  } while (tallies.front().rays < rays && outcome.trials < rays);
  // The definition's own counts, and what any engine got wrong.
  outcome.tally = tallies.front();
  for (const verify::Tally& tally : std::span(tallies).subspan(1)) outcome.tally.wrong += tally.wrong;
  outcome.left_to_caster = tallies[1].flagged;
  return outcome;
}

}  // namespace csgcast::stress
