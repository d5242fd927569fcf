// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <string>

#include "bindings/python/bind.h"
#include "csg/file/whole_file.h"
#include "csg/solid/rules/rules.h"
#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "model/model.h"
#include "shade/film/camera.h"
#include "shade/picture/image_file.h"

namespace csgcast::python {
namespace {

using namespace py::literals;

text::Facets facets_named(const std::string& name) {
  if (name == "auto") return text::Facets::automatic;
  if (name == "always") return text::Facets::always;
  if (name == "never") return text::Facets::never;
  throw py::value_error("facets must be 'auto', 'always' or 'never'");
}

Mode mode_named(const std::string& name) {
  if (name == "shaded") return Mode::shaded;
  if (name == "edges") return Mode::edges;
  if (name == "xray") return Mode::xray;
  if (name == "depth") return Mode::depth;
  if (name == "normal") return Mode::normal;
  if (name == "id") return Mode::id;
  throw py::value_error("mode must be 'shaded', 'edges', 'xray', 'depth', 'normal' or 'id'");
}

SceneDescription read_text(const std::string& text, const std::string& facets, bool skip_unsupported) {
  return text::build(text::read(text, "<text>"), {facets_named(facets), skip_unsupported});
}

SceneDescription load(const std::string& path, const std::string& facets, bool skip_unsupported) {
  return text::build(text::read_file(path), {facets_named(facets), skip_unsupported});
}

std::vector<std::string> warnings_of(const SceneDescription& description) {
  std::vector<std::string> texts;
  for (const Warning& warning : description.warnings) texts.push_back(to_string(warning));
  return texts;
}

/// eye, look_at, and maybe up, fov and height.
CameraDescription camera_from(const py::dict& numbers) {
  CameraDescription camera;
  if (!numbers.contains("eye") || !numbers.contains("look_at")) throw py::value_error("a camera needs eye and look_at");
  const Vector eye = vector_from(numbers["eye"], "eye");
  const Vector at = vector_from(numbers["look_at"], "look_at");
  camera.eye = {eye.x, eye.y, eye.z};
  camera.look_at = {at.x, at.y, at.z};
  for (const auto& [key, value] : numbers) {
    const std::string name = key.cast<std::string>();
    if (name == "up") {
      camera.up = vector_from(value, "up");
    } else if (name == "fov") {
      camera.fov = value.cast<double>();
    } else if (name == "height") {
      camera.height = value.cast<double>();
    } else if (name != "eye" && name != "look_at") {
      throw py::value_error("a camera has no '" + name + "'; it takes eye, look_at, up, fov and height");
    }
  }
  return camera;
}

/// A Light of csgcast/__init__.py.
LightDescription light_of(const py::handle& told) {
  LightDescription light;
  const py::object position = told.attr("position"), direction = told.attr("direction");
  if (!position.is_none()) {
    const Vector v = vector_from(position, "position");
    light.position = Point{v.x, v.y, v.z};
  }
  if (!direction.is_none()) light.direction = vector_from(direction, "direction");
  light.color = light_from(told.attr("color"), "color");
  light.intensity = told.attr("intensity").cast<double>();
  light.falloff = told.attr("falloff").cast<std::optional<double>>();
  require(broken_rule(light), "light");
  return light;
}

/// A Settings.
RenderSettings settings_of(const py::handle& told) {
  const RenderSettings settings{told.attr("max_depth").cast<int>(), told.attr("min_contribution").cast<double>()};
  require(broken_rule(settings), "settings");
  return settings;
}

/// What is None is left as it is.
ViewChange change_of(const py::object& camera, const py::object& lights, const py::object& background,
                     const py::object& settings) {
  ViewChange change;
  if (!camera.is_none()) change.camera = camera_from(camera.cast<py::dict>());
  if (!lights.is_none()) {
    change.lights.emplace();
    for (const py::handle& light : lights) change.lights->push_back(light_of(light));
  }
  if (!background.is_none()) change.background = light_from(background, "background");
  if (!settings.is_none()) change.settings = settings_of(settings);
  return change;
}

SceneDescription described(const Solid& solid, const py::object& camera, const py::object& lights,
                           const py::object& background, const py::object& settings) {
  ViewChange change = change_of(camera, lights, background, settings);
  SceneDescription description;
  description.solid = solid;
  description.camera = change.camera;
  if (change.lights) description.lights = std::move(*change.lights);
  description.background = change.background;
  if (change.settings) description.settings = *change.settings;
  return description;
}

py::tuple tuple_of(double x, double y, double z) { return py::make_tuple(x, y, z); }
template <class Tag>
py::tuple tuple_of(const Triple<Tag>& t) {
  return tuple_of(t.x, t.y, t.z);
}

/// The arguments of a Camera; None without one.
py::object camera_told(const SceneDescription& description) {
  if (!description.camera) return py::none();
  const CameraDescription& camera = *description.camera;
  py::dict told;
  told["eye"] = tuple_of(camera.eye);
  told["look_at"] = tuple_of(camera.look_at);
  told["up"] = tuple_of(camera.up);
  camera.height ? told["height"] = *camera.height : told["fov"] = camera.fov;
  return told;
}

/// The arguments of each Light.
py::list lights_told(const SceneDescription& description) {
  py::list lights;
  for (const LightDescription& light : description.lights) {
    py::dict told;
    if (light.position) told["position"] = tuple_of(*light.position);
    if (light.direction) told["direction"] = tuple_of(*light.direction);
    told["color"] = tuple_of(light.color.r, light.color.g, light.color.b);
    told["intensity"] = light.intensity;
    told["falloff"] = light.falloff;
    lights.append(told);
  }
  return lights;
}

py::object background_told(const SceneDescription& description) {
  if (!description.background) return py::none();
  const Rgb& color = *description.background;
  return tuple_of(color.r, color.g, color.b);
}

/// Four numbers, or None for the whole picture.
std::optional<PixelRegion> region_from(const py::object& region) {
  if (region.is_none()) return std::nullopt;
  const auto [x0, y0, x1, y1] = region.cast<std::tuple<int, int, int, int>>();
  return PixelRegion{x0, y0, x1, y1};
}

/// How a picture is made: the arguments of Model.render() but for those of the view.
struct PictureArguments {
  int width;
  int height;
  int samples;
  std::string mode;
  bool adaptive;
  std::optional<PixelRegion> region;
};

Film picture(const Model& model, const PictureArguments& arguments, const ViewChange& change, py::object callback,
             int threads) {
  RenderOptions options;
  options.width = arguments.width;
  options.height = arguments.height;
  options.samples = arguments.samples;
  options.mode = mode_named(arguments.mode);
  options.sampling = arguments.adaptive ? Sampling::adaptive : Sampling::regular;
  options.region = arguments.region;
  Callbacks callbacks(std::move(callback), threads);
  options.progress = callbacks.progress();
  return callbacks.run([&] {
    const double aspect = static_cast<double>(options.width) / std::max(options.height, 1);
    return model.render(model.view(aspect, change), options);
  });
}

py::array as_array(const Film& film) {
  std::vector<float> values = film.values();
  const int count = channels(film.content());
  if (count == 1) return array_of<float>(std::move(values), {film.height(), film.width()});
  return array_of<float>(std::move(values), {film.height(), film.width(), count});
}

}  // namespace

void bind_pictures(py::module_& m) {
  py::class_<SceneDescription>(m, "_Description")
      .def(py::init<>())
      .def_readonly("solid", &SceneDescription::solid)
      .def("with_solid",
           [](SceneDescription description, const Solid& solid) {
             description.solid = solid;
             return description;
           })
      .def_property_readonly("camera", camera_told)
      .def_property_readonly("lights", lights_told)
      .def_property_readonly("background", background_told)
      .def_property_readonly("settings",
                             [](const SceneDescription& description) {
                               const RenderSettings& settings = description.settings;
                               return py::make_tuple(settings.max_depth, settings.min_contribution);
                             })
      .def_property_readonly("warnings", warnings_of);
  m.def("_load", load, "path"_a, "facets"_a, "skip_unsupported"_a);
  m.def("_read", read_text, "text"_a, "facets"_a, "skip_unsupported"_a);
  m.def("_text_of", [](const Solid& solid) { return text::write(text::document_of(solid)); });
  m.def("_save_text", [](const Solid& solid, const std::string& path) {
    WholeFile file(path);
    file.write(text::write(text::document_of(solid)));
    file.commit();
  });
  m.def("_render", [](const Model& model, int width, int height, int samples, const std::string& mode, bool adaptive,
                      const py::object& region, const py::object& camera, const py::object& lights,
                      const py::object& background, const py::object& settings, py::object callback, int threads) {
    const ViewChange change = change_of(camera, lights, background, settings);
    return as_array(picture(model, {width, height, samples, mode, adaptive, region_from(region)}, change,
                            std::move(callback), threads));
  });
  m.def("_save_picture",
        [](const Model& model, const std::string& path, int width, int height, int samples, const std::string& mode,
           bool adaptive, const py::object& region, const py::object& camera, const py::object& lights,
           const py::object& background, const py::object& settings, py::object callback, int threads) {
          check_image_path(path);
          const ViewChange change = change_of(camera, lights, background, settings);
          write_image(picture(model, {width, height, samples, mode, adaptive, region_from(region)}, change,
                              std::move(callback), threads),
                      path);
        });
  m.def("_band", [](int width, int height, int index, int count) {
    const PixelRegion band = band_of_picture(width, height, index, count);
    return py::make_tuple(band.x0, band.y0, band.x1, band.y1);
  });
  m.def("_described", described);
  m.def("_triple", [](const py::object& value, const char* name) { return tuple_of(vector_from(value, name)); });
  m.def("_light_color", [](const py::object& value, const char* name) {
    const Rgb light = light_from(value, name);
    return tuple_of(light.r, light.g, light.b);
  });
  m.def("_check_camera", [](const py::dict& numbers) { Camera(camera_from(numbers), 1, 1); });
  m.def("_check_light", [](const py::object& told) { light_of(told); });
  m.def("_check_settings", [](const py::object& told) { settings_of(told); });
}

}  // namespace csgcast::python
