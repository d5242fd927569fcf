// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace csgcast {

/// The states of six truth values in which the i-th is true. There is a bit for each state, and bit i of a state is the
/// i-th value.
constexpr std::uint64_t positive_states(std::size_t i) {
  constexpr std::array<std::uint64_t, 6> words{0xaaaaaaaaaaaaaaaau, 0xccccccccccccccccu, 0xf0f0f0f0f0f0f0f0u,
                                               0xff00ff00ff00ff00u, 0xffff0000ffff0000u, 0xffffffff00000000u};
  return words[i];
}

/// A function of up to eight truth values. It is stored as its value in each of their states.
class TruthTable {
 public:
  static constexpr std::size_t most_values = 8;
  static constexpr std::size_t words = std::size_t{1} << (most_values - 6);

  constexpr TruthTable() = default;  ///< false everywhere
  static constexpr TruthTable constant(bool value) {
    TruthTable table;
    table.words_.fill(value ? ~std::uint64_t{0} : 0);
    return table;
  }

  /// A word has 64 states. In word w, the values from the seventh on are the bits of w.
  constexpr std::uint64_t& word(std::size_t w) { return words_[w]; }
  /// The i-th value in the states of a word.
  static constexpr std::uint64_t states_of_word(std::size_t i, std::size_t w) {
    if (i < 6) return positive_states(i);
    return ((w >> (i - 6)) & 1) != 0 ? ~std::uint64_t{0} : 0;
  }

  constexpr bool at(std::size_t state) const { return ((words_[state / 64] >> (state % 64)) & 1) != 0; }
  constexpr bool is_constant() const { return is_never() || is_always(); }
  constexpr bool is_never() const { return *this == constant(false); }
  constexpr bool is_always() const { return *this == constant(true); }
  friend constexpr bool operator==(const TruthTable&, const TruthTable&) = default;

  /// The function with the i-th value fixed. It no longer depends on that value.
  constexpr TruthTable with(std::size_t i, bool value) const {
    TruthTable result;
    for (std::size_t w = 0; w < words; ++w) {
      if (i < 6) {
        const std::uint64_t states = positive_states(i);
        const std::uint64_t shift = std::uint64_t{1} << i;
        result.words_[w] = value ? (words_[w] & states) | (words_[w] & states) >> shift
                                 : (words_[w] & ~states) | (words_[w] & ~states) << shift;
      } else {
        const std::size_t bit = std::size_t{1} << (i - 6);
        result.words_[w] = words_[value ? w | bit : w & ~bit];
      }
    }
    return result;
  }
  constexpr bool depends_on(std::size_t i) const { return !(with(i, false) == with(i, true)); }
  /// `negative` where the i-th value is false, `positive` where it is true.
  static constexpr TruthTable by(std::size_t i, const TruthTable& negative, const TruthTable& positive) {
    TruthTable result;
    for (std::size_t w = 0; w < words; ++w) {
      const std::uint64_t states = states_of_word(i, w);
      result.words_[w] = (positive.words_[w] & states) | (negative.words_[w] & ~states);
    }
    return result;
  }
  /// Replaces the i-th value by the j-th. The function must not depend on the j-th value, unless i = j.
  constexpr TruthTable renamed(std::size_t i, std::size_t j) const {
    return i == j ? *this : by(j, with(i, false), with(i, true));
  }

  friend constexpr TruthTable operator^(TruthTable a, const TruthTable& b) {
    for (std::size_t w = 0; w < words; ++w) a.words_[w] ^= b.words_[w];
    return a;
  }
  friend constexpr TruthTable operator|(TruthTable a, const TruthTable& b) {
    for (std::size_t w = 0; w < words; ++w) a.words_[w] |= b.words_[w];
    return a;
  }
  /// True if there is a state in which a is true and b is not.
  friend constexpr bool exceeds(const TruthTable& a, const TruthTable& b) {
    for (std::size_t w = 0; w < words; ++w) {
      if ((a.words_[w] & ~b.words_[w]) != 0) return true;
    }
    return false;
  }

 private:
  std::array<std::uint64_t, words> words_{};
};

}  // namespace csgcast
