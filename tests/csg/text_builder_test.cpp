// SPDX-License-Identifier: MIT
#include <string>

#include "csg/solid/bounds.h"
#include "csg/solid/leaf_shape.h"
#include "tests/csg/text_support.h"
#include "tests/support/catch.h"

namespace csgcast::text {
namespace {

using Kind = Solid::Kind;

Solid solid_of(std::string_view text) { return build_text(text).solid; }
Box bounds_of(std::string_view text) { return bounds(solid_of(text)); }

/// The words of the only leaf below transforms and looks.
std::string leaf_kind(Solid solid) {
  while (solid.kind() != Kind::leaf && !solid.children().empty()) solid = Solid(solid.children()[0]);
  return solid.kind() == Kind::leaf ? word(solid.shape().kind) : "";
}

/// The warnings of a text, one a line.
std::string warnings_of(std::string_view text) {
  std::string result;
  for (const Warning& warning : build_text(text).warnings) result += to_string(warning) + "\n";
  return result;
}

const Transform& transform_of(const SceneDescription& scene) {
  REQUIRE(scene.solid.kind() == Kind::transform);
  return scene.solid.transform();
}

Paint paint_of(std::string_view text) {
  const Solid solid = solid_of(text);
  REQUIRE(solid.kind() == Kind::look);
  REQUIRE(solid.look().paint);
  return *solid.look().paint;
}

}  // namespace

TEST_CASE("the primitives of OpenSCAD have its sizes and defaults") {
  CHECK(bounds_of("cube();") == Box{{0, 0, 0}, {1, 1, 1}});
  CHECK(bounds_of("cube(2, true);") == Box{{-1, -1, -1}, {1, 1, 1}});
  CHECK(bounds_of("cube(size = [1, 2, 3], center = false);") == Box{{0, 0, 0}, {1, 2, 3}});
  CHECK(bounds_of("sphere();") == Box{{-1, -1, -1}, {1, 1, 1}});
  CHECK(bounds_of("sphere(d = 6);") == Box{{-3, -3, -3}, {3, 3, 3}});
  CHECK(bounds_of("cylinder();") == Box{{-1, -1, 0}, {1, 1, 1}});
  CHECK(bounds_of("cylinder(4, 2, 1, true);") == Box{{-2, -2, -2}, {2, 2, 2}});
  CHECK(bounds_of("cylinder(h = 4, r = 3, r2 = 1);") == Box{{-3, -3, 0}, {3, 3, 4}});
  CHECK(bounds_of("cylinder(h = 4, d1 = 2, d2 = 8);") == Box{{-4, -4, 0}, {4, 4, 4}});
}

TEST_CASE("the other solids are made by their own words") {
  CHECK(bounds_of("ellipsoid(r = [1, 2, 3]);") == Box{{-1, -2, -3}, {1, 2, 3}});
  CHECK(bounds_of("paraboloid(h = 4, r = 2);") == Box{{-2, -2, 0}, {2, 2, 4}});
  CHECK(bounds_of("hyperboloid(h = 4, r = 2, waist = 1);") == Box{{-2, -2, -2}, {2, 2, 2}});
  CHECK(leaf_kind(solid_of("quadric(A = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], b = [0, 0, 0], c = -4);")) == "quadric");
  CHECK(leaf_kind(solid_of("halfspace(n = [0, 0, 2], d = 1);")) == "halfspace");
  CHECK(bounds_of("convex(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);") == Box{{0, 0, 0}, {1, 1, 1}});
  CHECK(bounds_of("convex(planes = [[1, 0, 0, 1], [-1, 0, 0, 1], [0, 1, 0, 1], [0, -1, 0, 1], [0, 0, 1, 1], [0, 0, -1, "
                  "1]]);") == Box{{-1, -1, -1}, {1, 1, 1}});
}

TEST_CASE("sizes that leave nothing give the empty solid and a warning") {
  for (const char* text : {"cube(0);", "cube([1, -1, 1]);", "sphere(0);", "sphere(-1, $fn = 5);", "cylinder(h = -1);",
                           "cylinder(r1 = 0, r2 = 0);", "cylinder(r1 = -1, r2 = 2, $fn = 6);", "ellipsoid([1, 0, 1]);",
                           "paraboloid(h = 0, r = 1);", "hyperboloid(h = 1, r = 0, waist = 0);",
                           "convex(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]);",
                           "polyhedron(points = undef, faces = undef, convexity = 1);",
                           "quadric(A = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], b = [0, 0, 0], c = 1);"}) {
    INFO(text);
    const SceneDescription scene = build_text(text);
    CHECK(scene.solid.kind() == Kind::empty);
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].place == Place{"test.csg", 1, 1});
    CHECK(scene.warnings[0].text.find("is empty") != std::string::npos);
  }
}

