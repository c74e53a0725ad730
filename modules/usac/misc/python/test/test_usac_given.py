#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the functions without a random search (modelErrors, fitModel, refineModel, removeDistortion,
and those that convert covariances), of estimateRelativePose, and of the warnings about units."""

import unittest
import warnings

import numpy as np

from usac_camera import rotation
from usac_common import ERRORS, FINDER, GENERAL, PLANE, RANSAC, Scene, cv, needsCv2, usac

K = np.array([[800, 0, 410], [0, 790, 305], [0, 0, 1.0]])


def confident(points):
    """Returns the points with a third column that looks like confidences, which must be refused."""
    return np.hstack([points, np.linspace(0.2, 0.9, len(points))[:, None]])


class GivenTest(unittest.TestCase):

    def scenes(self):
        solid = Scene(planar=False, distorted=True)
        cameras = dict(cameraMatrix1=solid.K1, cameraMatrix2=solid.K2, distCoeffs1=solid.d1, distCoeffs2=solid.d2)
        return (usac.HOMOGRAPHY, PLANE, {}, usac.estimateHomography), (usac.ESSENTIAL, solid, cameras, usac.estimateEssential)

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
            self.assertEqual((report.stop, report.inliers, report.sample), (usac.STOP_NO_SEARCH, np.count_nonzero(inliers), ()))
            weighted, _, _ = usac.fitModel(problem, scene.points1, scene.points2, weights=scene.inliers.astype(float), **cameras)
            np.testing.assert_array_equal(fitted, weighted)
            refined, _, report = usac.refineModel(problem, model, scene.points1, scene.points2, chosen=scene.inliers, **cameras)
            sums = [np.sum(usac.modelErrors(problem, one, scene.points1, scene.points2, **cameras)[scene.inliers]**2)
                    for one in (fitted, refined, model)]
            self.assertAlmostEqual(sums[0], sums[1], delta=1e-3 * sums[0])
            self.assertLessEqual(sums[0], sums[2] * (1 + 1e-9))
            polished, inliers, _ = usac.refineModel(problem, model, scene.points1, scene.points2, **cameras)
            self.assertGreaterEqual(np.count_nonzero(inliers), 0.95 * np.count_nonzero(mask))

    def test_mistakes(self):
        a, b = PLANE.points1, PLANE.points2
        for call, name in ((lambda: usac.fitModel(usac.HOMOGRAPHY, a, b[:9]), "points"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, a, b, weights=[1, 2]), "weights"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, a, b, weights=-np.ones(300)), "weights"),
                           (lambda: usac.fitModel(usac.HOMOGRAPHY, a, b, chosen=[True]), "chosen"),
                           (lambda: usac.refineModel(usac.HOMOGRAPHY, np.eye(2), a, b), "model"),
                           (lambda: usac.refineModel(usac.HOMOGRAPHY, a, b, np.eye(3)), "model: "),
                           (lambda: usac.modelErrors(usac.HOMOGRAPHY, None, a, b), "model"),
                           (lambda: usac.modelErrors(usac.ESSENTIAL, np.eye(3), a, b), "cameraMatrix1"),
                           (lambda: usac.fitModel(usac.ABSOLUTE_POSE, np.c_[a, a[:, 0]], b), "cameraMatrix1: ")):
            with self.assertRaisesRegex(usac.error, name):
                call()
        for problem in ("H", usac.USACV20, 99, 3.0, a):
            with self.assertRaisesRegex(Exception, "problem: a ProblemType is expected, HOMOGRAPHY"):
                usac.fitModel(problem, a, b)
        for name, wrong in (("confidence", confident(a)), ("one list", np.stack([a, a]))):
            for call, named in ((lambda: usac.fitModel("homography", wrong, b), "points1"),
                                (lambda: usac.refineModel("homography", np.eye(3), b, wrong), "points2"),
                                (lambda: usac.modelErrors("homography", np.eye(3), wrong, b), "points1"),
                                (lambda: usac.fitModel("absolute_pose", np.c_[a, a], wrong, cameraMatrix1=K), "points2")):
                with self.assertRaisesRegex(usac.error, named + ".*" + name):
                    call()
        space = confident(a / 640)  # 3-D points: the last column is a coordinate, not a confidence
        np.testing.assert_allclose(usac.modelErrors("rigid_3d", np.eye(3, 4), space, space), 0, atol=1e-12)
        model, mask, report = usac.fitModel(usac.HOMOGRAPHY, a[:3], b[:3])
        self.assertEqual((model, mask.tolist(), report.stop), (None, [[0]] * 3, usac.STOP_TOO_FEW_POINTS))

    def test_empty_lists(self):
        """An empty list of weights or of chosen points has the wrong length, unless there are no points.
        Only None stands for all points."""
        for empty in ([], np.zeros((0, 1), bool)):
            for name in ("weights", "chosen"):
                with self.assertRaisesRegex(usac.error, name + ": .*None"):
                    usac.fitModel(usac.HOMOGRAPHY, PLANE.points1, PLANE.points2, **{name: empty})
            with self.assertRaisesRegex(usac.error, "chosen: .*None"):
                usac.refineModel(usac.HOMOGRAPHY, np.eye(3), PLANE.points1, PLANE.points2, chosen=empty)
            none = np.zeros((0, 2))
            self.assertEqual(usac.fitModel(usac.HOMOGRAPHY, none, none, empty, empty)[2].stop, usac.STOP_TOO_FEW_POINTS)
            self.assertEqual(usac.refineModel(usac.HOMOGRAPHY, np.eye(3), none, none, empty)[1].shape, (0, 1))


class RelativePoseTest(unittest.TestCase):

    def test_motion(self):
        for scene in (GENERAL, Scene(planar=False, distorted=True)):
            R, t, mask, pose = usac.estimateRelativePose(scene.points1, scene.points2, scene.K1, scene.d1, scene.K2, scene.d2)
            self.assertEqual((R.shape, t.shape, mask.shape), ((3, 3), (3, 1), (300, 1)))
            np.testing.assert_allclose(R, rotation([0.03, -0.1, 0.05]), atol=0.01)  # the true motion in Scene
            np.testing.assert_allclose(t[:, 0], np.array([-0.8, 0.1, 0.1]) / np.linalg.norm([-0.8, 0.1, 0.1]), atol=0.1)
            self.assertEqual(pose.report.inliers, np.count_nonzero(mask))
            self.assertEqual((pose.onPlane, pose.otherR, pose.otherT, pose.otherInliers), (0, None, None, 0))
            self.assertEqual(pose.essential.shape, (3, 3))
        R, _, _, pose = usac.estimateRelativePose(PLANE.points1, PLANE.points2, PLANE.K1)
        self.assertGreater(pose.onPlane, 150)
        self.assertLess(min(np.abs(one - rotation([0.03, -0.1, 0.05])).max() for one in (R, pose.otherR)), 0.02)

    def test_no_model(self):
        a, b, own = GENERAL.points1, GENERAL.points2, np.zeros((4, 1), np.uint8)
        R, t, mask, pose = usac.estimateRelativePose(a[:4], b[:4], GENERAL.K1, mask=own)
        self.assertEqual((R, t, pose.essential, pose.report.stop), (None, None, None, usac.STOP_TOO_FEW_POINTS))
        self.assertIs(mask, own)

    def test_mistakes_and_masks(self):
        a, b, own = GENERAL.points1, GENERAL.points2, GENERAL.K1
        for arguments, name in (((a, b[:7], own), "points"), ((a, b, np.eye(2)), "cameraMatrix1"), ((a, b, own, [1, 2]), "distCoeffs1"),
                                ((a, confident(b), own), "points2.*confidence"),
                                ((np.stack([a, a]), np.stack([b, b]), own), "points1.*one list"),
                                ((a, b, own, None, None, None, None, np.zeros((len(a), 1))), "mask.*float64")):
            with self.assertRaisesRegex(usac.error, name):
                usac.estimateRelativePose(*arguments)
        mask = np.zeros(len(a), bool)
        self.assertIs(usac.estimateRelativePose(a, b, own, mask=mask)[2], mask)
        np.testing.assert_array_equal(mask, usac.estimateRelativePose(a, b, own)[2].ravel() != 0)


class CovarianceTest(unittest.TestCase):

    def test_shapes(self):
        a, b, right = PLANE.points1, PLANE.points2, PLANE.K1
        self.assertIsNone(usac.estimateHomography(a, b)[2].covariance)
        H, _, report = usac.estimateHomography(a, b, usac.Params(covariance=1))
        T = usac.tangentOfModel("homography", H)
        self.assertEqual((report.covariance.shape, T.shape), ((8, 8), (9, 8)))
        self.assertTrue(0.2 < report.sigma < 0.5, report.sigma)
        C = usac.covarianceOfModel(usac.HOMOGRAPHY, H, report.covariance)
        np.testing.assert_allclose(C, T.dot(report.covariance).dot(T.T), rtol=1e-9, atol=0)
        np.testing.assert_array_equal(C[8], 0)  # h33 is always 1
        self.assertEqual(usac.pointCovariance("homography", H, report.covariance, a).shape, (300, 2, 2))
        R, t, _, pose = usac.estimateRelativePose(GENERAL.points1, GENERAL.points2, right, params=usac.Params(covariance=1))
        E, covariance = pose.essential, pose.report.covariance
        self.assertEqual(usac.covarianceOfPose(E, covariance, R, t).shape, (6, 6))
        self.assertEqual(usac.pointCovariance("essential", E, covariance, a, b, right).shape, (300, 1, 1))
        space = confident(a)  # 3-D points: the last column is a coordinate, not a confidence
        self.assertEqual(usac.pointCovariance("rigid_3d", np.eye(3, 4), np.eye(6), space).shape, (300, 3, 3))
        none = np.empty((0, 2))
        for problem, model, d, k in (("homography", np.eye(3), 8, 2), ("fundamental", E, 7, 1)):
            found = usac.pointCovariance(problem, model, np.eye(d), none, none if k == 1 else None)
            self.assertEqual(found.shape, (0, k, k))

    def test_mistakes(self):
        a, H, C = PLANE.points1, np.eye(3), np.eye(8)
        for call, name in ((lambda: usac.covarianceOfModel("homography", H, np.eye(7)), "covariance"),
                           (lambda: usac.tangentOfModel("homography", np.eye(2)), "model"),
                           (lambda: usac.tangentOfModel("homographie", H), "problem"),
                           (lambda: usac.covarianceOfPose(np.eye(3), np.eye(5), 2 * np.eye(3), [1, 0, 0]), "R"),
                           (lambda: usac.pointCovariance("homography", H, C, confident(a)), "points1.*confidence"),
                           (lambda: usac.pointCovariance("homography", H, C, np.stack([a, a])), "points1.*one list"),
                           (lambda: usac.pointCovariance("homography", H, C, a, confident(a)), "points2.*confidence"),
                           (usac.Params(covariance=2).check, "covariance")):
            with self.assertRaisesRegex(usac.error, name):
                call()


class LensTest(unittest.TestCase):

    @needsCv2
    def test_is_the_inverse_of_projectPoints(self):
        ideal = np.stack(np.meshgrid(np.linspace(0, 800, 9), np.linspace(0, 600, 7)), axis=-1).reshape(-1, 2)
        coefficients = np.array([-.3, .1, .002, -.001, -.01, .05, .02, -.01, .003, -.001, .002, .001, .02, -.03])
        rays = np.c_[(ideal - K[:2, 2]) / K[[0, 1], [0, 1]], np.ones(len(ideal))]
        for count in (4, 5, 8, 12, 14):
            lens = coefficients[:count]
            taken = cv.projectPoints(rays, np.zeros(3), np.zeros(3), K, lens)[0][:, 0]
            for points in (taken, taken.T, taken[:, None], taken.tolist()):
                found = usac.removeDistortion(points, K.tolist(), lens)
                self.assertEqual((found.shape, found.dtype), (ideal.shape, np.float64))
                np.testing.assert_allclose(found, ideal, atol=1e-9, err_msg=str(count))
        np.testing.assert_allclose(usac.removeDistortion(points=ideal, cameraMatrix=K, distCoeffs=None), ideal, atol=1e-9)

    def test_what_is_not_seen_is_not_a_number(self):
        # The distorted radius r (1 - 0.25 r^2) is at most 0.77, or 616 pixels. Pixels farther from the
        # center correspond to no ray.
        found = usac.removeDistortion([[410 + 610, 305], [410 + 620, 305], [np.nan, 3], [3, np.inf]], K, (-.25, 0, 0, 0))
        self.assertTrue(np.isfinite(found[0]).all())
        self.assertTrue(np.isnan(found[1:]).all())
        self.assertEqual(usac.removeDistortion(np.empty((0, 2)), K).shape, (0, 2))

    def test_mistakes(self):
        points = np.zeros((3, 2))
        for name, args in (("points", (np.zeros((1, 4)), K, None)), ("points", (None, K, None)),
                           ("cameraMatrix", (points, np.zeros((3, 3)), None)), ("distCoeffs", (points, K, [1, 2, 3]))):
            with self.assertRaisesRegex(ERRORS, name):
                usac.removeDistortion(*args)


class WarningTest(unittest.TestCase):

    def test_warnings(self):
        """A camera matrix that is probably wrong gives a warning about the line of the call; the right one
        gives none, and neither does a flag of OpenCV."""
        a, b, right, p = GENERAL.points1, GENERAL.points2, GENERAL.K1, usac.Params()
        X = np.hstack([(a - right[:2, 2]) / 800, np.ones((len(a), 1))]) * np.random.RandomState(1).uniform(4, 8, (len(a), 1))
        calls = (lambda K: usac.estimateEssential(a, b, K, params=p), lambda K: usac.estimateRelativePose(a, b, K, params=p),
                 lambda K: usac.estimateEssentials([a], [b], K, params=p),
                 lambda K: FINDER.findEssentialMat(a, b, K, usac.USACV20, .99, 2.), lambda K: usac.findEssentialMat(a, b, K, p),
                 lambda K: FINDER.findEssentialMat(a, b, K[0, 0], tuple(K[:2, 2]), usac.USACV20, .99, 2.),
                 lambda K: usac.findEssentialMat(a, b, K, None, K, None, usac.USACV20),
                 lambda K: usac.refineModel("essential", np.eye(3), a, b, params=p, cameraMatrix1=K),
                 lambda K: usac.estimateAbsolutePose(X, a, K), lambda K: FINDER.solvePnPRansac(X, a, K, None, flags=usac.USACV20),
                 lambda K: usac.solvePnPRansac(X, a, K, None, params=p))
        for i, call in enumerate(calls):
            for K in (right, np.eye(3)):
                with warnings.catch_warnings(record=True) as seen:
                    warnings.simplefilter("always")
                    call(K)
                    with usac.progress(lambda report: None):
                        call(K)
                self.assertEqual([(one.category, one.filename) for one in seen],
                                 [(usac.UsacWarning, __file__)] * 2 if K is not right else [], i)
                self.assertTrue(all("80 degrees" in str(one.message) for one in seen), i)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            usac.findEssentialMat(a, b, np.eye(3), RANSAC, .99, 2.)
        with self.assertWarnsRegex(usac.UsacWarning, "threshold"):
            FINDER.findHomography(a / 800, b / 800, usac.USACV20, 3.0)


if __name__ == "__main__":
    unittest.main()
