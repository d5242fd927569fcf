// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/peers/engine.h"
#include "tests/bench/peers/engines.h"

namespace csgcast::bench {

/// Embree over the parts of any tree, as geometry that the program defines: its hierarchy finds the parts that a ray
/// comes near, our callbacks compute in double where the ray is in them, and nothing ends the ray, since what is behind
/// may be cut off from what is in front. What is gathered is sorted and passed through the tree. In a union of parts
/// the first hit is the nearest entry, and ends the ray. Rays one at a time, and in packets of 8 and 16.
Engines embree_parts_engines(const PeerScene& scene);

/// Embree's own spheres in single precision, for unions of balls, first hits: single rays, packets, streams.
Engines embree_ball_engines(const PeerScene& scene);

}  // namespace csgcast::bench
