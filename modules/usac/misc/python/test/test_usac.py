#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The Python surface of the module usac.

Runs alone (python3 test_usac.py, PYTHONPATH=<build>/python_loader) and among OpenCV's Python tests.
Without OpenCV's loader (OPENCV_SKIP_PYTHON_LOADER) cv2.find* are OpenCV's own; then cv2.usacv20.find* are tested in
their place, and what the loader's package adds is skipped.
"""

import importlib.util
import os
import pickle
import subprocess
import sys
import threading
import types
import unittest

import cv2 as cv
import numpy as np

usac = cv.usacv20
HAS_LOADER = hasattr(cv, "_native")
NATIVE = cv._native if HAS_LOADER else cv
FINDER = cv if HAS_LOADER else usac  # where find* take our flags
needsLoader = unittest.skipUnless(HAS_LOADER, "built with OPENCV_SKIP_PYTHON_LOADER")

FUNCTIONS = ("findHomography", "findFundamentalMat", "findEssentialMat")
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

    def error(self, problem, model):
        """Mean error in pixels of the noise-free inliers."""
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


def forms(method):
    """All signatures of the three functions: (problem, function, scene, positional arguments, keyword arguments).

    Calls with the same problem and scene estimate the same thing with the same parameters."""
    p, g, d = PLANE, GENERAL, DISTORTED
    pa, pb, ga, gb, da, db = p.points1, p.points2, g.points1, g.points2, d.points1, d.points2
    H, F, E = FUNCTIONS
    T = THRESHOLD
    return [
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


def paramsForms(params):
    """The same for the signatures with `params`."""
    p, g, d = PLANE, GENERAL, DISTORTED
    H, F, E = FUNCTIONS
    return [
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


@needsLoader
class WrapperTest(unittest.TestCase):

    def test_is_in_place(self):
        for name in FUNCTIONS:  # fails also if the loader has swallowed an ImportError of the package
            self.assertIsNot(getattr(cv, name), getattr(NATIVE, name), name)
            self.assertIs(getattr(cv, name).__wrapped__, getattr(NATIVE, name))
        self.assertTrue(os.path.isfile(usac.__file__))
        self.assertIs(usac.UsacParams, usac.Params)
        self.assertIs(usac.Params, NATIVE.usacv20.Params)

    def test_keeps_name_and_documentation(self):
        for name in FUNCTIONS:
            self.assertEqual(getattr(cv, name).__name__, name)
            self.assertTrue(getattr(cv, name).__doc__.startswith(getattr(NATIVE, name).__doc__))
            self.assertIn("USACV20", getattr(cv, name).__doc__)
        for function in (usac, usac.estimateHomography, usac.estimateFundamental, usac.estimateEssential):
            self.assertGreater(len(function.__doc__), 100)

    def test_can_be_pickled(self):
        for name in FUNCTIONS:
            self.assertIs(pickle.loads(pickle.dumps(getattr(cv, name))), getattr(cv, name))

    def test_import_is_silent(self):
        run = subprocess.Popen([sys.executable, "-c", "import cv2; cv2.findHomography.__wrapped__"],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual((run.communicate()[0], run.returncode), (b"", 0))

    def test_package_of_another_build_is_passed_over(self):
        self.assertRaises(ImportError, loadPackage, types.ModuleType("cv2"))


@needsLoader
class RouteTest(unittest.TestCase):
    """Which of the two functions a call reaches, whatever they return."""

    def setUp(self):
        native = types.ModuleType("cv2")
        native.usacv20 = types.ModuleType("cv2.usacv20")
        native.usacv20.Params = usac.Params
        vars(native).update(FLAGS)
        for name in FUNCTIONS:
            self.record(native, name, "opencv")
            self.record(native.usacv20, name, "usacv20")
        self.cv = loadPackage(native)

    def record(self, module, name, route):
        def function(*args, **kwargs):
            self.calls.append((route, args, kwargs))
            return route
        setattr(module, name, function)

    def check(self, route, function, *args, **kwargs):
        self.calls = []
        self.assertEqual(getattr(self.cv, function)(*args, **kwargs), route,
                         "{} {} {}".format(function, len(args), sorted(kwargs)))
        (_, calledArgs, calledKwargs), = self.calls
        self.assertEqual([id(arg) for arg in calledArgs], [id(arg) for arg in args])
        self.assertEqual(calledKwargs, kwargs)

    def test_forms(self):
        for method in (0, cv.RANSAC, cv.LMEDS, cv.RHO, cv.USAC_DEFAULT, cv.USAC_MAGSAC, 0x3fff, 0x4000 + len(FLAGS), -1,
                       2**40, True, None, "RANSAC", 16384.0):
            for _, function, _, args, kwargs in forms(method):
                self.check("opencv", function, *args, **kwargs)
        for flag in FLAGS.values():
            for method in (flag, np.int32(flag), np.int64(flag), np.uint16(flag)):
                for _, function, _, args, kwargs in forms(method):
                    self.check("usacv20", function, *args, **kwargs)
        for params, route in ((cv.UsacParams(), "opencv"), (None, "opencv"), (usac.Params(), "usacv20")):
            for _, function, _, args, kwargs in paramsForms(params):
                self.check(route, function, *args, **kwargs)

    def test_numbers_in_other_places(self):
        a = np.ones((9, 2))
        K, pp = np.eye(3), (1., 2.)
        for n in FLAGS.values():
            for function, args in (
                    ("findHomography", (a, a, cv.RANSAC, n, None, n, 0.99)), ("findHomography", (n, n)),
                    ("findHomography", (a, a, float(n))), ("findHomography", (a, a, np.array([n]))),
                    ("findFundamentalMat", (a, a, cv.FM_RANSAC, n, n, n, None)),
                    ("findEssentialMat", (a, a, K, cv.RANSAC, 0.99, 1., n)),
                    ("findEssentialMat", (a, a, K, np.int32(cv.RANSAC), n, 1., n)),
                    ("findEssentialMat", (a, a, K, None, 0.99, 1., n)), ("findEssentialMat", (a, a, K, None, None, None, n)),
                    ("findEssentialMat", (a, a, n, pp, cv.RANSAC, 0.99, 1., n)),
                    ("findEssentialMat", (a, a, np.float32(n), pp, cv.RANSAC, n, n, n)),
                    ("findEssentialMat", (a, a, 1.0, pp, cv.RANSAC, 0.99, n, 100)), ("findEssentialMat", (a, a, n, pp)),
                    ("findEssentialMat", (a, a, K, None, K, None, cv.RANSAC, 0.99, n)), ("findEssentialMat", (n, a, K)),
                    ("findEssentialMat", (a, a, K, a, K, a, None, n))):
                self.check("opencv", function, *args)
            self.check("opencv", "findHomography", a, a, method=cv.RANSAC, maxIters=n)
            self.check("opencv", "findEssentialMat", a, a, focal=n, pp=pp, method=cv.RANSAC)
            self.check("opencv", "findEssentialMat", a, a, K, method=cv.RANSAC, maxIters=n)
            self.check("usacv20", "findEssentialMat", a, a, n, pp, n)
            self.check("usacv20", "findEssentialMat", a, a, focal=1.0, pp=pp, method=n)


class FlagTest(unittest.TestCase):

    def test_names_and_values(self):
        self.assertLessEqual({"USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC", "USACV20_PARALLEL"}, set(FLAGS))
        self.assertEqual(sorted(FLAGS.values()), list(range(0x4000, 0x4000 + len(FLAGS))))
        for name, value in FLAGS.items():
            self.assertEqual(getattr(cv, name), value)
            self.assertTrue(usac.isUsacV20Method(value))
        for value in (-1, 0, cv.LMEDS, cv.RANSAC, cv.RHO, cv.USAC_DEFAULT, cv.USAC_MAGSAC, 0x3fff, 0x4000 + len(FLAGS)):
            self.assertFalse(usac.isUsacV20Method(value))

    def test_every_flag_in_every_form(self):
        for name, flag in sorted(FLAGS.items()):
            params = usac.Params.fromMethod(flag)
            params.threshold, params.confidence, params.maxIterations = THRESHOLD, 0.99, 1000
            for problem, function, scene, args, kwargs in forms(flag):
                label = "{} {} {} {}".format(name, function, len(args), sorted(kwargs))
                result = getattr(FINDER, function)(*args, **kwargs)
                self.assertEqual(len(result), 2, label)
                self.assertEqual(bits(result), bits(estimate(problem, scene, params)[:2]), label)
                self.check(problem, scene, result, label)

    def check(self, problem, scene, result, label):
        model, mask = result
        self.assertEqual((model.shape, model.dtype), ((3, 3), np.float64), label)
        self.assertEqual((mask.shape, mask.dtype), ((len(scene.points1), 1), np.uint8), label)
        self.assertLessEqual(set(mask.ravel()), {0, 1}, label)
        self.assertGreater(mask.ravel()[scene.inliers].mean(), 0.8, label)
        self.assertLess(scene.error(problem, model), 1.0, label)

    def test_integers_of_numpy(self):
        for kind in (np.int32, np.int64, np.uint16):
            for method in (kind(cv.USACV20), kind(cv.RANSAC)):
                finder = FINDER if method == cv.USACV20 else cv
                for (_, function, _, args, kwargs), (_, _, _, args2, kwargs2) in zip(forms(method), forms(int(method))):
                    self.assertEqual(outcome(getattr(finder, function), args, kwargs),
                                     outcome(getattr(finder, function), args2, kwargs2))

    def test_defaults_are_those_of_opencv(self):
        a, b, g = PLANE.points1, PLANE.points2, GENERAL
        self.assertEqual(bits(FINDER.findHomography(a, b, cv.USACV20)),
                         bits(FINDER.findHomography(a, b, cv.USACV20, 3, None, 2000, 0.995)))
        self.assertEqual(bits(FINDER.findFundamentalMat(a, b, cv.USACV20)),
                         bits(FINDER.findFundamentalMat(a, b, cv.USACV20, 3., 0.99, 1000)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, cv.USACV20)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, cv.USACV20, 0.999, 1.0, 1000)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, None, g.K1, None, cv.USACV20)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.focal, g.pp, cv.USACV20, 0.999, 1.0)))

    def test_none_in_the_place_of_the_mask(self):
        # OpenCV's findFundamentalMat takes a None there for maxIters = 0
        g = GENERAL
        self.assertEqual(bits(FINDER.findFundamentalMat(g.points1, g.points2, cv.USACV20, 1.0, 0.99, None)),
                         bits(FINDER.findFundamentalMat(g.points1, g.points2, cv.USACV20, 1.0, 0.99)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, cv.USACV20, 0.999, 1.0, None)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, cv.USACV20, 0.999, 1.0)))

    def test_mask_of_the_caller(self):
        for flag in (cv.USACV20, cv.USACV20_FAST):
            given = np.full((len(PLANE.points1), 1), 7, np.uint8)
            _, mask = FINDER.findHomography(PLANE.points1, PLANE.points2, flag, THRESHOLD, given)
            np.testing.assert_array_equal(given, mask)
            self.assertLessEqual(set(given.ravel()), {0, 1})

    def test_input_is_not_changed(self):
        for scene in (PLANE, GENERAL, DISTORTED):
            before = bits([scene.points1, scene.points2, scene.K1, scene.K2])
            estimate("Homography", scene, usac.Params())
            estimate("Fundamental", scene, usac.Params())
            estimate("Essential", scene, usac.Params())
            self.assertEqual(bits([scene.points1, scene.points2, scene.K1, scene.K2]), before)

    def test_layouts_of_the_points(self):
        a, b = np.rint(PLANE.points1), np.rint(PLANE.points2)
        expected = bits(FINDER.findHomography(a, b, cv.USACV20, 3.0))
        wide = np.zeros((len(a), 5))
        wide[:, 1:3] = b
        for p, q in ((np.float32(a), np.float32(b)), (np.int32(a), np.int32(b)), (a[:, None], b[:, None]),
                     (a[None], b[None]), (np.asfortranarray(a), wide[:, 1:3]), (np.float32(a), b[None]),
                     (a[::-1][::-1], np.repeat(b, 2, axis=0)[::2])):
            self.assertEqual(bits(FINDER.findHomography(p, q, cv.USACV20, 3.0)), expected)
        model, mask = FINDER.findHomography(cv.UMat(a), cv.UMat(b), cv.USACV20, 3.0)
        self.assertEqual((bits(model), bits(mask.get() if isinstance(mask, cv.UMat) else mask)), expected)


@needsLoader
class UnchangedTest(unittest.TestCase):
    """What carries none of our flags gives what OpenCV's own function gives, byte for byte."""

    def compare(self, function, args, kwargs):
        expected = outcome(getattr(NATIVE, function), args, kwargs)
        self.assertEqual(outcome(getattr(cv, function), args, kwargs), expected,
                         "{} {} {}".format(function, len(args), sorted(kwargs)))
        return expected

    def test_flags_of_opencv(self):
        usacs = [cv.USAC_DEFAULT, cv.USAC_FM_8PTS, cv.USAC_FAST, cv.USAC_ACCURATE, cv.USAC_PROSAC, cv.USAC_MAGSAC]
        found = 0
        for method in [0, cv.LMEDS, cv.RANSAC, cv.RHO, cv.FM_7POINT, cv.FM_8POINT] + usacs:
            for _, function, _, args, kwargs in forms(method):
                if function == "findEssentialMat" and method in usacs:
                    continue  # OpenCV 4.6 gives another E each time; see RouteTest
                expected = self.compare(function, args, kwargs)
                found += isinstance(expected[0], tuple)
        self.assertGreater(found, 100)  # models, not only equal exceptions

    def test_params_of_opencv(self):
        for _, function, _, args, kwargs in paramsForms(cv.UsacParams()):
            if function != "findEssentialMat":
                self.compare(function, args, kwargs)


    def test_defaults_of_opencv(self):
        p, g = PLANE, GENERAL
        self.compare("findHomography", (p.points1, p.points2), {})
        self.compare("findHomography", (p.points1, p.points2, None), {})
        self.compare("findFundamentalMat", (g.points1, g.points2), {})
        self.compare("findEssentialMat", (g.points1, g.points2), {})
        self.compare("findEssentialMat", (g.points1, g.points2, g.K1), {})
        self.compare("findEssentialMat", (g.points1, g.points2, g.focal, g.pp), {})
        self.compare("findEssentialMat", (g.points1, g.points2, g.K1, None, g.K1, None), {})

    def test_wrong_calls(self):
        p = PLANE
        for function in FUNCTIONS:
            for args, kwargs in (((), {}), ((p.points1,), {}), ((p.points1, p.points2[:50]), {}),
                                 ((p.points1, p.points2), dict(method="RANSAC")), (("a", "b", 3), {}),
                                 ((p.points1, p.points2), dict(nonsense=1)), ((p.points1, p.points2, 2**40), {}),
                                 ((p.points1, p.points2, 0x4000 + len(FLAGS)), {}),
                                 ((p.points1, p.points2, p.K1, 0x3fff), {}), ((1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12), {})):
                self.compare(function, args, kwargs)


