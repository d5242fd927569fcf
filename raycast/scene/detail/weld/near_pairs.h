// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/leaf_shape.h"
#include "raycast/scene/detail/weld/coincidence.h"
#include "raycast/scene/detail/weld/grouping.h"

namespace csgcast::detail {

/// Finds surfaces that may coincide within their errors without comparing all with all. A surface up to its sign is
/// summed up in one number with a bound on its error; surfaces that coincide have overlapping ranges.
class NearPairs {
 public:
  /// The forms must be in one common region. Surfaces whose errors are too large to tell anything are left out.
  void add(std::uint32_t surface, const RegionForm& form, const FormError& error);

  /// The surfaces in groups of two or more such that surfaces with overlapping ranges are in one group.
  Grouping::Groups groups() const;
  /// Whether the ranges of two surfaces overlap. Both must have been added.
  bool overlap(std::uint32_t a, std::uint32_t b) const;

 private:
  struct Range {
    double middle = 0;  // not below 0: of the surface or of its negative
    double reach = -1;  // below 0: left out
  };
  std::vector<Range> ranges_;
};

}  // namespace csgcast::detail
