// SPDX-License-Identifier: MIT
#include "csg/base/tree_walk.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/support/catch.h"

using csgcast::TreeWalk;

namespace {

/// A name and the children by their places in one list.
struct Tree {
  struct Node {
    std::string name;
    std::vector<std::size_t> children;
  };
  std::vector<Node> nodes;
};

/// What enter and leave are called with, in order; nodes whose names are in `skipped` are not entered.
std::string calls(const Tree& tree, const std::vector<std::size_t>& roots, const std::string& skipped) {
  std::string log;
  TreeWalk<const std::size_t, std::string> walk;
  const std::string whole = walk.run(
      roots, "top",
      [&](std::size_t at, const std::string& above) -> std::optional<std::string> {
        const std::string& name = tree.nodes[at].name;
        log += "(" + name + " below " + above + ")";
        if (skipped.find(name) != std::string::npos) return std::nullopt;
        return name;
      },
      [&](std::size_t at) { return std::span(tree.nodes[at].children); },
      [&](std::size_t at, std::string state, std::string& above) {
        log += "<" + tree.nodes[at].name + " " + state + ">";
        above += "+" + state;
      });
  return log + whole;
}

}  // namespace

TEST_CASE("a tree walk enters nodes in order, and leaves each after its children") {
  const Tree tree{{{"a", {1, 2}}, {"b", {3}}, {"c", {}}, {"d", {}}}};
  CHECK(calls(tree, {0}, "") ==
        "(a below top)(b below a)(d below b)<d d><b b+d>(c below a+b+d)<c c><a a+b+d+c>top+a+b+d+c");
}

TEST_CASE("a tree walk does not go below a node that has no state, and does not leave it") {
  const Tree tree{{{"a", {1, 2}}, {"b", {3}}, {"c", {}}, {"d", {}}}};
  CHECK(calls(tree, {0}, "bc") == "(a below top)(b below a)(c below a)<a a>top+a");
}

TEST_CASE("a tree walk takes several roots, or none") {
  const Tree tree{{{"a", {}}, {"b", {}}}};
  CHECK(calls(tree, {1, 0}, "") == "(b below top)<b b>(a below top+b)<a a>top+b+a");
  CHECK(calls(tree, {}, "") == "top");
}

TEST_CASE("a tree walk goes a million deep, and starts anew after it was broken off") {
  constexpr std::size_t depth = 1'000'000;
  std::vector<std::size_t> below(depth);  // the node that each has as its only child
  for (std::size_t i = 0; i < depth; ++i) below[i] = i + 1;
  const std::size_t root = 0;
  TreeWalk<const std::size_t, std::size_t> walk;
  const auto run = [&](std::size_t broken_off_at) {
    return walk.run(
        {&root, 1}, 0,
        [&](std::size_t at, std::size_t) {
          if (at == broken_off_at) throw at;
          return std::optional<std::size_t>(1);
        },
        [&](std::size_t at) { return at < depth ? std::span(&below[at], 1) : std::span<const std::size_t>(); },
        [](std::size_t, std::size_t levels, std::size_t& above) { above += levels; });
  };
  CHECK_THROWS_AS(run(depth / 2), std::size_t);
  CHECK(run(depth + 1) == depth + 1);
}
