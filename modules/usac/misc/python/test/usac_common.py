#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Scenes, call forms and comparisons that the Python tests of the module usac share."""

import importlib.util
import sys
import types
import unittest

import cv2 as cv
import numpy as np

usac = cv.usacv20
HAS_LOADER = hasattr(cv, "_native")
NATIVE = cv._native if HAS_LOADER else cv
FINDER = cv if HAS_LOADER else usac  # where find* take our flags
needsLoader = unittest.skipUnless(HAS_LOADER, "built with OPENCV_SKIP_PYTHON_LOADER")

FUNCTIONS = ("findHomography", "findFundamentalMat", "findEssentialMat", "estimateAffine2D", "estimateAffinePartial2D",
             "solvePnPRansac")
FLAGS = {name: value for name, value in vars(NATIVE).items() if name.startswith("USACV20")}
THRESHOLD = 2.0


class Scene(object):
    """Correspondences: 200 inliers with noise and 100 outliers, in no order."""

    def __init__(self, planar, distorted=False):
        rng = np.random.RandomState(5)
        count, outliers = 300, 100
        self.K1 = np.array([[800., 0, 320], [0, 800., 240], [0, 0, 1]])
        self.K2 = np.array([[700., 0, 300], [0, 720., 250], [0, 0, 1]]) if distorted else self.K1
        self.d1 = np.array([-0.1, 0.02, 0, 0, 0]) if distorted else None
        self.d2 = np.array([0.05, -0.01, 0, 0, 0]) if distorted else None
        X = rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (count, 3))
        if planar:
            X[:, 2] = 5 + 0.2 * X[:, 0]
        r, t = np.array([0.03, -0.1, 0.05]), np.array([-0.8, 0.1, 0.1])
        zero = np.zeros(3)
        self.true1 = cv.projectPoints(X, zero, zero, self.K1, self.d1)[0].reshape(-1, 2)
        self.true2 = cv.projectPoints(X, r, t, self.K2, self.d2)[0].reshape(-1, 2)
        self.points1 = self.true1 + rng.normal(0, 0.3, (count, 2))
        self.points2 = self.true2 + rng.normal(0, 0.3, (count, 2))
        bad = rng.permutation(count)[:outliers]
        self.points2[bad] = rng.uniform(0, [640, 480], (outliers, 2))
        self.inliers = np.ones(count, bool)
        self.inliers[bad] = False
        self.focal, self.pp = 800., (320., 240.)

    def moveTo(self, similarity):
        """Image 2 becomes the similarity of image 1."""
        noise = self.points2 - self.true2
        self.true2 = self.true1.dot(similarity[:, :2].T) + similarity[:, 2]
        self.points2[self.inliers] = (self.true2 + noise)[self.inliers]
        return self

    def error(self, problem, model):
        """Mean error in pixels of the noise-free inliers."""
        if model.shape == (2, 3):
            return np.linalg.norm(self.true1.dot(model[:, :2].T) + model[:, 2] - self.true2, axis=1)[self.inliers].mean()
        a, b = self.true1[self.inliers], self.true2[self.inliers]
        scale = 1.
        if problem == "Essential":
            a = cv.undistortPoints(a, self.K1, self.d1).reshape(-1, 2)
            b = cv.undistortPoints(b, self.K2, self.d2).reshape(-1, 2)
            scale = 750.
        a, b = np.hstack([a, np.ones((len(a), 1))]), np.hstack([b, np.ones((len(b), 1))])
        lines = a.dot(model.T)
        if problem == "Homography":
            return np.linalg.norm(lines[:, :2] / lines[:, 2:] - b[:, :2], axis=1).mean()
        back = b.dot(model)
        norm = np.sqrt((lines[:, :2] ** 2).sum(1) + (back[:, :2] ** 2).sum(1))
        return scale * (np.abs((b * lines).sum(1)) / norm).mean()


PLANE = Scene(planar=True)
GENERAL = Scene(planar=False)
DISTORTED = Scene(planar=False, distorted=True)
MOVED = Scene(planar=True).moveTo(np.array([[0.9, -0.2, 40.], [0.2, 0.9, -25.]]))


