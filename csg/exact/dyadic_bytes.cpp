// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csg/exact/dyadic.h"

// A packed number has three parts: twice the number of bytes of its mantissa, plus one if it is negative; the exponent
// with its sign in the lowest bit; and the mantissa's bytes, the lowest first. The first two parts have seven bits in
// each byte, the lowest first, and the highest bit says that more bytes follow. Zero is a single byte.

namespace csgcast {
namespace {

constexpr unsigned bits_of_byte = 8;
constexpr unsigned bits_of_digit = 7;
constexpr std::uint64_t more = 1u << bits_of_digit;

void append_count(std::uint64_t value, std::vector<std::byte>& bytes) {
  for (; value >= more; value >>= bits_of_digit) bytes.push_back(static_cast<std::byte>(value | more));
  bytes.push_back(static_cast<std::byte>(value));
}

std::uint64_t read_count(const std::byte*& bytes) {
  std::uint64_t value = 0;
  for (unsigned shift = 0;; shift += bits_of_digit) {
    const auto digit = static_cast<std::uint64_t>(*bytes++);
    value |= (digit & (more - 1)) << shift;
    if (digit < more) return value;
  }
}

}  // namespace

void Dyadic::pack(std::vector<std::byte>& bytes) const {
  if (is_zero()) return bytes.push_back(std::byte{0});
  const std::size_t count = (bits() + bits_of_byte - 1) / bits_of_byte;
  append_count(2 * count + (sign() < 0 ? 1 : 0), bytes);
  const auto magnitude = static_cast<std::uint64_t>(exponent_ < 0 ? -exponent_ : exponent_);
  append_count(2 * magnitude + (exponent_ < 0 ? 1 : 0), bytes);
  const std::size_t start = bytes.size();
  bytes.resize(start + count);
  if (large_) {
    mpz_export(&bytes[start], nullptr, -1, 1, 0, 0, large_->get_mpz_t());
    return;
  }
  Bits rest = absolute(small_);
  for (std::size_t i = start; i < bytes.size(); ++i, rest >>= bits_of_byte) bytes[i] = static_cast<std::byte>(rest);
}

Dyadic Dyadic::unpack(const std::byte*& bytes) {
  const std::uint64_t head = read_count(bytes);
  if (head == 0) return {};
  const std::size_t count = head / 2;
  const std::uint64_t tail = read_count(bytes);
  const auto exponent = static_cast<std::int64_t>(tail / 2);
  Dyadic result;
  result.exponent_ = tail % 2 != 0 ? -exponent : exponent;
  if (count < sizeof(Small)) {
    Bits magnitude = 0;
    for (std::size_t i = count; i-- > 0;) magnitude = magnitude << bits_of_byte | static_cast<Bits>(bytes[i]);
    result.small_ = static_cast<Small>(magnitude);
  } else {
    result.large_ = std::make_unique<mpz_class>();
    mpz_import(result.large_->get_mpz_t(), count, -1, 1, 0, 0, bytes);
    result.normalise();  // the object holds mantissas below 128 bits itself
  }
  bytes += count;
  return head % 2 != 0 ? -result : result;
}

}  // namespace csgcast
