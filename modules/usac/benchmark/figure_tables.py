# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes Markdown tables from the files that usac_benchmark and usac_tracking write with --csv."""

import collections
import csv
import math

CAPTION = ("Median error in pixels (geometric mean over the lists on which no method of the table fails in half of the runs) / failures in % (mean) / "
           "process CPU milliseconds of a call (geometric mean over lists of the median) / for E the AUC of the pose error at 10 degrees")


def read_tables(*files):
    """Returns {(problem, list): {method: {column: number}}} without the rows of averages."""
    tables = collections.OrderedDict()
    for file in files:
        with open(file, newline="") as lines:
            for row in csv.DictReader(lines):
                if row["list"] != "average" and not row["list"].startswith("average."):
                    numbers = {key: float(text) if text else math.nan for key, text in row.items()
                               if key not in ("list", "problem", "method")}
                    tables.setdefault((row["problem"], row["list"]), {})[row["method"]] = numbers
    return tables


def markdown(head, rows, right=False):
    rule = "|---" + ("|---:" if right else "|---") * (len(head) - 1) + "|"
    return "\n".join(["| %s |" % " | ".join(head), rule] + ["| %s |" % " | ".join(row) for row in rows])


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values)) if values else math.nan


def mean(values):
    return sum(values) / len(values) if values else math.nan


def number(value, form):
    return "-" if math.isnan(value) else "inf" if math.isinf(value) else form % value


def cell(row, digits=3, auc=True):
    """Returns the text of the table cell for a list and a method: median error / failures in % / median CPU
    milliseconds, and the AUC at 10 degrees if it is known and `auc` is True."""
    parts = [number(row["median_error"], "%%.%df" % digits), number(row["failures_percent"], "%.1f"),
             number(row["median_cpu_ms"], "%.2f")]
    return " / ".join(parts + [number(row["auc10"], "%.0f")] if auc and not math.isnan(row["auc10"]) else parts)


def averages(tables, methods, names=None, baseline=None, hopeless=()):
    """Returns a table with a row for each method and a column for each problem. A baseline adds a
    column: the geometric mean over the lists of the ratio of the method's time to the baseline's
    time. A list on which one of the methods has an infinite median error is left out of the average
    errors of all methods. Failures of the methods in `hopeless` do not exclude a list, so the average
    error of these methods can be infinite."""
    problems = list(dict.fromkeys(problem for problem, _ in tables))
    lists = {p: [table for (problem, _), table in tables.items() if problem == p] for p in problems}
    solved = {p: [t for t in lists[p] if all(math.isfinite(t[m]["median_error"]) for m in methods if m in t and m not in hopeless)]
              for p in problems}
    head = ["method"]
    for p in problems:
        count, left = len(lists[p]), len(solved[p])
        head.append("%s (%d list%s%s)" % (p, count, "" if count == 1 else "s", "" if left == count else ", errors of %d" % left))
    rows = []
    for method in methods:
        row = [(names or {}).get(method, "`%s`" % method)]
        for p in problems:
            of = [table[method] for table in lists[p] if method in table]
            if not of:
                row.append("-")
                continue
            figures = {"median_error": geometric_mean([t[method]["median_error"] for t in solved[p] if method in t]),
                       "failures_percent": mean([r["failures_percent"] for r in of]),
                       "median_cpu_ms": geometric_mean([r["median_cpu_ms"] for r in of]),
                       "auc10": mean([r["auc10"] for r in of]) if p == "E" else math.nan}
            row.append(cell(figures, 2))
        if baseline:
            both = [t[method]["median_cpu_ms"] / t[baseline]["median_cpu_ms"] for t in tables.values() if method in t]
            row.append("%.2f" % geometric_mean(both))
        rows.append(row)
    return markdown(head + (["CPU time to `%s`" % baseline] if baseline else []), rows)


def best(table, rivals, column):
    """Returns (value, name) of the rival with the lowest value in a column of a list's table; (NaN, "")
    if the table has none of the rivals."""
    return min(((table[m][column], m) for m in rivals if m in table), default=(math.nan, ""))


