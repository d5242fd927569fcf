// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/ways.h"

#include <vector>

#include "tests/bench/accuracy/textbook_line.h"

namespace csgcast::bench {
namespace {

// Crossings by other formulas, ordered by their computed t, which is also what is reported.
Predicates uncertified_with(decltype(Predicates::crossings) crossings) {
  Predicates table = uncertified_predicates();
  table.crossings = crossings;
  return table;
}

}  // namespace

std::span<const Way> ways() {
  static const std::vector<Way> list{
      {"plain", uncertified_with(plain_crossings)},
      {"Kahan", uncertified_with(kahan_crossings)},
      {"shifted", uncertified_with(shifted_crossings)},
      {"compensated", uncertified_predicates()},
      {"certified", certified_predicates()},
  };
  return list;
}

}  // namespace csgcast::bench
