// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "csg/base/precondition.h"
#include "csg/base/truth.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// One entry of a formula: a half-space, a leaf followed by its half-spaces, or an operator followed by its operands.
struct Term {
  enum class Op : std::uint8_t { unite, intersect, subtract, complement, leaf, half_space };

  std::uint32_t size = 1;  ///< the number of entries of the term: itself and its operands
  /// For a leaf, its LeafId. For a half-space, twice its SurfaceId, or twice the number of a leaf's own literal
  /// (leaf_terms.h), plus 1 for the positive side.
  std::uint32_t what = 0;
  Op op = Op::unite;
  bool is_wider = false;  ///< true if the leaf lacks half-spaces that matter to it, but not to the formula

  SurfaceId surface() const { return SurfaceId(what >> 1); }
  bool wants_positive() const { return (what & 1) != 0; }
};

/// A scene's tree over half-spaces, as far as it is not constant in some part of space. Terms are in prefix order. A
/// leaf's term is the conjunction of its half-spaces. A leaf that is not a conjunction has several terms. A formula
/// without terms is the constant `value`.
struct Formula {
  std::vector<Term> terms;
  bool value = false;

  bool is_constant() const { return terms.empty(); }
};

/// The whole tree below a node.
Formula formula_of(const Scene& scene, NodeId node);
/// The tree below a node, less the trees below other nodes.
Formula formula_of_difference(const Scene& scene, NodeId node, std::span<const NodeId> less);
/// The intersection of the trees below two nodes.
Formula formula_of_common(const Scene& scene, NodeId a, NodeId b);
/// The space in which the tree below a root would have another value if one of its nodes were empty, or everything. The
/// result is correct in the box `near` only: nodes that do not meet the box are taken to be empty. Returns nothing if
/// the tree still takes more than `most_terms` terms.
std::optional<Formula> formula_of_effect(const Scene& scene, NodeId root, NodeId node, bool as_everything,
                                         const Box& near, std::size_t most_terms);

/// The value of a half-space where a formula is folded.
struct FoldedTerm {
  Truth value;
  /// The terms that replace it, and the leaf that consists of it only, if the value is unknown. If there are none, it
  /// stays.
  std::span<const Term> instead{};
};

/// Rewrites a formula, given what is known of its leaves and half-spaces. The result is equivalent in every state of
/// the surfaces that stay open. It takes one pass over the terms, with a stack of its own, because trees may be a
/// million deep. The object keeps its memory.
class Folder {
 public:
  /// `leaf(term)` returns a Truth, `half_space(term)` a Truth or a FoldedTerm. The half-spaces of a leaf are asked for,
  /// unless the leaf is known to hold nothing. Precondition: `from` and `result` are different formulas.
  template <class LeafKnown, class HalfSpaceKnown>
  void fold(const Formula& from, Formula& result, LeafKnown&& leaf, HalfSpaceKnown&& half_space) {
    begin(from, result);
    while (at_ < from.terms.size() && !done_) {
      const Term& term = from.terms[at_];
      const bool is_leaf = term.op == Term::Op::leaf;
      if (is_leaf && leaf(term) == Truth::no) {
        at_ += term.size;
        settle(false);
      } else if (term.op == Term::Op::half_space || (is_leaf && term.size == 2)) {
        // The term is a half-space, or a leaf with a single half-space.
        const std::span<const Term> whole(&term, term.size);
        at_ += term.size;
        if constexpr (std::is_same_v<decltype(half_space(term)), Truth>) {
          deliver(half_space(whole.back()), whole);
        } else {
          const FoldedTerm folded = half_space(whole.back());
          deliver(folded.value, folded.instead.empty() ? whole : folded.instead);
        }
      } else {
        open(term);
      }
      close_finished();
    }
  }

 private:
  struct Operator {
    std::uint32_t end;    // index after its last operand, in the old formula
    std::uint32_t start;  // index of its term in the new formula
    std::uint32_t kept;   // number of operands that stay
    std::uint32_t seen;   // number of operands so far
    Term::Op op;
    bool is_merged;  // true if it has no term of its own, because the operator above is the same
  };

  void begin(const Formula& from, Formula& result);
  void open(const Term& term);
  void deliver(Truth value, std::span<const Term> operand);
  void keep();
  void settle(bool value);
  void close_finished();
  void close(const Operator& top);

  Formula* result_ = nullptr;
  std::vector<Operator> open_;
  std::size_t at_ = 0;
  bool done_ = false;
};

/// Computes the value of a formula, given `half_space(term)` for each half-space: 64 truth values side by side in a
/// word. The object keeps its memory. Precondition: the formula is not constant.
class FormulaValue {
 public:
  template <class HalfSpaceWord>
  std::uint64_t operator()(std::span<const Term> terms, HalfSpaceWord&& half_space) {
    CSGCAST_PRECONDITION(!terms.empty());
    open_.clear();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const Term& term = terms[i];
      if (term.op != Term::Op::half_space) {
        open_.push_back({i + term.size, 0, 0, term.op});
        continue;
      }
      std::uint64_t word = half_space(term);
      std::size_t end = i + 1;
      while (!open_.empty()) {
        Operator& top = open_.back();
        add(top, word);
        if (top.end != end) break;
        word = top.word;
        open_.pop_back();
        if (open_.empty()) return word;
      }
      if (open_.empty()) return word;
    }
    return 0;
  }

 private:
  struct Operator {
    std::size_t end;
    std::uint32_t seen;
    std::uint64_t word;
    Term::Op op;
  };
  static void add(Operator& top, std::uint64_t word) {
    const bool first = top.seen++ == 0;
    switch (top.op) {
      case Term::Op::unite:
        top.word = first ? word : top.word | word;
        break;
      case Term::Op::subtract:
        top.word = first ? word : top.word & ~word;
        break;
      case Term::Op::complement:
        top.word = ~word;
        break;
      default:
        top.word = first ? word : top.word & word;
    }
  }

  std::vector<Operator> open_;
};

}  // namespace csgcast::detail
