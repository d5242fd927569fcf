// SPDX-License-Identifier: MIT
#include "raycast/weld/coincidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/length.h"

namespace csgcast::detail {
namespace {

using Form = QuadricForm;
constexpr double infinity = std::numeric_limits<double>::infinity();
// Bound on the rounding of f_i g_m - g_i f_m. Each number is off by a relative 2^-104, and products and difference by a
// few times that.
constexpr double rounding = 0x1p-100;

// The magnitude of an entry of the matrix of second derivatives.
double bend(const RegionForm& form, std::size_t k, std::size_t l) {
  return std::fabs(form.coefficient[Form::second_degree(k, l)].high) * (k == l ? 2 : 1);
}

std::size_t largest(const RegionForm& f) {
  const auto less = [](Twofold a, Twofold b) { return std::fabs(a.high) < std::fabs(b.high); };
  return static_cast<std::size_t>(std::max_element(f.coefficient.begin(), f.coefficient.end(), less) -
                                  f.coefficient.begin());
}

// Computes f_i g_m - g_i f_m. This is the difference between f and g scaled to f, in coefficient i and times g_m.
Twofold difference(const RegionForm& f, const RegionForm& g, std::size_t i, std::size_t m) {
  return f.coefficient[i] * g.coefficient[m] + -(g.coefficient[i] * f.coefficient[m]);
}

bool same(const RegionForm& f, const RegionForm& g, std::size_t i) {
  return f.coefficient[i].high == g.coefficient[i].high && f.coefficient[i].low == g.coefficient[i].low;
}

double plane_gap(const RegionForm& f, const RegionForm& g, const Region& region, const Box& box) {
  const std::size_t m = largest(f);
  double most = std::fabs(difference(f, g, Form::one, m).high);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double c = region.center[axis];
    const double reach =
        std::ldexp(std::fmax(std::fabs(box.lower[axis] - c), std::fabs(box.upper[axis] - c)), -region.exponent);
    const double slope = std::fabs(difference(f, g, Form::x + axis, m).high);
    if (slope > 0) most += slope * reach;
  }
  const auto at = [&](std::size_t axis) { return f.coefficient[Form::x + axis].high; };
  const double steepness = std::hypot(at(0), at(1), at(2)) * std::fabs(g.coefficient[m].high);
  const double result = std::ldexp(most / steepness, region.exponent);
  return std::isnan(result) ? infinity : result;
}

}  // namespace

Region Region::around(const Box& box) {
  const double reach = longest(0.5 * box.size());
  return {box.center(), reach > 0 ? std::ilogb(reach) + 1 : 0};
}

bool Region::is_resolved() const { return std::ldexp(1, exponent) >= 0x1p-50 * longest(center); }

RegionForm::RegionForm(const QuadricForm& form, const Region& region) : is_plane(form.is_plane()) {
  const ExactPoint center{region.center.x, region.center.y, region.center.z};
  RoundedCoefficients high{};
  RoundedCoefficients low{};
  in_range = round_scaled(in_coordinates(form, center, region.exponent), high, &low, &is_exact);
  for (std::size_t i = 0; i < high.size(); ++i) coefficient[i] = {high[i], low[i]};
}

RegionForm seen_from(const RegionForm& form, const Region& region, const Region& place) {
  std::array<Twofold, 3> way;
  for (std::size_t k = 0; k < 3; ++k) {
    const Twofold difference = two_sum(place.center[k], -region.center[k]);
    way[k] = {std::ldexp(difference.high, -region.exponent), std::ldexp(difference.low, -region.exponent)};
  }
  // f(way + s) has the gradient at `way` as its first degree, and the value there as its constant.
  RegionForm moved = form;
  moved.is_exact = false;
  const auto& c = form.coefficient;
  for (std::size_t k = 0; k < 3; ++k) {
    Twofold half_bend{};
    for (std::size_t l = 0; l < 3; ++l) {
      const Twofold term = c[Form::second_degree(k, l)] * way[l];
      half_bend = half_bend + (k == l ? term : term * 0.5);
    }
    moved.coefficient[Form::x + k] = c[Form::x + k] + half_bend * 2.0;
    moved.coefficient[Form::one] = moved.coefficient[Form::one] + (c[Form::x + k] + half_bend) * way[k];
  }
  return moved;
}

FormError error_of(const RegionForm& form, const SmallMotion& motion) {
  // The gradient's component k is at most steepness + sum over l of bend(k, l) |s_l|. The motion's is at most offset[k]
  // + sum over m of slope(k, m) |s_m|. The change is at most their product, which is summed term by term.
  FormError error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double steepness = std::fabs(form.coefficient[Form::x + k].high);
    const double offset = motion.offset[k];
    error[Form::one] += steepness * offset;
    for (std::size_t l = 0; l < 3; ++l) {
      error[Form::x + l] += steepness * motion.slope[3 * k + l] + bend(form, k, l) * offset;
      for (std::size_t m = 0; m < 3; ++m)
        error[Form::second_degree(l, m)] += bend(form, k, l) * motion.slope[3 * k + m];
    }
  }
  return error;
}

double distance_in_errors(const RegionForm& f, const FormError& f_error, const RegionForm& g, const FormError& g_error,
                          double most_error) {
  if (f.is_plane != g.is_plane || !f.in_range || !g.in_range) return infinity;
  const std::size_t m = largest(f);
  const double fm = std::fabs(f.coefficient[m].high), gm = std::fabs(g.coefficient[m].high);
  double most = 0;
  for (std::size_t i = 0; i < f_error.size(); ++i) {
    if (!(f_error[i] <= most_error && g_error[i] <= most_error)) return infinity;
    const double fi = std::fabs(f.coefficient[i].high), gi = std::fabs(g.coefficient[i].high);
    if (f.is_exact && g.is_exact && same(f, g, i) && same(f, g, m)) continue;
    // A difference that rounding of the forms may hide counts as one, because errors smaller than that tell nothing.
    const double apart = std::fabs(difference(f, g, i, m).high) + rounding * (fi * gm + gi * fm);
    if (apart == 0 || i == m) continue;
    most = std::fmax(most, apart / (gm * f_error[i] + fm * g_error[i] + fi * g_error[m] + gi * f_error[m]));
  }
  return std::isnan(most) ? infinity : most;
}

bool is_flipped(const RegionForm& f, const RegionForm& g) {
  const std::size_t m = largest(f);
  return (f.coefficient[m].high < 0) != (g.coefficient[m].high < 0);
}

double gap(const RegionForm& f, const RegionForm& g, const Region& region, const Box& box) {
  if (f.is_plane != g.is_plane || !f.in_range || !g.in_range) return infinity;
  if (f.is_plane) return plane_gap(f, g, region, box);
  // The gap is the motion, shared between the two surfaces, that explains their difference. A motion by `tiny` on each
  // axis at the box's sides is tried first. It is then scaled by the ratio of the surfaces' distance to its effect.
  constexpr double tiny = 0x1p-40;
  constexpr double most_tiny = 0x1p-20;
  SmallMotion motion;
  for (std::size_t k = 0; k < 3; ++k) {
    motion.offset[k] = 0.5 * tiny;
    for (std::size_t l = 0; l < 3; ++l) {
      const double half = std::ldexp(0.5 * (box.upper[l] - box.lower[l]), -region.exponent);
      motion.slope[3 * k + l] = half > 0 ? 0.5 * tiny / half : 0;
    }
  }
  return std::ldexp(tiny * distance_in_errors(f, error_of(f, motion), g, error_of(g, motion), most_tiny),
                    region.exponent);
}

}  // namespace csgcast::detail
