// SPDX-License-Identifier: MIT
#include "raycast/packets/threads.h"

#include <tbb/task_arena.h>

#include <set>
#include <stdexcept>
#include <thread>

#include "tests/contracts/calls.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;

/// The threads that a call tells its progress from.
struct Callers {
  std::set<std::thread::id> ids;

  ProgressCallback note() {
    return [this](const Progress&) {
      ids.insert(std::this_thread::get_id());
      return true;
    };
  }
};

const std::set<std::thread::id> here{std::this_thread::get_id()};

}  // namespace

TEST_CASE("every call that takes long works on the threads of its arena, and says the same on any number") {
  for (const test::LongCall& call : test::long_calls()) {
    INFO(call.name);
    const std::string expected = call.run({});
    Callers alone;
    CHECK((tbb::task_arena(1).execute([&] { return call.run(alone.note()); }) == expected));
    CHECK((alone.ids == here));
    for (const int threads : {1, 2, 7}) {
      Callers callers;
      std::string told;
      on_threads(threads, [&] { told = call.run(callers.note()); });
      CHECK((told == expected));
      CHECK(callers.ids.size() <= static_cast<std::size_t>(threads));
      if (threads == 1) CHECK((callers.ids == here));
    }
  }
}

TEST_CASE("the option threads is an arena of its own, or with 0 the present one") {
  for (const test::CallOnThreads& call : test::calls_with_threads()) {
    INFO(call.name);
    const std::string expected = call.run(0, {});
    for (const int threads : {1, 2, 5}) {
      Callers callers;
      CHECK((call.run(threads, callers.note()) == expected));
      CHECK(callers.ids.size() <= static_cast<std::size_t>(threads));
    }
    Callers alone;
    CHECK((tbb::task_arena(1).execute([&] { return call.run(0, alone.note()); }) == expected));
    CHECK((alone.ids == here));
  }
}

TEST_CASE("work on threads sees their number, and what it throws comes back") {
  const int before = thread_count();
  for (const int threads : {1, 3, 40}) {
    int seen = 0;
    on_threads(threads, [&] { seen = thread_count(); });
    CHECK(seen == threads);
  }
  on_threads(0, [&] { CHECK(thread_count() == before); });
  CHECK(thread_count() == before);
  CHECK_THROWS_WITH(on_threads(2, [] { throw std::runtime_error("no more"); }), "no more");
}
