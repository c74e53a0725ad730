#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Measures how much larger the errors of a method become if the threshold is too wide. The program
usac_benchmark runs on the same lists with multiples of the right threshold, and the median errors are
compared.

With --estimated, a method is measured that estimates the threshold, such as USACV20_AUTO. It gets a
multiple of the right threshold as the upper limit of its estimate. For each list, its error is compared
with that of USACV20 with the best of several given thresholds.

The tables go to the standard output, in Markdown."""

import argparse
import csv
import glob
import math
import os
import subprocess
import sys
import tempfile

import pairs

# The right thresholds, which are the defaults of usac_benchmark: in pixels, for R and M in the unit of
# the points.
RIGHT = {"H": 2.0, "F": 1.0, "E": 1.0, "A": 3.0, "S": 3.0, "P": 4.0, "R": 3.0, "M": 3.0, "T": 3.0}
METHODS = "USACV20_MAGSAC,USACV20,cv:USAC_MAGSAC"
FAR, MOST = 1.15, 30  # ratios of errors: lists with a ratio above FAR are counted; ratios above MOST are replaced by MOST
# With --estimated, multiples of the right threshold: the given thresholds, and the upper limits of the
# estimated threshold.
GIVEN, LARGEST = (0.25, 0.5, 1, 2, 4), (3, 10)


def find_lists(folders, files):
    """Returns the files with lists of pairs as {problem: [file, ...]}, in the order of RIGHT."""
    found = list(files)
    for folder in folders:
        found += sorted(glob.glob(os.path.join(folder, "lists", "*.[HFEASPRMT].list")))
    by_problem = {problem: [f for f in found if pairs.split_name(f)[1] == problem] for problem in RIGHT}
    return {problem: lists for problem, lists in by_problem.items() if lists}


def read_rows(file):
    """Returns {(list, method): row} of a file that usac_benchmark --csv has written, without the rows of
    averages."""
    with open(file, newline="") as lines:
        return {(row["list"], row["method"]): row for row in csv.DictReader(lines)
                if row["list"] != "average" and not row["list"].startswith("average.")}


def read_errors(file):
    """Returns {(list, method): median error} of a file that usac_benchmark --csv has written."""
    return {key: float(row["median_error"]) for key, row in read_rows(file).items()}


def measure(program, lists, problem, factor, methods, more, read=read_errors):
    """Runs usac_benchmark with a multiple of the right threshold; returns read(file) for the file that
    usac_benchmark writes with --csv."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "tables.csv")
        command = [program] + ["--list=" + name for name in lists] + more + [
            "--methods=" + methods, "--threshold=%g" % (factor * RIGHT[problem]), "--csv=" + file]
        done = subprocess.run(command, stdout=subprocess.DEVNULL)
        if done.returncode not in (0, 2):  # 2: some pairs could not be read; usac_benchmark has printed messages about them
            raise ValueError("%s: exit code %d" % (program, done.returncode))
        return read(file)


class Ratios:
    """For each list, the ratio of a method's median error with a wide threshold to that with the right
    threshold. The median error is infinite if at least half of the runs fail. Lists on which one of
    these errors is infinite or 0 are left out. A list on which the error is infinite only with the wide
    threshold counts as broken."""

    def __init__(self, right, wide):
        self.values = [w / r for r, w in zip(right, wide) if math.isfinite(r) and math.isfinite(w) and r > 0 and w > 0]
        self.broken = sum(math.isfinite(r) and not math.isfinite(w) for r, w in zip(right, wide))

    def mean(self):
        """Returns the geometric mean of the ratios; NaN if there are none."""
        return math.exp(sum(map(math.log, self.values)) / len(self.values)) if self.values else math.nan

    def __str__(self):
        return "%.3f (%d%s)" % (self.mean(), len(self.values), ", %d broken" % self.broken if self.broken else "")


def print_lists(errors, factors, methods, out):
    """Prints all errors. `errors` is {(problem, list): {method: [error for each factor]}}."""
    print("\n## Median error, pixels, at %s times the right threshold\n" % ", ".join("%g" % f for f in factors), file=out)
    print("| list | %s |\n|---|%s" % (" | ".join(methods), "---|" * len(methods)), file=out)
    for (problem, name), row in errors.items():
        cells = [" / ".join("%.3f" % e for e in row[m]) if m in row else "-" for m in methods]
        print("| %s %s | %s |" % (problem, name, " | ".join(cells)), file=out)


def print_ratios(errors, factors, methods, out):
    print("\n## Error over that with the right threshold\n\nRatio of the median errors, geometric mean over lists. In brackets: "
          "the number of these lists and, if there are any, of broken lists (at least half of the runs fail, but not with the "
          "right threshold).\n", file=out)
    print("| threshold | problem | %s |\n|---|---|%s" % (" | ".join(methods), "---|" * len(methods)), file=out)
    problems = [p for p in RIGHT if any(key[0] == p for key in errors)]
    for k, factor in enumerate(factors[1:], 1):
        for chosen in [[p] for p in problems] + ([problems] if len(problems) > 1 else []):
            cells = []
            for method in methods:
                rows = [row[method] for key, row in errors.items() if key[0] in chosen and method in row]
                cells.append(str(Ratios([row[0] for row in rows], [row[k] for row in rows])))
            print("| x %g | %s | %s |" % (factor / factors[0], ", ".join(chosen), " | ".join(cells)), file=out)


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def ratios_to(best, rows):
    """Returns the ratios of the median errors in `rows`, {list: row}, to those in `best`, {list:
    smallest median error with any of the thresholds GIVEN}; ratios above MOST are replaced by MOST."""
    return [min(float(row["median_error"]) / best[key], MOST) for key, row in rows.items()]


