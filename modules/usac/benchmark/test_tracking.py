#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of usac_tracking, which measures how much the model of the previous frame, as initial model,
helps a tracker.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_tracking is
taken from the same folder."""

import csv
import os
import unittest

from test_problems import ProgramTest, program


@unittest.skipUnless(os.path.isfile(program("usac_tracking")), "there is no usac_tracking beside USAC_BENCHMARK")
class TrackingTest(ProgramTest):

    def rows(self, *options):
        """Runs the program; returns its rows as {(initial model, limit of samples): row}."""
        file = self.path("out.csv")
        done = self.call("usac_tracking", "--csv=" + file, *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(file, newline="") as lines:
            rows = list(csv.DictReader(lines))
        self.assertEqual(len(done.stdout.splitlines()), 2 + len(rows))
        return {(row["initial_model"], int(row["limit"])): row for row in rows}

    def test_few_samples(self):
        """With an inlier ratio of 0.3, one sample per frame must often fail without an initial model,
        although the first samples prefer matches with many similar matches nearby, which are inliers
        more often. The previous frame's model is nearly right, except at the jump."""
        for problem, default in (("P", 1000), ("H", 10000)):
            rows = self.rows("--problems=" + problem, "--ratios=0.3", "--limits=1,8", "--frames=40", "--size=200", "--sequences=1",
                             "--speed=0.5")
            self.assertEqual(set(rows), {(initial, limit) for initial in ("no", "yes", "yes or again") for limit in (1, 8)} |
                             {("no", default), ("yes", default)})
            self.assertEqual({row["frames"] for row in rows.values()}, {"40"})
            for initial in ("no", "yes"):
                self.assertEqual(float(rows[initial, 1]["mean_samples"]), 1)
                self.assertLess(float(rows[initial, default]["failures_percent"]), 10)
            self.assertGreater(float(rows["no", 1]["failures_percent"]), 20)
            self.assertLess(float(rows["yes", 8]["failures_percent"]), 10)
            self.assertLess(float(rows["yes", default]["recovery"]), 3)
            self.assertEqual(float(rows["no", default]["cpu_ratio"]), 1)
            again = rows["yes or again", 1]
            self.assertLess(float(again["failures_percent"]), 10)
            self.assertLess(float(again["recovery"]), 3)
            self.assertLess(float(again["mean_samples"]), float(rows["no", default]["mean_samples"]) / 2)

    def test_no_motion(self):
        """Without motion, one sample per frame suffices once a model is found, because the previous
        model stays right until the camera jumps. So the failures must be below 30 % of the frames."""
        row = self.rows("--problems=P", "--ratios=0.9", "--limits=1", "--frames=20", "--size=100", "--sequences=2",
                        "--speed=0")["yes", 1]
        self.assertEqual(row["frames"], "40")
        self.assertLess(float(row["median_error"]), 0.5)
        self.assertLess(float(row["failures_percent"]), 30)

    def test_mistakes(self):
        for option, complaint in (("--problems=F", "--problems"), ("--ratios=0", "--ratios"), ("--limits=0", "--limits"),
                                  ("--frames=1", "--frames"), ("--noise=-1", "--noise")):
            done = self.call("usac_tracking", option)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(complaint, done.stderr)


if __name__ == "__main__":
    unittest.main()
