#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error of a picture against the time it takes, by samples a pixel.

measure() draws examples at rising numbers of samples and compares them with a reference of 4,096.
"""
import csv
import json
import os
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from compare_pictures import read_png  # noqa: E402

SCENES = ("flange", "still-life")
SAMPLES = (1, 4, 16, 64, 256)
REFERENCE = 4096
SIZE = "40x30"
PASSES = 3


def draw(program, scene, samples, folder, threads):
    """The picture's channel values, 0 to 255, and the seconds its rays took."""
    image, stats = os.path.join(folder, "picture.png"), os.path.join(folder, "picture.json")
    subprocess.run([program, "render", scene, "-o", image, "--size", SIZE, "--samples", str(samples), "--threads",
                    str(threads), "--stats", stats, "--quiet"], check=True)
    with open(stats, encoding="utf-8") as file:
        seconds = json.load(file)["seconds"]["trace"]
    return [value for row in read_png(image) for pixel in row for value in pixel], seconds


def root_mean_square(values, reference):
    return (sum((a - b) ** 2 for a, b in zip(values, reference)) / len(values)) ** .5


def measure(program, examples, folder, output):
    """Writes a CSV: scene, samples, seconds on one thread (median), root mean square error in 8-bit steps."""
    with open(output, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "samples", "seconds", "error"])
        for scene in SCENES:
            path = os.path.join(examples, scene + ".csg")
            print(f"{scene}: reference of {REFERENCE} samples a pixel", file=sys.stderr, flush=True)
            reference, _ = draw(program, path, REFERENCE, folder, os.cpu_count())
            for samples in SAMPLES:
                passes = [draw(program, path, samples, folder, 1) for _ in range(PASSES)]
                seconds = statistics.median(seconds for _, seconds in passes)
                writer.writerow([scene, samples, f"{seconds:.6f}", f"{root_mean_square(passes[0][0], reference):.4f}"])
