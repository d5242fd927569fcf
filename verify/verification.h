// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "csg/base/progress.h"
#include "verify/comparison.h"

namespace csgcast::verify {

struct VerificationOptions {
  std::uint64_t rays = 10'000;  ///< the number of random rays, and of adversarial ones
  std::uint64_t seed = 1;
  int threads = 0;                   ///< as for on_threads(); 0 means the threads of the present arena
  std::size_t most_mismatches = 10;  ///< the number of mismatches that are kept to be shown
  ProgressCallback progress{};
};

/// The counts of one kind of rays, for each engine.
struct KindReport {
  std::string_view kind;
  std::vector<Tally> tallies;
};

struct FoundMismatch {
  std::string_view kind;
  Mismatch mismatch;
};

struct VerificationReport {
  std::vector<std::string_view> engines;
  std::vector<KindReport> kinds;          ///< the kinds that the scene has rays of
  std::vector<FoundMismatch> mismatches;  ///< the first ones, in the order in which the rays were made
  /// The sums over all kinds, for each engine.
  std::vector<Tally> totals() const;
};

/// Compares engines with the exact stage on random rays and on adversarial ones (adversarial_rays.h). If the scene has
/// no place for some kinds of rays, there are more rays of the other kinds. Near the limits of the range there may be
/// fewer rays.
///
/// The report depends on the scene, the number of rays and the seed, and not on the number of threads. Memory does not
/// grow with the number of rays. Throws Cancelled.
VerificationReport verify_scene(const Scene& scene, const VerificationOptions& options,
                                std::span<const EngineKind> kinds = engines());

/// The number of rays of each sort that takes seconds rather than minutes: 10,000, or fewer if rays meet very many
/// surfaces. It is found by counting the work of a few rays, so it is the same on every machine.
std::uint64_t moderate_ray_count(const Scene& scene);

}  // namespace csgcast::verify
