# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads counts of tests, coverage and times from the files that run_tests.sh and sanitize.sh leave
in USAC_BUILD_DIR. For each part NAME of the tests (PARTS) these are NAME.log, NAME.commit (the tested
commit), and NAME.before and NAME.after with the processor times of the shell. In the table of
doc/measurements/tests.md, a part without a log keeps its old row."""

import datetime
import os
import re

PARTS = {"cpp": "C++", "perf": "performance", "python": "Python inside OpenCV", "consumer": "consumer", "python_package": "Python package",
         "python_package_alone": "package without `cv2`", "benchmark": "benchmark", "opencv": "OpenCV's own", "sanitized": "C++ with sanitizers",
         "sources": "rules of the sources", "tsan": "ThreadSanitizer", "assertions": "assertions of libstdc++", "valgrind": "valgrind",
         "coverage": "coverage", "fuzz": "fuzzer", "lint": "lint"}
# The gate consists of those parts that run_tests.sh runs and that have tests.
GATE = ("cpp", "perf", "python", "consumer", "python_package", "python_package_alone", "benchmark", "opencv", "sanitized")
TOOLS = ("sanitized", "tsan", "assertions", "valgrind")
COLUMNS = ("part", "passed", "failed", "more", "processor s", "commit", "date", "results")
COUNTS = (r"^(\d+) passed, (\d+) failed$", r"^\[  PASSED  \] (\d+) tests?\.$")
FAILED = r"^\[  FAILED  \] (\d+) tests?, listed below"


class GateError(ValueError):
    pass


def read_counts(log):
    """Returns the numbers (passed, failed) of tests from a log. If several lines have counts, the last
    one is used, as in run() of common.sh."""
    for pattern in COUNTS:
        found = re.findall(pattern, log, re.M)
        if found:
            failed = re.findall(FAILED, log, re.M)
            last = found[-1]
            return (int(last[0]), int(last[1])) if isinstance(last, tuple) else (int(last), int(failed[-1]) if failed else 0)
    raise GateError("no count of tests")


def read_more(name, log):
    """Returns the further results in the log of a part as text: for `coverage` the covered lines and
    branches, for `fuzz` the number of inputs and the run time; "-" for other parts."""
    if name == "coverage":
        found = re.findall(r"^(lines|branches): [\d.]+% \((\d+) out of (\d+)\)$", log, re.M)
        if len(found) != 2:
            raise GateError("no summary of gcovr")
        return "; ".join("%s %s of %s" % row for row in found)
    if name == "fuzz":
        found = re.findall(r"^Done (\d+) runs in (\d+) second", log, re.M)
        if not found:
            raise GateError("no count of runs")
        return "%s inputs in %d minutes" % (found[-1][0], int(found[-1][1]) // 60)
    return "-"


def read_seconds(before, after):
    """Returns the processor seconds, as text, between two outputs of the shell's command `times`. Their
    second line has the user and system times of the shell's child processes."""
    def seconds(text):
        numbers = [float(n) for n in re.findall(r"[\d.]+", text.splitlines()[1])]
        return 60 * (numbers[0] + numbers[2]) + numbers[1] + numbers[3]
    return "%d" % (seconds(after) - seconds(before))


def read_row(folder, name, stamp):
    """Returns the row of a part as {column: text}, or None if it has no log. stamp(time, commit) must
    return (commit, digest of hashes.txt) of the tested state. Its arguments are the time of the log and
    the contents of the file NAME.commit, or "" if there is no such file."""
    def text(suffix):
        with open(os.path.join(folder, name + suffix), encoding="utf-8", errors="replace") as file:
            return file.read()
    path = os.path.join(folder, name + ".log")
    if not os.path.isfile(path):
        return None
    try:
        passed, failed = read_counts(text(".log"))
        more = read_more(name, text(".log"))
    except GateError as error:
        raise GateError("%s: %s" % (path, error)) from None
    try:
        seconds = read_seconds(text(".before"), text(".after"))
    except (OSError, IndexError):
        seconds = "-"
    time = datetime.datetime.fromtimestamp(os.path.getmtime(path), datetime.timezone.utc)
    try:
        commit = text(".commit").strip()
    except OSError:
        commit = ""
    commit, digest = stamp(time, commit)
    return dict(zip(COLUMNS, (name, str(passed), str(failed), more, seconds, commit, "%s" % time.date(), digest)))


def parse_table(text):
    """Returns {part: row} of the table in the text of an earlier doc/measurements/tests.md."""
    lines = [line.strip("| ").split(" | ") for line in text.splitlines() if re.match(r"\| [a-z_]+ \|", line)]
    return {row[0]: dict(zip(COLUMNS, row)) for row in lines if len(row) == len(COLUMNS) and row[0] in PARTS}


def table(rows):
    lines = ["| " + " | ".join(COLUMNS) + " |", "|---|---:|---:|---|---:|---|---|---|"]
    lines += ["| " + " | ".join(rows[name][column] for column in COLUMNS) + " |" for name in PARTS if name in rows]
    return "\n".join(lines)


def outcome(row):
    """Returns the number of failures in words, with the date and the commit that was tested."""
    failed = "none failed" if row["failed"] == "0" else "%s failed" % row["failed"]
    return "%s (%s, %s)" % (failed, row["date"], row["commit"])


def sentences(rows):
    """Returns {name: text for README.md} for the parts in TOOLS, `fuzz` and `coverage`, as far as they
    have a row, and for `gate` if all parts of GATE have a row."""
    found = {name: "%s tests, %s" % (rows[name]["passed"], outcome(rows[name])) for name in TOOLS if name in rows}
    if "fuzz" in rows:
        found["fuzz"] = "%s, %s" % (rows["fuzz"]["more"], outcome(rows["fuzz"]).replace("none failed", "no finding"))
    if "coverage" in rows:
        (hit, lines), (taken, branches) = re.findall(r"(\d+) of (\d+)", rows["coverage"]["more"])
        found["coverage"] = "%s of %s lines of `src/` and %.1f %% of the branches (%s of %s; %s, %s)" % (
            hit, lines, 100 * int(taken) / int(branches), taken, branches, rows["coverage"]["date"], rows["coverage"]["commit"])
    if all(name in rows for name in GATE):
        gate = [rows[name] for name in GATE]
        parts = ", ".join("%s %s" % (row["passed"], PARTS[row["part"]]) for row in gate)
        failed = sum(int(row["failed"]) for row in gate)
        dates = sorted({row["date"] for row in gate})
        found["gate"] = "%s; %s failed (%s)" % (parts, failed or "none", " to ".join(dict.fromkeys((dates[0], dates[-1]))))
    return found
