// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/line/crossing.h"

namespace csgcast {

/// A run of t inside the solid, entry before exit.
struct Interval {
  Crossing entry;
  Crossing exit;
};

/// The face at an end of an interval: whose it is and what it shows, not valid where no surface makes the end.
struct EndFace {
  LeafId leaf;
  LookId look;
  Normal normal{};  ///< unit, out of the solid
};

/// Sorted, disjoint, non-touching intervals.
using IntervalList = std::vector<Interval>;

enum class Passage : std::uint8_t { entry, exit };

/// A crossing that the solid's boundary keeps.
struct Hit {
  Crossing crossing;
  Passage passage = Passage::entry;
};

/// A change of medium along a ray: what the ray is in before and after. A region is not valid where there is no solid,
/// or an opaque one.
struct Interface {
  Hit hit;          ///< the boundary of the layer that begins or ends here
  RegionId before;  ///< the transmitting region on this side
  RegionId after;   ///< the transmitting region on the far side
  bool into_opaque = false;
  NodeId node;  ///< the node whose boundary the hit is: ask attribute() with it
};

/// Where a hit belongs in the uncompiled tree.
struct Attribution {
  LeafId leaf;
  RegionId region;  ///< the region that the leaf belongs to
  PartId part;      ///< not valid outside every named part
  LookId look;      ///< what to shade the face with
  /// The place, in double: off by at most 2^-51 of the scene's size (Scene::frame) and 2^-52 of its coordinates, beside
  /// what its crossing is off. Nearer than o + t d for a ray from far away.
  Point point;
  Normal normal;  ///< unit, out of the solid
  Sense front;    ///< the side of the crossing's surface on which the ray comes; the solid's boundary is left behind on
                  ///< the other
};

inline EndFace end_face(const Attribution& face) { return {face.leaf, face.look, face.normal}; }

enum class Location : std::uint8_t { inside, outside, boundary };

}  // namespace csgcast
