#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Shows how much of the time of a call each phase takes: runs usac_benchmark on synthetic scenes under
Valgrind's callgrind and counts the instructions of each phase. The counts do not depend on other
programs that run at the same time. A table goes to the standard output, in Markdown.

    phases.py --build=BUILD --sizes 100 1000 --parts 0.9 0.5

BUILD is a build folder with usac_benchmark and usac_synthetic. Needs valgrind."""

import argparse
import collections
import os
import re
import subprocess
import sys
import tempfile

import figure_tables

SCENES = collections.OrderedDict((("H", "planar"), ("F", "general"), ("E", "general"), ("P", "view"), ("A", "affinity"), ("S", "similarity"),
                                  ("T", "translation"), ("R", "rigid"), ("M", "rigidScaled")))
# For each phase two regular expressions: one for the functions whose calls belong to the phase, and
# one (or None) for callers from which such calls do not count, because the caller itself already
# belongs to the phase.
PHASES = collections.OrderedDict((
    ("samples", (r"SampleBatch::draw", None)),
    ("their models", (r"SampleBatch::solve", None)),
    ("test, score", (r"SampleBatch::score", None)),
    ("degeneracy", (r"\w+::(?:recover|discount|discounted)", r"Checks::|Restarts::")),
    ("graph cut", (r"Labeling::cut", None)),
    ("local fits", (r"\w*Optimizer::optimize", None)),
    ("polishing", (r"\w*Polisher::polish|Leverage::improve|Restarts::improve", r"Restarts::|Leverage::"))))
METHOD = "*ModuleMethod::run*"  # callgrind counts only the instructions during calls of this function


def read_calls(file):
    """Reads an output file of callgrind. Returns the total number of instructions, and {(caller,
    callee): number of instructions in these calls, including those in functions that the callee
    calls}."""
    names, calls, total, caller, callee = {}, collections.Counter(), 0, "", None
    for line in file:
        found = re.match(r"(c?)fn=\((\d+)\)(?: (.*))?", line)
        if found:
            name = names.setdefault(found.group(2), found.group(3))
            caller, callee = (caller, name) if found.group(1) else (name, None)
        elif line.startswith("calls="):
            calls[caller, callee] += int(next(file).split()[-1])
        elif line.startswith(("totals:", "summary:")):
            total = int(line.split()[1])
    return total, calls


def shares(total, calls):
    """Returns {phase: fraction of all instructions}. The last entry, "rest", contains the reading of
    the input, normalization, runners-up, termination and mask."""
    result = collections.OrderedDict()
    for phase, (inside, part) in PHASES.items():
        result[phase] = sum(cost for (caller, callee), cost in calls.items()
                            if re.search(r"usacv20::.*\b(%s)\(" % inside, callee) and not (part and re.search(part, caller))) / total
    result["local fits"] -= result["graph cut"]  # the local optimizer calls the graph cut
    result["rest"] = 1 - sum(result.values())
    return result


def measure(build, problem, size, part, pairs, method):
    """Returns the mean number of instructions of a call, and the fractions of the phases."""
    programs = os.path.join(build, "bin")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([os.path.join(programs, "usac_synthetic"), "--out=" + folder, "--scene=" + SCENES[problem], "--name=scene",
                        "--size=%d" % size, "--inliers=%g" % part, "--pairs=%d" % pairs], check=True, stdout=subprocess.DEVNULL)
        counts = os.path.join(folder, "counts")
        subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=" + counts, "--toggle-collect=" + METHOD,
                        os.path.join(programs, "usac_benchmark"), "--data=" + folder, "--problem=" + problem, "--methods=" + method, "--repeats=1"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(counts) as file:
            total, calls = read_calls(file)
    return total / (pairs + 1), shares(total, calls)  # the first scene is also run once as a warm-up


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, metavar="DIR")
    parser.add_argument("--problems", default="".join(SCENES), metavar="LETTERS", help="some of %(default)s")
    parser.add_argument("--sizes", nargs="+", type=int, default=[100, 1000, 10000], help="numbers of matches (default %(default)s)")
    parser.add_argument("--parts", nargs="+", type=float, default=[0.9, 0.5],
                        help="fractions of right matches (default %(default)s)")
    parser.add_argument("--pairs", type=int, default=10, help="scenes of each kind (default %(default)s)")
    parser.add_argument("--method", default="USACV20")
    args = parser.parse_args()
    if set(args.problems) - set(SCENES):
        parser.error("--problems: only letters of %s" % "".join(SCENES))
    rows = []
    for problem in args.problems:
        for size in args.sizes:
            for part in args.parts:
                instructions, found = measure(args.build, problem, size, part, args.pairs, args.method)
                rows.append([problem, str(size), "%g %%" % (100 * part), "%.2f" % (instructions / 1e6)] +
                            ["%.0f" % (100 * share) for share in found.values()])
    print(figure_tables.markdown(["problem", "matches", "right", "million instructions"] + ["%s, %%" % phase for phase in list(PHASES) + ["rest"]], rows, True))


if __name__ == "__main__":
    sys.exit(main())
