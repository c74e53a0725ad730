#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of removing the lens distortion from image points."""

import unittest
import warnings

import numpy as np

from usac_common import ERRORS, FINDER, GENERAL, RANSAC, cv, needsCv2, usac

K = np.array([[800, 0, 410], [0, 790, 305], [0, 0, 1.0]])
COEFFICIENTS = np.array([-.3, .1, .002, -.001, -.01, .05, .02, -.01, .003, -.001, .002, .001, .02, -.03])


def corners():
    return np.stack(np.meshgrid(np.linspace(0, 800, 9), np.linspace(0, 600, 7)), axis=-1).reshape(-1, 2)


def radial(points, k1):
    """Applies a lens distortion with the single coefficient k1 to pixels; computed from the definition
    of the distortion."""
    rays = (points - K[:2, 2]) / K[[0, 1], [0, 1]]
    return rays * (1 + k1 * (rays**2).sum(axis=1))[:, None] * K[[0, 1], [0, 1]] + K[:2, 2]


class LensTest(unittest.TestCase):

    @needsCv2
    def test_is_the_inverse_of_projectPoints(self):
        ideal = corners()
        rays = np.c_[(ideal - K[:2, 2]) / K[[0, 1], [0, 1]], np.ones(len(ideal))]
        for count in (4, 5, 8, 12, 14):
            taken, _ = cv.projectPoints(rays, np.zeros(3), np.zeros(3), K, COEFFICIENTS[:count])
            found = usac.removeDistortion(taken, K, COEFFICIENTS[:count])
            self.assertEqual((found.shape, found.dtype), (ideal.shape, np.float64))
            np.testing.assert_allclose(found, ideal, atol=1e-9, err_msg=str(count))

    def test_layouts(self):
        ideal = corners()
        taken = radial(ideal, -.25)
        for points in (taken, taken.T, taken[:, None], taken.tolist(), np.asfortranarray(taken)):
            np.testing.assert_allclose(usac.removeDistortion(points, K.tolist(), (-.25, 0, 0, 0)), ideal, atol=1e-9)
        np.testing.assert_allclose(usac.removeDistortion(taken.astype(np.float32), K, (-.25, 0, 0, 0)), ideal, atol=1e-3)
        np.testing.assert_array_equal(usac.removeDistortion(points=taken, cameraMatrix=K, distCoeffs=None),
                                      usac.removeDistortion(taken, K))
        np.testing.assert_allclose(usac.removeDistortion(taken, K), taken, atol=1e-9)
        self.assertEqual(usac.removeDistortion(np.empty((0, 2)), K).shape, (0, 2))

    def test_what_is_not_seen_is_not_a_number(self):
        # The distorted radius r (1 - 0.25 r^2) is at most 0.77, or 616 pixels. Pixels farther from the
        # center correspond to no ray.
        found = usac.removeDistortion([[410 + 610, 305], [410 + 620, 305], [np.nan, 3], [3, np.inf]], K, (-.25, 0, 0, 0))
        self.assertTrue(np.isfinite(found[0]).all())
        self.assertTrue(np.isnan(found[1:]).all())

    def test_mistakes(self):
        for name, args in (("points", (np.zeros((1, 4)), K, None)), ("points", (None, K, None)),
                           ("cameraMatrix", (corners(), np.zeros((3, 3)), None)), ("distCoeffs", (corners(), K, [1, 2, 3]))):
            with self.assertRaisesRegex(ERRORS, name):
                usac.removeDistortion(*args)


class ReportTest(unittest.TestCase):

    def test_threshold_in_another_unit(self):
        """The points are normalized image coordinates, but the threshold 1.5 is meant in pixels. The
        report must say that such a result is no better than chance. With the threshold in the unit of
        the points, 1.5 / 800, it must not say so."""
        rng = np.random.RandomState(2)
        X = rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (300, 3))
        points1, moved = X[:, :2] / X[:, 2:], X + [.5, .1, 0]
        points2 = moved[:, :2] / moved[:, 2:]
        for threshold in (1.5, 1.5 / 800):
            _, _, report = usac.estimateEssential(points1, points2, np.eye(3), params=usac.Params(threshold=threshold))
            self.assertIs(report.wideThreshold, threshold == 1.5)
            self.assertEqual("the threshold is as large as the extent" in report.describe(), threshold == 1.5)
            self.assertEqual(report.describe().endswith("no better than chance"), threshold == 1.5)

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
