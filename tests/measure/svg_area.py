#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The area of a section's SVG, integrated along its path, is the one that is printed, within the errors that are stated.

Usage: svg_area.py CSGCAST SCENE nx,ny,nz,d. Lines, quadratic Beziers and elliptic arcs are read as SVG 1.1, appendix F.6, defines them.
Exits 1 with a sentence if the areas differ, or the path is not closed loops.
"""
import cmath
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path


def arc_area(p, rx, ry, degrees, large, sweep, q):
    """The integral of (x dy - y dx) / 2 along an elliptic arc, and its length (by sampling)."""
    turn = cmath.rect(1, math.radians(degrees))
    half = (p - q) / 2 / turn
    scale = (half.real / rx) ** 2 + (half.imag / ry) ** 2
    if scale > 1:
        rx, ry = rx * math.sqrt(scale), ry * math.sqrt(scale)
    rest = max((rx * ry) ** 2 - (rx * half.imag) ** 2 - (ry * half.real) ** 2, 0)
    factor = math.sqrt(rest / ((rx * half.imag) ** 2 + (ry * half.real) ** 2)) * (1 if large != sweep else -1)
    middle = factor * complex(rx * half.imag / ry, -ry * half.real / rx)
    center = middle * turn + (p + q) / 2
    start = cmath.phase(complex((half.real - middle.real) / rx, (half.imag - middle.imag) / ry))
    end = cmath.phase(complex((-half.real - middle.real) / rx, (-half.imag - middle.imag) / ry))
    angle = end - start
    if sweep and angle < 0:
        angle += 2 * math.pi
    if not sweep and angle > 0:
        angle -= 2 * math.pi
    # About the centre it is rx ry angle / 2; the rest is that of the chord about the origin.
    about_center = rx * ry * angle / 2
    return about_center + (center.real * (q - p).imag - center.imag * (q - p).real) / 2


def loops(path):
    """Each loop's area and how far its end is from its start."""
    tokens = re.findall(r"[MLQAZ]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", path)
    at = 0

    def number():
        nonlocal at
        at += 1
        return float(tokens[at - 1])

    def point():
        return complex(number(), number())

    area, here, start = 0.0, 0j, 0j
    chord = lambda p, q: (p.real * q.imag - p.imag * q.real) / 2
    while at < len(tokens):
        command = tokens[at]
        at += 1
        if command == "M":
            area, here = 0.0, point()
            start = here
        elif command == "L":
            there = point()
            area, here = area + chord(here, there), there
        elif command == "Q":
            corner, there = point(), point()
            # A parabola's segment is two thirds of its triangle.
            area += chord(here, there) + 2 / 3 * chord(corner - here, there - corner)
            here = there
        elif command == "A":
            rx, ry, degrees, large, sweep = (number() for _ in range(5))
            there = point()
            area, here = area + arc_area(here, rx, ry, degrees, large != 0, sweep != 0, there), there
        else:
            yield area, abs(here - start)


def main():
    program, scene, plane = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        svg, table = Path(folder) / "cut.svg", Path(folder) / "cut.json"
        for output in (svg, table):
            subprocess.run([program, "section", scene, "--plane", plane, "-q", "-o", output], check=True)
        told = json.loads(table.read_text())
        text = svg.read_text()
    curves = float(re.search(r"Curves are within (\S+) of", text)[1])
    found = list(loops(re.search(r' d="([^"]*)"', text)[1]))
    area = -sum(a for a, _ in found)  # down is positive in pictures
    allowed = told["area_error"] + curves * told["perimeter"] * 2 + 1e-12 * told["area"]
    print(f"{Path(scene).name} {plane}: {len(found)} loops, area {area!r} along the path, {told['area']!r} within {told['area_error']:.2g} printed")
    if not told["closed"] or any(gap > 10 * curves for _, gap in found):
        sys.exit("some loop is open")
    if abs(area - told["area"]) > allowed:
        sys.exit(f"the areas differ by {abs(area - told['area']):.3g}, more than {allowed:.3g}")


main()
