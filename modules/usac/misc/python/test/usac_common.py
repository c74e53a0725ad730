#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The module under test, and scenes, forms of calls and comparisons that its tests share.

Environment variables:
USAC_TEST_MODULE  "cv2" (default): tests cv2.usacv20 of an OpenCV built with the module; "usacv20":
tests the package
USAC_TEST_CV2     "none": tests the package without cv2; comparisons with cv2 are skipped
"""

import os
import sys
import types
import unittest

import numpy as np

from usac_camera import normalize, project

IN_TREE = os.environ.get("USAC_TEST_MODULE", "cv2") == "cv2"
if os.environ.get("USAC_TEST_CV2") == "none":
    sys.modules["cv2"] = None  # makes `import cv2` raise an ImportError
try:
    import cv2 as cv
except ImportError:
    if IN_TREE:
        raise
    cv = None
if IN_TREE:
    usac = cv.usacv20
else:
    import usacv20 as usac
ERRORS = (usac.error,) if cv is None else (usac.error, cv.error)
FINDER = cv if IN_TREE else usac  # the module whose FUNCTIONS are called with flags
SANITIZED = "libasan" in os.environ.get("LD_PRELOAD", "")  # see misc/sanitize.sh
# Decorators that skip tests. `once` is for tests of tools and of the installation. Such tests do not
# depend on cv2 or a sanitizer, so they are skipped if a sanitizer or USAC_TEST_CV2=none is used.
once = unittest.skipIf(SANITIZED or os.environ.get("USAC_TEST_CV2") == "none", "tests tools or the installation, not the module")
needsCv2 = unittest.skipIf(cv is None, "there is no cv2")
inTree = unittest.skipUnless(IN_TREE, "tests cv2.usacv20 only")
package = unittest.skipIf(IN_TREE, "tests the package usacv20 only")

FUNCTIONS = ("findHomography", "findFundamentalMat", "findEssentialMat", "estimateAffine2D", "estimateAffinePartial2D",
             "solvePnPRansac")
# OpenCV's own functions, even if this module has replaced the functions of cv2.
NATIVE = types.SimpleNamespace(**{name: getattr(getattr(cv, "_native", cv), name) for name in FUNCTIONS if cv is not None})
FLAGS = {flag.name: int(flag) for flag in usac.UsacV20Method}
# Flags of OpenCV, defined here because the package also accepts them without cv2.
FM_7POINT, FM_8POINT, LMEDS, RANSAC, RHO = 1, 2, 4, 8, 16
USAC_DEFAULT, _, USAC_FM_8PTS, USAC_FAST, USAC_ACCURATE, USAC_PROSAC, USAC_MAGSAC = range(32, 39)
# The last two values differ between OpenCV 4 and 5; without cv2, those of OpenCV 4 are used.
SOLVEPNP_ITERATIVE, SOLVEPNP_EPNP, SOLVEPNP_P3P, SOLVEPNP_AP3P, SOLVEPNP_SQPNP = (
    0, 1, 2, getattr(cv, "SOLVEPNP_AP3P", 5), getattr(cv, "SOLVEPNP_SQPNP", 8))
THRESHOLD = 2.0  # pixels


class Scene(object):
    """300 correspondences in random order: 200 inliers with noise (standard deviation 0.3 pixels) and
    100 outliers.

    planar -- True: the 3-D points lie in a plane
    distorted -- True: two different cameras with lens distortion; False: one camera without it"""

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
        self.true1 = project(X, np.zeros(3), np.zeros(3), self.K1, self.d1)
        self.true2 = project(X, r, t, self.K2, self.d2)
        self.points1 = self.true1 + rng.normal(0, 0.3, (count, 2))
        self.points2 = self.true2 + rng.normal(0, 0.3, (count, 2))
        bad = rng.permutation(count)[:outliers]
        self.points2[bad] = rng.uniform(0, [640, 480], (outliers, 2))
        self.inliers = np.ones(count, bool)
        self.inliers[bad] = False
        self.focal, self.pp = 800., (320., 240.)

    def moveTo(self, similarity):
        """Replaces the inliers of image 2 with the noise-free points of image 1, mapped by a similarity
        transform (2 x 3 matrix), plus noise."""
        noise = self.points2 - self.true2
        self.true2 = self.true1.dot(similarity[:, :2].T) + similarity[:, 2]
        self.points2[self.inliers] = (self.true2 + noise)[self.inliers]
        return self

    def error(self, problem, model):
        """Returns the mean error of a model in pixels, computed from the noise-free positions of the
        inliers. For E, a focal length of 750 pixels converts the error to pixels."""
        if model.shape == (2, 3):
            return np.linalg.norm(self.true1.dot(model[:, :2].T) + model[:, 2] - self.true2, axis=1)[self.inliers].mean()
        a, b = self.true1[self.inliers], self.true2[self.inliers]
        scale = 1.
        if problem == "Essential":
            a, b = normalize(a, self.K1, self.d1), normalize(b, self.K2, self.d2)
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


class ErrorCase(unittest.TestCase):

    def refused(self, type_, words, function, *args, **kwargs):
        """Asserts that a call raises an exception of this type whose message contains all of the words."""
        with self.assertRaises(type_, msg=words) as context:
            function(*args, **kwargs)
        for word in words:
            self.assertIn(word, str(context.exception))


def formsOfMaps(method):
    """Returns the part of forms() for affine maps and similarities."""
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
    """Returns calls with two images in many forms: (problem, function, scene, positional arguments,
    keyword arguments).

    With a flag of this module, calls with the same problem and scene must give the same result."""
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
    """Returns forms() for OpenCV's flags, without calls whose results differ from run to run."""
    usacs = [USAC_DEFAULT, USAC_FM_8PTS, USAC_FAST, USAC_ACCURATE, USAC_PROSAC, USAC_MAGSAC]
    return [form for method in [0, LMEDS, RANSAC, RHO, FM_7POINT, FM_8POINT] + usacs for form in forms(method)
            if form[1] != "findEssentialMat" or method not in usacs]  # E differs from run to run in OpenCV 4.6


