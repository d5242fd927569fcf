// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "csg/base/truth_table.h"
#include "raycast/cells/formula/form_range.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

/// Which sides of some surfaces lie within sides of others, in a box. The literal 2 i + 1 is the i-th surface's
/// positive side, 2 i its negative one.
class Implications {
 public:
  static constexpr std::size_t most = 32;  ///< surfaces: more are seldom near each other, and cost their square
  using Literals = std::bitset<2 * most>;

  /// Of `count` surfaces in a box: nothing is known yet. `half`: of the box's sides.
  void begin(std::size_t count, Vector half);
  /// The i-th surface's form about the box's middle: it is compared with those that came before.
  void add(std::size_t i, const LocalForm& form);

  bool any() const { return any_; }
  /// The literals that hold where one does, itself included.
  const Literals& by(std::size_t literal) const { return implied_[literal]; }
  /// Of the first surfaces, bit i of a state for the i-th's positive side. Precondition: there are no more.
  TruthTable impossible_states() const;

 private:
  struct Added {
    std::size_t surface;
    LocalForm form;
    Likeness own;           // with itself
    std::uint32_t corners;  // where it is negative
  };

  void note(std::size_t literal, std::size_t other);

  std::size_t count_ = 0;
  Vector half_;
  bool any_ = false;
  std::vector<Added> added_;
  std::array<Literals, 2 * most> implied_;
};

/// Finds half-spaces of a formula that have one value wherever the formula's depends on them, given what implies what,
/// by what is known where they are asked for: in an intersection that the other operands hold, in a union that they do
/// not.
class ContextFold {
 public:
  /// `literals`: by term, of half-spaces. `known`: by term, all open; becomes what is found.
  ContextFold(const Formula& formula, const Implications& implications, const std::vector<std::uint8_t>& literals,
              std::vector<Known>& known)
      : terms_(formula.terms), implications_(implications), literals_(literals), known_(known) {}

  /// Whether any was found.
  bool run();

 private:
  using Literals = Implications::Literals;

  // What a leaf tells the operands beside it: literals that hold where it does, and where it does not.
  struct Told {
    Literals holds;
    Literals fails;
    Literals own;  // those it is the conjunction of; none of what is no leaf, or nowhere
  };

  void visit(std::size_t at, const Literals& context);
  void visit_operands(std::size_t at, const Literals& context);
  bool drop_covered(const std::vector<Told>& told, std::size_t operand, std::size_t at, const Literals& context);
  Told told_by(std::size_t at) const;

  const std::vector<Term>& terms_;
  const Implications& implications_;
  const std::vector<std::uint8_t>& literals_;
  std::vector<Known>& known_;
  bool any_ = false;
};

}  // namespace csgcast::detail
