#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of usac_covariance, which measures how well Report::covariance describes the errors of models,
and how much more accurate models become if the noise of each match is given (Params::sigmas).

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_covariance is
taken from the same folder."""

import os
import unittest

from test_problems import ProgramTest, program


@unittest.skipUnless(os.path.isfile(program("usac_covariance")), "there is no usac_covariance beside USAC_BENCHMARK")
class CovarianceTest(ProgramTest):

    def table(self, *options):
        """Runs the program; returns the rows of its table as {problem: {column: number}}."""
        done = self.call("usac_covariance", "--sizes=100", "--ratios=0.7", "--noises=0.3", "--by=problem", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines() if line]
        self.assertEqual({len(line) for line in lines}, {len(lines[0])})
        return {line[0]: dict(zip(lines[0][2:], map(float, line[2:]))) for line in lines[2:]}

    def test_calibration(self):
        rows = self.table("--problems=H,T,P", "--scenes=200")
        for row in rows.values():
            self.assertEqual(row["scenes"], 200)
            self.assertNotIn("without sigmas", row)
            self.assertAlmostEqual(row["mean / d"], 1, delta=0.25)
            self.assertAlmostEqual(row["noise"], 1, delta=0.05)

    def test_noise_of_each_match(self):
        rows = self.table("--problems=H,A,T,P,R", "--scenes=100", "--spread=5")
        self.assertEqual(set(rows), set("HATPR"))
        for row in rows.values():
            self.assertLess(row["error"], 1.1)
            self.assertGreater(row["without sigmas"], 1.5)
            self.assertAlmostEqual(row["mean / d"], 1, delta=0.35)

    def test_covariances_of_points(self):
        rows = self.table("--problems=H,A,T,P", "--scenes=100", "--spread=5", "--directed=1")
        self.assertEqual(set(rows), set("HATP"))
        for row in rows.values():
            self.assertLess(row["error"], 1.1)
            self.assertGreater(row["without sigmas"], 1.5)
            self.assertAlmostEqual(row["mean / d"], 1, delta=0.35)
            self.assertAlmostEqual(row["noise"], 1, delta=0.05)
        done = self.call("usac_covariance", "--problems=R", "--spread=5", "--directed=1")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--directed", done.stderr)

    def test_means_over_no_scene(self):
        """With ten right matches of 100, no model is significant."""
        done = self.call("usac_covariance", "--problems=H", "--shapes=plane", "--sizes=100", "--ratios=0.1", "--noises=1", "--scenes=5",
                         "--spread=5")
        row = [cell.strip() for cell in done.stdout.splitlines()[-1].strip("|").split("|")]
        self.assertEqual(row[2:4], ["5", "100.0"])
        self.assertEqual(row[6:], 5 * ["-"])

    def test_wrong_options(self):
        for option in ("--spread=0", "--spread=x", "--directed=2", "--by=color", "--preset=none", "--problems=X", "--noises=-1"):
            done = self.call("usac_covariance", "--scenes=1", option)
            self.assertNotEqual(done.returncode, 0, option)
            self.assertIn(option.split("=")[0], done.stderr)


if __name__ == "__main__":
    unittest.main()
