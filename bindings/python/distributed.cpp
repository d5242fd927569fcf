// SPDX-License-Identifier: MIT
#include <tbb/global_control.h>

#include <optional>
#include <vector>

#include "bindings/python/bind.h"
#include "model/model.h"

// What csgcast/distributed.py asks for besides the calls that Model has.

namespace csgcast::python {
namespace {

using namespace py::literals;

/// While it is entered, no call of the process works on more threads; several of them: the least number.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads) : threads_(threads) {
    if (threads == 0) throw py::value_error("threads must be 1 or more");
  }
  void enter() { control_.emplace(tbb::global_control::max_allowed_parallelism, threads_); }
  void exit() { control_.reset(); }

 private:
  std::size_t threads_;
  std::optional<tbb::global_control> control_;
};

py::array thickness(const Model& model, const Numbers& origins, const Numbers& directions, py::object callback,
                    int threads) {
  const Rays rays{triples_from(origins, "origins"), triples_from(directions, "directions")};
  Callbacks callbacks(std::move(callback), threads);
  QueryOptions options;
  options.progress = callbacks.progress();
  std::vector<double> found = callbacks.run([&] { return model.thickness(rays, options); });
  const auto count = static_cast<py::ssize_t>(found.size());
  return array_of<double>(std::move(found), {count});
}

}  // namespace

void bind_distributed(py::module_& m) {
  py::class_<ThreadLimit>(m, "_ThreadLimit")
      .def(py::init<std::size_t>(), "threads"_a)
      .def("__enter__", &ThreadLimit::enter)
      .def("__exit__", [](ThreadLimit& limit, const py::args&) { limit.exit(); });
  m.def("_thickness", thickness);
}

}  // namespace csgcast::python
