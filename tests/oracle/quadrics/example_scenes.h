// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/stress/families.h"

namespace csgcast::oracle::quadrics {

/// The scenes of examples/, by name, each with every kind of ray that `csgcast verify` knows: random ones, through
/// edges and vertices, in faces, grazing, bisected and so on.
std::vector<stress::Family> example_scenes();

}  // namespace csgcast::oracle::quadrics
