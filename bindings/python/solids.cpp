// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bindings/python/bind.h"
#include "csg/base/transform.h"
#include "csg/solid/bounds.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/parts.h"
#include "csg/solid/primitives.h"
#include "csg/text/syntax/color.h"

namespace csgcast::python {
namespace {

using namespace py::literals;

Centering centering(bool center) { return center ? Centering::centered : Centering::corner; }

/// A number of any kind, numpy's too; nothing for other things.
std::optional<double> scalar_from(const py::object& value) {
  if (PyNumber_Check(value.ptr()) == 0 || py::isinstance<py::str>(value)) return std::nullopt;
  const Numbers array = Numbers::ensure(value);
  if (!array || array.ndim() != 0) {
    PyErr_Clear();
    return std::nullopt;
  }
  return *array.data();
}

/// One number for all axes, or three.
Vector sizes_from(const py::object& value, const char* name) {
  if (const std::optional<double> size = scalar_from(value)) return {*size, *size, *size};
  return vector_from(value, name);
}

/// A radius, or half a diameter.
std::optional<double> radius_from(std::optional<double> radius, std::optional<double> diameter, const char* names) {
  if (radius && diameter) throw py::value_error(std::string("give one of ") + names + ", not both");
  if (diameter) return 0.5 * *diameter;
  return radius;
}

Solid make_sphere(std::optional<double> r, std::optional<double> d) {
  const auto radius = radius_from(r, d, "r and d");
  return sphere(radius ? *radius : 1);
}

Solid make_cylinder(double h, std::optional<double> r, std::optional<double> r1, std::optional<double> r2, bool center,
                    std::optional<double> d, std::optional<double> d1, std::optional<double> d2) {
  const auto both = radius_from(r, d, "r and d");
  const auto bottom = radius_from(r1, d1, "r1 and d1");
  const auto top = radius_from(r2, d2, "r2 and d2");
  if (both && bottom && top) throw py::value_error("give r, or r1 and r2, not all three");
  const double fallback = both ? *both : 1;
  return cylinder(h, bottom ? *bottom : fallback, top ? *top : fallback, centering(center));
}

Solid make_quadric(const Numbers& a, const py::object& b, double c) {
  if (a.ndim() != 2 || a.shape(0) != 3 || a.shape(1) != 3) throw py::value_error("A must be a 3 x 3 matrix");
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j) {
      if (a.at(i, j) != a.at(j, i)) throw py::value_error("A must be symmetric");
    }
  }
  return quadric({a.at(0, 0), a.at(1, 1), a.at(2, 2), a.at(0, 1), a.at(0, 2), a.at(1, 2)}, vector_from(b, "b"), c);
}

Solid make_convex(const std::optional<Numbers>& points, const std::optional<Numbers>& planes) {
  if (points.has_value() == planes.has_value()) throw py::value_error("give points or planes");
  if (points) {
    const auto numbers = triples_from(*points, "points");
    std::vector<Point> corners;
    for (std::size_t i = 0; i < numbers.size(); i += 3) corners.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return convex_from_points(corners);
  }
  if (planes->ndim() != 2 || planes->shape(1) != 4) throw py::value_error("planes must have shape (count, 4)");
  std::vector<PlaneEquation> equations;
  for (py::ssize_t i = 0; i < planes->shape(0); ++i)
    equations.push_back({{planes->at(i, 0), planes->at(i, 1), planes->at(i, 2)}, planes->at(i, 3)});
  return convex_from_planes(equations);
}

std::vector<Solid> solids_from(const py::args& args) {
  std::vector<Solid> solids;
  const auto add = [&](const py::handle& value) {
    if (!py::isinstance<Solid>(value)) throw py::type_error("only solids, or one list of them, can be put together");
    solids.push_back(value.cast<Solid>());
  };
  const bool is_list = args.size() == 1 && !py::isinstance<Solid>(args[0]) && py::isinstance<py::iterable>(args[0]);
  for (const py::handle& value : is_list ? py::iter(args[0]) : py::iter(args)) add(value);
  return solids;
}

/// Throws ValueError for numbers that are none.
Solid moved(const Solid& solid, const Transform& transform) {
  if (!transform.is_finite())
    throw py::value_error("a transform must not have entries that are infinite or no numbers");
  return transformed(solid, transform);
}

