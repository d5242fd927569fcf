// SPDX-License-Identifier: MIT
#include "measure/check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "csg/solid/primitives.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

Solid shifted(Solid solid, Vector by) { return transformed(std::move(solid), translation(by)); }
Solid part(const char* name, Solid solid) { return named(std::move(solid), {name, 1}); }

/// Two parts of size about 1 that overlap by `depth`; with 0 they are flush: faces coincide, or touch in a line or a
/// point. `kind` in [0, 10).
std::pair<Solid, Solid> pair_of(int kind, double depth) {
  const Centering centered = Centering::centered;
  switch (kind) {
    case 0:  // side by side
      return {box({1, 1, 1}), shifted(box({1, 0.5, 0.75}), {1 - depth, 0.25, 0.125})};
    case 1:  // a peg in its hole
      return {box({2, 2, 1}, centered) - cylinder(4, 0.5, 0.5, centered),
              cylinder(3, 0.5 + depth, 0.5 + depth, centered)};
    case 2:  // a ball on a plate
      return {box({2, 2, 0.5}), shifted(sphere(0.5), {1, 1, 1 - depth})};
    case 3:  // a ball in its socket
      return {box({2, 2, 2}, centered) - sphere(0.75), sphere(0.75 + depth)};
    case 4:  // two balls
      return {sphere(0.5), shifted(sphere(0.5), {1 - depth, 0, 0})};
    case 5:  // a cone in its seat
      return {shifted(box({2, 2, 1}), {-1, -1, 0}) - cylinder(1, 0.25, 0.75),
              shifted(cylinder(1, 0.25, 0.75), {0, 0, -depth})};
    case 6:  // edge to edge
      return {box({1, 1, 1}), shifted(box({1, 1, 1}), {1 - depth, 1 - depth, 0})};
    case 7:  // corner to corner
      return {box({1, 1, 1}), shifted(box({1, 1, 1}), {1 - depth, 1 - depth, 1 - depth})};
    case 8:  // rods side by side
      return {cylinder(2, 0.5, 0.5), shifted(cylinder(2, 0.5, 0.5), {1 - depth, 0, 0.5})};
    default:  // a ring about a shaft
      return {cylinder(1, 0.875, 0.875) - shifted(cylinder(2, 0.5, 0.5), {0, 0, -0.5}),
              shifted(cylinder(4, 0.5 + depth, 0.5 + depth), {0, 0, -1})};
  }
}

Scene scene_of(const std::pair<Solid, Solid>& solids, const Transform& transform) {
  return compile(transformed(part("a", solids.first) + part("b", solids.second), transform));
}

}  // namespace

TEST_CASE("Of 50 overlaps, down to 1e-9 of the parts' size, every one is found, with a place in it and its volume") {
  RandomSolids random(1);
  for (int i = 0; i < 50; i += test::stride) {
    const double depth = std::pow(10.0, -1.5 - 7.5 * (i / 10) / 4.0);  // 0.03 to 1e-9
    const Transform transform = i % 2 == 0 ? Transform() : rotation(random.number(1, 89), random.direction());
    const Scene scene = scene_of(pair_of(i % 10, depth), transform);
    const CheckReport report = check(scene);
    INFO("kind " << i % 10 << ", depth " << depth);
    REQUIRE(report.overlaps.size() == 1);
    CHECK(report.undecided.empty());
    CHECK(report.overlaps[0].first == PartId(0));
    CHECK(report.overlaps[0].second == PartId(1));
    Caster caster(scene);
    // What is thinner than a coordinate's rounding may not hold the rounded place.
    for (const std::uint32_t p : {0u, 1u}) {
      const Location location = caster.locate(scene.parts()[p].node, report.overlaps[0].witness);
      CHECK(location != Location::outside);
    }
    CHECK(report.overlaps[0].volume.value + report.overlaps[0].volume.error > 0);
    CHECK(report.overlaps[0].volume.value - report.overlaps[0].volume.error < 20 * depth);
  }
}

