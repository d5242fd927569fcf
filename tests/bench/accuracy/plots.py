# SPDX-License-Identifier: MIT
"""What was measured, as plots, by gnuplot: time from left to right, error from bottom to top, both logarithmic."""
import collections
import csv
import os
import statistics
import subprocess

import tables

# Colours that the colour-blind can tell apart (Okabe and Ito), and gnuplot's filled marks.
STYLES = {"plain": ("#e69f00", 9), "Kahan": ("#56b4e9", 11), "shifted": ("#cc79a7", 5), "compensated": ("#0072b2", 13),
          "certified": ("#009e73", 7), "exact": ("#404040", 15), "POV-Ray": ("#d55e00", 5), "Embree": ("#7a5c00", 9)}

# How errors are shown: zero, which has no logarithm, gets a line of its own at the bottom.
Axis = collections.namedtuple("Axis", "title label bottom top zero zero_label ticks")
SHARE = Axis("", "share of rays", 3e-5, 1.5, 1e-4, "none", "'0.1 %%' 1e-3, '1 %%' 1e-2, '10 %%' 1e-1, '100 %%' 1")
ULPS = Axis("", "units in the last place", 1e-3, 1e18, 3e-2, "0",
            "'1' 1, '10^3' 1e3, '10^6' 1e6, '10^9' 1e9, '10^{12}' 1e12, '10^{15}' 1e15")

ROUNDING = 12 ** -.5  # root mean square of what is uniform within half a step

HEAD = """
set terminal pngcairo size 1200,600 font 'DejaVu Sans,11' background '#ffffff'
set output '{output}'
set multiplot layout 1,2 margins 0.075,0.985,0.22,0.91 spacing 0.085,0
set logscale xy
set border 3 lc rgb '#808080'
set grid lc rgb '#e4e4e4' lt 1
set tics nomirror scale 0.5 textcolor rgb '#202020'
set xtics ('100 ns' 1e2, '1 µs' 1e3, '10 µs' 1e4, '100 µs' 1e5, '1 ms' 1e6)
set xlabel 'time a ray' offset 0,0.3
set xrange [{left}:{right}]
set key at screen 0.53,0.085 center maxrows 1 width 2 samplen 1 Left reverse
set label 1 at screen 0.53,0.035 center textcolor rgb '#606060' \
  'Small dots: families of rays. Large marks: their median time and {summary}.'
"""

PANEL = """
set title '{axis.title}'
set ylabel '{axis.label}' offset 1,0
set yrange [{axis.bottom}:{axis.top}]
set ytics ('{axis.zero_label}' {axis.zero}, {axis.ticks})
plot {curves}
"""


def run_gnuplot(script):
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def block(name, points):
    return f"${name} << EOD\n" + "".join(" ".join(str(value) for value in point) + "\n" for point in points) + "EOD\n"


def panel(number, axis, ways, with_key):
    """Data and plot of one panel. `ways`: name -> (points of all families, the point that stands for them)."""
    data, faint, strong = [], [], []
    for i, (way, (points, summary)) in enumerate(ways.items()):
        color, mark = STYLES[way]
        # Zeros lie on a strip, spread a little so that they do not hide each other.
        spread = [(x, y if y > 0 else axis.zero * 10 ** (.3 * ((k * .618) % 1 - .5))) for k, (x, y) in enumerate(points)]
        data.append(block(f"all{number}_{i}", spread))
        data.append(block(f"one{number}_{i}", [(summary[0], summary[1] or axis.zero)]))
        faint.append(f"$all{number}_{i} with points pt 7 ps 0.65 lc rgb '#70{color[1:]}' notitle")
        title = f"title '{way}'" if with_key else "notitle"
        strong.append(f"$one{number}_{i} with points pt {mark} ps 2.3 lc rgb '#ffffff' notitle, "
                      f"$one{number}_{i} with points pt {mark} ps 1.7 lc rgb '{color}' {title}")
    return "".join(data) + PANEL.format(axis=axis, curves=", \\\n  ".join(faint + strong))


def points_of(rows, ways, query, error, summarise):
    """For each way its families' (time, error), and the median time with the summarised error."""
    result = {}
    for way in ways:
        points = [(row.nanoseconds, error(row)) for row in tables.of(rows, way, query) if row.nanoseconds > 0]
        if points:
            result[way] = points, (statistics.median(x for x, _ in points), summarise(y for _, y in points))
    return result


def draw_pair(rows, ways, query, share, titles, output):
    shares = points_of(rows, ways, query, share, statistics.mean)
    errors = points_of(rows, ways, query, lambda row: row.ulps_99, statistics.median)
    times = [x for points, _ in shares.values() for x, _ in points]
    run_gnuplot(HEAD.format(output=output, left=min(times) / 1.5, right=max(times) * 1.5,
                            summary="mean share (left), median error (right)") +
                panel(0, SHARE._replace(title=titles[0]), shares, True) +
                panel(1, ULPS._replace(title=titles[1]), errors, False))


def draw_pictures(path, output):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    seconds, errors = ([float(row[name]) for row in rows] for name in ("seconds", "error"))
    script = [f"""
set terminal pngcairo size 760,480 font 'DejaVu Sans,11' background '#ffffff'
set output '{output}'
set logscale xy
set border 3 lc rgb '#808080'
set grid lc rgb '#e4e4e4' lt 1
set tics nomirror scale 0.5 textcolor rgb '#202020'
set xlabel 'seconds'
set ylabel 'root mean square error, of 255'
set title 'Error of a picture against its time, by samples a pixel'
set key top right samplen 2
set xrange [{min(seconds) / 2}:{max(seconds) * 3}]
set yrange [{min(min(errors), ROUNDING) / 1.6}:{max(errors) * 2}]
set arrow 1 from graph 0, first {ROUNDING} to graph 1, first {ROUNDING} nohead dashtype 2 lc rgb '#808080'
set label 1 'what rounding to 8 bits adds' at graph 0.02, first {ROUNDING} offset 0,0.6 textcolor rgb '#606060'
set format x '%g'
set format y '%g'
"""]
    curves = []
    for i, scene in enumerate(dict.fromkeys(row["scene"] for row in rows)):
        color = list(STYLES.values())[(3, 6)[i % 2]][0]
        script.append(block(f"scene{i}", [(row["seconds"], row["error"], row["samples"]) for row in rows
                                          if row["scene"] == scene]))
        curves += [f"$scene{i} using 1:2 with linespoints pt 7 ps 1.2 lw 2 lc rgb '{color}' title '{scene}'",
                   f"$scene{i} using 1:2:3 with labels offset 1.2,0.7 textcolor rgb '{color}' notitle"]
    run_gnuplot("".join(script) + "plot " + ", ".join(curves) + "\n")


def draw(rows, pictures_path, folder):
    """accuracy-ways.png, accuracy-rivals.png and accuracy-pictures.png."""
    draw_pair(rows, tables.WAYS, "lists", lambda row: row.wrong,
              ("Wrong interval lists", "Error of t where the list is right, 99th percentile"),
              os.path.join(folder, "accuracy-ways.png"))
    draw_pair(rows, ("plain", "compensated", "certified", *tables.PROGRAMS), "first", lambda row: row.wrong_clear,
              ("Wrong first hits, edges and silhouettes left out", "Error of t where the hit is right, 99th percentile"),
              os.path.join(folder, "accuracy-rivals.png"))
    draw_pictures(pictures_path, os.path.join(folder, "accuracy-pictures.png"))
