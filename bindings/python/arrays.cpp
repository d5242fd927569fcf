// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>

#include "bindings/python/bind.h"
#include "csg/base/length.h"
#include "csg/text/syntax/color.h"

namespace csgcast::python {

Vector vector_from(const py::handle& value, const char* name) {
  const Numbers array = Numbers::ensure(value);
  if (!array || array.ndim() != 1 || array.shape(0) != 3) {
    PyErr_Clear();
    throw py::value_error(fmt::format("{} must be three numbers", name));
  }
  return {array.at(0), array.at(1), array.at(2)};
}

std::span<const double> triples_from(const Numbers& array, const char* name) {
  if (array.size() == 0) return {};
  const bool is_one = array.ndim() == 1 && array.shape(0) == 3;
  const bool are_rows = array.ndim() == 2 && array.shape(1) == 3;
  if (!is_one && !are_rows) throw py::value_error(fmt::format("{} must have shape (count, 3), or (3,) for one", name));
  return {array.data(), static_cast<std::size_t>(array.size())};
}

Rgb light_from(const py::handle& value, const char* name) {
  if (!py::isinstance<py::str>(value)) {
    const Vector v = vector_from(value, name);
    if (!(v.x >= 0 && v.y >= 0 && v.z >= 0) || !is_finite(v))
      throw py::value_error(fmt::format("{} must be three finite numbers that are not negative", name));
    return {v.x, v.y, v.z};
  }
  const auto text = value.cast<std::string>();
  const std::optional<Paint> paint = text::paint_from(text);
  if (!paint) throw py::value_error("there is no color '" + text + "': give a CSS name, '#rrggbb' or numbers");
  if (paint->alpha < 1) throw py::value_error(fmt::format("{} must be an opaque color, not '{}'", name, text));
  return paint->color;
}

Callbacks::Callbacks(py::object progress, int threads) : progress_(std::move(progress)), threads_(threads) {
  if (threads < 0) throw py::value_error("threads must not be negative; 0 is one a core");
}

namespace {

/// False itself, Python's or numpy's: what else is false, as None or 0, tells nothing.
bool is_false(const py::object& answer) {
  if (py::isinstance<py::bool_>(answer)) return !answer.cast<bool>();
  return py::isinstance(answer, py::module_::import("numpy").attr("bool_")) && PyObject_Not(answer.ptr()) == 1;
}

}  // namespace

template <class Call>
bool Callbacks::asked(Call&& call) {
  const py::gil_scoped_acquire lock;
  if (error_) return false;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return call();
  } catch (py::error_already_set& error) {
    error_ = error;
    return false;
  }
}

ProgressCallback Callbacks::progress() {
  return [this](const csgcast::Progress& progress) {
    return asked([&] { return progress_.is_none() || !is_false(progress_(progress.share)); });
  };
}

std::function<bool(double)> Callbacks::question(const py::object& callable) {
  if (callable.is_none()) return {};
  return [this, &callable](double number) { return asked([&] { return py::bool_(callable(number)).cast<bool>(); }); };
}

}  // namespace csgcast::python
