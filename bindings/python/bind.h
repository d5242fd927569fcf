// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/progress.h"
#include "csg/base/vector.h"
#include "csg/solid/look.h"
#include "raycast/packets/threads.h"

namespace csgcast::python {

namespace py = pybind11;

/// Each adds its part to the module.
void bind_solids(py::module_& module);
void bind_queries(py::module_& module);
void bind_shapes(py::module_& module);
void bind_pictures(py::module_& module);
void bind_pickles(py::module_& module);

/// Numbers as C-ordered doubles; others are converted.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Three numbers. Throws ValueError, naming the argument.
Vector vector_from(const py::handle& value, const char* name);

/// Linear light: three numbers that are not negative, or a CSS name or '#rrggbb', which count as sRGB. Throws
/// ValueError, naming the argument.
Rgb light_from(const py::handle& value, const char* name);

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

/// Calls back into Python while a call runs without its lock. An interrupt cancels the call, and so does a callback
/// that returns False or raises.
class Callbacks {
 public:
  /// `threads`: as of on_threads(). Throws ValueError for a number below 0.
  Callbacks(py::object progress, int threads);

  ProgressCallback progress();
  /// Asks a callable about a number; None says no.
  std::function<bool(double)> question(const py::object& callable);

  /// Calls `work` without Python's lock, on the threads. Throws what a callback raised, an interrupt, or what the work
  /// throws.
  template <class Work>
  auto run(Work&& work) {
    std::optional<decltype(work())> result;
    try {
      const py::gil_scoped_release unlocked;
      on_threads(threads_, [&] { result.emplace(work()); });
    } catch (const Cancelled&) {
      if (error_) throw py::error_already_set(*error_);
      throw;
    }
    if (error_) throw py::error_already_set(*error_);
    return std::move(*result);
  }

 private:
  /// `call()`, with the lock; false if that raises, now or before.
  template <class Call>
  bool asked(Call&& call);

  py::object progress_;
  int threads_;
  std::optional<py::error_already_set> error_;
};

}  // namespace csgcast::python
