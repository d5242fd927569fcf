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
  std::uint64_t rays = 10'000;  ///< random rays, and as many adversarial ones
  std::uint64_t seed = 1;
  int threads = 0;                   ///< as of on_threads(); 0: those of the present arena
  std::size_t most_mismatches = 10;  ///< how many are kept to be shown
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
  std::vector<KindReport> kinds;          ///< those that the scene has rays of
  std::vector<FoundMismatch> mismatches;  ///< the first ones, in the order in which the rays were made
  /// Over all kinds, for each engine.
  std::vector<Tally> totals() const;
};

/// Compares engines with the exact stage on random rays and on adversarial ones (adversarial_rays.h). Kinds of rays
/// that the scene has no place for are made up for by the others; near the limits of the range there may be fewer.
///
/// The report depends on the scene, the rays and the seed, and not on the number of threads. Memory does not grow with
/// the number of rays. Throws Cancelled.
VerificationReport verify_scene(const Scene& scene, const VerificationOptions& options,
                                std::span<const EngineKind> kinds = engines());

/// How many rays of each sort take seconds rather than minutes: 10,000, fewer where rays meet very many surfaces. Found
/// by counting on a few rays, so it is the same on every machine.
std::uint64_t moderate_ray_count(const Scene& scene);

}  // namespace csgcast::verify
