// SPDX-License-Identifier: MIT
#include "csg/exact/detail/hull_builder.h"

#include <cassert>
#include <optional>
#include <utility>

#include "csg/base/precondition.h"
#include "csg/exact/dyadic.h"

namespace csgcast::detail {
namespace {

bool are_collinear(Point a, Point b, Point c) {
  const auto vanishes = [&](std::size_t i, std::size_t j) {
    return (Dyadic(b[i]) - Dyadic(a[i])) * (Dyadic(c[j]) - Dyadic(a[j])) ==
           (Dyadic(b[j]) - Dyadic(a[j])) * (Dyadic(c[i]) - Dyadic(a[i]));
  };
  return vanishes(0, 1) && vanishes(1, 2) && vanishes(2, 0);
}

// Four points, in the given order, that span a tetrahedron with positive orientation.
std::optional<std::array<std::uint32_t, 4>> spanning_tetrahedron(std::span<const Point> points,
                                                                 std::span<const std::uint32_t> order) {
  std::array<std::uint32_t, 4> corner{};
  std::size_t found = 0;
  for (const std::uint32_t candidate : order) {
    const Point p = points[candidate];
    if (found == 1 && p == points[corner[0]]) continue;
    if (found == 2 && are_collinear(points[corner[0]], points[corner[1]], p)) continue;
    if (found == 3) {
      const int side = orientation(points[corner[0]], points[corner[1]], points[corner[2]], p);
      if (side == 0) continue;
      if (side < 0) std::swap(corner[1], corner[2]);
    }
    corner[found++] = candidate;
    if (found == 4) return corner;
  }
  return std::nullopt;
}

constexpr std::size_t next(std::size_t slot) { return slot == 2 ? 0 : slot + 1; }

}  // namespace

HullBuilder::HullBuilder(std::span<const Point> points) : points_(points), conflict_(points.size(), none) {}

bool HullBuilder::sees(std::uint32_t point, const HullTriangle& face) const {
  return orientation(points_[face[0]], points_[face[1]], points_[face[2]], points_[point]) > 0;
}

HullBuilder::FaceIndex HullBuilder::add_face(const HullTriangle& vertex) {
  FaceIndex index = static_cast<FaceIndex>(faces_.size());
  if (free_.empty()) {
    faces_.emplace_back();
  } else {
    index = free_.back();
    free_.pop_back();
  }
  Face& face = faces_[index];
  face.vertex = vertex;
  face.alive = true;
  face.seen_by = none;
  return index;
}

// The slot of the edge that starts at `from`.
std::size_t HullBuilder::slot_of_edge(FaceIndex face, std::uint32_t from) const {
  const HullTriangle& vertex = faces_[face].vertex;
  return vertex[0] == from ? 0 : vertex[1] == from ? 1 : 2;
}

bool HullBuilder::start(std::span<const std::uint32_t> order) {
  const auto corner = spanning_tetrahedron(points_, order);
  if (!corner) return false;
  const auto [a, b, c, d] = *corner;  // d is on the outer side of (a, b, c)
  for (const HullTriangle& vertex :
       {HullTriangle{a, c, b}, HullTriangle{a, b, d}, HullTriangle{b, c, d}, HullTriangle{c, a, d}}) {
    add_face(vertex);
  }
  faces_[0].neighbour = {3, 2, 1};  // across a-c, c-b, b-a
  faces_[1].neighbour = {0, 2, 3};  // across a-b, b-d, d-a
  faces_[2].neighbour = {0, 3, 1};  // across b-c, c-d, d-b
  faces_[3].neighbour = {0, 1, 2};  // across c-a, a-d, d-c
  for (const std::uint32_t point : order) {
    for (FaceIndex face = 0; face < 4; ++face) {
      if (!sees(point, faces_[face].vertex)) continue;
      conflict_[point] = face;
      faces_[face].conflicts.push_back(point);
      break;
    }
  }
  return true;
}

void HullBuilder::insert(std::uint32_t point) {
  CSGCAST_PRECONDITION(!faces_.empty());
  const FaceIndex first = conflict_[point];
  if (first == none) return;  // inside, on the boundary, or a corner already
  collect_seen(point, first);
  collect_horizon();
  build_cone(point);
  refile_conflicts(point);
}

void HullBuilder::collect_seen(std::uint32_t point, FaceIndex first) {
  seen_.assign(1, first);
  faces_[first].seen_by = point;
  for (std::size_t done = 0; done < seen_.size(); ++done) {
    for (const FaceIndex neighbour : faces_[seen_[done]].neighbour) {
      if (faces_[neighbour].seen_by == point || !sees(point, faces_[neighbour].vertex)) continue;
      faces_[neighbour].seen_by = point;
      seen_.push_back(neighbour);
    }
  }
}

// Walks around the seen disc, turning about each vertex to the next edge on its rim.
void HullBuilder::collect_horizon() {
  const std::uint32_t inserted = faces_[seen_.front()].seen_by;
  const auto is_seen = [&](FaceIndex face) { return faces_[face].seen_by == inserted; };
  FaceIndex face = none;
  std::size_t slot = 0;
  for (const FaceIndex candidate : seen_) {
    for (std::size_t s = 0; s < 3 && face == none; ++s) {
      if (is_seen(faces_[candidate].neighbour[s])) continue;
      face = candidate;
      slot = s;
    }
    if (face != none) break;
  }
  assert(face != none);
  horizon_.clear();
  const std::uint32_t begin = faces_[face].vertex[slot];
  do {
    const std::uint32_t to = faces_[face].vertex[next(slot)];
    horizon_.push_back({faces_[face].vertex[slot], to, faces_[face].neighbour[slot]});
    slot = next(slot);
    while (is_seen(faces_[face].neighbour[slot])) {
      face = faces_[face].neighbour[slot];
      slot = slot_of_edge(face, to);
    }
  } while (faces_[face].vertex[slot] != begin);
}

// A triangle from every edge of the horizon to the new point.
void HullBuilder::build_cone(std::uint32_t apex) {
  cone_.clear();
  for (const HorizonEdge& edge : horizon_) {
    const FaceIndex face = add_face({edge.from, edge.to, apex});
    cone_.push_back(face);
    faces_[face].neighbour[0] = edge.unseen;
    faces_[edge.unseen].neighbour[slot_of_edge(edge.unseen, edge.to)] = face;
  }
  for (std::size_t i = 0; i < cone_.size(); ++i) {
    const std::size_t following = i + 1 == cone_.size() ? 0 : i + 1;
    faces_[cone_[i]].neighbour[1] = cone_[following];
    faces_[cone_[following]].neighbour[2] = cone_[i];
  }
}

void HullBuilder::refile_conflicts(std::uint32_t inserted) {
  for (const FaceIndex dead : seen_) {
    faces_[dead].alive = false;
    const std::vector<std::uint32_t> homeless = std::exchange(faces_[dead].conflicts, {});
    for (const std::uint32_t point : homeless) {
      conflict_[point] = none;
      if (point == inserted) continue;
      for (const FaceIndex face : cone_) {
        if (!sees(point, faces_[face].vertex)) continue;
        conflict_[point] = face;
        faces_[face].conflicts.push_back(point);
        break;
      }
    }
  }
  free_.insert(free_.end(), seen_.begin(), seen_.end());
}

std::vector<HullTriangle> HullBuilder::triangles() const {
  std::vector<HullTriangle> result;
  for (const Face& face : faces_) {
    if (face.alive) result.push_back(face.vertex);
  }
  return result;
}

}  // namespace csgcast::detail
