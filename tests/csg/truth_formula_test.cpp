// SPDX-License-Identifier: MIT
#include "csg/base/truth_formula.h"

#include <vector>

#include "csg/base/vector.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

const TruthFormula either_or = either(std::vector{both(std::vector{condition(0), condition(1, false)}), condition(2)});

Truth value(const TruthFormula& formula, const std::vector<Truth>& conditions) {
  std::vector<Truth> values(formula.size());
  evaluate(formula, conditions, values);
  return values.front();
}

}  // namespace

TEST_CASE("a truth formula is as well known as its conditions make it") {
  constexpr Truth no = Truth::no, yes = Truth::yes, unknown = Truth::unknown;
  CHECK(value(either_or, {yes, no, no}) == yes);
  CHECK(value(either_or, {yes, yes, no}) == no);
  CHECK(value(either_or, {no, unknown, unknown}) == unknown);
  CHECK(value(either_or, {no, unknown, no}) == no);
  CHECK(value(either_or, {unknown, unknown, yes}) == yes);
  CHECK(value(either({}), {}) == no);
  CHECK(value(both({}), {}) == yes);
}

TEST_CASE("a truth formula is one term with all its operands, over conditions that there are") {
  CHECK(is_well_formed(either_or, 3));
  CHECK_FALSE(is_well_formed(either_or, 2));
  CHECK_FALSE(is_well_formed({}, 3));
  TruthFormula two = condition(0);
  two.push_back(condition(1).front());
  CHECK_FALSE(is_well_formed(two, 3));
  for (std::size_t i = 0; i < either_or.size(); ++i) {
    for (const std::uint32_t size : {0u, 2u, 9u}) {
      TruthFormula wrong = either_or;
      if (wrong[i].size == size) continue;
      wrong[i].size = size;
      // Another size may make another formula of it, whose last operands stand elsewhere.
      if (is_well_formed(wrong, 3)) CHECK(wrong[i].op != TruthTerm::Op::condition);
      if (size != 2) CHECK_FALSE(is_well_formed(wrong, 3));
    }
  }
}
