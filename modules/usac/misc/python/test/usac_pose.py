#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Scenes and forms of calls of solvePnPRansac for tests of the module usac."""

import numpy as np

from usac_camera import project, rotation

THRESHOLD = 2.0  # pixels


class PoseScene(object):
    """`count` 3-D points X and their pixels x in a camera with lens distortion, in random order. `good`
    of the pixels have noise (standard deviation 0.3 pixels); the others are random: outliers."""

    def __init__(self, count, good):
        rng = np.random.RandomState(5)
        self.K = np.array([[800., 0, 320], [0, 790., 240], [0, 0, 1]])
        self.d = np.array([-0.1, 0.02, 0.001, -0.001, 0])
        self.r, self.t = np.array([0.2, -0.3, 0.1]), np.array([0.3, -0.2, 6.])
        self.pose = np.hstack((rotation(self.r), self.t[:, None]))
        self.X = rng.uniform([-2, -1.5, -1], [2, 1.5, 1], (count, 3))
        self.true = project(self.X, self.r, self.t, self.K, self.d)
        self.x = self.true + rng.normal(0, 0.3, (count, 2))
        bad = rng.permutation(count)[good:]
        self.x[bad] = rng.uniform(0, [640, 480], (len(bad), 2))
        self.inliers = np.ones(count, bool)
        self.inliers[bad] = False

    def error(self, rvec, tvec):
        """Returns the mean distance in pixels between the projections with this pose and with the true
        pose."""
        return self.errorOf(np.hstack((rotation(rvec), np.reshape(tvec, (3, 1)))))

    def errorOf(self, pose):
        return np.linalg.norm(self.seen(pose) - self.true, axis=1).mean()

    def seen(self, pose):
        """Projects the points with a pose [R t]; returns pixels."""
        X = self.X.dot(pose[:, :3].T) + pose[:, 3]
        return project(X, np.zeros(3), np.zeros(3), self.K, self.d)


POSE = PoseScene(300, 200)
FEW = PoseScene(600, 30)  # an inlier ratio of 5 %: about one in 9000 samples of 3 points is all-inlier


def formsOfPose(method):
    """Returns calls of solvePnPRansac with a flag in many forms: (positional arguments, keyword
    arguments). All calls have the same parameters, so their results must be equal."""
    s, T = POSE, THRESHOLD
    X, x, K, d = s.X, s.x, s.K, s.d
    return [
        ((X, x, K, d, None, None, False, 1000, T, 0.99, None, method), {}),
        ((X, x, K, d, None, None, False, 1000, T, 0.99, None), dict(flags=method)),
        ((X, x, K, d, None, None, False, 1000, T), dict(confidence=0.99, inliers=None, flags=method)),
        ((X, x, K, d), dict(iterationsCount=1000, reprojectionError=T, flags=method)),
        ((X, x, K), dict(distCoeffs=d, rvec=None, tvec=None, useExtrinsicGuess=False, iterationsCount=1000,
                         reprojectionError=T, confidence=0.99, flags=method)),
        ((), dict(objectPoints=X, imagePoints=x, cameraMatrix=K, distCoeffs=d, iterationsCount=1000, reprojectionError=T,
                  flags=method))]


def paramsFormsOfPose(params):
    """Returns calls of solvePnPRansac with Params instead of a flag, like formsOfPose()."""
    s = POSE
    return [
        ((s.X, s.x, s.K, s.d, None, None, None, params), {}),
        ((s.X, s.x, s.K, s.d, None, None), dict(inliers=None, params=params)),
        ((s.X, s.x, s.K, s.d), dict(params=params)),
        ((), dict(objectPoints=s.X, imagePoints=s.x, cameraMatrix=s.K, distCoeffs=s.d, params=params))]
