// SPDX-License-Identifier: MIT
#include "cli/output/scene_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "csg/exact/quadric_kind.h"
#include "csg/text/statement/builder.h"

namespace csgcast::cli {

StatementSummary summarise_statements(const text::Document& document) {
  StatementSummary summary;
  std::vector<std::pair<const text::Node*, std::uint64_t>> pending;
  for (const text::Node& node : document.nodes) pending.emplace_back(&node, 1);
  while (!pending.empty()) {
    const auto [node, depth] = pending.back();
    pending.pop_back();
    ++summary.by_name[node->name];
    if (text::is_unsupported(*node)) {
      ++summary.unsupported_by_name[node->name];
      summary.unsupported[node->name].push_back(node->line);
    }
    ++summary.total;
    summary.depth = std::max(summary.depth, depth);
    for (const text::Node& child : node->children) pending.emplace_back(&child, depth + 1);
  }
  for (auto& [name, lines] : summary.unsupported) {
    std::sort(lines.begin(), lines.end());
    lines.resize(std::min(lines.size(), StatementSummary::most_lines));
  }
  return summary;
}

bool is_quadric(const Surface& surface) { return !surface.is_plane && surface.other == nullptr; }

Tally quadric_kinds(const Scene& scene) {
  std::map<QuadricKind, std::uint64_t> counts;
  for (const Surface& surface : scene.surfaces()) {
    if (is_quadric(surface)) ++counts[kind_of_quadric(surface.exact.unpacked())];
  }
  Tally tally;
  for (const auto& [kind, count] : counts) tally[word(kind)] = count;
  return tally;
}

std::string list(const Tally& tally) {
  std::string text;
  for (const auto& [name, count] : tally) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count);
  return text.empty() ? "none" : text;
}

SurfaceSummary summarise_surfaces(const Scene& scene) {
  SurfaceSummary summary;
  summary.quadrics_by_kind = quadric_kinds(scene);
  for (const Surface& surface : scene.surfaces()) {
    ++(surface.is_plane ? summary.planes : surface.other == nullptr ? summary.quadrics : summary.others);
  }
  std::vector<LeafId> first_user(scene.surfaces().size());
  std::vector<bool> shared(scene.surfaces().size());
  for (std::uint32_t i = 0; i < scene.leaves().size(); ++i) {
    for (const HalfSpace& half_space : scene.half_spaces(scene.leaves()[i])) {
      LeafId& user = first_user[half_space.surface.index()];
      if (!user.valid()) user = LeafId(i);
      if (user != LeafId(i)) shared[half_space.surface.index()] = true;
    }
  }
  summary.shared = static_cast<std::uint64_t>(std::count(shared.begin(), shared.end(), true));
  return summary;
}

LeafSummary summarise_leaves(const Scene& scene) {
  LeafSummary summary;
  summary.by_part.resize(scene.parts().size());
  for (const Leaf& leaf : scene.leaves()) {
    ++summary.by_kind[word(leaf.kind)];
    if (leaf.part.valid()) ++summary.by_part[leaf.part.index()];
  }
  return summary;
}

}  // namespace csgcast::cli
