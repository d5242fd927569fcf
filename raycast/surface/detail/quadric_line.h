// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/line/line_frame.h"
#include "raycast/surface/surface.h"

// Surfaces restricted to a line, in double. The certified filter puts error bounds on these numbers.

namespace csgcast::detail {

/// f(near + tau d) = value + slope tau.
struct PlaneOnLine {
  double value;
  double slope;
};

/// f = a s² + 2 b s + c with s = tau - origin. At s = 0 is the line's closest approach to the surface's center, about
/// which the least cancels.
struct QuadricOnLine {
  double a;
  double b;
  double c;
  double origin;
  Vector start;  ///< from the center to the line's `near`
  Vector q;      ///< from the center to the closest approach
};

inline PlaneOnLine plane_on_line(const LineFrame& line, const Surface& plane) {
  using Form = QuadricForm;
  const Vector normal{plane.local[Form::x], plane.local[Form::y], plane.local[Form::z]};
  return {dot(normal, line.near) + plane.local[Form::one], dot(normal, line.direction)};
}

inline QuadricOnLine quadric_on_line(const LineFrame& line, const Surface& quadric) {
  using Form = QuadricForm;
  const auto& k = quadric.local;
  const auto times_matrix = [&k](Vector v) {
    return Vector{k[Form::xx] * v.x + 0.5 * (k[Form::xy] * v.y + k[Form::xz] * v.z),
                  k[Form::yy] * v.y + 0.5 * (k[Form::xy] * v.x + k[Form::yz] * v.z),
                  k[Form::zz] * v.z + 0.5 * (k[Form::xz] * v.x + k[Form::yz] * v.y)};
  };
  const Vector d = line.direction;
  const Vector start = line.near - quadric.center;
  const double origin = -dot(start, d) * line.inverse_squared;
  const Vector q = start + origin * d;
  const Vector linear{k[Form::x], k[Form::y], k[Form::z]};
  const Vector image = times_matrix(d);
  return {dot(d, image),
          dot(q, image) + 0.5 * dot(linear, d),
          dot(q, times_matrix(q)) + dot(linear, q) + k[Form::one],
          origin,
          start,
          q};
}

}  // namespace csgcast::detail
