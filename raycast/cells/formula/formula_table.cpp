// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/formula_table.h"

namespace csgcast::detail {

void FormulaTable::tabulate(const Formula& formula, const SurfaceSet& surfaces) {
  count_ = surfaces.size();
  words_.resize(count_ <= 6 ? 1 : std::size_t{1} << (count_ - 6));
  for (std::size_t word = 0; word < words_.size(); ++word) {
    words_[word] = value_(formula.terms, [&](const Term& term) {
      const std::uint64_t positive = TruthTable::states_of_word(surfaces.place_of(term.surface()), word);
      return term.wants_positive() ? positive : ~positive;
    });
  }
}

bool FormulaTable::depends_on(std::size_t i) const {
  const std::size_t flip = std::size_t{1} << i;
  for (std::size_t w = 0; w < words_.size(); ++w) {
    const std::uint64_t other = i < 6 ? words_[w] >> flip : words_[w | flip / 64];
    if (((words_[w] ^ other) & ~TruthTable::states_of_word(i, w)) != 0) return true;
  }
  return false;
}

std::uint64_t FormulaTable::over(std::span<const std::size_t> places) const {
  if (places.size() == count_) return words_.front();
  std::uint64_t result = 0;
  for (std::size_t state = 0; state < 64; ++state) {
    std::size_t wide = 0;
    for (std::size_t i = 0; i < places.size(); ++i) wide |= ((state >> i) & 1) << places[i];
    result |= ((words_[wide / 64] >> (wide % 64)) & 1) << state;
  }
  return result;
}

TruthTable FormulaTable::as_function() const {
  TruthTable table;
  for (std::size_t w = 0; w < TruthTable::words; ++w) table.word(w) = words_[w % words_.size()];
  return table;
}

}  // namespace csgcast::detail
