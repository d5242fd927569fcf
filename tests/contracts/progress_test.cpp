// SPDX-License-Identifier: MIT
#include "csg/base/progress.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "raycast/packets/threads.h"
#include "tests/contracts/calls.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;

struct Enough : std::runtime_error {
  Enough() : std::runtime_error("enough") {}
};

/// Calls back as often as `most` times; then it does `end()`.
struct Counter {
  int most = 0;
  std::atomic<int> calls = 0;

  template <class End>
  ProgressCallback then(End&& end) {
    return [this, end](const Progress&) { return ++calls < most || end(); };
  }
};

}  // namespace

TEST_CASE("every call that takes long tells how far it is: ascending to 1, one thread at a time") {
  for (const test::LongCall& call : test::long_calls()) {
    for (const int threads : {1, 4}) {
      INFO(call.name << " on " << threads << " threads");
      std::vector<double> shares;
      std::atomic<int> at_once = 0;
      bool is_alone = true;
      const ProgressCallback progress = [&](const Progress& now) {
        is_alone = is_alone && ++at_once == 1;
        shares.push_back(now.share);
        std::this_thread::yield();
        --at_once;
        return true;
      };
      std::string told;
      on_threads(threads, [&] { told = call.run(progress); });
      CHECK(is_alone);
      REQUIRE(shares.size() >= 2);
      CHECK(shares.front() >= 0);
      CHECK(shares.front() < 1);
      CHECK(std::is_sorted(shares.begin(), shares.end()));
      CHECK(shares.back() == 1);
      CHECK((told == call.run({})));
    }
  }
}

TEST_CASE("every call that takes long is cancelled by a callback that returns false, and asks no more") {
  for (const test::LongCall& call : test::long_calls()) {
    const std::string expected = call.run({});
    for (const int most : {1, 2}) {
      for (const int threads : {1, 4}) {
        INFO(call.name << " at call " << most << " on " << threads << " threads");
        Counter counter{most};
        on_threads(threads, [&] { CHECK_THROWS_AS(call.run(counter.then([] { return false; })), Cancelled); });
        CHECK(counter.calls == most);
        Counter thrower{most};
        on_threads(threads, [&] { CHECK_THROWS_AS(call.run(thrower.then([]() -> bool { throw Enough(); })), Enough); });
        CHECK(thrower.calls == most);
      }
    }
    CHECK((call.run({}) == expected));
  }
}

TEST_CASE("a callback may itself call what takes long") {
  const std::vector<test::LongCall> calls = test::long_calls();
  const test::LongCall& inner = calls.front();
  const std::string expected = inner.run({});
  for (const test::LongCall& call : calls) {
    INFO(call.name);
    int rest = 3;
    bool is_right = true;
    call.run([&](const Progress&) {
      if (rest-- > 0) is_right = is_right && inner.run({}) == expected;
      return true;
    });
    CHECK(is_right);
    CHECK(rest < 3);
  }
}
