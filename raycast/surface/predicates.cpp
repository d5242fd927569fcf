// SPDX-License-Identifier: MIT
#include "raycast/surface/predicates.h"

#include <cmath>

#include "raycast/surface/kind.h"

namespace csgcast {
namespace {

std::weak_ordering by_value(double gap) {
  return gap < 0 ? std::weak_ordering::less : gap > 0 ? std::weak_ordering::greater : std::weak_ordering::equivalent;
}

// The tau of a given t. The unit is a power of two, so only the subtraction of the shift rounds.
double tau_of(const Line& line, double t) { return t / line.in_frame.unit - line.in_frame.shift; }

std::weak_ordering order_with_infinity(double t) {
  return t > 0 ? std::weak_ordering::less : std::weak_ordering::greater;
}

LineCrossings certified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls) {
  const SurfaceKind& kind = *surface.kind;
  if (const std::optional<LineCrossings> found = kind.in_double(line, id, surface)) return *found;
  if (const std::optional<LineCrossings> found = kind.in_twofold(line, id, surface)) {
    ++calls.twofold;
    return *found;
  }
  ++calls.existence;
  return kind.exactly(line, id, surface);
}

std::strong_ordering exact_order(const Line& line, const CrossingView& a, const CrossingView& b) {
  return a.surface->kind->exact_root(line, a) <=> b.surface->kind->exact_root(line, b);
}

std::strong_ordering exact_order_with(const Line& line, const CrossingView& a, double t) {
  return a.surface->kind->exact_root(line, a) <=> detail::ExactRoot(Dyadic(t));
}

std::strong_ordering exact_order_in_frame(const Line& line, const CrossingView& a, double tau) {
  const Dyadic t = (Dyadic(line.in_frame.shift) + Dyadic(tau)).scaled(std::ilogb(line.in_frame.unit));
  return a.surface->kind->exact_root(line, a) <=> detail::ExactRoot(t);
}

std::weak_ordering certified_order(const Line& line, const CrossingView& a, const CrossingView& b, ExactCalls& calls) {
  if (a.id == b.id) return a.root <=> b.root;
  const double gap = a.tau() - b.tau();
  // The subtraction and the sum of the errors each round by a relative u. Twice the errors cover both.
  if (std::fabs(gap) > 2 * (a.found->error + b.found->error)) return by_value(gap);
  const auto root_a = a.surface->kind->twofold_root(line, a);
  const auto root_b = root_a ? b.surface->kind->twofold_root(line, b) : std::nullopt;
  const int sign = root_b ? detail::certain_order(*root_a, *root_b) : 0;
  if (sign != 0) {
    ++calls.twofold;
    return by_value(sign);
  }
  ++calls.order;
  return exact_order(line, a, b);
}

std::weak_ordering certified_order_with(const Line& line, const CrossingView& a, double t, ExactCalls& calls) {
  if (std::isinf(t)) return order_with_infinity(t);
  const double tau = tau_of(line, t);
  const double gap = a.tau() - tau;
  if (std::fabs(gap) > 2 * (a.found->error + 0x1p-53 * std::fabs(tau))) return by_value(gap);
  ++calls.order;
  return exact_order_with(line, a, t);
}

std::weak_ordering certified_order_in_frame(const Line& line, const CrossingView& a, double tau, ExactCalls& calls) {
  const double gap = a.tau() - tau;
  if (std::fabs(gap) > 2 * a.found->error) return by_value(gap);
  ++calls.order;
  return exact_order_in_frame(line, a, tau);
}

double certified_t(const Line& line, const CrossingView& crossing, ExactCalls& calls) {
  if (const std::optional<double> t = crossing.surface->kind->nearest_t(line, crossing)) return *t;
  ++calls.rounding;
  return crossing.surface->kind->exact_nearest_t(line, crossing);
}

LineCrossings always_exact_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls& calls) {
  ++calls.existence;
  return surface.kind->exactly(line, id, surface);
}

std::weak_ordering always_exact_order(const Line& line, const CrossingView& a, const CrossingView& b,
                                      ExactCalls& calls) {
  ++calls.order;
  return exact_order(line, a, b);
}

std::weak_ordering always_exact_order_with(const Line& line, const CrossingView& a, double t, ExactCalls& calls) {
  if (std::isinf(t)) return order_with_infinity(t);
  ++calls.order;
  return exact_order_with(line, a, t);
}

std::weak_ordering always_exact_order_in_frame(const Line& line, const CrossingView& a, double tau, ExactCalls& calls) {
  ++calls.order;
  return exact_order_in_frame(line, a, tau);
}

double always_exact_t(const Line& line, const CrossingView& crossing, ExactCalls& calls) {
  ++calls.rounding;
  return crossing.surface->kind->exact_nearest_t(line, crossing);
}

LineCrossings uncertified_crossings(const Line& line, SurfaceId id, const Surface& surface, ExactCalls&) {
  return surface.kind->uncertified(line, id, surface);
}

std::weak_ordering uncertified_order(const Line&, const CrossingView& a, const CrossingView& b, ExactCalls&) {
  if (a.id == b.id) return a.root <=> b.root;
  return by_value(a.tau() - b.tau());
}

std::weak_ordering uncertified_order_with(const Line& line, const CrossingView& a, double t, ExactCalls&) {
  return std::isinf(t) ? order_with_infinity(t) : by_value(a.tau() - tau_of(line, t));
}

std::weak_ordering uncertified_order_in_frame(const Line&, const CrossingView& a, double tau, ExactCalls&) {
  return by_value(a.tau() - tau);
}

double uncertified_t(const Line& line, const CrossingView& crossing, ExactCalls&) {
  return line.in_frame.t(crossing.tau());
}

}  // namespace

int sign_at(const Surface& surface, Point p) { return surface.kind->sign_at(surface, p); }

const Predicates& certified_predicates() {
  static constexpr Predicates table{certified_crossings, certified_order, certified_order_with,
                                    certified_order_in_frame, certified_t};
  return table;
}

const Predicates& exact_predicates() {
  static constexpr Predicates table{always_exact_crossings, always_exact_order, always_exact_order_with,
                                    always_exact_order_in_frame, always_exact_t};
  return table;
}

const Predicates& uncertified_predicates() {
  static constexpr Predicates table{uncertified_crossings, uncertified_order, uncertified_order_with,
                                    uncertified_order_in_frame, uncertified_t};
  return table;
}

}  // namespace csgcast
