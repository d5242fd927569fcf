// SPDX-License-Identifier: MIT
#include "csg/base/precondition.h"

#include "csg/exact/quadric_form.h"
#include "csg/solid/primitives.h"
#include "tests/support/catch.h"
#include "tests/support/death.h"

namespace {

using namespace csgcast;

int evaluations = 0;

bool counted(bool condition) {
  ++evaluations;
  return condition;
}

void call_with([[maybe_unused]] bool condition) { CSGCAST_PRECONDITION(counted(condition)); }

}  // namespace

TEST_CASE("a broken promise is printed with its place before the process aborts") {
  const auto ending = test::ending_of([] { precondition_failed("x > 0", "folder/file.cpp", 12, "work"); });
  CHECK(ending.aborted);
  CHECK(ending.printed == "folder/file.cpp:12: work: precondition failed: x > 0\n");
}

#if defined(CSGCAST_CHECK_PRECONDITIONS)

TEST_CASE("preconditions are checked: those that hold cost nothing else, others abort") {
  evaluations = 0;
  call_with(true);
  CHECK(evaluations == 1);
  const auto ending = test::ending_of([] { call_with(false); });
  CHECK(ending.aborted);
  CHECK(ending.printed.find("precondition_test.cpp:") != std::string::npos);
  CHECK(ending.printed.find(": call_with: precondition failed: counted(condition)\n") != std::string::npos);
}

TEST_CASE("the library's own preconditions are checked") {
  CHECK(test::ending_of([] { static_cast<void>(sphere(1).transform()); }).aborted);
  CHECK(test::ending_of([] { static_cast<void>(canonical(QuadricForm())); }).aborted);
  CHECK_FALSE(test::ending_of([] { static_cast<void>(sphere(1).shape()); }).aborted);
}

#else

TEST_CASE("preconditions are off: they are not evaluated") {
  evaluations = 0;
  call_with(false);
  call_with(true);
  CHECK(evaluations == 0);
}

#endif
