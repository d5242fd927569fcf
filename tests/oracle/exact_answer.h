// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "raycast/line/ray.h"
#include "tests/oracle/subject.h"

namespace csgcast::oracle {

/// An end of an interval along a line: a surface at an exact t, or none where a span cuts or the line goes on for ever.
struct ExactEnd {
  std::optional<Rational> t;         ///< none: infinite
  std::optional<SurfaceId> surface;  ///< none: no surface makes this end
};

struct ExactInterval {
  ExactEnd entry;
  ExactEnd exit;
};

using ExactList = std::vector<ExactInterval>;

/// The regularised list of the definition along the whole line, by rational arithmetic: the Boolean state between all
/// exact groups of crossings, and the tie rule at those where it changes.
ExactList exact_intervals(const Subject& subject, const Ray& ray);
/// What a span leaves of a list, by the rules for ends at, before and beyond the span's.
ExactList clipped(const ExactList& line, Span span);

/// The definition's answer for a point: inside (outside) if every choice of signs for the surfaces that are zero there
/// gives it, else boundary.
Location exact_location(const Subject& subject, Point p);

/// What Side_of_triangle_mesh of every operand implies; none if an operand on whose boundary the point is matters, or
/// one has no mesh.
std::optional<Location> location_by_meshes(const Subject& subject, Point p);

}  // namespace csgcast::oracle
