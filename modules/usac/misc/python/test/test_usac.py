#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests the method flags of the module (USACV20, USACV20_FAST, ...) in all forms in which OpenCV's
functions, for example findHomography, can be called.

The file can be run alone (python3 test_usac.py) or together with OpenCV's Python tests. It tests
either cv2.usacv20 or the package usacv20: see usac_common.py.
"""

import unittest

import numpy as np

from usac_common import (DISTORTED, FINDER, FLAGS, GENERAL, LMEDS, MOVED, PLANE, RANSAC, RHO, THRESHOLD, USAC_DEFAULT,
                         USAC_MAGSAC, bits, cv, estimate, forms, needsCv2, outcome, usac)


class FlagTest(unittest.TestCase):

    def test_names_and_values(self):
        self.assertLessEqual({"USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC", "USACV20_MAGSAC",
                              "USACV20_PARALLEL", "USACV20_AUTO"}, set(FLAGS))
        self.assertEqual(len(set(FLAGS.values())), len(FLAGS))
        self.assertTrue(all(0x4000 <= value < 0x4100 for value in FLAGS.values()))
        self.assertEqual([FLAGS[name] - 0x4000 for name in ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_PROSAC",
                                                            "USACV20_MAGSAC", "USACV20_PARALLEL",
                                                            "USACV20_AUTO")], list(range(7)))
        for name, value in FLAGS.items():
            self.assertEqual(getattr(usac, name), value)
            self.assertIsInstance(getattr(usac, name), usac.UsacV20Method)
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

    def test_integers_of_numpy(self):
        for kind in (np.int32, np.int64, np.uint16):
            for method in (kind(usac.USACV20), kind(RANSAC)):
                finder = FINDER if method == usac.USACV20 else usac
                for (_, function, _, args, kwargs), (_, _, _, args2, kwargs2) in zip(forms(method), forms(int(method))):
                    self.assertEqual(outcome(getattr(finder, function), args, kwargs),
                                     outcome(getattr(finder, function), args2, kwargs2))

    def test_defaults_are_those_of_opencv(self):
        a, b, g = PLANE.points1, PLANE.points2, GENERAL
        self.assertEqual(bits(FINDER.findHomography(a, b, usac.USACV20)),
                         bits(FINDER.findHomography(a, b, usac.USACV20, 3, None, 2000, 0.995)))
        self.assertEqual(bits(FINDER.findFundamentalMat(a, b, usac.USACV20)),
                         bits(FINDER.findFundamentalMat(a, b, usac.USACV20, 3., 0.99, 1000)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20, 0.999, 1.0, 1000)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, None, g.K1, None, usac.USACV20)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.focal, g.pp, usac.USACV20, 0.999, 1.0)))

    def test_defaults_of_the_maps_are_those_of_opencv(self):
        a, b = MOVED.points1, MOVED.points2
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            self.assertEqual(bits(function(a, b, None, usac.USACV20)), bits(function(a, b, None, usac.USACV20, 3, 2000, 0.99, 10)))
            self.assertEqual(bits(function(a, b, method=usac.USACV20)), bits(function(a, b, None, usac.USACV20)))

    def test_steps_of_the_last_polish(self):
        a, b = MOVED.points1, MOVED.points2
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            params = usac.Params()
            params.polishing, params.threshold, params.maxIterations = usac.POLISHING_NONE, 3, 2000
            plain = function(a, b, None, usac.USACV20, refineIters=0)
            self.assertEqual(bits(plain), bits(function(a, b, params)))
            self.assertNotEqual(bits(plain), bits(function(a, b, None, usac.USACV20)))
            for wrong in (dict(refineIters=2**40), dict(maxIters=2**40), dict(maxIters=0)):
                with self.assertRaises(usac.error) as context:
                    function(a, b, None, usac.USACV20, **wrong)
                self.assertIn(list(wrong)[0], str(context.exception))

    def test_too_few_points_for_a_map(self):
        for function in (FINDER.estimateAffine2D, FINDER.estimateAffinePartial2D):
            model, inliers = function(np.zeros((1, 2)), np.zeros((1, 2)), None, usac.USACV20)
            self.assertIsNone(model)
            self.assertEqual(bits(inliers), bits(np.zeros((1, 1), np.uint8)))

    def test_none_in_the_place_of_the_mask(self):
        # In OpenCV's findFundamentalMat, None at this position means that maxIters is 0. With a flag
        # of this module, None must have the same effect as no argument.
        g = GENERAL
        self.assertEqual(bits(FINDER.findFundamentalMat(g.points1, g.points2, usac.USACV20, 1.0, 0.99, None)),
                         bits(FINDER.findFundamentalMat(g.points1, g.points2, usac.USACV20, 1.0, 0.99)))
        self.assertEqual(bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20, 0.999, 1.0, None)),
                         bits(FINDER.findEssentialMat(g.points1, g.points2, g.K1, usac.USACV20, 0.999, 1.0)))

    def test_mask_of_the_caller(self):
        for flag in (usac.USACV20, usac.USACV20_FAST):
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
        expected = bits(FINDER.findHomography(a, b, usac.USACV20, 3.0))
        wide = np.zeros((len(a), 5))
        wide[:, 1:3] = b
        ones = np.ones((len(a), 1))
        for p, q in ((np.float32(a), np.float32(b)), (np.int32(a), np.int32(b)), (a[:, None], b[:, None]),
                     (a[None], b[None]), (np.asfortranarray(a), wide[:, 1:3]), (np.float32(a), b[None]),
                     (a[::-1][::-1], np.repeat(b, 2, axis=0)[::2]), (a.T, b.T), (np.ascontiguousarray(a.T), b[None]),
                     (np.hstack([a, ones]), np.hstack([b, ones]).T)):
            self.assertEqual(bits(FINDER.findHomography(p, q, usac.USACV20, 3.0)), expected)

    @needsCv2
    def test_umat(self):
        a, b = np.rint(PLANE.points1), np.rint(PLANE.points2)
        model, mask = FINDER.findHomography(cv.UMat(a), cv.UMat(b), usac.USACV20, 3.0)
        self.assertEqual(bits((model, mask)), bits(FINDER.findHomography(a, b, usac.USACV20, 3.0)))


if __name__ == "__main__":
    unittest.main()
