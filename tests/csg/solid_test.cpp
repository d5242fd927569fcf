// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>

#include "csg/solid/primitives.h"
#include "tests/support/catch.h"

using namespace csgcast;

TEST_CASE("leaves are counted at each use of a shared node, and no count overflows") {
  CHECK(Solid().leaf_count() == 0);
  CHECK(Solid::everything().leaf_count() == 0);
  CHECK(complement(sphere(1)).leaf_count() == 1);
  Solid doubled = sphere(1);
  for (int i = 0; i < 63; ++i) doubled = doubled - doubled;
  CHECK(doubled.leaf_count() == std::uint64_t{1} << 63);
  CHECK((doubled + sphere(1)).leaf_count() == (std::uint64_t{1} << 63) + 1);
  CHECK((doubled & doubled).leaf_count() == std::numeric_limits<std::uint64_t>::max());
  CHECK((doubled + doubled + doubled).leaf_count() == std::numeric_limits<std::uint64_t>::max());
}
