// SPDX-License-Identifier: MIT
#include "csg/base/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/base/length.h"

namespace csgcast {
namespace {

constexpr double half_sqrt3 = std::numbers::sqrt3 / 2;
constexpr double half_sqrt2 = std::numbers::sqrt2 / 2;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// Sine of an angle in [0, 90] degrees.
double sin_of_acute(double degrees) {
  if (degrees == 30) return 0.5;
  if (degrees == 45) return half_sqrt2;
  if (degrees == 60) return half_sqrt3;
  return degrees > 45 ? std::cos(radians(90 - degrees)) : std::sin(radians(degrees));
}

// A power of two brings the largest component near 1. If it is the only component it becomes exactly 1, and then every
// product below is exact.
Vector scaled_axis(Vector v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  const bool only_one = (v.x != 0) + (v.y != 0) + (v.z != 0) == 1;
  if (only_one) return {v.x / largest, v.y / largest, v.z / largest};
  const int exponent = std::ilogb(largest);
  return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

constexpr double u = 0x1p-53;

// How far an angle is off, in degrees. For more than a turn only the last turn counts, because 1e20 degrees in a text
// means exactly that number.
double angle_error(double degrees, Digits digits) {
  const double beyond_rounding = digits.are_few() && std::isfinite(degrees) ? digits.error(degrees) : 0;
  return std::fmax(u * std::fmin(std::fabs(degrees), 360), beyond_rounding);
}

// How far the coordinates of an axis are off, relative to its length, in units of 2^-53.
double axis_error(Vector axis, Digits digits) {
  if (!digits.are_few()) return 1;
  const double most = std::max({digits.error(axis.x), digits.error(axis.y), digits.error(axis.z)});
  return std::fmax(1, most / length(axis) / u);
}

// The error of an entry of a rotation. An error of the angle moves it by at most that in radians. A sine or cosine is
// off by at most 4 u: two roundings and the error of pi on the way to at most pi/4 radians, and the function's last
// bit. Three of them, four products and a sum about axes are off by at most 20. About one axis there are 12 for each
// unit of the axis's error.
double rotation_error(double off_degrees, double roundings) { return u * roundings + radians(off_degrees); }

bool has_direction(Vector v) { return v != Vector{} && is_finite(v); }

}  // namespace

bool Transform::is_finite() const {
  return std::all_of(entry.begin(), entry.end(), [](double e) { return std::isfinite(e); });
}

// All reductions below are exact: fmod always is, and so is a difference of numbers within a factor of two of each
// other.
double sin_degrees(double degrees) {
  double angle = std::fabs(std::fmod(degrees, 360));
  bool negative = degrees < 0;
  if (angle > 180) {
    angle = 360 - angle;
    negative = !negative;
  }
  if (angle > 90) angle = 180 - angle;
  const double sine = sin_of_acute(angle);
  return negative && sine != 0 ? -sine : sine;
}

double cos_degrees(double degrees) {
  double angle = std::fabs(std::fmod(degrees, 360));
  if (angle > 180) angle = 360 - angle;
  const bool negative = angle > 90;
  if (negative) angle = 180 - angle;
  // 90 - angle is exact only from 45 upward. Below that the cosine is computed directly.
  double cosine = 0;
  if (angle >= 45) {
    cosine = sin_of_acute(90 - angle);
  } else {
    cosine = angle == 30 ? half_sqrt3 : std::cos(radians(angle));
  }
  return negative ? -cosine : cosine;
}

std::array<double, 12> Transform::errors() const {
  const bool has_longest = digits.uses_all(entry);
  const auto is_alone = [this](std::size_t row, std::size_t column) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((k != column && (*this)(row, k) != 0) || (k != row && (*this)(k, column) != 0)) return false;
    }
    return true;
  };
  std::array<double, 12> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double e = (*this)(row, column);
      const bool by_itself = !has_longest || (column < 3 && is_alone(row, column));
      result[4 * row + column] =
          (by_itself ? digits.error(e) : digits.error_beside_longer(e)) + (column < 3 ? linear_error : offset_error);
    }
  }
  return result;
}

Transform translation(Vector offset, Digits digits) {
  return {.entry = {1, 0, 0, offset.x, 0, 1, 0, offset.y, 0, 0, 1, offset.z}, .digits = digits};
}

Transform scaling(Vector factors, Digits digits) {
  return {.entry = {factors.x, 0, 0, 0, 0, factors.y, 0, 0, 0, 0, factors.z, 0}, .digits = digits};
}

Transform rotation(Vector degrees_about_axes, Digits digits) {
  const double sx = sin_degrees(degrees_about_axes.x), cx = cos_degrees(degrees_about_axes.x);
  const double sy = sin_degrees(degrees_about_axes.y), cy = cos_degrees(degrees_about_axes.y);
  const double sz = sin_degrees(degrees_about_axes.z), cz = cos_degrees(degrees_about_axes.z);
  // Rz * Ry * Rx.
  return {{cy * cz, sx * sy * cz - cx * sz, cx * sy * cz + sx * sz, 0,  //
           cy * sz, sx * sy * sz + cx * cz, cx * sy * sz - sx * cz, 0,  //
           -sy, sx * cy, cx * cy, 0},
          rotation_error(angle_error(degrees_about_axes.x, digits) + angle_error(degrees_about_axes.y, digits) +
                             angle_error(degrees_about_axes.z, digits),
                         20)};
}

Transform rotation(double degrees, Vector axis, Digits digits) {
  if (!has_direction(axis)) return {};
  // Rodrigues' formula, each entry over |v|², so that small integer axes lose nothing before the division.
  const Vector v = scaled_axis(axis);
  const double square = dot(v, v);
  const double c = cos_degrees(degrees);
  const double s = sin_degrees(degrees) / std::sqrt(square);
  const double k = 1 - c;
  const double xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
  const double xy = k * (v.x * v.y) / square, xz = k * (v.x * v.z) / square, yz = k * (v.y * v.z) / square;
  return {{(xx + c * (yy + zz)) / square, xy - s * v.z, xz + s * v.y, 0,  //
           xy + s * v.z, (yy + c * (xx + zz)) / square, yz - s * v.x, 0,  //
           xz - s * v.y, yz + s * v.x, (zz + c * (xx + yy)) / square, 0},
          rotation_error(angle_error(degrees, digits), 4 + 12 * axis_error(axis, digits))};
}

Transform mirroring(Vector normal, Digits digits) {
  if (!has_direction(normal)) return {};
  const Vector n = scaled_axis(normal);
  const double square = dot(n, n);
  const auto off_diagonal = [square](double a, double b) { return -2 * (a * b) / square; };
  // 1 - 2 a² / |n|² without the cancellation.
  const auto diagonal = [square](double a, double b, double c) { return (b * b + c * c - a * a) / square; };
  const double xy = off_diagonal(n.x, n.y), xz = off_diagonal(n.x, n.z), yz = off_diagonal(n.y, n.z);
  return {{diagonal(n.x, n.y, n.z), xy, xz, 0,  //
           xy, diagonal(n.y, n.z, n.x), yz, 0,  //
           xz, yz, diagonal(n.z, n.x, n.y), 0},
          rotation_error(0, 12 * axis_error(normal, digits))};
}

}  // namespace csgcast
