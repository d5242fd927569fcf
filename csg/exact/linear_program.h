// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <gmpxx.h>

namespace csgcast::detail {

/// The exact condition normal . x <= limit.
template <std::size_t dimension>
struct Constraint {
  std::array<mpq_class, dimension> normal;
  mpq_class limit;
};

/// Finds a point of the box [-reach, reach]³ that satisfies all constraints and has the largest objective . x. Returns
/// nothing if no point satisfies them.
///
/// The expected time is linear in the number of constraints, if they come in random order. A normal may be zero.
/// Source: Seidel 1991, small-dimensional linear programming made easy.
std::optional<std::array<mpq_class, 3>> maximise(const std::vector<Constraint<3>>& constraints,
                                                 const std::array<mpq_class, 3>& objective, const mpq_class& reach);

}  // namespace csgcast::detail
