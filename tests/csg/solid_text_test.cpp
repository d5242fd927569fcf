// SPDX-License-Identifier: MIT
#include "csg/text/statement/solid_text.h"

#include <algorithm>

#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"
#include "csg/solid/simplify.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/each_statement.h"
#include "csg/text/syntax/reader.h"
#include "csg/text/syntax/writer.h"
#include "tests/support/catch.h"
#include "tests/support/membership.h"
#include "tests/support/planted.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::RandomSolids;

namespace {

Solid read_back(const Solid& solid) {
  const std::string written = text::write(text::document_of(solid));
  SceneDescription scene = text::build(text::read(written, "written"), {text::Facets::never});
  CHECK(scene.warnings.empty());
  return scene.solid;
}

/// Of a hull in any order.
bool same_forms(const LeafShape& a, const LeafShape& b) {
  if (a.kind != b.kind || a.forms.size() != b.forms.size()) return false;
  if (a.kind != LeafKind::convex) return std::equal(a.forms.begin(), a.forms.end(), b.forms.begin());
  return std::all_of(a.forms.begin(), a.forms.end(), [&](const QuadricForm& f) {
    const CanonicalForm wanted = canonical(f);
    return std::any_of(b.forms.begin(), b.forms.end(), [&](const QuadricForm& g) {
      const CanonicalForm found = canonical(g);
      return found.form == wanted.form && found.flipped == wanted.flipped;
    });
  });
}

/// The same tree: kinds, exact forms, matrices, names, looks.
bool same(const Solid& a, const Solid& b) {
  if (a.kind() != b.kind() || a.children().size() != b.children().size()) return false;
  if (a.kind() == Solid::Kind::leaf && !same_forms(a.shape(), b.shape())) return false;
  if (a.kind() == Solid::Kind::transform && a.transform().entry != b.transform().entry) return false;
  if (a.kind() == Solid::Kind::part && (a.part().name != b.part().name || a.part().density != b.part().density))
    return false;
  if (a.kind() == Solid::Kind::look && (a.look().material != b.look().material || a.look().paint != b.look().paint))
    return false;
  for (std::size_t i = 0; i < a.children().size(); ++i) {
    if (!same(a.children()[i], b.children()[i])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("every kind of leaf is written by its own statement and read back to the same exact forms") {
  RandomSolids random(1);
  const auto size = [&] { return random.number(0.01, 3); };
  for (int i = 0; i < 200; ++i) {
    const Centering centering = i % 2 == 0 ? Centering::corner : Centering::centered;
    const double waist = i % 5 == 0 ? 0 : size();
    std::vector<Point> points;
    for (int k = 0; k < 12; ++k) points.push_back(random.point(2));
    const std::vector<PlaneEquation> planes{{random.direction(), size()},
                                            {random.direction(), size()},
                                            {random.direction(), size()},
                                            {random.direction(), size()}};
    const std::vector<Solid> leaves{
        box({size(), size(), size()}, centering),
        sphere(size()),
        cylinder(size(), size(), i % 3 == 0 ? 0 : size(), centering),
        ellipsoid({size(), size(), size()}),
        paraboloid(size(), size()),
        hyperboloid(size(), size(), waist),
        hyperboloid(size(), i % 7 == 0 ? 0 : 0.5 * waist, waist == 0 ? 1 : waist),
        quadric({size(), -size(), size(), size(), -size(), size()}, {size(), size(), -size()}, -size()),
        halfspace(random.direction(), random.number(-1, 1)),
        convex_from_points(points),
        convex_from_planes(planes)};
    for (const Solid& leaf : leaves) {
      INFO(text::write(text::document_of(leaf)));
      CHECK(same(leaf, read_back(leaf)));
    }
  }
}

TEST_CASE("trees, transforms, parts and looks are read back as they are") {
  Material glass;
  glass.transmission = 0.7;
  glass.ior = 1.5;
  glass.absorption = {0.1, 0.2, 0.3};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomSolids random(seed);
    const Solid tree = random.tree(8);
    const Paint paint{{linear_from_srgb(0.3), linear_from_srgb(0.9), 1}, 0.5};
    const Solid scene = unite({named(tree, {"a \"b\"\n\\", 2.5}), with_look(named(tree, {"b", 0}), {glass, {}}),
                               with_look(tree, {{}, paint}), transformed(random.tree(3), rotation(33.0, {1, 2, 3}))});
    CHECK(same(scene, read_back(scene)));
  }
  // Both at once become one in the other.
  const Solid both = with_look(sphere(1), {glass, Paint{{1, 0, 0}, 1}});
  const Solid back = read_back(both);
  REQUIRE(back.kind() == Solid::Kind::look);
  CHECK(back.look().material == glass);
  CHECK(back.children()[0].look().paint == Paint{{1, 0, 0}, 1});
}

TEST_CASE("statements bear the places of the nodes that they are made of, those of one file") {
  const char* scene = "cube(1);\ndifference() {\n  sphere(2);\n    translate([1, 2, 3]) { cube(3); }\n}\n";
  const Solid solid = text::build(text::read(scene, "scene.csg")).solid;
  const Solid other = text::build(text::read("\n\n  sphere(7);", "other.csg")).solid;
  const text::Document document = text::document_of(solid + other + sphere(5));
  CHECK(document.file.string() == "scene.csg");
  std::string places;
  text::each_statement(std::span<const text::Node>(document.nodes), [&](const text::Node& node) {
    if (node.name == "cube" || node.name == "sphere")
      places += std::to_string(node.line) + ':' + std::to_string(node.column) + ' ';
  });
  CHECK(places == "1:1 3:3 4:28 0:0 0:0 ");
}

TEST_CASE("a truth function is written as unions and intersections of half-spaces, the same set") {
  RandomSolids random(5);
  for (const bool is_capped : {false, true}) {
    const Solid l = transformed(test::l_prism(is_capped), translation({0.5, 0, 0}));
    const Solid again = read_back(l);
    for (int i = 0; i < 500; ++i) {
      const Point p = random.point(2.5);
      CHECK(test::contains(again, p) == test::contains(l, p));
    }
  }
  CHECK_THROWS_AS(text::document_of(test::cut_cube(0.25, 0.5, 0.75)), Error);
}

TEST_CASE("nothing, everything, and faceted solids are written, too") {
  CHECK(read_back(Solid()).kind() == Solid::Kind::empty);
  CHECK(simplified(read_back(Solid::everything())).kind() == Solid::Kind::everything);
  const SceneDescription faceted =
      text::build(text::read("sphere(2, $fn = 7); cylinder(h = 3, r1 = 1, r2 = 2, $fn = 5);", "t"));
  const Solid back = read_back(faceted.solid);
  REQUIRE(back.children().size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(back.children()[i].shape().forms.size() == faceted.solid.children()[i].shape().forms.size());
}

TEST_CASE("a solid a million deep is written without recursion, a shared one of 2^40 leaves is an error") {
  Solid deep = sphere(1);
  for (int i = 0; i < 1'000'000; ++i) deep = complement(std::move(deep));
  CHECK(text::write(text::document_of(deep)).size() > 10'000'000);
  Solid doubled = sphere(1);
  for (int i = 0; i < 40; ++i) doubled = doubled + doubled;
  CHECK_THROWS_AS(text::document_of(doubled), Error);
}
