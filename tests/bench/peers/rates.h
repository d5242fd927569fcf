// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/peers/engines.h"
#include "tests/bench/peers/peer_scene.h"

namespace csgcast::bench {

enum class Query : std::uint8_t { first_hit, intervals };

/// How fast one engine answered one kind of query on one scene, and how often wrongly.
struct Rate {
  std::string scene;
  std::string engine;
  Query query = Query::first_hit;
  double rays_per_second = 0;   ///< of the median pass
  std::size_t rays = 0;         ///< of a pass; fewer than the scene's where the engine is slow
  std::size_t wrong_count = 0;  ///< rays with another number of intervals than csgcast's certified one, or another
                                ///< answer to whether there is a hit
  std::size_t wrong_t = 0;  ///< of the others, rays with a t that is off by more than t_tolerance of the scene's size
};

constexpr double t_tolerance = 1e-6;

struct Effort {
  int passes = 5;
  double seconds = 4;  ///< an engine that takes longer for all rays of a pass gets every n-th tile of them
};

/// Rates of all engines, the first of which is right by definition; pass by pass they take turns. Processor time.
std::vector<Rate> measure(const PeerScene& scene, const Engines& engines, const Effort& effort);

}  // namespace csgcast::bench
