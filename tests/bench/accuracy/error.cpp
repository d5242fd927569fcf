// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgcast::bench {
namespace {

double last_place(double value) {
  const double magnitude = std::fabs(value);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

}  // namespace

double ulps_off(double t, double exact_t, double size_along) {
  return std::fabs(t - exact_t) / last_place(std::max(std::fabs(exact_t), 1e-3 * size_along));
}

bool has_structure(const IntervalList& list, const IntervalList& exact) {
  return std::equal(list.begin(), list.end(), exact.begin(), exact.end(), [](const Interval& a, const Interval& b) {
    return a.entry.surface == b.entry.surface && a.exit.surface == b.exit.surface;
  });
}

bool is_same_hit(const std::optional<double>& t, const std::optional<double>& exact_t, double size_along) {
  if (!t || !exact_t) return !t && !exact_t;
  return std::fabs(*t - *exact_t) <= std::max(1e-4 * size_along, 16 * last_place(*exact_t));
}

double Errors::percentile_99() const {
  if (ulps_.empty()) return 0;
  std::vector<double> sorted = ulps_;
  const std::size_t place = (99 * sorted.size() + 99) / 100 - 1;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place), sorted.end());
  return sorted[place];
}

double Errors::greatest() const { return ulps_.empty() ? 0 : *std::max_element(ulps_.begin(), ulps_.end()); }

}  // namespace csgcast::bench
