// SPDX-License-Identifier: MIT
#include "csg/base/shared.h"

#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/catch.h"

using csgcast::Counted;
using csgcast::Shared;

namespace {

struct Value : Counted {
  int number = 1;
};

/// Tells when it is deleted.
struct Marked : Value {
  explicit Marked(int& deleted) : deleted_(deleted) {}
  ~Marked() override { ++deleted_; }

 private:
  int& deleted_;
};

}  // namespace

TEST_CASE("the last owner deletes a shared value, as what it was made") {
  int deleted = 0;
  Shared<Value> first = Shared<Value>::make<Marked>(deleted);
  {
    const Shared<Value> second = first;
    CHECK(second == first);
    CHECK(second->number == 1);
  }
  CHECK(deleted == 0);
  Shared<Value> third = std::move(first);
  CHECK_FALSE(first);  // NOLINT(bugprone-use-after-move): an owner of none is what is left
  CHECK(deleted == 0);
  third = Shared<Value>();
  CHECK(deleted == 1);
}

TEST_CASE("a shared value is assigned to its own owner") {
  int deleted = 0;
  Shared<Value> owner = Shared<Value>::make<Marked>(deleted);
  const Shared<Value>& same = owner;
  owner = same;
  CHECK(deleted == 0);
  CHECK(owner->number == 1);
}

TEST_CASE("only a single owner may change a shared value") {
  CHECK(Shared<Value>().if_only_owner() == nullptr);
  const Shared<Value> first = Shared<Value>::make();
  REQUIRE(first.if_only_owner() != nullptr);
  first.if_only_owner()->number = 2;
  CHECK(first->number == 2);
  const Shared<Value> second = first;
  CHECK(first.if_only_owner() == nullptr);
  CHECK(second.if_only_owner() == nullptr);
}

TEST_CASE("threads copy and drop owners of a shared value side by side") {
  int deleted = 0;
  Shared<Value> value = Shared<Value>::make<Marked>(deleted);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([own = value] {
      for (int k = 0; k < 100'000; ++k) {
        const Shared<Value> copy = own;
        if (copy.if_only_owner() != nullptr) std::terminate();  // `own` is another owner
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  threads.clear();
  CHECK(value.if_only_owner() != nullptr);
  CHECK(deleted == 0);
  value = Shared<Value>();
  CHECK(deleted == 1);
}
