#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests the method flags of the module (USACV20, USACV20_FAST, ...) in all forms in which OpenCV's
functions, for example findHomography, can be called, and the functions estimate... of the module.

The file can be run alone (python3 test_usac.py) or together with OpenCV's Python tests. It tests
either cv2.usacv20 or the package usacv20: see usac_common.py.
"""

import inspect
import unittest

import numpy as np

from usac_common import (FINDER, FLAGS, GENERAL, LMEDS, MOVED, PLANE, RANSAC, RHO, THRESHOLD, USAC_DEFAULT,
                         USAC_MAGSAC, bits, cv, estimate, forms, needsCv2, paramsForms, usac)
from usac_pose import POSE


class FlagTest(unittest.TestCase):

    def test_names_and_values(self):
        self.assertEqual([FLAGS[name] - 0x4000 for name in ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC",
                                                            "USACV20_MAGSAC", "USACV20_PARALLEL",
                                                            "USACV20_AUTO")], list(range(len(FLAGS))))
        for value in FLAGS.values():
            self.assertTrue(usac.isUsacV20Method(value))
        for value in (-1, 0, LMEDS, RANSAC, RHO, USAC_DEFAULT, USAC_MAGSAC, 0x3fff, max(FLAGS.values()) + 1):
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

    def test_params_in_the_place_of_a_flag(self):
        params = usac.Params(threshold=THRESHOLD, maxIterations=500)
        for problem, function, scene, args, kwargs in paramsForms(params):
            for where in {usac, FINDER}:
                result = getattr(where, function)(*args, **kwargs)
                self.assertEqual(bits(result), bits(estimate(problem, scene, params)[:2]),
                                 "{} {} {}".format(function, len(args), sorted(kwargs)))

    def test_defaults_are_those_of_opencv(self):
        """The defaults must be those that the signature shows: a call with these values must give the same
        result as a call without these arguments."""
        m, K = MOVED, PLANE.K1
        for name, args, values in (("findHomography", (), (3, 2000, 0.995)), ("findFundamentalMat", (), (3, 0.99, 1000)),
                                   ("findEssentialMat", (K,), (0.999, 1, 1000)), ("estimateAffine2D", (), (3, 2000, 0.99, 10)),
                                   ("estimateAffinePartial2D", (), (3, 2000, 0.99, 10))):
            function, args = getattr(usac, name), (m.points1, m.points2) + args
            bound = inspect.signature(function).bind(*args)
            bound.apply_defaults()
            del bound.arguments["params"]
            shown = [bound.arguments[key] for key in bound.arguments if key in (
                "ransacReprojThreshold", "threshold", "maxIters", "confidence", "prob", "refineIters")]
            self.assertEqual(tuple(shown), values, name)
            self.assertEqual(bits(function(**bound.arguments)), bits(function(*args)), name)
            self.assertEqual(bits(getattr(FINDER, name)(*args, method=usac.USACV20)), bits(function(*args)), name)

    def test_steps_of_the_last_polish(self):
        a, b = MOVED.points1, MOVED.points2
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            params = usac.Params(polishing=usac.POLISHING_NONE, threshold=3, maxIterations=2000)
            plain = function(a, b, None, usac.USACV20, refineIters=0)
            self.assertEqual(bits(plain), bits(function(a, b, params)))
            self.assertNotEqual(bits(plain), bits(function(a, b, None, usac.USACV20)))
            for wrong in (dict(refineIters=2**40), dict(maxIters=2**40), dict(maxIters=0)):
                with self.assertRaisesRegex(usac.error, list(wrong)[0]):
                    function(a, b, None, usac.USACV20, **wrong)

    def test_none_in_the_place_of_the_mask(self):
        # In OpenCV's findFundamentalMat, None at this position means that maxIters is 0. With a flag
        # of this module, None must have the same effect as no argument.
        g = GENERAL
        self.assertEqual(bits(FINDER.findFundamentalMat(g.points1, g.points2, usac.USACV20, 1.0, 0.99, None)),
                         bits(FINDER.findFundamentalMat(g.points1, g.points2, usac.USACV20, 1.0, 0.99)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20, 0.999, 1.0, None)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20, 0.999, 1.0)))

    @needsCv2
    def test_umat(self):
        a, b = np.rint(PLANE.points1), np.rint(PLANE.points2)
        model, mask = FINDER.findHomography(cv.UMat(a), cv.UMat(b), usac.USACV20, 3.0)
        self.assertEqual(bits((model, mask)), bits(FINDER.findHomography(a, b, usac.USACV20, 3.0)))


class EstimateTest(unittest.TestCase):

    def test_optional_arguments(self):
        p, g = PLANE, GENERAL
        params = usac.UsacParams()
        expected = bits(usac.estimateHomography(p.points1, p.points2, params)[:2])
        self.assertEqual(bits(usac.estimateHomography(p.points1, p.points2)[:2]), expected)
        self.assertEqual(bits(usac.estimateHomography(p.points1, p.points2, params=params, mask=None)[:2]), expected)
        self.assertEqual(bits(usac.estimateHomography(points1=p.points1, points2=p.points2)[:2]), expected)
        expected = bits(usac.estimateEssential(g.points1, g.points2, g.K1, None, None, None, params, None)[:2])
        for args in ((), (params,), (params, None), (g.K1,)):
            self.assertEqual(bits(usac.estimateEssential(g.points1, g.points2, g.K1, *args)[:2]), expected)

    def test_mask_of_the_caller(self):
        g = GENERAL
        for call in (lambda mask: usac.estimateFundamental(g.points1, g.points2, None, mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, usac.Params(), mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, usac.Params(), mask=mask),
                     lambda mask: usac.estimateEssential(g.points1, g.points2, g.K1, mask=mask)):
            given = np.full((len(g.points1), 1), 7, np.uint8)
            np.testing.assert_array_equal(call(given)[1], given)
            self.assertEqual(set(given.ravel()), {0, 1})

    def test_any_problem(self):
        """estimateModel(problem, ...) must return the same result as the function for this problem."""
        a, b, K, params = PLANE.points1, PLANE.points2, PLANE.K1, usac.Params(threshold=2, seed=3)
        for problem, function in (("homography", usac.estimateHomography), (usac.AFFINITY, usac.estimateAffinity2D)):
            self.assertEqual(bits(usac.estimateModel(problem, a, b, params)[:2]), bits(function(a, b, params)[:2]), problem)
        self.assertEqual(bits(usac.estimateModel(usac.ESSENTIAL, a, b, None, None, K)[:2]), bits(usac.estimateEssential(a, b, K)[:2]))
        for problem, name in (("plane", "problem"), (usac.ESSENTIAL, "cameraMatrix1")):
            with self.assertRaisesRegex(usac.error, name):
                usac.estimateModel(problem, a, b)

    def test_no_model(self):
        nan, few, none, same = np.full((50, 2), np.nan), np.eye(1, 2) * 100, np.zeros((0, 2)), np.full((50, 2), 5.)
        self.assertEqual((usac.findHomography([], [], usac.USACV20)[0], usac.findHomography([], [])[1].shape), (None, (0, 1)))
        for points in (nan, few, none, same):
            for function, args in ((usac.estimateHomography, ()), (usac.estimateEssential, (PLANE.K1,))):
                model, mask, report = function(points, points, *args)
                self.assertEqual((model, report.inliers), (None, 0))
                self.checkZeroMask(mask, len(points))
                self.assertIn(report.stop, (usac.STOP_TOO_FEW_POINTS, usac.STOP_NO_MODEL))
            for flag in (usac.USACV20, usac.USACV20_AUTO):
                for function, args in (("findHomography", (flag,)), ("findFundamentalMat", (flag,)), ("findEssentialMat", (PLANE.K1, flag)),
                                       ("estimateAffine2D", (None, flag)), ("estimateAffinePartial2D", (None, flag))):
                    model, mask = getattr(FINDER, function)(points, points, *args)
                    self.assertIsNone(model)
                    self.checkZeroMask(mask, len(points))
        given = np.full((3, 1), 7, np.uint8)
        FINDER.findHomography(np.eye(3, 2), np.eye(3, 2), usac.USACV20, 3.0, given)
        self.checkZeroMask(given, 3)

    def checkZeroMask(self, mask, count):
        if count == 0:
            self.assertTrue(mask is None or mask.size == 0)
        else:
            np.testing.assert_array_equal(mask, np.zeros((count, 1), np.uint8))

    def test_rows_that_are_not_finite(self):
        for bad in (np.nan, -np.inf, 1e30):
            a, b = PLANE.points1.copy(), PLANE.points2.copy()
            a[::5, 0] = bad
            b[2::5, 1] = bad
            model, mask, report = usac.estimateHomography(a, b, usac.Params())
            self.assertLess(PLANE.error("Homography", model), 1.0, bad)
            self.assertEqual(int(mask[::5].sum() + mask[2::5].sum()), 0, bad)
            self.assertEqual(report.inliers, int(mask.sum()))

    def test_pose_with_params(self):
        expected = bits(usac.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, params=usac.Params())[2:])
        self.assertEqual(bits(usac.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, flags=usac.Params())[1:]), expected)


if __name__ == "__main__":
    unittest.main()
