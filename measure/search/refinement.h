// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "measure/sheet/estimate.h"
#include "measure/sheet/measures.h"

namespace csgcast::detail {

/// The sums over a whole solid, in the coordinates of its space.
struct Totals {
  Moments moments;
  double volume_error = 0;
  std::array<double, 3> first_error{};
  std::array<double, 6> second_error{};
  double area = 0;
  double area_error = 0;
  std::size_t pieces = 0;
  bool is_as_asked = false;
};

/// A sum and its error in the scene's unit of length. The error includes the rounding of sums and of scaling, and the
/// loss if the numbers are too large or too small for doubles.
Measured scaled(double factor, double value, double error);

/// Cuts space until the sums are as certain as the options ask for, or is_enough says so. The calling thread calls
/// `tell` now and then with the progress. If `tell` throws, the work ends. The options' own progress callback is not
/// called. Precondition: the space is bounded.
Totals refine(
    const Space& space, const MeasureOptions& options,
    const std::function<void(const Progress&)>& tell = [](const Progress&) {});

}  // namespace csgcast::detail
