// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "csg/base/truth.h"
#include "csg/base/vector.h"
#include "csg/exact/quadric_form.h"
#include "raycast/weld/coincidence.h"

namespace csgcast::detail {

/// A part of the space around a region: places x / w with x in a box on a side of the region's cube, and 0 < w <=
/// least.
struct FarPart {
  Vector middle;  ///< of the box; one coordinate is 1 or -1
  Vector half;    ///< half of its sides; 0 on that axis
  double w = 1;
};

/// A form in a region's coordinates, with what is known exactly about it.
class FarForm {
 public:
  FarForm(const QuadricForm& form, const Region& region);

  /// Whether the form is below 0 everywhere in the part, or above 0 everywhere; not known if it may be 0, or both.
  Truth is_negative(const FarPart& part) const;
  /// The same in a box of the region's coordinates.
  Truth is_negative_in(Vector middle, Vector half) const;
  /// About how far from the region's center the surface lies, in its unit; 0 if nothing tells.
  double distance() const;

 private:
  struct Range {
    double lower;
    double upper;
  };
  Range second_degree(Vector middle, Vector half) const;
  Range first_degree(Vector middle, Vector half) const;

  RoundedCoefficients c_{};
  bool in_range_ = false;
  bool is_plane_ = false;
  int definite_ = 0;  // 1 if the second degree is nowhere negative, -1 if it is nowhere positive
};

}  // namespace csgcast::detail
