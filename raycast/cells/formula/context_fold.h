// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/cells/formula/formula.h"
#include "raycast/cells/formula/implications.h"

namespace csgcast::detail {

/// Finds half-spaces of a formula that have only one value wherever the formula depends on them. It goes down the
/// formula with what is known at each operand: in an intersection all other operands hold, and in a union none of them
/// does. It also uses what that implies. It recurses over the formula.
class ContextFold {
 public:
  /// `literals`: by term, the literal of each half-space. `known`: by term, all open at first; run() sets what it
  /// finds. All arguments must outlive this.
  ContextFold(const Formula& formula, const Implications& implications, const std::vector<std::uint8_t>& literals,
              std::vector<Truth>& known)
      : terms_(formula.terms), implications_(implications), literals_(literals), known_(known) {}

  /// Returns false if no half-space was found. Precondition: the formula is not constant.
  bool run();

 private:
  using Literals = Implications::Literals;

  // What a leaf tells the operands beside it. All three sets are empty if the operand is no leaf, or holds nowhere.
  struct Told {
    Literals holds;  // literals that hold where the leaf does
    Literals fails;  // literals that hold where the leaf does not
    Literals own;    // the literals that it is the conjunction of
  };

  void visit(std::size_t at, const Literals& context);
  void visit_operands(std::size_t at, const Literals& context);
  bool drop_covered(const std::vector<Told>& told, std::size_t operand, std::size_t at, const Literals& context);
  Told told_by(std::size_t at) const;

  const std::vector<Term>& terms_;
  const Implications& implications_;
  const std::vector<std::uint8_t>& literals_;
  std::vector<Truth>& known_;
  bool any_ = false;
};

}  // namespace csgcast::detail
