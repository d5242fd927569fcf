// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <gmpxx.h>

namespace csgcast::detail {

/// normal . x <= limit, exact.
template <std::size_t dimension>
struct Constraint {
  std::array<mpq_class, dimension> normal;
  mpq_class limit;
};

/// A point of the box [-reach, reach]³ that obeys all constraints and has the largest objective . x; nothing if there
/// is none.
///
/// Expected time linear in the number of constraints if these come in random order; a normal may be zero.
/// Source: Seidel 1991, small-dimensional linear programming made easy.
std::optional<std::array<mpq_class, 3>> maximise(const std::vector<Constraint<3>>& constraints,
                                                 const std::array<mpq_class, 3>& objective, const mpq_class& reach);

}  // namespace csgcast::detail
