// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "csg/base/number_text.h"
#include "csg/base/vector.h"
#include "csg/solid/scene_description.h"

namespace csgcast::cli {

/// `1, 2, 3`.
template <class Tag>
std::string coordinates(const Triple<Tag>& t) {
  return fmt::format("{}, {}, {}", number(t.x), number(t.y), number(t.z));
}

/// `eye 1, 2, 3  look at 0, 0, 0  up 0, 0, 1  field of view 30`, or `parallel, height 2`.
inline std::string camera_text(const CameraDescription& camera) {
  const std::string view = fmt::format("eye {}  look at {}  up {}", coordinates(camera.eye),
                                       coordinates(camera.look_at), coordinates(camera.up));
  return camera.height ? fmt::format("{}  parallel, height {}", view, number(*camera.height))
                       : fmt::format("{}  field of view {}", view, number(camera.fov));
}

}  // namespace csgcast::cli
