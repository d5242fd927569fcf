# SPDX-License-Identifier: MIT
"""What was measured, as Markdown tables."""
import csv
import statistics

WAYS = ("plain", "Kahan", "shifted", "compensated", "certified", "exact")
PROGRAMS = ("POV-Ray", "Embree")


class Row:
    """One line of the CSV: a way or program on a family."""

    def __init__(self, fields):
        self.family, self.way, self.query = fields["family"], fields["way"], fields["query"]
        self.wrong = int(fields["wrong"]) / max(int(fields["rays"]), 1)
        self.wrong_clear = int(fields["wrong_clear"] or 0) / max(int(fields["clear_rays"] or 0), 1)
        self.ulps_99, self.ulps_most = float(fields["ulps_99"]), float(fields["ulps_most"])
        self.nanoseconds = float(fields["nanoseconds"])


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [Row(fields) for fields in csv.DictReader(file)]


def percent(share):
    return "0" if share == 0 else f"{100 * share:.2g} %" if share < .0995 else f"{100 * share:.0f} %"


def ulps(value):
    return "0" if value == 0 else f"{value:.0f}" if value < 1000 else f"{value:.0e}".replace("e+0", "e").replace("e+", "e")


def time(nanoseconds):
    return f"{nanoseconds:.0f} ns" if nanoseconds < 1000 else f"{nanoseconds / 1000:.1f} µs"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def of(rows, way, query):
    return [row for row in rows if row.way == way and row.query == query]


def summary(rows):
    """A line for each way: medians, means and worst families, of whole lists."""
    lines = []
    for way in WAYS:
        mine = of(rows, way, "lists")
        lines.append([way, time(statistics.median(row.nanoseconds for row in mine)),
                      percent(statistics.mean(row.wrong for row in mine)), percent(max(row.wrong for row in mine)),
                      ulps(statistics.median(row.ulps_99 for row in mine)), ulps(max(row.ulps_99 for row in mine)),
                      ulps(max(row.ulps_most for row in mine))])
    return table(["way", "time a ray, median", "wrong lists, mean", "worst family", "p99 of t in ulps, median",
                  "worst family", "greatest"], lines)


def by_family(rows, query, ways, show):
    names = list(dict.fromkeys(row.family for row in rows if row.way in ways and row.query == query))
    cells = {(row.family, row.way): show(row) for row in rows if row.query == query}
    return table(["family", *ways], [[name, *(cells.get((name, way), "") for way in ways)] for name in names])


def first_hits(rows):
    """POV-Ray and Embree beside three ways, on the families that all of them were asked about."""
    lines = []
    for program in PROGRAMS:
        families = {row.family for row in of(rows, program, "first")}
        if not families:
            continue
        for way in ("plain", "compensated", "certified", program):
            mine = [row for row in of(rows, way, "first") if row.family in families]
            lines.append([f"{len(families)}, with {program}", way, time(statistics.median(r.nanoseconds for r in mine)),
                          percent(statistics.mean(row.wrong for row in mine)),
                          percent(statistics.mean(row.wrong_clear for row in mine)),
                          percent(max(row.wrong_clear for row in mine)),
                          ulps(statistics.median(row.ulps_99 for row in mine))])
    return table(["families", "way", "time a ray, median", "wrong hits, mean", "of clear rays, mean",
                  "of clear rays, worst family", "p99 of t in ulps, median"], lines)


def pictures(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return table(["scene", "samples a pixel", "seconds", "error, of 255"],
                 [[row["scene"], row["samples"], f"{float(row['seconds']):.3g}", f"{float(row['error']):.3g}"]
                  for row in rows])


def everything(rows, pictures_path):
    return "\n".join([
        "Ways of computing, whole lists:\n", summary(rows),
        "First hits, beside other programs:\n", first_hits(rows),
        "Wrong lists, by family:\n", by_family(rows, "lists", WAYS, lambda row: percent(row.wrong)),
        "p99 / greatest error of t in ulps on right lists, by family:\n",
        by_family(rows, "lists", WAYS, lambda row: f"{ulps(row.ulps_99)} / {ulps(row.ulps_most)}"),
        "Time a ray for its whole list, by family:\n", by_family(rows, "lists", WAYS, lambda row: time(row.nanoseconds)),
        "Wrong first hits of other programs, of all rays / of clear ones, by family:\n",
        by_family(rows, "first", ("certified", *PROGRAMS), lambda row: f"{percent(row.wrong)} / {percent(row.wrong_clear)}"),
        f"Pictures against 4,096 samples a pixel:\n", pictures(pictures_path)])
