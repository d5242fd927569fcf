// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "csg/solid/solid.h"
#include "raycast/scene/scene.h"
#include "tests/oracle/polyhedron.h"

namespace csgcast::oracle {

/// How polyhedra are combined; subtract takes all others from the first. With one operand all three are the operand
/// itself.
enum class Operation { unite, intersect, subtract };

/// The combination of truth values, one an operand.
bool combined(Operation operation, const std::vector<bool>& operands);

/// One solid as the product builds it and as CGAL does.
struct Model {
  Solid solid;
  std::vector<Polyhedron> operands;
  Operation operation = Operation::unite;
};

/// One plane of the model in the sign that the definition gives it, the leading coefficient positive, and its place in
/// the product's surface table.
struct OracleSurface {
  RationalPlane plane;
  SurfaceId id;  ///< not valid if the product has no such surface
};

/// An operand's half-space: where the surface is positive, or where it is negative.
struct OracleHalfSpace {
  std::size_t surface;
  bool positive;
};

/// A model joined with the scene that the product compiled from it: the planes are matched as exact integers, so that
/// answers can be compared by surface.
class Subject {
 public:
  explicit Subject(Model model);

  const Model& model() const { return model_; }
  const Scene& scene() const { return scene_; }
  /// Each once, ascending by id.
  const std::vector<OracleSurface>& surfaces() const { return surfaces_; }
  /// Of each operand, in the order of its planes().
  const std::vector<std::vector<OracleHalfSpace>>& half_spaces() const { return half_spaces_; }
  /// What is wrong with the compiled planes, or empty: every surface of the scene must be a plane of the model, and a
  /// single operand's leaf must have exactly its half-spaces.
  std::string complaint() const;

 private:
  Model model_;
  Scene scene_;
  std::vector<OracleSurface> surfaces_;
  std::vector<std::vector<OracleHalfSpace>> half_spaces_;
};

}  // namespace csgcast::oracle
