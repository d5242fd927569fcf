// SPDX-License-Identifier: MIT
#include "csg/solid/simplify.h"

#include <set>

#include "tests/csg/membership.h"
#include "tests/support/catch.h"

using namespace csgcast;
using csgcast::testing::contains;
using csgcast::testing::Random;
using Kind = Solid::Kind;

namespace {

const Solid a = sphere(1), b = box({1, 1, 1}), c = cylinder(1, 1, 1), d = sphere(2);
const Solid nothing, all = Solid::everything();

std::vector<const void*> leaves_in_order(const Solid& solid) {
  std::vector<const void*> leaves;
  std::vector<const Solid*> open{&solid};
  while (!open.empty()) {
    const Solid* top = open.back();
    open.pop_back();
    if (top->kind() == Kind::leaf) leaves.push_back(top->identity());
    for (std::size_t i = top->children().size(); i > 0; --i) open.push_back(&top->children()[i - 1]);
  }
  return leaves;
}

std::size_t node_count(const Solid& solid) {
  std::set<const void*> seen;
  std::vector<const Solid*> open{&solid};
  while (!open.empty()) {
    const Solid* top = open.back();
    open.pop_back();
    if (!seen.insert(top->identity()).second) continue;
    for (const Solid& child : top->children()) open.push_back(&child);
  }
  return seen.size();
}

bool has_part(const Solid& solid) {
  std::vector<const Solid*> open{&solid};
  while (!open.empty()) {
    const Solid* top = open.back();
    open.pop_back();
    if (top->kind() == Kind::part) return true;
    for (const Solid& child : top->children()) open.push_back(&child);
  }
  return false;
}

// The operator and its children, which must all be leaves.
void check_is(const Solid& solid, Kind kind, std::vector<Solid> children) {
  REQUIRE(solid.kind() == kind);
  REQUIRE(solid.children().size() == children.size());
  for (std::size_t i = 0; i < children.size(); ++i) CHECK(solid.children()[i].identity() == children[i].identity());
}

bool is_subsequence(const std::vector<const void*>& part, const std::vector<const void*>& whole) {
  std::size_t matched = 0;
  for (const void* leaf : whole) {
    if (matched < part.size() && part[matched] == leaf) ++matched;
  }
  return matched == part.size();
}

}  // namespace

TEST_CASE("nested unions and intersections become one, in file order") {
  check_is(simplified((a + b) + (c + d)), Kind::unite, {a, b, c, d});
  check_is(simplified(a + (b + (c + d))), Kind::unite, {a, b, c, d});
  check_is(simplified((a & b) & (c & d)), Kind::intersect, {a, b, c, d});
  check_is(simplified((a + Solid()) + complement(complement(b + c))), Kind::unite, {a, b, c});
}

TEST_CASE("nested differences become one, in file order") {
  check_is(simplified((a - b) - c), Kind::subtract, {a, b, c});
  check_is(simplified(a - (b + c)), Kind::subtract, {a, b, c});
  check_is(simplified(((a - b) - (c + d)) - b), Kind::subtract, {a, b, c, d, b});
  const Solid kept = simplified(a - (b - c));
  REQUIRE(kept.kind() == Kind::subtract);
  check_is(kept.children()[1], Kind::subtract, {b, c});
}

TEST_CASE("empty and full children are absorbed") {
  CHECK(simplified(a + nothing).identity() == a.identity());
  CHECK(simplified(a + all).kind() == Kind::everything);
  CHECK(simplified(a & nothing).kind() == Kind::empty);
  CHECK(simplified(a & all).identity() == a.identity());
  CHECK(simplified(all & all).kind() == Kind::everything);
  CHECK(simplified(nothing + nothing).kind() == Kind::empty);
  CHECK(simplified(a - nothing).identity() == a.identity());
  CHECK(simplified(nothing - a).kind() == Kind::empty);
  CHECK(simplified(a - all).kind() == Kind::empty);
  CHECK(simplified((a - (b + all)) + c).identity() == c.identity());
  check_is(simplified(unite({a, b & nothing, c})), Kind::unite, {a, c});
}

