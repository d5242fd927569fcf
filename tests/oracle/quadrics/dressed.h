// SPDX-License-Identifier: MIT
#pragma once

#include "tests/stress/families.h"

namespace csgcast::oracle::quadrics {

/// Unions of named parts, each a tree of boxes on the grid and random leaves under look statements here and there, also
/// within what is subtracted; so faces coincide, and whose they are is seen by their looks.
stress::Family dressed_solids();

}  // namespace csgcast::oracle::quadrics
