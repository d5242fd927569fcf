// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "csg/exact/dyadic.h"
#include "raycast/line/exact_root.h"
#include "raycast/surface/line_crossings.h"

namespace csgcast::detail {

/// f(o + t d) = a t² + b t + c, exact up to a positive factor. If the line departs from this surface, f(o) is 0 by
/// definition. The crossing at the start is then divided out, which leaves a t + b, stored as 0 t² + a t + b.
struct ExactPolynomial {
  Dyadic a;
  Dyadic b;
  Dyadic c;

  ExactPolynomial(const Line& line, SurfaceId id, const Surface& surface);
  /// Root 0 is the lower one. If there are no roots, d < 0. Precondition: the polynomial is not constant.
  ExactRoot root(unsigned number) const { return ExactRoot::of(a, b, c, number); }
};

/// The polynomials and roots of one line, by surface.
class ExactMemory {
 public:
  void forget() { known_.clear(); }

  const ExactPolynomial& polynomial(const Line& line, SurfaceId id, const Surface& surface);
  /// ExactPolynomial::root.
  const ExactRoot& root(const Line& line, SurfaceId id, const Surface& surface, unsigned root);

 private:
  struct Known {
    SurfaceId id;
    ExactPolynomial polynomial;
    std::array<std::optional<ExactRoot>, 2> roots;
  };
  Known& known(const Line& line, SurfaceId id, const Surface& surface);

  std::deque<Known> known_;           // of the present line
  std::vector<std::uint32_t> place_;  // by surface: its index in known_, if it is there
};

LineCrossings exact_crossings(const Line& line, SurfaceId id, const Surface& surface);
/// The t of a crossing, correctly rounded: the nearest double, ties to even.
double exact_nearest_t(const Line& line, const CrossingView& crossing);
/// The exact root of a crossing.
ExactRoot exact_root(const Line& line, const CrossingView& crossing);

}  // namespace csgcast::detail
