// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/context_fold.h"

namespace csgcast::detail {

bool ContextFold::run() {
  visit(0, {});
  return any_;
}

void ContextFold::visit(std::size_t at, const Literals& context) {
  if (terms_[at].op != Term::Op::half_space) return visit_operands(at, context);
  const std::size_t literal = literals_[at];
  if (!context.test(literal) && !context.test(literal ^ 1)) return;
  known_[at] = context.test(literal) ? Truth::yes : Truth::no;
  any_ = true;
}

// Visits each operand with what is known from the other operands: from those before it as they are now, and from those
// after it as they were.
void ContextFold::visit_operands(std::size_t at, const Literals& context) {
  const Term::Op op = terms_[at].op;
  const std::size_t end = at + terms_[at].size;
  if (op == Term::Op::complement) return visit(at + 1, context);
  std::vector<Told> told;  // by operand
  std::vector<Literals> later(1);
  for (std::size_t operand = at + 1; operand < end; operand += terms_[operand].size) told.push_back(told_by(operand));
  // The value depends on an operand of a difference only where the first operand holds, and none of the others does.
  const auto must_hold = [op](std::size_t k) {
    return op == Term::Op::intersect || op == Term::Op::leaf || (op == Term::Op::subtract && k == 0);
  };
  const auto of_others = [&](std::size_t k) { return must_hold(k) ? told[k].holds : told[k].fails; };
  for (std::size_t k = told.size(); k-- > 1;) later.push_back(later.back() | of_others(k));
  Literals earlier = context;
  std::size_t k = 0;
  for (std::size_t operand = at + 1; operand < end; operand += terms_[operand].size, ++k) {
    const Literals known = earlier | later[told.size() - 1 - k];
    if (must_hold(k) || !drop_covered(told, k, operand, known)) visit(operand, known);
    told[k] = told_by(operand);
    if (op == Term::Op::subtract && k == 0) told[k].own.reset();
    earlier |= of_others(k);
  }
}

// Drops an operand of a union if it is a leaf within another leaf of the union. Returns false if it is not.
bool ContextFold::drop_covered(const std::vector<Told>& told, std::size_t operand, std::size_t at,
                               const Literals& context) {
  constexpr std::size_t most_compared = 64;
  const Literals holds = told[operand].holds | context;
  if (told[operand].own.none() || told.size() > most_compared) return false;
  for (std::size_t other = 0; other < told.size(); ++other) {
    if (other == operand || told[other].own.none() || (told[other].own & ~holds).any()) continue;
    known_[terms_[at].op == Term::Op::leaf ? at + 1 : at] = Truth::no;
    return any_ = true;
  }
  return false;
}

// What a leaf, or a single half-space, tells by those of its half-spaces that are still open.
ContextFold::Told ContextFold::told_by(std::size_t at) const {
  const Term::Op op = terms_[at].op;
  if (op != Term::Op::leaf && op != Term::Op::half_space) return {};
  const std::size_t first = op == Term::Op::leaf ? at + 1 : at;
  Told told;
  std::size_t open = 0;
  for (std::size_t i = first; i < at + terms_[at].size; ++i) {
    if (known_[i] == Truth::no) return {};
    if (known_[i] == Truth::yes) continue;
    told.own.set(literals_[i]);
    told.holds |= implications_.by(literals_[i]);
    told.fails = implications_.by(literals_[i] ^ std::uint8_t{1});
    ++open;
  }
  if (open != 1) told.fails.reset();
  return told;
}

}  // namespace csgcast::detail
