#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run time against error: measures, prints tables, draws plots.

usage: run.py BENCH_ACCURACY CSGCAST [--output FOLDER] [--rays N] [FAMILY ..]

FOLDER (default: build/accuracy) gets accuracy.csv and pictures.csv, and of them accuracy-ways.png, accuracy-rivals.png and
accuracy-pictures.png: what docs/accuracy-figures.md shows, explained there. N rays a family, 2,000 unless given.
"""
import argparse
import os
import subprocess
import sys

import picture_error
import plots
import tables

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))


def main():
    parser = argparse.ArgumentParser(description="Run time against error: measures, prints tables, draws plots.")
    parser.add_argument("bench_accuracy")
    parser.add_argument("csgcast")
    parser.add_argument("--output", default=os.path.join(ROOT, "build", "accuracy"), help="folder of the results")
    parser.add_argument("--rays", type=int, default=2000, help="rays a family")
    parser.add_argument("family", nargs="*", help="families to measure; all unless given")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    lists, pictures = (os.path.join(options.output, name) for name in ("accuracy.csv", "pictures.csv"))
    subprocess.run([options.bench_accuracy, lists, os.path.join(options.output, "povray"), str(options.rays),
                    *options.family], check=True)
    picture_error.measure(options.csgcast, os.path.join(ROOT, "examples"), options.output, pictures)
    rows = tables.read(lists)
    print(tables.everything(rows, pictures))
    plots.draw(rows, pictures, options.output)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"{error.cmd[0]} failed")
