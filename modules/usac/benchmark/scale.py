#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Measures how the time of robust estimators grows with the number of matches and with the fraction of
wrong ones: runs usac_benchmark on scenes of usac_synthetic (`planar` for H, `general` for F and E). The
tables go to the standard output, in Markdown; plot_scale.py draws the file of --csv."""

import argparse
import csv
import os
import subprocess
import sys
import tempfile

import figure_tables

METHODS = ("USACV20", "USACV20_FAST", "cv:USAC_FAST", "cv:USAC_MAGSAC")
SIZES = (50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000)
PARTS = (0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.07, 0.05)
FIGURES = ("median_cpu_ms", "median_wall_ms", "median_error", "failures_percent", "median_iterations")


def measure(args, problem, size, part, methods):
    """Returns {method: row of usac_benchmark's table} for scenes of one kind."""
    with tempfile.TemporaryDirectory() as folder:
        table = os.path.join(folder, "table.csv")
        subprocess.run([os.path.join(os.path.dirname(args.program), "usac_synthetic"), "--out=" + folder, "--name=scale",
                        "--scene=" + ("planar" if problem == "H" else "general"), "--pairs=%d" % args.repeats, "--size=%d" % size,
                        "--inliers=%g" % part, "--noise=%g" % args.noise, "--seed=%d" % args.seed], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([args.program, "--list=%s" % os.path.join(folder, "lists", "scale.%s.list" % problem), "--repeats=1", "--csv=" + table,
                        "--threads=%d" % args.threads] + ["--methods=" + m for m in methods], check=True, stdout=subprocess.DEVNULL)
        with open(table, newline="") as lines:
            return {row["method"]: row for row in csv.DictReader(lines) if row["list"] == "scale"}


def cell(row):
    return "%.3g / %.3g / %.0f" % tuple(float(row[c]) for c in ("median_cpu_ms", "median_error", "failures_percent")) if row else "-"


def sweep(args, name, problem, points, rows):
    """Measures all methods at `points`, [(size, part), ...], the hardest last; appends rows of the CSV
    file to `rows` and returns the rows of the table. A method whose median call exceeds the limit is
    not run at the following points."""
    active, table = list(args.methods), []
    for size, part in points:
        found = measure(args, problem, size, part, active) if active else {}
        rows += [[name, problem, size, part, m, args.repeats] + [row[f] for f in FIGURES] for m, row in found.items()]
        table.append(["%g" % part if name == "inliers" else "%d" % size] + [cell(found.get(m)) for m in args.methods])
        active = [m for m in active if m in found and float(found[m]["median_cpu_ms"]) <= args.limit]
    return table


def run(args):
    if min(args.sizes) < 1 or args.size < 1 or args.repeats < 1:
        raise ValueError("--sizes, --size, --repeats: expected numbers above 0")
    if not all(0 < part <= 1 for part in args.parts + [args.part]):
        raise ValueError("--parts, --part: expected numbers above 0 up to 1")
    print("# Scale\n\nSynthetic scenes, noise %g px, %d of each kind, seed %d, threads %d.\n\nEntries: median CPU time of a call, ms / median "
          "error, px / failures, %%; -: not run, because the median call on easier scenes took more than %g ms." %
          (args.noise, args.repeats, args.seed, args.threads, args.limit))
    rows = []
    for problem in args.problems:
        for name, title, first, points in (
                ("size", "number of matches, part of right ones %g" % args.part, "matches", [(n, args.part) for n in sorted(args.sizes)]),
                ("inliers", "part of right matches, %d matches" % args.size, "right",
                 [(args.size, p) for p in sorted(args.parts, reverse=True)])):
            table = sweep(args, name, problem, points, rows)
            print("\n## %s: time over the %s\n\n%s" % (problem, title, figure_tables.markdown([first] + args.methods, table, True)), flush=True)
    if args.csv:
        with open(args.csv, "w", newline="") as out:
            csv.writer(out, lineterminator="\n").writerows([("sweep", "problem", "size", "inliers", "method", "runs") + FIGURES] + rows)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="usac_benchmark", metavar="FILE",
                        help="path of usac_benchmark, with usac_synthetic in the same folder; needed if they are not on the PATH")
    parser.add_argument("--problems", default="HFE", metavar="LETTERS", help="some of H, F and E (default: %(default)s)")
    parser.add_argument("--methods", nargs="+", default=list(METHODS), metavar="NAME", help="as for usac_benchmark")
    parser.add_argument("--sizes", nargs="+", type=int, default=list(SIZES), help="numbers of matches, of which --part are right")
    parser.add_argument("--parts", nargs="+", type=float, default=list(PARTS), help="fractions of right matches among --size")
    parser.add_argument("--size", type=int, default=2000)
    parser.add_argument("--part", type=float, default=0.5)
    parser.add_argument("--noise", type=float, default=0.5, help="standard deviation of each coordinate, pixels (default: %(default)s)")
    parser.add_argument("--repeats", type=int, default=9, help="scenes of each kind (default: %(default)s)")
    parser.add_argument("--limit", type=float, default=2000,
                        help="milliseconds; a method whose median call takes longer is not run on harder scenes (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--csv", metavar="FILE")
    args = parser.parse_args(arguments)
    if set(args.problems) - set("HFE"):
        parser.error("--problems: expected letters of HFE")
    try:
        run(args)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
