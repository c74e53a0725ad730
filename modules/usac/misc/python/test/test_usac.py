#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The Python surface of the module usac.

Runs alone (python3 test_usac.py, PYTHONPATH=<build>/python_loader) and among OpenCV's Python tests.
Without OpenCV's loader (OPENCV_SKIP_PYTHON_LOADER) cv2.find* are OpenCV's own; then cv2.usacv20.find* are tested in
their place, and what the loader's package adds is skipped.
"""

import os
import pickle
import subprocess
import sys
import types
import unittest

import cv2 as cv
import numpy as np

from usac_common import (DISTORTED, FINDER, FLAGS, FUNCTIONS, GENERAL, MOVED, NATIVE, PLANE, THRESHOLD, bits, estimate,
                         forms, formsOfOpencv, loadPackage, needsLoader, outcome, paramsForms, usac, values)
from usac_pose import formsOfPose, paramsFormsOfPose


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
        for function in (usac, usac.estimateHomography, usac.estimateFundamental, usac.estimateEssential,
                         usac.estimateAffinity2D, usac.estimateSimilarity2D, usac.estimateAbsolutePose):
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
        for method in (0, cv.RANSAC, cv.LMEDS, cv.RHO, cv.USAC_DEFAULT, cv.USAC_MAGSAC, 0x3fff, max(FLAGS.values()) + 1, -1,
                       2**40, True, None, "RANSAC", 16384.0):
            for function, args, kwargs in self.allForms(method):
                self.check("opencv", function, *args, **kwargs)
        for flag in FLAGS.values():
            for method in (flag, np.int32(flag), np.int64(flag), np.uint16(flag)):
                for function, args, kwargs in self.allForms(method):
                    self.check("usacv20", function, *args, **kwargs)
        for params, route in ((cv.UsacParams(), "opencv"), (None, "opencv"), (usac.Params(), "usacv20")):
            for _, function, _, args, kwargs in paramsForms(params):
                self.check(route, function, *args, **kwargs)
            for args, kwargs in paramsFormsOfPose(params):
                self.check(route, "solvePnPRansac", *args, **kwargs)

    def allForms(self, method):
        return ([(function, args, kwargs) for _, function, _, args, kwargs in forms(method)]
                + [("solvePnPRansac", args, kwargs) for args, kwargs in formsOfPose(method)])

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
            for function in ("estimateAffine2D", "estimateAffinePartial2D"):
                self.check("opencv", function, a, a, None, cv.RANSAC, n, n, n, n)
                self.check("opencv", function, a, a, n, cv.LMEDS)
                self.check("opencv", function, n, n, maxIters=n)
                self.check("usacv20", function, a, a, None, n)
            self.check("opencv", "solvePnPRansac", a, a, K, None, n, n, n, n, n, n, n)
            self.check("opencv", "solvePnPRansac", a, a, K, None, None, None, n, iterationsCount=n, flags=cv.SOLVEPNP_EPNP)
            self.check("usacv20", "solvePnPRansac", a, a, K, None, None, None, True, 9, 8., 0.9, None, n)


class FlagTest(unittest.TestCase):

    def test_names_and_values(self):
        self.assertLessEqual({"USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC", "USACV20_MAGSAC",
                              "USACV20_PARALLEL"}, set(FLAGS))
        self.assertEqual(len(set(FLAGS.values())), len(FLAGS))
        self.assertTrue(all(0x4000 <= value < 0x4100 for value in FLAGS.values()))
        self.assertEqual([FLAGS[name] - 0x4000 for name in ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC",
                                                            "USACV20_MAGSAC", "USACV20_PARALLEL")], list(range(6)))
        self.assertEqual([name for name in dir(NATIVE) if "USACV20" in name], sorted(FLAGS))  # none as of an enum class
        for name, value in FLAGS.items():
            self.assertIs(type(value), int)
            self.assertEqual(getattr(cv, name), value)
            self.assertTrue(usac.isUsacV20Method(value))
        for value in (-1, 0, cv.LMEDS, cv.RANSAC, cv.RHO, cv.USAC_DEFAULT, cv.USAC_MAGSAC, 0x3fff, max(FLAGS.values()) + 1):
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
        self.assertEqual((model.shape, model.dtype), ((2 if problem.endswith("2D") else 3, 3), np.float64), label)
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

    def test_flags_of_opencv_are_handed_on(self):
        found = 0
        for _, function, _, args, kwargs in formsOfOpencv():
            expected = outcome(getattr(NATIVE, function), args, kwargs)
            self.assertEqual(outcome(getattr(usac, function), args, kwargs), expected,
                             "{} {} {}".format(function, len(args), sorted(kwargs)))
            found += isinstance(expected[0], tuple)
        self.assertGreater(found, 100)  # models, not only equal exceptions

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

    def test_defaults_of_the_maps_are_those_of_opencv(self):
        a, b = MOVED.points1, MOVED.points2
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            self.assertEqual(bits(function(a, b, None, cv.USACV20)), bits(function(a, b, None, cv.USACV20, 3, 2000, 0.99, 10)))
            self.assertEqual(bits(function(a, b, method=cv.USACV20)), bits(function(a, b, None, cv.USACV20)))

    def test_steps_of_the_last_polish(self):
        a, b = MOVED.points1, MOVED.points2
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            params = usac.Params()
            params.polishing, params.threshold, params.maxIterations = usac.POLISHING_NONE, 3, 2000
            plain = function(a, b, None, cv.USACV20, refineIters=0)
            self.assertEqual(bits(plain), bits(function(a, b, params)))
            self.assertNotEqual(bits(plain), bits(function(a, b, None, cv.USACV20)))
            for wrong in (dict(refineIters=2**40), dict(maxIters=2**40), dict(maxIters=0)):
                with self.assertRaises(cv.error) as context:
                    function(a, b, None, cv.USACV20, **wrong)
                self.assertIn("polishingSteps" if "refineIters" in wrong else "maxIterations", str(context.exception))

    def test_too_few_points_for_a_map(self):
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            model, inliers = function(np.zeros((1, 2)), np.zeros((1, 2)), None, cv.USACV20)
            self.assertIsNone(model)
            self.assertEqual(bits(inliers), bits(np.zeros((1, 1), np.uint8)))

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
        ones = np.ones((len(a), 1))
        for p, q in ((np.float32(a), np.float32(b)), (np.int32(a), np.int32(b)), (a[:, None], b[:, None]),
                     (a[None], b[None]), (np.asfortranarray(a), wide[:, 1:3]), (np.float32(a), b[None]),
                     (a[::-1][::-1], np.repeat(b, 2, axis=0)[::2]), (a.T, b.T), (np.ascontiguousarray(a.T), b[None]),
                     (np.hstack([a, ones]), np.hstack([b, ones]).T), (a.reshape(2, -1, 2), b)):
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
        found = 0
        for _, function, _, args, kwargs in formsOfOpencv():  # for USAC and E see RouteTest
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
                                 ((p.points1, p.points2, max(FLAGS.values()) + 1), {}),
                                 ((p.points1, p.points2, p.K1, 0x3fff), {}), ((1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12), {})):
                self.compare(function, args, kwargs)


if __name__ == "__main__":
    unittest.main()
