// SPDX-License-Identifier: MIT
#include "csg/base/transform.h"

#include <cmath>
#include <limits>
#include <random>

#include "csg/exact/affine.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

// The largest entry of M Mᵀ - 1: how far from a rigid map.
double distance_from_orthogonal(const Transform& m) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += m(i, k) * m(j, k);
      largest = std::fmax(largest, std::fabs(sum));
    }
  }
  return largest;
}

Point applied(const Transform& m, Point p) {
  Point q;
  for (std::size_t i = 0; i < 3; ++i) q[i] = m(i, 0) * p.x + m(i, 1) * p.y + m(i, 2) * p.z + m(i, 3);
  return q;
}

}  // namespace

TEST_CASE("sines and cosines of multiples of 30 and 45 degrees are the nearest doubles") {
  const double half_sqrt3 = std::sqrt(3.0) / 2, half_sqrt2 = std::sqrt(0.5);
  CHECK(sin_degrees(0) == 0);
  CHECK(sin_degrees(30) == 0.5);
  CHECK(sin_degrees(45) == half_sqrt2);
  CHECK(sin_degrees(60) == half_sqrt3);
  CHECK(sin_degrees(90) == 1);
  CHECK(sin_degrees(120) == half_sqrt3);
  CHECK(sin_degrees(180) == 0);
  CHECK(sin_degrees(210) == -0.5);
  CHECK(sin_degrees(270) == -1);
  CHECK(cos_degrees(0) == 1);
  CHECK(cos_degrees(30) == half_sqrt3);
  CHECK(cos_degrees(45) == half_sqrt2);
  CHECK(cos_degrees(60) == 0.5);
  CHECK(cos_degrees(90) == 0);
  CHECK(cos_degrees(120) == -0.5);
  CHECK(cos_degrees(180) == -1);
  CHECK(cos_degrees(300) == 0.5);
}

TEST_CASE("sine is odd, cosine is even, and a full turn changes neither") {
  for (int k = -720; k <= 720; ++k) {
    const double angle = k;
    CAPTURE(angle);
    CHECK(sin_degrees(-angle) == -sin_degrees(angle));
    CHECK(cos_degrees(-angle) == cos_degrees(angle));
    CHECK(sin_degrees(angle + 360) == sin_degrees(angle));
    CHECK(cos_degrees(angle + 360) == cos_degrees(angle));
    CHECK(sin_degrees(180 - angle) == sin_degrees(angle));
    CHECK(cos_degrees(90 - angle) == sin_degrees(angle));
  }
}

TEST_CASE("sines of random angles agree with the library's to two units in the last place of 1") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-360, 360);
  for (int i = 0; i < 1000; ++i) {
    const double a = angle(random);
    CAPTURE(a);
    const long double exact = static_cast<long double>(a) * 3.14159265358979323846264338327950288L / 180;
    CHECK(std::fabs(sin_degrees(a) - static_cast<double>(std::sin(exact))) <= 0x1p-52);
    CHECK(std::fabs(cos_degrees(a) - static_cast<double>(std::cos(exact))) <= 0x1p-52);
  }
}

TEST_CASE("a quarter turn is exact about every axis and right-handed") {
  CHECK(rotation({90, 0, 0}) == Transform{{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}});
  CHECK(rotation({0, 90, 0}) == Transform{{0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0}});
  CHECK(rotation({0, 0, 90}) == Transform{{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}});
  CHECK(rotation(90, {0, 0, 7}) == rotation({0, 0, 90}));
  CHECK(rotation(-90, {0, -0.3, 0}) == rotation({0, 90, 0}));
}

TEST_CASE("angles about the axes turn about x first and about z last") {
  const Point p = applied(rotation({90, 0, 90}), {0, 1, 0});
  CHECK(p == Point{0, 0, 1});  // y goes to z, which the turn about z keeps
  CHECK(applied(rotation({0, 90, 90}), {1, 0, 0}) == Point{0, 0, -1});
}

TEST_CASE("a third of a turn about the diagonal permutes the axes exactly") {
  CHECK(rotation(120, {1, 1, 1}) == Transform{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}});
}

TEST_CASE("turning about an axis agrees with turning about the same coordinate axis") {
  for (int degrees = -180; degrees <= 180; degrees += 7) {
    CHECK(rotation(degrees, {5, 0, 0}) == rotation({static_cast<double>(degrees), 0, 0}));
    CHECK(rotation(degrees, {0, 0, 1e-200}) == rotation({0, 0, static_cast<double>(degrees)}));
  }
}

TEST_CASE("rotations and mirrors are rigid to a few units in the last place, for axes of any length") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const double length = std::ldexp(1.0, static_cast<int>(random() % 2000) - 1000);
    const Vector axis = length * Vector{number(random), number(random), number(random)};
    CHECK(distance_from_orthogonal(rotation(360 * number(random), axis)) <= 0x1p-49);
    CHECK(distance_from_orthogonal(mirroring(axis)) <= 0x1p-49);
    CHECK(ExactAffine(mirroring(axis)).determinant().sign() < 0);
  }
}

TEST_CASE("mirrors in axis-aligned and diagonal planes are exact") {
  CHECK(mirroring({0, 0.1, 0}) == scaling({1, -1, 1}));
  CHECK(mirroring({1, 1, 0}) == Transform{{0, -1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0}});
}

TEST_CASE("an axis without a direction gives the identity") {
  CHECK(rotation(30, {0, 0, 0}).is_identity());
  CHECK(mirroring({0, 0, 0}).is_identity());
}

TEST_CASE("translation and scaling put their numbers where they belong") {
  CHECK(applied(translation({1, 2, 3}), {10, 20, 30}) == Point{11, 22, 33});
  CHECK(applied(scaling({2, 3, 4}), {1, 1, 1}) == Point{2, 3, 4});
  CHECK(translation({}).is_identity());
  CHECK_FALSE(scaling({1, 1, 2}).is_identity());
}

TEST_CASE("a transform with a number that is not finite says so") {
  CHECK(translation({1, 2, 3}).is_finite());
  CHECK_FALSE(translation({1, std::numeric_limits<double>::infinity(), 3}).is_finite());
  CHECK_FALSE(scaling({std::numeric_limits<double>::quiet_NaN(), 1, 1}).is_finite());
}
