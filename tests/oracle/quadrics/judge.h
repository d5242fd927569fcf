// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raycast/ray/caster.h"
#include "tests/oracle/quadrics/definition.h"

namespace csgcast::oracle::quadrics {

/// What the product says of one end, as data: a test may change it to see whether the judge notices.
struct FoundEnd {
  Crossing crossing;
  std::optional<Attribution> attribution;  ///< none without a surface
};

struct FoundInterval {
  FoundEnd entry;
  FoundEnd exit;
};

using FoundList = std::vector<FoundInterval>;

/// The product's list on the caster's present ray, with every end attributed.
FoundList found_list(Caster& caster, Span span);

/// Says how a list differs from the definition's, or nothing if it agrees: as many intervals, ends made by the same
/// surface and leaf with the same look, part and side, and each t the double nearest to the exact root.
std::string difference(const Subject& subject, const FoundList& found, const DefinedList& expected);
/// The same for the first end that a surface makes.
std::string difference(const Subject& subject, const std::optional<Hit>& found, const DefinedList& expected);
/// How the list of the reversed ray is not the mirror image of the ray's own, along the whole line; or nothing.
std::string difference_of_mirrored(const FoundList& forward, const FoundList& backward);

/// Both lists for a reader; hexadecimal.
std::string to_text(const FoundList& list);
std::string to_text(const Subject& subject, const DefinedList& list);

}  // namespace csgcast::oracle::quadrics
