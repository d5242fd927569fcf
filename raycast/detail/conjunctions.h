// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "raycast/detail/cell_builder.h"

namespace csgcast::detail {

/// Takes a formula apart into a union of conjunctions less others.
class Conjunctions {
 public:
  Conjunctions(const CellGround& ground, const CellBox& everything) : ground_(ground), everything_(everything) {}

  /// False if the formula is not like that.
  bool read(const Formula& formula, BoxTree& tree);
  const std::vector<CellBox>& boxes() const { return boxes_; }
  // By side.
  struct Owner {
    SurfaceId surface;
    LeafId leaf;
    bool is_one = true;  // no other leaf of the conjunction has the surface
  };
  const std::vector<Owner>& owners() const { return owners_; }

 private:
  struct Open {
    std::size_t end;
    Term::Op op;
    bool is_top;  // nothing but differences above, whose first operand it is
    bool is_subtracted;
    bool has_first;
  };

  bool add_leaf(std::span<const Term> leaf, bool joins, bool is_subtracted, BoxTree& tree);

  const CellGround& ground_;
  CellBox everything_;
  std::vector<CellBox> boxes_;
  std::vector<Owner> owners_;
};

}  // namespace csgcast::detail
