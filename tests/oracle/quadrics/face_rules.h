// SPDX-License-Identifier: MIT
#pragma once

#include "tests/oracle/quadrics/definition.h"

namespace csgcast::oracle::quadrics {

/// Whose face an end is, where the formula's value differs before and after a group of crossings. `group`: the surfaces
/// in it, ascending by the product's id.
Face face_at(const Subject& subject, const Formula::State& before, const std::vector<std::size_t>& group);

}  // namespace csgcast::oracle::quadrics
