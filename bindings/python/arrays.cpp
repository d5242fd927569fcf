// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bindings/python/bind.h"

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

bool Progress::operator()(double done) {
  const py::gil_scoped_acquire lock;
  if (error_) return false;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback_.is_none()) callback_(done);
  } catch (py::error_already_set& error) {
    error_ = error;
  }
  return !error_;
}

void Progress::rethrow() {
  if (error_) throw py::error_already_set(*error_);
}

}  // namespace csgcast::python
