#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of affinities, similarities and translations: scenes that usac_synthetic writes, and the
measures of usac_benchmark on them.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_synthetic and
usac_test_methods are taken from the same folder."""

import csv
import os
import subprocess
import unittest

import numpy as np

import pairs
from test_benchmark import FolderTest

PROGRAMS = os.path.dirname(os.environ.get("USAC_BENCHMARK", ""))
RIVALS = {"A": ["cv:RANSAC", "cv:LMEDS", "cv:USAC_DEFAULT", "cv:USAC_PROSAC+scores"], "S": ["cv:RANSAC", "cv:LMEDS"], "T": []}


def program(name):
    return os.path.join(PROGRAMS, name)


class ProgramTest(FolderTest):
    """Base class of tests that run the programs on scenes in a temporary folder."""

    def call(self, name, *arguments):
        return subprocess.run([program(name)] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True)

    def write_scenes(self, scene, *options):
        """Writes scenes of the kind `scene` with usac_synthetic, as a data set of the same name."""
        done = self.call("usac_synthetic", "--out=" + self.folder, "--scene=" + scene, "--name=" + scene, *options)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def text(self, scene, name):
        with open(self.path("pairs", scene, name)) as contents:
            return contents.read()

    def benchmark(self, methods, *options, name="usac_benchmark"):
        """Runs the benchmark with one repeat. Returns the rows of its file --runs as {method: [row]},
        the rows of its file --csv as {(list, method): row}, and its output with the tables."""
        runs, tables = self.path("runs.csv"), self.path("tables.csv")
        done = self.call(name, "--data=" + self.folder, "--methods=" + ",".join(methods), "--runs=" + runs, "--csv=" + tables,
                         "--repeats=1", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        by_method, by_list = {}, {}
        with open(runs, newline="") as lines:
            for row in csv.DictReader(lines):
                by_method.setdefault(row["method"], []).append(row)
        with open(tables, newline="") as lines:
            for row in csv.DictReader(lines):
                by_list[row["list"], row["method"]] = row
        return by_method, by_list, done.stdout


@unittest.skipUnless(os.path.isfile(program("usac_synthetic")), "there is no usac_synthetic beside USAC_BENCHMARK")
class PlaneMapTest(ProgramTest):

    SCENES = {"A": "affinity", "S": "similarity", "T": "translation"}

    def test_scene(self):
        for letter, scene in self.SCENES.items():
            self.write_scenes(scene, "--pairs=2", "--size=60", "--inliers=0.3", "--scores=1", "--noise=0")
            paths = pairs.read_list(pairs.list_file(self.folder, scene, letter))
            self.assertEqual([os.path.basename(path) for path in paths], ["0000", "0001"])
            pair = pairs.read_pair(paths[1])
            self.assertEqual((pair.problems, pair.gt_kind, len(pair.scores)), ([letter], "exact", 60))
            A, right = np.array(pair.extra["A"]), pair.extra["gt_mask"]
            self.assertEqual((A.shape, len(right)), ((2, 3), 18))
            distances = np.linalg.norm(pair.points1 @ A[:, :2].T + A[:, 2] - pair.points2, axis=1)
            self.assertLess(distances[right].max(), 3e-4)
            self.assertGreater(np.median(np.delete(distances, right)), 20)
            self.assertLess(pair.scores[right].max(), np.delete(pair.scores, right).min(),
                            "with --scores=1, each right match must have a better score than all wrong ones")
            self.assertLess(np.abs(pair.gt_points[:, :2] @ A[:, :2].T + A[:, 2] - pair.gt_points[:, 2:]).max(), 1e-9)
            similar = abs(A[0, 0] - A[1, 1]) + abs(A[0, 1] + A[1, 0])
            self.assertEqual(similar < 1e-9, letter != "A", A)
            self.assertEqual(np.array_equal(A[:, :2], np.eye(2)), letter == "T", A)

    def test_outliers(self):
        """Wrong matches of the kind "clustered" must go from one small square to another one. Those of
        the kind "second" must agree with an affinity other than the true one."""
        self.write_scenes("affinity", "--pairs=1", "--size=200", "--outliers=clustered", "--noise=0")
        pair = pairs.read_pair(self.path("pairs", "affinity", "0000"))
        wrong = np.delete(np.hstack((pair.points1, pair.points2)), pair.extra["gt_mask"], 0)
        self.assertEqual(len(wrong), 100)
        self.assertLess(np.ptp(wrong, axis=0).max(), 80)
        self.write_scenes("affinity", "--pairs=1", "--size=200", "--outliers=second", "--noise=0")
        pair = pairs.read_pair(self.path("pairs", "affinity", "0000"))
        ones = np.delete(np.column_stack((pair.points1, np.ones(200))), pair.extra["gt_mask"], 0)
        second = np.delete(pair.points2, pair.extra["gt_mask"], 0)
        other, _, _, _ = np.linalg.lstsq(ones, second, rcond=None)
        self.assertLess(np.abs(ones @ other - second).max(), 1e-3)
        self.assertGreater(np.abs(other.T - pair.extra["A"]).max(), 0.1)

    def test_methods(self):
        for letter, scene in self.SCENES.items():
            self.write_scenes(scene, "--pairs=2", "--size=200", "--inliers=0.6", "--noise=0.2", "--scores=0.8")
        runs, tables, text = self.benchmark(["USACV20", "USACV20_FAST", "USACV20+scores", "preset:ransac"] + RIVALS["A"] + ["cv:RHO"])
        for letter, scene in self.SCENES.items():
            self.assertIn("## %s (%s, 2 pairs, threshold 3, 2000 iterations, confidence 0.99)" % (scene, letter), text)
            for method, rows in runs.items():
                own = [row for row in rows if row["problem"] == letter]
                self.assertEqual(len(own), 2 if method in RIVALS[letter] or not method.startswith("cv:") else 0, method)
                for row in own:
                    self.assertLess(float(row["error"]), 3 if method == "preset:ransac" else 0.6, method)
                    self.assertEqual((row["failed"], row["pose_error"], row["correspondences"]), ("0", "", "200"))
                    self.assertEqual(row["iterations"] != "", not method.startswith("cv:"))
                    self.assertLess(abs(int(row["inliers"]) - 120), 8 if method != "cv:LMEDS" else 121)
        self.assertNotIn(("affinity", "cv:RHO"), tables)
        self.assertEqual(tables["average.A", "USACV20"]["median_error"], tables["affinity", "USACV20"]["median_error"])

    def test_other_settings(self):
        self.write_scenes("similarity", "--pairs=1", "--size=100", "--inliers=0.8")
        narrow, wide = [self.benchmark(["USACV20", "cv:RANSAC"], "--problem=S", "--threshold=%g" % threshold)[0]
                        for threshold in (0.5, 3)]
        for method in narrow:
            self.assertLess(int(narrow[method][0]["inliers"]), int(wide[method][0]["inliers"]))
        one = self.benchmark(["USACV20"], "--maxIters=1")[0]
        self.assertEqual(one["USACV20"][0]["iterations"], "1")

    @unittest.skipUnless(os.path.isfile(program("usac_test_methods")), "there is no usac_test_methods beside USAC_BENCHMARK")
    def test_measures(self):
        """The measures of the identity as a model must agree with values computed with numpy."""
        for scene in self.SCENES.values():
            self.write_scenes(scene, "--pairs=1", "--size=50")
        runs = self.benchmark(["custom:identity"], name="usac_test_methods")[0]["custom:identity"]
        self.assertEqual([row["problem"] for row in runs], ["A", "S", "T"])
        for row in runs:
            pair = pairs.read_pair(self.path("pairs", row["list"], "0000"))
            shifts = np.linalg.norm(pair.gt_points[:, :2] - pair.gt_points[:, 2:], axis=1)
            self.assertAlmostEqual(float(row["error"]) / np.sqrt(np.mean(shifts ** 2)), 1, delta=1e-4)
            self.assertEqual(row["failed"], str(int(float(row["error"]) > 8)))
            distances = np.linalg.norm(pair.points1 - pair.points2, axis=1)
            self.assertAlmostEqual(float(row["cost"]), np.mean(np.minimum(1, (distances / 3) ** 2)), delta=1e-4)

    def test_mistakes(self):
        for scene, option, complaint in (("cube", "--size=9", "--scene: expected one of general, plane, planar, affinity"),
                                         ("affinity", "--outliers=no", "--outliers: expected one of uniform, local"),
                                         ("similarity", "--planeFraction=1", "--planeFraction: for --scene=plane only")):
            done = self.call("usac_synthetic", "--out=" + self.path("none"), "--scene=" + scene, option)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(complaint, done.stderr)
        self.assertFalse(os.path.exists(self.path("none")))


if __name__ == "__main__":
    unittest.main()
