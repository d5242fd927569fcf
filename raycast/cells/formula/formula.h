// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/precondition.h"
#include "raycast/scene/scene.h"

namespace csgcast::detail {

/// One entry of a formula: an operator followed by its operands, or a half-space.
struct Term {
  enum class Op : std::uint8_t { unite, intersect, subtract, complement, leaf, half_space };

  std::uint32_t size = 1;  ///< entries of this term, itself included
  std::uint32_t what = 0;  ///< of a leaf its LeafId; of a half-space twice its SurfaceId, plus 1 for the positive side
  Op op = Op::unite;
  bool is_wider = false;  ///< a leaf that lacks half-spaces which matter to it, but not to the formula

  SurfaceId surface() const { return SurfaceId(what >> 1); }
  bool wants_positive() const { return (what & 1) != 0; }
};

/// A scene's tree over half-spaces, as far as it is not constant in some region: terms in prefix order, a leaf standing
/// for the conjunction of its half-spaces. Without terms it is the constant `value`.
struct Formula {
  std::vector<Term> terms;
  bool value = false;

  bool is_constant() const { return terms.empty(); }
};

/// The whole tree below a node.
Formula formula_of(const Scene& scene, NodeId node);
/// The tree below one less those below others.
Formula formula_of_difference(const Scene& scene, NodeId node, std::span<const NodeId> less);
/// What is below both of two.
Formula formula_of_common(const Scene& scene, NodeId a, NodeId b);
/// Where the tree below a root would have another value if one of its nodes were empty, or everything; as far as that
/// depends on what meets the box. Nothing if the tree near there takes more than `most_terms`.
std::optional<Formula> formula_of_effect(const Scene& scene, NodeId root, NodeId node, bool as_everything,
                                         const Box& near, std::size_t most_terms);

/// What is known of a term where a formula is folded.
enum class Known : std::uint8_t { no, yes, open };

/// Rewrites a formula given what is known of its leaves and half-spaces. Equivalent in every state of the surfaces that
/// stay open. One pass over the terms with a stack of its own; trees may be a million deep. Keeps its memory.
class Folder {
 public:
  /// `leaf(term)`: no if the leaf is known to hold nothing; yes or open: ask its half-spaces. `half_space(term)`.
  template <class LeafKnown, class HalfSpaceKnown>
  void fold(const Formula& from, Formula& result, LeafKnown&& leaf, HalfSpaceKnown&& half_space) {
    begin(from, result);
    while (at_ < from.terms.size() && !done_) {
      const Term& term = from.terms[at_];
      const bool is_leaf = term.op == Term::Op::leaf;
      if (is_leaf && leaf(term) == Known::no) {
        at_ += term.size;
        settle(false);
      } else if (term.op == Term::Op::half_space || (is_leaf && term.size == 2)) {
        // A half-space, or a leaf of one.
        const std::span<const Term> whole(&term, term.size);
        at_ += term.size;
        deliver(half_space(whole.back()), whole);
      } else {
        open(term);
      }
      close_finished();
    }
  }

 private:
  struct Frame {
    std::uint32_t end;    // where its operands end in the old formula
    std::uint32_t start;  // where it starts in the new one
    std::uint32_t kept;   // operands that stay
    std::uint32_t seen;   // operands so far
    Term::Op op;
    bool is_merged;  // into the operator above, which is the same: it has no entry of its own
  };

  void begin(const Formula& from, Formula& result);
  void open(const Term& term);
  void deliver(Known value, std::span<const Term> operand);
  void keep();
  void settle(bool value);
  void close_finished();
  void close(const Frame& frame);

  Formula* result_ = nullptr;
  std::vector<Frame> frames_;
  std::size_t at_ = 0;
  bool done_ = false;
};

/// The value of a formula, given that of each half-space (a truth value, or 64 of them in a word). `half_space(term)`.
/// Precondition: not constant.
class FormulaValue {
 public:
  template <class HalfSpaceWord>
  std::uint64_t operator()(std::span<const Term> terms, HalfSpaceWord&& half_space) {
    CSGCAST_PRECONDITION(!terms.empty());
    frames_.clear();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const Term& term = terms[i];
      if (term.op != Term::Op::half_space) {
        frames_.push_back({i + term.size, 0, 0, term.op});
        continue;
      }
      std::uint64_t word = half_space(term);
      std::size_t end = i + 1;
      while (!frames_.empty()) {
        Frame& frame = frames_.back();
        add(frame, word);
        if (frame.end != end) break;
        word = frame.word;
        frames_.pop_back();
        if (frames_.empty()) return word;
      }
      if (frames_.empty()) return word;
    }
    return 0;
  }

 private:
  struct Frame {
    std::size_t end;
    std::uint32_t seen;
    std::uint64_t word;
    Term::Op op;
  };
  static void add(Frame& frame, std::uint64_t word) {
    const bool first = frame.seen++ == 0;
    switch (frame.op) {
      case Term::Op::unite:
        frame.word = first ? word : frame.word | word;
        break;
      case Term::Op::subtract:
        frame.word = first ? word : frame.word & ~word;
        break;
      case Term::Op::complement:
        frame.word = ~word;
        break;
      default:
        frame.word = first ? word : frame.word & word;
    }
  }

  std::vector<Frame> frames_;
};

}  // namespace csgcast::detail
