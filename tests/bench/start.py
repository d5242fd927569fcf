#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long someone waits for a picture: from the start of the program to its end, the file written, and where the time goes.

Median wall milliseconds over some runs of each scene: `read`, `compile`, `trace` and `write` as --stats has them, `other` for
the rest (loading the program, its options, its end), and `total`, seen from outside. One more run before them warms the disk's
cache. A scene that does not render is named with the program's reason, and left out. The last row is the median of each column.
"""
import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
STAGES = ["read", "compile", "trace", "write"]
COLUMNS = STAGES + ["other", "total"]


def measure(program, scene, options, folder):
    """Milliseconds by column of one run; throws CalledProcessError."""
    stats = folder / "stats.json"
    command = [program, "render", scene, "-q", "-o", folder / ("picture." + options.kind), "--stats", stats,
               "--size", options.size, "--threads", str(options.threads)]
    begin = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True, text=True)
    total = time.perf_counter() - begin
    seconds = json.loads(stats.read_text())["seconds"]
    row = {stage: seconds[stage] for stage in STAGES}
    row |= {"other": total - sum(row.values()), "total": total}
    return {name: 1e3 * value for name, value in row.items()}


def medians(rows):
    return {name: statistics.median(row[name] for row in rows) for name in COLUMNS}


def line(name, width, cells):
    return f"{name:<{width}}" + "".join(f"{cell:>10}" for cell in cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="all examples")
    parser.add_argument("--runs", type=int, default=5, help="of each scene, 5")
    parser.add_argument("--threads", type=int, default=2, help="2")
    parser.add_argument("--size", default="800x600", help="800x600")
    parser.add_argument("--kind", default="png", help="of picture: png, jpg, tif or exr")
    options = parser.parse_intermixed_args()
    options.scenes = options.scenes or sorted(EXAMPLES.glob("*.csg"))
    width = max(len(Path(scene).stem) for scene in options.scenes) + 2
    print(f"median milliseconds of {options.runs} runs: {options.size}, {options.threads} threads, .{options.kind}")
    print(line("scene", width, COLUMNS))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in options.scenes:
            try:
                runs = [measure(options.program, scene, options, Path(folder)) for _ in range(options.runs + 1)][1:]
            except subprocess.CalledProcessError as error:
                print(f"{scene} is left out: {error.stderr.strip().splitlines()[0]}", file=sys.stderr)
                continue
            rows.append(medians(runs))
            print(line(Path(scene).stem, width, (f"{rows[-1][name]:.1f}" for name in COLUMNS)), flush=True)
    if not rows:
        sys.exit(2)
    print(line("median", width, (f"{value:.1f}" for value in medians(rows).values())))


if __name__ == "__main__":
    main()
