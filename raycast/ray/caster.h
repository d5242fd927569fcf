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

/// The surface that a ray starts on, and the side of it that the ray goes to.
///
/// By definition the ray has no crossing with this surface at t = 0, and is on `side` right after it. Only a further
/// crossing, with a curved surface, is computed. So a surface never shadows or reflects itself, and no epsilon is
/// needed.
///
/// Precondition: the ray goes to that side, or along the surface up to rounding. If it clearly goes to the other side,
/// the answer is arbitrary.
struct Departure {
  SurfaceId surface;
  Sense side = Sense::positive;
};

/// The double that stands for a crossing's exact t.
enum class Rounding : std::uint8_t {
  nearest,  ///< the nearest one
  close,    ///< one that is a few roundings off: faster, for pictures
};

/// Counts of the work done. They depend on the scene and the queries only, not on the machine or on time.
struct CasterCounts {
  std::uint64_t rays = 0;
  std::uint64_t surface_tests = 0;  ///< computed crossings of a ray and a surface
  std::uint64_t box_tests = 0;
  std::uint64_t leaf_tests = 0;
  std::uint64_t twofold_calls = 0;  ///< decisions that double left open and twofold (double-double) arithmetic took
  std::uint64_t exact_calls = 0;    ///< decisions that needed exact numbers
  std::uint64_t rays_flagged = 0;   ///< rays with a decision of either kind
  CasterCounts& operator+=(const CasterCounts& other);
};

/// Answers questions about one ray at a time, and about points. It holds the working memory of one thread. Once that
/// memory has grown, queries do not allocate.
///
/// The answer is the regularised list of intervals that docs/answer.md defines. begin() sets the ray. All other queries
/// ask about that ray, except locate() and part_at().
class Caster {
 public:
  /// The scene must outlive the caster.
  explicit Caster(const Scene& scene, const Predicates& predicates = certified_predicates());
  ~Caster();
  Caster(Caster&&) noexcept;

  const Scene& scene() const;

  /// Turns to another ray, which may start on a surface.
  void begin(const Ray& ray, std::optional<Departure> departure = std::nullopt);

  /// All intervals of the solid, or of one of its nodes (a part's or region's), clipped to the span. The list is
  /// overwritten.
  ///
  /// An infinite end has t = ±infinity and no surface. An end that the span cuts off has the span's t and no surface.
  /// An interval that starts exactly at span.from keeps its surface; one that ends exactly there vanishes.
  void intervals(IntervalList& list, Span span = {}) { intervals(scene().root(), list, span); }
  void intervals(NodeId node, IntervalList& list, Span span = {}, Rounding rounding = Rounding::nearest);

  /// Finds the first crossing of the boundary in the span, an entry or an exit. The search stops as early as it can.
  std::optional<Hit> first_hit(Span span = {}, Rounding rounding = Rounding::nearest) {
    return first_hit(scene().root(), span, rounding);
  }
  std::optional<Hit> first_hit(NodeId node, Span span = {}, Rounding rounding = Rounding::nearest);
  /// True if the ray meets the inside of the solid anywhere in the open span. Costs less than first_hit.
  bool any_hit(Span span = {}) { return any_hit(scene().root(), span); }
  bool any_hit(NodeId node, Span span = {});

  /// A crossing of the present ray, with the double nearest to its exact t.
  Crossing reported(const Crossing& crossing);

  /// Orders two crossings of the present ray. They are equivalent if they tie.
  std::weak_ordering order(const Crossing& a, const Crossing& b);

  /// The changes of medium in the span, for scenes that transmit light. They are in ascending order and end with the
  /// first change into an opaque solid. Where layers overlap, the first one in file order counts. Layers that touch and
  /// have the same look are one medium. The vector is overwritten.
  void interfaces(std::vector<Interface>& list, Span span = {});

  /// The leaf, part, look and normal of a boundary crossing of the present ray, as a boundary of the whole solid or of
  /// one of its nodes. Throws Error(usage) if no face of the node is there.
  Attribution attribute(const Hit& hit) { return attribute(scene().root(), hit); }
  Attribution attribute(NodeId node, const Hit& hit);
  /// The look of what is inside a node next to one of its boundary crossings. It is the look of the first leaf in file
  /// order that holds the place and that nothing subtracts. It is not valid if there is none.
  LookId look_inside(NodeId node, const Hit& hit);

  /// Locates a point. The answer is `boundary` if the point is on the boundary, or if its place cannot be found at
  /// reasonable cost; it is never falsely inside or outside. Throws Error(bad_value) for a point that is not finite.
  Location locate(Point p) { return locate(scene().root(), p); }
  Location locate(NodeId node, Point p);
  /// The first part in file order that has the point inside. It is not valid if there is none.
  PartId part_at(Point p);

  CasterCounts counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
