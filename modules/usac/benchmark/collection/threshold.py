#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes tables on the threshold that `--threshold auto` of the collection tool estimates, from scenes
with known noise: its accuracy, its effect on the verification, and the effect of halving and doubling
each constant of the estimation. The scenes come from the tests of the Python package. The tables go
to the standard output, in Markdown; the first line of a function's docstring is the table's heading."""

import argparse
import math
import os
import sys
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "misc", "python", "test"))
from usac_collection_noise import NONE, noisyPairs  # noqa: E402
from usacv20.collection import _threshold  # noqa: E402
from usacv20.collection._geometry import verifyPairs  # noqa: E402
from usacv20.collection._pair import CollectionError  # noqa: E402
from usacv20.collection._settings import Settings  # noqa: E402

SIZES, SIGMAS = ((640, 480), (1600, 1200), (6000, 4000)), (0.3, 1.0, 3.0)
CONSTANTS = ("WIDEST", "CONFIDENCE", "ITERATIONS", "SIGNIFICANCE", "MOST", "LEAST_INLIERS", "FEW_PAIRS")


def estimate(scenes):
    """Returns the result of estimateThreshold (threshold, noise and more), or None if the estimation
    fails, and the mean CPU milliseconds per pair."""
    begin = time.process_time()
    try:
        found = _threshold.estimateThreshold([scene.pair for scene in scenes], Settings())
    except CollectionError:
        found = None
    return found, 1000 * (time.process_time() - begin) / len(scenes)


def printRow(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def printHead(*cells):
    printRow(*cells)
    print("|" + "---|" * len(cells))


def noise(args):
    """Estimated noise, divided by the true noise."""
    printHead("size", "noise, px", "without overlap", "focal lengths", "ratio", "threshold", "pairs used / with overlap / all",
              "CPU ms a pair")
    for size in SIZES:
        for sigma in SIGMAS:
            for none in (0.2, 0.9):
                for known in (True, False):
                    scenes = noisyPairs(args.seed, args.pairs, none, size=size, sigma=sigma, known=known)
                    found, cpu = estimate(scenes)
                    overlap = sum(scene.kind != NONE for scene in scenes)
                    printRow("{}x{}".format(*size), sigma, "{:.0%}".format(none), "known" if known else "unknown",
                             "%.3f" % (found.sigma / sigma) if found else "none", "%g" % found.threshold if found else "",
                             "{} / {} / {}".format(found.used if found else 0, overlap, len(scenes)), "%.1f" % cpu)


def sample(args):
    """Deviation of the estimated noise from the true noise, by the number of pairs with overlap: root mean square, and the worst."""
    printHead("pairs with overlap", "estimates", "rms, %", "within 10 %", "worst, %", "none")
    scenes = noisyPairs(args.seed, 480, 0)
    for count in (1, 2, 3, 5, 10, 20, 40):
        groups = [scenes[i:i + count] for i in range(0, min(len(scenes), 40 * count) - count + 1, count)]
        found = [estimate(group)[0] for group in groups]
        wrong = np.array([abs(math.log(each.sigma)) for each in found if each])
        printRow(count, len(groups), "%.1f" % (100 * math.sqrt((wrong**2).mean())), "{:.0%}".format((wrong < 0.1).mean()),
                 "%.0f" % (100 * math.expm1(wrong.max())), sum(each is None for each in found))


def angle(cosine):
    return math.degrees(math.acos(min(max(cosine, -1), 1)))


def poseError(scene, result):
    """Returns the larger of the errors of the rotation and of the direction of the translation in
    degrees; 180 if there is no pose or no translation. If the true translation is 0, only the rotation
    counts."""
    if result.quaternion is None:
        return 180.0
    w, x, y, z = result.quaternion
    R = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                  [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                  [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    error = angle((np.trace(R.T.dot(scene.R)) - 1) / 2)
    if scene.t.any() and result.translation.any():
        return max(error, angle(scene.t.dot(result.translation) / np.linalg.norm(scene.t)))
    return 180.0 if scene.t.any() else error


def poses(args):
    """Verification of pairs with known focal lengths: with the estimated threshold, its half and double, and a fixed one."""
    printHead("size", "noise, px", "threshold", "AUC at 1 / 3 / 5 degrees", "precision", "recall", "pairs without overlap kept")
    for size in SIZES:
        for sigma in SIGMAS:
            scenes = noisyPairs(args.seed, args.pairs, size=size, sigma=sigma)
            auto = estimate(scenes)[0].threshold
            for name, threshold in (("auto", auto), ("auto / 2", auto / 2), ("2 auto", 2 * auto), ("fixed", 4.0)):
                results = verifyPairs([scene.pair for scene in scenes], Settings(threshold=threshold))
                overlap = [(scene, result) for scene, result in zip(scenes, results) if scene.kind != NONE]
                errors = np.array([poseError(*each) for each in overlap])
                auc = [100 * np.maximum(0, 1 - errors / limit).mean() for limit in (1, 3, 5)]
                right = np.array([[scene.right[result.inliers[:, 0]].sum(), len(result.inliers), scene.right.sum()]
                                  for scene, result in overlap]).sum(axis=0)
                kept = sum(len(result.inliers) > 0 for scene, result in zip(scenes, results) if scene.kind == NONE)
                printRow("{}x{}".format(*size), sigma, "{}, {:.3g}".format(name, threshold), "%.1f / %.1f / %.1f" % tuple(auc),
                         "%.3f" % (right[0] / right[1]), "%.3f" % (right[0] / right[2]),
                         "{} of {}".format(kept, len(scenes) - len(overlap)))


def deviation(args, **options):
    """Estimates the noise for all image sizes and noise levels, with known and unknown focal lengths.
    Returns the root mean square and the value of largest magnitude of log(estimated / true noise),
    which are infinite if an estimation fails, and the mean CPU milliseconds per pair."""
    wrong, cpus = [], []
    for size in SIZES:
        for sigma in SIGMAS:
            for known in (True, False):
                found, cpu = estimate(noisyPairs(args.seed, args.pairs, size=size, sigma=sigma, known=known, **options))
                wrong.append(math.log(found.sigma / sigma) if found else math.inf)
                cpus.append(cpu)
    return math.sqrt(np.mean(np.square(wrong))), max(wrong, key=abs), np.mean(cpus)


def constants(args):
    """Deviation of the estimated noise from the true noise, with half and double of each constant.

    Each of CONSTANTS is halved and doubled in turn; instead of CONFIDENCE, 1 - CONFIDENCE is doubled
    and halved."""
    printHead("constant", "value", "20 % without overlap: rms, worst", "90 % without overlap: rms, worst", "heavy tails: threshold, px",
              "CPU ms a pair")
    for name in ("",) + CONSTANTS:
        value = getattr(_threshold, name) if name else None
        for factor in (0.5, 2) if name else (1,):
            if name == "CONFIDENCE":
                setattr(_threshold, name, 1 - (1 - value) / factor)
            elif name:
                setattr(_threshold, name, type(value)(value * factor))
            few, many = deviation(args), deviation(args, none=0.9)
            heavy = estimate(noisyPairs(args.seed, args.pairs, heavy=0.5))[0]
            printRow(name or "all as they are", "%g" % getattr(_threshold, name) if name else "", "%.3f, %+.3f" % few[:2],
                     "%.3f, %+.3f" % many[:2], "%.2f" % heavy.threshold if heavy else "none", "%.1f" % few[2])
        if name:
            setattr(_threshold, name, value)


TABLES = {table.__name__: table for table in (noise, sample, poses, constants)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help="some of {}; default all".format(", ".join(TABLES)))
    parser.add_argument("--pairs", type=int, default=60, help="number of pairs of a collection (default %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    if set(args.tables) - set(TABLES):
        parser.error("there is no table {}".format(", ".join(sorted(set(args.tables) - set(TABLES)))))
    for name in args.tables or TABLES:
        print("\n## {}\n".format(TABLES[name].__doc__.splitlines()[0]))
        TABLES[name](args)


if __name__ == "__main__":
    main()
