#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Small trees, each with one breach of the house's rules or with something that only looks like one."""
import tempfile
import unittest
from pathlib import Path

from check import check, sizes


def found_in(files, ask=check):
    """What the check says about a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return list(ask(Path(folder)))


def includes(*paths):
    return "".join(f'#include "{path}"\n' for path in paths)


def listing(*headers):
    return f"csgcast_library(name PUBLIC_HEADERS\n  {' '.join(headers)})\n"


def function(lines, inside="", head="int f(int a) {"):
    return "\n".join([head, inside] + ["  a();"] * (lines - 3) + ["}", ""])


class Breach(unittest.TestCase):
    def assert_breach(self, expected, files):
        found = found_in(files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])

    def test_an_include_of_a_module_above(self):
        self.assert_breach("csg/base/a.h:2: csg may not include raycast/line/b.h",
                           {"csg/base/a.h": "\n" + includes("raycast/line/b.h")})

    def test_an_include_of_a_module_beside(self):
        self.assert_breach("shade may not include verify/b.h", {"shade/film/a.h": includes("verify/b.h")})
        self.assert_breach("verify may not include shade/film/b.h", {"verify/a.h": includes("shade/film/b.h")})

    def test_an_include_of_a_higher_floor(self):
        self.assert_breach("raycast/cells may not include raycast/packets/b.h, which is on a higher floor",
                           {"raycast/cells/a.cpp": includes("raycast/packets/b.h")})
        self.assert_breach("csg/base may not include csg/solid/b.h, which is on a higher floor",
                           {"csg/base/a.h": includes("csg/solid/b.h")})

    def test_an_include_of_an_inner_room_that_is_on_a_higher_floor(self):
        self.assert_breach("raycast/cells/build may not include raycast/cells/b.h",
                           {"raycast/cells/build/a.h": includes("raycast/cells/b.h")})

    def test_rooms_of_which_neither_builds_on_the_other(self):
        self.assert_breach("neither room builds on the other", {"raycast/cells/a.cpp": includes("raycast/ray/b.h")})
        self.assert_breach("neither room builds on the other", {"measure/search/a.cpp": includes("measure/section/b.h")})

    def test_a_circle_of_rooms(self):
        found = found_in({"raycast/scene/a.h": includes("raycast/ray/b.h"), "raycast/ray/b.h": includes("raycast/scene/a.h")})
        self.assertEqual(len(found), 2, found)  # one of the two includes points up as well
        self.assertIn("rooms include each other: raycast/ray -> raycast/scene -> raycast/ray", found[1])

    def test_a_circle_of_three_rooms_of_one_floor(self):
        found = found_in({"measure/search/a.h": includes("measure/section/b.h"), "measure/section/b.h": includes("measure/sheet/c.h"),
                          "measure/sheet/c.h": includes("measure/search/a.h")})
        self.assertTrue(any("measure/search -> measure/section -> measure/sheet -> measure/search" in line for line in found), found)

    def test_an_include_beside_the_file(self):
        self.assert_breach("does not start with a module", {"csg/base/a.h": includes("b.h")})

    def test_a_private_header_of_another_room(self):
        self.assert_breach("is private", {"raycast/ray/a.cpp": includes("raycast/surface/detail/b.h")})
        self.assert_breach("is private", {"raycast/cells/a.cpp": includes("raycast/cells/build/detail/b.h")})

    def test_a_header_of_another_module_that_is_not_public(self):
        self.assert_breach("raycast/line/b.h is not public", {"shade/film/a.cpp": includes("raycast/line/b.h")})

    def test_a_private_header_in_a_public_one(self):
        self.assert_breach("csg/base/a.h:1: a public header includes csg/base/detail/b.h, which is not public",
                           {"csg/CMakeLists.txt": listing("base/a.h"), "csg/base/a.h": includes("csg/base/detail/b.h"),
                            "csg/base/detail/b.h": ""})

    def test_a_header_for_the_module_alone_in_a_public_one(self):
        self.assert_breach("csg/exact/b.h, which is not public",
                           {"csg/CMakeLists.txt": listing("solid/a.h"), "csg/solid/a.h": includes("csg/exact/b.h"), "csg/exact/b.h": ""})

    def test_a_public_header_that_names_something_private(self):
        self.assert_breach("csg/base/a.h:1: a public header names detail",
                           {"csg/CMakeLists.txt": listing("base/a.h"), "csg/base/a.h": "namespace csgcast::detail { class B; }\n"})

    def test_a_public_header_that_takes_an_array_as_a_pointer(self):
        for pointer in ("double* t", "const double *t", "std::uint8_t* state", "const std::size_t* ends", "double const* t"):
            self.assert_breach("csg/base/a.h:1: a public header has a pointer to numbers",
                               {"csg/CMakeLists.txt": listing("base/a.h"), "csg/base/a.h": f"void ask({pointer});\n"})

    def test_a_public_header_that_is_not_there(self):
        self.assert_breach("csg/base/a.h:1: listed as a public header", {"csg/CMakeLists.txt": listing("base/a.h")})

    def test_its_own_header_comes_second(self):
        self.assert_breach("first include", {"csg/base/a.h": "", "csg/base/a.cpp": "#include <vector>\n" + includes("csg/base/a.h")})

    def test_a_room_of_31_files(self):
        self.assert_breach("csg/exact:1: a room of 31 files",
                           {f"csg/exact/{'detail/' if i > 20 else ''}a{i}.h": "" for i in range(31)})

    def test_an_inner_folder_of_31_files(self):
        self.assert_breach("raycast/surface/torus:1: a room of 31 files",
                           {f"raycast/surface/torus/{'detail/' if i > 20 else ''}a{i}.h": "" for i in range(31)})

    def test_a_class_in_a_file_without_its_name(self):
        self.assert_breach("raycast/ray/locate.cpp:1: LineCaster is spread over 2 files",
                           {"raycast/ray/line_caster.cpp": "void LineCaster::begin() {}\n",
                            "raycast/ray/locate.cpp": "namespace csgcast {\nPoint LineCaster::locate(int a) const {\n}\n}\n"})

    def test_cgal_in_the_product(self):
        self.assert_breach("CGAL", {"csg/base/a.cpp": "#include <CGAL/Gmpq.h>\n"})

    def test_eigen_in_a_public_header(self):
        listed = {"csg/CMakeLists.txt": listing("base/a.h"), "csg/base/b.h": "#include <Eigen/Core>\n"}
        self.assert_breach("csg/base/a.h:1: a public header that all users", {**listed, "csg/base/a.h": "#include <Eigen/Core>\n"})

    def test_a_library_of_pictures_outside_shade(self):
        self.assert_breach("libpng", {"cli/a.cpp": "#include <png.h>\n"})
        self.assert_breach("OpenImageIO", {"cli/a.cpp": "#include <OpenImageIO/imageio.h>\n"})

    def test_a_library_of_pictures_in_two_files(self):
        for header in ["png.h", "OpenImageIO/imageio.h", "webp/encode.h"]:
            text = f"#include <{header}>\n"
            self.assert_breach("shade/picture/b.cpp:1", {"shade/picture/a.cpp": text, "shade/picture/b.cpp": text})

    def test_a_test_case_that_begins_with_a_dash(self):
        self.assert_breach("tests/a_test.cpp:1: a test case whose name is an option", {"tests/a_test.cpp": 'TEST_CASE("-o works") {}\n'})

    def test_a_wide_line_of_docs(self):
        wide = "word " * 21
        self.assert_breach("docs/a.md:2: a line of 105 columns", {"docs/a.md": f"# A\n{wide}\n| {wide}|\n```\n{wide}\n```\n"})

    def test_a_test_case_with_a_semicolon(self):
        self.assert_breach("tests/a_test.cpp:2: a test case with a semicolon",
                           {"tests/a_test.cpp": 'int a;\nTEST_CASE("this; that") {}\n'})

    def test_test_cases_in_a_file_that_is_not_called_a_test(self):
        self.assert_breach("tests/a.cpp:1: a file is called *_test.cpp", {"tests/a.cpp": 'TEST_CASE("this") {}\n'})

    def test_a_file_without_test_cases_that_is_called_a_test(self):
        self.assert_breach("tests/a_test.cpp:1: a file is called *_test.cpp", {"tests/a_test.cpp": "int a;\n"})


class NoBreach(unittest.TestCase):
    def assert_clean(self, files):
        self.assertEqual(found_in(files), [])

    def test_includes_that_point_down(self):
        self.assert_clean({"csg/CMakeLists.txt": listing("base/b.h"), "csg/base/b.h": "",
                           "cli/command/a.cpp": "#include <vector>\n" + includes("cli/output/c.h", "csg/base/b.h"),
                           "raycast/packets/a.cpp": includes("raycast/cells/build/b.h", "raycast/ray/c.h", "raycast/line/d.h")})

    def test_lane_operations_in_shade(self):
        self.assert_clean({"shade/trace/a.cpp": includes("raycast/simd/lane_ops-inl.h")})

    def test_each_library_of_pictures_in_a_file_of_its_own(self):
        self.assert_clean({"shade/picture/a.cpp": "#include <png.h>\n", "shade/picture/b.cpp": "#include <ImfHeader.h>\n#include <Iex.h>\n",
                           "tests/shade/c.cpp": "#include <png.h>\n#include <tiffio.h>\n"})

    def test_its_own_private_header(self):
        self.assert_clean({"csg/exact/a.cpp": includes("csg/exact/detail/b.h"),
                           "csg/exact/detail/weld/c.h": includes("csg/exact/detail/b.h")})

    def test_a_room_of_30_files_with_an_inner_folder(self):
        files = {f"raycast/surface/a{i}.h": "" for i in range(30)}
        self.assert_clean(files | {f"raycast/surface/torus/a{i}.h": "" for i in range(30)})

    def test_tests_see_everything(self):
        self.assert_clean({"tests/raycast/a_test.cpp": includes("raycast/ray/detail/b.h") + 'TEST_CASE("a") {}\n'})

    def test_the_word_detail_in_a_comment(self):
        self.assert_clean({"csg/CMakeLists.txt": listing("base/a.h"), "csg/base/a.h": "// see detail/b.h\n"})

    def test_a_class_in_files_that_bear_its_name(self):
        self.assert_clean({"csg/exact/dyadic.cpp": "Dyadic Dyadic::negated() const {}\n", "csg/exact/dyadic_bytes.cpp": "void Dyadic::pack() {}\n",
                           "csg/exact/other.cpp": "int f() {\n  return Dyadic::zero();\n}\n"})

    def test_a_class_with_one_file_of_another_name(self):
        self.assert_clean({"csg/exact/numbers.cpp": "Dyadic Dyadic::negated() const {}\n"})

    def test_classes_of_the_same_name_in_two_rooms(self):
        self.assert_clean({"csg/exact/a.cpp": "void State::f() {}\n", "csg/solid/b.cpp": "void State::g() {}\n"})


class Sizes(unittest.TestCase):
    """They are places to look: the check itself does not mind."""

    def assert_listed(self, expected, files):
        self.assertEqual(found_in(files), [])
        found = found_in(files, sizes)
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])

    def test_a_file_of_401_lines(self):
        self.assert_listed("csg/base/a.cpp:1: 401 lines", {"csg/base/a.cpp": "int a;\n" * 401})

    def test_a_function_of_61_lines(self):
        self.assert_listed("csg/base/a.cpp:2: a function of 61 lines", {"csg/base/a.cpp": "namespace n {\n" + function(61) + "}\n"})

    def test_a_member_function_of_61_lines(self):
        self.assert_listed("61 lines", {"csg/base/a.h": "struct S {\n" + function(61) + "};\n"})

    def test_a_long_function_after_braces_in_literals(self):
        odd = "auto a = R\"x({ \" )x\"; char b = '{'; auto c = \"\\\"{\"; /* { */ // {\nint d = 1'000;\n#define E {\n"
        self.assert_listed("csg/base/a.cpp:4: a function of 61 lines", {"csg/base/a.cpp": odd + function(61)})

    def test_what_is_short_or_a_table_is_not_listed(self):
        for text in ("int a;\n" * 400, function(60), function(70, head="constexpr int table[] = {")):
            self.assertEqual(found_in({"csg/base/a.cpp": text}, sizes), [])


if __name__ == "__main__":
    unittest.main()
