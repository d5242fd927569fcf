#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Small trees, each with one breach of the house's rules or with something that only looks like one."""
import tempfile
import unittest
from pathlib import Path

from check import check


def breaches(files):
    """What the check says about a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return list(check(Path(folder)))


def function(lines, inside="", head="int f(int a) {"):
    return "\n".join([head, inside] + ["  a();"] * (lines - 3) + ["}", ""])


class Breach(unittest.TestCase):
    def assert_breach(self, expected, files):
        found = breaches(files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])

    def test_an_include_that_points_up(self):
        self.assert_breach("csg/a.h:2: csg may not include raycast/b.h", {"csg/a.h": '\n#include "raycast/b.h"\n'})

    def test_an_include_of_a_module_on_the_same_level(self):
        self.assert_breach("shade may not include verify/b.h", {"shade/a.h": '#include "verify/b.h"\n'})
        self.assert_breach("verify may not include shade/b.h", {"verify/a.h": '#include "shade/b.h"\n'})

    def test_an_include_beside_the_file(self):
        self.assert_breach("does not start with a module", {"csg/a.h": '#include "b.h"\n'})

    def test_anothers_private_header(self):
        self.assert_breach("is private", {"shade/a.cpp": '#include "raycast/detail/b.h"\n'})

    def test_a_private_header_in_a_public_one(self):
        self.assert_breach("is private", {"csg/a.h": '#include "csg/detail/b.h"\n'})

    def test_its_own_header_comes_second(self):
        self.assert_breach("first include", {"csg/a.h": "", "csg/a.cpp": '#include <vector>\n#include "csg/a.h"\n'})

    def test_cgal_in_the_product(self):
        self.assert_breach("CGAL", {"csg/a.cpp": "#include <CGAL/Gmpq.h>\n"})

    def test_a_library_of_pictures_outside_shade(self):
        self.assert_breach("libpng", {"cli/a.cpp": "#include <png.h>\n"})
        self.assert_breach("OpenEXR", {"cli/a.cpp": "#include <ImfOutputFile.h>\n"})

    def test_a_library_of_pictures_in_two_files(self):
        for header in ["png.h", "jpeglib.h", "tiffio.h", "OpenEXR/ImfHeader.h"]:
            text = f"#include <{header}>\n"
            self.assert_breach("shade/b.cpp:1", {"shade/a.cpp": text, "shade/b.cpp": text})

    def test_a_test_case_with_a_semicolon(self):
        self.assert_breach("tests/a.cpp:2: a test case with a semicolon", {"tests/a.cpp": 'int a;\nTEST_CASE("this; that") {}\n'})

    def test_a_file_of_401_lines(self):
        self.assert_breach("400 lines", {"csg/a.cpp": "int a;\n" * 401})

    def test_a_function_of_61_lines(self):
        self.assert_breach("csg/a.cpp:2: a function of 61 lines", {"csg/a.cpp": "namespace n {\n" + function(61) + "}\n"})

    def test_a_member_function_of_61_lines(self):
        self.assert_breach("61 lines", {"csg/a.h": "struct S {\n" + function(61) + "};\n"})

    def test_a_long_function_after_braces_in_literals(self):
        odd = "auto a = R\"x({ \" )x\"; char b = '{'; auto c = \"\\\"{\"; /* { */ // {\nint d = 1'000;\n#define E {\n"
        self.assert_breach("csg/a.cpp:4: a function of 61 lines", {"csg/a.cpp": odd + function(61)})

    def test_a_long_comment_without_a_reason(self):
        self.assert_breach("61 lines", {"csg/a.cpp": function(61, inside="// long: ")})


class NoBreach(unittest.TestCase):
    def assert_clean(self, files):
        self.assertEqual(breaches(files), [])

    def test_includes_that_point_down(self):
        self.assert_clean({"cli/a.cpp": '#include <vector>\n#include "csg/b.h"\n#include "shade/c.h"\n#include "verify/d.h"\n'})

    def test_each_library_of_pictures_in_a_file_of_its_own(self):
        self.assert_clean({"shade/a.cpp": "#include <png.h>\n", "shade/b.cpp": "#include <ImfHeader.h>\n#include <Iex.h>\n",
                           "tests/shade/c.cpp": "#include <png.h>\n#include <tiffio.h>\n"})

    def test_its_own_private_header(self):
        self.assert_clean({"csg/a.cpp": '#include "csg/detail/b.h"\n', "csg/detail/c.h": '#include "csg/detail/b.h"\n'})

    def test_a_file_of_400_lines(self):
        self.assert_clean({"csg/a.cpp": "int a;\n" * 400})

    def test_a_function_of_60_lines(self):
        self.assert_clean({"csg/a.cpp": function(60)})

    def test_a_long_function_with_a_reason(self):
        self.assert_clean({"csg/a.cpp": function(61, inside="// long: one case for each token")})

    def test_a_long_table(self):
        self.assert_clean({"csg/a.cpp": function(70, head="constexpr int table[] = {")})


if __name__ == "__main__":
    unittest.main()
