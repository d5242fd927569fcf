// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "csg/base/place.h"
#include "csg/base/shared.h"
#include "csg/base/transform.h"
#include "csg/exact/composition.h"
#include "csg/solid/look.h"

namespace csgcast {

/// The scene text's words for leaves.
enum class LeafKind : std::uint8_t {
  cube,
  sphere,
  cylinder,
  ellipsoid,
  paraboloid,
  hyperboloid,
  quadric,
  halfspace,
  convex,
};

/// As it stands in a scene text: "cube".
const char* word(LeafKind kind);

struct LeafShape;  // csg/solid/leaf_shape.h

/// A named subtree with a density, for queries by part.
struct PartName {
  std::string name;
  double density = 1;
};

/// A solid: an immutable tree of shared nodes; copying is cheap. The regular closed set that its operators give.
///
/// Trees may be a million deep: nothing here recurses, destructors included.
class Solid {
 public:
  enum class Kind : std::uint8_t {
    empty,
    everything,
    leaf,
    unite,
    intersect,
    subtract,
    complement,
    transform,
    part,
    look
  };

  Solid();  ///< the empty solid

  static Solid everything();
  static Solid leaf(LeafShape shape);

  Kind kind() const;
  /// unite, intersect, subtract: two or more, in file order (subtract: first less all others); complement, transform,
  /// part, look: one; else none.
  std::span<const Solid> children() const;
  const LeafShape& shape() const;      ///< precondition: a leaf
  const Transform& transform() const;  ///< precondition: a transform
  const PartName& part() const;        ///< precondition: a part
  const LookStatement& look() const;   ///< precondition: a look
  /// Where the statement that made this node stands; line 0 if it was made in code.
  const Place& place() const;
  /// The same solid with another place.
  Solid at(Place place) const&;
  Solid at(Place place) &&;
  /// Nodes with equal identity are one shared node.
  const void* identity() const;
  /// How many leaves the tree has, those of a shared node at each of its uses; 2^64 - 1 if there are more.
  std::uint64_t leaf_count() const;

  friend Solid unite(std::vector<Solid> children);
  friend Solid intersect(std::vector<Solid> children);
  friend Solid subtract(std::vector<Solid> children);
  friend Solid complement(Solid solid);
  friend Solid transformed(Solid solid, const Transform& world_from_solid);
  friend Solid named(Solid solid, PartName name);
  friend Solid with_look(Solid solid, LookStatement look);

 private:
  struct Node;
  template <class Payload>
  struct NodeWith;
  explicit Solid(Shared<Node> node);
  static Solid make(Kind kind, std::vector<Solid> children);
  template <class Payload>
  static Solid make(Kind kind, std::vector<Solid> children, Payload payload);
  template <class Payload>
  const Payload& payload(Kind of) const;
  Solid copy() const;

  Shared<Node> node_;
};

/// All points of any child; of none: empty.
Solid unite(std::vector<Solid> children);
/// All points of every child; of none: empty (as in OpenSCAD).
Solid intersect(std::vector<Solid> children);
/// The first child less all the others, closed; of none: empty.
Solid subtract(std::vector<Solid> children);
/// The closure of the complement.
Solid complement(Solid solid);
/// A singular transform gives the empty solid; the caller warns. Transforms of transforms compose exactly, as many as
/// there are; a * b (csg/exact/composition.h) is one rounded matrix. Precondition: finite entries.
Solid transformed(Solid solid, const Transform& world_from_solid);
/// Both throw Error(bad_value) for what a scene text refuses: an empty name, a density that is negative or not finite,
/// a material or paint out of its range (csg/solid/rules/rules.h).
Solid named(Solid solid, PartName name);
Solid with_look(Solid solid, LookStatement look);

inline Solid operator+(Solid a, Solid b) { return unite({std::move(a), std::move(b)}); }
inline Solid operator&(Solid a, Solid b) { return intersect({std::move(a), std::move(b)}); }
inline Solid operator-(Solid a, Solid b) { return subtract({std::move(a), std::move(b)}); }

}  // namespace csgcast
