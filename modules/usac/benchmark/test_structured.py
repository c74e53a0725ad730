#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of usac_structured, which counts failures of the search and measures accuracy on scenes with
structure (planes, clusters, repeated patterns, ...).

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_structured is
taken from the same folder."""

import csv
import math
import os
import subprocess
import unittest

from test_benchmark import FolderTest

PROGRAM = os.path.join(os.path.dirname(os.environ.get("USAC_BENCHMARK", "")), "usac_structured")
COUNTS = ("calls", "failures", "limited", "limited_failures", "worse", "wrong", "no_model")
#: Quantile of the normal distribution for a two-sided 95 % interval.
QUANTILE = 1.959964


def wilson(count, of):
    p, z2 = count / of, QUANTILE ** 2
    middle, half = p + z2 / (2 * of), QUANTILE * math.sqrt(p * (1 - p) / of + z2 / (4 * of * of))
    return (middle - half) / (1 + z2 / of), (middle + half) / (1 + z2 / of)


@unittest.skipUnless(os.path.isfile(PROGRAM), "there is no usac_structured beside USAC_BENCHMARK")
class StructuredTest(FolderTest):

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True)

    def rows(self, *arguments):
        """Runs the program; returns the rows of its CSV file and its standard output."""
        file = self.path("out.csv")
        done = self.run_program("--csv=" + file, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        with open(file, newline="") as lines:
            return list(csv.DictReader(lines)), done.stdout

    def test_one_sample_is_not_enough(self):
        """With 50 inliers among 100 matches, about one in 160 samples of seven matches (F) consists of
        inliers only. So one sample must fail in at least 46 of 50 scenes, and 1000 samples must fail in
        fewer than 15 scenes."""
        methods = ["preset:ransac{maxIterations=%d,significance=1}" % limit for limit in (1, 1000)]
        rows, _ = self.rows("--problems=F", "--methods=" + ",".join(methods), "--kinds=generic", "--orders=none", "--sizes=100",
                            "--ratios=0.5", "--runs=50")
        self.assertEqual([row["method"] for row in rows], methods)
        one, many = rows
        self.assertEqual((one["calls"], one["limited"], float(one["mean_iterations"])), ("50", "50", 1))
        self.assertEqual((one["failures"], one["failures_low"], one["failures_high"]), ("0", "0", "1"),
                         "all searches must end at the limit of iterations, so no call is left for this proportion")
        self.assertGreaterEqual(int(one["limited_failures"]), 46)
        self.assertGreaterEqual(int(one["wrong"]), 40)
        self.assertLess(int(many["failures"]) + int(many["limited_failures"]), 15)
        self.assertLess(int(many["wrong"]), 10)
        self.assertTrue(200 < float(many["mean_iterations"]) <= 1000, many)

    def test_judged_by_a_start_at_the_true_model(self):
        """With --judge=start, a missed true model counts as a failure only if a search that starts from
        the true model returns it. RANSAC with one sample misses models that such a search returns, so
        the number of its failures must not change. In some scenes the score of MAGSAC++ prefers another
        model to the true one, so MAGSAC++ must have fewer failures than with --judge=cost."""
        few = ["--problems=F", "--methods=preset:ransac{maxIterations=1,significance=1}", "--kinds=generic", "--orders=none", "--sizes=100",
               "--ratios=0.5", "--runs=20"]
        wide = ["--problems=F", "--methods=USACV20_MAGSAC", "--kinds=shift35", "--orders=none", "--sizes=400", "--ratios=0.4,0.45",
                "--runs=60", "--maxIters=1000000"]

        def failures(arguments, judge):
            rows, _ = self.rows("--judge=" + judge, *arguments)
            return sum(int(row["failures"]) + int(row["limited_failures"]) for row in rows)

        self.assertGreaterEqual(failures(few, "cost"), 17)
        self.assertEqual(failures(few, "start"), failures(few, "cost"))
        self.assertLess(failures(wide, "start"), failures(wide, "cost"))
        done = self.run_program("--judge=nobody")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--judge: expected cost or start", done.stderr)

    def test_models_of_wrong_matches(self):
        """All matches are wrong: random points in clusters or near the center. RANSAC without a
        significance test must return a model in each scene. USACV20 with its significance test must
        refuse the models in all but at most one of ten scenes."""
        methods = ["USACV20", "preset:ransac{significance=1}", "cv:RANSAC"]
        rows, text = self.rows("--mode=random", "--problems=H,S,E", "--methods=" + ",".join(methods), "--sizes=200", "--kinds=clusters,center",
                               "--runs=10", "--maxIters=300")
        of = {(row["problem"], row["kind"], row["method"]): (int(row["models"]), int(row["calls"])) for row in rows}
        self.assertEqual({key[:2] for key in of}, {(p, k) for p in "HSE" for k in ("clusters", "center")})
        for problem, kind in {key[:2] for key in of}:
            self.assertLessEqual(of[problem, kind, methods[0]][0], 1, (problem, kind))
            self.assertEqual(of[problem, kind, methods[1]], (10, 10), (problem, kind))
        self.assertEqual(len(text.split("| H |")), 3, "the table must have one line for each of the two kinds")
        for option in ("--ratios=0.5", "--motions=general", "--orders=none", "--noises=1", "--problems=P"):
            done = self.run_program("--mode=random", option)
            self.assertEqual(done.returncode, 1, option)
            self.assertIn(option.split("=")[0], done.stderr)

    def test_baselines(self):
        for motion in ("baseline0", "baseline101", "baseline"):
            self.assertIn("--motions: %s is unknown" % motion, self.run_program("--mode=accuracy", "--motions=" + motion).stderr)
        rows, _ = self.rows("--mode=accuracy", "--problems=E", "--motions=baseline1,general", "--noises=0.2", "--ratios=1", "--runs=20")
        short, long = (float(row["median_pose"]) for row in rows if row["method"] == "USACV20")
        self.assertGreater(short, 10 * long, "the short baseline must make the error of the direction much larger")

    def test_counts_are_consistent(self):
        rows, _ = self.rows("--problems=H,E", "--methods=USACV20_FAST,cv:RANSAC", "--kinds=clustered,copies,second",
                            "--orders=none,0.05", "--sizes=20,50", "--ratios=0.5,0.9", "--runs=6")
        self.assertEqual(len(rows), 2 * (2 + 1) * (2 * 2 + 2 * 2 + 2), "cv:RANSAC uses no scores; ratios do not apply to "
                                                                       "`second`")
        for row in rows:
            counts = {name: int(row[name]) for name in COUNTS}
            self.assertEqual(counts["calls"], 6)
            self.assertLessEqual(counts["failures"] + counts["limited_failures"], counts["worse"], row)
            self.assertLessEqual(counts["no_model"], counts["wrong"], row)
            self.assertLessEqual(counts["limited_failures"], counts["limited"], row)
            if counts["calls"] > counts["limited"]:
                low, high = wilson(counts["failures"], counts["calls"] - counts["limited"])
                self.assertAlmostEqual(float(row["failures_low"]), low, delta=1e-5)
                self.assertAlmostEqual(float(row["failures_high"]), high, delta=1e-5)
            self.assertEqual(float(row["mean_iterations"]) < 0, row["method"].startswith("cv:"), row)

    def test_sums(self):
        arguments = ("--problems=F", "--methods=preset:ransac{confidence=0.3}", "--kinds=generic,plane95", "--orders=none",
                     "--sizes=20,30", "--ratios=0.6,0.7", "--runs=10")
        rows, text = self.rows("--by=kind", *arguments)
        lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("|")]
        self.assertEqual([line[0] for line in lines], ["kind", "---", "generic", "plane95"])
        self.assertEqual(len({len(line) for line in lines}), 1, "head and body must have the same number of columns")
        for line in lines[2:]:
            cells = [row for row in rows if row["kind"] == line[0]]
            self.assertEqual(int(line[2]), sum(int(row["calls"]) for row in cells))
            failures = sum(int(row["failures"]) for row in cells)
            self.assertEqual(line[3].split()[0], "%.2f" % (100 * failures / 40))
        _, brief = self.rows("--by=kind", "--table=brief", *arguments)
        for line, cells in zip(lines[2:], [line.split(" | ") for line in brief.splitlines() if line.startswith("|")][2:]):
            self.assertEqual(["| " + line[0], line[2], line[3] + " |"], cells, "both tables must have the same figures")
        self.assertGreater(sum(int(row["failures"]) for row in rows), 0, "with a confidence of 0.3, some searches must fail")

    def test_is_deterministic(self):
        arguments = ("--problems=E", "--kinds=line", "--orders=0.8", "--sizes=50", "--ratios=0.5", "--runs=5")
        first, again, other = [self.rows(*(arguments + more))[0][0] for more in ((), (), ("--seed=7",))]
        for row in first, again, other:
            del row["median_cpu_us"]
        self.assertEqual(first, again)
        self.assertNotEqual(first["mean_iterations"], other["mean_iterations"])

    def test_accuracy(self):
        """The error of the least-squares fit to the right matches must be proportional to the noise.
        The ratio of a method's error to that of least squares must be 1 for least squares itself, and
        0.9 to 10 for USACV20_ACCURATE."""
        rows, text = self.rows("--mode=accuracy", "--methods=USACV20_ACCURATE", "--motions=sideways,forward",
                               "--noises=0,0.05,0.1", "--runs=10")
        self.assertEqual(sum(line.startswith("## ") for line in text.splitlines()), 3)
        self.assertEqual(len(rows), 3 * 2 * 3 * 2)
        cells = {(row["problem"], row["motion"], float(row["noise"]), row["method"]): row for row in rows}
        for problem in "HFE":
            for motion in ("sideways", "forward"):
                errors = [float(cells[problem, motion, noise, "least squares"]["median_error"]) for noise in (0, 0.05, 0.1)]
                self.assertLess(errors[0], 1e-10)
                self.assertAlmostEqual(errors[2] / errors[1], 2, delta=0.1)
                self.assertEqual(float(cells[problem, motion, 0.1, "least squares"]["median_ratio"]), 1)
                ratio = float(cells[problem, motion, 0.1, "USACV20_ACCURATE"]["median_ratio"])
                self.assertTrue(0.9 < ratio < 10, (problem, motion, ratio))

    def test_pose(self):
        """The baseline of the motion "narrow" is a hundredth of the usual one, so the parallax is only
        about a pixel. Without noise the least-squares pose must be right. With noise of one threshold this
        pose must be wrong in all scenes."""
        rows, _ = self.rows("--mode=accuracy", "--problems=E", "--motions=narrow", "--noises=0,1", "--runs=10")
        poses = {(row["noise"], row["method"]): float(row["median_pose"]) for row in rows}
        wrong = {(row["noise"], row["method"]): float(row["wrong_percent"]) for row in rows}
        self.assertLess(poses["0", "least squares"], 1e-6)
        self.assertGreater(poses["1", "least squares"], 20)
        self.assertEqual((wrong["0", "least squares"], wrong["1", "least squares"]), (0, 100))

    def test_mistakes(self):
        for argument, complaint in (("--mode=speed", "--mode"), ("--methods=USACV21", "USACV21"),
                                    ("--kinds=plane101", "plane101"), ("--motions=circle", "circle"),
                                    ("--orders=1.5", "--orders"), ("--orders=sorted", "--orders"),
                                    ("--sizes=0", "--sizes"), ("--sizes=4", "no such scene"), ("--ratios=1.1", "--ratios"),
                                    ("--table=long", "--table"),
                                    ("--problems=A", "--problems"), ("--runs=0", "--runs"), ("--confidence=1", "--confidence"), ("--maxIters=0", "--maxIters"),
                                    ("--by=color", "color"), ("--noises=1", "--noises"), ("--methods=cv:RANSAC+scores", "scores"),
                                    ("--kinds=", "--kinds"), ("--sizes=", "--sizes"), ("--unknown=1", "--unknown"),
                                    ("--csv=" + self.path("no", "x.csv"), "no")):
            done = self.run_program(argument)
            self.assertEqual((done.returncode, done.stdout), (1, ""), argument)
            self.assertIn(complaint, done.stderr)
        for option, complaint in (("--kinds=generic", "not for --mode=accuracy"), ("--orders=none", "for --mode=search only")):
            done = self.run_program("--mode=accuracy", option)
            self.assertEqual(done.returncode, 1)
            self.assertIn(complaint, done.stderr)


if __name__ == "__main__":
    unittest.main()
