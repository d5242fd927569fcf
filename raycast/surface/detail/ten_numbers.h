// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/surface/detail/exact_line.h"
#include "raycast/surface/detail/form_sign.h"
#include "raycast/surface/detail/nearest_t.h"
#include "raycast/surface/form_range.h"
#include "raycast/surface/kind.h"

namespace csgcast::detail {

/// The part of the table of kinds that planes and quadrics share: the rungs that take a form's ten numbers.
constexpr SurfaceKind kind_of_ten_numbers() {
  SurfaceKind kind;
  kind.exactly = exact_crossings;
  kind.exact_root = exact_root;
  kind.nearest_t = nearest_t;
  kind.exact_nearest_t = exact_nearest_t;
  kind.sign_at = form_sign_at;
  kind.sides_in = sides_by_form;
  kind.has_lanes = true;
  return kind;
}

}  // namespace csgcast::detail