def formsOfMaps(method):
    """Those of the maps of the plane among forms()."""
    m, T = MOVED, THRESHOLD
    a, b = m.points1, m.points2
    return [(problem, function, m, args, kwargs)
            for problem, function in (("Affinity2D", "estimateAffine2D"), ("Similarity2D", "estimateAffinePartial2D"))
            for args, kwargs in (
                ((a, b, None, method, T, 1000, 0.99, 100), {}),
                ((a, b, None, method, T, 1000), {}),
                ((a, b, None, method, T), dict(maxIters=1000, confidence=0.99, refineIters=100)),
                ((a, b, None, method), dict(ransacReprojThreshold=T, maxIters=1000)),
                ((a, b, None), dict(method=method, ransacReprojThreshold=T, maxIters=1000)),
                ((a, b), dict(method=method, ransacReprojThreshold=T, maxIters=1000, inliers=None)),
                ((), dict(from_=a, to=b, method=method, ransacReprojThreshold=T, maxIters=1000, confidence=0.99)))]


def forms(method):
    """All signatures of the functions of two images: (problem, function, scene, positional arguments, keyword arguments).

    Calls with the same problem and scene estimate the same thing with the same parameters."""
    p, g, d = PLANE, GENERAL, DISTORTED
    pa, pb, ga, gb, da, db = p.points1, p.points2, g.points1, g.points2, d.points1, d.points2
    H, F, E = FUNCTIONS[:3]
    T = THRESHOLD
    return formsOfMaps(method) + [
        ("Homography", H, p, (pa, pb, method, T, None, 1000, 0.99), {}),
        ("Homography", H, p, (pa, pb, method, T, None), dict(maxIters=1000, confidence=0.99)),
        ("Homography", H, p, (pa, pb, method, T), dict(confidence=0.99, maxIters=1000, mask=None)),
        ("Homography", H, p, (pa, pb), dict(method=method, ransacReprojThreshold=T, maxIters=1000, confidence=0.99)),
        ("Homography", H, p, (), dict(srcPoints=pa, dstPoints=pb, method=method, ransacReprojThreshold=T, mask=None,
                                      maxIters=1000, confidence=0.99)),
        ("Fundamental", F, g, (ga, gb, method, T, 0.99, 1000, None), {}),
        ("Fundamental", F, g, (ga, gb, method, T, 0.99, 1000), {}),
        ("Fundamental", F, g, (ga, gb, method, T, 0.99), {}),
        ("Fundamental", F, g, (ga, gb, method, T), dict(confidence=0.99, mask=None)),
        ("Fundamental", F, g, (ga, gb), dict(method=method, ransacReprojThreshold=T, confidence=0.99)),
        ("Fundamental", F, g, (), dict(points1=ga, points2=gb, method=method, ransacReprojThreshold=T, confidence=0.99,
                                       maxIters=1000, mask=None)),
        ("Essential", E, g, (ga, gb, g.K1, method, 0.99, T, 1000, None), {}),
        ("Essential", E, g, (ga, gb, g.K1, method, 0.99, T, 1000), {}),
        ("Essential", E, g, (ga, gb, g.K1, method, 0.99, T), {}),
        ("Essential", E, g, (ga, gb, g.K1, method), dict(prob=0.99, threshold=T, mask=None)),
        ("Essential", E, g, (ga, gb, g.K1), dict(method=method, prob=0.99, threshold=T)),
        ("Essential", E, g, (), dict(points1=ga, points2=gb, cameraMatrix=g.K1, method=method, prob=0.99, threshold=T,
                                     maxIters=1000, mask=None)),
        ("Essential", E, g, (ga, gb, g.focal, g.pp, method, 0.99, T, 1000, None), {}),
        ("Essential", E, g, (ga, gb, g.focal, g.pp, method, 0.99, T), {}),
        ("Essential", E, g, (ga, gb, int(g.focal), g.pp), dict(method=method, prob=0.99, threshold=T, maxIters=1000)),
        ("Essential", E, g, (ga, gb), dict(focal=g.focal, pp=g.pp, method=method, prob=0.99, threshold=T)),
        ("Essential", E, d, (da, db, d.K1, d.d1, d.K2, d.d2, method, 0.99, T, None), {}),
        ("Essential", E, d, (da, db, d.K1, d.d1, d.K2, d.d2, method, 0.99, T), {}),
        ("Essential", E, d, (da, db, d.K1, d.d1, d.K2, d.d2), dict(method=method, prob=0.99, threshold=T, mask=None)),
        ("Essential", E, d, (), dict(points1=da, points2=db, cameraMatrix1=d.K1, distCoeffs1=d.d1, cameraMatrix2=d.K2,
                                     distCoeffs2=d.d2, method=method, prob=0.99, threshold=T)),
        ("Essential", E, g, (ga, gb, g.K1, None, g.K1, None, method, 0.99, T, None), {}),
    ]


