// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csg/solid/look.h"
#include "csg/solid/solid.h"
#include "tests/oracle/quadrics/form.h"

namespace csgcast::oracle::quadrics {

/// A half-space as it stands in one leaf.
struct Copy {
  std::size_t surface;
  std::size_t leaf;
  bool positive;  ///< where the surface's normalised form is positive, or where it is negative
};

/// One leaf where it stands in the tree.
struct FormulaLeaf {
  std::size_t first = 0;  ///< of its copies
  std::size_t end = 0;
  std::string part;         ///< the name of the part it is in, or empty
  Material look;            ///< what the look statements above it say
  bool subtracted = false;  ///< some subtraction or complement is above it
  bool shows_cut = false;   ///< an odd number of them, and no look statement below the outermost
};

/// A solid as the definition takes it: a Boolean formula over half-spaces of the world, leaf by leaf in file order.
/// Made straight from the solid's tree by rational arithmetic.
class Formula {
 public:
  /// Which copies hold, in the order of copies().
  using State = std::vector<bool>;

  explicit Formula(const Solid& solid);

  /// Normalised, each once, in the order in which the tree brings them.
  const std::vector<RationalForm>& surfaces() const { return surfaces_; }
  /// In file order.
  const std::vector<FormulaLeaf>& leaves() const { return leaves_; }
  /// Leaf by leaf.
  const std::vector<Copy>& copies() const { return copies_; }
  /// True if nothing in the tree is empty or everything by itself, so that no leaf goes for such a reason.
  bool has_no_constants() const { return has_no_constants_; }

  /// What the tree is in a state.
  bool value(const State& state) const { return values(state).front(); }
  /// The first leaf that nothing subtracts and that holds in a state together with all operators above it.
  std::optional<std::size_t> first_holder(const State& state) const;
  /// The state with every copy of a surface turned round.
  State flipped(State state, std::size_t surface) const;
  /// The state with the copies in one leaf turned round.
  State flipped(State state, std::size_t surface, std::size_t leaf) const;

 private:
  // Parents come before their children, so one pass from the back evaluates the tree.
  struct FormulaNode {
    Solid::Kind kind;
    std::size_t parent;
    bool is_first_child;
    std::size_t leaf;
  };
  struct Visit;

  bool holds(const FormulaLeaf& leaf, const State& state) const;
  std::vector<bool> values(const State& state) const;  // of every node
  static Visit below(const Visit& visit, std::size_t child, std::size_t node);
  void add_leaf(const Visit& visit);
  std::size_t index_of(const RationalForm& normalised);

  std::vector<FormulaNode> nodes_;
  std::vector<FormulaLeaf> leaves_;
  std::vector<Copy> copies_;
  std::vector<RationalForm> surfaces_;
  std::map<RationalForm, std::size_t> index_;
  bool has_no_constants_ = true;
};

/// The same tree, each leaf's place naming it: line 1 + its index in file order.
Solid with_numbered_leaves(const Solid& solid);

}  // namespace csgcast::oracle::quadrics
