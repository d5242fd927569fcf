// SPDX-License-Identifier: MIT
#include "csg/solid/look.h"

#include <cmath>

namespace csgcast {

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

LookContext LookContext::with(const LookStatement& inner) const {
  LookContext result = *this;
  if (inner.material) result.material = inner.material;
  if (inner.paint && !paint) result.paint = inner.paint;
  return result;
}

Material LookContext::resolve() const {
  Material result = material.value_or(Material{});
  if (!paint) return result;
  result.color = paint->color;
  if (paint->alpha < 1) {
    result.ambient *= paint->alpha;
    result.diffuse *= paint->alpha;
    result.transmission = std::fmax(result.transmission, 1 - paint->alpha);
  }
  return result;
}

}  // namespace csgcast