def single_lists(tables, methods, rivals):
    head = ["list"] + ["`%s`" % m for m in methods] + ["best error of `cv:USAC_*`", "fewest failures of them"]
    rows = []
    for (problem, name), table in tables.items():
        error, rival = best(table, rivals, "median_error")
        rows.append(["%s %s" % (problem, name)] + [cell(table[m], auc=problem == "E") if m in table else "-" for m in methods] +
                    ["%.3f (%s)" % (error, rival.replace("cv:USAC_", "")), "%.1f" % best(table, rivals, "failures_percent")[0]])
    return markdown(head, rows)


def losses(tables, method, rivals, fastest, margin=1.02):
    """Returns a table of the lists on which the method is behind: it fails more often than the rival
    with the fewest failures, its error is more than `margin` times the smallest error of the rivals,
    or its time is more than `margin` times that of the method `fastest`."""
    rows = []
    for (problem, name), table in tables.items():
        own = table[method]
        error, rival = best(table, rivals, "median_error")
        failures = best(table, rivals, "failures_percent")[0]
        time = table[fastest]["median_cpu_ms"]
        behind = [own["median_error"] > margin * error, own["failures_percent"] > failures, own["median_cpu_ms"] > margin * time]
        if any(behind):
            texts = ["%.3f, %.3f (%s)" % (own["median_error"], error, rival.replace("cv:USAC_", "")),
                     "%.1f, %.1f" % (own["failures_percent"], failures), "%.2f, %.2f" % (own["median_cpu_ms"], time)]
            rows.append(["%s %s" % (problem, name), "%d" % own["pairs"]] + ["**%s**" % t if b else t for t, b in zip(texts, behind)])
    return markdown(["list", "pairs", "error: `%s`, best of `cv:USAC_*`" % method, "failures, %: the same",
                     "CPU ms: `%s`, `%s`" % (method, fastest)], rows)


def ratios(table, methods, baseline):
    """Returns a table of the methods on one list of absolute poses: errors of the rotations and of the
    camera centers, failures, AUC at one degree, times, and times divided by those of the baseline."""
    rows = []
    for m in methods:
        row = table[m]
        of = [row[c] / table[baseline][c] for c in ("median_cpu_ms", "mean_cpu_ms")]
        rows.append(["`%s`" % m] + [number(row[c], f) for c, f in (("median_error", "%.3f"), ("median_center_percent", "%.3f"),
                                                                  ("failures_percent", "%.1f"), ("auc1", "%.1f"))] +
                    ["%.2f, %.2f" % (row["median_cpu_ms"], row["mean_cpu_ms"]), "%.2f, %.2f" % tuple(of)])
    return markdown(["method", "error", "center error", "failures, %", "AUC@1", "CPU median, mean, ms", "of `%s`" % baseline], rows, True)


def against(tables, methods, baseline):
    """Returns a table with a row for each list: errors and failures of all methods, then the time of
    the baseline, then the time of each method divided by that of the baseline."""
    rows = []
    for (_, name), table in tables.items():
        errors = ["%s / %s" % (number(table[m]["median_error"], "%.3f"), number(table[m]["failures_percent"], "%.1f"))
                  for m in methods + [baseline]]
        times = ["%.2f" % (table[m]["median_cpu_ms"] / table[baseline]["median_cpu_ms"]) for m in methods]
        rows.append([name] + errors + ["%.2f" % table[baseline]["median_cpu_ms"]] + times)
    names = ["`%s`" % m for m in methods]
    return markdown(["list"] + names + ["`%s`" % baseline, "`%s`, ms" % baseline] + ["time of " + n for n in names], rows, True)


def tracking(file):
    """Returns a table of a file that usac_tracking has written with --csv: a row for each problem,
    inlier ratio and limit of the number of samples, a column for each use of the initial model."""
    rows = collections.OrderedDict()
    with open(file, newline="") as lines:
        for row in csv.DictReader(lines):
            text = "%s / %.1f / %.0f / %.2f / %.1f" % (number(float(row["median_error"]), "%.3f"), float(row["failures_percent"]),
                                                     float(row["mean_samples"]), float(row["cpu_ratio"]), float(row["recovery"]))
            key = ("%s, %.0f %%" % (row["problem"], 100 * float(row["ratio"])), row["limit"])
            rows.setdefault(key, {})[row["initial_model"]] = text
    beginnings = ("no", "yes", "yes or again")
    return markdown(["right matches", "most samples", "no model", "model", "model or again"],
                    [list(key) + [row.get(b, "") for b in beginnings] for key, row in rows.items()], True)
