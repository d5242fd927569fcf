// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csg/exact/affine.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/solid.h"
#include "raycast/weld/coincidence.h"
#include "raycast/weld/hash_index.h"

namespace csgcast::detail {

/// Knows where the forms of leaves come from: the solid that each leaf was made from, and the chain of transforms that
/// moved it. From these follows how far a surface may be from what was meant, if every given number is known to half an
/// ulp.
class Provenance {
 public:
  /// A chain of transforms, the innermost at the end. Equal chains have the same id. 0 is the empty chain.
  using ChainId = std::uint32_t;
  /// One form of one leaf.
  struct Source {
    std::uint32_t leaf;
    std::uint32_t form;
  };

  Provenance();

  /// The chain `outer` with one more transform inside. `world_from_solid` is the exact product of the whole chain.
  ChainId chain(ChainId outer, const Transform& transform, const ExactAffine& world_from_solid);
  /// Adds a leaf made from a solid, moved by a chain, with its box in the world. Returns the leaf's index.
  std::uint32_t add_leaf(const Solid& solid, ChainId chain, const Box& box);

  std::size_t leaf_count() const { return leaves_.size(); }
  /// Whether a number is known to fewer digits than a double has.
  bool has_few_digits() const { return has_few_digits_; }
  /// The statement that made the source's leaf.
  const Place& place(Source source) const { return leaves_[source.leaf].solid.place(); }
  const Box& box(Source source) const { return leaves_[source.leaf].box; }
  ChainId chain_of(Source source) const { return leaves_[source.leaf].chain; }
  /// The longest outer part that two chains have in common. Its errors move both surfaces alike. `steps` is increased
  /// by the work done.
  ChainId common(ChainId a, ChainId b, std::uint64_t& steps) const;

  /// A bound on the difference between the source's surface and what was meant. `form` is its form in the region. The
  /// chain `known`, an outer part of the source's own chain, counts as exact.
  FormError error(Source source, const RegionForm& form, const Region& region, ChainId known) const;
  /// About how far the source's surface may be from what was meant, somewhere in the region, in its unit of length.
  double displacement(Source source, const RegionForm& form, const Region& region) const;

 private:
  using Matrix = std::array<double, 9>;
  static constexpr Matrix identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
  // The linear part of one transform.
  struct Turn {
    Matrix entry = identity;
    Matrix error{};  // the most that each entry may be off
  };
  // The linear part of a whole chain and its inverse. Plain double is enough, because errors need not be exact.
  struct Linear {
    Matrix forward = identity;
    Matrix inverse = identity;
  };
  // A large scene has as many chains as leaves, and most chains end with a translation. A translation changes no linear
  // part. So linear parts are stored separately, and links are small.
  struct Link {
    ChainId outer = 0;
    std::uint32_t depth = 0;
    std::uint32_t turn = 0;    // the linear part of its own transform, in turns_
    std::uint32_t linear = 0;  // the linear part of the whole chain, in linears_
    Vector own_offset;         // the translation of its own transform
    Vector own_offset_error;
    Vector offset;  // the translation of the whole chain
    Digits digits;  // of its own transform's numbers
  };
  struct LeafSource {
    Solid solid;
    ChainId chain;
    Box box;
  };

  // The solid's coordinates over a region, as a function of the region's s: at + spread s.
  struct LocalRegion {
    Vector at;
    Matrix spread;
  };
  bool is_link(const Link& link, ChainId outer, const Transform& transform) const;
  void set_linear(Link& link, const Transform& transform, const ExactAffine& world_from_solid);
  LocalRegion local(const Link& link, const Region& region) const;
  SmallMotion motion(const LeafSource& leaf, const Region& region, ChainId known) const;
  FormError shape_error(const LeafShape& shape, std::uint32_t form, const RegionForm& moved,
                        const LocalRegion& local) const;

  std::vector<Turn> turns_;      // the first is the identity
  std::vector<Linear> linears_;  // the first is the identity
  std::vector<Link> links_;      // the first is the empty chain
  HashIndex by_transform_;       // all other links, by their outer chain and their own transform
  std::vector<LeafSource> leaves_;
  bool has_few_digits_ = false;
};

}  // namespace csgcast::detail
