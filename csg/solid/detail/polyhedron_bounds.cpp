// SPDX-License-Identifier: MIT
#include "csg/solid/detail/polyhedron_bounds.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "csg/base/precondition.h"
#include "csg/exact/directed.h"
#include "csg/exact/linear_program.h"
#include "csg/solid/detail/form_bounds.h"

namespace csgcast::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t largest_program = 250'000;  // planes times bits of a coefficient

using Program = std::vector<Constraint<3>>;

mpq_class rational(const Dyadic& integer) {
  CSGCAST_PRECONDITION(integer.exponent() >= 0);
  return mpq_class(integer.mantissa() << static_cast<mp_bitcnt_t>(integer.exponent()));
}

// Precondition: the forms are canonical up to sign, so that all coefficients are integers.
Program program_of(std::span<const QuadricForm> planes) {
  Program program;
  for (const QuadricForm& f : planes) {
    const auto& c = f.coefficient;
    program.push_back({{rational(c[QuadricForm::x]), rational(c[QuadricForm::y]), rational(c[QuadricForm::z])},
                       rational(-c[QuadricForm::one])});
  }
  std::mt19937_64 random(0x9e3779b97f4a7c15u);
  for (std::size_t i = program.size(); i > 1; --i) std::swap(program[i - 1], program[random() % i]);
  return program;
}

std::int64_t largest_magnitude(std::span<const QuadricForm> planes) {
  std::int64_t bits = 1;
  for (const QuadricForm& f : planes) {
    for (const Dyadic& c : f.coefficient) {
      if (!c.is_zero()) bits = std::max(bits, c.magnitude());
    }
  }
  return bits;
}

// The extent along axis * sense, as an upper bound of sense * coordinate.
struct Reach {
  mpq_class vertex;  // every extreme point, and every optimum of a bounded program, is nearer to the origin
  mpq_class box;     // an unbounded program that is confined to this box still gets beyond `vertex`
};

// With integer coefficients below 2^b, Cramer's rule gives the coordinates of some optimal point as quotients of
// determinants below 6 * 2^3b, so below v = 2^(3b+3). An unbounded direction can be taken with integer components below
// 2 * 2^2b, and a component of at least 1 along the objective: starting from a point within v, it goes on for (box - v)
// / 2^(2b+1) steps, which leads beyond v if box = v 2^(2b+4).
Reach reach_of(std::int64_t b) {
  const auto power = [](std::int64_t e) { return mpq_class(mpz_class(1) << static_cast<mp_bitcnt_t>(e)); };
  return {power(3 * b + 3), power(5 * b + 7)};
}

// The largest sense * coordinate, rounded up. Nothing if the polyhedron is empty.
std::optional<double> farthest(const Program& program, std::size_t axis, int sense, const Reach& reach) {
  std::array<mpq_class, 3> objective;
  objective[axis] = sense;
  const auto best = maximise(program, objective, reach.box);
  if (!best) return std::nullopt;
  const mpq_class value = sense * (*best)[axis];
  if (value > reach.vertex) return infinity;
  return quotient({value.get_num(), 0}, {value.get_den(), 0}, Toward::up).rounded_up();
}

Box box_of_axis_aligned(std::span<const QuadricForm> planes) {
  Box box = Box::everything();
  for (const QuadricForm& f : planes) box = intersection(box, bounds(f));
  return box;
}

}  // namespace

Box polyhedron_bounds(std::span<const QuadricForm> planes) {
  const std::int64_t bits = largest_magnitude(planes);
  if (planes.size() * static_cast<std::size_t>(bits) > largest_program) return box_of_axis_aligned(planes);
  const Program program = program_of(planes);
  const Reach reach = reach_of(bits);
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto upper = farthest(program, axis, 1, reach);
    const auto negated_lower = farthest(program, axis, -1, reach);
    if (!upper || !negated_lower) return {};
    box.lower[axis] = -*negated_lower;
    box.upper[axis] = *upper;
  }
  return box;
}

}  // namespace csgcast::detail
