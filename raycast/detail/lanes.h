// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/detail/cell_data.h"
#include "raycast/packet_counts.h"
#include "raycast/ray_arrays.h"
#include "raycast/scene.h"

// Many rays at once, in the lanes of vector registers: the interface of the code that is compiled for each instruction
// set (lanes.cpp).

namespace csgcast::detail {

/// What was found of each ray. Arrays of FaceArrays may be null where they are not wanted, but `state`.
struct LaneHits {
  FaceArrays faces;
  std::uint8_t* root = nullptr;                ///< which of the surface's crossings it is (Crossing::root)
  std::vector<std::uint32_t>* left = nullptr;  ///< gets the rays that lanes cannot tell all about: nothing told of
                                               ///< them means anything
};

/// A ray with more ends of intervals is flagged.
constexpr std::size_t most_lane_ends = 256;

/// The ends of intervals, ray by ray; an interval that has no end of its own begins before or ends after what was
/// asked.
struct LaneLists {
  struct End {
    double t;
    std::uint32_t slot;
    std::uint8_t root;
  };
  std::vector<End> ends;
  std::vector<std::size_t> offsets;  ///< where each ray's ends begin, and the end of the last; rays + 1
  std::vector<bool> starts_inside;   ///< by ray
  std::vector<bool> is_flagged;      ///< by ray
};

/// The work on rays of one width.
struct LaneFunctions {
  void (*first_hits)(const Scene&, const CellData&, const RayArrays&, const LaneHits&, PacketCounts&);
  /// Whether the rays meet the inside: state is entry or none, and `left`.
  void (*any_hits)(const Scene&, const CellData&, const RayArrays&, const LaneHits&, PacketCounts&);
  void (*lists)(const Scene&, const CellData&, const RayArrays&, LaneLists&, PacketCounts&);
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
