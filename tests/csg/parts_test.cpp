// SPDX-License-Identifier: MIT
#include "csg/solid/parts.h"

#include "csg/solid/primitives.h"
#include "tests/support/catch.h"

using namespace csgcast;
using Kind = Solid::Kind;

namespace {

Solid part(const std::string& name, Solid solid) { return named(std::move(solid), {name, 1}); }

TEST_CASE("parts are named in file order, each once, and only where a scene may have them") {
  const Solid shared = part("s", sphere(1));
  const Solid scene = unite({transformed(part("b", box({1, 1, 1})), translation({1, 0, 0})),
                             part("a", part("inner", sphere(2))), shared, with_look(shared, {}), part("b", sphere(3)),
                             part("cut", sphere(1)) - sphere(0.5), complement(part("outside", sphere(9)))});
  CHECK(part_names(scene) == std::vector<std::string>{"b", "a", "s"});
  CHECK(part_names({}).empty());
}

TEST_CASE("only what holds a wanted part stays of unions, transforms and looks") {
  const Solid a = part("a", box({1, 1, 1})), b = part("b", sphere(1));
  const Transform up = translation({0, 0, 5});
  const Place place{"scene.csg", 3, 7};
  const Solid scene = unite({sphere(9), transformed(unite({a, b, sphere(2)}), up).at(place), with_look(b, {})});

  const std::vector<std::string> only_a{"a"};
  const Solid kept = only_parts(scene, only_a);
  REQUIRE(kept.kind() == Kind::transform);
  CHECK(kept.place() == place);
  CHECK(kept.children()[0].identity() == a.identity());

  const std::vector<std::string> both{"b", "a", "nobody"};
  const Solid all = only_parts(scene, both);
  REQUIRE(all.kind() == Kind::unite);
  REQUIRE(all.children().size() == 2);
  const Solid& moved = all.children()[0].children()[0];
  REQUIRE(moved.children().size() == 2);
  CHECK(moved.children()[1].identity() == b.identity());
  CHECK(all.children()[1].kind() == Kind::look);

  const std::vector<std::string> nobody{"nobody"};
  CHECK(only_parts(scene, nobody).kind() == Kind::empty);
  CHECK(only_parts(a, both).identity() == a.identity());
}

TEST_CASE("parts a million nodes deep are found without recursion, those of shared nodes in no time") {
  const std::vector<std::string> wanted{"a"};
  Solid deep = part("a", sphere(1));
  for (int i = 0; i < 1'000'000; ++i) deep = with_look(std::move(deep), {});
  CHECK(part_names(deep) == wanted);
  CHECK(only_parts(deep, wanted).kind() == Kind::look);
  Solid doubled = part("a", sphere(1)) + sphere(2);
  for (int i = 0; i < 60; ++i) doubled = doubled + doubled;
  CHECK(part_names(doubled) == wanted);
  CHECK(only_parts(doubled, wanted).kind() == Kind::unite);
}

}  // namespace