TEST_CASE("complements, identities and looks over constants vanish") {
  CHECK(simplified(complement(nothing)).kind() == Kind::everything);
  CHECK(simplified(complement(all)).kind() == Kind::empty);
  CHECK(simplified(complement(complement(a))).identity() == a.identity());
  CHECK(simplified(complement(complement(complement(complement(a))))).identity() == a.identity());
  CHECK(simplified(complement(complement(complement(a)))).kind() == Kind::complement);
  CHECK(simplified(transformed(a, Transform{})).identity() == a.identity());
  CHECK(simplified(transformed(a & nothing, translation({1, 0, 0}))).kind() == Kind::empty);
  CHECK(simplified(with_look(a & nothing, {})).kind() == Kind::empty);
  CHECK(simplified(with_look(a, {})).kind() == Kind::look);
}

TEST_CASE("a named part stays, empty or not, and so does what is around it") {
  const Solid part = named(a & nothing, {"void", 2});
  const Solid kept = simplified(b + part);
  REQUIRE(kept.kind() == Kind::unite);
  REQUIRE(kept.children()[1].kind() == Kind::part);
  CHECK(kept.children()[1].part().name == "void");
  CHECK(kept.children()[1].part().density == 2);
  CHECK(kept.children()[1].children()[0].kind() == Kind::empty);
  for (const Solid& solid :
       {all + part, (all + b) + part, nothing & part, part - all, nothing - part, complement(complement(part)),
        with_look(part, {}), transformed(part, translation({1, 0, 0})), part + (all + part)}) {
    CHECK(has_part(simplified(solid)));
  }
}

TEST_CASE("what cannot be simplified is returned as it was, and a rebuilt node keeps its place") {
  const Solid tidy = transformed(with_look(named((a - b) + c, {"p", 1}), {}), translation({1, 2, 3}));
  CHECK(simplified(tidy).identity() == tidy.identity());
  const Place place{"scene.csg", 7, 3};
  const Solid flat = simplified((with_look(a + nothing, {}).at(place) + b).at({"scene.csg", 1, 1}));
  CHECK(flat.place() == Place{"scene.csg", 1, 1});
  CHECK(flat.children()[0].place() == place);
}

TEST_CASE("simplification keeps the point set and the order of the leaves of random trees") {
  Random random(1);
  std::size_t decided = 0, fewer = 0;
  for (int i = 0; i < 250; ++i) {
    const Solid before = random.tree(8);
    const Solid after = simplified(before);
    CHECK(node_count(after) <= node_count(before) + 1);  // a shared constant may turn into one of its own
    fewer += node_count(after) < node_count(before);
    CHECK(is_subsequence(leaves_in_order(after), leaves_in_order(before)));
    for (int k = 0; k < 12; ++k) {
      const Point p = random.point(3);
      const auto expected = contains(before, p);
      if (!expected) continue;
      ++decided;
      CHECK(contains(after, p) == expected);
    }
  }
  CHECK(decided > 1500);
  CHECK(fewer > 125);
}

TEST_CASE("shared nodes stay shared") {
  Solid doubled = a + b;
  for (int i = 0; i < 100; ++i) doubled = (doubled + nothing) + doubled;
  const Solid result = simplified(doubled);
  CHECK(node_count(result) <= node_count(doubled));
  CHECK(node_count(result) >= 100);
}

TEST_CASE("very deep trees of every shape take a moment") {
  constexpr std::size_t depth = 100'000;
  Solid left = a, right = a, differences = a, alternating = a, padded = a, complements = a;
  for (std::size_t i = 0; i < depth; ++i) {
    left = left + b;
    right = b + right;
    differences = differences - b;
    alternating = i % 2 == 0 ? alternating + b : alternating - c;
    padded = (padded + nothing) - complement(complement(b + c));
    complements = complement(complements);
  }
  CHECK(simplified(left).children().size() == depth + 1);
  CHECK(simplified(right).children().size() == depth + 1);
  CHECK(simplified(differences).children().size() == depth + 1);
  CHECK(node_count(simplified(alternating)) == depth + 3);
  CHECK(simplified(padded).children().size() == 2 * depth + 1);
  CHECK(simplified(complements).identity() == a.identity());
}
