// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "csg/base/vector.h"

namespace csgcast {

/// A polygon mesh: faces are loops of indices into the points, all turning the same way seen from outside (which way
/// does not matter).
struct Mesh {
  using Face = std::vector<std::uint32_t>;

  std::vector<Point> points;
  std::vector<Face> faces;
};

/// The mesh with equal points made one, repeated neighbours in a face left out, faces with fewer than three corners
/// dropped, and only the points that faces use. Precondition: indices in range.
Mesh welded(const Mesh& mesh);

/// Two points that an edge joins.
struct MeshEdge {
  Point from;
  Point to;
};

/// An edge that faces do not run along equally often in both directions, so that the mesh bounds no solid; nothing if
/// the mesh is closed.
std::optional<MeshEdge> open_edge(const Mesh& welded);

/// Whether a closed mesh is convex, or so nearly that OpenSCAD takes its hull instead: connected, each edge between two
/// faces, no edge bent inward and no face bent out of its plane by more than 0.1 degree, and the volume that of the
/// hull but for what these angles explain. A flat mesh is convex. Computed in doubles: it accepts, it does not define
/// the solid. Source: OpenSCAD 2021.01, is_approximately_convex.
bool is_convex(const Mesh& welded);

}  // namespace csgcast
