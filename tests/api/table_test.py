#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The check of the table of calls finds each kind of fault. Usage: table_test.py PROJECT_FOLDER"""
import sys
import unittest
from pathlib import Path

import table

ROOT = Path(sys.argv.pop())
ROWS = list(table.ROWS)


class TheCheck(unittest.TestCase):
    def tearDown(self):
        table.ROWS[:] = ROWS

    def change(self, name, column, content):
        table.ROWS[:] = [row[:column] + (content,) + row[column + 1:] if row[0] == name else row for row in ROWS]

    def found(self):
        return "\n".join(table.faults(ROOT))

    def test_finds_nothing_in_the_table_as_it_is(self):
        self.assertEqual(self.found(), "")

    def test_finds_a_name_that_stands_in_no_row(self):
        table.ROWS[:] = [row for row in ROWS if row[0] != "the thinnest wall"]
        for name in ("C++: Model::thinnest", "Python: Model.thinnest", "C: csgcast_thinnest"):
            self.assertIn(f"{name} stands in no row", self.found())

    def test_finds_a_command_that_stands_in_no_row(self):
        table.ROWS[:] = [row for row in ROWS if row[4:] != (["verify"],)]
        self.assertIn("command line: verify stands in no row", self.found())

    def test_finds_a_name_that_the_sources_do_not_have(self):
        for column, name in enumerate(("Model::guess", "Model.guess", "csgcast_guess", "guess"), 1):
            self.change("a section", column, [name])
            self.assertIn(f"the sources have no {name}", self.found())

    def test_finds_a_row_without_a_name_and_without_a_reason(self):
        self.change("a section", 3, [])
        self.assertIn("C: 'a section' has no name", self.found())
        self.change("a section", 3, "!mood")
        self.assertIn("C: 'a section' has neither a name nor a reason", self.found())

    def test_finds_a_reason_that_nothing_has(self):
        table.ROWS[:] = [row for row in ROWS if row[0] != "a map of thickness"]
        self.assertIn("the reason 'map' is not used", self.found())


if __name__ == "__main__":
    unittest.main()
