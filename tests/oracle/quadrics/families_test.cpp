// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tests/oracle/quadrics/examination.h"
#include "tests/oracle/quadrics/example_scenes.h"
#include "tests/oracle/quadrics/tie_families.h"
#include "tests/support/catch.h"

namespace csgcast::oracle::quadrics {
namespace {

Tally require_agreement(const stress::Family& family, std::uint64_t rays = rays_a_family()) {
  const Tally tally = check_family(family, rays);
  fmt::print("{}\n", summary(family.name, tally));
  for (const std::string& complaint : tally.complaints) UNSCOPED_INFO(complaint);
  CHECK(tally.wrong == 0);
  CHECK(tally.rays >= rays);
  CHECK(tally.ends > rays / 20);
  return tally;
}

TEST_CASE("every stress family gives the lists of the definition in CGAL's exact numbers") {
  for (const stress::Family& family : stress::families()) {
    DYNAMIC_SECTION(family.name) { require_agreement(family); }
  }
}

TEST_CASE("every example scene gives the lists of the definition in CGAL's exact numbers") {
  for (const stress::Family& scene : example_scenes()) {
    DYNAMIC_SECTION(scene.name) { require_agreement(scene, rays_a_family() / 4); }
  }
}

TEST_CASE("looks and parts of faces are those of the definition") { require_agreement(looks_and_parts()); }

TEST_CASE("where many surfaces and leaves tie the face is that of the definition, by each of its rules") {
  const Tally tally = require_agreement(surfaces_through_one_point(), 5 * rays_a_family());
  CHECK(tally.ties > tally.rays / 2);
  CHECK(tally.surface_walks > 0);
  CHECK(tally.leaf_walks > 0);
}

}  // namespace
}  // namespace csgcast::oracle::quadrics