TEST_CASE("undef, inf and nan count as not given") {
  CHECK(bounds_of("cube(size = [inf, 5, 5]);") == Box{{0, 0, 0}, {1, 1, 1}});
  CHECK(bounds_of("cylinder(h = 2, r1 = 3, r2 = inf);") == Box{{-3, -3, 0}, {3, 3, 2}});
  CHECK(bounds_of("sphere(r = undef);") == Box{{-1, -1, -1}, {1, 1, 1}});
  CHECK(warnings_of("sphere(r = undef);").empty());
  CHECK(warnings_of("sphere(r = nan);") ==
        "test.csg:1:8: warning: 'nan' in 'r' of 'sphere' counts as undef, as in OpenSCAD\n");
}

TEST_CASE("operators keep the order of their children, and a union of one is that one") {
  const Solid solid = solid_of("difference() { group() { cube(); sphere(); } group() { cylinder(); } }");
  REQUIRE(solid.kind() == Kind::subtract);
  REQUIRE(solid.children().size() == 2);
  CHECK(solid.children()[0].kind() == Kind::unite);
  CHECK(leaf_kind(solid.children()[1]) == "cylinder");
  CHECK(solid_of("intersection() { cube(); sphere(); }").kind() == Kind::intersect);
  CHECK(solid_of("complement() { cube(); }").kind() == Kind::complement);
  CHECK(leaf_kind(solid_of("render(convexity = 3) { union() { cube(); } }")) == "cube");
  CHECK(solid_of("cube(); sphere();").kind() == Kind::unite);
}

TEST_CASE("an empty first child of a difference and any empty child of an intersection leave nothing") {
  CHECK(bounds_of("difference() { group(); cube(); }").is_null());
  CHECK(bounds_of("difference() { cube(0); cube(); }").is_null());
  CHECK(bounds_of("intersection() { cube(); group(); }").is_null());
  CHECK(bounds_of("union() { group(); cube(); }") == bounds_of("cube();"));
  CHECK(bounds_of("difference();").is_null());
  CHECK(bounds_of("").is_null());
}

TEST_CASE("% and * leave a subtree out before children are counted") {
  for (const char mark : {'%', '*'}) {
    const Solid rest = solid_of(std::string("difference() { ") + mark + "cube(9); sphere(); cylinder(); }");
    REQUIRE(rest.kind() == Kind::subtract);
    CHECK(leaf_kind(rest.children()[0]) == "sphere");
    CHECK(leaf_kind(solid_of(std::string("intersection() { cube(); ") + mark + "group(); }")) == "cube");
    CHECK(leaf_kind(solid_of(std::string("cube(); ") + mark + "hull() { nonsense(); }")) == "cube");
  }
  CHECK(leaf_kind(solid_of("#cube();")) == "cube");
}

TEST_CASE("! leaves only its subtree, without what is above, and the picture's statements") {
  const SceneDescription scene = build_text(
      "light(position = [1, 2, 3]); cube(); translate([5, 0, 0]) { %group() { !sphere(2); } !cylinder(); } hull();");
  CHECK(leaf_kind(scene.solid) == "sphere");
  CHECK(bounds(scene.solid) == Box{{-2, -2, -2}, {2, 2, 2}});
  CHECK(scene.lights.size() == 1);
  CHECK(leaf_kind(solid_of("*group() { !sphere(); } cube();")) == "cube");
}

TEST_CASE("solids know the place of the statement that made them") {
  const Solid solid = solid_of("union() {\n  cube();\n  group() {\n    sphere();\n  }\n}\n");
  CHECK(solid.place() == Place{"test.csg", 1, 1});
  CHECK(solid.children()[0].place() == Place{"test.csg", 2, 3});
  CHECK(solid.children()[1].place() == Place{"test.csg", 4, 5});
}

