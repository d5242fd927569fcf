// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bindings/python/bind.h"
#include "csg/base/error.h"
#include "model/model.h"

namespace csgcast::python {
namespace {

using namespace py::literals;

/// Rays from arrays of which one may be a single origin or direction for all.
class RayInput {
 public:
  RayInput(const Numbers& origins, const Numbers& directions)
      : origins_(triples_from(origins, "origins")), directions_(triples_from(directions, "directions")) {
    spread(origins_, directions_, memory_);
    spread(directions_, origins_, memory_);
    if (origins_.size() != directions_.size())
      throw py::value_error("origins and directions must be as many, or one of them for all");
  }

  Rays rays() const { return {origins_, directions_}; }
  py::ssize_t count() const { return static_cast<py::ssize_t>(origins_.size() / 3); }

 private:
  static void spread(std::span<const double>& one, std::span<const double> others, std::vector<double>& memory) {
    if (one.size() != 3 || one.size() == others.size()) return;
    memory.resize(others.size());
    for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = one[i % 3];
    one = memory;
  }

  std::span<const double> origins_;
  std::span<const double> directions_;
  std::vector<double> memory_;
};

struct SpanOptions {
  double t_min = 0;
  double t_max = HUGE_VAL;
  bool line = false;

  Span span() const { return line ? Span::line() : Span{t_min, t_max}; }
};

py::dict intervals(const Model& model, const Numbers& origins, const Numbers& directions, double t_min, double t_max,
                   bool line, bool faces, bool normals, py::object callback, int threads) {
  const RayInput input(origins, directions);
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  options.span = SpanOptions{t_min, t_max, line}.span();
  options.faces = faces;
  options.normals = normals;
  IntervalTable table = callbacks.run([&] { return model.intervals(input.rays(), options); });
  const auto count = static_cast<py::ssize_t>(table.count());
  py::dict result;
  result["offsets"] = array_of<std::int64_t>(std::move(table.offsets), {input.count() + 1});
  result["t"] = array_of<double>(std::move(table.t), {count, 2});
  result["surfaces"] = array_of<std::int32_t>(std::move(table.surfaces), {count, 2});
  result["leaves"] = faces ? py::object(array_of<std::int32_t>(std::move(table.leaves), {count, 2})) : py::none();
  result["parts"] = faces ? py::object(array_of<std::int32_t>(std::move(table.parts), {count, 2})) : py::none();
  result["normals"] = normals ? py::object(array_of<double>(std::move(table.normals), {count, 2, 3})) : py::none();
  return result;
}

py::tuple first_hits(const Model& model, const Numbers& origins, const Numbers& directions, double t_min, double t_max,
                     py::object callback, int threads) {
  const RayInput input(origins, directions);
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  options.span = {t_min, t_max};
  HitTable table = callbacks.run([&] { return model.first_hits(input.rays(), options); });
  return py::make_tuple(array_of<double>(std::move(table.t), {input.count()}),
                        array_of<std::int32_t>(std::move(table.surfaces), {input.count()}),
                        array_of<bool>(std::move(table.is_entry), {input.count()}));
}

py::array any_hits(const Model& model, const Numbers& origins, const Numbers& directions, double t_min, double t_max,
                   py::object callback, int threads) {
  const RayInput input(origins, directions);
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  options.span = {t_min, t_max};
  return array_of<bool>(callbacks.run([&] { return model.any_hits(input.rays(), options); }), {input.count()});
}

/// 1 inside, 0 on the boundary, -1 outside.
py::array locate(const Model& model, const Numbers& points, py::object callback, int threads) {
  const auto numbers = triples_from(points, "points");
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  const std::vector<Location> found = callbacks.run([&] { return model.locate(numbers, options); });
  std::vector<std::int8_t> signs(found.size());
  std::transform(found.begin(), found.end(), signs.begin(), sign_of);
  const auto count = static_cast<py::ssize_t>(signs.size());
  return array_of<std::int8_t>(std::move(signs), {count});
}

py::array thickness(const Model& model, const Numbers& origins, const Numbers& directions, py::object callback,
                    int threads) {
  const RayInput input(origins, directions);
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  return array_of<double>(callbacks.run([&] { return model.thickness(input.rays(), options); }), {input.count()});
}

py::array point_array(Point p) { return array_of<double>(std::vector<double>{p.x, p.y, p.z}, {3}); }

py::object box_array(const Box& box) {
  if (box.is_null()) return py::none();
  return array_of<double>(
      std::vector<double>{box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z}, {2, 3});
}

py::dict measures_dict(const Measures& m) {
  const auto& i = m.inertia;
  py::dict d;
  d["is_bounded"] = m.is_bounded;
  d["volume"] = m.volume.value;
  d["volume_error"] = m.volume.error;
  d["area"] = m.area.value;
  d["area_error"] = m.area.error;
  d["mass"] = m.mass.value;
  d["mass_error"] = m.mass.error;
  d["centroid"] = point_array(m.centroid);
  d["centroid_error"] = m.centroid_error;
  d["inertia"] = array_of<double>(std::vector<double>{i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2]}, {3, 3});
  d["inertia_error"] = m.inertia_error;
  std::vector<double> axes;
  for (const Vector& axis : m.principal_axes) axes.insert(axes.end(), {axis.x, axis.y, axis.z});
  d["principal_moments"] =
      array_of<double>(std::vector<double>(m.principal_moments.begin(), m.principal_moments.end()), {3});
  d["principal_error"] = m.principal_error;
  d["principal_axes"] = array_of<double>(std::move(axes), {3, 3});
  d["principal_angles"] =
      array_of<double>(std::vector<double>(m.principal_angles.begin(), m.principal_angles.end()), {3});
  d["bounds"] = box_array(m.bounds);
  d["bounds_error"] = m.bounds_error;
  d["cells"] = m.pieces;
  d["as_asked"] = m.is_as_asked;
  return d;
}

py::dict measure_model(const Model& model, double relative_error, double area_error, py::object callback,
                       const py::object& enough, int threads) {
  Callbacks callbacks(std::move(callback), threads);
  MeasureOptions options;
  options.relative_error = relative_error;
  options.relative_area_error = area_error;
  options.progress = callbacks.progress();
  options.is_enough = callbacks.question(enough);
  const SceneMeasures measures = callbacks.run([&] { return model.measure(options); });
  py::dict result = measures_dict(measures.whole);
  py::list parts;
  for (std::size_t i = 0; i < measures.parts.size(); ++i) {
    const PartName& part = model.scene().parts()[i].name;
    py::dict d = measures_dict(measures.parts[i]);
    d["name"] = part.name;
    d["density"] = part.density;
    parts.append(d);
  }
  result["parts"] = parts;
  return result;
}

std::string leaf_name(const Model& model, std::int64_t leaf) {
  if (leaf < 0 || static_cast<std::size_t>(leaf) >= model.scene().leaves().size())
    throw py::index_error("there is no such leaf");
  return model.leaf_name(LeafId(static_cast<std::uint32_t>(leaf)));
}

Welding welding_from(std::optional<double> weld) {
  return !weld ? Welding::derived() : *weld == 0 ? Welding{} : Welding::by_hand(*weld);
}

/// Of a solid, or of a description.
template <class What>
std::shared_ptr<Model> model_of(const What& what, std::optional<double> weld, int threads) {
  const Welding welding = welding_from(weld);
  return Callbacks(py::none(), threads).run([&] { return std::make_shared<Model>(What(what), welding); });
}

}  // namespace

void bind_queries(py::module_& m) {
  py::class_<Model, std::shared_ptr<Model>>(m, "_Model")
      .def(py::init(&model_of<Solid>), "solid"_a, "weld"_a, "threads"_a)
      .def(py::init(&model_of<SceneDescription>), "description"_a, "weld"_a, "threads"_a)
      .def("intervals", intervals)
      .def("first_hits", first_hits)
      .def("any_hits", any_hits)
      .def("locate", locate)
      .def("thickness", thickness)
      .def("measure", measure_model)
      .def("leaf", leaf_name)
      .def("bounds", [](const Model& model) { return box_array(model.bounds()); })
      .def("part_names", &Model::part_names)
      .def("counts", [](const Model& model) {
        const ModelCounts counts = model.counts();
        py::dict d;
        d["leaves"] = counts.leaves;
        d["surfaces"] = counts.surfaces;
        d["cells"] = counts.cells;
        d["bytes"] = counts.bytes;
        return d;
      });
}

}  // namespace csgcast::python
