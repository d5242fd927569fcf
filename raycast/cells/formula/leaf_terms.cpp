// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/leaf_terms.h"

#include <algorithm>

#include "csg/base/precondition.h"
#include "raycast/scene/leaf_function.h"

namespace csgcast::detail {
namespace {

// A box that is all of space.
class Everywhere final : public LeafBox {
 public:
  Box in_scene() const override { return Box::everything(); }
  Sides sides_of(SurfaceId /*id*/) override { return Sides::both; }
};

Term side_term(const HalfSpace& half_space, bool is_contrary) {
  const bool wants_positive = (half_space.sense == Sense::positive) != is_contrary;
  return {1, 2 * half_space.surface.index() + (wants_positive ? 1u : 0u), Term::Op::half_space};
}

// Lays out the formula of one leaf.
class LeafLayout {
 public:
  LeafLayout(std::span<const HalfSpace> half_spaces, LeafId leaf, std::span<const TruthTerm> formula,
             std::vector<Term>& terms)
      : half_spaces_(half_spaces), leaf_(leaf), formula_(formula), terms_(terms) {}

  void run() {
    for (std::size_t i = 0; i < formula_.size();) {
      close_until(i);
      const TruthTerm& term = formula_[i];
      if (term.op == TruthTerm::Op::intersect) {
        i = open_intersection(i);
      } else if (term.op == TruthTerm::Op::unite) {
        open(Term::Op::unite, i);
        ++i;
      } else {
        // The conditions of an intersection are in its conjunction already.
        if (open_.empty() || open_.back().op == Term::Op::unite) {
          conjunction_ = {side_term(half_spaces_[term.condition], term.is_contrary)};
          append_conjunction();
        }
        ++i;
      }
    }
    close_until(formula_.size());
  }

 private:
  struct Open {
    std::size_t end;    // the end of the operator's operands in the truth formula
    std::size_t start;  // the start of the operator's term in the result
    Term::Op op;
  };

  // Joins the conditions of an intersection in one conjunction. The intersection gets no operator of its own if it
  // consists of conditions only.
  std::size_t open_intersection(std::size_t at) {
    const std::size_t end = at + formula_[at].size;
    conjunction_.clear();
    bool is_all = true;
    for (std::size_t k = at + 1; k < end; k += formula_[k].size) {
      const TruthTerm& operand = formula_[k];
      if (operand.op == TruthTerm::Op::condition) {
        conjunction_.push_back(side_term(half_spaces_[operand.condition], operand.is_contrary));
      } else {
        is_all = false;
      }
    }
    if (is_all && !conjunction_.empty()) {
      append_conjunction();
      return end;
    }
    open(Term::Op::intersect, at);
    if (!conjunction_.empty()) append_conjunction();
    return at + 1;
  }

  // A conjunction has no surface twice. If it has both sides of a surface, it holds nothing.
  void append_conjunction() {
    std::sort(conjunction_.begin(), conjunction_.end(), [](const Term& a, const Term& b) { return a.what < b.what; });
    conjunction_.erase(std::unique(conjunction_.begin(), conjunction_.end(),
                                   [](const Term& a, const Term& b) { return a.what == b.what; }),
                       conjunction_.end());
    const auto both = std::adjacent_find(conjunction_.begin(), conjunction_.end(),
                                         [](const Term& a, const Term& b) { return a.surface() == b.surface(); });
    if (both != conjunction_.end()) {
      terms_.push_back({1, 0, Term::Op::unite});
      return;
    }
    terms_.push_back({static_cast<std::uint32_t>(conjunction_.size()) + 1, leaf_.index(), Term::Op::leaf});
    terms_.insert(terms_.end(), conjunction_.begin(), conjunction_.end());
  }

  void open(Term::Op op, std::size_t at) {
    open_.push_back({at + formula_[at].size, terms_.size(), op});
    terms_.push_back({1, 0, op});
  }
  void close_until(std::size_t at) {
    while (!open_.empty() && open_.back().end <= at) {
      const std::size_t start = open_.back().start;
      terms_[start].size = static_cast<std::uint32_t>(terms_.size() - start);
      open_.pop_back();
    }
  }

  std::span<const HalfSpace> half_spaces_;
  LeafId leaf_;
  std::span<const TruthTerm> formula_;
  std::vector<Term>& terms_;
  std::vector<Term> conjunction_;
  std::vector<Open> open_;
};

}  // namespace

SurfaceId literal_of(const Scene& scene, LeafId leaf) {
  const auto all = scene.function_leaves();
  const auto at = std::lower_bound(all.begin(), all.end(), leaf);
  CSGCAST_PRECONDITION(at != all.end() && *at == leaf);
  return SurfaceId(static_cast<std::uint32_t>(scene.surfaces().size() + static_cast<std::size_t>(at - all.begin())));
}

void append_leaf(const Scene& scene, LeafId id, std::vector<Term>& terms) {
  const Leaf& leaf = scene.leaf(id);
  const auto half_spaces = scene.half_spaces(leaf);
  if (leaf.function == nullptr) {
    terms.push_back({static_cast<std::uint32_t>(half_spaces.size()) + 1, id.index(), Term::Op::leaf});
    for (const HalfSpace& half_space : half_spaces) terms.push_back(side_term(half_space, false));
    return;
  }
  Everywhere everywhere;
  TruthFormula formula;
  switch (leaf.function->in_box(half_spaces, everywhere, formula)) {
    case LeafFunction::Content::empty:
      return terms.push_back({1, 0, Term::Op::unite});
    case LeafFunction::Content::full:
      return terms.push_back({1, 0, Term::Op::intersect});
    case LeafFunction::Content::terms:
      return append_leaf_terms(scene, id, formula, terms);
    case LeafFunction::Content::open:
      terms.push_back({2, id.index(), Term::Op::leaf});
      terms.push_back({1, 2 * literal_of(scene, id).index() + 1, Term::Op::half_space});
  }
}

void append_leaf_terms(const Scene& scene, LeafId leaf, std::span<const TruthTerm> formula, std::vector<Term>& terms) {
  LeafLayout(scene.half_spaces(scene.leaf(leaf)), leaf, formula, terms).run();
}

}  // namespace csgcast::detail
