// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "csg/vector.h"

namespace csgcast::detail {

using Tetrahedron = std::array<Vector, 4>;
using Triangle = std::array<Vector, 3>;

/// Five tetrahedra that fill the box |d_i| <= half_i: one about every second corner, and the one that these leave.
std::array<Tetrahedron, 5> tetrahedra_of_box(Vector half);

/// The zero between two points of a function that is linear from one to the other.
inline Vector zero_between(Vector a, Vector b, double at_a, double at_b) {
  return a + (at_a / (at_a - at_b)) * (b - a);
}

/// Calls `add(tetrahedron)` for each of three that fill what lies between two triangles with corresponding corners.
template <class Add>
void add_wedge(const Triangle& a, const Triangle& b, Add&& add) {
  add(Tetrahedron{a[0], a[1], a[2], b[2]});
  add(Tetrahedron{a[0], a[1], b[1], b[2]});
  add(Tetrahedron{a[0], b[0], b[1], b[2]});
}

/// What a plane makes of a tetrahedron: `below(tetrahedron)` and `above(tetrahedron)` for the parts where a linear
/// function is negative, and is not, `face(triangle)` for the cut. `at`: the function at the corners.
template <class Below, class Above, class Face>
void cut(const Tetrahedron& t, const std::array<double, 4>& at, Below&& below, Above&& above, Face&& face) {
  std::array<std::size_t, 4> order{};  // the corners below first
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (at[i] < 0) order[count++] = i;
  }
  for (std::size_t i = 0, last = count; i < 4; ++i) {
    if (!(at[i] < 0)) order[last++] = i;
  }
  if (count == 0) return above(t);
  if (count == 4) return below(t);
  const auto corner = [&](std::size_t i) { return t[order[i]]; };
  const auto zero = [&](std::size_t i, std::size_t j) {
    return zero_between(t[order[i]], t[order[j]], at[order[i]], at[order[j]]);
  };
  if (count == 2) {
    const Vector p02 = zero(0, 2), p03 = zero(0, 3), p12 = zero(1, 2), p13 = zero(1, 3);
    add_wedge({corner(0), p02, p03}, {corner(1), p12, p13}, below);
    add_wedge({corner(2), p02, p12}, {corner(3), p03, p13}, above);
    face(Triangle{p02, p03, p13});
    face(Triangle{p02, p13, p12});
    return;
  }
  // One corner is alone on its side.
  const std::size_t alone = count == 1 ? 0 : 3;
  const std::size_t first = count == 1 ? 1 : 0;
  const Triangle at_zero{zero(alone, first), zero(alone, first + 1), zero(alone, first + 2)};
  const Triangle others{corner(first), corner(first + 1), corner(first + 2)};
  const Tetrahedron tip{corner(alone), at_zero[0], at_zero[1], at_zero[2]};
  if (count == 1) {
    below(tip);
    add_wedge(at_zero, others, above);
  } else {
    above(tip);
    add_wedge(at_zero, others, below);
  }
  face(at_zero);
}

}  // namespace csgcast::detail
