// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "raycast/line/ray.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/predicates.h"

namespace csgcast {

/// A ray that starts on a surface, towards one side of it. The surface has no crossing at t = 0 and is on `side` right
/// after the start; only a crossing further on, of a curved surface, is computed. So a surface never shadows or
/// reflects itself, and no distance is an epsilon. The ray must go to that side, but for rounding: of one that clearly
/// goes to the other, casters say what they like.
struct Departure {
  SurfaceId surface;
  Sense side = Sense::positive;
};

/// Which double stands for a crossing's exact t.
enum class Rounding : std::uint8_t {
  nearest,  ///< the nearest one
  close,    ///< one that is a few roundings off: faster, for pictures
};

/// Work done, in counts that do not drift.
struct CasterCounts {
  std::uint64_t rays = 0;
  std::uint64_t surface_tests = 0;  ///< crossings computed
  std::uint64_t box_tests = 0;
  std::uint64_t leaf_tests = 0;
  std::uint64_t twofold_calls = 0;  ///< decisions that double could not take, but twofold (double-double) could
  std::uint64_t exact_calls = 0;    ///< decisions that took exact numbers
  std::uint64_t rays_flagged = 0;   ///< rays with a decision of either kind
  CasterCounts& operator+=(const CasterCounts& other);
};

/// The working memory of one thread that asks a scene about rays. Queries never allocate once the memory has grown.
///
/// The answer is the regularised list of intervals that docs/answer.md defines. begin() sets the ray; the others ask
/// about it.
class Caster {
 public:
  /// The scene must outlive the caster.
  explicit Caster(const Scene& scene, const Predicates& predicates = certified_predicates());
  ~Caster();
  Caster(Caster&&) noexcept;

  const Scene& scene() const;

  /// Turns to another ray.
  void begin(const Ray& ray, std::optional<Departure> departure = std::nullopt);

  /// All intervals of the solid, or of one of its nodes (a part's or region's), clipped to the span. Infinite ends have
  /// t = ±infinity and no surface, and so have ends that the span cuts off; an interval that starts exactly at
  /// span.from keeps its surface, one that ends there vanishes. The list is overwritten.
  void intervals(IntervalList& list, Span span = {}) { intervals(scene().root(), list, span); }
  void intervals(NodeId node, IntervalList& list, Span span = {}, Rounding rounding = Rounding::nearest);

  /// The first crossing of the boundary in the span, entry or exit; stops as early as it can.
  std::optional<Hit> first_hit(Span span = {}, Rounding rounding = Rounding::nearest) {
    return first_hit(scene().root(), span, rounding);
  }
  std::optional<Hit> first_hit(NodeId node, Span span = {}, Rounding rounding = Rounding::nearest);
  /// True if the ray meets the inside of the solid anywhere in the open span. Cheaper than first_hit.
  bool any_hit(Span span = {}) { return any_hit(scene().root(), span); }
  bool any_hit(NodeId node, Span span = {});

  /// A crossing of the present ray with the t to report, the nearest double.
  Crossing reported(const Crossing& crossing);

  /// Which of two crossings of the present ray comes first; equivalent if they tie.
  std::weak_ordering order(const Crossing& a, const Crossing& b);

  /// For scenes that transmit: the changes of medium in the span, in ascending order, ended by the first one into an
  /// opaque solid. Where layers overlap the first in file order wins; layers of one look side by side are one medium.
  /// The vector is overwritten.
  void interfaces(std::vector<Interface>& list, Span span = {});

  /// The leaf, part, look and normal of a boundary crossing of the present ray, as a boundary of the whole solid or of
  /// one of its nodes. Throws Error(usage) for a hit that is none.
  Attribution attribute(const Hit& hit) { return attribute(scene().root(), hit); }
  Attribution attribute(NodeId node, const Hit& hit);
  /// The look of what is inside a node next to one of its boundary crossings: the first leaf in file order, of those
  /// that nothing subtracts, that holds the place; not valid if there is none.
  LookId look_inside(NodeId node, const Hit& hit);

  /// Where a point is. Never falsely inside or outside.
  Location locate(Point p) { return locate(scene().root(), p); }
  Location locate(NodeId node, Point p);
  /// The first part in file order that holds the point inside; not valid if none.
  PartId part_at(Point p);

  CasterCounts counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