TEST_CASE("Of 50 flush contacts none is an overlap") {
  RandomSolids random(2);
  for (int i = 0; i < 50; i += test::stride) {
    const Transform transform = i % 2 == 0 ? Transform() : rotation(random.number(1, 89), random.direction());
    const CheckReport report = check(scene_of(pair_of(i % 10, 0), transform));
    INFO("kind " << i % 10 << ", " << (i % 2 == 0 ? "straight" : "turned"));
    CHECK(report.overlaps.empty());
    for (const Contact& contact : report.undecided) CHECK(contact.most < 1e-9);
  }
}

TEST_CASE("The volume of an overlap is that of what both share") {
  const CheckReport report =
      check(compile(part("a", box({1, 1, 1})) + part("b", shifted(box({1, 1, 1}), {0.75, 0.5, 0}))));
  REQUIRE(report.overlaps.size() == 1);
  CHECK(std::fabs(report.overlaps[0].volume.value - 0.125) <= report.overlaps[0].volume.error + 1e-15);
  CHECK(report.overlaps[0].volume.error < 1e-3);
}

TEST_CASE("All pairs of many parts that overlap are found, in order") {
  std::vector<Solid> parts;
  for (int i = 0; i < 12; ++i)
    parts.push_back(part("ball", shifted(sphere(0.6), {static_cast<double>((i * 5) % 12), 0, 0})));
  const CheckReport report = check(compile(unite(parts)));
  CHECK(report.overlaps.size() == 11);
  for (std::size_t i = 1; i < report.overlaps.size(); ++i)
    CHECK(std::pair(report.overlaps[i - 1].first, report.overlaps[i - 1].second) <
          std::pair(report.overlaps[i].first, report.overlaps[i].second));
}

TEST_CASE(
    "What is without effect: hidden, missed, empty, holding all it is intersected with, and of these the outermost") {
  using Why = Redundancy::Why;
  const Solid block = box({4, 4, 4}, Centering::centered);
  const Solid ball = sphere(1);
  const Scene scene = compile(unite({
      block - shifted(ball, {9, 0, 0}),                                       // leaf 1 cuts nothing
      ball,                                                                   // 2: within the block
      shifted(box({1, 1, 1}), {2, 0, 0}),                                     // 3: on its side, seen
      shifted(block & shifted(box({9, 9, 9}), {-4, -4, -4}), {9, 0, 0}),      // 5: holds all of 4
      ball & shifted(ball, {3, 0, 0}),                                        // 6, 7: apart
      shifted(box({1, 1, 1}) & shifted(sphere(1.7), {2, 2, 2}), {-9, 0, 0}),  // 8, 9: apart, but for their boxes
      shifted(ball - (ball - shifted(ball, {5, 0, 0})), {0, 9, 0}),           // 10 to 12: nothing is left
      shifted(block - (ball & halfspace({0, 0, 1}, -1.5)), {0, 0, 9}),        // 14, 15: cut nothing together
      shifted(block & halfspace({0, 0, 1}, 3), {0, 0, 18}),                   // 17: unbounded, holds all of 16
  }));
  const CheckReport report = check(scene);
  struct Found {
    const char* word;
    Why why;
    std::uint32_t first, end;
  };
  const std::vector<Found> expected{{"sphere", Why::has_no_effect, 1, 2},    {"sphere", Why::has_no_effect, 2, 3},
                                    {"cube", Why::holds_all, 5, 6},          {"intersection", Why::is_empty, 6, 8},
                                    {"intersection", Why::is_empty, 8, 10},  {"difference", Why::is_empty, 10, 13},
                                    {"intersection", Why::is_empty, 14, 16}, {"halfspace", Why::holds_all, 17, 18}};
  REQUIRE(report.redundant.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Redundancy& found = report.redundant[i];
    INFO(i);
    CHECK(std::string(word(scene, found)) == expected[i].word);
    CHECK(found.why == expected[i].why);
    CHECK(found.first_leaf == expected[i].first);
    CHECK(found.leaf_end == expected[i].end);
  }
}