def paramsForms(params):
    """Returns calls with Params instead of a flag, as tuples like those of forms()."""
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
    ] + placesOfParams(params)


def placesOfParams(params):
    """Returns the part of paramsForms() with Params in places where OpenCV has no UsacParams."""
    g, d, m = GENERAL, DISTORTED, MOVED
    ga, gb, da, db = g.points1, g.points2, d.points1, d.points2
    E, A = FUNCTIONS[2:4]
    return [("Essential", E, g, args, kwargs) for args, kwargs in (
        ((ga, gb, g.K1, params), {}), ((ga, gb, g.K1), dict(method=params)), ((ga, gb, g.K1), dict(params=params)),
        ((ga, gb), dict(cameraMatrix=g.K1, method=params)), ((ga, gb, g.focal, g.pp, params), {}),
        ((ga, gb, g.focal, g.pp), dict(method=params)), ((ga, gb, g.K1, None, None, None, params), {}))] + [
        ("Essential", E, d, (da, db, d.K1, d.K2, d.d1, d.d2, params), {}),
        ("Essential", E, d, (da, db, d.K1, d.d1, d.K2, d.d2), dict(method=params)),
        ("Affinity2D", A, m, (m.points1, m.points2, None, params), {}),
        ("Affinity2D", A, m, (m.points1, m.points2), dict(method=params))]


def estimate(problem, scene, params, *args):
    """Calls usacv20.estimate<problem>; returns (model, mask, report)."""
    function = getattr(usac, "estimate" + problem)
    if problem == "Essential":
        return function(scene.points1, scene.points2, scene.K1, scene.K2, scene.d1, scene.d2, params, *args)
    return function(scene.points1, scene.points2, params, *args)


def bits(result):
    """Converts a result or an exception to values that == compares exactly; arrays are compared bit
    by bit."""
    if isinstance(result, (tuple, list)):
        return tuple(bits(item) for item in result)
    if isinstance(result, np.ndarray):
        return result.dtype.str, result.shape, result.tobytes()
    if isinstance(result, Exception):
        return "error" if isinstance(result, ERRORS) else type(result), str(result)
    return result


def outcome(function, args, kwargs):
    if cv is not None:
        cv.setRNGSeed(7)
    try:
        return bits(function(*args, **kwargs))
    except Exception as error:
        return bits(error)


def fields(params):
    return sorted(name for name in dir(params) if name[0] != "_" and not callable(getattr(params, name)))
