// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "csg/base/precondition.h"
#include "csg/base/vector.h"

namespace csgcast {

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

}  // namespace csgcast
