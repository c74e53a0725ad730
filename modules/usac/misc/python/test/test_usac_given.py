#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the functions without a random search (modelErrors, fitModel, refineModel), and of
estimateRelativePose, which returns the motion between two views."""

import pickle
import unittest

import numpy as np

from usac_common import Scene, cv, needsCv2, usac


class GivenTest(unittest.TestCase):
    def scenes(self):
        flat, solid = Scene(planar=True), Scene(planar=False, distorted=True)
        cameras = dict(cameraMatrix1=solid.K1, cameraMatrix2=solid.K2, distCoeffs1=solid.d1, distCoeffs2=solid.d2)
        yield usac.HOMOGRAPHY, flat, {}, usac.estimateHomography
        yield usac.FUNDAMENTAL, Scene(planar=False), {}, usac.estimateFundamental
        yield usac.ESSENTIAL, solid, cameras, usac.estimateEssential

    def test_errors_are_those_of_the_mask(self):
        for problem, scene, cameras, estimate in self.scenes():
            model, mask, report = estimate(scene.points1, scene.points2, **cameras)
            errors = usac.modelErrors(problem, model, scene.points1, scene.points2, **cameras)
            self.assertEqual((errors.shape, errors.dtype), ((300, 1), np.float64))
            np.testing.assert_array_equal(mask == 1, errors <= report.threshold)
            single = usac.modelErrors(problem, model.astype(np.float32), scene.points1, scene.points2, **cameras)
            self.assertLess(np.median(np.abs(single - errors)), 0.01)

    def test_fit_and_refine(self):
        for problem, scene, cameras, estimate in self.scenes():
            model, mask, _ = estimate(scene.points1, scene.points2, **cameras)
            fitted, inliers, report = usac.fitModel(problem, scene.points1, scene.points2, chosen=scene.inliers, **cameras)
            self.assertEqual(report.stop, usac.STOP_NO_SEARCH)
            self.assertEqual(report.inliers, np.count_nonzero(inliers))
            self.assertEqual(report.inlierRatio, report.inliers / 300)
            self.assertEqual(report.sample, ())
            weighted, _, _ = usac.fitModel(problem, scene.points1, scene.points2, weights=scene.inliers.astype(float), **cameras)
            np.testing.assert_array_equal(fitted, weighted)
            refined, _, report = usac.refineModel(problem, model, scene.points1, scene.points2, chosen=scene.inliers, **cameras)
            sums = [np.sum(usac.modelErrors(problem, one, scene.points1, scene.points2, **cameras)[scene.inliers]**2)
                    for one in (fitted, refined, model)]
            self.assertAlmostEqual(sums[0], sums[1], delta=1e-3 * sums[0])
            self.assertLessEqual(sums[0], sums[2] * (1 + 1e-9))
            polished, inliers, _ = usac.refineModel(problem, model, scene.points1, scene.points2, **cameras)
            self.assertGreaterEqual(np.count_nonzero(inliers), 0.95 * np.count_nonzero(mask))

    @needsCv2
    def test_method_0_of_OpenCV(self):
        scene = Scene(planar=True)
        points1, points2 = scene.points1[scene.inliers], scene.points2[scene.inliers]
        H, _, _ = usac.fitModel(usac.HOMOGRAPHY, points1, points2)
        expected, _ = cv.findHomography(points1, points2, 0)
        np.testing.assert_allclose(H, expected, rtol=1e-4, atol=1e-4)

    def test_mistakes(self):
        scene = Scene(planar=True)
        for call, name in ((lambda: usac.fitModel(99, scene.points1, scene.points2), "problem"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, scene.points1, scene.points2[:9]), "points"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, scene.points1, scene.points2, weights=[1, 2]), "weights"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, scene.points1, scene.points2, weights=-np.ones(300)), "weights"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, scene.points1, scene.points2, chosen=[True]), "chosen"),
                           (lambda: usac.refineModel(usac.HOMOGRAPHY, np.eye(2), scene.points1, scene.points2), "model"),
                           (lambda: usac.modelErrors(usac.HOMOGRAPHY, None, scene.points1, scene.points2), "model"),
                           (lambda: usac.modelErrors(usac.ESSENTIAL, np.eye(3), scene.points1, scene.points2), "cameraMatrix1")):
            with self.assertRaisesRegex(usac.error, name):
                call()
        self.emptyLists(scene.points1, scene.points2)
        a, b = scene.points1, scene.points2
        weights = np.linspace(0.2, 0.9, len(a))[:, None]
        for name, wrong in (("confidence", np.hstack([a, weights])), ("one list", np.stack([a, a]))):
            for call, named in ((lambda: usac.fitModel("homography", wrong, b), "points1"),
                                (lambda: usac.refineModel("homography", np.eye(3), b, wrong), "points2"),
                                (lambda: usac.modelErrors("homography", np.eye(3), wrong, b), "points1"),
                                (lambda: usac.fitModel("absolute_pose", np.c_[a, a], wrong, cameraMatrix1=scene.K1), "points2")):
                with self.assertRaisesRegex(usac.error, named + ".*" + name):
                    call()
        space = np.hstack([a / 640, weights])  # 3-D points: the last column is a coordinate, not a confidence
        np.testing.assert_allclose(usac.modelErrors("rigid_3d", np.eye(3, 4), space, space), 0, atol=1e-12)
        model, mask, report = usac.fitModel(usac.HOMOGRAPHY, scene.points1[:3], scene.points2[:3])
        self.assertEqual((model, mask.tolist(), report.stop), (None, [[0]] * 3, usac.STOP_TOO_FEW_POINTS))

    def emptyLists(self, points1, points2):
        """An empty list of weights or of chosen points has the wrong length, unless there are no points.
        Only None stands for all points."""
        for empty in ([], (), np.zeros((0, 1), bool)):
            for name in ("weights", "chosen"):
                with self.assertRaisesRegex(usac.error, name + ": .*None"):
                    usac.fitModel(usac.HOMOGRAPHY, points1, points2, **{name: empty})
            with self.assertRaisesRegex(usac.error, "chosen: .*None"):
                usac.refineModel(usac.HOMOGRAPHY, np.eye(3), points1, points2, chosen=empty)
            none = np.zeros((0, 2))
            self.assertEqual(usac.fitModel(usac.HOMOGRAPHY, none, none, empty, empty)[2].stop, usac.STOP_TOO_FEW_POINTS)
            self.assertEqual(usac.refineModel(usac.HOMOGRAPHY, np.eye(3), none, none, empty)[1].shape, (0, 1))

    def test_report(self):
        scene = Scene(planar=True)
        _, mask, report = usac.estimateHomography(scene.points1, scene.points2)
        self.assertEqual(len(set(report.sample)), 4)
        self.assertGreaterEqual(sum(scene.inliers[list(report.sample)]), 3)
        self.assertEqual(report.inlierRatio, np.mean(mask))
        self.assertEqual(pickle.loads(pickle.dumps(report)), report)
        self.assertIn("sample=(", repr(report))


class RelativePoseTest(unittest.TestCase):
    r, t = np.array([0.03, -0.1, 0.05]), np.array([-0.8, 0.1, 0.1])  # the true motion in Scene: rotation vector, translation

    def rotation(self):
        angle = np.linalg.norm(self.r)
        x, y, z = self.r / angle
        K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K

    def check(self, scene, degrees):
        R, t, mask, pose = usac.estimateRelativePose(scene.points1, scene.points2, scene.K1, scene.d1, scene.K2, scene.d2)
        self.assertEqual((R.shape, t.shape, mask.shape), ((3, 3), (3, 1), (300, 1)))
        self.assertLess(np.degrees(np.arccos((np.trace(R @ self.rotation().T) - 1) / 2)), degrees)
        self.assertLess(np.degrees(np.arccos(min(1, float(t[:, 0] @ self.t) / np.linalg.norm(self.t)))), 10 * degrees)
        self.assertEqual(pose.report.inliers, np.count_nonzero(mask))
        self.assertAlmostEqual(float(np.linalg.norm(t)), 1)
        return pose

    def test_solid(self):
        pose = self.check(Scene(planar=False), 0.5)
        self.assertEqual((pose.onPlane, pose.otherR, pose.otherT, pose.otherInliers), (0, None, None, 0))
        self.assertEqual(pose.essential.shape, (3, 3))
        self.check(Scene(planar=False, distorted=True), 0.5)

    def test_plane(self):
        scene = Scene(planar=True)
        R, t, mask, pose = usac.estimateRelativePose(scene.points1, scene.points2, scene.K1)
        self.assertGreater(pose.onPlane, 150)
        motions = [R, pose.otherR]
        best = min(np.degrees(np.arccos(min(1, (np.trace(one @ self.rotation().T) - 1) / 2))) for one in motions)
        self.assertLess(best, 1)

    @needsCv2
    def test_as_recoverPose(self):
        scene = Scene(planar=False)
        R, t, mask, pose = usac.estimateRelativePose(scene.points1, scene.points2, scene.K1)
        _, expectedR, expectedT, _ = cv.recoverPose(pose.essential, scene.points1[mask[:, 0] == 1], scene.points2[mask[:, 0] == 1],
                                                    scene.K1)
        np.testing.assert_allclose(R, expectedR, atol=1e-9)
        np.testing.assert_allclose(t, expectedT, atol=1e-9)

    def test_no_model(self):
        scene = Scene(planar=False)
        own = np.zeros((4, 1), np.uint8)
        R, t, mask, pose = usac.estimateRelativePose(scene.points1[:4], scene.points2[:4], scene.K1, mask=own)
        self.assertEqual((R, t, pose.essential, pose.report.stop), (None, None, None, usac.STOP_TOO_FEW_POINTS))
        self.assertIs(mask, own)
        for arguments, name in (((scene.points1, scene.points2[:7], scene.K1), "points"),
                                ((scene.points1, scene.points2, np.eye(2)), "cameraMatrix1"),
                                ((scene.points1, scene.points2, scene.K1, [1, 2]), "distCoeffs1")):
            with self.assertRaisesRegex(usac.error, name):
                usac.estimateRelativePose(*arguments)

    def test_points_and_masks(self):
        scene = Scene(planar=False)
        a, b = scene.points1, scene.points2
        with self.assertRaisesRegex(usac.error, "points2.*confidence"):
            usac.estimateRelativePose(a, np.hstack([b, np.linspace(0.2, 0.9, len(b))[:, None]]), scene.K1)
        with self.assertRaisesRegex(usac.error, "points1.*one list"):
            usac.estimateRelativePose(np.stack([a, a]), np.stack([b, b]), scene.K1)
        with self.assertRaisesRegex(usac.error, "mask.*float64"):
            usac.estimateRelativePose(a, b, scene.K1, mask=np.zeros((len(a), 1)))
        own = np.zeros(len(a), bool)
        self.assertIs(usac.estimateRelativePose(a, b, scene.K1, mask=own)[2], own)
        np.testing.assert_array_equal(own, usac.estimateRelativePose(a, b, scene.K1)[2].ravel() != 0)


if __name__ == "__main__":
    unittest.main()
