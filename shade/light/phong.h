// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/base/length.h"
#include "csg/base/vector.h"
#include "csg/solid/look.h"
#include "csg/solid/scene_description.h"

namespace csgcast {

/// base^exponent for base >= 0. Whole exponents up to 65,536 by repeated squaring: fast, and the same on every machine.
inline double power(double base, double exponent) {
  if (!(exponent >= 0 && exponent <= 65536 && exponent == std::floor(exponent))) return std::pow(base, exponent);
  double result = 1;
  for (auto rest = static_cast<unsigned>(exponent); rest != 0; rest >>= 1u) {
    if ((rest & 1u) != 0) result *= base;
    base *= base;
  }
  return result;
}

/// What one light sends to one point.
struct Illumination {
  Vector to_light;        ///< unit
  Vector path;            ///< along to_light, not unit: a point light is reached at 1 times it
  bool is_finite = true;  ///< the light is at point + path; else infinitely far away
  Rgb light;              ///< falloff included
};

/// None where the direction is not defined (the point is the light's place) or beyond the range of double.
inline std::optional<Illumination> illuminate(const LightDescription& light, Point p) {
  Illumination result;
  result.is_finite = light.position.has_value();
  result.path = light.position ? *light.position - p : -light.direction.value_or(Vector{0, 0, -1});
  result.to_light = normalised(result.path);
  if (result.to_light == Vector{}) return std::nullopt;
  result.light = light.intensity * light.color;
  if (light.falloff && light.position) {
    const double ratio = *light.falloff / dot(result.path, result.to_light);
    result.light = ratio * ratio * result.light;
  }
  return result;
}

/// v seen in a mirror with unit normal n.
constexpr Vector mirrored(Vector v, Vector n) { return v - 2 * dot(v, n) * n; }

/// What one unshadowed light adds: (diffuse color (n.l) + specular (r.v)^shininess) light, nothing where n.l <= 0.
/// `normal` and `to_viewer` are unit, the normal on the viewer's side. Source: Phong 1975; highlights have the light's
/// colour.
inline Rgb phong(const Material& material, Vector normal, Vector to_viewer, const Illumination& from) {
  const double n_l = dot(normal, from.to_light);
  if (!(n_l > 0)) return {};
  Rgb share = material.diffuse * n_l * material.color;
  const double r_v = dot(mirrored(-from.to_light, normal), to_viewer);
  if (material.specular > 0 && r_v > 0) {
    const double highlight = material.specular * power(r_v, material.shininess);
    share = share + Rgb{highlight, highlight, highlight};
  }
  return share * from.light;
}

/// What a surface shows without any light: ambient color + emission.
inline Rgb unlit(const Material& material) { return material.ambient * material.color + material.emission; }

/// What is left of light after a length of a medium: exp(-absorption length). An infinite length of a clear medium
/// takes nothing.
inline Rgb transmittance(Rgb absorption, double length) {
  const auto channel = [length](double a) { return a > 0 ? std::exp(-a * length) : 1.0; };
  return {channel(absorption.r), channel(absorption.g), channel(absorption.b)};
}

/// The direction behind a surface by Snell's law, unit; none at total internal reflection. `incoming` and `normal` are
/// unit, the normal on the incoming side; `ratio` is the index of refraction before over that behind.
inline std::optional<Vector> refracted(Vector incoming, Vector normal, double ratio) {
  if (ratio == 1) return incoming;
  const double cos_in = -dot(incoming, normal);
  const double sin2_out = ratio * ratio * (1 - cos_in * cos_in);
  if (!(sin2_out < 1)) return std::nullopt;
  return normalised(ratio * incoming + (ratio * cos_in - std::sqrt(1 - sin2_out)) * normal);
}

constexpr double brightest(Rgb color) { return std::max({color.r, color.g, color.b}); }

}  // namespace csgcast
