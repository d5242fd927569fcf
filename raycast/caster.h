// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "raycast/hit.h"
#include "raycast/ray.h"
#include "raycast/scene.h"

namespace csgcast {

/// A ray that starts on a surface starts exactly on it: that surface's crossing at t = 0 is 0 by definition, never computed.
struct Departure {
  SurfaceId surface;
};

/// Work done, in counts that do not drift.
struct CasterCounts {
  std::uint64_t rays = 0;
  std::uint64_t surface_tests = 0;  ///< crossings computed
  std::uint64_t box_tests = 0;
  std::uint64_t leaf_tests = 0;
  std::uint64_t exact_calls = 0;    ///< decisions that floating point could not take
  CasterCounts& operator+=(const CasterCounts& other);
};

/// The working memory of one thread that asks a scene about rays. Queries never allocate once the memory has grown.
///
/// The answer is the regularised list of intervals that docs/answer.md defines. begin() sets the ray; the others ask about it.
class Caster {
 public:
  /// The scene must outlive the caster.
  explicit Caster(const Scene& scene);
  ~Caster();
  Caster(Caster&&) noexcept;

  const Scene& scene() const;

  /// Turns to another ray.
  void begin(const Ray& ray, std::optional<Departure> departure = std::nullopt);

  /// All intervals of the solid, or of one of its nodes (a part's or region's), clipped to the span. Infinite ends have t = ±infinity and no surface,
  /// and so have ends that the span cuts off; an interval that starts exactly at span.from keeps its surface, one that ends there vanishes.
  /// The list is overwritten.
  void intervals(IntervalList& list, Span span = {}) { intervals(scene().root(), list, span); }
  void intervals(NodeId node, IntervalList& list, Span span = {});

  /// The first crossing of the boundary in the span, entry or exit; stops as early as it can.
  std::optional<Hit> first_hit(Span span = {});
  /// True if the ray meets the inside of the solid anywhere in the open span. Cheaper than first_hit.
  bool any_hit(Span span = {});

  /// The leaf, part, look and normal of a boundary crossing of the present ray.
  Attribution attribute(const Hit& hit);
  /// The look of what is inside `region` just before (exit) or after (entry) a crossing; the first positive leaf in file order that holds it.
  LookId look_inside(RegionId region, const Hit& hit);

  /// Where a point is. Never falsely inside or outside.
  Location locate(Point p) { return locate(scene().root(), p); }
  Location locate(NodeId node, Point p);
  /// The first part in file order that holds the point inside; not valid if none.
  PartId part_at(Point p);

  const CasterCounts& counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
