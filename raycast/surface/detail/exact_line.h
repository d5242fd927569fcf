// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "csg/exact/dyadic.h"
#include "raycast/surface/predicates.h"

namespace csgcast::detail {

/// f(o + t d) = a t² + b t + c, exact up to a positive factor. For the surface that a line departs from f(o) is 0 by
/// definition, and the crossing at the start is divided out: what is left is a t + b, written as 0 t² + a t + b.
struct ExactPolynomial {
  Dyadic a;
  Dyadic b;
  Dyadic c;

  ExactPolynomial(const Line& line, SurfaceId id, const Surface& surface);
};

/// The last rung of the ladder: a root as (p + s sqrt(d)) / q. p, q and d >= 0 are integers times powers of two, s is
/// -1, 0 or 1.
struct ExactRoot {
  Dyadic p;
  Dyadic q;
  Dyadic d;
  int s = 0;

  /// Root 0 is the lower one. Precondition: the polynomial has that root.
  ExactRoot(const ExactPolynomial& f, unsigned root);
  explicit ExactRoot(const Dyadic& value) : p(value), q(1.0) {}
};

std::strong_ordering operator<=>(const ExactRoot& a, const ExactRoot& b);

/// Keeps the polynomials and roots of one line, by surface.
class ExactMemory {
 public:
  void forget() { known_.clear(); }

  const ExactPolynomial& polynomial(const Line& line, SurfaceId id, const Surface& surface);
  /// Precondition: the polynomial has that root.
  const ExactRoot& root(const Line& line, SurfaceId id, const Surface& surface, unsigned root);

 private:
  struct Known {
    SurfaceId id;
    ExactPolynomial polynomial;
    std::array<std::optional<ExactRoot>, 2> roots;
  };
  Known& known(const Line& line, SurfaceId id, const Surface& surface);

  std::deque<Known> known_;           // what is known about the present line
  std::vector<std::uint32_t> place_;  // by surface: where it stands in known_, if it is there
};

/// The crossings of a line and a surface, by exact arithmetic alone.
LineCrossings exact_crossings(const Line& line, SurfaceId id, const Surface& surface);
/// The t of a crossing, correctly rounded: the nearest double, ties to even.
double exact_nearest_t(const Line& line, const CrossingView& crossing);
/// The exact root of a crossing.
ExactRoot exact_root(const Line& line, const CrossingView& crossing);

}  // namespace csgcast::detail

struct csgcast::LineMemory::State : csgcast::detail::ExactMemory {};
