// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raycast/scene/detail/surface_table.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// Whether a node is bounded, and in which box.
struct Extent {
  enum class Kind : std::uint8_t { bounded, unbounded, undecided };

  Kind kind = Kind::undecided;
  Box box;             ///< of a bounded node: holds the closed set. Null if the node is empty
  Vector direction{};  ///< else: where the node reaches to infinity, or may; 0 if it was not asked
};

/// Finds out if nodes whose leaves are unbounded are bounded themselves, as a cone between two half-spaces is. A place
/// far away is x / w, with x on the sides of a cube and w small. There a form is q(x) + w l(x) + w² c, and its range
/// over a part of a side and 0 < w <= w0 may tell its sign. If the node's truth formula is then false on all parts, the
/// node lies within 1 / w0. Of forms that differ by a constant, as those of parallel planes, one sign may imply the
/// other.
/// docs/answer.md, "Bounded solids".
class Boundedness {
 public:
  /// Both must outlive it. The node's boxes must hold the nodes.
  Boundedness(const SceneTables& tables, const SurfaceTable& surfaces) : tables_(tables), surfaces_(surfaces) {}

  Extent of(NodeId node);

 private:
  const SceneTables& tables_;
  const SurfaceTable& surfaces_;
  std::uint64_t work_ = 0;
};

}  // namespace csgcast::detail
