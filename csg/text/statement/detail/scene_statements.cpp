// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/scene_statements.h"

#include <cmath>
#include <filesystem>

#include "csg/base/length.h"
#include "csg/text/statement/detail/color_argument.h"
#include "csg/text/statement/detail/document_digits.h"

namespace csgcast::text {
namespace {

/// The path of a file that a text names: relative ones start at the text's own folder.
std::string beside(const Place& text, const std::string& path) {
  return (std::filesystem::path(text.file.string()).parent_path() / path).string();
}

Point as_point(Vector v) { return {v.x, v.y, v.z}; }

}  // namespace

void apply_camera(const Call& call, SceneDescription& scene) {
  CameraDescription camera;
  camera.eye = as_point(call.required_vector("eye"));
  camera.look_at = as_point(call.required_vector("look_at"));
  camera.up = call.vector("up").value_or(camera.up);
  const Vector view = normalised(camera.look_at - camera.eye);
  call.require(view != Vector{}, "look_at", "differ from 'eye'");
  call.require(cross(view, normalised(camera.up)) != Vector{}, "up", "not be zero nor along the view");
  camera.height = call.number("height");
  camera.fov = call.number_or("fov", camera.fov);
  call.require(camera.fov > 0 && camera.fov < 180, "fov", "be greater than 0 and less than 180");
  if (camera.height) {
    call.require(*camera.height > 0, "height", "be greater than 0");
    call.require(call.find("fov") == nullptr, "fov", "not stand beside 'height', which asks for a parallel projection");
  }
  scene.camera = camera;
}

void apply_light(const Call& call, SceneDescription& scene) {
  LightDescription light;
  if (const auto position = call.vector("position")) light.position = as_point(*position);
  light.direction = call.vector("direction");
  if (light.position.has_value() == light.direction.has_value()) {
    call.reject(ErrorCode::bad_value, call.place(), "'light' needs either 'position' or 'direction'",
                light.position ? "both are given" : "neither is given", "give one of them");
  }
  light.color = color_argument(call, "color").value_or(light.color);
  light.intensity = call.number_or("intensity", light.intensity);
  light.falloff = call.number("falloff");
  call.require(broken_rule(light));
  scene.lights.push_back(light);
}

void apply_background(const Call& call, SceneDescription& scene) {
  scene.background = color_argument(call, "color");
  if (const std::optional<std::string> image = call.string("image")) {
    call.require(!scene.background, "image", "not stand beside 'color'");
    scene.background_image = BackgroundImage{beside(call.place(), *image), call.place()};
  }
  if (!scene.background && !scene.background_image)
    call.missing("color", "a CSS name, \"#rrggbb\" or linear [r, g, b], or 'image', a picture");
}

void apply_settings(const Call& call, SceneDescription& scene) {
  RenderSettings& settings = scene.settings;
  const double depth = call.number_or("max_depth", settings.max_depth);
  const bool is_whole = depth == std::trunc(depth) && std::fabs(depth) <= 1000;
  settings.max_depth = is_whole ? static_cast<int>(depth) : -1;
  settings.min_contribution = call.number_or("min_contribution", settings.min_contribution);
  call.require(broken_rule(settings));
  // What they say was read before the first solid was made.
  if (const std::optional<double> digits = call.number("digits"))
    call.require(is_digit_count(*digits), "digits", "be a whole number from 1 to 17");
}

}  // namespace csgcast::text
