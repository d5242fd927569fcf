// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "raycast/packets/packet_caster.h"
#include "tests/support/random_solid.h"
#include "tests/support/ray_batch.h"

namespace csgcast::test {

/// Rays, and room for what they hit.
struct Shots {
  explicit Shots(std::vector<Ray> list)
      : rays(std::move(list)), t(rays.size()), surface(rays.size()), state(rays.size()), root(rays.size()) {}

  HitArrays hits() { return {state, t, surface, root}; }

  RayBatch rays;
  std::vector<double> t;
  std::vector<std::uint32_t> surface;
  std::vector<std::uint8_t> state, root;
};

bool same(const Crossing& a, const Crossing& b);

void check_same(std::span<const Interval> found, const IntervalList& expected);

/// That the lists of some rays, and the faces at all ends, are those of the scalar caster. `asked`: the batch's arrays,
/// with whatever else is asked.
void check_lists(const Cells& cells, PacketCaster& caster, const RayArrays& asked, const RayBatch& batch);

/// Towards places within 1 of the origin, from up to 4 away.
std::vector<Ray> rays_at(RandomSolids& random, std::size_t count);

/// Rays that depart, all ways, from where others first meet a scene.
struct DepartingRays {
  DepartingRays(const Scene& scene, RandomSolids& random, std::span<const Ray> from);

  RayArrays arrays() const;

  RayBatch rays;
  std::vector<std::uint32_t> surfaces;
  std::vector<std::uint8_t> sides;
};

}  // namespace csgcast::test
