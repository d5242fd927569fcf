// SPDX-License-Identifier: MIT
#pragma once

#include "csg/text/statement/detail/statements.h"

namespace csgcast::text {

// How operators without a matrix or a look combine their children; union, group and render mean the same.

Combine make_union(const Call& call);
Combine make_render(const Call& call);
Combine make_difference(const Call& call);
Combine make_intersection(const Call& call);
Combine make_complement(const Call& call);
Combine make_part(const Call& call);

}  // namespace csgcast::text