TEST_CASE("multmatrix fills up with the identity and divides by its last entry") {
  CHECK(transform_of(build_text("multmatrix([[2, 0, 0, 5]]) { cube(); }")) ==
        Transform{{2, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}});
  CHECK(transform_of(build_text("multmatrix([[1], [0, 3, nan], undef]) { cube(); }")) ==
        Transform{{1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0}});
  CHECK(transform_of(build_text("multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,2]]) { cube(); }")) ==
        Transform{{.5, 0, 0, 2, 0, .5, 0, 0, 0, 0, .5, 0}});
}

TEST_CASE("a perspective matrix keeps its affine part and warns") {
  const SceneDescription scene = build_text("multmatrix([[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0.5,0,1]]) { cube(); }");
  CHECK(transform_of(scene) == scaling({2, 2, 2}));
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0].text.find("perspective") != std::string::npos);
}

TEST_CASE("singular and infinite matrices give the empty solid and a warning") {
  for (const char* head : {"multmatrix([[1,0,0,0],[2,0,0,0],[0,0,1,0],[0,0,0,1]])", "scale([1, 0, 1])", "scale(0)",
                           "multmatrix([[1,2,3,0],[4,5,6,0],[7,8,9,0]])", "multmatrix([[1],[0,1],[0,0,1],[0,0,0,0]])",
                           "multmatrix([[1e300,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1e-300]])"}) {
    INFO(head);
    const SceneDescription scene = build_text(std::string(head) + " { cube(); }");
    CHECK(scene.solid.kind() == Kind::empty);
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].text.find("is empty") != std::string::npos);
  }
}

TEST_CASE("translate, rotate, scale and mirror are OpenSCAD's") {
  CHECK(transform_of(build_text("translate([1, 2]) { cube(); }")) == translation({1, 2, 0}));
  CHECK(transform_of(build_text("rotate([90, 0, 45]) { cube(); }")) == rotation({90, 0, 45}));
  CHECK(transform_of(build_text("rotate(30) { cube(); }")) == rotation(30, {0, 0, 1}));
  CHECK(transform_of(build_text("rotate(a = 30, v = [1, 1, 0]) { cube(); }")) == rotation(30, {1, 1, 0}));
  CHECK(transform_of(build_text("scale(3) { cube(); }")) == scaling({3, 3, 3}));
  CHECK(transform_of(build_text("scale([3, 2]) { cube(); }")) == scaling({3, 2, 1}));
  CHECK(transform_of(build_text("mirror([1, 0, 0]) { cube(); }")) == mirroring({1, 0, 0}));
}

TEST_CASE("a part may stand below unions, groups, transforms and looks") {
  const Solid solid =
      solid_of("group() { scale(2) { color(\"red\") { part(\"axle\", density = 7.8) { cube(); sphere(); } } } }");
  REQUIRE(solid.kind() == Kind::transform);
  const Solid part = solid.children()[0].children()[0];
  REQUIRE(part.kind() == Kind::part);
  CHECK(part.part().name == "axle");
  CHECK(part.part().density == 7.8);
  CHECK(part.children()[0].kind() == Kind::unite);
}

TEST_CASE("a part with the name of another one is a part of its own, with a warning") {
  const std::string text =
      "part(\"a\") { cube(); }\npart(\"b\") { cube(); }\ngroup() {\n part(\"a\", nan) { cube(); } }\n*part(\"b\");";
  const Solid solid = solid_of(text);
  REQUIRE(solid.children().size() == 3);
  CHECK(solid.children()[2].kind() == Kind::part);
  CHECK(warnings_of(text) ==
        "test.csg:4:12: warning: 'nan' in 'density' of 'part' counts as undef, as in OpenSCAD\n"
        "test.csg:4:2: warning: a part of line 1 is named 'a' too: they stay two parts\n");
  const std::string name = repeated("x", 41);
  const std::string twice = "part(\"" + name + "\"); part(\"" + name + "\");";
  CHECK(warnings_of(twice).find("'" + repeated("x", 40) + "...' too") != std::string::npos);
}

