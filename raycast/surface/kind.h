// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "raycast/line/exact_root.h"
#include "raycast/line/twofold_root.h"
#include "raycast/surface/cell_form.h"
#include "raycast/surface/line_crossings.h"
#include "raycast/surface/sides.h"

namespace csgcast {

/// What the engine knows of one kind of surface: a row of the table of kinds (kinds.h). A function that gets the
/// surface's id can tell whether the line departs from the surface. LineCrossings says what it answers then.
struct SurfaceKind {
  const char* name = nullptr;       ///< "plane"
  std::uint8_t most_crossings = 0;  ///< how often a line may meet such a surface
  /// Whether surfaces with this form are of the kind. Of the two one is null.
  bool (*takes)(const QuadricForm& form) = nullptr;
  bool (*takes_other)(const OtherForm& form) = nullptr;

  // Which crossings exist, rung by rung of the ladder (docs/accuracy.md): nothing where the rung leaves it open.
  std::optional<LineCrossings> (*in_double)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  std::optional<LineCrossings> (*in_twofold)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  LineCrossings (*exactly)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  /// Floating point as it comes, without bounds: what certification costs is measured against it.
  LineCrossings (*uncertified)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;

  // Where a crossing is that exists.
  std::optional<detail::TwofoldRoot> (*twofold_root)(const Line& line, const CrossingView& crossing) = nullptr;
  detail::ExactRoot (*exact_root)(const Line& line, const CrossingView& crossing) = nullptr;
  /// t rounded to the nearest double, ties to even, where floating point is certain of it.
  std::optional<double> (*nearest_t)(const Line& line, const CrossingView& crossing) = nullptr;
  /// The same by exact arithmetic.
  double (*exact_nearest_t)(const Line& line, const CrossingView& crossing) = nullptr;

  /// -1, 0 or 1: the sign of f(p), exactly.
  int (*sign_at)(const Surface& surface, Point p) = nullptr;
  /// The sides that the points of a finite box may be on, `both` if that is not known; in the frame's coordinates.
  detail::Sides (*sides_in)(const Surface& surface, const Frame& frame, const CellBox& box) = nullptr;
  /// Lanes compute with the surface's ten numbers (Surface::local). If not, rays are left to the caster in every cell
  /// that the surface may cross.
  bool has_lanes = false;

  /// The gradient of f at p up to a positive factor, in plain double.
  Vector (*gradient)(const Surface& surface, const Frame& frame, Point p) = nullptr;
};

}  // namespace csgcast
