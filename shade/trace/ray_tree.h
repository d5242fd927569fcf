// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "csg/solid/look.h"
#include "raycast/scene/scene.h"

namespace csgcast {

enum class RayKind : std::uint8_t { primary, shadow, reflection, transmission };

/// What became of a ray.
enum class Fate : std::uint8_t {
  hit,             ///< it met a boundary
  left,            ///< it left the scene: the background
  at_depth_limit,  ///< not traced: the background
  below_cutoff,    ///< not traced: too little could come of it
  facing_away,     ///< a shadow ray, not traced: the light is behind the surface
  without_effect,  ///< a shadow ray, not traced: the light adds nothing
  blocked,         ///< a shadow ray that did not reach its light
  arrived,         ///< a shadow ray that did
};

/// One ray of a pixel.
struct RayRecord {
  RayKind kind = RayKind::primary;
  Fate fate = Fate::left;
  int depth = 0;        ///< 0 for the primary ray
  Rgb weight{1, 1, 1};  ///< the share of what it finds that reaches the pixel (shadow rays: of the light that passes)
  double t = 0;         ///< distance to the hit
  LeafId leaf{};        ///< the leaf that it met
  SurfaceId surface{};  ///< the surface of its that it met
  LookId look{};
  bool total = false;     ///< a reflection that takes what total internal reflection keeps from being transmitted
  std::size_t light = 0;  ///< the light of a shadow ray, from 0
  Rgb brings{};  ///< what it adds to the pixel by itself: background, or the hit's local light; of a shadow ray:
                 ///< counted in its parent's
};

/// The rays of a pixel, each after its parent and before its parent's next child.
using RayTree = std::vector<RayRecord>;

/// A line for each ray, indented by depth. The `brings` of all but shadow rays add up to the pixel.
std::string to_string(const RayTree& tree, const Scene& scene);

}  // namespace csgcast