namespace {

/// Boxes whose corners are quarters, joined anyhow.
Solid tree_of_boxes(RandomSolids& random, int leaves) {
  if (leaves == 1) return random.grid_box();
  const int left = 1 + static_cast<int>(random.index(static_cast<std::size_t>(leaves - 1)));
  const Solid a = tree_of_boxes(random, left), b = tree_of_boxes(random, leaves - left);
  switch (random.index(4)) {
    case 0:
      return a - b;
    case 1:
      return a & b;
    case 2:
      return a & complement(b);
    default:
      return a + b;
  }
}

/// The value of a scene's tree at a point, if one of its nodes were empty or everything.
bool value_with(Caster& caster, Point p, NodeId node, NodeId replaced, bool by) {
  if (node == replaced) return by;
  const Scene& scene = caster.scene();
  const Node& at = scene.node(node);
  if (at.op == Node::Op::leaf) return caster.locate(node, p) == Location::inside;
  const auto children = scene.children(at);
  const auto holds = [&](NodeId child) { return value_with(caster, p, child, replaced, by); };
  switch (at.op) {
    case Node::Op::unite:
      return std::ranges::any_of(children, holds);
    case Node::Op::intersect:
      return std::ranges::all_of(children, holds);
    case Node::Op::subtract:
      return holds(children[0]) && !holds(children[1]);
    case Node::Op::complement:
      return !holds(children[0]);
    default:
      return at.op == Node::Op::everything;
  }
}

/// Whether a tree of boxes whose corners are quarters would be the same without a node: by the middles of all cells.
bool is_redundant(Caster& caster, NodeId node, bool by) {
  constexpr int quarters = 11;
  for (int x = -quarters; x < quarters; ++x) {
    for (int y = -quarters; y < quarters; ++y) {
      for (int z = -quarters; z < quarters; ++z) {
        const Point p{0.25 * x + 0.125, 0.25 * y + 0.125, 0.25 * z + 0.125};
        const NodeId root = caster.scene().root();
        if (value_with(caster, p, root, NodeId(), by) != value_with(caster, p, root, node, by)) return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("Of trees of boxes exactly those nodes are without effect that no cell of the grid shows a difference for") {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomSolids random(seed);
    const Scene scene = compile(box({4, 4, 4}, Centering::centered) & tree_of_boxes(random, 7));
    const CheckReport report = check(scene);
    Caster caster(scene);
    const auto covered = [&](std::uint32_t leaf) {
      return std::ranges::any_of(report.redundant,
                                 [&](const Redundancy& r) { return r.first_leaf <= leaf && leaf < r.leaf_end; });
    };
    // Leaves that are no operand of an intersection, and those that are.
    for (const Node& node : scene.nodes()) {
      if (node.op == Node::Op::leaf) continue;
      for (const NodeId child : scene.children(node)) {
        const Node& leaf = scene.node(child);
        if (leaf.op != Node::Op::leaf) continue;
        const bool expected = is_redundant(caster, child, node.op == Node::Op::intersect);
        INFO("seed " << seed << ", leaf " << leaf.first);
        if (expected) CHECK(covered(leaf.first));
        if (!expected && covered(leaf.first)) {  // then it is within something that is redundant as a whole
          const auto whole = std::ranges::find_if(report.redundant, [&](const Redundancy& r) {
            return r.first_leaf <= leaf.first && leaf.first < r.leaf_end;
          });
          CHECK(whole->op != Node::Op::leaf);
        }
        found += expected;
      }
    }
    for (const Redundancy& r : report.redundant) {
      const auto operation = std::ranges::find_if(scene.operations(), [&](const Operation& o) {
        return o.first_leaf == r.first_leaf && o.leaf_end == r.leaf_end && o.op == r.op;
      });
      if (r.op == Node::Op::leaf) continue;
      REQUIRE(operation != scene.operations().end());
      INFO("seed " << seed << ", leaves from " << r.first_leaf << " to " << r.leaf_end);
      CHECK(is_redundant(caster, operation->node, r.why == Redundancy::Why::holds_all));
      ++found;
    }
  }
  CHECK(found > 20);
}

TEST_CASE("A ball that two others hold between them is without effect, and less these two empty") {
  const Solid held = shifted(sphere(1.2986449187477205), {1.1643664121687392, 2.201070675528236, 8.535071669751751});
  const Solid one = shifted(sphere(2.956668032013189), {1.4396253063062703, 3.4055177269707917, 7.8673899510011015});
  const Solid other = shifted(sphere(3.5566315767170633), {4.949023852885141, 1.8075216357245283, 6.851760787812882});
  const CheckReport report = check(compile(unite({held, one, other})));
  REQUIRE(report.redundant.size() == 1);
  CHECK(report.redundant[0].first_leaf == 0);
  CHECK(check(compile(subtract({held, one, other}))).is_empty);
}

TEST_CASE("A leaf that makes the least of a difference is not without effect") {
  const CheckReport thin = check(compile(box({1, 1, 1}) + box({1, 1, 1 + 1e-9})));
  REQUIRE(thin.redundant.size() == 1);
  CHECK(thin.redundant[0].first_leaf == 0);  // the lower one
  const CheckReport same = check(compile(box({1, 1, 1}) + box({1, 1, 1})));
  CHECK(same.redundant.size() == 2);
}

TEST_CASE("More than a thousand solids in one place are not asked one by one, which would take minutes") {
  Solid chain = box({1, 1, 1});
  for (int i = 0; i < 2000; ++i) {
    Solid next = shifted(sphere(0.1), {i % 7 / 7.0 + i / 2000.0, 0.5 * (i % 2), 0});
    chain = i % 2 == 0 ? chain + next : chain - next;
  }
  const CheckReport report = check(compile(chain));
  CHECK(report.looked_for_redundancy);
  CHECK(report.not_asked > 1000);
}

TEST_CASE("Unbounded and empty parts are told") {
  const Scene scene =
      compile(unite({part("ground", halfspace({0, 0, 1}, 0)), part("ball", shifted(sphere(1), {0, 0, 3})),
                     part("nothing", sphere(1) & shifted(sphere(1), {1, 0, 0}) & halfspace({1, 0, 0}, -5)),
                     part("sunk", shifted(sphere(1), {5, 0, 0.5}))}));
  const CheckReport report = check(scene);
  CHECK(report.is_unbounded);
  CHECK_FALSE(report.is_empty);
  CHECK(report.unbounded == std::vector<PartId>{PartId(0)});
  CHECK(report.empty == std::vector<PartId>{PartId(2)});
  REQUIRE(report.overlaps.size() == 1);
  CHECK(report.overlaps[0].first == PartId(0));
  CHECK(report.overlaps[0].second == PartId(3));
  // A ball cut at half its radius above the middle: pi h² (3 r - h) / 3 with h = 1/2.
  const double cap = M_PI * 0.25 * 2.5 / 3;
  CHECK(std::fabs(report.overlaps[0].volume.value - cap) <= report.overlaps[0].volume.error + 1e-15);
}

TEST_CASE("The empty scene is fine, and says that it is empty") {
  const CheckReport report = check(compile(Solid()));
  CHECK(report.is_empty);
  CHECK(report.overlaps.empty());
  CHECK(report.redundant.empty());
}

TEST_CASE("A line in the surfaces of both parts proves no overlap") {
  // Disjoint, and the x axis lies in all four surfaces.
  const Solid ball_like = quadric({0, 1, 1, 0, 0, 0}, {0, -2, 0}, 0);
  const Solid a = (halfspace({0, -1, 0}, 0) & halfspace({0, 0, -1}, 0)) - ball_like;
  const Solid b = halfspace({0, -1, 1}, 0) & halfspace({0, 1, 0}, 0.5) & halfspace({0, 0, 1}, 0.5);
  CHECK(check(compile(part("a", a) + part("b", b))).overlaps.empty());
}
