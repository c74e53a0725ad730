#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Compares methods pair by pair, from the files that `usac_benchmark --runs=FILE` has written.

The median over a list of few pairs is the error on one of these pairs, whereas a comparison pair by
pair uses all pairs. The error of a method on a pair is the median over its runs; it is infinite if at
least half of the runs fail. The table goes to the standard output, in Markdown. For each list it has:

- the ratio of the errors of the first method to those of another method, as a geometric mean over the
  pairs on which both errors are finite and above 0, with a 95 % interval (bootstrap over these pairs);
- the numbers of pairs on which the first method is better and worse: its error differs by more than
  2 %, or is finite for only one of the two methods;
- the number of pairs on which the first method is worse although its model has the lower cost. A
  better search would not help there."""

import argparse
import math
import random
import statistics
import sys

from rows import read_rows

COLUMNS = ("list", "problem", "pair", "method", "error", "failed", "cost")
SAME = 0.02  # relative difference of errors below which neither method is better


class Pair:
    """The runs of one method on one pair."""

    def __init__(self):
        self.errors, self.costs = [], []

    def error(self):
        return statistics.median(self.errors)

    def cost(self):
        return statistics.median(self.costs)


def read_pairs(files):
    """Returns {(problem, list): {pair: {method: Pair}}} in the order of the files. The error of a
    failed run is infinite."""
    results = {}
    for file in files:
        read_rows(file, COLUMNS, "usac_benchmark --runs", lambda row: _add(results, row))
    return results


def _add(results, row):
    error, cost, failed = float(row["error"]), float(row["cost"]), int(row["failed"])
    pair = results.setdefault((row["problem"], row["list"]), {}).setdefault(row["pair"], {}).setdefault(row["method"], Pair())
    pair.errors.append(math.inf if failed else error)
    pair.costs.append(cost)


class Comparison:
    """Compares `method` with `other` on those pairs of a list on which both methods were run."""

    def __init__(self, pairs, method, other):
        both = [(p[method], p[other]) for p in pairs.values() if method in p and other in p]
        self.pairs = len(both)
        errors = [(a.error(), b.error(), a.cost() < b.cost()) for a, b in both]
        self.logs = [math.log(a / b) for a, b, _ in errors if math.isfinite(a) and math.isfinite(b) and a > 0 and b > 0]
        self.better = sum(a < b * (1 - SAME) for a, b, _ in errors)
        worse = [cheaper for a, b, cheaper in errors if b < a * (1 - SAME)]
        self.worse, self.cheaper = len(worse), sum(worse)

    def ratio(self):
        return math.exp(statistics.fmean(self.logs)) if self.logs else math.nan

    def interval(self, draws=2000):
        """Returns the 95 % bootstrap interval of the ratio; NaN with fewer than two pairs. The random
        seed is fixed, so the same runs give the same interval."""
        if len(self.logs) < 2:
            return math.nan, math.nan
        chance = random.Random(1)
        means = sorted(statistics.fmean(chance.choices(self.logs, k=len(self.logs))) for _ in range(draws))
        return math.exp(means[int(0.025 * draws)]), math.exp(means[int(0.975 * draws)])

    def __str__(self):
        return "%.2f (%.2f .. %.2f), %d : %d, %d" % ((self.ratio(),) + self.interval() + (self.better, self.worse, self.cheaper))


def print_table(results, method, others, out):
    print("# `%s` pair by pair\n\nRatio of its error to that of the other method, geometric mean over pairs (95 %% interval); "
          "numbers of pairs on which it is better : worse; number of the latter on which its model has the lower "
          "cost.\n" % method, file=out)
    print("| list | pairs | %s |\n|---|---|%s" % (" | ".join("`%s`" % o for o in others), "---|" * len(others)), file=out)
    for (problem, name), pairs in results.items():
        comparisons = [Comparison(pairs, method, other) for other in others]
        if any(c.pairs for c in comparisons):
            cells = [str(c) if c.pairs else "-" for c in comparisons]
            print("| %s %s | %d | %s |" % (problem, name, max(c.pairs for c in comparisons), " | ".join(cells)), file=out)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="FILE",
                        help="file that usac_benchmark --runs has written; several files are taken together")
    parser.add_argument("--method", default="USACV20", help="method that is compared with the others (default: %(default)s)")
    parser.add_argument("--other", action="append", default=[],
                        help="method to compare with; may be repeated (default: all other methods)")
    options = parser.parse_args(arguments)
    try:
        results = read_pairs(options.runs)
        known = list(dict.fromkeys(m for pairs in results.values() for methods in pairs.values() for m in methods))
        unknown = [m for m in [options.method] + options.other if m not in known]
        if unknown:
            raise ValueError("no runs of %s; there are %s" % (", ".join(unknown), ", ".join(known)))
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    print_table(results, options.method, options.other or [m for m in known if m != options.method], sys.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
