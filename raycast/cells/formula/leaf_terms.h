// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csg/base/truth_formula.h"
#include "raycast/cells/formula/formula.h"

namespace csgcast::detail {

// A leaf with a LeafFunction has several terms in a formula, each of which is a conjunction of half-spaces. If the leaf
// is open, it has one term, whose only entry is the leaf's own literal. The literals of leaves are numbered behind the
// surfaces. The positive side of a leaf's literal is the inside of the leaf.

/// The number of literals of a scene: its surfaces, and its leaves with a function.
inline std::size_t literal_count(const Scene& scene) {
  return scene.surfaces().size() + scene.function_leaves().size();
}
/// The literal of a leaf. Precondition: the leaf has a function.
SurfaceId literal_of(const Scene& scene, LeafId leaf);
/// The leaf that a literal belongs to. It is not valid if the literal is a surface.
inline LeafId leaf_of(const Scene& scene, SurfaceId literal) {
  const std::size_t surfaces = scene.surfaces().size();
  return literal.index() < surfaces ? LeafId() : scene.function_leaves()[literal.index() - surfaces];
}

/// Appends the terms of any leaf, conjunction or not.
void append_leaf(const Scene& scene, LeafId leaf, std::vector<Term>& terms);
/// Appends the terms of a truth formula of a leaf's half-spaces: operators over conjunctions. An operator without
/// operands stands for a constant.
void append_leaf_terms(const Scene& scene, LeafId leaf, std::span<const TruthTerm> formula, std::vector<Term>& terms);

}  // namespace csgcast::detail
