// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "raycast/cells/build/box_fold.h"
#include "raycast/cells/build/cell_ground.h"
#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/surface_set.h"

namespace csgcast::detail {

/// A place where a box can be split, and the expected cost of a ray through the two parts.
struct Split {
  std::size_t axis = 0;
  double at = 0;
  double cost = 0;
};

/// Searches splits of boxes that make rays cheaper, by the surface area heuristic. Working memory of one thread.
class SplitSearch {
 public:
  /// The number of splits that promise nothing and may be made on the way down, before one promises something. The
  /// number that is left may fall below 0 where a cell would be slow.
  static constexpr int most_hopes = 3;

  struct Found {
    Split split;
    int hopes = most_hopes;  ///< the number of hopes left for the two parts
  };

  /// The fold must be of_rays. `leaves` is the number of leaves of the node; it limits the number of futile trials. All
  /// arguments must outlive this.
  SplitSearch(const CellGround& ground, BoxFold& fold, std::size_t leaves);

  /// Returns the split that should be made for a box, or nothing if the box should be one cell. `formula` is the
  /// formula of the box, `leaves` are its leaves, `surfaces` is the number of its surfaces, and `hopes` the number of
  /// hopes left here.
  std::optional<Found> find(const Formula& formula, std::span<const LeafId> leaves, std::size_t surfaces,
                            const CellBox& box, int hopes);

 private:
  bool is_too_small(std::span<const LeafId> leaves, bool is_large, const CellBox& box) const;
  std::optional<Split> best(const Formula& formula, std::span<const LeafId> leaves, std::size_t surfaces,
                            const CellBox& box);
  std::optional<Split> by_bins(std::span<const LeafId> leaves, const CellBox& box) const;
  std::optional<Split> by_trial(const Formula& formula, std::span<const LeafId> leaves, const CellBox& box);
  void find_candidates(std::span<const LeafId> leaves, const CellBox& box);
  double trial_cost(const Formula& formula, const CellBox& box);
  bool may_hope(const Formula& formula, std::size_t surfaces, int hopes);
  bool spend(const Formula& formula);

  const CellGround& ground_;
  BoxFold& fold_;
  std::size_t most_crowded_splits_;  // the most splits, that promise nothing, of boxes that would be left to the caster
  std::size_t crowded_splits_ = 0;
  std::size_t spare_terms_;     // the number of terms of formulas that may still be tried more than usual
  std::vector<double> places_;  // the places of candidates on an axis
  std::vector<Split> candidates_;
  Formula trial_;
  SurfaceSet trial_surfaces_;
};

}  // namespace csgcast::detail
