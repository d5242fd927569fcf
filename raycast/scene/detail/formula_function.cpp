// SPDX-License-Identifier: MIT
#include "raycast/scene/detail/formula_function.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "raycast/scene/half_space_runs.h"

namespace csgcast::detail {
namespace {

// `yes` if a half-space holds all of a box, `no` if it holds nothing of it.
Truth holds(const HalfSpace& half_space, LeafBox& box) {
  const Sides sides = box.sides_of(half_space.surface);
  if (sides == Sides::both) return Truth::unknown;
  return truth((sides == Sides::positive) == (half_space.sense == Sense::positive));
}

// Room for some values. It allocates no memory if they are few.
class TruthBuffer {
 public:
  explicit TruthBuffer(std::size_t size) : size_(size) {
    if (size > few_.size()) many_.resize(size);
  }
  std::span<Truth> span() { return many_.empty() ? std::span(few_).first(size_) : std::span(many_); }

 private:
  std::array<Truth, 128> few_;
  std::vector<Truth> many_;
  std::size_t size_;
};

}  // namespace

Truth FormulaFunction::value(std::span<const Truth> holds) const {
  TruthBuffer values(formula_->size());
  evaluate(*formula_, holds, values.span());
  return values.span().front();
}

// Operands come after their operators, so the lists of the operands are known first when going backwards. scratch[i] is
// the list of term i.
void FormulaFunction::intervals(std::span<const HalfSpace> half_spaces, LeafLine& line, Span /*reach*/,
                                IntervalList& list, std::vector<IntervalList>& scratch) const {
  const TruthFormula& terms = *formula_;
  const auto by_order = [&line](const Crossing& a, const Crossing& b) { return line.order(a, b); };
  if (scratch.size() < terms.size()) scratch.resize(terms.size());
  for (std::size_t i = terms.size(); i-- > 0;) {
    const TruthTerm& term = terms[i];
    IntervalList& result = scratch[i];
    if (term.op == TruthTerm::Op::condition) {
      HalfSpace half_space = half_spaces[term.condition];
      if (term.is_contrary) half_space.sense = csgcast::opposite(half_space.sense);
      half_space_runs(line, half_space, result);
      continue;
    }
    const bool unites = term.op == TruthTerm::Op::unite;
    result.clear();
    if (!unites) result.push_back({line_start(), line_end()});
    for (std::size_t k = i + 1; k < i + term.size; k += terms[k].size) {
      if (unites) {
        combine<Union>(result, scratch[k], list, by_order);
      } else {
        combine<Intersection>(result, scratch[k], list, by_order);
      }
      std::swap(result, list);
    }
  }
  std::swap(list, scratch.front());
}

LeafFunction::Content FormulaFunction::in_box(std::span<const HalfSpace> half_spaces, LeafBox& box,
                                              TruthFormula& terms) const {
  const TruthFormula& all = *formula_;
  TruthBuffer known(half_spaces.size());
  std::transform(half_spaces.begin(), half_spaces.end(), known.span().begin(),
                 [&box](const HalfSpace& half_space) { return holds(half_space, box); });
  TruthBuffer buffer(all.size());
  const std::span<Truth> values = buffer.span();
  evaluate(all, known.span(), values);
  if (values.front() != Truth::unknown) return values.front() == Truth::yes ? Content::full : Content::empty;
  terms.clear();
  std::vector<std::size_t> open;  // the operators around a term, by their places in the result
  std::vector<std::size_t> ends;  // the ends of these operators in the whole formula
  const auto close_until = [&](std::size_t at) {
    while (!ends.empty() && ends.back() <= at) {
      terms[open.back()].size = static_cast<std::uint32_t>(terms.size() - open.back());
      open.pop_back();
      ends.pop_back();
    }
  };
  for (std::size_t i = 0; i < all.size();) {
    close_until(i);
    if (values[i] != Truth::unknown) {  // if the term settles an operator, the operator is not unknown itself
      i += all[i].size;
      continue;
    }
    if (all[i].op != TruthTerm::Op::condition) {
      open.push_back(terms.size());
      ends.push_back(i + all[i].size);
    }
    terms.push_back(all[i]);
    ++i;
  }
  close_until(all.size());
  return Content::terms;
}

}  // namespace csgcast::detail
