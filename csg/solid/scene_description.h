// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "csg/base/digits.h"
#include "csg/base/error.h"
#include "csg/base/vector.h"
#include "csg/solid/look.h"
#include "csg/solid/solid.h"

namespace csgcast {

/// A camera statement: perspective with a vertical field of view in degrees, or parallel with a height in units of
/// length.
struct CameraDescription {
  Point eye{};
  Point look_at{};
  Vector up{0, 0, 1};
  double fov = 30;                 ///< vertical, degrees, in (0, 180)
  std::optional<double> height{};  ///< parallel projection if set
};

/// A light statement: a point light (position) or a directional one (direction: where its light goes).
struct LightDescription {
  std::optional<Point> position{};
  std::optional<Vector> direction{};
  Rgb color{1, 1, 1};  ///< linear
  double intensity = 1;
  std::optional<double>
      falloff;  ///< inverse-square, with `intensity` reached at this distance; none: the same everywhere
};

struct RenderSettings {
  int max_depth = 5;
  double min_contribution = 1.0 / 512;
};

/// A picture of all that is seen beyond the solid, by longitude and latitude: shade/light/environment.h.
struct BackgroundImage {
  std::string path;
  Place place{};  ///< the statement that names it
};

/// All that a scene text says.
struct SceneDescription {
  Solid solid;
  std::optional<CameraDescription> camera;
  std::vector<LightDescription> lights;
  std::optional<Rgb> background;
  std::optional<BackgroundImage> background_image;  ///< if there is one, there is no background colour
  RenderSettings settings;
  Digits digits{};            ///< of the numbers of solids and transforms, as the text says, or as they show
  std::uint64_t faceted = 0;  ///< how many round solids of the text became polyhedra
  std::vector<Warning> warnings;
};

}  // namespace csgcast