class ParamsTest(unittest.TestCase):

    def test_fields_can_be_read_and_written(self):
        params = usac.Params()
        self.assertLessEqual({"threshold", "confidence", "maxIterations", "seed", "threads", "sampler", "prior", "scores",
                              "scoreOrder", "quality", "verification", "localOptimization", "termination", "degeneracy",
                              "polishing"}, set(fields(params)))
        for name in fields(params):
            if name == "scores":
                continue
            value = getattr(params, name) + (0.25 if isinstance(getattr(params, name), float) else 1)
            setattr(params, name, value)
            self.assertEqual(getattr(params, name), value, name)
            self.assertRaises(TypeError, setattr, params, name, "text")
            self.assertRaises(TypeError, delattr, params, name)
            self.assertEqual(getattr(params, name), value, name)
        self.assertRaises(AttributeError, setattr, params, "treshold", 1.0)
        self.assertNotEqual(values(params), values(usac.Params()))

    def test_scores(self):
        params = usac.Params()
        self.assertEqual(len(params.scores), 0)
        for scores in ([3, 1, 2], (3., 1., 2.), np.array([3, 1, 2], np.float32), np.array([3., 1., 2.]),
                       np.array([9., 3, 1, 2])[1:], np.array([3., 0, 1, 0, 2, 0])[::2], np.array([3, 1, 2], np.uint8)):
            params.scores = []
            params.scores = scores
            np.testing.assert_array_equal(params.scores, [3, 1, 2])
        for wrong in ("text", 3, np.zeros((3, 2))):
            self.assertRaises((TypeError, cv.error), setattr, params, "scores", wrong)

    def test_scores_reach_the_estimator(self):
        good = PLANE.inliers.astype(np.float32)
        params = usac.Params()
        params.scoreOrder = usac.SCORES_HIGHER_IS_BETTER
        params.scores = good
        higher = FINDER.findHomography(PLANE.points1, PLANE.points2, params)
        params.scoreOrder = usac.SCORES_LOWER_IS_BETTER
        params.scores = -good
        self.assertEqual(bits(FINDER.findHomography(PLANE.points1, PLANE.points2, params)), bits(higher))
        params.scores = good[1:]
        with self.assertRaises(cv.error) as context:
            FINDER.findHomography(PLANE.points1, PLANE.points2, params)
        self.assertIn("scores", str(context.exception))

    def test_presets(self):
        for name in ("usacV20", "fast", "accurate", "prosac", "ransac"):
            params = getattr(usac.Params, name)()
            self.assertIsInstance(params, usac.Params)
            params.check()
            self.assertEqual(values(getattr(usac.Params(), name)()), values(params))
        presets = {"USACV20": "usacV20", "USACV20_FAST": "fast", "USACV20_ACCURATE": "accurate", "USACV20_PROSAC": "prosac",
                   "USACV20_PARALLEL": "parallel"}
        for flag, preset in presets.items():
            self.assertEqual(values(usac.Params.fromMethod(FLAGS[flag])), values(getattr(usac.Params, preset)()))
        self.assertEqual(values(usac.Params.usacV20()), values(usac.Params()))
        self.assertEqual(len({repr(usac.Params.fromMethod(flag)) for flag in FLAGS.values()}), len(FLAGS))

    def test_check_names_the_field(self):
        usac.Params().check()
        usac.Params().check(10)
        for name, wrong in (("threshold", float("nan")), ("threshold", 0), ("confidence", 1.0), ("confidence", 0.0),
                            ("maxIterations", 0), ("sampler", 99), ("quality", -1), ("threads", -1)):
            params = usac.Params()
            setattr(params, name, wrong)
            for function, args in ((params.check, ()),
                                   (FINDER.findHomography, (PLANE.points1, PLANE.points2, params)),
                                   (usac.estimateHomography, (PLANE.points1, PLANE.points2, params))):
                with self.assertRaises(cv.error) as context:
                    function(*args)
                self.assertIn(name, str(context.exception))

    def test_repr(self):
        params = usac.Params()
        params.scores = [1, 2, 3]
        for name in fields(params):
            self.assertIn(name + "=", repr(params))
        self.assertTrue(repr(params).startswith("cv2.usacv20.Params("))
        self.assertIn("threshold=1.5", repr(params))
        self.assertIn("scores=<3 values>", repr(params))

    def test_in_the_place_of_a_flag(self):
        params = usac.Params()
        params.threshold, params.maxIterations = THRESHOLD, 500
        for problem, function, scene, args, kwargs in paramsForms(params):
            result = getattr(FINDER, function)(*args, **kwargs)
            self.assertEqual(bits(result), bits(estimate(problem, scene, params)[:2]),
                             "{} {} {}".format(function, len(args), sorted(kwargs)))


