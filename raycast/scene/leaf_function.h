// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/box.h"
#include "csg/base/truth.h"
#include "csg/base/truth_formula.h"
#include "raycast/line/interval_list.h"
#include "raycast/line/ray.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/line_crossings.h"
#include "raycast/surface/sides.h"

namespace csgcast {

/// The questions that a leaf asks about one line.
class LeafLine {
 public:
  virtual const Ray& ray() const = 0;
  /// The crossings of the line with a surface.
  virtual const LineCrossings& found(SurfaceId id) = 0;
  /// One of these crossings. Precondition: root < found(id).count.
  virtual Crossing crossing(SurfaceId id, std::uint8_t root) = 0;
  /// Orders two crossings exactly.
  virtual std::weak_ordering order(const Crossing& a, const Crossing& b) = 0;

 protected:
  ~LeafLine() = default;
};

/// The questions that a leaf asks about one box.
class LeafBox {
 public:
  /// A box of the scene, maybe with infinite sides, that contains this one.
  virtual Box in_scene() const = 0;
  /// The sides of a surface that the box may meet.
  virtual detail::Sides sides_of(SurfaceId id) = 0;

 protected:
  ~LeafBox() = default;
};

/// Defines a leaf that is not a conjunction of half-spaces, but any other truth function of them. Each call gets the
/// leaf's list of half-spaces. The function knows a half-space by its place in that list, not by its surface, because
/// surfaces may be welded. Several threads call it at once. Leaves may share a function that stores no places of its
/// own.
class LeafFunction {
 public:
  /// The content of the leaf in a box.
  enum class Content : std::uint8_t {
    empty,  ///< the leaf holds nothing of the box
    full,   ///< the leaf holds all of the box
    terms,  ///< a truth formula, in which condition k means that half-space k holds
    open,   ///< not known yet; it may be known in a smaller box
  };

  virtual ~LeafFunction() = default;

  /// True if a place is inside, given which half-spaces hold there. Some of these may be unknown. Then the value is
  /// unknown, too, unless the others settle it.
  virtual Truth value(std::span<const Truth> holds) const = 0;
  /// Writes the intervals along a line. They are correct within the reach, and arbitrary outside of it. The crossings
  /// at their ends are crossings of the leaf's surfaces. `scratch` is working memory.
  virtual void intervals(std::span<const HalfSpace> half_spaces, LeafLine& line, Span reach, IntervalList& list,
                         std::vector<IntervalList>& scratch) const = 0;
  /// Tells the content of the leaf in a box. `terms` is written only if the content is Content::terms; then it is not
  /// constant. The formula may leave out half-spaces that hold in all of the box, or nowhere in it.
  virtual Content in_box(std::span<const HalfSpace> half_spaces, LeafBox& box, TruthFormula& terms) const = 0;
};

}  // namespace csgcast
