// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raycast/line/exact_root.h"
#include "raycast/line/twofold_root.h"
#include "raycast/surface/line_crossings.h"

namespace csgcast {

/// What the engine knows of one kind of surface: a row of the table of kinds (kinds.h). A function that gets the
/// surface's id can tell whether the line departs from the surface. LineCrossings says what it answers then.
struct SurfaceKind {
  const char* name;  ///< "plane"
  /// Whether surfaces with this form are of the kind.
  bool (*takes)(const QuadricForm& form);

  // Which crossings exist, rung by rung of the ladder (docs/accuracy.md): nothing where the rung leaves it open.
  std::optional<LineCrossings> (*in_double)(const Line& line, SurfaceId id, const Surface& surface);
  std::optional<LineCrossings> (*in_twofold)(const Line& line, SurfaceId id, const Surface& surface);
  LineCrossings (*exactly)(const Line& line, SurfaceId id, const Surface& surface);
  /// Floating point as it comes, without bounds: what certification costs is measured against it.
  LineCrossings (*uncertified)(const Line& line, SurfaceId id, const Surface& surface);

  // Where a crossing is that exists.
  std::optional<detail::TwofoldRoot> (*twofold_root)(const Line& line, const CrossingView& crossing);
  detail::ExactRoot (*exact_root)(const Line& line, const CrossingView& crossing);
  /// t rounded to the nearest double, ties to even, where floating point is certain of it.
  std::optional<double> (*nearest_t)(const Line& line, const CrossingView& crossing);
  /// The same by exact arithmetic.
  double (*exact_nearest_t)(const Line& line, const CrossingView& crossing);

  /// -1, 0 or 1: the sign of f(p), exactly.
  int (*sign_at)(const Surface& surface, Point p);
  /// The gradient of f at p up to a positive factor, in plain double.
  Vector (*gradient)(const Surface& surface, const Frame& frame, Point p);
};

}  // namespace csgcast
