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
  bool skips_unsupported = false;  ///< statements of OpenSCAD that have no solid here yet are left out, with a warning
};

/// Whether a statement is OpenSCAD's, and has no solid here yet.
bool is_unsupported(const Node& statement);

/// What the statements mean; each is given up once it is built, so a document that is moved here and the solids take
/// little more memory than one of them. Throws Error naming the first (in file order) statement that is unknown,
/// wrongly used or not supported yet, with its place; the message about the last tells how many more there are.
SceneDescription build(Document document, const BuildOptions& options = {});

}  // namespace csgcast::text
