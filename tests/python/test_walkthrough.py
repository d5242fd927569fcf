# SPDX-License-Identifier: MIT
"""docs/python.md prints what it says that it prints."""
import contextlib
import io
import re
from pathlib import Path

import pytest

TEXT = (Path(__file__).resolve().parents[2] / "docs" / "python.md").read_text()
STEPS = re.findall(r"^```python\n(.*?)^```\n```\n(.*?)^```", TEXT, re.S | re.M)


def test_the_walk_through_prints_what_it_says():
    assert len(STEPS) == TEXT.count("```python")
    names = {}
    for code, said in STEPS:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        assert printed.getvalue() == said
