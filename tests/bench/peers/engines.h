// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "tests/bench/peers/engine.h"
#include "tests/bench/peers/peer_scene.h"

namespace csgcast::bench {

using Engines = std::vector<std::unique_ptr<Engine>>;

/// csgcast's own, the certified scalar one first: it says what is right. The scene must outlive the engines.
Engines csgcast_engines(const PeerScene& scene);

/// Each of the others as it serves the scene: none if its library was not found when this was built.
Engines embree_engines(const PeerScene& scene);
Engines vecgeom_engines(const PeerScene& scene);

}  // namespace csgcast::bench
