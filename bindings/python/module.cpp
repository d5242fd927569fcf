// SPDX-License-Identifier: MIT
#include "bindings/python/bind.h"
#include "csg/base/error.h"
#include "model/model.h"

// What csgcast/__init__.py makes a package of.

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  // Docstrings begin with the signature as inspect.signature() reads it: `name(arguments)\n--\n\n`.
  py::options options;
  options.disable_function_signatures();
  py::register_exception<csgcast::Error>(m, "Error", PyExc_ValueError);
  py::register_exception<csgcast::Cancelled>(m, "Cancelled", PyExc_RuntimeError);
  m.attr("__version__") = CSGCAST_VERSION;
  csgcast::python::bind_solids(m);
  csgcast::python::bind_queries(m);
  csgcast::python::bind_shapes(m);
  csgcast::python::bind_pictures(m);
  csgcast::python::bind_pickles(m);
}
