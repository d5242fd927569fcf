#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""csgcast beside other programs, on the standard scenes, one thread each; they take turns, and medians count.

usage: run.py BENCH_PEERS CSGCAST [options], or: ./dev bench peers [options]

First the rates of intersection, in millions of rays a second, beside Embree and VecGeom (BENCH_PEERS measures them), then
the seconds of whole pictures beside POV-Ray's. Prints Markdown tables; rates.csv and pictures.csv in the output folder have
the same and more.
"""
import argparse
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
sys.path.insert(0, os.path.join(ROOT, "tests", "bench"))

import pictures  # noqa: E402 (needs the path)

QUICK_SECONDS = 10


def arguments():
    parser = argparse.ArgumentParser(prog="./dev bench peers", description="csgcast beside POV-Ray, Embree and VecGeom.")
    parser.add_argument("bench_peers", help=argparse.SUPPRESS)
    parser.add_argument("csgcast", help=argparse.SUPPRESS)
    parser.add_argument("--only", choices=["rates", "pictures"], help="measure these alone")
    parser.add_argument("--scenes", nargs="+", choices=list(pictures.PICTURES), default=list(pictures.PICTURES),
                        metavar="SCENE", help="of " + " ".join(pictures.PICTURES) + "; all unless given")
    parser.add_argument("--passes", type=int, default=3, help="how often each measures a scene (default: 3)")
    parser.add_argument("--side", type=int, default=512, help="rates: side x side rays a scene (default: 512)")
    parser.add_argument("--size", type=int, help="pictures: side of each (default: 1024, swiss 128)")
    parser.add_argument("--limit", type=float, default=300, metavar="SECONDS",
                        help="pictures: halve the side until POV-Ray takes no longer than this; 0: never (default: 300)")
    parser.add_argument("--quick", action="store_true", help=f"pictures: the same as --limit {QUICK_SECONDS}")
    parser.add_argument("--output", default=os.path.join(ROOT, "build", "peers"), help="folder of the results")
    options = parser.parse_args()
    options.csgcast, options.output = os.path.abspath(options.csgcast), os.path.abspath(options.output)
    if options.quick:
        options.limit = QUICK_SECONDS
    return options


def rates(options):
    for name in options.scenes:
        pictures.write_scene(name, options.output)
    subprocess.run([options.bench_peers, *(os.path.join(options.output, f"{name}.csg") for name in options.scenes),
                    "--side", str(options.side), "--passes", str(options.passes),
                    "--csv", os.path.join(options.output, "rates.csv")], check=True)


def draw(options):
    results = []
    for name in options.scenes:
        side = options.size or pictures.PICTURES[name][0]
        results.append(pictures.measure(options.csgcast, name, side, options.passes, options.limit, options.output))
        pictures.write_csv(results, os.path.join(options.output, "pictures.csv"))  # what there is, should one stop it
    print("\n" + pictures.markdown(results))


def main():
    options = arguments()
    os.makedirs(options.output, exist_ok=True)
    if options.only != "pictures":
        rates(options)
    if options.only != "rates":
        draw(options)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"{error.cmd[0]} failed")
