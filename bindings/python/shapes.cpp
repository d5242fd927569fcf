// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "bindings/python/bind.h"
#include "measure/section_json.h"
#include "measure/section_polylines.h"
#include "measure/section_svg.h"
#include "model/model.h"
#include "model/section_file.h"

// Sections and checks.

namespace csgcast::python {
namespace {

py::array vector_array(Vector v) { return array_of<double>(std::vector<double>{v.x, v.y, v.z}, {3}); }

py::tuple loop_arrays(const SectionLoop& loop) {
  std::vector<double> points;
  std::vector<double> conics;
  std::vector<std::int32_t> surfaces;
  for (const SectionArc& arc : loop) {
    for (const PlanePoint p : {arc.from, arc.middle, arc.to}) points.insert(points.end(), {p.u, p.v});
    conics.insert(conics.end(), arc.conic.begin(), arc.conic.end());
    surfaces.push_back(static_cast<std::int32_t>(arc.surface.index()));
  }
  const auto count = static_cast<py::ssize_t>(loop.size());
  return py::make_tuple(array_of<double>(std::move(points), {count, 3, 2}),
                        array_of<double>(std::move(conics), {count, 6}),
                        array_of<std::int32_t>(std::move(surfaces), {count}));
}

py::dict cut(const Model& model, const py::object& normal, double distance, double relative_error, py::object callback,
             int threads) {
  const Plane plane{vector_from(normal, "normal"), distance};
  SectionOptions options;
  options.relative_error = relative_error;
  Callbacks callbacks(std::move(callback), threads);
  options.progress = callbacks.progress();
  const Section s = callbacks.run([&] { return model.section(plane, options); });
  py::list loops;
  for (const SectionLoop& loop : s.loops) loops.append(loop_arrays(loop));
  py::dict d;
  d["is_bounded"] = s.is_bounded;
  d["origin"] = vector_array(as_vector(s.origin));
  d["u"] = vector_array(s.u);
  d["v"] = vector_array(s.v);
  d["area"] = s.area.value;
  d["area_error"] = s.area.error;
  d["perimeter"] = s.perimeter.value;
  d["perimeter_error"] = s.perimeter.error;
  d["place_error"] = s.place_error;
  d["is_closed"] = s.is_closed;
  d["loops"] = loops;
  return d;
}

py::dict checked(const Model& model, py::object callback, int threads) {
  const Scene& scene = model.scene();
  Callbacks callbacks(std::move(callback), threads);
  CheckOptions options;
  options.progress = callbacks.progress();
  const CheckReport report = callbacks.run([&] { return model.check(options); });
  const auto name = [&](PartId part) { return scene.parts()[part.index()].name.name; };
  py::dict d;
  py::list overlaps, undecided, unbounded, empty, redundant;
  for (const Overlap& o : report.overlaps)
    overlaps.append(py::make_tuple(name(o.first), name(o.second), o.volume.value, o.volume.error,
                                   vector_array(as_vector(o.witness))));
  for (const Contact& c : report.undecided) undecided.append(py::make_tuple(name(c.first), name(c.second), c.most));
  for (const PartId part : report.unbounded) unbounded.append(name(part));
  for (const PartId part : report.empty) empty.append(name(part));
  for (const Redundancy& r : report.redundant) {
    redundant.append(py::make_tuple(name_of(scene, r), reason(r.why),
                                    py::module_::import("builtins").attr("range")(r.first_leaf, r.leaf_end)));
  }
  d["overlaps"] = overlaps;
  d["undecided"] = undecided;
  d["unbounded_parts"] = unbounded;
  d["empty_parts"] = empty;
  d["without_effect"] = redundant;
  d["not_asked"] = report.not_asked;
  d["is_unbounded"] = report.is_unbounded;
  d["is_empty"] = report.is_empty;
  return d;
}

/// The thickness, place, normal and leaf; None if there is no such place.
py::object thinnest(const Model& model, std::int64_t grid, py::object callback, int threads) {
  Callbacks callbacks(std::move(callback), threads);
  const auto found = callbacks.run(
      [&] { return model.thinnest(static_cast<std::size_t>(std::max<std::int64_t>(grid, 0)), callbacks.progress()); });
  if (!found) return py::none();
  return py::make_tuple(found->thickness, vector_array(as_vector(found->place)), vector_array(as_vector(found->normal)),
                        found->leaf.index());
}

/// The section that a Section of csgcast/__init__.py tells of.
Section section_from(const py::object& told) {
  const auto number = [&](const char* name) { return told.attr(name).cast<double>(); };
  Section s;
  s.is_bounded = told.attr("is_bounded").cast<bool>();
  s.is_closed = told.attr("is_closed").cast<bool>();
  const Vector origin = vector_from(told.attr("origin"), "origin");
  s.origin = {origin.x, origin.y, origin.z};
  s.u = vector_from(told.attr("u"), "u");
  s.v = vector_from(told.attr("v"), "v");
  s.area = {number("area"), number("area_error")};
  s.perimeter = {number("perimeter"), number("perimeter_error")};
  s.place_error = number("place_error");
  for (const py::handle& arcs : told.attr("loops")) {
    const auto [points, conics, surfaces] = arcs.cast<std::tuple<Numbers, Numbers, py::array_t<std::int32_t>>>();
    const py::ssize_t count = surfaces.size();
    const bool has_points =
        points.ndim() == 3 && points.shape(0) == count && points.shape(1) == 3 && points.shape(2) == 2;
    const bool has_conics = conics.ndim() == 2 && conics.shape(0) == count && conics.shape(1) == 6;
    if (!has_points || !has_conics || count == 0)
      throw py::value_error("a loop has points (arcs, 3, 2), conics (arcs, 6) and surfaces (arcs,)");
    SectionLoop& loop = s.loops.emplace_back();
    for (py::ssize_t i = 0; i < count; ++i) {
      SectionArc& arc = loop.emplace_back();
      for (py::ssize_t k = 0; k < 6; ++k) arc.conic[static_cast<std::size_t>(k)] = conics.at(i, k);
      py::ssize_t at = 0;
      for (PlanePoint* point : {&arc.from, &arc.middle, &arc.to}) {
        *point = {points.at(i, at, 0), points.at(i, at, 1)};
        ++at;
      }
      arc.surface = SurfaceId(static_cast<std::uint32_t>(surfaces.at(i)));
    }
  }
  return s;
}

std::string svg_of(const py::object& told, std::optional<double> tolerance) {
  const Section s = section_from(told);
  if (tolerance && !(*tolerance > 0 && std::isfinite(*tolerance)))
    throw py::value_error("a tolerance must be above 0 and finite");
  return section_svg(s, tolerance ? *tolerance : unseen_tolerance(s));
}

py::list polylines_of(const py::object& told, double tolerance) {
  py::list lines;
  for (const std::vector<PlanePoint>& line : section_polylines(section_from(told), tolerance)) {
    std::vector<double> numbers;
    for (const PlanePoint p : line) numbers.insert(numbers.end(), {p.u, p.v});
    lines.append(array_of<double>(std::move(numbers), {static_cast<py::ssize_t>(line.size()), 2}));
  }
  return lines;
}

/// A drawing or numbers, which the section alone makes; or a picture, which asks the model.
void save_section(const py::object& told, const std::string& path, int pixels, const Model* model,
                  const py::object& normal, double distance) {
  const Section s = section_from(told);
  if (model != nullptr) {
    const Plane plane{vector_from(normal, "normal"), distance};
    const py::gil_scoped_release unlocked;
    return write_section(model->scene(), plane, s, path, pixels);
  }
  if (path.ends_with(".png"))
    throw py::value_error(
        "a section that came from another process has no model to make a .png of: save .svg or .json");
  write_section(Scene{}, {}, s, path, pixels);
}

}  // namespace

void bind_shapes(py::module_& m) {
  m.def("_section", cut);
  m.def("_check", checked);
  m.def("_thinnest", thinnest);
  m.def("_section_svg", svg_of);
  m.def("_section_json", [](const py::object& told) { return section_json(section_from(told)); });
  m.def("_section_polylines", polylines_of);
  m.def("_save_section", save_section);
}

}  // namespace csgcast::python
