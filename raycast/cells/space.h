// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "raycast/scene/scene.h"
#include "raycast/surface/cell_form.h"

namespace csgcast {

/// The space of a scene's solid, or of one of its nodes, to be cut into pieces: exactly, not for rays only. Its
/// coordinates are the frame's, turned to the axes that most planes are square to. Read-only; any number of threads may
/// use it.
class Space {
 public:
  /// The scene must outlive the space.
  explicit Space(const Scene& scene) : Space(scene, scene.root()) {}
  /// Of one of its nodes, less others.
  Space(const Scene& scene, NodeId node, std::span<const NodeId> less = {});
  ~Space();
  Space(Space&&) noexcept;
  Space(const Space&);

  /// What two nodes share. Made from the whole solid's space, which is not needed any more then.
  Space common(NodeId a, NodeId b) const;
  /// Its section with the plane normal . p = distance, of height 1: in coordinates x and y of the plane; no surface
  /// depends on z, which goes from -1/2 to 1/2. Precondition: the space is bounded, the normal not zero.
  Space section(Vector normal, double distance) const;
  /// Where the whole solid would be another one if one of its nodes were empty, or everything. Made from the whole
  /// solid's space. `reach` holds all of that; if it is infinite,
  /// or meets more than some 300 leaves, the result is not bounded.
  Space effect_of(NodeId node, bool as_everything, const Box& reach) const;

  const Scene& scene() const;
  /// False if the solid may be unbounded: then there are no pieces.
  bool is_bounded() const { return is_bounded_; }
  /// Known to hold nothing.
  bool is_empty() const;
  /// Holds the solid; within |u| <= 4.
  const CellBox& box() const { return box_; }
  /// A surface's form in these coordinates, up to a positive factor. `is_known` is false where the form decides
  /// nothing, as its numbers are out of range.
  const CellForm& form(std::uint32_t surface) const;
  bool is_known(std::uint32_t surface) const;
  bool is_plane(std::uint32_t surface) const;

  /// One unit of these coordinates in the scene's unit of length: a power of two.
  double scale() const;
  /// The axes of these coordinates, as rows in those of the scene: unit and square to each other to 2^-52.
  std::array<Vector, 3> axes() const;
  Vector turned_back(Vector v) const;  ///< into the scene's axes; not scaled
  Point in_scene(Vector u) const;

  /// What the tree comes to in it, for those who cut it (detail/space_content.h).
  struct Content;
  const Content& content() const { return *content_; }

 private:
  Space unbounded() const;
  Space(Content content, CellBox box, NodeId node = {});

  std::shared_ptr<const Content> content_;
  CellBox box_;
  NodeId node_;  ///< if it is the space of one
  bool is_bounded_ = true;
};

}  // namespace csgcast
