// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "raycast/packets/packet_caster.h"
#include "tests/bench/camera_rays.h"

namespace csgcast::bench {

enum class RayQuery : std::uint8_t { first_hit, any_hit, lists };

/// Room for what packets answer to a block of rays.
struct BlockAnswers {
  std::array<std::uint8_t, CameraRays::block> state;
  std::array<double, CameraRays::block> t;
  std::array<std::uint32_t, CameraRays::block> surface;
  std::array<std::uint8_t, CameraRays::block> root;
  IntervalBatch lists;
};

inline void ask(PacketCaster& caster, RayQuery query, Rounding rounding, const RayArrays& rays, BlockAnswers& answers) {
  const HitArrays hits{answers.state, answers.t, answers.surface, answers.root};
  switch (query) {
    case RayQuery::first_hit:
      return caster.first_hits(rays, hits, rounding);
    case RayQuery::any_hit:
      return caster.any_hits(rays, answers.state);
    case RayQuery::lists:
      return caster.intervals(rays, answers.lists, rounding);
  }
}

/// The work of packets in a query, a ray.
struct WorkPerRay {
  double nodes = 0;
  double cells = 0;
  double surface_tests = 0;
  double left_to_caster = 0;  ///< a share
  double intervals = 0;       ///< of lists
};

inline WorkPerRay work_per_ray(const Cells& cells, RayQuery query, const CameraRays& rays) {
  PacketCaster caster(cells);
  BlockAnswers answers;
  std::size_t intervals = 0;
  for (std::size_t begin = 0; begin < rays.size(); begin += CameraRays::block) {
    ask(caster, query, Rounding::close, rays.block_at(begin), answers);
    intervals += answers.lists.intervals.size();
  }
  const PacketCounts counts = caster.counts();
  const auto each = [&rays](auto count) { return static_cast<double>(count) / static_cast<double>(rays.size()); };
  return {each(counts.nodes), each(counts.cells), each(counts.surface_tests), each(counts.flagged), each(intervals)};
}

}  // namespace csgcast::bench
