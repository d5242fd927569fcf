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
  /// The lines of statements that are not supported yet, by their names: the first `most_lines` of each.
  std::map<std::string, std::vector<int>> unsupported;
  Tally unsupported_by_name;

  static constexpr std::size_t most_lines = 10;
};

struct SurfaceSummary {
  std::uint64_t planes = 0;
  std::uint64_t quadrics = 0;
  std::uint64_t others = 0;
  std::uint64_t shared = 0;  ///< those that more than one leaf has
  Tally quadrics_by_kind;    ///< by what they are: csg/exact/quadric_kind.h
};

struct LeafSummary {
  Tally by_kind;
  std::vector<std::uint64_t> by_part;  ///< for each part of the scene
};

/// It has a quadric's form: it is no plane and of no other kind.
bool is_quadric(const Surface& surface);

/// How many quadrics there are of each kind (csg/exact/quadric_kind.h), planes left out.
Tally quadric_kinds(const Scene& scene);

/// `cube 3, sphere 1`; `none`.
std::string list(const Tally& tally);

/// Iterative: texts may nest a million deep.
StatementSummary summarise_statements(const text::Document& document);
SurfaceSummary summarise_surfaces(const Scene& scene);
LeafSummary summarise_leaves(const Scene& scene);

}  // namespace csgcast::cli