TEST_CASE("color reads names, hexadecimal digits and channels as sRGB") {
  CHECK(paint_of("color(\"Red\") { cube(); }") == Paint{{1, 0, 0}, 1});
  CHECK(paint_of("color(\"#f00\") { cube(); }") == Paint{{1, 0, 0}, 1});
  CHECK(paint_of("color(\"#f000\") { cube(); }") == Paint{{1, 0, 0}, 0});
  CHECK(paint_of("color(\"#FF0000\", 0.5) { cube(); }") == Paint{{1, 0, 0}, 0.5});
  CHECK(paint_of("color([1, 0, 0, 0.25]) { cube(); }") == Paint{{1, 0, 0}, 0.25});
  CHECK(paint_of("color(\"transparent\") { cube(); }").alpha == 0);
  const Paint teal = paint_of("color(\"teal\") { cube(); }");
  CHECK(teal.color == Rgb{0, linear_from_srgb(128 / 255.0), linear_from_srgb(128 / 255.0)});
  CHECK(paint_of("color(\"#0080807f\") { cube(); }") == Paint{teal.color, 127 / 255.0});
}

TEST_CASE("material, light and background read the same names and digits as color, and lists as linear light") {
  const Rgb teal = paint_of("color(\"teal\") { cube(); }").color;
  for (const std::string color : {"\"teal\"", "\"#008080\"", "\"#008080ff\""}) {
    INFO(color);
    CHECK(solid_of("material(color = " + color + ") { cube(); }").look().material->color == teal);
    CHECK(build_text("light(direction = [0, 0, 1], color = " + color + ");").lights[0].color == teal);
    CHECK(build_text("background(" + color + ");").background == teal);
  }
  CHECK(build_text("background([0, 0.5, 7]);").background == Rgb{0, 0.5, 7});
  CHECK(build_text("light(direction = [0, 0, 1], color = undef);").lights[0].color == Rgb{1, 1, 1});
}

TEST_CASE("a colour that is not set sets none, and one too bright is clamped") {
  CHECK(solid_of("color([-1, -1, -1, 1]) { cube(); }").kind() == Kind::leaf);
  CHECK(solid_of("color(alpha = 0.5) { cube(); }").kind() == Kind::leaf);
  CHECK(paint_of("color([255, 0, 0]) { cube(); }") == Paint{{1, 0, 0}, 1});
  CHECK(warnings_of("color([255, 0, 0]) { cube(); }").find("255") != std::string::npos);
}

TEST_CASE("material reads all that a surface has, in linear light") {
  const Solid solid = solid_of(
      "material(color = [.1, .2, 3], ambient = .1, diffuse = .2, specular = .3, shininess = 4, reflection = .5, "
      "transmission = .6, ior = 1.5, emission = [1, 2, 3], absorption = [4, 5, 6]) { cube(); }");
  REQUIRE(solid.kind() == Kind::look);
  CHECK(solid.look().material == Material{{.1, .2, 3}, .1, .2, .3, 4, .5, .6, 1.5, {1, 2, 3}, {4, 5, 6}});
  CHECK(solid_of("material() { cube(); }").look().material == Material{});
}

TEST_CASE("camera, lights, background and settings are read") {
  const SceneDescription scene = build_text(
      "camera(eye = [1, 2, 3], look_at = [0, 0, 0], fov = 40);"
      "light(position = [1, 0, 0], color = [1, .5, 0], intensity = 2, falloff = 10);"
      "light(direction = [0, 0, -1]);"
      "background([.2, .3, .4]); settings(max_depth = 7, min_contribution = 0);");
  REQUIRE(scene.camera);
  CHECK(scene.camera->eye == Point{1, 2, 3});
  CHECK(scene.camera->up == Vector{0, 0, 1});
  CHECK(scene.camera->fov == 40);
  CHECK_FALSE(scene.camera->height);
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].position == Point{1, 0, 0});
  CHECK(scene.lights[0].color == Rgb{1, .5, 0});
  CHECK(scene.lights[0].intensity == 2);
  CHECK(scene.lights[0].falloff == 10);
  CHECK(scene.lights[1].direction == Vector{0, 0, -1});
  CHECK(scene.background == Rgb{.2, .3, .4});
  CHECK(scene.settings.max_depth == 7);
  CHECK(scene.settings.min_contribution == 0);
  CHECK(build_text("camera(eye = [1, 0, 0], look_at = [0, 0, 0], height = 5);").camera->height == 5);
}