Solid moved_by_matrix(const Solid& solid, const Numbers& m) {
  const bool has_shape = m.ndim() == 2 && (m.shape(0) == 3 || m.shape(0) == 4) && m.shape(1) == 4;
  if (!has_shape) throw py::value_error("the matrix must have shape (3, 4) or (4, 4)");
  if (m.shape(0) == 4 && (m.at(3, 0) != 0 || m.at(3, 1) != 0 || m.at(3, 2) != 0 || m.at(3, 3) != 1))
    throw py::value_error("the matrix must be affine: its last row 0, 0, 0, 1");
  Transform transform;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) transform.entry[static_cast<std::size_t>(4 * i + j)] = m.at(i, j);
  }
  return moved(solid, transform);
}

/// Degrees about an axis, or about x, then y, then z.
Solid rotated(const Solid& solid, const py::object& a, const py::object& v) {
  if (const std::optional<double> degrees = scalar_from(a)) {
    const Vector axis = v.is_none() ? Vector{0, 0, 1} : vector_from(v, "v");
    return moved(solid, rotation(*degrees, axis));
  }
  if (!v.is_none()) throw py::value_error("v goes with one angle, not with three");
  return moved(solid, rotation(vector_from(a, "a")));
}

/// A name, #rrggbb, or sRGB in [0, 1], as colours are written; alpha may be left out.
Solid colored(const Solid& solid, const py::object& color_of) {
  if (py::isinstance<py::str>(color_of)) {
    const auto name = color_of.cast<std::string>();
    const std::optional<Paint> paint = text::paint_from(name);
    if (!paint) throw py::value_error("there is no color '" + name + "': give a CSS name, '#rrggbb' or numbers");
    return with_look(solid, {{}, paint});
  }
  std::vector<double> rgba;
  try {
    rgba = color_of.cast<std::vector<double>>();
  } catch (const py::cast_error&) {
    throw py::type_error("a color is a name, '#rrggbb', or three or four numbers");
  }
  if (rgba.size() != 3 && rgba.size() != 4) throw py::value_error("a color has three or four numbers");
  for (const double channel : rgba) {
    if (!(channel >= 0 && channel <= 1)) throw py::value_error("a color's numbers are between 0 and 1");
  }
  const Rgb color{linear_from_srgb(rgba[0]), linear_from_srgb(rgba[1]), linear_from_srgb(rgba[2])};
  return with_look(solid, {{}, Paint{color, rgba.size() == 4 ? rgba[3] : 1}});
}

Solid as_part(const Solid& solid, const std::string& name, double density) { return named(solid, {name, density}); }

/// The scene text's statement.
Solid with_material(const Solid& solid, const py::object& color, double ambient, double diffuse, double specular,
                    double shininess, double reflection, double transmission, double ior, const py::object& emission,
                    const py::object& absorption) {
  Material material;
  if (!color.is_none()) material.color = light_from(color, "color");
  material.ambient = ambient;
  material.diffuse = diffuse;
  material.specular = specular;
  material.shininess = shininess;
  material.reflection = reflection;
  material.transmission = transmission;
  material.ior = ior;
  material.emission = light_from(emission, "emission");
  material.absorption = light_from(absorption, "absorption");
  return with_look(solid, {material, {}});
}

Solid only(const Solid& solid, const py::object& name) {
  std::vector<std::string> names;
  try {
    names = py::isinstance<py::str>(name) ? std::vector<std::string>{name.cast<std::string>()}
                                          : name.cast<std::vector<std::string>>();
  } catch (const py::cast_error&) {
    throw py::type_error("only() takes the name of a part, or a list of names");
  }
  const std::vector<std::string> known = part_names(solid);
  if (const std::string* wanted = unknown_part(known, names))
    throw py::value_error("no part is named '" + *wanted + "'; there are " +
                          py::repr(py::cast(known)).cast<std::string>());
  return only_parts(solid, names);
}

py::array bounds_of(const Solid& solid) {
  const auto [lower, upper] = bounds(solid);
  return array_of<double>(std::vector<double>{lower.x, lower.y, lower.z, upper.x, upper.y, upper.z}, {2, 3});
}

