// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/far_form.h"

#include <algorithm>
#include <cmath>

#include "csg/exact/dyadic.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;

// The coefficients are rounded, and so are some twenty operations: both come to less than 2^-47 of all terms together.
constexpr double tolerance = 0x1p-46;

Truth told(double lower, double upper) {
  if (lower > 0) return Truth::no;
  return upper < 0 ? Truth::yes : Truth::unknown;
}

// The same of q + w r for 0 < w <= most: where q does not have the other sign, that of r decides.
Truth told(double q_lower, double q_upper, double r_lower, double r_upper, double most) {
  if (q_lower >= 0 && r_lower > 0) return Truth::no;
  if (q_upper <= 0 && r_upper < 0) return Truth::yes;
  return told(q_lower + std::fmin(most * r_lower, 0), q_upper + std::fmax(most * r_upper, 0));
}

}  // namespace

FarForm::FarForm(const QuadricForm& form, const Region& region) : is_plane_(form.is_plane()) {
  const ExactPoint center{region.center.x, region.center.y, region.center.z};
  in_range_ = round_scaled(in_coordinates(form, center, region.exponent), c_);
  if (is_plane_) return;
  if (is_convex(form)) definite_ = 1;
  if (is_convex(-form)) definite_ = -1;
}

FarForm::Range FarForm::second_degree(Vector middle, Vector half) const {
  double value = 0, deviation = 0, terms = 0, low = 0, high = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double slope = 0;
    for (std::size_t l = 0; l < 3; ++l) {
      const double c = c_[Form::second_degree(k, l)];
      if (c == 0) continue;
      const double own = k == l ? c : 0.5 * c;
      value += own * middle[k] * middle[l];
      slope += 2 * own * middle[l];
      terms += std::fabs(own) * (std::fabs(middle[k]) + half[k]) * (std::fabs(middle[l]) + half[l]);
      if (k == l) {
        (c < 0 ? low : high) += c * half[k] * half[k];
      } else {
        deviation += std::fabs(own) * half[k] * half[l];
      }
    }
    deviation += std::fabs(slope) * half[k];
  }
  const double slack = tolerance * terms;
  Range range{value - deviation + low - slack, value + deviation + high + slack};
  if (definite_ > 0) range.lower = std::fmax(range.lower, 0);
  if (definite_ < 0) range.upper = std::fmin(range.upper, 0);
  return range;
}

FarForm::Range FarForm::first_degree(Vector middle, Vector half) const {
  double value = 0, deviation = 0, terms = 0;
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = c_[Form::x + k];
    if (c == 0) continue;
    ++count;
    value += c * middle[k];
    deviation += std::fabs(c) * half[k];
    terms += std::fabs(c) * (std::fabs(middle[k]) + half[k]);
  }
  // Bounds of parts are dyadic numbers of few bits. So the sign of a single product is right.
  const double slack = count > 1 ? tolerance * terms : 0;
  return {value - deviation - slack, value + deviation + slack};
}

Truth FarForm::is_negative(const FarPart& part) const {
  if (!in_range_) return Truth::unknown;
  const Range l = first_degree(part.middle, part.half);
  const double c = c_[Form::one];
  if (is_plane_) return told(l.lower, l.upper, c, c, part.w);
  const Range q = second_degree(part.middle, part.half);
  // l + w c, whose slack covers that of c.
  const double slack = tolerance * std::fabs(part.w * c);
  const Range rest{l.lower + std::fmin(part.w * c, 0) - slack * (c < 0 ? 1 : 0),
                   l.upper + std::fmax(part.w * c, 0) + slack * (c > 0 ? 1 : 0)};
  return told(q.lower, q.upper, rest.lower, rest.upper, part.w);
}

Truth FarForm::is_negative_in(Vector middle, Vector half) const {
  if (!in_range_) return Truth::unknown;
  const Range l = first_degree(middle, half);
  const double c = c_[Form::one];
  const double slack = tolerance * std::fabs(c);
  if (is_plane_) return told(l.lower + c - slack, l.upper + c + slack);
  const Range q = second_degree(middle, half);
  return told(q.lower + l.lower + c - slack, q.upper + l.upper + c + slack);
}

double FarForm::distance() const {
  double q = 0, l = 0;
  for (std::size_t i = 0; i < Form::x; ++i) q += std::fabs(c_[i]);
  for (std::size_t k = 0; k < 3; ++k) l += std::fabs(c_[Form::x + k]);
  const double c = std::fabs(c_[Form::one]);
  if (q == 0) return l > 0 ? c / l : 0;
  return std::fmax(l / q, std::sqrt(c / q));
}

}  // namespace csgcast::detail
