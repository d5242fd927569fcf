// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "csg/base/progress.h"
#include "csg/solid/solid.h"
#include "raycast/cells/cells.h"
#include "raycast/ray/caster.h"
#include "raycast/scene/scene.h"

namespace csgcast {

/// Rays as they lie in memory, three numbers after another a ray: 3 x count each. Directions need not be unit; t counts
/// in units of them.
struct Rays {
  std::span<const double> origins;
  std::span<const double> directions;

  std::size_t count() const { return origins.size() / 3; }
};

/// Which part of each ray's line is asked about, and what shall be told.
struct QueryOptions {
  Span span{};                            ///< from t = 0 to infinity, both ends included
  Rounding rounding = Rounding::nearest;  ///< of t
  bool faces = false;                     ///< leaves and parts of intervals as well
  bool normals = false;                   ///< and normals
  ProgressCallback progress{};
};

/// No surface, leaf or part: an end that no surface makes, a face in no part.
constexpr std::uint32_t no_id = 0xffffffffu;

/// The intervals of many rays as flat arrays. Those of ray i are [offsets[i], offsets[i + 1]); two ends each, entry and
/// exit. Ends at infinity, or cut off by the span, have t there and no_id.
struct IntervalTable {
  std::vector<std::uint64_t> offsets;   ///< rays + 1
  std::vector<double> t;                ///< 2 x intervals
  std::vector<std::uint32_t> surfaces;  ///< 2 x intervals: SurfaceId
  std::vector<std::uint32_t> leaves;    ///< 2 x intervals: LeafId; empty unless faces are asked for
  std::vector<std::uint32_t> parts;     ///< 2 x intervals: PartId of the faces' leaves; likewise
  std::vector<double> normals;          ///< 6 x intervals: unit, out of the solid; zero where no surface makes the end

  std::size_t count() const { return t.size() / 2; }
};

/// Where rays first cross the boundary, entering or leaving.
struct HitTable {
  std::vector<double> t;                ///< by ray; infinity without a hit
  std::vector<std::uint32_t> surfaces;  ///< no_id without a hit
  std::vector<std::uint8_t> is_entry;   ///< 1 or 0
};

/// 1 inside, 0 on the boundary, -1 outside: as other languages are told.
constexpr std::int8_t sign_of(Location location) {
  return location == Location::inside ? 1 : location == Location::outside ? -1 : 0;
}

/// A solid made ready for many rays and points: compiled, and cut into cells. Any number of threads may ask it at once;
/// making it and queries of many rays or points share the work among threads: raycast/packets/threads.h. Answers are
/// certified: docs/answer.md. It links no pictures; Model (model/model.h) answers all kinds of questions.
class RayQueries {
 public:
  explicit RayQueries(Solid solid, const Welding& welding = Welding::derived());
  explicit RayQueries(Scene scene);
  ~RayQueries();
  RayQueries(RayQueries&&) noexcept;

  const Scene& scene() const;
  const Cells& cells() const;

  /// All of these throw Error(usage) if the numbers are not 3 x rays or points; Error(bad_value) or Error(limit),
  /// naming the ray, for rays that Ray does not take; Cancelled.
  IntervalTable intervals(const Rays& rays, const QueryOptions& options = {}) const;
  HitTable first_hits(const Rays& rays, const QueryOptions& options = {}) const;
  /// 1 where a ray meets the inside of the solid in the open span, else 0.
  std::vector<std::uint8_t> any_hits(const Rays& rays, const QueryOptions& options = {}) const;
  /// `points`: 3 x count. Never falsely inside or outside.
  std::vector<Location> locate(std::span<const double> points, const QueryOptions& options = {}) const;

  /// Calls `visit(interval)` for each interval of one ray, in ascending order, until that returns false. `caster` is
  /// the memory of one thread: Caster(scene()); once it has grown nothing is allocated.
  template <class Visit>
  static void visit_intervals(Caster& caster, const Ray& ray, IntervalList& memory, Visit&& visit, Span span = {}) {
    caster.begin(ray);
    caster.intervals(memory, span);
    for (const Interval& interval : memory) {
      if (!visit(interval)) return;
    }
  }

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace csgcast
