// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tests/support/ray_batch.h"

namespace csgcast::bench {

using test::RayBatch;

/// The intervals of many rays, one ray after the other: ends[first[i] .. first[i + 1]) are entry, exit, entry, exit, ..
/// of ray i.
struct IntervalTable {
  std::vector<double> ends;
  std::vector<std::size_t> first{0};

  std::size_t rays() const { return first.size() - 1; }
  std::span<const double> of(std::size_t ray) const {
    return std::span(ends).subspan(first[ray], first[ray + 1] - first[ray]);
  }
  void clear() {
    ends.clear();
    first.resize(1);
  }
  void end_ray() { first.push_back(ends.size()); }
};

/// A program, or a way to use one, that is asked about the rays of a scene it was made with. Rays come in tiles
/// (peer_scene.h), and start outside the solid.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::string name() const = 0;
  virtual bool knows_intervals() const { return true; }
  /// t of each ray's first hit, infinite if there is none. `t` has one place a ray.
  virtual void first_hits(const RayBatch& rays, std::span<double> t) = 0;
  /// All intervals of each ray from t = 0 on. The table comes cleared.
  virtual void intervals(const RayBatch& rays, IntervalTable& table) = 0;
  /// Turns the answers to the last call into that form, where the engine has another one of its own. Not timed.
  virtual void restate(std::span<double> /*t*/) {}
  virtual void restate(IntervalTable& /*table*/) {}
};

}  // namespace csgcast::bench
