// SPDX-License-Identifier: MIT
#include "verify/surface_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "csg/exact/dyadic.h"
#include "csg/exact/quadric_form.h"

namespace csgcast::verify {
namespace {

using Form = QuadricForm;

constexpr int most_steps = 30;

double longest(Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// The power of two that the world's coefficients of a surface are divided by.
std::int64_t scale_of(const Form& form) {
  std::int64_t scale = std::numeric_limits<std::int64_t>::min();
  for (const Dyadic& c : form.coefficient) {
    if (!c.is_zero()) scale = std::max(scale, c.magnitude());
  }
  return scale;
}

Vector world_gradient(const Surface& surface, Point p) {
  const auto& c = surface.world;
  return {2 * c[Form::xx] * p.x + c[Form::xy] * p.y + c[Form::xz] * p.z + c[Form::x],
          2 * c[Form::yy] * p.y + c[Form::xy] * p.x + c[Form::yz] * p.z + c[Form::y],
          2 * c[Form::zz] * p.z + c[Form::xz] * p.x + c[Form::yz] * p.y + c[Form::z]};
}

// The gradient at p, in the scale of the world's coefficients. Only the last step rounds.
Vector exact_gradient(const Form& form, Point p) {
  const auto& c = form.coefficient;
  const std::int64_t scale = scale_of(form);
  const Dyadic two(2.0);
  const Dyadic x(p.x);
  const Dyadic y(p.y);
  const Dyadic z(p.z);
  return {(two * c[Form::xx] * x + c[Form::xy] * y + c[Form::xz] * z + c[Form::x]).scaled(-scale).nearest(),
          (two * c[Form::yy] * y + c[Form::xy] * x + c[Form::yz] * z + c[Form::y]).scaled(-scale).nearest(),
          (two * c[Form::zz] * z + c[Form::xz] * x + c[Form::yz] * y + c[Form::z]).scaled(-scale).nearest()};
}

// The shortest step from p onto all tangent planes at once. It takes one direction after the other, each square to
// those before.
std::optional<Vector> newton_step(const Scene& scene, std::span<const SurfaceId> surfaces, Point p) {
  CSGCAST_PRECONDITION(surfaces.size() <= 3);
  std::array<Vector, 3> axis;
  Vector step;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& surface = scene.surface(surfaces[i]);
    const Vector slope = world_gradient(surface, p);
    const Vector normal = normalised(slope);
    if (normal == Vector{}) return std::nullopt;
    const Form form = surface.exact.unpacked();
    const double distance = form.at(p).scaled(-scale_of(form)).nearest() / length(slope) + dot(normal, step);
    Vector rest = normal;
    for (std::size_t j = 0; j < i; ++j) rest = rest - dot(rest, axis[j]) * axis[j];
    constexpr double tangent = 1e-7;
    if (!(length(rest) > tangent)) return std::nullopt;
    axis[i] = normalised(rest);
    step = step - (distance / dot(normal, axis[i])) * axis[i];
  }
  if (!is_finite(step)) return std::nullopt;
  return step;
}

// The symmetric matrix of twice the second-degree part.
using Matrix = std::array<Vector, 3>;
Matrix second_degree(const Surface::Coefficients& c) {
  return {Vector{2 * c[Form::xx], c[Form::xy], c[Form::xz]}, Vector{c[Form::xy], 2 * c[Form::yy], c[Form::yz]},
          Vector{c[Form::xz], c[Form::yz], 2 * c[Form::zz]}};
}

// Solves m x = v. Returns nothing if the matrix is singular, or so nearly singular that rounding may be the reason.
std::optional<Vector> solve(Matrix m, Vector v) {
  const double size = std::max({longest(m[0]), longest(m[1]), longest(m[2])});
  if (!(size > 0)) return std::nullopt;
  for (Vector& row : m) row = (1 / size) * row;
  v = (1 / size) * v;
  const Vector a = cross(m[1], m[2]);
  const double determinant = dot(m[0], a);
  if (!(std::fabs(determinant) > 1e-12)) return std::nullopt;
  // The matrix is symmetric: its rows are its columns.
  return (1 / determinant) * Vector{dot(v, a), dot(v, cross(m[2], m[0])), dot(v, cross(m[0], m[1]))};
}

Vector without_rounding(Vector v) {
  const double least = 1e-13 * longest(v);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(v[i]) < least) v[i] = 0;
  }
  return v;
}

}  // namespace

