// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/surface_welding.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "raycast/weld/welder.h"

namespace csgcast::detail {
namespace {

// The sources of all surfaces in one list, grouped by surface.
struct SourcesBySurface {
  std::vector<Provenance::Source> sources;
  std::vector<std::size_t> end;  // by surface: the end of its sources

  SourcesBySurface(std::vector<SurfaceOrigins::Ownership> ownerships, std::size_t surface_count)
      : sources(ownerships.size()), end(surface_count) {
    for (const SurfaceOrigins::Ownership& owned : ownerships) ++end[owned.surface.index()];
    std::exclusive_scan(end.begin(), end.end(), end.begin(), std::size_t{0});
    for (const SurfaceOrigins::Ownership& owned : ownerships) sources[end[owned.surface.index()]++] = owned.source;
  }

  std::span<const Provenance::Source> of(std::size_t surface) const {
    const std::size_t begin = surface == 0 ? 0 : end[surface - 1];
    return std::span(sources).subspan(begin, end[surface] - begin);
  }
};

// Gives the leaves' half-spaces their new surfaces. `positive_side` has, by old surface, what its positive side is now.
void replace_surfaces(std::span<const HalfSpace> positive_side, SceneTables& tables) {
  std::vector<bool> is_empty(tables.leaves.size());
  for (std::size_t i = 0; i < tables.leaves.size(); ++i) {
    Leaf& leaf = tables.leaves[i];
    const auto begin = tables.half_spaces.begin() + leaf.first;
    auto end = begin;
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
      HalfSpace half_space = *(begin + k);
      const auto [surface, side] = positive_side[half_space.surface.index()];
      half_space = {surface, side == Sense::positive ? half_space.sense : opposite(half_space.sense)};
      if (leaf.function != nullptr) {  // a function knows its half-spaces by their places
        *end++ = half_space;
        continue;
      }
      const auto same = std::find_if(begin, end, [&](const HalfSpace& other) { return other.surface == surface; });
      if (same == end) {
        *end++ = half_space;
      } else if (same->sense != half_space.sense) {
        is_empty[i] = true;
      }
    }
    leaf.count = static_cast<std::uint32_t>(end - begin);
  }
  for (Node& node : tables.nodes) {
    if (node.op == Node::Op::leaf && is_empty[node.first]) node = {};
  }
}

}  // namespace

WeldReport weld_surfaces(const Welding& welding, const Box& everything, SurfaceOrigins origins, SurfaceTable& surfaces,
                         SceneTables& tables) {
  WeldReport report;
  if (surfaces.size() == 0) return report;
  const SourcesBySurface sources(std::move(origins.ownerships), surfaces.size());
  // Only planes and quadrics are welded.
  std::vector<std::uint32_t> numbers;
  std::vector<Welder::Candidate> candidates;
  std::vector<Replacement> replacements;
  candidates.reserve(surfaces.size());
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    replacements.push_back({i});
    const PackedForm* form = surfaces.form(SurfaceId(i));
    if (form == nullptr) continue;
    numbers.push_back(i);
    candidates.push_back({form, sources.of(i)});
  }
  Welder welder(origins.provenance, welding, everything);
  const std::vector<Replacement> found = welder.run(candidates, report);
  for (std::size_t k = 0; k < found.size(); ++k)
    replacements[numbers[k]] = {numbers[found[k].surface], found[k].flipped};
  if (report.surfaces > 0) replace_surfaces(surfaces.merge(replacements), tables);
  return report;
}

}  // namespace csgcast::detail
