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

// Many rays at once, in the lanes of vector registers: the interface of the code that is compiled for each instruction
// set (lanes.cpp).

namespace csgcast::detail {

/// What was found of each ray. Arrays of FacePointers may be null where they are not wanted, but `state`.
struct LaneHits {
  FacePointers faces;
  std::vector<std::uint32_t>* unowned = nullptr;    ///< if looks are wanted: gets the rays whose face's look or leaf
                                                    ///< depends on more than the cell; only these are not told
  bool rounds = false;                              ///< t is wanted rounded to nearest
  std::vector<std::uint32_t>* unrounded = nullptr;  ///< then: gets the rays whose t still has to be
  std::vector<std::uint32_t>* left = nullptr;       ///< gets the rays that lanes cannot tell all about: nothing told of
                                                    ///< them means anything
};

/// Where the interval lists of rays go.
struct LaneLists {
  std::vector<Interval>* intervals = nullptr;       ///< they are appended, ray after ray
  std::vector<EndFace>* faces = nullptr;            ///< the same of their ends; may be null. Not valid: unknown
  bool wants_normals = false;                       ///< of the faces
  std::size_t* ends = nullptr;                      ///< by ray: how many intervals there are after its own
  std::vector<std::uint32_t>* left = nullptr;       ///< gets the rays that lanes cannot tell all about: they have none
  bool rounds = false;                              ///< t is wanted rounded to nearest
  std::vector<std::uint32_t>* unrounded = nullptr;  ///< then: gets the rays with an end whose t still has to be
};

/// The work on rays of one width.
struct LaneFunctions {
  void (*first_hits)(const Scene&, const CellData&, const RayPointers&, const LaneHits&, PacketCounts&);
  /// Whether the rays meet the inside: state is entry or none, and `left`.
  void (*any_hits)(const Scene&, const CellData&, const RayPointers&, const LaneHits&, PacketCounts&);
  void (*lists)(const Scene&, const CellData&, const RayPointers&, const LaneLists&, PacketCounts&);
};

/// The code for one instruction set. All give the same answers to rays that they do not flag.
struct LaneCode {
  std::string_view name;
  LaneFunctions packet;  ///< as many rays at once as a register holds
  LaneFunctions single;  ///< one
};

/// Those that this machine can run, the best first.
std::span<const LaneCode> lane_codes();

}  // namespace csgcast::detail
