// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/cells/build/cell_data.h"
#include "raycast/packets/detail/ray_pointers.h"
#include "raycast/packets/packet_counts.h"
#include "raycast/ray/hit.h"
#include "raycast/scene/scene.h"

// The interface of the code for many rays at once, in the lanes of vector registers. The code is compiled for each
// instruction set (lanes.cpp).

namespace csgcast::detail {

/// The results for each ray. Arrays of FacePointers that are not wanted may be null, except `state`.
struct LaneHits {
  FacePointers faces;
  std::vector<std::uint32_t>* unowned = nullptr;    ///< if looks are wanted: gets the rays whose face's look or leaf
                                                    ///< depends on more than the cell; only these are not told
  bool rounds = false;                              ///< true if t is to be rounded to nearest
  std::vector<std::uint32_t>* unrounded = nullptr;  ///< in that case: gets the rays whose t still has to be rounded
  std::vector<std::uint32_t>* left = nullptr;       ///< gets the rays left undecided; their other results are arbitrary
};

/// The place for the interval lists of rays.
struct LaneLists {
  std::vector<Interval>* intervals = nullptr;       ///< intervals are appended, ray after ray
  std::vector<EndFace>* faces = nullptr;            ///< the faces of their ends; may be null. Unknown ids are not valid
  bool wants_normals = false;                       ///< true if the normals of the faces are wanted
  std::size_t* ends = nullptr;                      ///< by ray: the number of intervals up to and including its own
  std::vector<std::uint32_t>* left = nullptr;       ///< gets the rays that lanes cannot decide; these have no intervals
  bool rounds = false;                              ///< true if t is to be rounded to nearest
  std::vector<std::uint32_t>* unrounded = nullptr;  ///< in that case: gets the rays with a t still to be rounded
};

/// The functions for rays of one width.
struct LaneFunctions {
  void (*first_hits)(const Scene&, const CellData&, const RayPointers&, const LaneHits&, PacketCounts&);
  /// Tells if the rays meet the inside. Only `state` (entry or none) and `left` are set.
  void (*any_hits)(const Scene&, const CellData&, const RayPointers&, const LaneHits&, PacketCounts&);
  void (*lists)(const Scene&, const CellData&, const RayPointers&, const LaneLists&, PacketCounts&);
};

/// The code for one instruction set. All sets give the same answers to rays that they do not flag.
struct LaneCode {
  std::string_view name;
  LaneFunctions packet;  ///< handles as many rays at once as a register holds
  LaneFunctions single;  ///< handles one ray at a time
};

/// The codes that this machine can run, the best first.
std::span<const LaneCode> lane_codes();

}  // namespace csgcast::detail
