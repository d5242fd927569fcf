// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/accuracy/sample.h"

namespace csgcast::bench {

/// How right and how fast one way or program was on one family.
struct Measurement {
  std::string family;
  std::string way;
  std::string query;  ///< "lists" or "first": all intervals from t = 0 on, or the first hit
  std::uint64_t rays = 0;
  std::uint64_t wrong = 0;
  std::optional<std::uint64_t> clear_rays;   ///< of first hits: see FirstHit
  std::optional<std::uint64_t> wrong_clear;  ///< of these, how many are wrong
  double ulps_99 = 0;                        ///< of t, on the rays that are right
  double ulps_most = 0;
  double nanoseconds = 0;  ///< a ray
};

/// All ways of ways.h on a family, for lists and for first hits.
std::vector<Measurement> measure_ways(const std::string& family, std::span<const Sample> samples);
/// The same of exact arithmetic, which the others are compared with: its time.
std::vector<Measurement> measure_exact(const std::string& family, std::span<const Sample> samples);

/// What another program says of the samples' rays, in order, and its time for one.
struct FirstHits {
  std::vector<std::optional<double>> t;
  double nanoseconds = 0;
};
Measurement judge(const std::string& family, const std::string& program, std::span<const Sample> samples,
                  const FirstHits& answer);

}  // namespace csgcast::bench
