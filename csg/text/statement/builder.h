// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/scene_description.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// Which curved solids become polyhedra.
enum class Facets {
  automatic,  ///< those with an explicit 0 < $fn <= 16
  always,     ///< all, with OpenSCAD's vertices
  never,
};

struct BuildOptions {
  Facets facets = Facets::automatic;
};

/// What the statements mean; each is given up once it is built, so a document that is moved here and the solids take
/// little more memory than one of them. Throws Error naming the first (in file order) statement that is unknown,
/// wrongly used or not supported yet, with its place.
SceneDescription build(Document document, const BuildOptions& options = {});

}  // namespace csgcast::text
