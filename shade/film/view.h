// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "csg/solid/scene_description.h"
#include "raycast/scene/scene.h"
#include "shade/light/environment.h"

namespace csgcast {

/// From where, in what light and how far a scene is looked at: everything that a description may leave open, decided.
struct View {
  CameraDescription camera;
  std::vector<LightDescription> lights;
  Rgb background;  ///< what is seen beyond the solid, without an environment
  RenderSettings settings;
  std::shared_ptr<const Environment> environment{};

  /// What is seen beyond the solid in a direction, which is not zero.
  Rgb sky(Vector direction) const { return environment ? environment->color(direction) : background; }
};

/// The description's camera, lights, background and settings, or their defaults: a camera that frames the solid (of an
/// unbounded one its bounded leaves) in pictures of `aspect` = width / height, one point light beside the camera, a
/// pale blue sky. Throws Error(input_output), with the statement's place, if its background image cannot be read, and
/// Error(unsupported) where csgcast reads no pictures.
View make_view(const SceneDescription& description, const Scene& scene, double aspect);

/// A camera from above the front right that has the whole box in the picture with a small margin; of a box that is null
/// or infinite: a unit cube's.
CameraDescription framing_camera(const Box& box, double aspect);

/// A point light above and to the left of the camera.
LightDescription headlight(const CameraDescription& camera);

/// OpenSCAD's --camera: six numbers are eye and centre; seven are translate x, y, z, rotate x, y, z in degrees, and
/// distance, with OpenSCAD's vertical field of view of 22.5 degrees. Throws Error(usage) for another count and
/// Error(bad_value) for numbers that are not finite.
CameraDescription camera_from_numbers(const std::vector<double>& numbers);

}  // namespace csgcast
