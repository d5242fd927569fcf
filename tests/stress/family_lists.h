// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/stress/families.h"

namespace csgcast::stress {

// The families by what makes them hard; families() is all of these.

/// Rays through the edges, vertices and faces of boxes and other polyhedra, and faces that coincide.
std::vector<Family> box_families();
/// Tangents, generators, apexes, surfaces that touch or nearly do.
std::vector<Family> curved_families();
/// Quadrics with coefficients of every kind, degenerate and near-parabolic ones.
std::vector<Family> quadric_families();
/// Places far away, units far from 1, sizes far apart.
std::vector<Family> scale_families();
/// Sizes, distances and coefficients that are up to 2^300 apart.
std::vector<Family> extreme_families();
/// Trees: deep, random, and rays bisected onto their edges and silhouettes.
std::vector<Family> tree_families();

}  // namespace csgcast::stress
