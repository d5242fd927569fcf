// SPDX-License-Identifier: MIT
#include "tests/cli/hostile.h"

namespace csgcast::test {

std::vector<Hostile> hostile_scenes() {
  const std::string identity = "[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]";
  const std::vector<std::string> facets{"render", "scene.csg", "-o",       "out.png",
                                        "--size", "16x16",     "--facets", "always"};
  return {
      {"an unknown statement", "cubes(1);", 2, "1:1: error: there is no statement 'cubes'"},
      {"an unknown argument", "cube(1);\n  cube(sized = 3);", 2, "2:8: error: "},
      {"an unknown colour", "color(\"rde\") { cube(1); }", 2, "1:7: error: "},
      {"an argument twice", "sphere(r = 1, r = 2);", 2, "1:15: error: "},
      {"a string for a size", "cube(\"a\");", 2, "1:6: error: "},
      {"a list for a radius", "sphere(r = [1]);", 2, "1:8: error: 'r' of 'sphere' must be a number"},
      {"a number for a colour", "color(5) { cube(1); }", 2, "1:7: error: "},
      {"a size of two numbers", "cube([1, 2]);", 2, "1:6: error: "},
      {"children of a cube", "cube(1) {\n  sphere(1);\n}", 2, "2:3: error: 'cube' takes no children"},
      {"what is not supported", "union() {\n  cube(1);\n  hull() { cube(1); }\n}", 2,
       "3:3: error: 'hull' is not supported"},
      {"NaN for a size", "cube(size = [nan, 1, 1]);", 0, "1:6: warning: 'nan' in 'size'"},
      {"infinity for a size", "cube(size = inf);", 0, "1:6: warning: 'inf' in 'size'"},
      {"a size of zero", "cube(0);", 0, "1:1: warning: 'cube' is empty"},
      {"a negative size", "cube([1, -1, 1]);", 0, "1:1: warning: 'cube' is empty"},
      {"a negative radius", "sphere(r = -1);", 0, "1:1: warning: 'sphere' is empty"},
      {"a singular matrix", "multmatrix([[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { cube(1); }", 0,
       "1:1: warning: "},
      {"a scale of zero", "cube(1);\nscale([1, 0, 1]) { cube(1); }", 0, "2:1: warning: "},
      {"a perspective matrix", "multmatrix([" + identity + ", [0, 0, 1, 1]]) { cube(1); }", 0,
       "1:1: warning: the last row"},
      {"a matrix with w = 0", "multmatrix([" + identity + ", [0, 0, 0, 0]]) { cube(1); }", 0,
       "1:1: warning: 'multmatrix' is empty"},
      {"a matrix of words", "multmatrix([[\"a\"]]) { cube(1); }", 2, "1:14: error: "},
      {"a normal of zero", "halfspace(n = [0, 0, 0], d = 1);", 2,
       "1:11: error: 'n' of 'halfspace' must not be the zero vector"},
      {"a quadric that is not symmetric", "quadric(A = [[1, 2, 0], [0, 1, 0], [0, 0, 1]], b = [0, 0, 0], c = -1);", 2,
       "1:26: error: the matrix 'A' of 'quadric' is not symmetric"},
      {"a face with the index 1e9",
       "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces = [[0, 1, 1000000000]]);", 2,
       "1:72: error: a face of 'polyhedron' names point 1000000000"},
      {"flat points", "convex(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]);", 0, "1:1: warning: "},
      {"a part in a difference", "difference() {\n  cube(1);\n  part(\"a\") { cube(1); }\n}", 2, "3:3: error: "},
      {"a part in a part", "part(\"a\") { part(\"b\") { cube(1); } }", 2, "1:13: error: "},
      {"a negative density", "part(\"a\", density = -1) { cube(1); }", 2, "1:11: error: 'density'"},
      {"a camera that looks at itself", "camera(eye = [1, 1, 1], look_at = [1, 1, 1]);", 2, "1:25: error: 'look_at'"},
      {"a camera's angle of 180", "camera(eye = [1, 1, 1], look_at = [0, 0, 0], fov = 180);", 2, "1:46: error: 'fov'"},
      {"two cameras", "camera(eye = [9, 0, 0], look_at = [0, 0, 0]);\ncamera(eye = [9, 0, 0], look_at = [0, 0, 0]);", 2,
       "2:1: error: a second 'camera'"},
      {"a light without a place", "light(intensity = 1);", 2, "1:1: error: "},
      {"a depth of 1e9", "settings(max_depth = 1e9);", 2, "1:10: error: 'max_depth'"},
      {"a negative depth", "settings(max_depth = -1);", 2, "1:10: error: 'max_depth'"},
      {"a thousand million facets", "sphere(r = 1, $fn = 1e9);", 2, "1:1: error: 'sphere' has too many facets", facets},
      {"facets that are not asked for", "sphere(r = 1, $fn = 1e9);", 0, ""},
      {"numbers at the edge of double", "translate([1e308, 1e308, 0]) { cube(1e308); }", 2,
       "1:32: error: this solid is too large"},
      {"numbers at the least of double", "scale([1e-308, 1e-308, 1e-308]) { sphere(1e-308); }", 2,
       "1:35: error: this solid is too small"},
      {"scales that overflow double",
       repeated("scale([1e300, 1e300, 1e300]) { ", 1000) + "cube(1);" + repeated("}", 1000), 2, "1:"},
      {"a thousand rotations", repeated("rotate([11, 22, 33]) {", 1000) + "sphere(1);" + repeated("}", 1000), 2, "1:"},
      {"an unbounded scene", "complement() { sphere(1); }", 0, ""},
      {"a hundred thousand solids", repeated("cube(1);\n", 100000), 0, "", {"info", "scene.csg", "-o", "out.png"}},
  };
}

}  // namespace csgcast::test
