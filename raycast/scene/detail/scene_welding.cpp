// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "raycast/scene/detail/scene_compiler.h"

// What the compiler does about faces that coincide but for rounding.

namespace csgcast {

void SceneCompiler::weld() {
  if (welding_.mode == Welding::Mode::off || surfaces_.size() == 0) return;
  // The leaves that own a surface, surface by surface: end[i] is where those of surface i end.
  std::vector<std::size_t> end(surfaces_.size());
  for (const Ownership& owned : ownerships_) ++end[owned.surface.index()];
  std::exclusive_scan(end.begin(), end.end(), end.begin(), std::size_t{0});
  std::vector<detail::Provenance::Source> sources(ownerships_.size());
  for (const Ownership& owned : ownerships_) sources[end[owned.surface.index()]++] = owned.source;
  std::vector<Ownership>().swap(ownerships_);
  std::vector<detail::Welder::Candidate> candidates;
  candidates.reserve(surfaces_.size());
  for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : end[i - 1];
    candidates.push_back({&surfaces_.form(SurfaceId(i)), std::span(sources).subspan(begin, end[i] - begin)});
  }
  // A solid of unbounded leaves alone may be bounded itself.
  Box everything = scene_.bounded_leaves_;
  if (everything.is_null()) {
    for (const Body& body : bodies_) everything = hull(everything, scene_.node(body.node).box);
  }
  detail::Welder welder(provenance_, welding_, everything);
  const std::vector<detail::Replacement> replacements = welder.run(candidates, scene_.weld_report_);
  if (scene_.weld_report_.surfaces > 0) replace_surfaces(surfaces_.merge(replacements));
}

// The leaves' half-spaces by their new surfaces. A leaf with both sides of one has no inside any more.
void SceneCompiler::replace_surfaces(std::span<const HalfSpace> positive_side) {
  std::vector<bool> is_empty(scene_.leaves_.size());
  for (std::size_t i = 0; i < scene_.leaves_.size(); ++i) {
    Leaf& leaf = scene_.leaves_[i];
    const auto begin = scene_.half_spaces_.begin() + leaf.first;
    auto end = begin;
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
      HalfSpace half_space = *(begin + k);
      const auto [surface, side] = positive_side[half_space.surface.index()];
      half_space = {surface, side == Sense::positive ? half_space.sense : opposite(half_space.sense)};
      const auto same = std::find_if(begin, end, [&](const HalfSpace& other) { return other.surface == surface; });
      if (same == end) {
        *end++ = half_space;
      } else if (same->sense != half_space.sense) {
        is_empty[i] = true;
      }
    }
    leaf.count = static_cast<std::uint32_t>(end - begin);
  }
  for (Node& node : scene_.nodes_) {
    if (node.op == Node::Op::leaf && is_empty[node.first]) node = {};
  }
}

}  // namespace csgcast
