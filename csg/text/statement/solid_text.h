// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/solid.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// A solid as statements of the scene text, for write(). Built again without facets (Facets::never) it is a solid of
/// the same exact surfaces in the same tree, with the same parts and looks; colours that sRGB cannot say are an ulp
/// off. What is known of its numbers goes along: settings say how many digits they have if these are few, or look so.
/// If solids differ in that, the fewest digits are written.
///
/// The statements bear the places of their nodes, those in the file of the first that has one; the document is named
/// after that. Shared nodes are written as often as they are used. Throws Error(limit) for more than 4,194,304
/// statements, Error(unsupported) for a leaf whose forms are no doubles: none that the functions of
/// csg/solid/primitives.h make.
Document document_of(const Solid& solid);

}  // namespace csgcast::text
