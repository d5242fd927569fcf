// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/exact/hull.h"

namespace csgcast::detail {

/// The convex hull of the points inserted so far. It is a closed triangle mesh in which every face knows its
/// neighbours. Every point that is still to come and lies outside knows one face that it sees.
///
/// A point sees a face if it is strictly on its outer side. Faces in whose plane a new point lies are kept: the new
/// triangles continue them. So the seen faces always form a disc (they are those seen from a point moved a little
/// towards the inside, which lies in no face's plane), and no triangle is degenerate (a point in line with an edge is
/// in the planes of both its faces and sees neither). Source: Clarkson and Shor 1989, with one conflict a point in
/// place of the whole conflict graph: a point outside that saw a removed face sees one of the new ones (Barber, Dobkin,
/// Huhdanpaa 1996).
class HullBuilder {
 public:
  explicit HullBuilder(std::span<const Point> points);

  /// Begins with a tetrahedron of the first points in this order that span one. Returns false if all points lie in one
  /// plane.
  bool start(std::span<const std::uint32_t> order);
  /// Adds one point. Precondition: started.
  void insert(std::uint32_t point);
  std::vector<HullTriangle> triangles() const;

 private:
  using FaceIndex = std::uint32_t;
  static constexpr FaceIndex none = 0xffffffffu;

  struct Face {
    HullTriangle vertex{};                 // counter-clockwise from outside
    std::array<FaceIndex, 3> neighbour{};  // across the edge from vertex[i] to vertex[i + 1]
    std::vector<std::uint32_t> conflicts;  // points still to come that see this face and are listed here
    bool alive = true;
    std::uint32_t seen_by = none;  // the last inserted point that saw this face
  };

  // An edge between a face that the new point sees and one that it does not see, as stored in the unseen face.
  struct HorizonEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    FaceIndex unseen = none;
  };

  bool sees(std::uint32_t point, const HullTriangle& face) const;
  FaceIndex add_face(const HullTriangle& vertex);
  std::size_t slot_of_edge(FaceIndex face, std::uint32_t from) const;
  void collect_seen(std::uint32_t point, FaceIndex first);
  void collect_horizon();
  void build_cone(std::uint32_t apex);
  void refile_conflicts(std::uint32_t inserted);

  std::span<const Point> points_;
  std::vector<Face> faces_;
  std::vector<FaceIndex> conflict_;  // by point: a face that it sees, or none
  std::vector<FaceIndex> free_;      // dead faces to use again
  // These are used during one insertion:
  std::vector<FaceIndex> seen_;
  std::vector<HorizonEdge> horizon_;  // a cycle, counter-clockwise seen from the new point
  std::vector<FaceIndex> cone_;
};

}  // namespace csgcast::detail
