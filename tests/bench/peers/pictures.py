# SPDX-License-Identifier: MIT
"""The same picture by csgcast and by POV-Ray: seconds to trace it on one thread, shadows and all.

The two take turns, and what counts is the median. POV-Ray's seconds are the processor's, from its own log. csgcast's are
the processor's in the trace stage (`render --stats`). Neither has reading the scene, building what rays are traced in or
writing the picture in it.
"""
import csv
import json
import os
import re
import statistics
import subprocess

import scenes
import table

# Scene and side of the picture, and the least ratio POV-Ray / csgcast that a release may have.
PICTURES = {"angel": (1024, 10), "die": (1024, 15), "flange": (1024, 35), "flush": (1024, 30), "sponge": (1024, 150),
            "balls1k": (1024, 5), "balls": (1024, 4), "swiss1k": (1024, 400), "swiss": (128, 3000)}
SMALLEST_SIDE = 32
CLEARLY = .05  # seconds that the log, which gives milliseconds, tells well enough for an estimate
MINUTES = 60  # seconds from which on POV-Ray draws once
TRACE_TIME = re.compile(r"Trace Time:.*?with ([\d.]+) CPU-seconds", re.S)


class Seconds:
    """One scene: how long each program took, pass by pass, for a picture of side x side."""

    def __init__(self, scene, side):
        self.scene, self.side, self.csgcast, self.povray = scene, side, [], []

    def ratio(self):
        return statistics.median(self.povray) / statistics.median(self.csgcast)


def write_scene(name, folder):
    for kind, write in scenes.WRITERS.items():
        with open(os.path.join(folder, f"{name}.{kind}"), "w", encoding="utf-8") as file:
            file.write(write(scenes.SCENES[name]()))


def trace_csgcast(program, name, side, folder):
    subprocess.run([program, "render", f"{name}.csg", "-o", f"{name}-csgcast.png", "--size", f"{side}x{side}", "--quiet",
                    "--threads", "1", "--stats", f"{name}.json"], check=True, cwd=folder)
    with open(os.path.join(folder, f"{name}.json"), encoding="utf-8") as file:
        return json.load(file)["seconds"]["trace_cpu"]


def trace_povray(name, side, folder):
    done = subprocess.run(["povray", f"+I{name}.pov", f"+O{name}-povray.png", f"+W{side}", f"+H{side}", "-D", "-A", "-V",
                           "+WT1"], check=True, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    return float(TRACE_TIME.search(done.stderr.decode(errors="replace"))[1])


def fitting_side(name, side, limit, folder):
    """The side, halved until POV-Ray should take no more than `limit` seconds for the picture; and how long it should."""
    small = min(side, SMALLEST_SIDE)
    while (seconds := trace_povray(name, small, folder)) < CLEARLY and small < side:
        small = min(side, 2 * small)
    estimate = seconds * (side / small) ** 2
    while limit and estimate > limit and side > small:
        side, estimate = side // 2, estimate / 4
    return side, estimate


def measure(program, name, side, passes, limit, folder):
    write_scene(name, folder)
    wanted = side
    side, estimate = fitting_side(name, side, limit, folder)
    smaller = f" (not {wanted}: POV-Ray would take {estimate * (wanted / side) ** 2:.0f} s)" if side < wanted else ""
    print(f"{name}: {side} x {side}{smaller}, POV-Ray takes about {estimate:.2g} s", flush=True)
    seconds = Seconds(name, side)
    for number in range(passes):
        seconds.csgcast.append(trace_csgcast(program, name, side, folder))
        if number == 0 or estimate < MINUTES:
            seconds.povray.append(trace_povray(name, side, folder))
    return seconds


def write_csv(results, path):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "side", "csgcast_seconds", "povray_seconds", "ratio", "floor", "csgcast_passes",
                         "povray_passes"])
        for r in results:
            writer.writerow([r.scene, r.side, statistics.median(r.csgcast), statistics.median(r.povray), f"{r.ratio():.4g}",
                             PICTURES[r.scene][1], " ".join(map(str, r.csgcast)), " ".join(map(str, r.povray))])


def markdown(results):
    return table.markdown(
        ["scene", "picture", "csgcast, s", "POV-Ray, s", "POV-Ray / csgcast", "floor"],
        [[r.scene, f"{r.side} x {r.side}", f"{statistics.median(r.csgcast):.3g}", f"{statistics.median(r.povray):.3g}",
          table.number(r.ratio()), PICTURES[r.scene][1]] for r in results])
