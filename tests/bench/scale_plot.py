#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `bench_scale --csv` measured, as a plot, by gnuplot: the cost of a ray and of building, over the number of leaves.

usage: scale_plot.py FILE.csv FILE.png
"""
import csv
import subprocess
import sys

# Colours that the colour-blind can tell apart (Okabe and Ito); solid lines are unions, dashed ones differences.
SCENES = {"union": "solid", "difference": "(8,5)"}
RAYS = {"first hit": ("#0072b2", 7, lambda row: row["first_ns"]), "list": ("#d55e00", 5, lambda row: row["lists_ns"])}
BUILD = {"compiling": ("#009e73", 9, lambda row: 1e6 * row["compile_s"] / row["leaves"]),
         "cells": ("#cc79a7", 13, lambda row: 1e6 * row["cells_s"] / row["leaves"])}

HEAD = """
set terminal pngcairo size 1200,520 font 'DejaVu Sans,11' background '#ffffff'
set output '{output}'
set multiplot layout 1,2 margins 0.07,0.985,0.13,0.91 spacing 0.085,0
set logscale xy
set border 3 lc rgb '#808080'
set grid lc rgb '#e4e4e4' lt 1
set tics nomirror scale 0.5 textcolor rgb '#202020'
set format x '10^{{%T}}'
set format y '%g'
set autoscale xfix
set xlabel 'leaves'
set key top left Left reverse samplen 4
"""


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [{name: value if name == "scene" else float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]


def panel(name, title, label, curves, rows):
    data, plots, values = [], [], []
    for i, (curve, (color, mark, value)) in enumerate(curves.items()):
        for scene, dash in SCENES.items():
            points = [(row["leaves"], value(row)) for row in rows if row["scene"] == scene]
            values += [y for _, y in points]
            data.append(f"${name}{i}{scene} << EOD\n" + "".join(f"{x} {y}\n" for x, y in points) + "EOD\n")
            plots.append(f"${name}{i}{scene} with linespoints pt {mark} ps 1.1 lw 2 dashtype {dash} lc rgb '{color}' "
                         f"title '{curve}, {scene}'")
    # Room above the curves for the key.
    return ("".join(data) + f"set title '{title}'\nset ylabel '{label}' offset 1,0\n"
            f"set yrange [{min(values) / 1.5}:{max(values) * 8}]\nplot " + ", ".join(plots) + "\n")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    rows = read(sys.argv[1])
    script = (HEAD.format(output=sys.argv[2]) +
              panel("rays", "Cost of a ray, in packets", "nanoseconds a ray", RAYS, rows) +
              panel("build", "Cost of making a scene ready", "microseconds a leaf", BUILD, rows))
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
