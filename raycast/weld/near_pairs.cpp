// SPDX-License-Identifier: MIT
#include "raycast/weld/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csgcast::detail {
namespace {

constexpr double u = 0x1p-53;
constexpr double most_reach = 0x1p-2;

// A direction in the space of coefficients. It may be any direction in which two different surfaces of a scene are
// unlikely to agree.
constexpr std::array<double, QuadricForm::term_count> weight{0.8147, 0.5479, 0.9661, 0.6324, 0.7278,
                                                             0.4218, 0.9157, 0.6787, 0.5822, 0.8491};

}  // namespace

void NearPairs::add(std::uint32_t surface, const RegionForm& form, const FormError& error) {
  if (surface >= ranges_.size()) ranges_.resize(surface + 1);
  if (!form.in_range) return;
  double norm = 0;
  double sum = 0;
  double off = 0;
  double off_norm = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const double c = form.coefficient[i].high;
    norm += c * c;
    sum += weight[i] * c;
    off += weight[i] * error[i];
    off_norm += error[i];
  }
  norm = std::sqrt(norm);
  // The sum is off by at most `off`, and the norm by at most the sum of the errors. 64 u covers the rounding of both.
  const double reach = off / norm + std::fabs(sum) / norm * (off_norm / norm) + 64 * u;
  if (reach <= most_reach) ranges_[surface] = {std::fabs(sum) / norm, reach};
}

bool NearPairs::overlap(std::uint32_t a, std::uint32_t b) const {
  const Range& x = ranges_[a];
  const Range& y = ranges_[b];
  if (x.reach < 0 || y.reach < 0) return false;
  const double reach = x.reach + y.reach;
  return std::fabs(x.middle - y.middle) <= reach || x.middle + y.middle <= reach;
}

Grouping::Groups NearPairs::groups() const {
  struct Entry {
    double low;
    double high;
    std::uint32_t surface;
  };
  std::vector<Entry> entries;
  for (std::uint32_t i = 0; i < ranges_.size(); ++i) {
    const auto [middle, reach] = ranges_[i];
    if (reach < 0) continue;
    entries.push_back({middle - reach, middle + reach, i});
    if (middle <= reach) entries.push_back({-middle - reach, -middle + reach, i});  // the sign is open
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.low != b.low ? a.low < b.low : a.surface < b.surface; });
  Grouping grouping(ranges_.size());
  double reached = -1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0 && entries[i].low <= reached) grouping.join(entries[i - 1].surface, entries[i].surface);
    reached = i == 0 ? entries[i].high : std::fmax(reached, entries[i].high);
  }
  return grouping.groups([this](std::uint32_t i) { return ranges_[i].reach >= 0; });
}

}  // namespace csgcast::detail
