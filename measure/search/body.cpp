// SPDX-License-Identifier: MIT
#include "measure/search/body.h"

#include <cmath>

#include "csg/base/length.h"
#include "csg/exact/symmetric_eigen.h"

namespace csgcast::detail {
namespace {

// A factor that covers the rounding of sums of positive numbers.
constexpr double rounding_up = 1 + 0x1p-20;
// The rounding of turning and scaling, relative to the sum of the magnitudes of the terms. Coordinates are within 4,
// and mostly within 1, of the frame's center.
constexpr double rounding = 0x1p-46;

}  // namespace

Body& Body::operator+=(const Body& other) {
  moments += other.moments;
  mass_error += other.mass_error;
  for (std::size_t i = 0; i < 3; ++i) first_error[i] += other.first_error[i];
  for (std::size_t i = 0; i < 6; ++i) second_error[i] += other.second_error[i];
  return *this;
}

Body body_of(const Space& space, const Totals& totals, double density) {
  const auto axes = space.axes();
  const Moments& m = totals.moments;
  // Sums of terms of either sign round in proportion to the sum of the magnitudes of the terms.
  const double reach = std::fmax(longest(space.box().lower), longest(space.box().upper));
  const double rounded = rounding * m.volume * std::fmax(reach, reach * reach);
  Body body;
  body.moments.volume = density * m.volume;
  body.mass_error = density * rounding_up * (totals.volume_error + rounding * m.volume);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      body.moments.first[i] += density * axes[k][i] * m.first[k];
      const double error = totals.first_error[k] + rounded;
      body.first_error[i] += density * rounding_up * std::fabs(axes[k][i]) * error;
    }
  }
  for (std::size_t at = 0; at < 6; ++at) {
    const auto [i, j] = Moments::pair[at];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) {
        const std::size_t from = Moments::of_axes(k, l);
        const double factor = density * axes[k][i] * axes[l][j];
        body.moments.second[at] += factor * m.second[from];
        const double error = totals.second_error[from] + rounded;
        body.second_error[at] += rounding_up * std::fabs(factor) * error;
      }
    }
  }
  return body;
}

namespace {

/// Mass, centroid and inertia.
void tell_inertia(const Frame& frame, const Body& body, Measures& measures) {
  const Moments& m = body.moments;
  const double scale = std::ldexp(1.0, frame.exponent);
  const double volume_scale = std::ldexp(1.0, 3 * frame.exponent);
  const double mass = m.volume;
  measures.mass = scaled(volume_scale, mass, body.mass_error);
  if (!(mass > body.mass_error)) {  // then it is not known where the body is, if there is one
    if (body.mass_error > 0) measures.centroid_error = measures.inertia_error = HUGE_VAL;
    return;
  }
  std::array<double, 3> c{};
  std::array<double, 3> c_error{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = m.first[i] / mass;
    const double off = body.first_error[i] + std::fabs(c[i]) * body.mass_error;
    c_error[i] = off / (mass - body.mass_error) + rounding;
    measures.centroid[i] = frame.center[i] + scale * c[i];
    const double error = rounding_up * scale * c_error[i] + 0x1p-52 * std::fabs(measures.centroid[i]);
    measures.centroid_error = std::fmax(measures.centroid_error, error);
  }
  std::array<double, 6> central{};
  std::array<double, 6> central_error{};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    // F_i F_j / mass = F_i c_j.
    const double away = m.first[i] * c[j];
    central[k] = m.second[k] - away;
    central_error[k] = body.second_error[k] + body.first_error[i] * (std::fabs(c[j]) + c_error[j]) +
                       std::fabs(m.first[i]) * c_error[j] + rounding * mass;
  }
  const double inertia_scale = std::ldexp(1.0, 5 * frame.exponent);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    measures.inertia[k] = inertia_scale * (i == j ? central[a] + central[b] : -central[k]);
    const double error = inertia_scale * (i == j ? central_error[a] + central_error[b] : central_error[k]);
    const Measured entry = scaled(1, measures.inertia[k], error);
    measures.inertia_error = std::fmax(measures.inertia_error, entry.error);
  }
}

}  // namespace

void tell_mass(const Frame& frame, const Body& body, Measures& measures) {
  tell_inertia(frame, body, measures);
  const SymmetricEigen eigen = symmetric_eigen(measures.inertia, measures.inertia_error);
  measures.principal_moments = eigen.value;
  measures.principal_error = eigen.value_error;
  measures.principal_axes = eigen.axis;
  measures.principal_angles = eigen.angle;
}

}  // namespace csgcast::detail