TEST_CASE("a convex polyhedron is the hull of its points, whichever way its faces turn") {
  const std::string points = "points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [2, 0, 0], [9, 9, 9]], ";
  for (const char* faces :
       {"[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]", "[[2, 1, 0], [1, 3, 0], [3, 2, 0], [2, 3, 4]]"}) {
    INFO(faces);
    const Solid solid = solid_of("polyhedron(" + points + "faces = " + faces + ");");
    REQUIRE(solid.kind() == Kind::leaf);
    CHECK(solid.shape().forms.size() == 4);
    CHECK(bounds(solid) == Box{{0, 0, 0}, {2, 2, 2}});
  }
}

TEST_CASE("a polyhedron bent inward by less than a tenth of a degree is its hull, by more it is not convex") {
  // A cube of side 2 whose top's centre is pushed in by `depth`: the top's triangles slope by atan(depth).
  const auto dented = [](const std::string& depth) {
    return "polyhedron(points = [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0],[-1,-1,2],[1,-1,2],[1,1,2],[-1,1,2],[0,0," +
           depth + "]], faces = [[0,1,2,3],[0,4,5,1],[1,5,6,2],[2,6,7,3],[3,7,4,0],[4,8,5],[5,8,6],[6,8,7],[7,8,4]]);";
  };
  // Neighbouring triangles with normals (d, 0, 1) and (0, d, 1) meet at acos(1 / (1 + d²)), about sqrt(2) d: 0.1 degree
  // at d = 0.001234.
  CHECK(bounds_of(dented("1.99880")) == Box{{-1, -1, 0}, {1, 1, 2}});
  CHECK(error_of(dented("1.99870"))->code() == ErrorCode::unsupported);
  CHECK(bounds_of(dented("2.5")) == Box{{-1, -1, 0}, {1, 1, 2.5}});
}

TEST_CASE("a polyhedron with a bent face is its hull, and a warning says so unless few digits explain it") {
  const auto warnings = [](const std::string& height) {
    return build_text(
               "polyhedron(points = [[-10, 0, -10], [10, 0, -10], [10, " + height +
               ", 10], [-10, 0, 10], [-10, -20, -10], [10, -20, -10], [10, -20, 10], [-10, -20, 10]], faces = [[0, 1, "
               "2, 3], [7, 6, 5, 4], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]]);")
        .warnings;
  };
  REQUIRE(warnings("0.01").size() == 1);
  CHECK(warnings("0.01").front().text.find("bent by 0.0025: the hull of its points is taken") != std::string::npos);
  CHECK(warnings("0").empty());
  CHECK(warnings("1.23457e-5").empty());
  CHECK(warnings("1e-17").empty());
}

TEST_CASE("a star-shaped pyramid, whose edges all bend outward, is not convex") {
  const std::string points =
      "points = [[1,0,0],[.309,.951,0],[-.809,.588,0],[-.809,-.588,0],[.309,-.951,0],[0,0,.01]], ";
  const auto error =
      error_of("polyhedron(" + points + "faces = [[0,2,4,1,3],[2,0,5],[4,2,5],[1,4,5],[3,1,5],[0,3,5]]);");
  REQUIRE(error);
  CHECK(error->code() == ErrorCode::unsupported);
}

TEST_CASE("two separate convex shells are not one convex polyhedron") {
  const auto tetrahedron = [](int x) {
    const std::string s = std::to_string(x), t = std::to_string(x + 1);
    return "[" + s + ",0,0],[" + t + ",0,0],[" + s + ",1,0],[" + s + ",0,1]";
  };
  const auto error = error_of("polyhedron(points = [" + tetrahedron(0) + "," + tetrahedron(5) +
                              "], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2],[4,5,6],[4,7,5],[4,6,7],[5,7,6]]);");
  REQUIRE(error);
  CHECK(error->code() == ErrorCode::unsupported);
}

TEST_CASE("convexity is judged alike at every scale") {
  for (const char* scale : {"1e-150", "1", "1e150"}) {
    const std::string s = scale;
    const std::string text = "polyhedron(points = [[0,0,0],[" + s + ",0,0],[0," + s + ",0],[0,0," + s +
                             "]], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);";
    INFO(s);
    CHECK(solid_of(text).kind() == Kind::leaf);
  }
}

TEST_CASE("a million nested operators build without recursion") {
  constexpr std::size_t depth = 500'000;
  const Solid solid = solid_of(repeated("union(){complement(){", depth) + "cube();" + repeated("}}", depth));
  CHECK(solid.kind() == Kind::complement);
}

}  // namespace csgcast::text
