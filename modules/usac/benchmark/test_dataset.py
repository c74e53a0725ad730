#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of dataset.py, which makes pairs from images and ground truth. The tests are skipped if cv2 is
missing, has no SIFT or reads no images."""

import contextlib
import io
import os
import shutil
import unittest

import numpy as np

from test_benchmark import FolderTest, rotation, text
import geometry
import ground_truth
import pairs

try:
    import cv2
    import dataset
    HAS_SIFT = hasattr(cv2, "SIFT_create") and hasattr(cv2, "imread")
except ImportError:
    HAS_SIFT = False


@unittest.skipUnless(HAS_SIFT, "cv2 has no SIFT or reads no images")
class BuildTest(FolderTest):
    """Tests of making pairs from images."""

    H = np.array([[0.95, 0.08, 12], [-0.06, 0.97, 20], [1e-4, -5e-5, 1]])

    def images(self):
        noise = np.random.RandomState(2)
        image = sum(cv2.resize(noise.uniform(0, 255, (240 // s, 320 // s)).astype(np.float32), (320, 240),
                               interpolation=cv2.INTER_CUBIC) for s in (4, 8, 16)) / 3
        image = np.clip(image * 1.6 - 76, 0, 255).astype(np.uint8)
        return image, cv2.warpPerspective(image, self.H, (320, 240))

    def run_dataset(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = dataset.main([*arguments, "--images", self.path("in"), "--out", self.path("out")])
        return code, out.getvalue(), err.getvalue()

    def evd(self, name):
        for part, image in zip("12", self.images()):
            os.makedirs(self.path("in", part), exist_ok=True)
            cv2.imwrite(self.path("in", part, name + ".png"), image)
        self.put("in/h/%s.txt" % name, text(*self.H))

    def test_center_of_the_first_pixel_is_zero(self):
        y, x = np.mgrid[:90, :100]
        for at in ((50, 40), (50.5, 40.25)):
            spot = 20 + 220 * np.exp(-((x - at[0]) ** 2 + (y - at[1]) ** 2) / 18)
            points, _ = dataset.detect(np.uint8(np.round(spot)), 10)
            self.assertLess(np.linalg.norm(points - at, axis=1).min(), 0.05)

    def test_homography(self):
        self.evd("wall")
        code, out, err = self.run_dataset("evd")
        self.assertEqual((code, err), (0, ""))
        path, = pairs.read_list(pairs.list_file(self.path("out"), "evd", "H"))
        pair = pairs.read_pair(path)
        self.assertEqual((pair.problems, pair.gt_kind, pair.extra), (["H"], "homography", {"gt_thresh_px": 3.0}))
        self.assertEqual((pair.size1.tolist(), pair.size2.tolist()), ([320, 240], [320, 240]))
        np.testing.assert_array_equal(pair.H, self.H)
        errors = geometry.transfer_error(self.H, pair.points1, pair.points2)
        self.assertEqual(len(pair.gt_points), np.sum(errors < 3))
        self.assertGreater(np.mean(errors < 3), 0.5)
        self.assertLess(np.median(errors[errors < 3]), 0.5)
        self.assertLess(pair.scores.max(), 0.85)

    def test_options(self):
        self.evd("wall")
        self.run_dataset("evd")
        path = self.path("out", "pairs", "evd", "wall")
        every = pairs.read_pair(path)
        self.run_dataset("evd", "--ratio", "0.6", "--tolerance", "1")
        strict = pairs.read_pair(path)
        self.assertLess(strict.scores.max(), 0.6)
        self.assertEqual(len(strict.scores), np.sum(every.scores < 0.59995))
        self.assertLess(geometry.transfer_error(self.H, strict.gt_points[:, :2], strict.gt_points[:, 2:]).max(), 1.01)
        self.run_dataset("evd", "--max", "30")
        best = pairs.read_pair(path)
        np.testing.assert_array_equal(np.sort(best.scores), np.sort(every.scores)[:30])
        rows = every.points1.tolist()
        order = [rows.index(row) for row in best.points1.tolist()]
        self.assertEqual(order, sorted(order))  # --max must keep the matches in the order of the features
        code, _, err = self.run_dataset("evd", "--least", "100000")
        self.assertEqual(code, 1)
        self.assertRegex(err, r"wall: left out: \d+ matches")

    def test_pairs_are_drawn(self):
        for name in "abcd":
            self.evd(name)
        self.put("in/1/b.png", "no image")
        drawn = set()
        for seed in range(4):
            shutil.rmtree(self.path("out"), ignore_errors=True)
            code, _, _ = self.run_dataset("evd", "--pairs", "2", "--seed", str(seed), "--features", "300")
            names = [os.path.basename(p) for p in pairs.read_list(pairs.list_file(self.path("out"), "evd", "H"))]
            self.assertEqual((code, len(names), names), (0, 2, sorted(names)))
            drawn.update(names)
        self.assertEqual(drawn, set("acd"))

    def test_poses(self):
        """Two cameras with known poses (1DSfM format) see a plane; the second camera has lens
        distortion. The distortion must be removed from the points, so that they agree with the
        homography of the plane."""
        normal, R, t = np.array([0, 0, 0.2]), rotation((0.2, 1, 0), 8), np.array([-0.5, 0.1, 0.05])
        matrix = np.array([[300.0, 0, 159.5], [0, 300, 119.5], [0, 0, 1]])
        image, _ = self.images()
        second = cv2.warpPerspective(image, matrix @ (R + np.outer(t, normal)) @ np.linalg.inv(matrix), (320, 240))
        y, x = np.mgrid[:240, :320].astype(np.float32)
        ideal = cv2.undistortPoints(np.dstack((x, y)).reshape(-1, 1, 2), matrix, np.array([0.3, 0, 0, 0]), P=matrix)
        second = cv2.remap(second, ideal.reshape(240, 320, 2), None, cv2.INTER_CUBIC)
        os.makedirs(self.path("in", "images"))
        for name, picture in zip("ab", (image, second)):
            cv2.imwrite(self.path("in", "images", name + ".png"), picture)
        flip = np.diag([1.0, -1, -1])
        self.put("in/gt_bundle.out", "# Bundle file v0.3\n2 0\n" + text([300, 0, 0], *flip, [0, 0, 0])
                 + text([300, 0.3, 0], *(flip @ R), flip @ t))
        self.put("in/list.txt", "images/a.png\nimages/b.png\n")
        self.put("in/EGs.txt", "0 1\n")
        code, _, err = self.run_dataset("1dsfm")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(sorted(os.listdir(self.path("out", "lists"))), ["1dsfm.E.list", "1dsfm.F.list"])
        pair = pairs.read_pair(pairs.read_list(pairs.list_file(self.path("out"), "1dsfm", "E"))[0])
        np.testing.assert_allclose(pair.R, R, atol=1e-12)
        np.testing.assert_allclose(pair.t, t, atol=1e-12)
        F = geometry.fundamental(matrix, matrix, R, t)
        self.assertGreater(len(pair.gt_points), 0.6 * len(pair.scores))
        self.assertLess(geometry.sampson_distance(F, pair.gt_points[:, :2], pair.gt_points[:, 2:]).max(), 1.001)
        H = matrix @ (R + np.outer(t, normal)) @ np.linalg.inv(matrix)
        self.assertLess(np.median(geometry.transfer_error(H, pair.gt_points[:, :2], pair.gt_points[:, 2:])), 0.5)

    def test_points_and_fundamental_matrices(self):
        """Published points must become the ground truth unchanged. If F is published, the ground truth
        must consist of the matches that agree with F. Here F = [e]x H, which agrees with all right
        matches of the plane."""
        self.evd("wall")
        files = [self.path("in", part, "wall.png") for part in "12"]
        args = dataset.parse(["cpc", "--images", self.folder, "--out", self.folder])
        points = np.array([[1.0, 2, 3, 4], [5, 6, 7, 8]])
        args.right = 2
        pair = dataset.build(ground_truth.Truth("a", *files, ["H"], points=points), args)
        self.assertEqual((pair.gt_kind, pair.gt_points.tolist(), pair.extra), ("annotated", points.tolist(), {}))
        args.right = 3
        with self.assertRaisesRegex(dataset.NoPair, "^2 of [0-9]+ matches are right$"):
            dataset.build(ground_truth.Truth("a", *files, ["H"], points=points), args)
        F = np.array([[0, -1, 120], [1, 0, -900], [-120, 900, 0]]) @ self.H
        pair = dataset.build(ground_truth.Truth("a", *files, ["F"], F=F), args)
        errors = geometry.sampson_distance(F, pair.points1, pair.points2)
        self.assertEqual((pair.problems, pair.gt_kind, len(pair.gt_points)), (["F"], "pose", np.sum(errors < 1)))
        self.assertGreater(np.mean(errors < 1), 0.5)

    def test_mistakes(self):
        code, _, err = self.run_dataset("evd")
        self.assertEqual(code, 1)
        self.assertRegex(err, "no [*].txt")
        with self.assertRaises(SystemExit):
            self.run_dataset("evd", "--pairs", "-1")


if __name__ == "__main__":
    unittest.main()
