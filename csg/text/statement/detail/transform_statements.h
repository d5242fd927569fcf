// SPDX-License-Identifier: MIT
#pragma once

#include "csg/text/statement/detail/statements.h"

namespace csgcast::text {

// Transforms move the union of their children. A singular one, or one whose entries overflow, gives the empty solid and
// a warning.

/// Missing rows and columns are the identity's; all is divided by m[3][3]; the rest of the last row is ignored with a
/// warning.
Combine make_multmatrix(const Call& call);
Combine make_translate(const Call& call);
Combine make_rotate(const Call& call);
Combine make_scale(const Call& call);
Combine make_mirror(const Call& call);

}  // namespace csgcast::text
