// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csg/base/truth_table.h"
#include "raycast/surface/form_range.h"

namespace csgcast::detail {

/// Tells which sides of some surfaces lie within sides of others in a box. The literal 2 i + 1 is the positive side of
/// the i-th surface, and 2 i its negative side. The object keeps its memory.
class Implications {
 public:
  /// The greatest number of surfaces. More are seldom near each other, and the time goes by the square of the number.
  static constexpr std::size_t most = 32;
  using Literals = std::bitset<2 * most>;

  /// Forgets everything, and begins with `count` surfaces in a box. `half` is half of the box's sides.
  void begin(std::size_t count, Vector half);
  /// Adds the i-th surface by its form about the box's middle. It is compared with the surfaces that came before. In an
  /// infinite box this does nothing.
  void add(std::size_t i, const LocalForm& form);

  /// True if some literal implies another one.
  bool any() const { return any_; }
  /// The literals that hold wherever a literal does, itself included.
  const Literals& by(std::size_t literal) const { return implied_[literal]; }
  /// The states that occur nowhere in the box. Bit i of a state says that the i-th surface is positive. Precondition:
  /// there are at most eight surfaces.
  TruthTable impossible_states() const;

 private:
  struct Added {
    std::size_t surface;
    LocalForm form;
    Likeness own;           // the form's likeness with itself
    std::uint32_t corners;  // the corners where the form is negative
  };

  void note(std::size_t literal, std::size_t other);

  std::size_t count_ = 0;
  Vector half_;
  bool any_ = false;
  std::vector<Added> added_;
  std::array<Literals, 2 * most> implied_;
};

}  // namespace csgcast::detail
