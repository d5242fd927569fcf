// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "raycast/scene/scene.h"
#include "raycast/surface/cell_form.h"

namespace csgcast {

/// The space of a scene's solid, or of one of its nodes, which can be cut into pieces. Cells are made for rays; pieces
/// are exact. The coordinates are the frame's, turned to the axes that most planes are square to. The object is
/// read-only; any number of threads may use it.
class Space {
 public:
  /// The space of the whole solid. The scene must outlive it.
  explicit Space(const Scene& scene) : Space(scene, scene.root()) {}
  /// The space of a node, less other nodes.
  Space(const Scene& scene, NodeId node, std::span<const NodeId> less = {});
  ~Space();
  Space(Space&&) noexcept;
  Space(const Space&);

  /// The space of the intersection of two nodes. It is made from the whole solid's space, which need not outlive it.
  Space common(NodeId a, NodeId b) const;
  /// The section with the plane normal . p = distance, in coordinates x and y of the plane. No surface depends on z,
  /// which goes from -1/2 to 1/2. Preconditions: the space is bounded, and the normal is not zero.
  Space section(Vector normal, double distance) const;
  /// The space in which the whole solid would be different if one of its nodes were empty, or everything. It is made
  /// from the whole solid's space. `reach` must hold all of the result. If `reach` is infinite, or meets more than some
  /// 300 leaves, the result is not bounded.
  Space effect_of(NodeId node, bool as_everything, const Box& reach) const;

  const Scene& scene() const;
  /// False if the solid may be unbounded. Then there are no pieces.
  bool is_bounded() const { return is_bounded_; }
  /// True if the space is known to hold nothing of the solid.
  bool is_empty() const;
  /// A box that holds the solid, within |u| <= 4.
  const CellBox& box() const { return box_; }
  /// A surface's form in these coordinates, up to a positive factor. If its numbers are out of range, the form decides
  /// nothing and `is_known` is false.
  const CellForm& form(std::uint32_t surface) const;
  bool is_known(std::uint32_t surface) const;
  /// Upper bound on the number of crossings of a line with a surface, at least two. A leaf may have a number of its own
  /// behind all surfaces; for it, this bounds the crossings with the leaf's surfaces.
  std::uint64_t most_crossings(std::uint32_t surface) const;
  bool is_plane(std::uint32_t surface) const;

  /// One unit of these coordinates in the scene's unit of length. It is a power of two.
  double scale() const;
  /// The axes of these coordinates, as rows in the scene's coordinates. They are unit and square to each other to
  /// 2^-52.
  std::array<Vector, 3> axes() const;
  /// A vector of these coordinates in the scene's axes. Its length is not scaled.
  Vector turned_back(Vector v) const;
  /// A place of these coordinates in the scene's coordinates.
  Point in_scene(Vector u) const;

  /// The content of the space, for the code that cuts it (detail/space_content.h).
  struct Content;
  const Content& content() const { return *content_; }

 private:
  Space unbounded() const;
  Space(Content content, CellBox box, NodeId node = {});

  std::shared_ptr<const Content> content_;
  CellBox box_;
  NodeId node_;  // valid if this is the space of a node
  bool is_bounded_ = true;
};

}  // namespace csgcast
