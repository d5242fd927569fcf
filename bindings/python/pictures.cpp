// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <string>

#include "bindings/python/bind.h"
#include "csg/base/whole_file.h"
#include "csg/text/statement/builder.h"
#include "csg/text/statement/solid_text.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "query/model.h"
#include "shade/film/view.h"
#include "shade/picture/image_file.h"
#include "shade/trace/render.h"

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

SceneDescription read_text(const std::string& text, const std::string& facets) {
  return text::build(text::read(text, "<text>"), {facets_named(facets)});
}

SceneDescription load(const std::string& path, const std::string& facets) {
  return text::build(text::read_file(path), {facets_named(facets)});
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

/// Four numbers, or None for the whole picture.
std::optional<PixelRegion> region_from(const py::object& region) {
  if (region.is_none()) return std::nullopt;
  const auto [x0, y0, x1, y1] = region.cast<std::tuple<int, int, int, int>>();
  return PixelRegion{x0, y0, x1, y1};
}

Film picture(const Model& model, const SceneDescription& description, int width, int height, int samples,
             const std::string& mode, const py::object& camera, bool adaptive, const py::object& region,
             py::object callback) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.samples = samples;
  options.mode = mode_named(mode);
  if (adaptive) options.sampling = Sampling::adaptive;
  options.region = region_from(region);
  SceneDescription seen = description;
  if (!camera.is_none()) seen.camera = camera_from(camera.cast<py::dict>());
  Callbacks callbacks(std::move(callback));
  options.progress = callbacks.progress();
  return callbacks.run([&] {
    const double aspect = static_cast<double>(width) / std::max(height, 1);
    return render(model.scene(), make_view(seen, model.scene(), aspect), options);
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
      .def_property_readonly("warnings", warnings_of);
  m.def("_load", load, "path"_a, "facets"_a);
  m.def("_read", read_text, "text"_a, "facets"_a);
  m.def("_text_of", [](const Solid& solid) { return text::write(text::document_of(solid)); });
  m.def("_save_text", [](const Solid& solid, const std::string& path) {
    WholeFile file(path);
    file.write(text::write(text::document_of(solid)));
    file.commit();
  });
  m.def("_render", [](const Model& model, const SceneDescription& description, int width, int height, int samples,
                      const std::string& mode, const py::object& camera, bool adaptive, const py::object& region,
                      py::object callback) {
    return as_array(
        picture(model, description, width, height, samples, mode, camera, adaptive, region, std::move(callback)));
  });
  m.def("_band", [](int width, int height, int index, int count) {
    const PixelRegion band = band_of_picture(width, height, index, count);
    return py::make_tuple(band.x0, band.y0, band.x1, band.y1);
  });
  m.def("_save_picture", [](const Model& model, const SceneDescription& description, const std::string& path, int width,
                            int height, int samples, const std::string& mode, const py::object& camera, bool adaptive,
                            const py::object& region, py::object callback) {
    check_image_path(path);
    write_image(
        picture(model, description, width, height, samples, mode, camera, adaptive, region, std::move(callback)), path);
  });
}

}  // namespace csgcast::python
