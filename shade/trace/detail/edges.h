// SPDX-License-Identifier: MIT
#pragma once

#include "csg/solid/look.h"
#include "shade/trace/detail/sight.h"

namespace csgcast::detail {

/// Whether a line is drawn between two places of a picture: one shows something and the other does not, or they show
/// different surfaces, parts or looks, or one surface twice, one fold of it before another. Faces of touching solids
/// that lie in one plane have no line between them.
///
/// `spacing` is the distance of the two rays at the nearer place.
bool is_edge(const Sight& a, const Sight& b, double spacing);

/// The paper under the lines: white, with a pale tint of the colour that falls off towards silhouettes.
Rgb paper(const Sight& sight, Rgb color);

}  // namespace csgcast::detail
