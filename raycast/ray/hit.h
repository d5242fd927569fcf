// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "csg/base/ids.h"
#include "csg/base/vector.h"
#include "raycast/line/interval_list.h"

namespace csgcast {

/// The face at an end of an interval: the leaf it belongs to and the look that it shows. Both are not valid if no
/// surface makes the end.
struct EndFace {
  LeafId leaf;
  LookId look;
  Normal normal{};  ///< unit, out of the solid
};

enum class Passage : std::uint8_t { entry, exit };

/// A crossing that the solid's boundary keeps.
struct Hit {
  Crossing crossing;
  Passage passage = Passage::entry;
};

/// A change of medium along a ray. A region is not valid if the ray is outside every solid there, or in an opaque one.
struct Interface {
  Hit hit;          ///< the boundary of the layer that begins or ends here
  RegionId before;  ///< the transmitting region that the ray is in before the change
  RegionId after;   ///< the transmitting region that the ray is in after the change
  bool into_opaque = false;
  NodeId node;  ///< the node whose boundary the hit is, for Caster::attribute
};

/// Where a hit belongs in the uncompiled tree.
struct Attribution {
  LeafId leaf;
  RegionId region;  ///< the region that the leaf belongs to
  PartId part;      ///< not valid outside every named part
  LookId look;      ///< what to shade the face with
  /// The place in double. Beside the error of its crossing, it is off by at most 2^-51 of the scene's size
  /// (Scene::frame) and 2^-52 of its coordinates. For a ray from far away this is more accurate than o + t d.
  Point point;
  Normal normal;  ///< unit, out of the solid
  Sense front;    ///< the side of the crossing's surface that the ray comes from; the ray goes on to the other side
};

inline EndFace end_face(const Attribution& face) { return {face.leaf, face.look, face.normal}; }

enum class Location : std::uint8_t { inside, outside, boundary };

}  // namespace csgcast
