// SPDX-License-Identifier: MIT
#include "csg/solid/mesh.h"

#include <algorithm>
#include <array>
#include <compare>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

/// For each point, the index of the first equal point. After sorting by coordinates, equal points are neighbours.
std::vector<std::uint32_t> first_equals(const std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) { return std::array{points[i].x, points[i].y, points[i].z}; };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeated = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = repeated ? first[order[i - 1]] : order[i];
  }
  return first;
}

Mesh::Face without_repeats(const Mesh::Face& face, const std::vector<std::uint32_t>& first) {
  Mesh::Face result;
  for (const std::uint32_t index : face) {
    CSGCAST_PRECONDITION(index < first.size());
    if (result.empty() || result.back() != first[index]) result.push_back(first[index]);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

/// One run along an edge, by its lower and upper end.
struct Run {
  std::uint32_t lower;
  std::uint32_t upper;
  bool upward;
  friend auto operator<=>(const Run&, const Run&) = default;
};

std::vector<Run> sorted_runs(const Mesh& mesh) {
  std::vector<Run> runs;
  for (const Mesh::Face& face : mesh.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
      runs.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

}  // namespace

Mesh welded(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_equals(mesh.points);
  constexpr std::uint32_t unused = 0xffffffffu;
  std::vector<std::uint32_t> renumbered(mesh.points.size(), unused);
  Mesh result;
  for (const Mesh::Face& face : mesh.faces) {
    Mesh::Face corners = without_repeats(face, first);
    if (corners.size() < 3) continue;
    for (std::uint32_t& corner : corners) {
      std::uint32_t& number = renumbered[corner];
      if (number == unused) {
        number = static_cast<std::uint32_t>(result.points.size());
        result.points.push_back(mesh.points[corner]);
      }
      corner = number;
    }
    result.faces.push_back(std::move(corners));
  }
  return result;
}

std::optional<MeshEdge> open_edge(const Mesh& mesh) {
  const std::vector<Run> runs = sorted_runs(mesh);
  for (std::size_t begin = 0; begin < runs.size();) {
    std::size_t end = begin;
    std::size_t upward = 0;
    while (end < runs.size() && runs[end].lower == runs[begin].lower && runs[end].upper == runs[begin].upper) {
      if (runs[end++].upward) ++upward;
    }
    if (2 * upward != end - begin) return MeshEdge{mesh.points[runs[begin].lower], mesh.points[runs[begin].upper]};
    begin = end;
  }
  return std::nullopt;
}

}  // namespace csgcast