class EstimateTest(unittest.TestCase):

    def test_report(self):
        for problem, scene in (("Homography", PLANE), ("Fundamental", GENERAL), ("Essential", DISTORTED)):
            model, mask, report = estimate(problem, scene, usac.Params())
            self.assertLess(scene.error(problem, model), 1.0)
            self.assertIsInstance(report, usac.Report)
            self.assertEqual(report.inliers, int(mask.sum()))
            self.assertGreater(report.iterations, 0)
            self.assertGreater(report.models, 0)
            self.assertIn(report.stop, (usac.STOP_MAX_ITERATIONS, usac.STOP_STANDARD, usac.STOP_SPRT, usac.STOP_P_NAPSAC))
            self.assertGreater(report.cost, 0)
            self.assertLess(report.cost, 1)
            for name in ("rejectedSamples", "rejectedModels", "droppedModels", "localOptimizations", "localImprovements",
                         "setupMs", "searchMs", "localMs", "polishMs"):
                self.assertGreaterEqual(getattr(report, name), 0, name)
            self.assertIsInstance(report.degenerate, bool)
            self.assertIsInstance(report.describe(), str)
            self.assertGreater(len(report.describe()), 10)
            for name in fields(report):
                self.assertIn(name + "=", repr(report))
        self.assertEqual(usac.Report().stop, usac.STOP_NOT_RUN)

    @needsLoader
    def test_optional_arguments(self):
        p, g, d = PLANE, GENERAL, DISTORTED
        params = usac.UsacParams()
        for function, short, full in (
                (usac.estimateHomography, [(p.points1, p.points2), (p.points1, p.points2, params)],
                 (p.points1, p.points2, params, None)),
                (usac.estimateFundamental, [(g.points1, g.points2), (g.points1, g.points2, params)],
                 (g.points1, g.points2, params, None)),
                (usac.estimateEssential,
                 [(g.points1, g.points2, g.K1), (g.points1, g.points2, g.K1, params),
                  (g.points1, g.points2, g.K1, params, None), (g.points1, g.points2, g.K1, g.K1)],
                 (g.points1, g.points2, g.K1, None, None, None, params, None)),
                (usac.estimateEssential, [(d.points1, d.points2, d.K1, d.K2, d.d1, d.d2)],
                 (d.points1, d.points2, d.K1, d.K2, d.d1, d.d2, params, None))):
            for args in short:
                self.assertEqual(bits(function(*args)[:2]), bits(function(*full)[:2]))
        expected = bits(usac.estimateHomography(p.points1, p.points2, params)[:2])
        self.assertEqual(bits(usac.estimateHomography(p.points1, p.points2, params=params, mask=None)[:2]), expected)
        self.assertEqual(bits(usac.estimateHomography(points1=p.points1, points2=p.points2)[:2]), expected)

    @needsLoader
    def test_mask_of_the_caller(self):
        g = GENERAL
        for call in (lambda mask: usac.estimateFundamental(g.points1, g.points2, None, mask),
                     lambda mask: usac.estimateFundamental(g.points1, g.points2, mask=mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, usac.Params(), mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, usac.Params(), mask=mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, mask=mask)):
            given = np.full((len(g.points1), 1), 7, np.uint8)
            np.testing.assert_array_equal(call(given)[1], given)
            self.assertEqual(set(given.ravel()), {0, 1})

    def test_no_model(self):
        nan, few, none = np.full((50, 2), np.nan), np.eye(3, 2) * 100, np.zeros((0, 2))
        same = np.full((50, 2), 5.)
        for points, reasons in ((nan, [usac.STOP_TOO_FEW_POINTS]), (few, [usac.STOP_TOO_FEW_POINTS]),
                                (none, [usac.STOP_TOO_FEW_POINTS]), (same, [usac.STOP_TOO_FEW_POINTS, usac.STOP_NO_MODEL])):
            for function, args in ((usac.estimateHomography, ()), (usac.estimateFundamental, ()),
                                   (usac.estimateEssential, (PLANE.K1, None, None, None))):
                model, mask, report = function(points, points, *(args + (usac.Params(),)))
                self.assertIsNone(model)
                self.checkZeroMask(mask, len(points))
                self.assertIn(report.stop, reasons)
                self.assertEqual(report.inliers, 0)
            for flag in FLAGS.values():
                for function, args in (("findHomography", (flag,)), ("findFundamentalMat", (flag,)),
                                       ("findEssentialMat", (PLANE.K1, flag))):
                    model, mask = getattr(FINDER, function)(points, points, *args)
                    self.assertIsNone(model)
                    self.checkZeroMask(mask, len(points))

    def checkZeroMask(self, mask, count):
        if count == 0:
            self.assertTrue(mask is None or mask.size == 0)
        else:
            np.testing.assert_array_equal(mask, np.zeros((count, 1), np.uint8))

    def test_no_model_clears_the_mask_of_the_caller(self):
        given = np.full((3, 1), 7, np.uint8)
        FINDER.findHomography(np.eye(3, 2), np.eye(3, 2), cv.USACV20, 3.0, given)
        self.checkZeroMask(given, 3)

    def test_mistakes_raise(self):
        a, b, K, params = GENERAL.points1, GENERAL.points2, GENERAL.K1, usac.Params()
        for word, function, args in (
                ("points", usac.estimateHomography, (a, b[1:], params)),
                ("points", usac.estimateFundamental, (a, b[1:], params)),
                ("points", usac.estimateEssential, (a, b[1:], K, None, None, None, params)),
                ("points", FINDER.findHomography, (a, b[1:], cv.USACV20)),
                ("points", usac.estimateHomography, (np.ones((9, 5)), np.ones((9, 5)), params)),
                ("cameraMatrix", usac.estimateEssential, (a, b, np.eye(2), None, None, None, params)),
                ("cameraMatrix", usac.estimateEssential, (a, b, np.zeros((3, 3)), None, None, None, params)),
                ("cameraMatrix", FINDER.findEssentialMat, (a, b, np.eye(2), cv.USACV20)),
                ("hreshold", FINDER.findHomography, (a, b, cv.USACV20, -1.0)),
                ("hreshold", FINDER.findHomography, (a, b, cv.USACV20, float("nan"))),
                ("onfidence", FINDER.findFundamentalMat, (a, b, cv.USACV20, 3.0, 1.5)),
                ("max", FINDER.findEssentialMat, (a, b, K, cv.USACV20, 0.99, 1.0, -5)),
                ("method", usac.Params.fromMethod, (cv.RANSAC,)),
                ("method", usac.findHomography, (a, b, cv.RANSAC)),
                ("params", usac.estimateHomography, (a, b, 3.0)),
                ("params", usac.estimateHomography, (a, b, cv.UsacParams())),
                ("", usac.estimateHomography, ("a", "b", params)),
                ("", FINDER.findHomography, (a, "b", cv.USACV20))):
            with self.assertRaises(cv.error, msg="{} {}".format(word, args[2:])) as context:
                function(*args)
            self.assertIn(word, str(context.exception))

    def test_is_reproducible(self):
        def run():
            return [bits(estimate(*case)[:2]) for case in (("Homography", PLANE, usac.Params()),
                                                           ("Fundamental", GENERAL, usac.Params()),
                                                           ("Essential", DISTORTED, usac.Params()))]
        expected = run()
        cv.setRNGSeed(99)
        cv.randu(np.zeros((9, 9)), 0, 1)
        cv.findHomography(PLANE.points1, PLANE.points2, cv.RANSAC)
        self.assertEqual(run(), expected)
        results = [None] * 4

        def work(i):
            results[i] = run()
        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(results))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [expected] * len(results))

    def test_enumerations(self):
        for prefix, count in (("SAMPLER_", 3), ("PRIOR_", 4), ("SCORES_", 2), ("QUALITY_", 2), ("VERIFICATION_", 2),
                              ("LOCAL_OPTIMIZATION_", 2), ("TERMINATION_", 3), ("DEGENERACY_", 2), ("POLISHING_", 2),
                              ("STOP_", 8)):
            found = [getattr(usac, name) for name in dir(usac) if name.startswith(prefix)]
            self.assertGreaterEqual(len(found), count, prefix)
            self.assertEqual(len(set(found)), len(found), prefix)
        self.assertEqual((usac.HOMOGRAPHY, usac.FUNDAMENTAL, usac.ESSENTIAL), (0, 1, 2))
        for name in ("MAX_MODELS", "Residual_SAMPSON"):
            self.assertFalse(hasattr(usac, name))


if __name__ == "__main__":
    unittest.main()
