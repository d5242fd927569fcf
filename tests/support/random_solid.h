// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

#include "csg/solid/solid.h"

namespace csgcast::test {

/// Seeded random solids: every kind of leaf, every operator, transforms with mirrors. The same seed gives the same
/// solid everywhere.
class RandomSolids {
 public:
  explicit RandomSolids(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double number(double low, double high);
  /// A multiple of 1/4 in [low, high]: makes faces coincide and edges meet rays exactly.
  double quarter(double low, double high);
  std::size_t index(std::size_t count);
  Point point(double radius);
  Vector direction();

  /// A leaf of size about 1 near the origin, moved by a random transform.
  Solid leaf();
  /// A box whose corners are multiples of 1/4.
  Solid grid_box();
  /// A tree of about `leaves` leaves made by `make_leaf`.
  template <class MakeLeaf>
  Solid tree(int leaves, MakeLeaf&& make_leaf) {
    if (leaves <= 1) return make_leaf();
    const int left = 1 + static_cast<int>(index(static_cast<std::size_t>(leaves - 1)));
    Solid a = tree(left, make_leaf);
    Solid b = tree(leaves - left, make_leaf);
    return combined(std::move(a), std::move(b));
  }
  Solid tree(int leaves) {
    return tree(leaves, [this] { return leaf(); });
  }

 private:
  Solid combined(Solid a, Solid b);
  Solid plain_leaf();
  Transform transform();

  std::mt19937_64 engine_;
};

}  // namespace csgcast::test
