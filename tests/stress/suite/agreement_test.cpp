// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <string_view>

#include "tests/stress/trial_run.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

// CSGCAST_LONG=1 asks for a million rays a family.
std::uint64_t rays_a_family() {
  const char* variable = std::getenv("CSGCAST_LONG");
  return variable != nullptr && std::string_view(variable) == "1" ? 1'000'000 : 2'000;
}

}  // namespace

TEST_CASE("every engine gives the lists of exact arithmetic, surface by surface and bit by bit, in every family") {
  for (const stress::Family& family : stress::families()) {
    const stress::FamilyOutcome outcome = stress::run_family(family, 1, rays_a_family());
    INFO(family.name);
    if (!outcome.differences.empty()) INFO(outcome.differences.front());
    CHECK(outcome.tally.wrong == 0);
    CHECK(outcome.tally.rays >= rays_a_family());
    CHECK(outcome.tally.intervals > outcome.tally.rays / 20);
  }
}

TEST_CASE("families have names of their own, and a seed gives the same trial again") {
  std::set<std::string> names;
  for (const stress::Family& family : stress::families()) {
    INFO(family.name);
    CHECK(names.insert(family.name).second);
    CHECK(stress::run_family(family, 7, 50).tally == stress::run_family(family, 7, 50).tally);
  }
}
