// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/vector.h"

namespace csgcast::python {

namespace py = pybind11;

/// Each adds its part to the module.
void bind_solids(py::module_& module);
void bind_queries(py::module_& module);
void bind_shapes(py::module_& module);
void bind_pictures(py::module_& module);

/// Numbers as C-ordered doubles; others are converted.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Three numbers. Throws ValueError, naming the argument.
Vector vector_from(const py::handle& value, const char* name);

/// `count` rows of three, from an array of shape (count, 3), or (3,) for one. Throws ValueError.
std::span<const double> triples_from(const Numbers& array, const char* name);

/// An array over a vector's memory, which it owns from now on.
template <class As, class T>
py::array array_of(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
  static_assert(sizeof(As) == sizeof(T));
  auto owner = std::make_unique<std::vector<T>>(std::move(values));
  const auto* data = reinterpret_cast<const As*>(owner->data());
  const py::capsule capsule(owner.get(), [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  static_cast<void>(owner.release());
  return py::array_t<As>(std::move(shape), data, capsule);
}

/// Asks Python now and then, while a query runs without its lock, whether to go on: an interrupt ends it, and so does a
/// callback that raises.
class Progress {
 public:
  explicit Progress(py::object callback) : callback_(std::move(callback)) {}

  /// Safe to call from any thread.
  bool operator()(double done);
  /// Once the lock is held again: throws what ended the query.
  void rethrow();

 private:
  py::object callback_;
  std::optional<py::error_already_set> error_;
};

}  // namespace csgcast::python
