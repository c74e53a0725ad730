#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the readers of ground truth (ground_truth.py) on tiny files in the format of each data
set, and of the distances of geometry.py."""

import os
import unittest

import numpy as np

from test_benchmark import C1, C2, K, POINTS, R1, R2, SIZE, FolderTest, project, text
import geometry
import ground_truth

try:
    from scipy.io import savemat
except ImportError:
    savemat = None


class ReadersTest(FolderTest):

    def check_cameras(self, truth, R=None, center=None):
        """The cameras and their relative pose must be those of the scene in test_benchmark.py. Its
        points must fulfill the epipolar constraint and have positive depths."""
        a, b = truth.cameras
        np.testing.assert_allclose(a.matrix(SIZE), K, atol=1e-9)
        R12, t = geometry.relative_pose(a, b)
        np.testing.assert_allclose(R12, R2 @ R1.T if R is None else R, atol=1e-9)
        np.testing.assert_allclose(t, R2 @ (C1 - C2), atol=1e-9)
        F = geometry.fundamental(K, K, R12, t)
        self.assertLess(geometry.sampson_distance(F, project(R1, C1), project(R2, C2)).max(), 1e-6)
        self.assertTrue(geometry.in_front(K, K, R12, t, project(R1, C1), project(R2, C2)).all())
        self.assertFalse(geometry.in_front(K, K, R12, -t, project(R1, C1), project(R2, C2)).any())
        self.assertEqual(truth.problems, ["E", "F"])

    def camera_file(self, R, center):
        return text(*K) + "0 0 0\n" + text(*R.T) + text(center) + "640 480\n"

    def test_strecha(self):
        for image, R, center in (("0000.png", R1, C1), ("0001.png", R2, C2)):
            self.put("fountain/gt/%s.camera" % image, self.camera_file(R, center))
            self.put("fountain/urd/" + image)
            for place in ("a", "b"):  # two more scenes, each with images and cameras in one folder
                self.put("more/%s/%s.camera" % (place, image), self.camera_file(R, center))
                self.put("more/%s/%s" % (place, image))
        truths = ground_truth.strecha(self.folder)
        self.assertEqual([t.name for t in truths], ["fountain_0000_0001", "a_0000_0001", "b_0000_0001"])
        self.assertEqual([t.name for t in ground_truth.strecha(self.path("fountain"))], ["fountain_0000_0001"])
        self.assertEqual(truths[0].image2, self.path("fountain", "urd", "0001.png"))
        for truth in truths:
            self.check_cameras(truth)
        os.remove(self.path("fountain", "urd", "0000.png"))
        with self.assertRaisesRegex(ground_truth.DataError, r"0000\.png\.camera: expected one image 0000\.png"):
            ground_truth.strecha(self.folder)

    def kitti(self):
        still = np.column_stack((R2.T, C2))
        self.put("poses/06.txt", text(np.column_stack((R1.T, C1)), still, still))
        self.put("poses/07.txt", text(still))  # the folder of this sequence is missing, so it must be skipped
        matrix = np.column_stack((K, np.zeros(3)))
        self.put("sequences/06/calib.txt", "P1: 1 2\nP0: " + text(matrix) + "P2: 3\n")

    def test_kitti(self):
        self.kitti()
        truths = ground_truth.kitti(self.folder)
        self.assertEqual([t.name for t in truths], ["k06_000000_000001"])  # frames 1 and 2 have the same pose and give no pair
        self.assertEqual(truths[0].image1, self.path("sequences", "06", "image_0", "000000.png"))
        self.check_cameras(truths[0])
        truths = ground_truth.kitti(self.folder, step=2)
        self.assertEqual([t.name for t in truths], ["k06_000000_000002"])
        self.put("poses/06.txt", "1 2 3\n")
        with self.assertRaisesRegex(ground_truth.DataError, r"06\.txt: expected a multiple of 12 numbers, found 3"):
            ground_truth.kitti(self.folder)

    def test_tum(self):
        quaternions = []
        # TUM stores the rotation camera -> world, so the quaternions are those of R1 and R2 transposed.
        for axis, angle in (((1, 2, 0.5), -10), ((-0.3, 1, 0.2), 12)):
            half = np.radians(angle) / 2
            quaternions.append(np.append(np.sin(half) * np.array(axis) / np.linalg.norm(axis), np.cos(half)))
        root = "rgbd_dataset_freiburg3_test"
        self.put(root + "/groundtruth.txt", "# timestamp tx ty tz qx qy qz qw\n"
                 + text([10.001, *C1, *quaternions[0]], [10.5, 0, 0, 9, 0, 0, 0, 1], [11.0, *C2, *quaternions[1]]))
        self.put(root + "/rgb.txt", "# color images\n10.0 rgb/10.png\n10.2 rgb/far.png\n11.01 rgb/11.png\n")
        truth, = ground_truth.tum(self.folder)
        self.assertEqual(truth.name, root + "_10_11")
        self.assertEqual(truth.image2, self.path(root, "rgb", "11.png"))
        fixed = np.array([[535.4, 0, 320.1], [0, 539.2, 247.6], [0, 0, 1]])
        for camera in truth.cameras:
            np.testing.assert_array_equal(camera.matrix(SIZE), fixed)
            self.assertIsNone(camera.distortion)
            camera.K = K
        self.check_cameras(truth)
        os.rename(self.path(root), self.path("freiburg1"))
        self.assertEqual(len(ground_truth.tum(self.folder)[0].cameras[0].distortion), 5)
        os.rename(self.path("freiburg1"), self.path("mine"))
        with self.assertRaisesRegex(ground_truth.DataError, "the name does not say which camera"):
            ground_truth.tum(self.folder)

    def test_bundler(self):
        flip = np.diag([1.0, -1, -1])
        rows = []
        for R, center, focal in ((R1, C1, 700), (np.zeros((3, 3)), C1 * 0, 0), (R2, C2, 650)):
            rows += [[focal, 0.01 if focal == 650 else 0, 0]] + list(flip @ R) + [-flip @ R @ center]
        self.put("scene/gt_bundle.out", "# Bundle file v0.3\n3 1\n" + text(*rows) + "1 2 3\n0 0 0\n0\n")
        self.put("scene/list.txt", "images/a.jpg 0 700\nimages/b.jpg\nimages/c.jpg 0 650\n")
        self.put("scene/EGs.txt", "0 2 1 0 0 0 1 0 0 0 1 1 0 0\n0 1 1 0 0 0 1 0 0 0 1 1 0 0\n")
        truth, = ground_truth.one_dsfm(self.path("scene"))
        self.assertEqual(truth.name, "scene_0_2")
        self.assertEqual(truth.image2, self.path("scene", "images/c.jpg"))
        a, b = truth.cameras
        self.assertEqual((a.distortion, b.distortion), (None, (0.01, 0, 0, 0)))
        np.testing.assert_allclose(b.matrix((641, 481)), [[650, 0, 320], [0, 650, 240], [0, 0, 1]])
        # In Bundler's format the image point is -f P / P.z, with y upward from the middle of the image.
        # The camera that was read must project to the same point.
        inCamera = (POINTS - C2) @ (flip @ R2).T
        p = 650 * -inCamera[:, :2] / inCamera[:, 2:]
        np.testing.assert_allclose(np.column_stack((320 + p[:, 0], 240 - p[:, 1])), project(b.R, C2, b.matrix((641, 481))))
        a.K = b.K = K
        self.check_cameras(truth)
        self.put("scene/EGs.txt", "0 3 1\n")
        with self.assertRaisesRegex(ground_truth.DataError, r"EGs\.txt:1: there are only 3 cameras"):
            ground_truth.one_dsfm(self.path("scene"))

    def fm_bench(self, folder):
        F = geometry.fundamental(K, K, R2 @ R1.T, R2 @ (C1 - C2))
        self.put(folder + "/pairs_with_gt.txt", text([3, 12, *F.ravel()], [4, 5, *F.ravel()]))
        self.put(folder + "/pairs_which_dataset.txt", "Barn/\nsub/Truck/\n")

    def test_fm_bench(self):
        self.fm_bench("set")
        for reader in (ground_truth.tanks_and_temples, ground_truth.cpc, ground_truth.kitti, ground_truth.tum):
            truths = reader(self.path("set"))
            self.assertEqual([t.name for t in truths], ["Barn_3_12", "sub_Truck_4_5"])
            self.assertEqual(truths[0].image2, self.path("set", "Barn", "Images", "00000012.jpg"))
            self.assertEqual(truths[0].problems, ["F"])
            self.assertLess(geometry.sampson_distance(truths[0].F, project(R1, C1), project(R2, C2)).max(), 1e-6)
        self.put("set/pairs_which_dataset.txt", "Barn/\n")
        with self.assertRaisesRegex(ground_truth.DataError, "has 2 lines"):
            ground_truth.cpc(self.path("set"))

    def test_evd(self):
        H = np.array([[0.9, 0.1, 5], [-0.1, 1.1, 3], [1e-4, 2e-4, 1]])
        self.put("h/adam.txt", text(*H))
        with self.assertRaisesRegex(ground_truth.DataError, r"no image adam"):
            ground_truth.evd(self.folder)
        for part in "12":
            self.put(part + "/adam.png")
        truth, = ground_truth.evd(self.folder)
        self.assertEqual((truth.name, truth.problems, truth.image2), ("adam", ["H"], self.path("2", "adam.png")))
        np.testing.assert_array_equal(truth.H, H)

    @unittest.skipUnless(savemat, "SciPy is missing")
    def test_annotated(self):
        points = np.array([[1.0, 2, 3, 4], [5, 6, 7, 8], [9, 1, 2, 3]])
        weights = np.array([2.0, 1, 4])  # homogeneous coordinates with different scales
        stacked = np.vstack((points[:, :2].T * weights, weights, points[:, 2:].T, np.ones(3)))
        for letter in "AB":
            self.put("box%s.jpg" % letter)
        savemat(self.path("box_vpts.mat"), {"validation": {"pts": stacked, "model": np.eye(3)}})
        for reader, problem in ((ground_truth.homogr, "H"), (ground_truth.kusvod2, "F")):
            truth, = reader(self.folder)
            self.assertEqual((truth.name, truth.problems), ("box", [problem]))
            self.assertEqual(truth.image1, self.path("boxA.jpg"))
            np.testing.assert_allclose(truth.points, points)
        savemat(self.path("box_vpts.mat"), {"validation": {"model": np.eye(3)}})
        with self.assertRaisesRegex(ground_truth.DataError, "no structure 'validation' with a member 'pts'"):
            ground_truth.homogr(self.folder)

    def test_missing_files(self):
        for reader in (ground_truth.homogr, ground_truth.evd, ground_truth.kusvod2, ground_truth.strecha, ground_truth.kitti,
                       ground_truth.tum, ground_truth.tanks_and_temples, ground_truth.cpc, ground_truth.one_dsfm):
            with self.assertRaises(ground_truth.DataError, msg=reader.__name__):
                reader(self.folder)

    def test_distances(self):
        H = np.array([[2.0, 0, 1], [0, 2, 0], [0, 0.01, 1]])
        errors = geometry.transfer_error(H, np.array([[1.0, 0], [1, 0], [3, -100]]), np.array([[3.0, 0], [0, 4], [0, 0]]))
        np.testing.assert_allclose(errors, [0, 5, np.inf])
        # The camera moves along x, so epipolar lines are rows of the image. The rows 3 and 7 differ by
        # 4 pixels, so each point must move by 2 pixels: a distance of 4 / sqrt(2) in four dimensions.
        F = np.array([[0.0, 0, 0], [0, 0, -1], [0, 1, 0]])
        np.testing.assert_allclose(geometry.sampson_distance(F, np.array([[5.0, 3]]), np.array([[9.0, 7]])), 4 / np.sqrt(2))


if __name__ == "__main__":
    unittest.main()
