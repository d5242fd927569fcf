// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "csg/base/digits.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// The digits that the settings of a document give. Nothing if there are none, or no valid ones.
std::optional<Digits> digits_given(const Document& document);

/// What the numbers of a document's solids and transforms show: the most digits that one of them has, if these are
/// Digits::fewest_shown to Digits::most_rounded; else doubles.
Digits digits_shown(const Document& document);

/// Whether a number may stand for digits.
bool is_digit_count(double number);

}  // namespace csgcast::text
