// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "csg/base/vector.h"

namespace csgcast::detail {

/// Corners 1, 2, 3 are anticlockwise as seen from the far side of corner 0. The volume is positive, up to rounding.
/// Parts that are cut off keep that order, so sums are correct even where rounding folds slivers over.
using Tetrahedron = std::array<Vector, 4>;
using Triangle = std::array<Vector, 3>;

/// Five tetrahedra that fill the box |d_i| <= half_i: one about every second corner, and the one that these leave.
std::array<Tetrahedron, 5> tetrahedra_of_box(Vector half);

/// An order of places. By it, neighbours that share places treat them alike.
inline bool comes_before(Vector a, Vector b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// The zero between two points of a function that is linear between them. The result does not depend on the order of
/// the points.
inline Vector zero_between(Vector a, Vector b, double at_a, double at_b) {
  if (comes_before(b, a)) return zero_between(b, a, at_b, at_a);
  return a + (at_a / (at_a - at_b)) * (b - a);
}

/// Calls `add(tetrahedron)` for each of three tetrahedra that fill the wedge between two triangles with corresponding
/// corners. If the wedge is turned round, so are they. The sides are cut along diagonals from their first corners, in
/// the order of places, so that two wedges on one side fit together (Dompierre et al. 1999, How to subdivide pyramids,
/// prisms and hexahedra).
template <class Add>
void add_wedge(Triangle a, Triangle b, bool is_turned, Add&& add) {
  const auto first_of = [](const Triangle& t) {
    std::size_t first = comes_before(t[1], t[0]) ? 1 : 0;
    return comes_before(t[2], t[first]) ? std::size_t{2} : first;
  };
  if (comes_before(b[first_of(b)], a[first_of(a)])) {
    std::swap(a, b);
    is_turned = !is_turned;
  }
  const std::size_t first = first_of(a);
  std::rotate(a.begin(), a.begin() + static_cast<long>(first), a.end());
  std::rotate(b.begin(), b.begin() + static_cast<long>(first), b.end());
  const auto emit = [&](Vector p, Vector q, Vector r, Vector s) {
    add(is_turned ? Tetrahedron{q, p, r, s} : Tetrahedron{p, q, r, s});
  };
  const Vector one = comes_before(a[1], b[2]) ? a[1] : b[2];
  const Vector other = comes_before(a[2], b[1]) ? a[2] : b[1];
  if (comes_before(one, other)) {
    emit(a[0], a[1], a[2], b[2]);
    emit(a[0], a[1], b[2], b[1]);
  } else {
    emit(a[0], a[1], a[2], b[1]);
    emit(a[0], b[1], a[2], b[2]);
  }
  emit(a[0], b[0], b[1], b[2]);
}

/// Cuts a tetrahedron by a plane, on which a linear function is zero. Calls `below(tetrahedron)` for parts where the
/// function is negative, `above(tetrahedron)` for the other parts, and `face(triangle)` for the cut, anticlockwise as
/// seen from above. `at` has the function's values at the corners.
template <class Below, class Above, class Face>
void cut(const Tetrahedron& t, const std::array<double, 4>& at, Below&& below, Above&& above, Face&& face) {
  std::array<std::size_t, 4> order{};  // the corners below come first
  std::size_t count = 0;
  bool is_odd = false;  // true if the permutation is odd
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(at[i] < 0)) continue;
    is_odd = is_odd != ((i - count) % 2 != 0);
    order[count++] = i;
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
  const auto add_face = [&](Vector p, Vector q, Vector r) { face(is_odd ? Triangle{q, p, r} : Triangle{p, q, r}); };
  if (count == 2) {
    const Vector p02 = zero(0, 2), p03 = zero(0, 3), p12 = zero(1, 2), p13 = zero(1, 3);
    add_wedge({corner(0), p02, p03}, {corner(1), p12, p13}, is_odd, below);
    add_wedge({corner(2), p02, p12}, {corner(3), p03, p13}, is_odd, above);
    add_face(p02, p03, p13);
    add_face(p02, p13, p12);
    return;
  }
  // One corner is alone on its side: the first or the last one. An even number of steps cannot bring the last to the
  // front.
  const std::size_t alone = count == 1 ? 0 : 3;
  const std::size_t first = count == 1 ? 1 : 0;
  const bool is_turned = is_odd != (count == 3);
  const Triangle at_zero{zero(alone, first), zero(alone, first + 1), zero(alone, first + 2)};
  const Triangle others{corner(first), corner(first + 1), corner(first + 2)};
  const Tetrahedron tip = is_turned ? Tetrahedron{at_zero[0], corner(alone), at_zero[1], at_zero[2]}
                                    : Tetrahedron{corner(alone), at_zero[0], at_zero[1], at_zero[2]};
  if (count == 1) {
    below(tip);
    add_wedge(at_zero, others, is_turned, above);
  } else {
    above(tip);
    add_wedge(at_zero, others, is_turned, below);
  }
  add_face(at_zero[0], at_zero[1], at_zero[2]);
}

}  // namespace csgcast::detail
