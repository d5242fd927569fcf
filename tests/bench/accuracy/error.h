// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "raycast/ray/hit.h"

namespace csgcast::bench {

/// How far a t is from the nearest double to the exact one, in units of that one's last place. Close to the ray's
/// origin, where a last place is arbitrarily small, those of a thousandth of `size_along` count.
double ulps_off(double t, double exact_t, double size_along);

/// As many intervals, bounded by the same surfaces.
bool has_structure(const IntervalList& list, const IntervalList& exact);

/// Both nothing, or both within 1e-4 of `size_along`, or of 16 last places where those are coarser.
bool is_same_hit(const std::optional<double>& t, const std::optional<double>& exact_t, double size_along);

/// Errors, for their 99th percentile and their maximum; 0 if there are none.
class Errors {
 public:
  void add(double ulps) { ulps_.push_back(ulps); }
  std::size_t count() const { return ulps_.size(); }
  /// The least error that 99 % of the errors do not exceed.
  double percentile_99() const;
  double greatest() const;

 private:
  std::vector<double> ulps_;
};

}  // namespace csgcast::bench