/// `<csgcast.Solid: difference, parts 'a', 'b'>`.
std::string description_of(const Solid& solid) {
  const auto kind = [&]() -> std::string {
    switch (solid.kind()) {
      case Solid::Kind::empty:
        return "empty";
      case Solid::Kind::everything:
        return "everything";
      case Solid::Kind::leaf:
        return word(solid.shape().kind);
      case Solid::Kind::unite:
        return "union";
      case Solid::Kind::intersect:
        return "intersection";
      case Solid::Kind::subtract:
        return "difference";
      case Solid::Kind::complement:
        return "complement";
      case Solid::Kind::transform:
        return "moved";
      case Solid::Kind::part:
        return "part";
      default:
        return "with a look";
    }
  };
  constexpr std::size_t most_named = 4;
  const std::vector<std::string> names = part_names(solid);
  std::string text = "<csgcast.Solid: " + kind();
  for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i)
    text += (i == 0 ? ", parts " : ", ") + py::repr(py::str(names[i])).cast<std::string>();
  return text + (names.size() > most_named ? ", ..>" : ">");
}

void bind_primitives(py::module_& m) {
  m.def(
      "box", [](const py::object& size, bool center) { return box(sizes_from(size, "size"), centering(center)); },
      "size"_a = 1.0, "center"_a = false,
      "box(size=1.0, center=False)\n--\n\n"
      "A box of one size, or of three, from the origin on or about it.");
  m.def("sphere", make_sphere, "r"_a = py::none(), py::kw_only(), "d"_a = py::none(),
        "sphere(r=None, *, d=None)\n--\n\n"
        "A ball about the origin, by radius (1) or diameter.");
  m.def("cylinder", make_cylinder, "h"_a = 1.0, "r"_a = py::none(), "r1"_a = py::none(), "r2"_a = py::none(),
        "center"_a = false, py::kw_only(), "d"_a = py::none(), "d1"_a = py::none(), "d2"_a = py::none(),
        "cylinder(h=1.0, r=None, r1=None, r2=None, center=False, *, d=None, d1=None, d2=None)\n--\n\n"
        "A cylinder or cone along z, from z = 0 on or about it: one radius, or r1 at the bottom and r2 at the top.");
  m.def(
      "ellipsoid", [](const py::object& r) { return ellipsoid(vector_from(r, "r")); }, "r"_a,
      "ellipsoid(r)\n--\n\n"
      "An ellipsoid about the origin with three semi-axes.");
  m.def(
      "paraboloid", [](double h, double r) { return paraboloid(h, r); }, "h"_a, "r"_a,
      "paraboloid(h, r)\n--\n\n"
      "A paraboloid with its apex at the origin, open upwards, of radius r at z = h, where it ends.");
  m.def(
      "hyperboloid", [](double h, double r, double waist) { return hyperboloid(h, r, waist); }, "h"_a, "r"_a, "waist"_a,
      "hyperboloid(h, r, waist)\n--\n\n"
      "A hyperboloid about the z axis, of radius waist at z = 0 and r at z = -h/2 and h/2, where it ends; waist 0 is "
      "a double cone, waist > r a barrel.");
  m.def("quadric", make_quadric, "A"_a, "b"_a, "c"_a,
        "quadric(A, b, c)\n--\n\n"
        "Where p' A p + b . p + c <= 0; A symmetric, 3 x 3.");
  m.def(
      "halfspace", [](const py::object& n, double d) { return halfspace(vector_from(n, "n"), d); }, "n"_a, "d"_a,
      "halfspace(n, d)\n--\n\n"
      "Where n . p <= d.");
  m.def("convex", make_convex, "points"_a = py::none(), "planes"_a = py::none(),
        "convex(points=None, planes=None)\n--\n\n"
        "The convex hull of points (count, 3), or where n . p <= d for all planes, rows n, d of (count, 4).");
  m.def(
      "empty", [] { return Solid(); },
      "empty()\n--\n\n"
      "No point.");
  m.def(
      "everything", [] { return Solid::everything(); },
      "everything()\n--\n\n"
      "All of space.");
  m.def(
      "union", [](const py::args& solids) { return unite(solids_from(solids)); },
      "union(*solids)\n--\n\n"
      "All points of any of the solids, or of a list of them; of none: empty.");
  m.def(
      "intersection", [](const py::args& solids) { return intersect(solids_from(solids)); },
      "intersection(*solids)\n--\n\n"
      "All points that every one of the solids, or of a list of them, has; of none: empty.");
  m.def(
      "difference", [](const py::args& solids) { return subtract(solids_from(solids)); },
      "difference(*solids)\n--\n\n"
      "The first of the solids, or of a list of them, less all others; of none: empty.");
  m.def(
      "complement", [](const Solid& solid) { return complement(solid); }, "solid"_a,
      "complement(solid)\n--\n\n"
      "All of space but the solid.");
}

}  // namespace

