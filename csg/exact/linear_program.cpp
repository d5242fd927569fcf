// SPDX-License-Identifier: MIT
#include "csg/exact/linear_program.h"

#include <utility>

namespace csgcast::detail {
namespace {

template <std::size_t dimension>
using Place = std::array<mpq_class, dimension>;

template <std::size_t dimension>
mpq_class dot(const Place<dimension>& a, const Place<dimension>& b) {
  mpq_class sum;
  for (std::size_t i = 0; i < dimension; ++i) {
    if (sgn(a[i]) != 0 && sgn(b[i]) != 0) sum += a[i] * b[i];
  }
  return sum;
}

// The axis of a non-zero component, or `dimension` if there is none. Any such axis will do, because nothing is rounded.
template <std::size_t dimension>
std::size_t pivot_axis(const Place<dimension>& normal) {
  for (std::size_t i = 0; i < dimension; ++i) {
    if (sgn(normal[i]) != 0) return i;
  }
  return dimension;
}

// `a` without its component along the axis, less that component's share on the plane normal . x = limit.
template <std::size_t dimension>
Place<dimension - 1> eliminated(const Place<dimension>& a, std::size_t axis, const Place<dimension>& scaled_normal) {
  Place<dimension - 1> result;
  for (std::size_t i = 0, k = 0; i < dimension; ++i) {
    if (i == axis) continue;
    result[k++] = sgn(a[axis]) == 0 ? a[i] : mpq_class(a[i] - a[axis] * scaled_normal[i]);
  }
  return result;
}

std::optional<Place<1>> solve(const std::vector<Constraint<1>>& constraints, const Place<1>& objective,
                              const mpq_class& reach) {
  mpq_class lower = -reach, upper = reach;
  for (const auto& [normal, limit] : constraints) {
    const int sign = sgn(normal[0]);
    if (sign == 0) {
      if (sgn(limit) < 0) return std::nullopt;
      continue;
    }
    const mpq_class end = limit / normal[0];
    if (sign > 0 && end < upper) upper = end;
    if (sign < 0 && end > lower) lower = end;
  }
  if (lower > upper) return std::nullopt;
  return Place<1>{sgn(objective[0]) < 0 ? lower : upper};
}

template <std::size_t dimension>
std::optional<Place<dimension>> solve(const std::vector<Constraint<dimension>>& constraints,
                                      const Place<dimension>& objective, const mpq_class& reach);

// The best point on the plane of constraints[active] that obeys those before it.
template <std::size_t dimension>
std::optional<Place<dimension>> solve_on_plane(const std::vector<Constraint<dimension>>& constraints,
                                               std::size_t active, const Place<dimension>& objective,
                                               const mpq_class& reach) {
  const Constraint<dimension>& plane = constraints[active];
  const std::size_t axis = pivot_axis<dimension>(plane.normal);
  if (axis == dimension) return std::nullopt;  // the condition is: 0 <= a negative limit
  // On the plane, x[axis] = offset - scaled . x, the sum over the other axes.
  Place<dimension> scaled = plane.normal;
  for (mpq_class& component : scaled) component /= plane.normal[axis];
  const mpq_class offset = plane.limit / plane.normal[axis];

  std::vector<Constraint<dimension - 1>> reduced;
  reduced.reserve(active + 2);
  const auto append = [&](const Place<dimension>& normal, const mpq_class& limit) {
    reduced.push_back({eliminated<dimension>(normal, axis, scaled), mpq_class(limit - normal[axis] * offset)});
  };
  for (std::size_t i = 0; i < active; ++i) append(constraints[i].normal, constraints[i].limit);
  Place<dimension> side;
  for (const int sign : {1, -1}) {
    side[axis] = sign;
    append(side, reach);
  }
  const auto best = solve(reduced, eliminated<dimension>(objective, axis, scaled), reach);
  if (!best) return std::nullopt;
  Place<dimension> result;
  result[axis] = offset;
  for (std::size_t i = 0, k = 0; i < dimension; ++i) {
    if (i == axis) continue;
    result[axis] -= scaled[i] * (*best)[k];
    result[i] = (*best)[k++];
  }
  return result;
}

template <std::size_t dimension>
std::optional<Place<dimension>> solve(const std::vector<Constraint<dimension>>& constraints,
                                      const Place<dimension>& objective, const mpq_class& reach) {
  Place<dimension> best;
  for (std::size_t i = 0; i < dimension; ++i) best[i] = sgn(objective[i]) < 0 ? mpq_class(-reach) : reach;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (dot<dimension>(constraints[i].normal, best) <= constraints[i].limit) continue;
    const auto better = solve_on_plane<dimension>(constraints, i, objective, reach);
    if (!better) return std::nullopt;
    best = *better;
  }
  return best;
}

}  // namespace

std::optional<std::array<mpq_class, 3>> maximise(const std::vector<Constraint<3>>& constraints,
                                                 const std::array<mpq_class, 3>& objective, const mpq_class& reach) {
  return solve<3>(constraints, objective, reach);
}

}  // namespace csgcast::detail
