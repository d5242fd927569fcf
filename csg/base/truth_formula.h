// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/base/truth.h"

namespace csgcast {

/// One entry of a truth formula: a condition, its negation, or an operator followed by its operands.
struct TruthTerm {
  enum class Op : std::uint8_t { unite, intersect, condition };

  Op op = Op::condition;
  bool is_contrary = false;     ///< true: the condition must not hold
  std::uint32_t size = 1;       ///< the number of entries of the term: itself and its operands
  std::uint32_t condition = 0;  ///< the number of a condition
};

/// A truth function of numbered conditions. It is one term, in prefix order. Only conditions are negated. An empty
/// union is false, an empty intersection true.
using TruthFormula = std::vector<TruthTerm>;

/// The condition with that number, or its negation.
TruthFormula condition(std::uint32_t number, bool holds = true);
/// True where at least one of the operands is.
TruthFormula either(std::span<const TruthFormula> operands);
/// True where all of the operands are.
TruthFormula both(std::span<const TruthFormula> operands);

/// True if the terms are one term with all its operands, over that many conditions.
bool is_well_formed(std::span<const TruthTerm> terms, std::size_t conditions);

/// Writes the value of each term to its place, given the value of each condition by number. Preconditions: the terms
/// are well-formed, and there is one value for each term.
void evaluate(std::span<const TruthTerm> terms, std::span<const Truth> conditions, std::span<Truth> values);

}  // namespace csgcast
