#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Draws the runs that `usac_benchmark --runs=FILE` has written.

For each list there is a picture of the cumulative distributions of error and of time, with one curve
for each method. The error of a failed run is not drawn, so a curve of errors ends at the fraction of
successful runs. Two more pictures show all lists: error over time, and a summary of the
distributions."""

import argparse
import math
import os
import sys

try:
    import matplotlib
except ImportError:
    if os.path.basename(sys.argv[0]) not in ("plot.py", "plot_scale.py"):
        raise
    sys.exit("matplotlib was not found; the plots need it (Debian: python3-matplotlib)")
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, PercentFormatter
import numpy as np

from rows import read_rows

# Colors of Okabe and Ito, which color-blind people can distinguish. The number of markers has no common
# divisor with the number of colors, and the line style changes each time the colors start again, so
# that different methods have different combinations.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9")
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*", "<", ">", "h")
TITLES = {"H": "homography", "F": "fundamental matrix", "E": "essential matrix", "A": "affinity",
          "S": "similarity", "P": "absolute pose", "R": "rigid motion", "M": "rigid motion and scale", "T": "translation"}
DEGREES = ("P", "R", "M")  # problems whose error is an angle
COLUMNS = ("list", "problem", "pair", "method", "error", "failed", "cpu_ms", "wall_ms")
STYLE = {"font.size": 9, "axes.titlesize": 10, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
         "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.edgecolor": "#666666", "axes.axisbelow": True,
         "lines.linewidth": 1.6, "legend.frameon": False, "svg.hashsalt": "usac_benchmark"}


class Runs:
    """The runs of one method on one list. The error of a failed run is infinity; times are in
    milliseconds."""

    def __init__(self):
        self.errors, self.times, self.pairs = [], [], []

    def median_error(self):
        return float(np.median(self.errors))

    def median_time(self):
        """Returns the median over the pairs of the median over the repeats of a pair, in milliseconds,
        as in the tables of usac_benchmark."""
        of_pair = {}
        for pair, time in zip(self.pairs, self.times):
            of_pair.setdefault(pair, []).append(time)
        return float(np.median([np.median(times) for times in of_pair.values()]))

    def failures(self):
        return float(np.mean(np.isinf(self.errors)))


def choose(results, methods):
    """Returns `results`, {key: {method: ...}}, with only the given methods in the given order; with all
    methods if the list of methods is empty."""
    if not methods:
        return results
    return {key: {m: runs[m] for m in methods if m in runs} for key, runs in results.items()}


def read_runs(files, time, methods):
    """Returns {(list, problem): {method: Runs}} in the order of the files. `time` is "cpu" or "wall".
    `methods` selects methods and their order; an empty list selects all."""
    results = {}
    for file in files:
        read_rows(file, COLUMNS, "usac_benchmark --runs", lambda row: _add(results, row, time, methods))
    if not results:
        raise ValueError(", ".join(files) + ": no runs" + (" of the methods asked for" if methods else ""))
    return choose(results, methods)


def _add(results, row, time, methods):
    values = float(row["error"]), float(row[time + "_ms"]), int(row["failed"])
    if methods and row["method"] not in methods:
        return
    runs = results.setdefault((row["list"], row["problem"]), {}).setdefault(row["method"], Runs())
    runs.errors.append(math.inf if values[2] else values[0])
    runs.times.append(max(values[1], 1e-4))  # milliseconds; zero cannot be shown on a logarithmic axis
    runs.pairs.append(row["pair"])


class Look:
    """Color, line style and marker of each method, which are the same in all pictures. Methods of
    OpenCV have dashed or dotted lines and hollow markers."""

    def __init__(self, results):
        self.methods = list(dict.fromkeys(m for runs in results.values() for m in runs))

    def line(self, method):
        i = self.methods.index(method)
        dashes = ["--", ":", "-."] if method.startswith("cv:") else ["-", (0, (7, 1.2)), (0, (5, 1, 1, 1))]
        return {"color": COLORS[i % len(COLORS)], "linestyle": dashes[i // len(COLORS) % len(dashes)],
                "zorder": 3 - i / len(self.methods)}  # the first method is drawn on top

    def marker(self, method):
        i = self.methods.index(method)
        color = COLORS[i % len(COLORS)]
        return {"color": color, "marker": MARKERS[i % len(MARKERS)],
                "markerfacecolor": "none" if method.startswith("cv:") else color, "linestyle": ""}

    def legend(self, figure, methods, markers=False):
        styles = [dict(self.line(m), **(dict(self.marker(m), linestyle="") if markers else {})) for m in methods]
        handles = [Line2D([], [], label=m, **style) for m, style in zip(methods, styles)]
        width, height = figure.get_size_inches()
        columns = max(1, min(len(handles), int(width // (0.8 + 0.075 * max(len(m) for m in methods)))))
        rows = -(-len(handles) // columns)
        columns = -(-len(handles) // rows)  # spreads the entries evenly over the columns
        room = (0.18 * rows + 0.12) / height
        figure.get_layout_engine().set(rect=(0, room, 1, 1 - room))
        figure.legend(handles=handles, loc="lower center", ncol=columns, handlelength=2.4, columnspacing=1.4, fontsize=8.5,
                      borderaxespad=0.2, labelspacing=0.25)


def cumulative(values, weights=None):
    """Returns the steps of the cumulative distribution: the sorted values, and for each value the
    fraction (of the total weight, if there are weights) of all values up to it. Infinite values have no
    step but count in the total, so the last fraction can be below 1."""
    values = np.asarray(values, float)
    weights = np.full(len(values), 1 / len(values)) if weights is None else np.asarray(weights, float)
    order = np.argsort(values, kind="stable")
    shares = np.cumsum(weights[order])
    finite = np.isfinite(values[order])
    return values[order][finite], shares[finite]


def _curve(axes, values, weights, right, style):
    x, y = cumulative(values, weights)
    if len(x):
        axes.step(np.concatenate((x[:1], x, [max(right, x[-1])])), np.concatenate(([0], y, y[-1:])), where="post", **style)


def _number(value, _=None):
    return "%g" % value


def log_axis(axis):
    axis.axes.set(**{axis.axis_name + "scale": "log"})
    axis.set_major_locator(LogLocator(10, subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(_number))
    axis.set_minor_formatter(NullFormatter())


def thin(axis, low, high):
    """Keeps only the labels at powers of ten if a logarithmic axis spans more than 1.7 decades."""
    if math.log10(max(high / max(low, 1e-9), 1)) > 1.7:
        axis.set_major_locator(LogLocator(10))


def _distribution(axes, samples, look, xlabel):
    """Draws the distributions of `samples`, {method: (values, weights)}, over a logarithmic axis."""
    finite = np.concatenate([np.asarray(v, float)[np.isfinite(v)] for v, _ in samples.values()] + [np.empty(0)])
    finite = finite[finite > 0]
    low, high = (np.percentile(finite, 0.5), finite.max()) if len(finite) else (0.1, 10)
    low, high = low / 1.1, max(high, low * 2) * 1.1
    for method, (values, weights) in samples.items():
        _curve(axes, values, weights, high, look.line(method))
    log_axis(axes.xaxis)
    thin(axes.xaxis, low, high)
    axes.set_xlim(low, high)
    axes.set_ylim(0, 1.02)
    axes.yaxis.set_major_formatter(PercentFormatter(1))
    axes.set_xlabel(xlabel)


def error_label(problem):
    return "error of the rotation, degrees" if problem in DEGREES else "error, pixels"


def time_label(time):
    return "%s time of a run, ms" % ("CPU" if time == "cpu" else "wall")


def draw_list(name, problem, runs, look, time):
    """Draws the distributions of error and time of a list side by side."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.5), layout="constrained", sharey=True)
    pairs = len({pair for r in runs.values() for pair in r.pairs})
    figure.suptitle("%s: %s, %d pairs" % (name, TITLES.get(problem, problem), pairs), fontsize=10.5)
    _distribution(left, {m: (r.errors, None) for m, r in runs.items()}, look, error_label(problem))
    _distribution(right, {m: (r.times, None) for m, r in runs.items()}, look, time_label(time))
    left.set_ylabel("runs")
    look.legend(figure, list(runs))
    return figure


