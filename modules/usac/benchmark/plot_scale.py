#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Draws the results that `scale.py --csv=FILE` has written: time and error over the number of matches
and over the inlier ratio, with a column of diagrams for each problem. A cross marks a point at which at
least half of the runs failed. A curve ends where the method exceeded the time limit of scale.py."""

import argparse
import math
import sys

import plot  # must be first: it selects matplotlib's backend
from matplotlib.ticker import LogFormatterMathtext
from plot import plt
from rows import read_rows

SWEEPS = {"size": "matches", "inliers": "fraction of right matches"}
COLUMNS = ("sweep", "problem", "size", "inliers", "method", "median_cpu_ms", "median_wall_ms", "median_error", "failures_percent")


def _add(results, row):
    if row["sweep"] not in SWEEPS or row["problem"] not in plot.TITLES:
        raise ValueError
    point = {name: float(row[name]) for name in COLUMNS if name not in ("sweep", "problem", "method")}
    results.setdefault((row["sweep"], row["problem"]), {}).setdefault(row["method"], []).append(point)


def read_scale(file, methods=()):
    """Returns {(sweep, problem): {method: [point, ...]}}. A sweep is a key of SWEEPS; a point is a row
    of the file as {column: number}. `methods` selects methods and their order; an empty list selects
    all."""
    results = {}
    read_rows(file, COLUMNS, "scale.py --csv", lambda row: _add(results, row))
    results = plot.choose(results, methods)
    if not any(results.values()):
        raise ValueError(file + ": no results" + (" of the methods asked for" if methods else ""))
    return results


def split_failed(points, x, y):
    """Returns two lists of (x, y): for the curve, the points whose y is finite and above 0; for the
    crosses, the points of the curve at which at least half of the runs failed."""
    finite = [(p[x], p[y], p["failures_percent"] >= 50) for p in points if math.isfinite(p[y]) and p[y] > 0]
    return [p[:2] for p in finite], [p[:2] for p in finite if p[2]]


def _panel(axes, runs, sweep, y, look):
    for method, points in runs.items():
        curve, failed = split_failed(points, sweep, y)
        style = look.line(method)
        if curve:
            axes.plot(*zip(*curve), marker=".", markersize=4, **style)
        if failed:
            axes.plot(*zip(*failed), linestyle="", marker="x", markersize=6, color=style["color"], zorder=style["zorder"])
    for axis in (axes.xaxis, axes.yaxis):
        plot.log_axis(axis)
        plot.thin(axis, *axis.get_view_interval())
    if sweep == "inliers":
        axes.invert_xaxis()  # lower inlier ratios on the right, so that problems become harder to the right, as for the size
    else:
        axes.xaxis.set_major_formatter(LogFormatterMathtext())
    axes.set_xlabel(SWEEPS[sweep])


def draw(results, look, y, label):
    """Draws a figure with a row of diagrams for each sweep and a column for each problem. `y` is the
    column of the file for the vertical axis, `label` the label of this axis."""
    sweeps = [s for s in SWEEPS if any(key[0] == s for key in results)]
    problems = [p for p in plot.TITLES if any(key[1] == p for key in results)]
    figure, panels = plt.subplots(len(sweeps), len(problems), figsize=(max(3.1 * len(problems) + 0.6, 4.8), 2.9 * len(sweeps) + 0.5),
                                  layout="constrained", sharey="row", squeeze=False)
    for row, sweep in zip(panels, sweeps):
        for axes, problem in zip(row, problems):
            _panel(axes, results.get((sweep, problem), {}), sweep, y, look)
        row[0].set_ylabel(label)
    for axes, problem in zip(panels[0], problems):
        axes.set_title(plot.TITLES[problem])
    look.legend(figure, look.methods)
    return figure


def draw_all(results, folder, form, time):
    """Writes the pictures of time and error; returns their paths."""
    with plt.rc_context(plot.STYLE):
        look = plot.Look(results)
        return [plot.save(draw(results, look, "median_%s_ms" % time, "median " + plot.time_label(time)), folder, "scale_time", form),
                plot.save(draw(results, look, "median_error", "median error, pixels"), folder, "scale_error", form)]


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", metavar="FILE", help="file that scale.py --csv has written")
    plot.add_options(parser)
    args = parser.parse_args(arguments)
    return plot.run(lambda: draw_all(read_scale(args.csv, args.method or []), args.out, args.format, args.time))


if __name__ == "__main__":
    sys.exit(main())
