// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "csg/exact/other_form.h"
#include "csg/exact/quadric_form.h"
#include "csg/solid/solid.h"
#include "raycast/scene/leaf_function.h"
#include "raycast/scene/scene.h"
#include "raycast/surface/kinds.h"

namespace csgcast::test {

// What the engine knows nothing of, planted where a new kind of surface or of leaf goes.

/// The product of three planes' forms: a line meets it up to three times.
class ThreePlanes final : public OtherForm {
 public:
  explicit ThreePlanes(std::array<QuadricForm, 3> planes) : planes_(std::move(planes)) {}

  const std::array<QuadricForm, 3>& planes() const { return planes_; }

  std::shared_ptr<const OtherForm> moved(const ExactAffine& world_from_solid) const override;
  Canonical canonical() const override;
  bool equals(const OtherForm& other) const override;
  std::uint64_t hash() const override;

 private:
  std::array<QuadricForm, 3> planes_;
};

/// The engine's kinds, and that of three planes.
SurfaceKinds planted_kinds();

/// The part of the unit cube where (x - a)(y - b)(z - c) <= 0: four of the eight boxes that the planes cut it into.
Solid cut_cube(double a, double b, double c);
/// The same as a tree of boxes.
Solid cut_cube_of_boxes(double a, double b, double c);

/// An L, 2 by 2 with arms 1 wide: one leaf, a truth function of six planes. It goes on without end along z, or is 1
/// high if it is capped: two planes more. The one is told as an intersection with a union in it, the other as a union.
Solid l_prism(bool is_capped);
/// The same as a union of two boxes.
Solid l_prism_of_boxes();
/// Whether a place is in the L, by which of its half-spaces hold.
bool in_l_prism(const std::vector<bool>& holds);

/// What a leaf with a hierarchy of its own may be: it tells nothing in large boxes. In others it tells as much as the
/// leaf that it is made from, or only what is empty and full.
class Reluctant final : public LeafFunction {
 public:
  Reluctant(std::shared_ptr<const LeafFunction> inner, double largest, bool tells_terms)
      : inner_(std::move(inner)), largest_(largest), tells_terms_(tells_terms) {}

  Truth value(std::span<const Truth> holds) const override { return inner_->value(holds); }
  void intervals(std::span<const HalfSpace> half_spaces, LeafLine& line, Span reach, IntervalList& list,
                 std::vector<IntervalList>& scratch) const override {
    inner_->intervals(half_spaces, line, reach, list, scratch);
  }
  Content in_box(std::span<const HalfSpace> half_spaces, LeafBox& box, TruthFormula& terms) const override;

 private:
  std::shared_ptr<const LeafFunction> inner_;
  double largest_;
  bool tells_terms_;
};

/// A scene whose leaves with functions are reluctant.
Scene with_reluctant_leaves(const Scene& scene, double largest, bool tells_terms);

}  // namespace csgcast::test
