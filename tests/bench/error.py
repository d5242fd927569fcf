#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error of a picture against the time it takes: regular samples beside adaptive ones.

Each scene is drawn with 1, 4, 9, 16, 25 and 64 samples a pixel, on one thread, and compared with a regular picture of 529: 23 x 23,
a prime, so that none of the grids to be judged is part of it.
Prints a markdown table: root mean square errors, of linear light and of sRGB values in [0, 1], over all pixels and channels; the
seconds of the processor that tracing took, the least of some runs; and the primary rays a pixel that were traced. The output
folder gets error.csv with the same numbers, and error.png, a plot of them: time from left to right, error from bottom to top.
"""
import argparse
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import exr

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["die", "flange", "sponge"]
SAMPLES = [1, 4, 9, 16, 25, 64]
COLUMNS = ["scene", "samples", "sampling", "linear", "srgb", "seconds", "rays"]


def draw(options, scene, samples, more, folder):
    """The picture's channels one after another, and what --stats tells of it."""
    picture, stats = folder / "picture.exr", folder / "stats.json"
    subprocess.run([options.program, "render", scene, "-q", "-o", picture, "--stats", stats, "--size", options.size,
                    "--samples", str(samples), *more], check=True)
    _, _, channels = exr.read(picture)
    return [light for name in "RGB" for light in channels[name]], json.loads(stats.read_text())


def srgb(light):
    """Of linear light, clamped to [0, 1] as 8-bit pictures are."""
    light = min(max(light, 0), 1)
    return 12.92 * light if light <= .0031308 else 1.055 * light ** (1 / 2.4) - .055


def root_mean_square(values, reference):
    return (sum((a - b) ** 2 for a, b in zip(values, reference)) / len(values)) ** .5


def measure(options, scene, folder):
    """A row of COLUMNS for each number of samples, each way."""
    name = Path(scene).stem
    print(f"{name}: the reference, {options.reference} samples a pixel", file=sys.stderr, flush=True)
    reference, _ = draw(options, scene, options.reference, [], folder)
    seen = [srgb(light) for light in reference]
    for samples in SAMPLES:
        for sampling in ["regular"] if samples == 1 else ["regular", "adaptive"]:
            more = ["--threads", "1"] + (["--adaptive"] if sampling == "adaptive" else [])
            runs = [draw(options, scene, samples, more, folder) for _ in range(options.runs)]
            values, stats = runs[0]
            yield {"scene": name, "samples": samples, "sampling": sampling, "linear": root_mean_square(values, reference),
                   "srgb": root_mean_square([srgb(light) for light in values], seen),
                   "seconds": min(stats["seconds"]["trace_cpu"] for _, stats in runs),
                   "rays": stats["rays"]["primary"] / (stats["width"] * stats["height"])}


def cells(row):
    return [row["scene"], str(row["samples"]), row["sampling"], f"{row['linear']:.5f}", f"{row['srgb']:.5f}",
            f"{row['seconds']:.3f}", f"{row['rays']:.2f}"]


HEAD = """
set terminal pngcairo size {width},520 font 'DejaVu Sans,11' background '#ffffff'
set output '{output}'
set multiplot layout 1,{panels} margins {left},0.985,0.2,0.91 spacing {gap},0
set logscale xy
set border 3 lc rgb '#808080'
set grid lc rgb '#e4e4e4' lt 1
set tics nomirror scale 0.5 textcolor rgb '#202020'
set xlabel 'seconds of the processor' offset 0,0.3
set format x '%g'
set format y '%g'
set xrange [{fastest}:{slowest}]
set yrange [{least}:{greatest}]
set key at screen 0.5,0.055 center maxrows 1 width 3 samplen 2 Left reverse
"""

# Okabe and Ito's colours, which the colour-blind can tell apart; gnuplot's marks; where the numbers of samples stand.
STYLES = {"regular": ("#d55e00", 7, "left offset 0.6,0.7"), "adaptive": ("#0072b2", 5, "right offset -0.6,-0.7")}


def plot(rows, output):
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    seconds, errors = ([row[name] for row in rows] for name in ("seconds", "srgb"))
    width = 120 + 380 * len(scenes)
    script = [HEAD.format(output=output, width=width, panels=len(scenes), left=95 / width, gap=60 / width,
                          fastest=min(seconds) / 2.5, slowest=max(seconds) * 1.5, least=min(error for error in errors if error > 0) / 1.5,
                          greatest=max(errors) * 1.5)]
    for i, scene in enumerate(scenes):
        curves = []
        for sampling, (color, mark, place) in STYLES.items():
            points = [row for row in rows  # a sample a pixel is where both ways start
                      if row["scene"] == scene and (row["sampling"] == sampling or row["samples"] == 1)]
            script.append(f"$points{i}_{sampling} << EOD\n" +
                          "".join(f"{row['seconds']} {row['srgb']} {row['samples']}\n" for row in points) + "EOD\n")
            title = f"title '{sampling} samples'" if i == 0 else "notitle"
            curves += [f"$points{i}_{sampling} using 1:2 with linespoints pt {mark} ps 1.2 lw 2 lc rgb '{color}' {title}",
                       f"$points{i}_{sampling} using 1:2:3 with labels {place} textcolor rgb '{color}' notitle"]
        label = "root mean square error of sRGB, of 1" if i == 0 else ""
        script.append(f"set title '{scene}'\nset ylabel '{label}' offset 1,0\nplot " + ", ".join(curves) + "\n")
    subprocess.run(["gnuplot"], input="".join(script), text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="scene files; the examples " + ", ".join(SCENES))
    parser.add_argument("--output", type=Path, default=ROOT / "build" / "error", help="folder of error.csv and error.png")
    parser.add_argument("--size", default="320x240", help="320x240")
    parser.add_argument("--reference", type=int, default=529, help="samples a pixel of the reference, 529")
    parser.add_argument("--runs", type=int, default=1, help="of each picture, 1")
    options = parser.parse_intermixed_args()
    scenes = options.scenes or [ROOT / "examples" / (name + ".csg") for name in SCENES]
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    print("| scene | samples | sampling | error, linear | error, sRGB | seconds | rays a pixel |\n|---|--:|---|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            for row in measure(options, scene, Path(folder)):
                rows.append(row)
                print("| " + " | ".join(cells(row)) + " |", flush=True)
    with open(options.output / "error.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    plot(rows, options.output / "error.png")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"{error.cmd[0]} failed")
