// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "csg/solid/look.h"
#include "csg/solid/scene_description.h"
#include "shade/film/camera.h"

// Camera rays and Phong's model in lanes: the interface of the code that is compiled for each instruction set
// (shading_lanes.cpp). The same numbers as Camera::ray and shade/light/phong.h, bit for bit.

namespace csgcast::detail {

/// What samples of a picture see, as arrays.
struct ShadingPoints {
  std::size_t count = 0;
  const std::uint8_t* is_plain = nullptr;  ///< 1 for those to be shaded: an opaque face seen from outside; eight more
  const double* point[3] = {};
  const double* normal[3] = {};         ///< unit, out of the solid
  const double* direction[3] = {};      ///< of the rays that see them, unit
  const std::uint32_t* look = nullptr;  ///< eight more, of any value
  /// 1 for those whose outside leads away (Scene::leads_away), eight more; null if there are none.
  const std::uint8_t* leads_away = nullptr;
};

/// The shadow rays to one light, close together, and what the light adds if nothing is in their way. Room for as many
/// as samples, and eight.
struct ShadowRays {
  std::size_t count = 0;
  std::uint64_t facing_away = 0;     ///< samples without one: the light is behind the surface
  std::uint64_t without_effect = 0;  ///< it would add nothing
  std::uint64_t leading_away = 0;    ///< nothing can be in its way: the light is added to the colour at once
  double* origin[3] = {};
  double* path[3] = {};  ///< towards the light (Illumination::path)
  double* light[3] = {};
  std::uint32_t* sample = nullptr;  ///< whose ray it is
};

struct ShadingCode {
  /// The directions of the rays through places (x, y) of the picture, and their origins.
  void (*camera_rays)(const CameraFrame& camera, std::size_t count, const double* x, const double* y,
                      double* const* origin, double* const* direction);
  /// What plain samples show without any light: ambient and emission. The others get anything.
  void (*unlit)(const Material* looks, const ShadingPoints& points, double* const* color);
  /// The shadow rays to a light. What needs none because it leads away gets its light at once, on top of its colour.
  void (*light)(const Material* looks, const LightDescription& light, const ShadingPoints& points, ShadowRays& rays,
                double* const* color);
};

/// Of one of PacketCaster::instruction_sets(); by default of the best that this machine has.
const ShadingCode& shading_code(std::string_view instructions = {});

}  // namespace csgcast::detail
