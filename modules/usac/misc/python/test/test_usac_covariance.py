#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of Report.covariance and of the functions that convert covariances."""

import unittest

import numpy as np

from usac_camera import project
from usac_common import usac

K = np.array([[800., 0, 320], [0, 780., 240], [0, 0, 1]])


def mapped(H, points):
    places = np.c_[points, np.ones(len(points))].dot(H.T)
    return places[:, :2] / places[:, 2:]


class CovarianceTest(unittest.TestCase):
    def setUp(self):
        self.rng = np.random.RandomState(1)
        self.H = np.array([[0.9, -0.2, 40], [0.2, 0.9, -25], [1e-4, -5e-5, 1]])
        self.corners = np.array([[0., 0], [639, 0], [639, 479], [0, 479]])

    def estimate(self, noise=0.5, **fields):
        points1 = self.rng.uniform(0, [640, 480], (200, 2))
        points2 = mapped(self.H, points1) + self.rng.normal(0, noise, points1.shape)
        return usac.estimateHomography(points1, points2, usac.Params(threshold=3, **fields))

    def test_only_if_asked_for(self):
        report = self.estimate()[2]
        self.assertIsNone(report.covariance)
        self.assertEqual(report.sigma, 0)
        report = self.estimate(covariance=1)[2]
        self.assertEqual(report.covariance.shape, (8, 8))
        self.assertTrue(np.allclose(report.covariance, report.covariance.T))
        # Sigma, here 0.5 pixels, is estimated from about 400 errors; its standard deviation is 4 %.
        self.assertAlmostEqual(report.sigma, 0.5, delta=0.06)

    def test_corners_are_where_they_are_said_to_be(self):
        squares = []
        for _ in range(60):
            H, _, report = self.estimate(covariance=1)
            errors = mapped(H, self.corners) - mapped(self.H, self.corners)
            for error, C in zip(errors, usac.pointCovariance(usac.HOMOGRAPHY, H, report.covariance, self.corners)):
                squares.append(error.dot(np.linalg.solve(C, error)))
        # If the covariances are right, each entry of `squares` has a chi-square distribution with two
        # degrees of freedom, whose mean is 2. The four entries of an estimation depend on each other,
        # so the tolerance is about two standard deviations of the mean of 60 independent values.
        self.assertAlmostEqual(np.mean(squares), 2, delta=0.5)

    def test_entries_and_tangent(self):
        H, _, report = self.estimate(covariance=1)
        T = usac.tangentOfModel("homography", H)
        self.assertEqual(T.shape, (9, 8))
        C = usac.covarianceOfModel(usac.HOMOGRAPHY, H, report.covariance)
        self.assertTrue(np.allclose(C, T.dot(report.covariance).dot(T.T), rtol=1e-9, atol=0))
        self.assertTrue(np.allclose(C[8], 0), "h33 is always 1, so its covariances must be 0")

    def test_pose_of_essential_matrix(self):
        X = self.rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (300, 3))
        points1 = project(X, np.zeros(3), np.zeros(3), K)
        points2 = project(X, [0.03, -0.1, 0.05], [-0.8, 0.1, 0.1], K) + self.rng.normal(0, 0.3, points1.shape)
        found = usac.estimateEssential(points1, points2, K, params=usac.Params(covariance=1))
        E, covariance = found[0], found[2].covariance
        self.assertEqual(covariance.shape, (5, 5))
        R, t = usac.estimateRelativePose(points1, points2, K)[:2]
        C = usac.covarianceOfPose(E, covariance, R, t)
        self.assertEqual(C.shape, (6, 6))
        self.assertEqual(np.linalg.matrix_rank(C, tol=1e-9 * np.trace(C)), 5)
        self.assertLess(np.abs(C[3:, 3:].dot(np.ravel(t))).max(), 1e-9 * np.trace(C))
        self.assertEqual(usac.pointCovariance("essential", E, covariance, points1, points2, K).shape, (300, 1, 1))

    def test_translation(self):
        points = self.rng.uniform(0, 100, (50, 2))
        _, _, report = usac.estimateTranslation2D(points, points + [3, 4] + self.rng.normal(0, 0.1, points.shape),
                                                  usac.Params(covariance=1, threshold=1))
        # The translation is the mean of 50 displacements, so the variance of each coordinate is
        # sigma^2 / 50.
        self.assertTrue(np.allclose(report.covariance, np.eye(2) * report.sigma**2 / 50, rtol=0.3, atol=0.2 * report.sigma**2 / 50))

    def test_mistakes(self):
        H, _, report = self.estimate(covariance=1)
        for call, name in ((lambda: usac.covarianceOfModel("homography", H, np.eye(7)), "covariance"),
                           (lambda: usac.tangentOfModel("homography", np.eye(2)), "model"),
                           (lambda: usac.tangentOfModel("homographie", H), "problem"),
                           (lambda: usac.covarianceOfPose(np.eye(3), np.eye(5), 2 * np.eye(3), [1, 0, 0]), "R")):
            with self.assertRaises(usac.error) as raised:
                call()
            self.assertIn(name, str(raised.exception))
        self.assertRaises(usac.error, usac.Params(covariance=2).check)

    def test_points(self):
        H, _, report = self.estimate(covariance=1)
        weights = np.array([[0.2], [0.5], [0.9], [1]])
        for arguments, name in (((np.hstack([self.corners, weights]),), "points1.*confidence"),
                                ((np.stack([self.corners] * 2),), "points1.*one list"),
                                ((self.corners, np.hstack([self.corners, weights])), "points2.*confidence")):
            with self.assertRaisesRegex(usac.error, name):
                usac.pointCovariance("homography", H, report.covariance, *arguments)
        space = np.hstack([self.corners, weights])  # 3-D points: the last column is a coordinate, not a confidence
        self.assertEqual(usac.pointCovariance("rigid_3d", np.eye(3, 4), np.eye(6), space).shape, (4, 3, 3))

    def test_no_points(self):
        E = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]]) / 2 ** 0.5
        for problem, model, d, k in (("homography", np.eye(3), 8, 2), ("fundamental", E, 7, 1), ("rigid_3d", np.eye(3, 4), 6, 3)):
            none = np.empty((0, 3 if k == 3 else 2))
            found = usac.pointCovariance(problem, model, np.eye(d), none, none if k == 1 else None)
            self.assertEqual(found.shape, (0, k, k))


if __name__ == "__main__":
    unittest.main()