def _problems(results):
    return [p for p in TITLES if any(key[1] == p for key in results)]


def geometric_mean(values):
    return float(np.exp(np.mean(np.log(values)))) if len(values) else math.nan


def draw_scatter(results, look, time):
    """Draws the median error over the median time. Small markers show single lists. Large markers show
    geometric means over the lists on which all methods succeed in more than half of the runs."""
    problems = _problems(results)
    figure, panels = plt.subplots(1, len(problems), figsize=(max(3.4 * len(problems) + 0.8, 4.8), 3.9), layout="constrained",
                                  squeeze=False)
    for axes, problem in zip(panels[0], problems):
        lists = [runs for key, runs in results.items() if key[1] == problem]
        solved = [runs for runs in lists if all(math.isfinite(r.median_error()) for r in runs.values())]
        for method in look.methods:
            style = look.marker(method)
            _scatter(axes, [r[method] for r in lists if method in r], dict(style, markersize=3.5, alpha=0.45, markeredgewidth=0.7))
            good = [r[method] for r in solved if method in r]
            if good:
                axes.plot(geometric_mean([r.median_time() for r in good]), geometric_mean([r.median_error() for r in good]),
                          markersize=8, markeredgewidth=1.7, zorder=3, **style)
        for axis in (axes.xaxis, axes.yaxis):
            log_axis(axis)
            thin(axis, *axis.get_view_interval())
        axes.set_title("%s, %d of %d lists" % (TITLES[problem], len(solved), len(lists)))
        axes.set_xlabel("median " + time_label(time))
        if axes is panels[0][0] or problem in DEGREES:
            axes.set_ylabel("median " + error_label(problem))
    look.legend(figure, look.methods, markers=True)
    return figure


