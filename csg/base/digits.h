// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace csgcast {

/// How many significant decimal digits the numbers of a text have at most. Programs that print few digits round, so a
/// number that uses all of them is known to half a unit of its last digit. docs/welding.md has the rule.
///
/// What is not known only decides which faces weld. Each number counts as the double that it is.
class Digits {
 public:
  static constexpr int most = 17;          ///< enough for each double
  static constexpr int fewest_shown = 6;   ///< what a text's numbers must have, to show that they were rounded
  static constexpr int most_rounded = 15;  ///< with more digits a double loses nothing that matters

  constexpr Digits() = default;  ///< of doubles: known to half an ulp
  /// Precondition: 1 <= count <= most.
  explicit constexpr Digits(int count) : count_(static_cast<std::uint8_t>(count)) {}

  constexpr int count() const { return count_; }
  /// False if numbers are known to half an ulp.
  constexpr bool are_few() const { return count_ <= most_rounded; }
  /// Whether the number uses all of the digits, if they are few.
  bool uses_all(double number) const;
  /// Whether one of the numbers does.
  bool uses_all(std::span<const double> numbers) const;

  /// The most that a number may differ from what was meant: half an ulp, and half a unit of the last digit if it uses
  /// all digits, or up to two less and has a fraction: it may have lost zeros at its end. A shorter one is what it
  /// says. Precondition: the number is finite.
  double error(double number) const;
  /// The same for a number in a list or a matrix with others that use all digits: it may have lost any zeros, but if it
  /// is 0 itself.
  double error_beside_longer(double number) const;

  friend constexpr bool operator==(Digits, Digits) = default;

 private:
  std::uint8_t count_ = most;
};

/// The significant decimal digits of the shortest number that reads back to the same double; 0 has none. Precondition:
/// the number is finite.
int digits_used(double number);
/// Those of a number as it is written, without zeros at its begin and end: 3 of `0.01230`, `-123e4` and `1.23`.
int digits_written(std::string_view number);

}  // namespace csgcast
