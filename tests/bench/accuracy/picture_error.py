# SPDX-License-Identifier: MIT
"""The error of a picture against the time it takes, by samples a pixel.

The reference has 4,096 samples a pixel: a picture twice as wide and high with 1,024, of which each four pixels are averaged
in linear light. Its samples are those of a grid of 64 x 64 in the pixel.
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
WIDTH, HEIGHT = 24, 18
PASSES = 3


def draw(program, scene, folder, width, height, samples, threads):
    """The rows of a picture, and the seconds its rays took."""
    image, stats = os.path.join(folder, "picture.png"), os.path.join(folder, "picture.json")
    subprocess.run([program, "render", scene, "-o", image, "--size", f"{width}x{height}", "--samples", str(samples),
                    "--threads", str(threads), "--stats", stats, "--quiet"], check=True)
    with open(stats, encoding="utf-8") as file:
        seconds = json.load(file)["seconds"]["trace"]
    return read_png(image), seconds


def linear(value):
    """Light, 0 to 1, of an sRGB value of 0 to 255."""
    value /= 255
    return value / 12.92 if value <= .04045 else ((value + .055) / 1.055) ** 2.4


def srgb(light):
    """The inverse: 0 to 255, not rounded."""
    return 255 * (12.92 * light if light <= .0031308 else 1.055 * light ** (1 / 2.4) - .055)


def halved(rows):
    """A picture half as wide and high."""
    def channel(x, y, c):
        return srgb(sum(linear(rows[2 * y + j][2 * x + i][c]) for j in (0, 1) for i in (0, 1)) / 4)

    return [[tuple(channel(x, y, c) for c in range(3)) for x in range(len(rows[0]) // 2)] for y in range(len(rows) // 2)]


def root_mean_square(rows, reference):
    values = [[value for row in picture for pixel in row for value in pixel] for picture in (rows, reference)]
    return statistics.mean((a - b) ** 2 for a, b in zip(*values)) ** .5


def measure(program, examples, folder, output):
    """Writes a CSV: scene, samples, seconds on one thread (median), root mean square error in 8-bit steps."""
    with open(output, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "samples", "seconds", "error"])
        for scene in SCENES:
            path = os.path.join(examples, scene + ".csg")
            print(f"{scene}: the reference picture", file=sys.stderr, flush=True)
            reference = halved(draw(program, path, folder, 2 * WIDTH, 2 * HEIGHT, 1024, os.cpu_count())[0])
            for samples in SAMPLES:
                passes = [draw(program, path, folder, WIDTH, HEIGHT, samples, 1) for _ in range(PASSES)]
                seconds = statistics.median(seconds for _, seconds in passes)
                writer.writerow([scene, samples, f"{seconds:.6f}", f"{root_mean_square(passes[0][0], reference):.4f}"])
