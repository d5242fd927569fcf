// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "csg/base/precondition.h"
#include "csg/base/vector.h"

namespace csgcast::verify {

/// Seeded random numbers, the same on every machine. Cheap to make, so that each block of rays has its own.
/// Source: Steele, Lea and Flood 2014 (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// Makes a separate stream for each pair.
  Random(std::uint64_t seed, std::uint64_t stream) : state_(Random(seed ^ Random(stream).bits()).bits()) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// A number in [low, high).
  double number(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  /// A number in [0, count). Precondition: count > 0.
  std::size_t index(std::size_t count) {
    CSGCAST_PRECONDITION(count > 0);
    return static_cast<std::size_t>(bits() % count);
  }
  double sign() { return index(2) == 0 ? 1 : -1; }
  /// 10^-digits with digits anywhere in [least, most).
  double power_of_tenth(double least, double most) { return std::pow(10.0, -number(least, most)); }
  /// A direction whose length is between 0.1 and 1.8.
  Vector direction() {
    for (;;) {
      const Vector v{number(-1, 1), number(-1, 1), number(-1, 1)};
      if (dot(v, v) > 0.01) return v;
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace csgcast::verify
