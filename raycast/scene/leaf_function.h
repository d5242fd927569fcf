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

/// One line, as a leaf asks about it.
class LeafLine {
 public:
  virtual const Ray& ray() const = 0;
  /// The crossings with a surface.
  virtual const LineCrossings& found(SurfaceId id) = 0;
  /// One of them. Precondition: root < found(id).count.
  virtual Crossing crossing(SurfaceId id, std::uint8_t root) = 0;
  /// Which of two crossings comes first, exactly.
  virtual std::weak_ordering order(const Crossing& a, const Crossing& b) = 0;

 protected:
  ~LeafLine() = default;
};

/// One box, as a leaf asks about it.
class LeafBox {
 public:
  /// It lies in this box of the scene, whose sides may be infinite.
  virtual Box in_scene() const = 0;
  /// The sides of a surface that it may meet.
  virtual detail::Sides sides_of(SurfaceId id) = 0;

 protected:
  ~LeafBox() = default;
};

/// What a leaf is that is no conjunction of half-spaces: any truth function of them. It knows a half-space by its place
/// in the leaf's list, which it is given with every question, not by its surface: surfaces may weld. Several threads
/// ask it at once. Leaves may share it if it keeps no places of its own.
class LeafFunction {
 public:
  /// What a leaf is in a box.
  enum class Content : std::uint8_t {
    empty,  ///< none of it
    full,   ///< all of it
    terms,  ///< a truth formula, whose condition k is that half-space k holds
    open,   ///< not known yet: a smaller box may tell
  };

  virtual ~LeafFunction() = default;

  /// Whether a place is inside, by which of the half-spaces hold there. Some may be unknown: the value is, too, unless
  /// the others settle it.
  virtual Truth value(std::span<const Truth> holds) const = 0;
  /// Writes the intervals along a line. They are right within the reach, and may be anything outside of it. The
  /// crossings at their ends are those of the leaf's surfaces. `scratch` is memory to use.
  virtual void intervals(std::span<const HalfSpace> half_spaces, LeafLine& line, Span reach, IntervalList& list,
                         std::vector<IntervalList>& scratch) const = 0;
  /// What the leaf is in a box. `terms` is written if the content is terms, and then is no constant. It may leave out
  /// half-spaces that hold in all of the box, or nowhere in it.
  virtual Content in_box(std::span<const HalfSpace> half_spaces, LeafBox& box, TruthFormula& terms) const = 0;
};

}  // namespace csgcast
