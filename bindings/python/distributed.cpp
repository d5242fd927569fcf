// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "bindings/python/bind.h"
#include "csg/base/error.h"
#include "measure/thickness.h"
#include "model/model.h"
#include "raycast/line/ray.h"

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

/// Rays by axis, as ThicknessProbe takes them.
struct RayColumns {
  std::array<std::vector<double>, 6> numbers;

  /// `origins` and `directions`: three numbers a ray. Throws Error naming the ray for one that cannot be cast.
  RayColumns(std::span<const double> origins, std::span<const double> directions) {
    const std::size_t count = origins.size() / 3;
    for (auto& column : numbers) column.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point o{origins[3 * i], origins[3 * i + 1], origins[3 * i + 2]};
      const Vector d{directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]};
      if (!std::isfinite(o.x + o.y + o.z) || !std::isfinite(d.x + d.y + d.z) || d == Vector{} || !Ray::in_range(o, d)) {
        throw Error(ErrorCode::bad_value, {}, fmt::format("ray {} (counted from 0) cannot be cast", i),
                    "its direction is zero, or its numbers are not finite or out of range",
                    "correct the ray or leave it out");
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        numbers[axis][i] = o[axis];
        numbers[3 + axis][i] = d[axis];
      }
    }
  }

  RayArrays part(std::size_t first, std::size_t count) const {
    RayArrays rays;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rays.origin[axis] = std::span(numbers[axis]).subspan(first, count);
      rays.direction[axis] = std::span(numbers[3 + axis]).subspan(first, count);
    }
    return rays;
  }
};

py::array thickness(const Model& model, const Numbers& origins, const Numbers& directions, py::object callback,
                    int threads) {
  const auto from = triples_from(origins, "origins");
  const auto towards = triples_from(directions, "directions");
  if (from.size() != towards.size()) throw py::value_error("origins and directions must be as many");
  Callbacks callbacks(std::move(callback), threads);
  const ProgressCallback tell = callbacks.progress();
  std::vector<double> found = callbacks.run([&] {
    const RayColumns columns(from, towards);
    std::vector<double> result(from.size() / 3);
    constexpr std::size_t run = 2048;
    const std::size_t runs = (result.size() + run - 1) / run;
    ProgressTeller progress(tell, runs);
    tbb::enumerable_thread_specific<ThicknessProbe> probes([&] { return ThicknessProbe(model.cells()); });
    tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t i) {
      const std::size_t first = i * run;
      const std::size_t count = std::min(run, result.size() - first);
      probes.local().first_faces(columns.part(first, count), std::span(result).subspan(first, count));
      progress.step();
    });
    progress.finish();
    return result;
  });
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
