// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/formula_table.h"
#include "raycast/cells/formula/implications.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

/// Removes from a formula what its surfaces imply of each other in a box. For example, if one of two balls is within
/// the other there, or apart from it, one state of the two surfaces never occurs. If a surface's sign changes nothing
/// in all other states, the formula need not depend on it. Working memory of one thread.
class ImpliedFold {
 public:
  /// Returns false if the formula is too simple or too large to be worth a search. `surfaces` are the surfaces of the
  /// formula.
  static bool is_worthwhile(const Formula& formula, const SurfaceSet& surfaces) {
    return surfaces.size() >= 2 && surfaces.size() <= Implications::most && formula.terms.size() <= most_terms;
  }
  /// Makes `simpler` the formula without the half-spaces on which it does not depend in any possible state. Returns
  /// false if there are none; then `simpler` is untouched. `implications` are those of the surfaces, in the same order.
  /// Preconditions: is_worthwhile() is true, and `simpler` is a different formula.
  bool fold(const Formula& formula, const SurfaceSet& surfaces, const Implications& implications, Formula& simpler);

 private:
  static constexpr std::size_t most_terms = 2048;

  void set_literals(const Formula& formula, const SurfaceSet& surfaces);
  bool find_needless(const Formula& formula, const SurfaceSet& surfaces, const Implications& implications);
  void mark_wider(const Formula& formula, Formula& simpler);

  Folder folder_;
  FormulaTable table_;
  std::vector<std::uint8_t> literals_;  // by term: the literal of a half-space, as Implications counts them
  std::vector<Truth> known_;            // by term: the value that may be assumed for a half-space
  std::vector<std::uint32_t> wider_;    // LeafIds, sorted
};

}  // namespace csgcast::detail
