// SPDX-License-Identifier: MIT
#include "csg/text/syntax/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace csgcast::text {
namespace {

/// Optimal string alignment distance; three rows of the table are enough.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_back(b.size() + 1), back(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_back.swap(back);
    back.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = back[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, back[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], two_back[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest_word(std::string_view misspelt, std::span<const std::string_view> known) {
  constexpr std::size_t longest = 40;  // no known word is longer
  if (misspelt.size() > longest) return {};
  std::size_t least = std::min<std::size_t>(2, std::max<std::size_t>(1, misspelt.size() / 3)) + 1;
  std::string_view nearest;
  for (const std::string_view word : known) {
    const std::size_t distance = edit_distance(misspelt, word);
    if (distance >= least || distance >= word.size()) continue;
    least = distance;
    nearest = word;
  }
  return nearest;
}

std::string did_you_mean(std::string_view misspelt, std::span<const std::string_view> known, std::string otherwise) {
  const std::string_view nearest = nearest_word(misspelt, known);
  return nearest.empty() ? otherwise : fmt::format("did you mean '{}'?", nearest);
}

}  // namespace csgcast::text
