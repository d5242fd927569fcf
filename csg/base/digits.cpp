// SPDX-License-Identifier: MIT
#include "csg/base/digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

struct Decimal {
  int digits = 0;
  int exponent = 0;  // of the first digit
};

Decimal decimal(double number) {
  CSGCAST_PRECONDITION(std::isfinite(number));
  if (number == 0) return {};
  std::array<char, 32> buffer{};  // the shortest form of a double takes at most 24 characters
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::fabs(number), std::chars_format::scientific).ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t mark = text.find('e');
  Decimal result;
  result.digits = static_cast<int>(mark) - (mark > 1 ? 1 : 0);  // less the point
  const bool is_negative = text[mark + 1] == '-';
  std::from_chars(text.data() + mark + 2, end, result.exponent);
  if (is_negative) result.exponent = -result.exponent;
  return result;
}

double half_unit(const Decimal& number, int digits) { return 0.5 * std::pow(10.0, number.exponent - digits + 1); }

double half_ulp(double number) { return 0x1p-53 * std::fabs(number); }

}  // namespace

int digits_used(double number) { return decimal(number).digits; }

int digits_written(std::string_view number) {
  int count = 0;
  int with_zeros = 0;
  for (const char c : number.substr(0, number.find_first_of("eE"))) {
    if (c < '0' || c > '9' || (c == '0' && with_zeros == 0)) continue;
    ++with_zeros;
    if (c != '0') count = with_zeros;
  }
  return count;
}

bool Digits::uses_all(double number) const { return are_few() && decimal(number).digits == count_; }

bool Digits::uses_all(std::span<const double> numbers) const {
  return are_few() && std::any_of(numbers.begin(), numbers.end(), [this](double number) { return uses_all(number); });
}

double Digits::error(double number) const {
  if (!are_few()) return half_ulp(number);
  constexpr int lost = 2;
  const Decimal shown = decimal(number);
  const bool is_rounded = shown.digits == count_ || (shown.digits >= count_ - lost && shown.digits < count_ &&
                                                     shown.digits > 0 && number != std::trunc(number));
  return half_ulp(number) + (is_rounded ? half_unit(shown, count_) : 0);
}

double Digits::error_beside_longer(double number) const {
  if (!are_few() || number == 0) return half_ulp(number);
  const Decimal shown = decimal(number);
  return half_ulp(number) + (shown.digits <= count_ ? half_unit(shown, count_) : 0);
}

}  // namespace csgcast
