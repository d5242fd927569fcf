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

/// Everything the engine knows of one kind of surface: a row of the table of kinds (kinds.h). Some functions get the
/// surface's id, so that they can tell if the line departs from the surface. LineCrossings documents the answer for
/// that case.
struct SurfaceKind {
  const char* name = nullptr;       ///< "plane"
  std::uint8_t most_crossings = 0;  ///< the most crossings that a line may have with such a surface
  /// True if surfaces with this form are of the kind. One of the two functions is null.
  bool (*takes)(const QuadricForm& form) = nullptr;
  bool (*takes_other)(const OtherForm& form) = nullptr;

  // These find out which crossings exist, rung by rung of the ladder (docs/accuracy.md). A rung returns nothing if it
  // leaves the answer open.
  std::optional<LineCrossings> (*in_double)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  std::optional<LineCrossings> (*in_twofold)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  LineCrossings (*exactly)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;
  /// Plain floating point without error bounds. The benchmark of the cost of certification uses it.
  LineCrossings (*uncertified)(const Line& line, SurfaceId id, const Surface& surface) = nullptr;

  // These locate a crossing that exists.
  std::optional<detail::TwofoldRoot> (*twofold_root)(const Line& line, const CrossingView& crossing) = nullptr;
  detail::ExactRoot (*exact_root)(const Line& line, const CrossingView& crossing) = nullptr;
  /// t rounded to the nearest double, ties to even. Returns nothing if floating point is not certain of it.
  std::optional<double> (*nearest_t)(const Line& line, const CrossingView& crossing) = nullptr;
  /// The same by exact arithmetic.
  double (*exact_nearest_t)(const Line& line, const CrossingView& crossing) = nullptr;

  /// The sign of f(p), exactly: -1, 0 or 1.
  int (*sign_at)(const Surface& surface, Point p) = nullptr;
  /// The sides of the surface that the points of a finite box may be on, in the frame's coordinates. The answer is
  /// `both` if that is not known.
  detail::Sides (*sides_in)(const Surface& surface, const Frame& frame, const CellBox& box) = nullptr;
  /// True if lanes can compute with the surface's ten numbers (Surface::local). If not, rays are left to the caster in
  /// every cell that the surface may cross.
  bool has_lanes = false;

  /// The gradient of f at p up to a positive factor, in plain double.
  Vector (*gradient)(const Surface& surface, const Frame& frame, Point p) = nullptr;
};

}  // namespace csgcast
