// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "csg/look.h"
#include "csg/scene_description.h"
#include "shade/camera.h"

// Camera rays and Phong's model in lanes: the interface of the code that is compiled for each instruction set
// (shading_lanes.cpp). The same numbers as Camera::ray and shade/phong.h, bit for bit.

namespace csgcast::detail {

/// Places on opaque solids to be shaded, as arrays.
struct ShadingPoints {
  std::size_t count = 0;
  const double* point[3] = {};
  const double* normal[3] = {};     ///< unit, out of the solid
  const double* direction[3] = {};  ///< of the rays that see them, unit
  const std::uint32_t* look = nullptr;
};

enum class LightEffect : std::uint8_t {
  facing_away,  ///< the light is behind the surface
  none,         ///< it would add nothing
  some,         ///< it adds `light` unless something is in its way
};

/// What one light would add, as arrays.
struct LightArrays {
  std::uint8_t* effect = nullptr;  ///< LightEffect
  double* light[3] = {};
  double* path[3] = {};  ///< from the point towards the light (Illumination::path)
};

struct ShadingCode {
  std::string_view name;
  /// The directions of the rays through places (x, y) of the picture, and their origins.
  void (*camera_rays)(const CameraFrame& camera, std::size_t count, const double* x, const double* y,
                      double* const* origin, double* const* direction);
  /// What the points show without any light: ambient and emission.
  void (*unlit)(const Material* looks, const ShadingPoints& points, double* const* color);
  void (*light)(const Material* looks, const LightDescription& light, const ShadingPoints& points,
                const LightArrays& result);
};

/// The best that this machine can run.
const ShadingCode& shading_code();

}  // namespace csgcast::detail
