// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/implications.h"

#include "csg/base/length.h"
#include "csg/base/precondition.h"

namespace csgcast::detail {

void Implications::begin(std::size_t count, Vector half) {
  count_ = count;
  half_ = half;
  any_ = false;
  added_.clear();
  for (std::size_t literal = 0; literal < 2 * count; ++literal) implied_[literal] = Literals().set(literal);
}

// Notes that one literal implies another, and also the contraposition.
void Implications::note(std::size_t literal, std::size_t other) {
  implied_[literal].set(other);
  implied_[other ^ 1].set(literal ^ 1);
  any_ = true;
}

void Implications::add(std::size_t i, const LocalForm& form) {
  if (!is_finite(half_)) return;
  const Likeness own = likeness(form, form, half_);
  const std::uint32_t here = negative_corners(form, half_);
  for (const Added& other : added_) {
    const std::size_t j = other.surface;
    const std::uint32_t there = other.corners;
    const Likeness between = likeness(form, other.form, half_);
    // The corners refute most implications. If rounding makes a sign wrong there, the form is within its slack of 0,
    // and nothing is implied anyway.
    if ((here & ~there) == 0 && implies({form}, {other.form}, half_, between, own)) note(2 * i, 2 * j);
    if ((there & ~here) == 0 && implies({other.form}, {form}, half_, between, other.own)) note(2 * j, 2 * i);
    if ((there & here) == 0 && implies({other.form}, {form, -1}, half_, between, other.own)) note(2 * j, 2 * i + 1);
    if ((there | here) == all_corners && implies({form, -1}, {other.form}, half_, between, own)) note(2 * i + 1, 2 * j);
  }
  added_.push_back({i, form, own, here});
}

TruthTable Implications::impossible_states() const {
  CSGCAST_PRECONDITION(count_ <= TruthTable::most_values);
  TruthTable impossible;
  const auto states = [](std::size_t literal, std::size_t w) {
    const std::uint64_t positive = TruthTable::states_of_word(literal / 2, w);
    return literal % 2 != 0 ? positive : ~positive;
  };
  for (std::size_t a = 0; a < 2 * count_; ++a) {
    for (std::size_t b = 0; b < 2 * count_; ++b) {
      if (b == a || !implied_[a].test(b)) continue;
      for (std::size_t w = 0; w < TruthTable::words; ++w) impossible.word(w) |= states(a, w) & ~states(b, w);
    }
  }
  return impossible;
}

}  // namespace csgcast::detail
