// SPDX-License-Identifier: MIT
#include "tests/measure/revolved.h"

#include <cmath>
#include <numbers>

namespace csgcast::test {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

// Gauss's rule with five points on 64 parts: exact for polynomials up to degree 9.
template <class F>
long double integral(double from, double to, F&& f) {
  static const long double root = std::sqrt(10.0L / 7);
  const std::array<long double, 5> node{0, std::sqrt(5 - 2 * root) / 3, -std::sqrt(5 - 2 * root) / 3,
                                        std::sqrt(5 + 2 * root) / 3, -std::sqrt(5 + 2 * root) / 3};
  const long double s = 13 * std::sqrt(70.0L);
  const std::array<long double, 5> weight{128.0L / 225, (322 + s) / 900, (322 + s) / 900, (322 - s) / 900,
                                          (322 - s) / 900};
  constexpr int parts = 64;
  const long double half = (static_cast<long double>(to) - from) / parts / 2;
  long double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const long double middle = from + half * (2 * i + 1);
    for (std::size_t k = 0; k < 5; ++k) sum += half * weight[k] * f(middle + half * node[k]);
  }
  return sum;
}

// 2 pi r sqrt(1 + r'²) = 2 pi sqrt(q + q'² / 4) for q = r².
long double side_area(double from, double to, const Square& q) {
  return integral(from, to, [&](long double z) {
    const long double slope = q.c1 + 2 * q.c2 * z;
    return 2 * pi * std::sqrt(q.at(z) + slope * slope / 4);
  });
}

}  // namespace

Known Profile::known() const {
  long double volume = 0, z1 = 0, z2 = 0, radial = 0, area = flat_area;  // radial: of x² + y²
  for (const Slice& s : slices) {
    const auto ring = [&](long double z) { return pi * (s.outer.at(z) - s.inner.at(z)); };
    volume += integral(s.from, s.to, ring);
    z1 += integral(s.from, s.to, [&](long double z) { return z * ring(z); });
    z2 += integral(s.from, s.to, [&](long double z) { return z * z * ring(z); });
    radial += integral(s.from, s.to, [&](long double z) {
      return pi / 2 * (s.outer.at(z) * s.outer.at(z) - s.inner.at(z) * s.inner.at(z));
    });
    if (s.outer_is_face) area += side_area(s.from, s.to, s.outer);
    const bool has_inner = s.inner.c0 != 0 || s.inner.c1 != 0 || s.inner.c2 != 0;
    if (has_inner && s.inner_is_face) area += side_area(s.from, s.to, s.inner);
  }
  const long double across = radial / 2 + z2 - z1 * z1 / volume;
  Known known;
  known.volume = static_cast<double>(volume);
  known.area = static_cast<double>(area);
  known.centroid = {0, 0, static_cast<double>(z1 / volume)};
  known.inertia = {static_cast<double>(across), static_cast<double>(across), static_cast<double>(radial), 0, 0, 0};
  return known;
}

Known moved(const Known& known, const Transform& t) {
  Known result = known;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centroid[i] = t(i, 3);
    for (std::size_t j = 0; j < 3; ++j) result.centroid[i] += t(i, j) * known.centroid[j];
  }
  const auto entry = [&](std::size_t i, std::size_t j) { return known.inertia[i == j ? i : i + j + 2]; };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) sum += t(i, k) * entry(k, l) * t(j, l);
      }
      result.inertia[i == j ? i : i + j + 2] = sum;
    }
  }
  return result;
}

}  // namespace csgcast::test
