// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace csgcast {

/// Counts of the work done by packets.
struct PacketCounts {
  std::uint64_t rays = 0;
  std::uint64_t packets = 0;
  std::uint64_t nodes = 0;          ///< nodes of the kd-tree that packets passed
  std::uint64_t cells = 0;          ///< cells that packets visited
  std::uint64_t surface_tests = 0;  ///< surfaces that packets were tested with
  std::uint64_t flagged = 0;        ///< rays left to the caster
  PacketCounts& operator+=(const PacketCounts& other);
};

}  // namespace csgcast
