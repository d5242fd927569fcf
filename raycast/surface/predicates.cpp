// SPDX-License-Identifier: MIT
#include "raycast/surface/predicates.h"

#include <cmath>

#include "raycast/surface/detail/exact_line.h"
#include "raycast/surface/detail/line_filter.h"
#include "raycast/surface/detail/nearest_t.h"
#include "raycast/surface/detail/twofold_line.h"
#include "raycast/surface/detail/uncertified_line.h"

namespace csgcast {
namespace {

std::weak_ordering by_value(double gap) {
  return gap < 0 ? std::weak_ordering::less : gap > 0 ? std::weak_ordering::greater : std::weak_ordering::equivalent;
}

std::optional<LineCrossings> filtered(const Line& line, SurfaceId id, const Surface& surface) {
  if (id == line.departure) return detail::filtered_departure(line, surface);
  return surface.kind == SurfaceKind::plane ? detail::filtered_plane(line.in_frame, surface)
                                            : detail::filtered_quadric(line.in_frame, surface);
}

// The tau of a t. The unit is a power of two, so only the subtraction of the shift rounds.
double tau_of(const Line& line, double t) { return t / line.in_frame.unit - line.in_frame.shift; }

std::weak_ordering order_with_infinity(double t) {
  return t > 0 ? std::weak_ordering::less : std::weak_ordering::greater;
}

LineCrossings certified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls) {
  if (const std::optional<LineCrossings> found = filtered(line, id, surface)) return *found;
  if (id != line.departure) {
    if (const std::optional<LineCrossings> found = detail::twofold_crossings(line.in_frame, surface)) {
      ++calls.twofold;
      return *found;
    }
  }
  ++calls.existence;
  return detail::exact_crossings(line, id, surface);
}

std::weak_ordering certified_order(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls) {
  if (a.id == b.id) return a.root <=> b.root;
  const double gap = a.tau() - b.tau();
  // The subtraction and the sum of the errors round by a relative u each. Twice the errors cover both.
  if (std::fabs(gap) > 2 * (a.found->error + b.found->error)) return by_value(gap);
  if (a.id != line.departure && b.id != line.departure) {
    const auto root_a = detail::twofold_root(line.in_frame, a);
    const auto root_b = detail::twofold_root(line.in_frame, b);
    const int sign = root_a && root_b ? detail::certain_order(*root_a, *root_b) : 0;
    if (sign != 0) {
      ++calls.twofold;
      return by_value(sign);
    }
  }
  ++calls.order;
  return detail::exact_root(line, a) <=> detail::exact_root(line, b);
}

std::weak_ordering certified_order_with(const Line& line, const CrossingView& a, double t, ExactCalls& calls) {
  if (std::isinf(t)) return order_with_infinity(t);
  const double tau = tau_of(line, t);
  const double gap = a.tau() - tau;
  if (std::fabs(gap) > 2 * (a.found->error + 0x1p-53 * std::fabs(tau))) return by_value(gap);
  ++calls.order;
  return detail::exact_root(line, a) <=> detail::ExactRoot(Dyadic(t));
}

LineCrossings always_exact_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls) {
  ++calls.existence;
  return detail::exact_crossings(line, id, surface);
}

std::weak_ordering always_exact_order(const Line& line, const CrossingView& a, const CrossingView& b,
                                      ExactCalls& calls) {
  ++calls.order;
  return detail::exact_root(line, a) <=> detail::exact_root(line, b);
}

std::weak_ordering always_exact_order_with(const Line& line, const CrossingView& a, double t, ExactCalls& calls) {
  if (std::isinf(t)) return order_with_infinity(t);
  ++calls.order;
  return detail::exact_root(line, a) <=> detail::ExactRoot(Dyadic(t));
}

double always_exact_t(const Line& line, const CrossingView& crossing, ExactCalls& calls) {
  ++calls.rounding;
  return detail::exact_nearest_t(line, crossing);
}

std::weak_ordering uncertified_order(const Line&, const CrossingView& a, const CrossingView& b, ExactCalls&) {
  if (a.id == b.id) return a.root <=> b.root;
  return by_value(a.tau() - b.tau());
}

std::weak_ordering uncertified_order_with(const Line& line, const CrossingView& a, double t, ExactCalls&) {
  return std::isinf(t) ? order_with_infinity(t) : by_value(a.tau() - tau_of(line, t));
}

double uncertified_t(const Line& line, const CrossingView& crossing, ExactCalls&) {
  return line.in_frame.t(crossing.tau());
}

}  // namespace

LineMemory::LineMemory() : state_(std::make_unique<State>()) {}
LineMemory::~LineMemory() = default;
LineMemory::LineMemory(LineMemory&&) noexcept = default;

void LineMemory::forget() { state_->forget(); }

int sign_at(const Surface& surface, Point p) {
  using Form = QuadricForm;
  const auto& c = surface.world;
  const std::array<double, Form::term_count> term{c[Form::xx] * p.x * p.x, c[Form::yy] * p.y * p.y,
                                                  c[Form::zz] * p.z * p.z, c[Form::xy] * p.x * p.y,
                                                  c[Form::xz] * p.x * p.z, c[Form::yz] * p.y * p.z,
                                                  c[Form::x] * p.x,        c[Form::y] * p.y,
                                                  c[Form::z] * p.z,        c[Form::one]};
  double sum = 0;
  double magnitude = 0;
  for (const double t : term) {
    sum += t;
    magnitude += std::fabs(t);
  }
  // The rounding of a coefficient, two products and nine additions come to (1 + u)^12 - 1 < 13 u; 16 u also covers the
  // rounding of the bound. Outside the middle range of exponents a term may have under- or overflowed.
  if (surface.in_range && magnitude > 0x1p-900 && magnitude < 0x1p900 && std::fabs(sum) > 0x10p-53 * magnitude)
    return sum > 0 ? 1 : -1;
  return surface.exact.unpacked().at(p).sign();
}

const Predicates& certified_predicates() {
  static constexpr Predicates table{certified_crossings, certified_order, certified_order_with, detail::nearest_t};
  return table;
}

const Predicates& exact_predicates() {
  static constexpr Predicates table{always_exact_crossings, always_exact_order, always_exact_order_with,
                                    always_exact_t};
  return table;
}

const Predicates& uncertified_predicates() {
  static constexpr Predicates table{detail::uncertified_crossings, uncertified_order, uncertified_order_with,
                                    uncertified_t};
  return table;
}

}  // namespace csgcast
