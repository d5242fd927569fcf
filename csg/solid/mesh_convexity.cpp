// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include "csg/base/length.h"
#include "csg/exact/hull.h"
#include "csg/solid/mesh.h"

namespace csgcast {
namespace {

constexpr double largest_bend = 0.1 * std::numbers::pi / 180;
/// What doubles lose of a volume relative to area times extent, with room to spare.
constexpr double rounding = 1e-9;

/// Smaller faces of a mesh of extent about 1 have no normal to speak of.
constexpr double least_area = 1e-12;

/// The mesh with its largest coordinate brought near 1, so that volumes neither overflow nor underflow.
Mesh scaled_to_one(Mesh mesh) {
  double largest = 0;
  for (const Point& p : mesh.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  if (largest == 0) return mesh;
  const int exponent = -std::ilogb(largest);
  for (Point& p : mesh.points) p = {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent), std::scalbn(p.z, exponent)};
  return mesh;
}

/// A face's plane: unit normal (zero if the face has hardly any area) and a point on it.
struct FacePlane {
  Vector normal;
  Point center;
  double area = 0;
};

FacePlane plane_of(const Mesh& mesh, const Mesh::Face& face) {
  const Point origin = mesh.points[face[0]];
  Vector doubled_area, sum;
  for (std::size_t i = 1; i < face.size(); ++i) sum = sum + (mesh.points[face[i]] - origin);
  for (std::size_t i = 2; i < face.size(); ++i) {
    doubled_area = doubled_area + cross(mesh.points[face[i - 1]] - origin, mesh.points[face[i]] - origin);
  }
  const double area = length(doubled_area) / 2;
  const Vector normal = area > least_area ? normalised(doubled_area) : Vector{};
  return {normal, origin + (1.0 / static_cast<double>(face.size())) * sum, area};
}

double volume(const Mesh& mesh) {
  const Point origin = mesh.points[0];
  double six_volumes = 0;
  for (const Mesh::Face& face : mesh.faces) {
    const Vector a = mesh.points[face[0]] - origin;
    for (std::size_t i = 2; i < face.size(); ++i) {
      six_volumes += dot(a, cross(mesh.points[face[i - 1]] - origin, mesh.points[face[i]] - origin));
    }
  }
  return six_volumes / 6;
}

/// The largest coordinate difference.
double extent(const std::vector<Point>& points) {
  double result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [&](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    result = std::max(result, (*high)[axis] - (*low)[axis]);
  }
  return result;
}

/// The angle by which a face leaves its plane: the farthest corner's height over its distance from the centre.
double bend_of_face(const Mesh& mesh, const Mesh::Face& face, const FacePlane& plane) {
  double result = 0;
  for (const std::uint32_t corner : face) {
    const Vector offset = mesh.points[corner] - plane.center;
    const double reach = length(offset);
    if (reach > 0) result = std::max(result, std::fabs(dot(plane.normal, offset)) / reach);
  }
  return result;
}

/// One side of an edge: the face that runs along it, and which way.
struct Side {
  std::uint32_t lower;
  std::uint32_t upper;
  std::uint32_t face;
  bool upward;
};

std::vector<Side> sorted_sides(const Mesh& mesh) {
  std::vector<Side> sides;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Mesh::Face& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
      sides.push_back({std::min(from, to), std::max(from, to), f, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.lower, a.upper, a.upward) < std::tie(b.lower, b.upper, b.upward);
  });
  return sides;
}

/// Sets of faces that hang together (union-find with path halving).
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count), count_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parent_[a] = b;
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

/// The angle by which the surface bends inward at an edge; 0 if it bends outward or a face has no area. `outward` is +1
/// if face loops are counter-clockwise seen from outside, else -1.
double bend_of_edge(const Mesh& mesh, const std::vector<FacePlane>& planes, const Side& upward, const Side& downward,
                    double outward) {
  const Vector along = mesh.points[upward.upper] - mesh.points[upward.lower];
  const Vector turn = cross(planes[upward.face].normal, planes[downward.face].normal);
  if (outward * dot(turn, along) >= 0) return 0;
  return std::atan2(length(turn), dot(planes[upward.face].normal, planes[downward.face].normal));
}

/// The largest inward bend of any edge; nothing if the mesh is no connected manifold.
std::optional<double> bend_of_edges(const Mesh& mesh, const std::vector<FacePlane>& planes, double outward) {
  const std::vector<Side> sides = sorted_sides(mesh);
  Components components(mesh.faces.size());
  double result = 0;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    if (i + 1 == sides.size()) return std::nullopt;
    const Side& downward = sides[i];
    const Side& upward = sides[i + 1];
    const bool pair =
        downward.lower == upward.lower && downward.upper == upward.upper && !downward.upward && upward.upward;
    const bool alone =
        i + 2 == sides.size() || sides[i + 2].lower != upward.lower || sides[i + 2].upper != upward.upper;
    if (!pair || !alone) return std::nullopt;
    components.join(upward.face, downward.face);
    result = std::max(result, bend_of_edge(mesh, planes, upward, downward, outward));
  }
  if (components.count() != 1) return std::nullopt;
  return result;
}

}  // namespace

bool is_convex(const Mesh& unscaled) {
  const Mesh mesh = scaled_to_one(unscaled);
  const std::vector<HullTriangle> hull_triangles = convex_hull(mesh.points);
  if (hull_triangles.empty()) return true;
  std::vector<FacePlane> planes;
  for (const Mesh::Face& face : mesh.faces) planes.push_back(plane_of(mesh, face));
  const double mesh_volume = volume(mesh);
  const auto edge_bend = bend_of_edges(mesh, planes, mesh_volume < 0 ? -1 : 1);
  if (!edge_bend) return false;
  double bend = *edge_bend;
  double area = 0;
  for (std::size_t f = 0; f < planes.size(); ++f) {
    bend = std::max(bend, bend_of_face(mesh, mesh.faces[f], planes[f]));
    area += planes[f].area;
  }
  if (bend > largest_bend) return false;
  Mesh hull{mesh.points, {}};
  for (const HullTriangle& triangle : hull_triangles) hull.faces.emplace_back(triangle.begin(), triangle.end());
  const double missing = volume(hull) - std::fabs(mesh_volume);
  return std::fabs(missing) <= (bend + rounding) * area * extent(mesh.points);
}

double greatest_bend(const Mesh& welded) {
  double most = 0;
  for (const Mesh::Face& face : welded.faces) {
    const FacePlane plane = plane_of(welded, face);
    for (const std::uint32_t corner : face)
      most = std::fmax(most, std::fabs(dot(plane.normal, welded.points[corner] - plane.center)));
  }
  return most;
}

}  // namespace csgcast
