// SPDX-License-Identifier: MIT
#include "csg/base/truth_formula.h"

#include <algorithm>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

TruthFormula joined(TruthTerm::Op op, std::span<const TruthFormula> operands) {
  TruthFormula whole{{op, false, 1, 0}};
  for (const TruthFormula& operand : operands) whole.insert(whole.end(), operand.begin(), operand.end());
  whole.front().size = static_cast<std::uint32_t>(whole.size());
  return whole;
}

}  // namespace

TruthFormula condition(std::uint32_t number, bool holds) { return {{TruthTerm::Op::condition, !holds, 1, number}}; }

TruthFormula either(std::span<const TruthFormula> operands) { return joined(TruthTerm::Op::unite, operands); }

TruthFormula both(std::span<const TruthFormula> operands) { return joined(TruthTerm::Op::intersect, operands); }

bool is_well_formed(std::span<const TruthTerm> terms, std::size_t conditions) {
  std::vector<std::size_t> ends;  // the ends of the operators around a term
  std::size_t end = terms.size();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    while (!ends.empty() && ends.back() == i) ends.pop_back();
    end = ends.empty() ? terms.size() : ends.back();
    const TruthTerm& term = terms[i];
    const bool is_condition = term.op == TruthTerm::Op::condition;
    if (is_condition ? term.size != 1 || term.condition >= conditions : term.size == 0) return false;
    if (term.size > end - i || (i == 0 && term.size != terms.size())) return false;
    if (!is_condition) ends.push_back(i + term.size);
  }
  return !terms.empty();
}

// Operands come after their operators, so their values are known first when going backwards.
void evaluate(std::span<const TruthTerm> terms, std::span<const Truth> conditions, std::span<Truth> values) {
  CSGCAST_PRECONDITION(is_well_formed(terms, conditions.size()));
  CSGCAST_PRECONDITION(values.size() == terms.size());
  for (std::size_t i = terms.size(); i-- > 0;) {
    const TruthTerm& term = terms[i];
    if (term.op == TruthTerm::Op::condition) {
      const Truth holds = conditions[term.condition];
      values[i] = term.is_contrary ? opposite(holds) : holds;
      continue;
    }
    const bool unites = term.op == TruthTerm::Op::unite;
    Truth value = truth(!unites);
    for (std::size_t k = i + 1; k < i + term.size; k += terms[k].size)
      value = unites ? std::max(value, values[k]) : std::min(value, values[k]);
    values[i] = value;
  }
}

}  // namespace csgcast
