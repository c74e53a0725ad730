#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of rigid motions of space: scenes that usac_synthetic and spaces.py write, and the measures
of usac_benchmark on them.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_synthetic and
usac_test_methods are taken from the same folder."""

import os
import unittest

import numpy as np

import pairs
import spaces
from test_benchmark import FolderTest, rotation
from test_problems import ProgramTest, program

SCENES = {"R": "rigid", "M": "rigidScaled"}
OWN = ["USACV20", "USACV20_FAST", "USACV20_MAGSAC", "USACV20+scores", "preset:msac{maxIterations=500}"]
RIVALS = ["cv:AFFINE3D", "cv:AFFINE3D_REFIT"]


def near_motion(count=30, **changes):
    """Returns `count` matches without noise and a motion that is close to the identity (0.4 degrees)
    unless `changes` has another one. The first five matches are not marked as right."""
    points = np.random.RandomState(5).uniform(-50, 50, (count, 3))
    values = dict(points1=points, points2=points, scores=np.linspace(0, 1, count), R=rotation((1, 2, 0.5), 0.4), t=(0.3, -0.2, 0.1),
                  right=range(5, count))
    values.update(changes)
    motion = spaces.Motion(**values)
    motion.points2 = motion.moved()
    return motion


class MotionsTest(FolderTest):

    def test_round_trip(self):
        for scale in (1, 1.5):
            motion = near_motion(scale=scale, extra={"sensor": "none"})
            path = self.path("pairs", "set", "a")
            spaces.write_motion(path, motion)
            again = spaces.read_motion(path)
            for name, tolerance in (("points1", 6e-6), ("points2", 6e-6), ("scores", 1e-6), ("R", 0), ("t", 0), ("scale", 0)):
                np.testing.assert_allclose(getattr(again, name), getattr(motion, name), rtol=0, atol=tolerance, err_msg=name)
            self.assertEqual((again.right, again.extra, again.problem),
                             (list(range(5, 30)), {"sensor": "none"}, "R" if scale == 1 else "M"))
            os.remove(path + ".score")
            self.assertEqual(set(spaces.read_motion(path).scores), {1.0})

    def test_nonsense_is_not_written(self):
        for changes, complaint in (({"scores": [1]}, "differ in number"), ({"R": 2 * np.eye(3)}, "no rotation"),
                                   ({"right": [30]}, "gt_mask: expected"), ({"right": [3]}, "the scene is one point"),
                                   ({"scale": 0}, "s: expected a number above 0"), ({"t": None}, "t: missing"),
                                   ({"t": (0, 0, np.nan)}, "t: not finite")):
            motion = near_motion()
            for name, value in changes.items():
                setattr(motion, name, value if value is None or name in ("right", "scale") else np.asarray(value, float))
            with self.assertRaisesRegex(pairs.PairError, complaint):
                spaces.write_motion(self.path("bad"), motion)
        with self.assertRaisesRegex(pairs.PairError, "s: expected 1 for R"):
            spaces.write_motion(self.path("bad"), near_motion(scale=2), "R")
        self.assertEqual(os.listdir(self.folder), [])

    def test_messages_name_file_and_line(self):
        path = self.path("a")
        for ending, contents, complaint in ((".txt", "1 2 3 4 5 6\n\n1 2 3 4 5\n", r"a\.txt:3: expected 'X1 Y1 Z1 X2 Y2 Z2'"),
                                            (".score", "0.5\n0.5 0.5\n", r"a\.score:2: expected a score"),
                                            (".json", '{"problem": ["E"]}', r"a\.json: problem: the pair is not one for R or M"),
                                            (".json", '{"problem": "R", "s": 2}', r"a\.json: s: expected 1 for R"),
                                            (".json", '{"R": [1]}', r"a\.json: R: expected 3 x 3 numbers")):
            spaces.write_motion(path, near_motion())
            self.put("a" + ending, contents)
            with self.assertRaisesRegex(pairs.PairError, complaint):
                spaces.read_motion(path)


@unittest.skipUnless(os.path.isfile(program("usac_synthetic")), "there is no usac_synthetic beside USAC_BENCHMARK")
class SyntheticMotionTest(ProgramTest):

    def motion(self, letter, *options):
        scene = SCENES[letter]
        self.write_scenes(scene, "--pairs=1", *options)
        paths = pairs.read_list(pairs.list_file(self.folder, scene, letter))
        self.assertEqual([os.path.basename(path) for path in paths], ["0000"])
        return spaces.read_motion(paths[0])

    def test_scene(self):
        for letter in SCENES:
            motion = self.motion(letter, "--size=100", "--inliers=0.3", "--noise=0", "--scores=1")
            distances = np.linalg.norm(motion.moved() - motion.points2, axis=1) / motion.scale
            self.assertEqual((len(distances), len(motion.right), motion.problem), (100, 30, letter))
            self.assertLess(distances[motion.right].max(), 1e-3)
            self.assertGreater(np.median(np.delete(distances, motion.right)), 50)
            self.assertLess(motion.scores[motion.right].max(), np.delete(motion.scores, motion.right).min(),
                            "with --scores=1, each right match must have a better score than all wrong ones")
            # The points fill a cube of side 200, for which size() is half of the side.
            self.assertAlmostEqual(motion.size() / (motion.scale * 100), 1, delta=0.15)

    def test_noise(self):
        motion = self.motion("R", "--size=5000", "--inliers=1", "--noise=2")
        self.assertAlmostEqual((motion.moved() - motion.points2).std(), 2, delta=0.06)

    def test_plane(self):
        for thickness in (0, 0.02):
            motion = self.motion("R", "--size=2000", "--thickness=%g" % thickness)
            centered = motion.points1 - motion.points1.mean(0)
            deviation = np.linalg.svd(centered, compute_uv=False)[2] / np.sqrt(2000)
            self.assertAlmostEqual(deviation / 200, thickness, delta=1e-6 if thickness == 0 else 0.002)
        thick = self.motion("R", "--size=2000").points1
        self.assertGreater(np.linalg.svd(thick - thick.mean(0), compute_uv=False)[2] / np.sqrt(2000), 50)

    def test_outliers(self):
        motion = self.motion("M", "--size=200", "--outliers=clustered", "--noise=0")
        wrong = np.delete(np.arange(200), motion.right)
        self.assertEqual(len(wrong), 100)
        self.assertLess(np.ptp(motion.points1[wrong], axis=0).max(), 25 * np.sqrt(3))
        self.assertLess(np.ptp(motion.points2[wrong], axis=0).max(), motion.scale * 25 * np.sqrt(3))
        self.assertGreater(np.median(np.linalg.norm(motion.moved() - motion.points2, axis=1)[wrong]), 10)

    def test_second_motion(self):
        """Half of the 100 wrong matches agree with a second motion. From the wrong matches alone, an
        estimator must find this motion. The result must count as failed, because the second motion
        differs from the true one."""
        motion = self.motion("R", "--size=200", "--outliers=second")
        wrong = np.delete(np.arange(200), motion.right)
        alone = spaces.Motion(motion.points1[wrong], motion.points2[wrong], motion.scores[wrong], motion.R, motion.t)
        spaces.write_motion(self.path("pairs", "rigid", "0000"), alone)
        row = self.benchmark(["USACV20"], "--threshold=2")[0]["USACV20"][0]
        self.assertTrue(49 <= int(row["inliers"]) <= 52, row)
        self.assertEqual(row["failed"], "1", "the second motion is not the right one")

    def test_same_options_write_the_same(self):
        texts = []
        for seed in (1, 1, 2):
            self.write_scenes("rigid", "--pairs=1", "--size=30", "--duplicates=0.5", "--seed=%d" % seed)
            texts.append([self.text("rigid", "0000" + ending) for ending in (".txt", ".score", ".json")])
        self.assertEqual(texts[0], texts[1])
        for one, other in zip(texts[0], texts[2]):
            self.assertNotEqual(one, other)
        self.assertEqual(len(set(texts[0][0].split("\n")[:-1])), 30 - 7)

    def test_methods(self):
        for scene in SCENES.values():
            self.write_scenes(scene, "--pairs=2", "--size=300", "--inliers=0.7", "--scores=0.9", "--noise=0.3")
        self.write_scenes("planar", "--pairs=1", "--size=100")
        runs, tables, text = self.benchmark(OWN + RIVALS + ["cv:RANSAC"])
        self.assertIn("## rigidScaled (M, 2 pairs, threshold 3, 10000 iterations, confidence 0.99)", text)
        self.assertIn("R, M: the error is that of the rotation in degrees", text)
        for method in OWN + RIVALS:
            rows = [row for row in runs[method] if row["problem"] in SCENES]
            self.assertEqual(len(rows), 4, method)
            for row in rows:
                self.assertEqual((row["failed"], row["pose_error"]), ("0", row["error"]), method)
                self.assertEqual(row["iterations"] != "", method in OWN)
                self.assertLess(float(row["error"]), 0.1 if method in OWN else 1)
                self.assertLess(float(row["center_error"]), 0.2 if method in OWN else 3)
                self.assertLess(abs(int(row["inliers"]) - 210), 12, method)
                self.assertLess(float(row["cost"]), 0.36 if method in OWN else 0.5)
            rotations = [float(row["error"]) for row in rows if row["list"] == "rigid"]
            table = tables["rigid", method]
            self.assertAlmostEqual(float(table["auc1"]), 100 * (1 - np.mean(rotations)), delta=1e-2)
            self.assertAlmostEqual(float(table["median_error"]), np.median(rotations), delta=1e-5)
        self.assertEqual({row["problem"] for row in runs["cv:RANSAC"]}, {"H"})
        self.assertNotIn(("planar", "cv:AFFINE3D"), tables)


@unittest.skipUnless(os.path.isfile(program("usac_test_methods")), "there is no usac_test_methods beside USAC_BENCHMARK")
class MeasuredMotionTest(ProgramTest):

    def measure(self, motion, letter=None):
        path, letter = self.path("pairs", "set", "a"), letter or motion.problem
        spaces.write_motion(path, motion, letter)
        pairs.write_list(pairs.list_file(self.folder, "set", letter), [path])
        rows = self.benchmark(["custom:identity"], "--problem=" + letter, name="usac_test_methods")[0]["custom:identity"]
        self.assertEqual([row["problem"] for row in rows], [letter])
        return rows[0]

    def test_measures(self):
        """The measures of the identity as a model must agree with values computed with numpy."""
        for changes in ({}, {"t": (2, 1, -1)}, {"scale": 1.02}, {"scale": 1.2}, {"right": None}):
            motion = near_motion(**changes)
            row = self.measure(motion)
            self.assertAlmostEqual(float(row["error"]), 0.4, delta=1e-4)
            distances = np.linalg.norm(motion.points1 - motion.points2, axis=1)
            right = slice(None) if motion.right is None else motion.right
            distance = 100 * np.sqrt(np.mean(distances[right] ** 2)) / motion.size()
            self.assertAlmostEqual(float(row["center_error"]) / distance, 1, delta=1e-4)
            self.assertAlmostEqual(float(row["cost"]), np.mean(np.minimum(1, (distances / 3) ** 2)), delta=1e-4)
            self.assertEqual((row["failed"], row["inliers"]), (str(int(distance > 5)), "30"))
        # A rotation error of more than 5 degrees is a failure. The points are close to the axis of the
        # rotation, so that the center error is small and does not decide.
        for degrees in (4.9, 5.1):
            points = np.column_stack((np.linspace(-50, 50, 30), np.linspace(-3, 3, 30), np.zeros(30)))
            row = self.measure(near_motion(points1=points, points2=points, R=rotation((1, 0, 0), degrees), t=(0, 0, 0)))
            self.assertEqual(row["failed"], str(int(degrees > 5)))

    def test_mistakes(self):
        motion, path = near_motion(), self.path("pairs", "set", "a")
        pairs.write_list(pairs.list_file(self.folder, "set", "R"), [path])
        eye = '"R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]'
        for ending, contents, complaint in (
                (".txt", "1 2 3 4 5 6\n1 2 3\n", "a.txt:2: expected 'X1 Y1 Z1 X2 Y2 Z2'"),
                (".txt", "\n", "a.txt:1: no correspondences"),
                (".txt", "1 2 3 4 5 6 7\n", "a.txt:1: expected 'X1 Y1 Z1 X2 Y2 Z2'"),
                (".score", "1\n1\n", "a.score:2: 2 scores, but 30 correspondences"),
                (".json", '{"problem": "M"}', "the pair is not one for R"),
                (".json", "{%s}" % eye, "a.json:1: t: needed"), (".json", '{"t": [0, 0, 1]}', "a.json:1: R: needed"),
                (".json", '{"s": 2, %s, "t": [0, 0, 1]}' % eye, "s: expected 1 for R"),
                (".json", '{"s": 0, %s, "t": [0, 0, 1]}' % eye, "s: expected a number above 0"),
                (".json", '{"gt_mask": [30]}', "gt_mask: expected numbers of matches"),
                (".json", '{"gt_mask": [3], %s, "t": [0, 0, 1]}' % eye, "gt_mask: the scene is one point")):
            spaces.write_motion(path, motion)
            self.put("pairs/set/a" + ending, contents)
            done = self.call("usac_benchmark", "--data=" + self.folder, "--methods=cv:AFFINE3D")
            self.assertEqual(done.returncode, 2, contents)
            self.assertIn(complaint, done.stderr)
        for scene, option, complaint in (("rigid", "--outliers=local", "for pairs of images only"),
                                         ("rigid", "--angle=3", "--angle"), ("rigid", "--thickness=0.6", "--thickness"),
                                         ("rigid", "--distortion=0.1", "--distortion"), ("planar", "--thickness=0.1", "--thickness")):
            done = self.call("usac_synthetic", "--out=" + self.path("none"), "--scene=" + scene, option)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(complaint, done.stderr)


if __name__ == "__main__":
    unittest.main()
