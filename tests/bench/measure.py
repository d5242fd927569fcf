#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error of a volume against the time it takes: csgcast's bounds beside meshing, by OpenSCAD and by the manifold library.

csgcast measures each scene with rising precision, on one thread; OpenSCAD exports meshes with rising $fn, and, where Node and the
npm package manifold-3d are (--manifold FOLDER, which holds node_modules), that library does with rising segments. Volumes of meshes
are summed here. The truth is csgcast's at 1e-11. Prints a markdown table: the error, relative, and the seconds of the processor from the
program's start to its end. csgcast's own bound, which is all that a user of it sees, stands beside its error; meshes have none.
The output folder gets measure.csv and measure.png: time from left to right, error from bottom to top.
"""
import argparse
import csv
import json
import os
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import scenes

ROOT = Path(__file__).resolve().parents[2]
SCENES = ["angel", "die", "flange"]
ERRORS = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9]
SEGMENTS = [16, 32, 64, 128, 256]
MANIFOLD_SEGMENTS = [16, 32, 64, 128, 256, 512, 1024]
COLUMNS = ["scene", "program", "setting", "volume", "error", "bound", "seconds"]
SLOW = 90  # seconds, beyond which a program is not asked for more


def timed(command, **more):
    """What it prints, and the processor's seconds that it took; nothing if it is too slow."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=2 * SLOW, **more)
    except subprocess.TimeoutExpired:
        return None, 2 * SLOW
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def mesh_volume(path):
    """Of a binary or text STL file."""
    data = path.read_bytes()
    if data[:5] == b"solid":
        numbers = [tuple(map(float, line.split()[1:])) for line in data.decode().splitlines() if line.split()[:1] == ["vertex"]]
        triangles = zip(numbers[::3], numbers[1::3], numbers[2::3])
    else:
        triangles = (((r[3], r[4], r[5]), (r[6], r[7], r[8]), (r[9], r[10], r[11])) for r in struct.iter_unpack("<12fH", data[84:]))
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
               for a, b, c in triangles) / 6


def by_csgcast(options, folder, name):
    scene = folder / f"{name}.csg"
    scene.write_text(scenes.csg(scenes.SCENES[name]()))
    for error in ERRORS:
        text, seconds = timed([options.program, "measure", scene, "-q", "--threads", "1", "--format", "json", "--relative-error",
                               str(error), "--area-error", "0.99"])
        told = json.loads(text)
        yield f"{error:.0e}", told["volume"], told["volume_error"] / told["volume"], seconds


def by_openscad(options, folder, name):
    solid = scenes.SCENES[name]().solid
    for segments in SEGMENTS:
        source, mesh = folder / f"{name}.scad", folder / f"{name}.stl"
        source.write_text(f"$fn = {segments};\n" + "\n".join(scenes.lines(solid, "()", scenes.csg_leaf, 0)))
        text, seconds = timed(["openscad", "-o", mesh, source], env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))
        if text is None:
            return
        yield f"$fn {segments}", mesh_volume(mesh), None, seconds
        if seconds > SLOW:
            return


MANIFOLD = """
import Module from 'manifold-3d';
const wasm = await Module(); wasm.setup();
const {Manifold} = wasm;
const turns = [[0,1,0,0, 0,0,1,0, 1,0,0,0, 0,0,0,1], [0,0,1,0, 1,0,0,0, 0,1,0,0, 0,0,0,1], null];
const ball = (c, r) => Manifold.sphere(r, N).translate(c);
const box = (a, b) => Manifold.cube([b[0]-a[0], b[1]-a[1], b[2]-a[2]]).translate(a);
const cone = (c, axis, r, s, h) => { let m = Manifold.cylinder(h, r, s, N); if (turns[axis]) m = m.transform(turns[axis]); return m.translate(c); };
const N = %d;
const solid = %s;
console.log(solid.volume());
"""


def manifold_text(solid):
    if isinstance(solid, scenes.Ball):
        return f"ball({list(map(float, solid.center))}, {solid.radius})"
    if isinstance(solid, scenes.Box):
        return f"box({list(map(float, solid.lower))}, {list(map(float, solid.upper))})"
    if isinstance(solid, scenes.Cone):
        return f"cone({list(map(float, solid.bottom))}, {solid.axis}, {solid.bottom_radius}, {solid.top_radius}, {solid.height})"
    return f"Manifold.{solid.name}([{', '.join(map(manifold_text, solid.children))}])"


def by_manifold(options, folder, name):
    if not options.manifold or not shutil.which("node"):
        return
    program = Path(options.manifold) / f"{name}.mjs"
    for segments in MANIFOLD_SEGMENTS:
        program.write_text(MANIFOLD % (segments, manifold_text(scenes.SCENES[name]().solid)))
        text, seconds = timed(["node", program])
        if text is None:
            return
        yield f"{segments} segments", float(text), None, seconds
        if seconds > SLOW:
            return


WAYS = {"csgcast": by_csgcast, "OpenSCAD": by_openscad, "manifold": by_manifold}


def rows(options, folder):
    for name in options.scenes or SCENES:
        scene = folder / f"{name}.csg"
        scene.write_text(scenes.csg(scenes.SCENES[name]()))
        text, _ = timed([options.program, "measure", scene, "-q", "--format", "json", "--relative-error", "1e-11", "--area-error", "0.99"])
        truth = json.loads(text)["volume"]
        for program, way in WAYS.items():
            print(f"{name}: {program}", file=sys.stderr, flush=True)
            for setting, volume, bound, seconds in way(options, folder, name):
                yield dict(zip(COLUMNS, [name, program, setting, volume, abs(volume - truth) / truth, bound, seconds]))


def plot(found, output):
    colors = {"csgcast": "#0072b2", "OpenSCAD": "#d55e00", "manifold": "#009e73"}
    script = [f"set terminal pngcairo size 1200,420 font 'DejaVu Sans,10'\nset output '{output}'\nset logscale xy\n",
              "set format y '10^{%L}'\nset xlabel 'seconds of the processor'\nset multiplot layout 1,3\n"]
    names = list(dict.fromkeys(row["scene"] for row in found))
    for name in names:
        lines, data = [], []
        for program, color in colors.items():
            for column in ["error", "bound"]:
                points = [(r["seconds"], r[column]) for r in found if r["scene"] == name and r["program"] == program and r[column]]
                if points:
                    title = program if column == "error" else program + ", its bound"
                    lines.append(f"'-' with linespoints lc rgb '{color}' pt 7 ps .6 dt {1 if column == 'error' else 2} title '{title}'")
                    data.append("".join(f"{x} {max(y, 1e-13)}\n" for x, y in points) + "e\n")
        script += [f"set title '{name}'\nset ylabel 'error of the volume, relative'\nset key top right\nplot {', '.join(lines)}\n", *data]
    subprocess.run(["gnuplot"], input="".join(script), text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--scenes", nargs="+", choices=SCENES)
    parser.add_argument("--manifold", help="a folder with node_modules/manifold-3d")
    parser.add_argument("--output", type=Path, default=ROOT / "build" / "measure")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        found = list(rows(options, Path(folder)))
    with open(options.output / "measure.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(found)
    print("| scene | program | setting | error | bound | seconds |\n|---|---|---|---:|---:|---:|")
    for row in found:
        bound = f"{row['bound']:.1e}" if row["bound"] else ""
        print(f"| {row['scene']} | {row['program']} | {row['setting']} | {row['error']:.1e} | {bound} | {row['seconds']:.2f} |")
    if shutil.which("gnuplot"):
        plot(found, options.output / "measure.png")


main()