std::optional<Point> meeting_point(const Scene& scene, std::span<const SurfaceId> surfaces, Point start) {
  if (std::any_of(surfaces.begin(), surfaces.end(), [&](SurfaceId id) { return scene.surface(id).other != nullptr; }))
    return std::nullopt;
  Point p = start;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<Vector> step = newton_step(scene, surfaces, p);
    if (!step) return std::nullopt;
    const double now = longest(*step);
    const Point next = p + *step;
    const double reach = std::max(longest(as_vector(next)), std::ldexp(1.0, scene.frame().exponent));
    // At the limit of rounding the steps stay as they are.
    const bool settled = now <= 0x1p-40 * reach;
    if (next == p || (settled && now >= 0.5 * before)) return p;
    p = next;
    before = now;
  }
  return std::nullopt;
}

std::optional<Point> center_of(const Scene& scene, SurfaceId id) {
  const Surface& surface = scene.surface(id);
  if (surface.is_plane || surface.other != nullptr) return std::nullopt;
  const Frame& frame = scene.frame();
  const auto& c = surface.local;
  const Matrix m = second_degree(c);
  const std::optional<Vector> q = solve(m, -Vector{c[Form::x], c[Form::y], c[Form::z]});
  if (!q) return std::nullopt;
  Point p = frame.center + std::ldexp(1.0, frame.exponent) * (surface.center + *q);
  for (int i = 0; i < 3; ++i) {
    const std::optional<Vector> step =
        solve(second_degree(surface.world), -exact_gradient(surface.exact.unpacked(), p));
    if (!step || !is_finite(*step)) break;
    p = p + *step;
  }
  if (!is_finite(p)) return std::nullopt;
  return p;
}

Vector normal_at(const Scene& scene, SurfaceId surface, Point p) {
  return normalised(gradient(scene.surface(surface), scene.frame(), p));
}

std::vector<Vector> straight_lines(const Scene& scene, SurfaceId id, Point on_it) {
  const Surface& surface = scene.surface(id);
  const Vector normal = normal_at(scene, id, on_it);
  if (surface.is_plane || normal == Vector{}) return {};
  const Matrix m = second_degree(surface.local);
  const auto product = [&](Vector u, Vector v) { return u.x * dot(m[0], v) + u.y * dot(m[1], v) + u.z * dot(m[2], v); };
  std::size_t flattest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(normal[i]) < std::fabs(normal[flattest])) flattest = i;
  }
  Vector side;
  side[flattest] = 1;
  // The second-degree form on the tangent plane: a u² + 2 b u v + c v².
  const Vector e = normalised(cross(normal, side));
  const Vector g = cross(normal, e);
  const double a = product(e, e);
  const double b = product(e, g);
  const double c = product(g, g);
  const double size = std::max({std::fabs(a), std::fabs(b), std::fabs(c)});
  if (!(size > 0)) return {e, g};
  double discriminant = b * b - a * c;
  constexpr double rounding = 1e-9;  // of a point an ulp off the surface, and of the form itself
  if (std::fabs(discriminant) < rounding * size * size) discriminant = 0;
  if (discriminant < 0) return {};
  std::vector<Vector> lines;
  for (const double root : {std::sqrt(discriminant), -std::sqrt(discriminant)}) {
    const Vector d = std::fabs(a) >= std::fabs(c) ? ((root - b) / a) * e + g : e + ((root - b) / c) * g;
    if (is_finite(d)) lines.push_back(without_rounding(normalised(d)));
    if (root == 0) break;
  }
  return lines;
}

}  // namespace csgcast::verify
