// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace csgcast {

/// Linear RGB, no upper limit.
struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(double s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }

/// IEC 61966-2-1, one channel in [0, 1].
double linear_from_srgb(double encoded);
double srgb_from_linear(double linear);

/// The answer of a surface to light. The model is in shade/light/phong.h. The default colour is OpenSCAD's yellow.
struct Material {
  Rgb color{0.947306542, 0.679542454, 0.025186860};  ///< #f9d72c
  double ambient = 0.15;
  double diffuse = 0.7;
  double specular = 0.2;
  double shininess = 30;
  double reflection = 0;
  double transmission = 0;
  double ior = 1;  ///< index of refraction
  Rgb emission;    ///< light that the surface itself sends out
  Rgb absorption;  ///< per unit of length, for a medium that transmits
  friend bool operator==(const Material&, const Material&) = default;

  bool transmits() const { return transmission > 0; }
};

/// A color statement: base colour in linear RGB and opacity.
struct Paint {
  Rgb color;
  double alpha = 1;
  friend bool operator==(const Paint&, const Paint&) = default;
};

/// What one look statement sets: a material (the innermost wins) or a paint (the outermost wins).
struct LookStatement {
  std::optional<Material> material;
  std::optional<Paint> paint;
};

/// The look statements on the way from the root to a leaf, resolved step by step from the outside in.
struct LookContext {
  std::optional<Material> material;
  std::optional<Paint> paint;
  friend bool operator==(const LookContext&, const LookContext&) = default;

  /// The context below one more statement.
  LookContext with(const LookStatement& inner) const;
  /// The material to shade with: a paint replaces the base colour; its transparency 1 - alpha transmits and takes that
  /// share from the local light.
  Material resolve() const;
};

}  // namespace csgcast
