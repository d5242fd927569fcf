// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/ray/hit.h"
#include "tests/oracle/quadrics/root.h"
#include "tests/oracle/quadrics/subject.h"

namespace csgcast::oracle::quadrics {

/// The face that makes an end of an interval. Surfaces and leaves are the formula's.
struct Face {
  std::size_t surface;
  std::size_t leaf;
  bool positive_before;               ///< the sign of the surface before the crossing
  bool surface_by_walk;               ///< no flip of one surface alone told
  bool leaf_by_walk;                  ///< no copy alone told
  std::optional<std::size_t> holder;  ///< what holds the solid's side: see Formula::first_holder
};

/// An end of an interval along a line.
struct DefinedEnd {
  std::optional<Root> t;     ///< none: infinite
  std::optional<Face> face;  ///< none: a span cuts here, or the line goes on for ever
};

struct DefinedInterval {
  DefinedEnd entry;
  DefinedEnd exit;
};

using DefinedList = std::vector<DefinedInterval>;

/// The list of the definition along the whole line: every crossing of every surface, exact groups of ties, the whole
/// formula between them, and the rules for surface and leaf at each end.
struct LineAnswer {
  DefinedList list;
  std::uint64_t ties = 0;  ///< groups of two or more
};
LineAnswer answer_on_line(const Subject& subject, const Ray& ray);

/// What a ray meets, for t >= 0 alone, that departs from a surface: this is zero at the start by definition, so it does
/// not cross there, and is right after the start on the side to which the ray leads.
struct DepartingAnswer {
  DefinedList list;
  bool positive_after;  ///< that side
  bool is_linear;       ///< the surface is, along the ray: whatever side is given, the ray's slope tells it
};
/// `given_positive`: the side of a surface that is zero all along the ray.
DepartingAnswer answer_on_departing_ray(const Subject& subject, const Ray& ray, std::size_t surface,
                                        bool given_positive);

/// What a span leaves of a list, by the rules for ends at, before and beyond the span's.
DefinedList clipped(const DefinedList& line, Span span);

/// Where a point is: by every choice of signs for the surfaces that are zero there. None if there are more than 2^16.
struct PointAnswer {
  std::optional<Location> location;
  std::size_t zeros = 0;  ///< surfaces that vanish there
};
PointAnswer answer_at_point(const Subject& subject, Point p);

}  // namespace csgcast::oracle::quadrics
