// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raycast/scene/scene.h"
#include "tests/oracle/quadrics/formula.h"

namespace csgcast::oracle::quadrics {

/// A solid as the definition takes it, joined with the scene that the product compiled from it: surfaces are matched
/// as exact integers and leaves by their number in the file, so that answers can be compared.
class Subject {
 public:
  explicit Subject(const Solid& solid) : Subject(solid, solid) {}
  /// The product is given another solid: only a test of the oracle itself wants that.
  Subject(const Solid& defined, const Solid& compiled);

  const Formula& formula() const { return formula_; }
  const Scene& scene() const { return scene_; }
  /// The product's id of one of the formula's surfaces; not valid if it has none.
  SurfaceId surface_id(std::size_t surface) const { return surface_id_[surface]; }
  /// The product's id of one of the formula's leaves; not valid if it left the leaf out.
  LeafId leaf_id(std::size_t leaf) const { return leaf_id_[leaf]; }
  /// What is wrong with the compiled surfaces and leaves, or empty: every surface must be one of the formula's, every
  /// leaf have the half-spaces of the formula's, and ids ascend in file order.
  std::string complaint() const;

 private:
  std::string complaint_about_order() const;
  std::string complaint_about_leaf(std::size_t leaf) const;

  Formula formula_;
  Scene scene_;
  std::vector<SurfaceId> surface_id_;
  std::vector<LeafId> leaf_id_;
  std::size_t matched_surfaces_ = 0;
};

}  // namespace csgcast::oracle::quadrics
