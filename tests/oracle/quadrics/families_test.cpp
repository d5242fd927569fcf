// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tests/oracle/quadrics/dressed.h"
#include "tests/oracle/quadrics/examination.h"
#include "tests/support/catch.h"

namespace csgcast::oracle::quadrics {
namespace {

void require_agreement(const stress::Family& family) {
  const std::uint64_t rays = rays_a_family();
  const Tally tally = check_family(family, rays);
  fmt::print("{}\n", summary(family.name, tally));
  for (const std::string& complaint : tally.complaints) UNSCOPED_INFO(complaint);
  INFO(family.name);
  CHECK(tally.wrong == 0);
  CHECK(tally.rays >= rays);
  CHECK(tally.ends > rays / 20);
}

TEST_CASE("every stress family gives the lists of the definition in CGAL's exact numbers") {
  for (const stress::Family& family : stress::families()) require_agreement(family);
}

TEST_CASE("looks and parts of faces are those of the definition") { require_agreement(dressed_solids()); }

}  // namespace
}  // namespace csgcast::oracle::quadrics
