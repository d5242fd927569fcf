// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "csg/base/precondition.h"

namespace csgcast {

/// Three doubles with a meaning: points, vectors and normals do not convert into each other.
template <class Tag>
struct Triple {
  double x = 0;
  double y = 0;
  double z = 0;

  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Triple&, const Triple&) = default;
};

/// A place in space, in the scene's unit of length.
using Point = Triple<struct PointTag>;
/// A difference of points; need not be unit.
using Vector = Triple<struct VectorTag>;
/// A direction square to a surface, of unit length where it is returned by a query.
using Normal = Triple<struct NormalTag>;

constexpr Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point operator+(Point a, Vector v) { return {a.x + v.x, a.y + v.y, a.z + v.z}; }
constexpr Point operator-(Point a, Vector v) { return {a.x - v.x, a.y - v.y, a.z - v.z}; }
constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Normal operator-(Normal a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector as_vector(Normal n) { return {n.x, n.y, n.z}; }
constexpr Vector as_vector(Point p) { return {p.x, p.y, p.z}; }

template <class A, class B>
constexpr double dot(Triple<A> a, Triple<B> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Length without overflow or underflow.
template <class Tag>
double length(Triple<Tag> a) {
  return std::hypot(a.x, a.y, a.z);
}

/// The magnitude of the longest coordinate. Precondition: none is NaN.
template <class Tag>
double longest(Triple<Tag> a) {
  CSGCAST_PRECONDITION(!std::isnan(a.x) && !std::isnan(a.y) && !std::isnan(a.z));
  return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

template <class Tag>
bool is_finite(Triple<Tag> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// v / |v|, safe against overflow and underflow; the zero vector stays zero.
inline Vector normalised(Vector v) {
  const double largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const int exponent = std::ilogb(largest);
  const Vector scaled{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  return (1 / std::sqrt(dot(scaled, scaled))) * scaled;
}

constexpr Normal as_normal(Vector v) { return {v.x, v.y, v.z}; }

}  // namespace csgcast
