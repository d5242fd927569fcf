// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raycast/packet_caster.h"
#include "tests/support/random_solid.h"

namespace csgcast::test {

/// Rays as arrays, and room for what they hit.
struct Arrays {
  explicit Arrays(const std::vector<Ray>& list);

  RayArrays rays() const;
  HitArrays hits() { return {state.data(), t.data(), surface.data(), root.data()}; }

  std::array<std::vector<double>, 3> origin, direction;
  std::vector<double> t;
  std::vector<std::uint32_t> surface;
  std::vector<std::uint8_t> state, root;
};

bool same(const Crossing& a, const Crossing& b);

void check_same(std::span<const Interval> found, const IntervalList& expected);

/// That the lists of some rays, and the faces at all ends, are those of the scalar caster. The rays that `arrays` holds
/// as `list` has them.
void check_lists(const Cells& cells, PacketCaster& caster, const RayArrays& arrays, const std::vector<Ray>& list);

/// Towards places within 1 of the origin, from up to 4 away.
std::vector<Ray> rays_at(RandomSolids& random, std::size_t count);

/// Rays that depart, all ways, from where others first meet a scene.
struct DepartingRays {
  DepartingRays(const Scene& scene, RandomSolids& random, std::span<const Ray> from);

  RayArrays arrays(const Arrays& from) const;

  std::vector<Ray> rays;
  std::vector<std::uint32_t> surfaces;
  std::vector<std::uint8_t> sides;
};

}  // namespace csgcast::test