void bind_solids(py::module_& m) {
  py::class_<Solid>(
      m, "Solid",
      "A solid: an immutable value, at first the empty one. a + b (or a | b), a - b, a & b and ~a put solids together, "
      "methods "
      "move them; nothing is computed until compile(). Regular closed sets: faces belong to it, nothing is "
      "thinner than a point's neighbourhood.")
      .def(py::init<>())
      .def(
          "__add__", [](const Solid& a, const Solid& b) { return a + b; }, py::is_operator())
      .def("__radd__",
           [](const Solid& a, int zero) {  // sum() begins with 0
             if (zero != 0) throw py::type_error("a number is no solid");
             return a;
           })
      .def(
          "__or__", [](const Solid& a, const Solid& b) { return a + b; }, py::is_operator())
      .def(
          "__sub__", [](const Solid& a, const Solid& b) { return a - b; }, py::is_operator())
      .def(
          "__and__", [](const Solid& a, const Solid& b) { return a & b; }, py::is_operator())
      .def("__invert__", [](const Solid& a) { return complement(a); })
      .def(
          "translate", [](const Solid& s, const py::object& v) { return moved(s, translation(vector_from(v, "v"))); },
          "v"_a,
          "translate(self, v)\n--\n\n"
          "Moved by a vector.")
      .def("rotate", rotated, "a"_a, "v"_a = py::none(),
           "rotate(self, a, v=None)\n--\n\n"
           "Turned by a degrees about the axis v (z), or by three angles about x, then y, then z. Multiples of 90 "
           "degrees "
           "are exact.")
      .def(
          "scale", [](const Solid& s, const py::object& v) { return moved(s, scaling(sizes_from(v, "v"))); }, "v"_a,
          "scale(self, v)\n--\n\n"
          "Scaled by a number, or by one along each axis.")
      .def(
          "mirror", [](const Solid& s, const py::object& v) { return moved(s, mirroring(vector_from(v, "v"))); }, "v"_a,
          "mirror(self, v)\n--\n\n"
          "Mirrored at the plane through the origin that is square to v.")
      .def("transform", moved_by_matrix, "matrix"_a,
           "transform(self, matrix)\n--\n\n"
           "Moved by an affine matrix, (3, 4) or (4, 4). A singular one leaves nothing.")
      .def(
          "part", as_part, "name"_a, "density"_a = 1.0,
          "part(self, name, density=1.0)\n--\n\n"
          "The same solid as a part, for measures and checks by part. Parts stand below unions, moves and colors only, "
          "not within parts.")
      .def("color", colored, "color"_a,
           "color(self, color)\n--\n\n"
           "With a color: a CSS name, '#rrggbb', or three or four sRGB numbers in [0, 1]. The outermost color counts.")
      .def("material", with_material, "color"_a = py::none(), "ambient"_a = 0.15, "diffuse"_a = 0.7, "specular"_a = 0.2,
           "shininess"_a = 30.0, "reflection"_a = 0.0, "transmission"_a = 0.0, "ior"_a = 1.0,
           "emission"_a = py::make_tuple(0.0, 0.0, 0.0), "absorption"_a = py::make_tuple(0.0, 0.0, 0.0),
           "material(self, color=None, ambient=0.15, diffuse=0.7, specular=0.2, shininess=30.0, reflection=0.0, "
           "transmission=0.0, ior=1.0, emission=(0.0, 0.0, 0.0), absorption=(0.0, 0.0, 0.0))\n--\n\n"
           "With a material, as the scene text's statement: how it answers to light. color, emission and absorption "
           "(per "
           "unit of length) are linear light, three numbers, or names or '#rrggbb'; color None is OpenSCAD's yellow. "
           "The "
           "innermost material counts, and a color replaces its color.")
      .def_property_readonly("parts", &part_names, "The names of its parts, in order, each once.")
      .def("only", only, "name"_a,
           "only(self, name)\n--\n\n"
           "The parts of this name, or of these names, as if nothing else were there; of none: empty.")
      .def_property_readonly(
          "bounds", bounds_of,
          "Lower and upper corner, (2, 3), of a box that holds it, rounded outward: not the least one. "
          "inf, -inf if it is empty.")
      .def("__copy__", [](const Solid& s) { return s; })
      .def("__deepcopy__", [](const Solid& s, const py::dict&) { return s; })  // immutable
      .def("__repr__", description_of);
  bind_primitives(m);
}

}  // namespace csgcast::python
