// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "measure/search/refinement.h"
#include "measure/sheet/measures.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// The integrals of density over a body, in the frame's coordinates, with bounds on their errors.
struct Body {
  Moments moments;
  double mass_error = 0;
  std::array<double, 3> first_error{};
  std::array<double, 6> second_error{};

  Body& operator+=(const Body& other);
};

/// `totals`: of a space.
Body body_of(const Space& space, const Totals& totals, double density);

/// Fills in mass, centroid, inertia and what is principal of it.
void tell_mass(const Frame& frame, const Body& body, Measures& measures);

}  // namespace csgcast::detail
