// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/implications.h"

#include "csg/base/precondition.h"

namespace csgcast::detail {

void Implications::begin(std::size_t count, Vector half) {
  count_ = count;
  half_ = half;
  any_ = false;
  added_.clear();
  for (std::size_t literal = 0; literal < 2 * count; ++literal) implied_[literal] = Literals().set(literal);
}

// One literal implies another, and the other's contrary its own.
void Implications::note(std::size_t literal, std::size_t other) {
  implied_[literal].set(other);
  implied_[other ^ 1].set(literal ^ 1);
  any_ = true;
}

void Implications::add(std::size_t i, const LocalForm& form) {
  if (!is_finite(half_)) return;
  const Likeness own = likeness(form, form, half_);
  const std::uint32_t here = negative_corners(form, half_);
  for (const Added& other : added_) {
    const std::size_t j = other.surface;
    const std::uint32_t there = other.corners;
    const Likeness between = likeness(form, other.form, half_);
    // The corners refute most. Signs that rounding gets wrong there are within slacks, by which nothing is implied.
    if ((here & ~there) == 0 && implies({form}, {other.form}, half_, between, own)) note(2 * i, 2 * j);
    if ((there & ~here) == 0 && implies({other.form}, {form}, half_, between, other.own)) note(2 * j, 2 * i);
    if ((there & here) == 0 && implies({other.form}, {form, -1}, half_, between, other.own)) note(2 * j, 2 * i + 1);
    if ((there | here) == all_corners && implies({form, -1}, {other.form}, half_, between, own)) note(2 * i + 1, 2 * j);
  }
  added_.push_back({i, form, own, here});
}

TruthTable Implications::impossible_states() const {
  CSGCAST_PRECONDITION(count_ <= TruthTable::most_values);
  TruthTable impossible;
  const auto states = [](std::size_t literal, std::size_t w) {
    const std::uint64_t positive = TruthTable::states_of_word(literal / 2, w);
    return literal % 2 != 0 ? positive : ~positive;
  };
  for (std::size_t a = 0; a < 2 * count_; ++a) {
    for (std::size_t b = 0; b < 2 * count_; ++b) {
      if (b == a || !implied_[a].test(b)) continue;
      for (std::size_t w = 0; w < TruthTable::words; ++w) impossible.word(w) |= states(a, w) & ~states(b, w);
    }
  }
  return impossible;
}

bool ContextFold::run() {
  visit(0, {});
  return any_;
}

void ContextFold::visit(std::size_t at, const Literals& context) {
  if (terms_[at].op != Term::Op::half_space) return visit_operands(at, context);
  const std::size_t literal = literals_[at];
  if (!context.test(literal) && !context.test(literal ^ 1)) return;
  known_[at] = context.test(literal) ? Known::yes : Known::no;
  any_ = true;
}

// Each operand in turn is seen in the light of those before it as they are now, and of those after it as they were.
void ContextFold::visit_operands(std::size_t at, const Literals& context) {
  const Term::Op op = terms_[at].op;
  const std::size_t end = at + terms_[at].size;
  if (op == Term::Op::complement) return visit(at + 1, context);
  std::vector<Told> told;  // by operand
  std::vector<Literals> later(1);
  for (std::size_t operand = at + 1; operand < end; operand += terms_[operand].size) told.push_back(told_by(operand));
  // Of a difference the first holds, and none of the others does.
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

// In a union a leaf within another one is not needed.
bool ContextFold::drop_covered(const std::vector<Told>& told, std::size_t operand, std::size_t at,
                               const Literals& context) {
  constexpr std::size_t most_compared = 64;
  const Literals holds = told[operand].holds | context;
  if (told[operand].own.none() || told.size() > most_compared) return false;
  for (std::size_t other = 0; other < told.size(); ++other) {
    if (other == operand || told[other].own.none() || (told[other].own & ~holds).any()) continue;
    known_[terms_[at].op == Term::Op::leaf ? at + 1 : at] = Known::no;
    return any_ = true;
  }
  return false;
}

// Of a leaf, or one half-space, by those of its half-spaces that are still open.
ContextFold::Told ContextFold::told_by(std::size_t at) const {
  const Term::Op op = terms_[at].op;
  if (op != Term::Op::leaf && op != Term::Op::half_space) return {};
  const std::size_t first = op == Term::Op::leaf ? at + 1 : at;
  Told told;
  std::size_t open = 0;
  for (std::size_t i = first; i < at + terms_[at].size; ++i) {
    if (known_[i] == Known::no) return {};
    if (known_[i] == Known::yes) continue;
    told.own.set(literals_[i]);
    told.holds |= implications_.by(literals_[i]);
    told.fails = implications_.by(literals_[i] ^ std::uint8_t{1});
    ++open;
  }
  if (open != 1) told.fails.reset();
  return told;
}

}  // namespace csgcast::detail
