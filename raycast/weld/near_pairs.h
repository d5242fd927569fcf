// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/leaf_shape.h"
#include "raycast/weld/coincidence.h"
#include "raycast/weld/grouping.h"

namespace csgcast::detail {

/// Finds surfaces that may coincide within their errors, without comparing all with all. A surface, up to its sign, is
/// summed up in one number with a bound on its error. Surfaces that coincide have overlapping ranges of that number.
class NearPairs {
 public:
  /// The forms must be in one common region. Surfaces whose errors are too large to tell anything are left out.
  void add(std::uint32_t surface, const RegionForm& form, const FormError& error);

  /// The surfaces in groups of two or more. Surfaces with overlapping ranges belong to the same group.
  Grouping::Groups groups() const;
  /// True if the ranges of two surfaces overlap. Precondition: both have been added.
  bool overlap(std::uint32_t a, std::uint32_t b) const;

 private:
  struct Range {
    double middle = 0;  // not below 0: the number of the surface, or of its negative
    double reach = -1;  // bound on its error; below 0 if the surface is left out
  };
  std::vector<Range> ranges_;
};

}  // namespace csgcast::detail
