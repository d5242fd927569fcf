// SPDX-License-Identifier: MIT
#include <string>

#include "bindings/python/bind.h"
#include "measure/check.h"
#include "measure/section.h"
#include "measure/thickness.h"
#include "model/model.h"

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

py::dict cut(const Model& model, const py::object& normal, double distance, double relative_error,
             py::object callback) {
  const Plane plane{vector_from(normal, "normal"), distance};
  SectionOptions options;
  options.relative_error = relative_error;
  Callbacks callbacks(std::move(callback));
  options.progress = callbacks.progress();
  const Section s = callbacks.run([&] { return section(model.scene(), plane, options); });
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

py::dict checked(const Model& model, py::object callback) {
  const Scene& scene = model.scene();
  Callbacks callbacks(std::move(callback));
  CheckOptions options;
  options.progress = callbacks.progress();
  const CheckReport report = callbacks.run([&] { return check(scene, options); });
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
    const std::string kind = word(scene, r);
    redundant.append(py::make_tuple(r.place.line > 0 ? kind + " at " + to_string(r.place) : kind, reason(r.why),
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
py::object thinnest(const Model& model, std::size_t samples, py::object callback) {
  if (samples == 0 || samples > 16384) throw py::value_error("samples must be between 1 and 16384");
  Callbacks callbacks(std::move(callback));
  const auto found = callbacks.run([&] { return find_thinnest(model.cells(), samples, callbacks.progress()); });
  if (!found) return py::none();
  return py::make_tuple(found->thickness, vector_array(as_vector(found->place)), vector_array(as_vector(found->normal)),
                        found->leaf.index());
}

}  // namespace

void bind_shapes(py::module_& m) {
  m.def("_section", cut);
  m.def("_check", checked);
  m.def("_thinnest", thinnest);
}

}  // namespace csgcast::python