def _scatter(axes, runs, style):
    points = [(r.median_time(), r.median_error()) for r in runs if math.isfinite(r.median_error()) and r.median_error() > 0]
    if points:
        axes.plot(*zip(*points), **style)


def _pooled(results, problem, look, what):
    """Returns {method: (values, weights)} of all runs on the lists of a problem. `what`, "errors" or
    "times", selects the values. Each list has the same total weight."""
    samples = {}
    for method in look.methods:
        parts = [getattr(runs[method], what) for key, runs in results.items() if key[1] == problem and method in runs]
        if parts:
            weights = np.concatenate([np.full(len(p), 1 / len(p) / len(parts)) for p in parts])
            samples[method] = (np.concatenate(parts), weights)
    return samples


def draw_summary(results, look, time):
    """Draws distributions of error (above) and time (below), with a column for each problem. All lists
    of a problem are pooled with equal weights."""
    problems = _problems(results)
    figure, panels = plt.subplots(2, len(problems), figsize=(max(2.9 * len(problems) + 0.7, 4.8), 4.9), layout="constrained",
                                  sharey=True, squeeze=False)
    for column, problem in enumerate(problems):
        lists = sum(key[1] == problem for key in results)
        panels[0][column].set_title("%s, %d lists" % (TITLES[problem], lists))
        _distribution(panels[0][column], _pooled(results, problem, look, "errors"), look, error_label(problem))
        _distribution(panels[1][column], _pooled(results, problem, look, "times"), look, time_label(time))
    for row in panels:
        row[0].set_ylabel("runs")
    look.legend(figure, look.methods)
    return figure


def save(figure, folder, name, form):
    os.makedirs(folder, exist_ok=True)
    file = os.path.join(folder, name + "." + form)
    # The date (SVG) and the version of matplotlib (PNG) are left out, so that the same runs give the
    # same file.
    figure.savefig(file, dpi=110, metadata={"Date": None} if form == "svg" else {"Software": None})
    plt.close(figure)
    return file


def draw_all(results, folder, form, time):
    """Writes all pictures; returns their paths."""
    with plt.rc_context(STYLE):
        look = Look(results)
        files = [save(draw_list(name, problem, runs, look, time), folder, "%s.%s" % (name, problem), form)
                 for (name, problem), runs in results.items()]
        files.append(save(draw_scatter(results, look, time), folder, "accuracy_over_time", form))
        files.append(save(draw_summary(results, look, time), folder, "summary", form))
    return files


def add_options(parser):
    """Adds the options that all drawing programs share."""
    parser.add_argument("--out", required=True, metavar="DIR", help="folder for the pictures")
    parser.add_argument("--format", choices=("png", "svg"), default="png")
    parser.add_argument("--time", choices=("cpu", "wall"), default="cpu",
                        help="processor time or wall time of a run (default: cpu)")
    parser.add_argument("--method", action="append", metavar="NAME",
                        help="draw only this method; may be repeated; the legend has the methods in this order")


def run(draw):
    """Prints the paths that draw() returns, or the message of its exception; returns the exit code."""
    try:
        for file in draw():
            print(file)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="FILE",
                        help="file that usac_benchmark --runs has written; several files are taken together")
    add_options(parser)
    args = parser.parse_args(arguments)
    return run(lambda: draw_all(read_runs(args.runs, args.time, args.method or []), args.out, args.format, args.time))


if __name__ == "__main__":
    sys.exit(main())