def estimated_row(problem, name, rows, best, usual):
    """Returns a row of the table of --estimated. `rows`, `best`: see ratios_to. `usual` has the rows of
    USACV20 with the right threshold, {list: row}."""
    ratios = ratios_to(best, rows)
    aucs = [float(row["auc10"]) for row in rows.values() if row.get("auc10")]
    times = [float(row["mean_cpu_ms"]) / float(usual[key]["mean_cpu_ms"]) for key, row in rows.items()]
    return "| %s | %s | %.3f | %d | %.1f | %s | %.2f |" % (
        problem, name, geometric_mean(ratios), sum(r > FAR for r in ratios),
        sum(float(row["failures_percent"]) for row in rows.values()) / len(rows),
        "%.1f" % (sum(aucs) / len(aucs)) if len(aucs) == len(rows) else "-", geometric_mean(times))


def draw(curves, file):
    """Draws `curves`, which is {problem: {"given" or "estimated": {factor of the right threshold:
    ratio of errors}}}."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, len(curves), figsize=(3.2 * len(curves), 2.8), sharey=True, squeeze=False)
    for axis, (problem, lines) in zip(axes[0], curves.items()):
        for name, style in (("given", "o-"), ("estimated", "s--")):
            axis.plot(list(lines[name]), list(lines[name].values()), style, label="USACV20" if name == "given" else "USACV20_AUTO")
        axis.set(xscale="log", yscale="log", title=problem, xlabel="(largest) threshold / right threshold",
                 xticks=[0.25, 1, 3, 10], yticks=[1, 1.2, 1.5, 2, 3])
        axis.set_xticklabels(["1/4", "1", "3", "10"])
        axis.set_yticklabels(["1", "1.2", "1.5", "2", "3"])
        axis.minorticks_off()
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("error / that of the best threshold")
    axes[0][-1].legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(file, dpi=110, metadata={"Software": None})


def print_estimated(args, lists, more, out):
    curves = {}
    print("\n| problem | threshold | error over that of the best given one | lists above %g | failures, %% | AUC at 10 degrees "
          "| mean CPU |\n|---|---|---:|---:|---:|---:|---:|" % FAR, file=out)
    for problem, files in lists.items():
        def rows(factor, method):
            found = measure(args.program, files, problem, factor, method, more, read_rows)
            return {name: row for (name, _), row in found.items()}
        given = {factor: rows(factor, "USACV20") for factor in GIVEN}
        best = {name: min(float(table[name]["median_error"]) for table in given.values()) for name in given[1]}
        for factor, table in given.items():
            print(estimated_row(problem, "given, x %g" % factor, table, best, given[1]), file=out)
        estimated = {factor: rows(factor, args.estimated) for factor in LARGEST}
        for factor, table in estimated.items():
            print(estimated_row(problem, "estimated, at most x %g" % factor, table, best, given[1]), file=out)
        curves[problem] = {name: {factor: geometric_mean(ratios_to(best, table)) for factor, table in tables.items()}
                           for name, tables in (("given", given), ("estimated", estimated))}
    if args.plot:
        draw(curves, args.plot)


def run(args, out):
    lists = find_lists(args.data or [], args.list or [])
    if not lists:
        raise ValueError("no lists: give --list or --data")
    factors = [float(f) for f in args.factors.split(",")]
    if len(factors) < 2 or min(factors) <= 0:
        raise ValueError("--factors: expected at least two numbers above 0")
    more = ["--repeats=%d" % args.repeats, "--seed=%d" % args.seed]
    if args.estimated:
        print_estimated(args, lists, more, out)
        return
    errors = {}
    for problem, files in lists.items():
        for factor in factors:
            for (name, method), error in measure(args.program, files, problem, factor, args.methods, more).items():
                errors.setdefault((problem, name), {}).setdefault(method, []).append(error)
    methods = list(dict.fromkeys(m for row in errors.values() for m in row))
    print("# Sensitivity to the threshold\n\n%d repeats, seed %d; right thresholds: H 2 px, F and E 1 px%s%s%s." %
          (args.repeats, args.seed, ", A, S and T 3 px" if set(lists) & set("AST") else "",
           ", P 4 px (errors in degrees)" if "P" in lists else "",
           ", R and M 3 (errors in degrees)" if set(lists) & set("RM") else ""), file=out)
    print_lists(errors, factors, methods, out)
    print_ratios(errors, factors, methods, out)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="usac_benchmark", metavar="FILE",
                        help="path of usac_benchmark, needed if it is not on the PATH")
    parser.add_argument("--data", action="append", metavar="DIR", help="folder of data; may be repeated")
    parser.add_argument("--list", action="append", metavar="FILE", help="list of pairs; may be repeated")
    parser.add_argument("--methods", default=METHODS, help="methods, as for usac_benchmark (default: %(default)s)")
    parser.add_argument("--factors", default="1,2,4",
                        help="factors of the right threshold; errors are compared with those for the first factor (default: "
                             "%(default)s)")
    parser.add_argument("--estimated", metavar="METHOD",
                        help="method that estimates the threshold, such as USACV20_AUTO; --methods and --factors then have no "
                             "effect")
    parser.add_argument("--plot", metavar="FILE", help="draw the result of --estimated (needs matplotlib)")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args(arguments)
    try:
        run(args, sys.stdout)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
