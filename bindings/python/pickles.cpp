// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "bindings/python/bind.h"
#include "csg/solid/scene_description.h"
#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/each_statement.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"

// What solids and descriptions are to pickle: a scene text, and plain numbers.

namespace csgcast::python {
namespace {

using text::Document;
using text::Node;

/// Scene text; the name of the file that places are in; line and column of each statement, 0 where none is known.
using SolidState = std::tuple<std::string, std::string, py::bytes>;

SolidState state_of(const Solid& solid) {
  const Document document = text::document_of(solid);
  std::string places;
  bool any = false;
  text::each_statement(std::span<const Node>(document.nodes), [&](const Node& node) {
    for (const int number : {node.line, node.column}) {
      any = any || number != 0;
      for (unsigned shift = 0; shift < 32; shift += 8)
        places += static_cast<char>((static_cast<std::uint32_t>(number) >> shift) & 0xffu);
    }
  });
  return {text::write(document), document.file.string(), py::bytes(any ? places : std::string())};
}

/// The same solid, but for places in other files than the first.
Solid solid_of(const SolidState& state) {
  const auto& [scene, file, bytes] = state;
  const auto places = bytes.cast<std::string>();
  Document document = text::read(scene, file);
  std::size_t next = 0;
  const auto number = [&] {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 32 && next < places.size(); shift += 8)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(places[next++])) << shift;
    return static_cast<int>(value);
  };
  text::each_statement(std::span<Node>(document.nodes), [&](Node& node) {
    node.line = number();
    node.column = number();
  });
  return text::build(std::move(document), {text::Facets::never}).solid;
}

using Three = std::tuple<double, double, double>;
template <class T>
Three three(const T& v) {
  return {v.x, v.y, v.z};
}
template <class T>
T from(const Three& v) {
  return {std::get<0>(v), std::get<1>(v), std::get<2>(v)};
}
Three channels_of(const Rgb& c) { return {c.r, c.g, c.b}; }

using CameraState = std::tuple<Three, Three, Three, double, std::optional<double>>;
using LightState = std::tuple<std::optional<Three>, std::optional<Three>, Three, double, std::optional<double>>;
using WarningState = std::tuple<std::string, int, int, std::string>;
/// All but the solid.
using DescriptionState = std::tuple<std::optional<CameraState>, std::vector<LightState>, std::optional<Three>, int,
                                    double, std::vector<WarningState>, std::optional<std::string>>;

DescriptionState state_of(const SceneDescription& d) {
  std::optional<CameraState> camera;
  if (d.camera) {
    camera = {three(d.camera->eye), three(d.camera->look_at), three(d.camera->up), d.camera->fov, d.camera->height};
  }
  std::vector<LightState> lights;
  for (const LightDescription& light : d.lights) {
    lights.emplace_back(light.position ? std::optional(three(*light.position)) : std::nullopt,
                        light.direction ? std::optional(three(*light.direction)) : std::nullopt,
                        channels_of(light.color), light.intensity, light.falloff);
  }
  const std::optional<Three> background = d.background ? std::optional(channels_of(*d.background)) : std::nullopt;
  std::vector<WarningState> warnings;
  for (const Warning& w : d.warnings)
    warnings.emplace_back(w.place.file.string(), w.place.line, w.place.column, w.text);
  const auto image = d.background_image ? std::optional(d.background_image->path) : std::nullopt;
  return {camera, lights, background, d.settings.max_depth, d.settings.min_contribution, warnings, image};
}

SceneDescription description_of(const DescriptionState& state, const Solid& solid) {
  const auto& [camera, lights, background, max_depth, min_contribution, warnings, image] = state;
  SceneDescription d;
  d.solid = solid;
  if (camera) {
    const auto& [eye, look_at, up, fov, height] = *camera;
    d.camera = CameraDescription{from<Point>(eye), from<Point>(look_at), from<Vector>(up), fov, height};
  }
  for (const auto& [position, direction, color, intensity, falloff] : lights) {
    LightDescription light;
    if (position) light.position = from<Point>(*position);
    if (direction) light.direction = from<Vector>(*direction);
    light.color = from<Rgb>(color);
    light.intensity = intensity;
    light.falloff = falloff;
    d.lights.push_back(light);
  }
  if (background) d.background = from<Rgb>(*background);
  if (image) d.background_image = BackgroundImage{*image};
  d.settings = {max_depth, min_contribution};
  for (const auto& [file, line, column, text] : warnings) {
    Warning warning;
    warning.place = {FileName(file), line, column};
    warning.text = text;
    d.warnings.push_back(warning);
  }
  return d;
}

}  // namespace

void bind_pickles(py::module_& m) {
  m.def("_solid_state", [](const Solid& solid) { return state_of(solid); });
  m.def("_solid_of", solid_of);
  m.def("_description_state", [](const SceneDescription& description) { return state_of(description); });
  m.def("_description_of", description_of);
}

}  // namespace csgcast::python
