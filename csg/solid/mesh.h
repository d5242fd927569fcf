// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "csg/base/vector.h"

namespace csgcast {

/// A polygon mesh. Faces are loops of indices into the points. All faces must turn the same way as seen from outside,
/// but it does not matter which way.
struct Mesh {
  using Face = std::vector<std::uint32_t>;

  std::vector<Point> points;
  std::vector<Face> faces;
};

/// The mesh with equal points merged. Repeated neighbours in a face are left out, faces with fewer than three corners
/// are dropped, and only points that faces use are kept. Precondition: indices are in range.
Mesh welded(const Mesh& mesh);

/// Two points that an edge joins.
struct MeshEdge {
  Point from;
  Point to;
};

/// Finds an edge along which faces do not run equally often in both directions. With such an edge the mesh bounds no
/// solid. Returns nothing if the mesh is closed.
std::optional<MeshEdge> open_edge(const Mesh& welded);

/// True if a closed mesh is convex, or so nearly convex that OpenSCAD uses its hull instead. Such a mesh is connected,
/// and each edge is between two faces. No edge is bent inward and no face is bent out of its plane by more than 0.1
/// degree, and the volume is that of the hull, up to what these angles explain. A flat mesh is convex. The test is
/// computed in doubles: it accepts a mesh, it does not define the solid. Source: OpenSCAD 2021.01,
/// is_approximately_convex.
bool is_convex(const Mesh& welded);

/// How far a corner lies from the plane of its face, at most. Computed in doubles.
double greatest_bend(const Mesh& welded);

}  // namespace csgcast
