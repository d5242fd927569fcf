// SPDX-License-Identifier: MIT
#include "shade/film/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "csg/base/transform.h"
#include "shade/module/picture_module.h"

namespace csgcast {
namespace {

constexpr Rgb default_background{0.62, 0.72, 0.83};

constexpr double openscad_fov = 22.5;

// What each corner demands of the distance between eye and centre, so that it is within the cone of view.
double framing_distance(const Box& box, Vector forward, Vector right, Vector up, double tan_x, double tan_y) {
  double distance = 0;
  const Vector half = 0.5 * box.size();
  for (int corner = 0; corner < 8; ++corner) {
    const Vector c{(corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                   (corner & 4) != 0 ? half.z : -half.z};
    const double nearer = -dot(c, forward);
    distance = std::max({distance, nearer + std::fabs(dot(c, right)) / tan_x, nearer + std::fabs(dot(c, up)) / tan_y});
  }
  return distance;
}

// Light that is finite and not negative.
float sound(double x) { return std::isfinite(x) && x > 0 ? static_cast<float>(x) : 0; }

std::shared_ptr<const Environment> environment_of(const BackgroundImage& image) {
  constexpr std::size_t most = std::size_t{1} << 28;  // a gigabyte of numbers
  detail::DecodedPicture picture;
  const detail::PictureModule& module = detail::picture_module(image.place, "give a background color");
  try {
    picture = module.decode(image.path, most);
  } catch (const std::runtime_error& failure) {
    throw Error(ErrorCode::input_output, image.place, "the background image '" + image.path + "' cannot be read",
                failure.what(), "give the path of a picture, from the scene's folder on");
  }
  const std::size_t count = picture.channels.size();
  const std::size_t pixels = picture.values.size() / count;
  std::vector<float> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = picture.values[i * count + (count >= 3 ? c : 0)];
      rgb[3 * i + c] = sound(picture.is_srgb ? linear_from_srgb(value) : value);
    }
  }
  return std::make_shared<const Environment>(picture.width, picture.height, std::move(rgb));
}

}  // namespace

View make_view(const SceneDescription& description, const Scene& scene, double aspect) {
  View view;
  const Box& solid = scene.bounds();
  view.camera = description.camera.value_or(framing_camera(solid.is_finite() ? solid : scene.bounded_leaves(), aspect));
  view.lights = description.lights;
  if (view.lights.empty()) view.lights.push_back(headlight(view.camera));
  view.background = description.background.value_or(default_background);
  view.settings = description.settings;
  if (description.background_image) view.environment = environment_of(*description.background_image);
  return view;
}

CameraDescription framing_camera(const Box& wanted, double aspect) {
  constexpr double margin = 1.06;
  const Box box = wanted.is_finite() ? wanted : Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  CameraDescription camera;
  camera.look_at = box.center();
  const Vector forward = normalised(Vector{-4, 5, -3.5});
  const Vector right = normalised(cross(forward, camera.up));
  const double tan_y = std::tan(camera.fov / 360 * std::numbers::pi) / margin;
  double distance = framing_distance(box, forward, right, cross(right, forward), tan_y * aspect, tan_y);
  // A box without size still is somewhere: stay far enough from it for eye and centre to be told apart.
  const double place =
      std::max({std::fabs(camera.look_at.x), std::fabs(camera.look_at.y), std::fabs(camera.look_at.z)});
  distance = std::max(distance, std::max(place * 0x1p-48, 0x1p-1000));
  camera.eye = camera.look_at - distance * forward;
  return camera;
}

LightDescription headlight(const CameraDescription& camera) {
  const Vector towards = camera.look_at - camera.eye;
  Vector right = cross(normalised(towards), normalised(camera.up));
  if (right == Vector{}) right = {1, 0, 0};
  right = normalised(right);
  const Vector up = cross(right, normalised(towards));
  const double distance = length(towards);
  LightDescription light;
  light.position = camera.eye + distance * (0.35 * up - 0.3 * right);
  return light;
}

CameraDescription camera_from_numbers(const std::vector<double>& numbers) {
  if (numbers.size() != 6 && numbers.size() != 7) {
    throw Error(ErrorCode::usage, {}, "a camera of " + std::to_string(numbers.size()) + " numbers",
                "six are eye and centre, seven are translation, rotation in degrees and distance",
                "give 6 or 7 numbers, separated by commas");
  }
  if (!std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); })) {
    throw Error(ErrorCode::bad_value, {}, "a camera number that is not finite", "it is no place to look from",
                "give ordinary numbers");
  }
  CameraDescription camera;
  camera.fov = openscad_fov;
  if (numbers.size() == 6) {
    camera.eye = {numbers[0], numbers[1], numbers[2]};
    camera.look_at = {numbers[3], numbers[4], numbers[5]};
    return camera;
  }
  // The camera hangs above the origin and looks down, y up in its picture; it is turned like a solid by rotate(), then
  // moved.
  const Transform turn = rotation(Vector{numbers[3], numbers[4], numbers[5]});
  camera.look_at = {numbers[0], numbers[1], numbers[2]};
  camera.eye = camera.look_at + numbers[6] * Vector{turn(0, 2), turn(1, 2), turn(2, 2)};
  camera.up = {turn(0, 1), turn(1, 1), turn(2, 1)};
  return camera;
}

}  // namespace csgcast
