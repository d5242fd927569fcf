// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "csg/text/syntax/syntax.h"
#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// How many things there are of each name.
using Tally = std::map<std::string, std::uint64_t>;

/// The statements of a text, disabled ones included.
struct StatementSummary {
  Tally by_name;
  std::uint64_t total = 0;
  std::uint64_t depth = 0;  ///< of the deepest statement; 1 is the top level
};

struct SurfaceSummary {
  std::uint64_t planes = 0;
  std::uint64_t quadrics = 0;
  std::uint64_t others = 0;
  std::uint64_t shared = 0;  ///< those that more than one leaf has
};

struct LeafSummary {
  Tally by_kind;
  std::vector<std::uint64_t> by_part;  ///< for each part of the scene
};

/// Iterative: texts may nest a million deep.
StatementSummary summarise_statements(const text::Document& document);
SurfaceSummary summarise_surfaces(const Scene& scene);
LeafSummary summarise_leaves(const Scene& scene);

}  // namespace csgcast::cli
