#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that a header pulls in little. Usage: header_lines.py COMPILER PROJECT_FOLDER HEADER MOST

Counts the lines of the header with all that it includes, as the compiler preprocesses it. Exits 1 if there are MOST or
more."""
import subprocess
import sys

compiler, folder, header, most = sys.argv[1:]
command = [compiler, "-std=c++20", "-I", folder, "-E", "-x", "c++", "-"]
text = subprocess.run(command, input=f'#include "{header}"\n', stdout=subprocess.PIPE, text=True, check=True).stdout
lines = text.count("\n")
print(f"{header}: {lines} lines preprocessed; the limit is {most}")
sys.exit(1 if lines >= int(most) else 0)