def formsOfOpencv():
    """forms() for each of OpenCV's flags whose result is the same each time."""
    usacs = [cv.USAC_DEFAULT, cv.USAC_FM_8PTS, cv.USAC_FAST, cv.USAC_ACCURATE, cv.USAC_PROSAC, cv.USAC_MAGSAC]
    return [form for method in [0, cv.LMEDS, cv.RANSAC, cv.RHO, cv.FM_7POINT, cv.FM_8POINT] + usacs for form in forms(method)
            if form[1] != "findEssentialMat" or method not in usacs]  # OpenCV 4.6 gives another E each time


def paramsForms(params):
    """The same for the signatures with `params`."""
    p, g, d, m = PLANE, GENERAL, DISTORTED, MOVED
    H, F, E, A, S = FUNCTIONS[:5]
    return [
        ("Affinity2D", A, m, (m.points1, m.points2, params), {}),
        ("Affinity2D", A, m, (m.points1, m.points2, params, None), {}),
        ("Affinity2D", A, m, (), dict(pts1=m.points1, pts2=m.points2, inliers=None, params=params)),
        ("Similarity2D", S, m, (m.points1, m.points2, params), {}),
        ("Similarity2D", S, m, (m.points1, m.points2), dict(params=params)),
        ("Homography", H, p, (p.points1, p.points2, params), {}),
        ("Homography", H, p, (p.points1, p.points2, params, None), {}),
        ("Homography", H, p, (p.points1, p.points2), dict(params=params)),
        ("Homography", H, p, (p.points1, p.points2), dict(mask=None, params=params)),
        ("Fundamental", F, g, (g.points1, g.points2, params), {}),
        ("Fundamental", F, g, (g.points1, g.points2, params, None), {}),
        ("Fundamental", F, g, (g.points1, g.points2), dict(mask=None, params=params)),
        ("Essential", E, d, (d.points1, d.points2, d.K1, d.K2, d.d1, d.d2, params), {}),
        ("Essential", E, d, (d.points1, d.points2, d.K1, d.K2, d.d1, d.d2, params, None), {}),
        ("Essential", E, d, (d.points1, d.points2, d.K1, d.K2, d.d1, d.d2), dict(mask=None, params=params)),
        ("Essential", E, d, (d.points1, d.points2), dict(cameraMatrix1=d.K1, cameraMatrix2=d.K2, dist_coeff1=d.d1,
                                                         dist_coeff2=d.d2, params=params)),
    ]


def estimate(problem, scene, params, *args):
    """(model, mask, report) of usacv20.estimate<problem>."""
    function = getattr(usac, "estimate" + problem)
    if problem == "Essential":
        return function(scene.points1, scene.points2, scene.K1, scene.K2, scene.d1, scene.d2, params, *args)
    return function(scene.points1, scene.points2, params, *args)


def bits(result):
    """A result or a cv2.error in a form that compares byte for byte."""
    if isinstance(result, (tuple, list)):
        return tuple(bits(item) for item in result)
    if isinstance(result, np.ndarray):
        return result.dtype.str, result.shape, result.tobytes()
    if isinstance(result, Exception):
        return type(result), str(result)
    return result


def outcome(function, args, kwargs):
    cv.setRNGSeed(7)
    try:
        return bits(function(*args, **kwargs))
    except Exception as error:
        return bits(error)


def loadPackage(native):
    """Runs the package again, in a cv2 with other natives. Returns that cv2."""
    spec = importlib.util.spec_from_file_location("package", usac.__file__)
    other = types.ModuleType("cv2")
    other._native = native
    saved = sys.modules["cv2"]
    sys.modules["cv2"] = other
    try:
        spec.loader.exec_module(importlib.util.module_from_spec(spec))
    finally:
        sys.modules["cv2"] = saved
    return other


def fields(params):
    return sorted(name for name in dir(params) if name[0] != "_" and not callable(getattr(params, name)))


def values(params):
    return {name: bits(getattr(params, name)) for name in fields(params)}
