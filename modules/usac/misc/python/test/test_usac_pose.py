#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of solvePnPRansac with the flags of the module, of estimateAbsolutePose, and of initial
models."""

import sys
import types
import unittest
from unittest import mock

import numpy as np

from usac_common import (FINDER, FLAGS, IN_TREE, NATIVE, SOLVEPNP_AP3P, SOLVEPNP_EPNP, SOLVEPNP_ITERATIVE,
                         SOLVEPNP_P3P, SOLVEPNP_SQPNP, THRESHOLD, USAC_ACCURATE, USAC_DEFAULT, USAC_FAST, USAC_MAGSAC,
                         USAC_PROSAC, bits, cv, inTree, needsCv2, outcome, package, usac)
from usac_camera import rotation
from usac_pose import FEW, POSE, formsOfPose, paramsFormsOfPose


def pose(scene, params, *args):
    """Estimates the pose of a PoseScene with its camera; returns (model, mask, report)."""
    return usac.estimateAbsolutePose(scene.X, scene.x, scene.K, scene.d, params, *args)


def solve(scene, **kwargs):
    return FINDER.solvePnPRansac(scene.X, scene.x, scene.K, scene.d, **kwargs)


def indices(mask):
    """Returns the array `inliers` that solvePnPRansac must return for this mask."""
    return np.flatnonzero(mask).astype(np.int32).reshape(-1, 1)


class PoseFlagTest(unittest.TestCase):

    def test_every_flag_in_every_form(self):
        for name, flag in sorted(FLAGS.items()):
            params = usac.Params.fromMethod(flag)
            params.threshold, params.confidence, params.maxIterations = THRESHOLD, 0.99, 1000
            model, mask, _ = pose(POSE, params)
            for args, kwargs in formsOfPose(flag):
                label = "{} {} {}".format(name, len(args), sorted(kwargs))
                self.check(FINDER.solvePnPRansac(*args, **kwargs), model, mask, label)

    def check(self, result, model, mask, label):
        self.assertEqual(len(result), 4, label)
        found, rvec, tvec, inliers = result
        self.assertIs(found, True, label)
        self.assertEqual((rvec.shape, rvec.dtype), ((3, 1), np.float64), label)
        self.assertEqual((tvec.shape, tvec.dtype), ((3, 1), np.float64), label)
        self.assertEqual(bits(tvec), bits(model[:, 3:].copy()), label)
        np.testing.assert_allclose(rotation(rvec), model[:, :3], atol=1e-12)
        self.assertEqual(bits(inliers), bits(indices(mask)), label)
        self.assertGreater(POSE.inliers[inliers.ravel()].mean(), 0.95, label)
        self.assertGreater(len(inliers), 0.8 * POSE.inliers.sum(), label)
        self.assertLess(POSE.error(rvec, tvec), 0.3, label)

    def test_params_in_the_place_of_a_flag(self):
        params = usac.Params()
        params.threshold, params.maxIterations = THRESHOLD, 1000
        expected = bits(solve(POSE, reprojectionError=THRESHOLD, iterationsCount=1000, flags=usac.USACV20))
        for args, kwargs in paramsFormsOfPose(params):
            found, cameraMatrix, rvec, tvec, inliers = FINDER.solvePnPRansac(*args, **kwargs)
            self.assertEqual(bits((found, rvec, tvec, inliers)), expected)
            self.assertEqual(bits(cameraMatrix), bits(POSE.K))
        if cv is not None:
            theirs = NATIVE.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, params=cv.UsacParams())
            self.assertEqual([type(value) for value in theirs], [bool] + [np.ndarray] * 4)

    def test_defaults_are_those_of_opencv(self):
        expected = bits(solve(POSE, useExtrinsicGuess=False, iterationsCount=100, reprojectionError=8.0, confidence=0.99,
                              flags=usac.USACV20))
        self.assertEqual(bits(solve(POSE, flags=usac.USACV20)), expected)
        self.assertEqual(bits(usac.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d)), expected)

    def test_arrays_of_the_caller(self):
        found, rvec, tvec, inliers = solve(POSE, flags=usac.USACV20)
        given = [np.full((3, 1), 7.), np.full((3, 1), 7.), np.full(inliers.shape, 7, np.int32)]
        result = FINDER.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, given[0], given[1], inliers=given[2], flags=usac.USACV20)
        self.assertEqual(bits(result), bits((found, rvec, tvec, inliers)))
        self.assertEqual(bits(given), bits([rvec, tvec, inliers]))

    def test_no_pose(self):
        same = np.ones_like(POSE.X)
        for X, x in ((same, POSE.x), (POSE.X[:2], POSE.x[:2]), (POSE.X * np.nan, POSE.x)):
            found, _, _, inliers = FINDER.solvePnPRansac(X, x, POSE.K, POSE.d, flags=usac.USACV20)
            self.assertIs(found, False)
            self.assertTrue(inliers is None or len(inliers) == 0)
            rvec, tvec = np.full((3, 1), 7.), np.full((3, 1), 5.)
            self.assertIs(FINDER.solvePnPRansac(X, x, POSE.K, POSE.d, rvec, tvec, flags=usac.USACV20)[0], False)
            self.assertEqual((set(rvec.ravel()), set(tvec.ravel())), ({7.}, {5.}))
            model, mask, report = usac.estimateAbsolutePose(X, x, POSE.K)
            self.assertIsNone(model)
            self.assertEqual(bits(mask), bits(np.zeros((len(X), 1), np.uint8)))
            self.assertIn(report.stop, (usac.STOP_TOO_FEW_POINTS, usac.STOP_NO_MODEL))


@needsCv2
class OpencvFlagTest(unittest.TestCase):
    """Calls without a flag or Params of this module must give exactly the same results as OpenCV's
    own function."""

    def setUp(self):
        if not IN_TREE:
            self.addCleanup(usac.patch_cv2().undo)

    FLAGS = (SOLVEPNP_ITERATIVE, SOLVEPNP_EPNP, SOLVEPNP_P3P, SOLVEPNP_AP3P, SOLVEPNP_SQPNP, USAC_DEFAULT,
             USAC_FAST, USAC_ACCURATE, USAC_PROSAC, USAC_MAGSAC)

    def test_are_handed_on(self):
        found = 0
        for flag in self.FLAGS:
            for args, kwargs in formsOfPose(flag):
                expected = outcome(NATIVE.solvePnPRansac, args, kwargs)
                self.assertEqual(outcome(usac.solvePnPRansac, args, kwargs), expected, flag)
                self.assertEqual(outcome(cv.solvePnPRansac, args, kwargs), expected, flag)
                found += expected[0] is True
        self.assertGreater(found, len(self.FLAGS))  # makes sure that poses are compared, not only exceptions

    def test_other_calls(self):
        s, X, x = POSE, POSE.X, POSE.x
        for args, kwargs in paramsFormsOfPose(cv.UsacParams()) + [
                ((X, x, s.K, s.d), {}), ((X, x, s.K, None), {}), ((X, x, s.K), {}), ((), {}), ((X, x[:50], s.K, s.d), {}),
                ((X, x, s.K, s.d), dict(flags="USACV20")), ((X, x, s.K, s.d), dict(method=usac.USACV20)),
                ((X, x, s.K, s.d), dict(flags=max(FLAGS.values()) + 1)), ((X, x, s.K, s.d), dict(flags=2**40)),
                ((X, x, s.K, s.d), dict(iterationsCount=usac.USACV20))]:
            self.assertEqual(outcome(cv.solvePnPRansac, args, kwargs), outcome(NATIVE.solvePnPRansac, args, kwargs),
                             "{} {}".format(len(args), sorted(kwargs)))


@package
class FlagsOfAnotherOpencvTest(unittest.TestCase):
    """The values of SOLVEPNP_* differ between OpenCV 4 and 5. Values of the imported cv2 must be
    converted by name to those of the OpenCV that the package was built with."""

    V4 = dict(ITERATIVE=0, EPNP=1, P3P=2, DLS=3, UPNP=4, AP3P=5, IPPE=6, IPPE_SQUARE=7, SQPNP=8, MAX_COUNT=9)
    V5 = dict(ITERATIVE=0, EPNP=1, P3P=2, AP3P=3, IPPE=4, IPPE_SQUARE=5, SQPNP=6, MAX_COUNT=7)

    def outcomes(self, cv2, flags):
        with mock.patch.dict(sys.modules, cv2=cv2):
            return [outcome(usac.solvePnPRansac, (POSE.X, POSE.x, POSE.K, POSE.d), dict(flags=flag)) for flag in flags]

    def test_by_name(self):
        native = sys.modules[usac.__name__ + "._native"].solvePnPFlags
        names = sorted(native)
        expected = self.outcomes(None, [native[name] for name in names])
        # OpenCV 5's SQPNP has the value of OpenCV 4's IPPE, and OpenCV 5's IPPE_SQUARE has the value of
        # OpenCV 4's AP3P. If the two flags of such a pair gave equal results, the test could not detect
        # a flag that was not converted.
        byName = dict(zip(names, expected))
        self.assertNotEqual(byName["SOLVEPNP_SQPNP"], byName["SOLVEPNP_IPPE"])
        self.assertNotEqual(byName["SOLVEPNP_AP3P"], byName["SOLVEPNP_IPPE_SQUARE"])
        for version, theirs in (("4.10.0", self.V4), ("5.0.0", self.V5)):
            cv2 = types.SimpleNamespace(__version__=version, **{"SOLVEPNP_" + name: flag for name, flag in theirs.items()})
            self.assertEqual(self.outcomes(cv2, [getattr(cv2, name) for name in names]), expected, version)
            others = [USAC_DEFAULT, USAC_MAGSAC, usac.USACV20]
            self.assertEqual(self.outcomes(cv2, others), self.outcomes(None, others), version)

    def test_refused(self):
        own = sys.modules[usac.__name__ + "._native"].solvePnPFlags
        theirs, wrong, word = ((self.V5, 7, "no flag") if own["SOLVEPNP_SQPNP"] == 8 else (self.V4, 3, "SOLVEPNP_DLS"))
        cv2 = types.SimpleNamespace(__version__="x.y", **{"SOLVEPNP_" + name: flag for name, flag in theirs.items()})
        with mock.patch.dict(sys.modules, cv2=cv2):
            with self.assertRaisesRegex(usac.error, "flags: {} is {} of the imported cv2 x.y".format(wrong, word)):
                solve(POSE, flags=wrong)


class BeginTest(unittest.TestCase):
    """Tests of initial models, for example a guessed pose. The search evaluates the initial model
    before the first sample."""

    def guess(self, rvec, tvec, **kwargs):
        return FINDER.solvePnPRansac(FEW.X, FEW.x, FEW.K, FEW.d, rvec, tvec, True, 10, THRESHOLD, flags=usac.USACV20, **kwargs)

    def test_guess(self):
        r, t = FEW.r + [0.003, -0.002, 0.002], FEW.t
        found, rvec, tvec, inliers = self.guess(r.copy(), t.copy())
        self.assertIs(found, True)
        self.assertLess(FEW.error(rvec, tvec), 0.5)
        self.assertGreater(FEW.inliers[inliers.ravel()].mean(), 0.8)
        expected = bits((found, rvec.reshape(3, 1), tvec.reshape(3, 1), inliers))
        for given in ((r[:, None].copy(), t[:, None].copy()), (r[None].copy(), t[None].copy()), (r.copy(), t[:, None].copy())):
            found, rvec, tvec, inliers = self.guess(*given)
            self.assertEqual(bits((found, rvec.reshape(3, 1), tvec.reshape(3, 1), inliers)), expected)
        self.assertEqual(bits(self.guess(np.float32(r), np.float32(t))[3]), expected[3])
        locked = r[:, None].copy(), t.copy()
        for array in locked:
            array.setflags(write=False)
        for given in (locked, (r.tolist(), tuple(t))):  # such a guess is only read
            found, rvec, tvec, inliers = usac.solvePnPRansac(FEW.X, FEW.x, FEW.K, FEW.d, *given, True, 10, THRESHOLD, flags=usac.USACV20)
            self.assertEqual(bits((found, rvec.reshape(3, 1), tvec.reshape(3, 1), inliers)), expected)
        self.assertEqual(bits(locked), bits((r[:, None], t)))
        away = self.guess(r + 1, t)
        self.assertFalse(away[0] and FEW.error(away[1], away[2]) < 5)

    def test_arrays_of_other_types(self):
        for kind in (bool, np.float32, np.uint8):
            given = np.ones((3, 1), kind), np.zeros((3, 1), kind)
            params = usac.Params(threshold=THRESHOLD)
            found, rvec, tvec, _ = usac.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, *given, flags=params)
            self.assertTrue(found)
            self.assertLess(POSE.error(rvec, tvec), 0.5)
            self.assertTrue(given[0].all() and not given[1].any())

    def test_wrong_guess(self):
        t = FEW.t
        for rvec, tvec, word in ((np.zeros(2), t, "rvec"), (t, np.zeros((2, 1)), "tvec"), (t * np.nan, t, "rvec"),
                                 (t, t * np.inf, "tvec"), (None, t, "rvec"), (np.zeros(3), None, "tvec")):
            with self.assertRaisesRegex(usac.error, word):
                self.guess(rvec, tvec)

    def test_shapes_of_initial_models(self):
        params = usac.Params(initialModel=np.eye(3), initialCovariance=np.eye(8))
        for wrong in (np.ones((3, 2)), np.ones((4, 3)), np.ones((2, 6)), np.ones((3, 3, 1))):
            with self.assertRaisesRegex(usac.error, "^model: "):
                params.setInitialModel(wrong)
            with self.assertRaisesRegex(TypeError, "initialModel"):
                params.initialModel = wrong
        for wrong in (np.ones((1, 64)), np.ones((64, 1)), np.ones(64), np.ones((8, 7)), np.ones((8, 8, 1))):
            with self.assertRaisesRegex(usac.error, "^covariance: "):
                params.setInitialModel(np.eye(3), wrong)
        with self.assertRaisesRegex(TypeError, "initialCovariance"):
            params.initialCovariance = np.ones((4, 16))
        np.testing.assert_array_equal(params.initialModel, np.eye(3).ravel())
        np.testing.assert_array_equal(params.initialCovariance, np.eye(8).ravel())
        numbers = np.arange(6.)
        for right in (numbers.reshape(2, 3), numbers, numbers[None], numbers[:, None], numbers.tolist()):
            for assign in (params.setInitialModel, lambda value: setattr(params, "initialModel", value)):
                params.setInitialModel(None)
                assign(right)
                np.testing.assert_array_equal(params.initialModel, numbers)
        for right in (np.eye(8), np.eye(8).ravel(), np.eye(8).tolist()):
            params.initialCovariance = right
            np.testing.assert_array_equal(params.initialCovariance, np.eye(8).ravel())

    def test_initial_pose(self):
        params = usac.Params(threshold=THRESHOLD, maxIterations=5)
        model = pose(FEW, params)[0]
        self.assertFalse(model is not None and FEW.errorOf(model) < 5)  # five samples alone do not find the pose
        for begin in (FEW.pose, np.float32(FEW.pose), np.asfortranarray(FEW.pose)):
            params.setInitialModel(begin)
            np.testing.assert_allclose(params.initialModel, FEW.pose.ravel(), rtol=1e-6)
            self.assertLess(FEW.errorOf(pose(FEW, params)[0]), 0.5)
        self.assertIn("initialModel=<12 values>", repr(params))
        params.setInitialModel(np.empty((0, 0)))
        self.assertEqual(len(params.initialModel), 0)

    def test_prior(self):
        params = usac.Params(threshold=THRESHOLD, covariance=1)
        model, _, alone = pose(POSE, params)
        self.assertEqual(alone.priorChance, 0)
        params.setInitialModel(model, alone.covariance)
        self.assertGreater(pose(POSE, params)[2].priorChance, 0.99)
        for wrong in (-alone.covariance, np.eye(5), np.full((6, 6), np.nan)):
            params.setInitialModel(model, wrong)
            with self.assertRaisesRegex(usac.error, "initialCovariance"):
                pose(POSE, params)
        params.setInitialModel(model)
        self.assertEqual(len(params.initialCovariance), 0)
        for wrong in (np.eye(3), np.zeros(5), np.full((3, 4), np.nan)):
            params.initialModel = wrong.ravel()
            with self.assertRaisesRegex(usac.error, "initialModel"):
                pose(POSE, params)
        self.assertRaises((TypeError, usac.error), params.setInitialModel, "text")
        self.assertRaises(TypeError, setattr, params, "initialModel", "text")

    @inTree
    def test_shapes_of_initial_models_of_the_binding(self):
        params = cv._native.usacv20.Params()
        for model, covariance in ((np.ones((3, 2)), None), (np.ones((4, 3)), None), (np.eye(3), np.ones((1, 64)))):
            self.assertRaises(cv.error, params.setInitialModel, model, covariance)


class PoseInputTest(unittest.TestCase):

    def test_arrays(self):
        X, x, K, d = np.rint(POSE.X * 50), np.rint(POSE.x), np.rint(POSE.K), POSE.d
        call = lambda *args: FINDER.solvePnPRansac(*args, flags=usac.USACV20)
        expected = bits(call(X, x, K, d))
        self.assertIs(expected[0], True)
        locked = [array.copy() for array in (X, x, K, d)]
        for array in locked:
            array.setflags(write=False)
        for args in ((np.float32(X), np.float32(x), np.float32(K), d[None]), (np.int16(X), x, np.int32(K), d[:, None]),
                     (X[:, None], x[:, None], np.asfortranarray(K), np.hstack([d, np.zeros(9)])), (X[None], x[None], 2 * K, d),
                     (X.T, x.T, K, np.repeat(d, 2)[::2]), (np.hstack([X, X])[:, 3:], np.repeat(x, 2, axis=0)[::2], K, d), locked):
            self.assertEqual(bits(call(*args)), expected)
            self.assertEqual(bits(usac.estimateAbsolutePose(*args)[:2]), bits(usac.estimateAbsolutePose(X, x, K, d)[:2]))
        self.assertEqual(bits(call(X, x, K, np.zeros(4))), bits(call(X, x, K, None)))
        self.assertNotEqual(bits(call(X, x, K, None)), expected)
        for word, args in (("objectPoints", (X[:, :2], x, K, d)), ("imagePoints", (X, x[:, :1], K, d)),
                           ("distCoeffs", (X, x, K, np.zeros(3))), ("cameraMatrix", (X, x, K.T, d))):
            with self.assertRaisesRegex(usac.error, word):
                call(*args)
        for flag in (-1, 1000, max(FLAGS.values()) + 1):
            with self.assertRaisesRegex(usac.error, "flags"):
                usac.solvePnPRansac(X, x, K, d, flags=flag)

    def test_optional_arguments_and_mask(self):
        X, x, K, d = POSE.X, POSE.x, POSE.K, POSE.d
        expected = bits(pose(POSE, usac.Params())[:2])
        self.assertEqual(bits(usac.estimateAbsolutePose(X, x, K, d)[:2]), expected)
        self.assertEqual(bits(usac.estimateAbsolutePose(objectPoints=X, imagePoints=x, cameraMatrix=K, distCoeffs=d,
                                                        params=usac.Params(), mask=None)[:2]), expected)
        given = np.full((len(X), 1), 7, np.uint8)
        model, mask, report = pose(POSE, usac.Params(), given)
        self.assertEqual((model.shape, model.dtype), ((3, 4), np.float64))
        self.assertEqual(bits(given), bits(mask))
        self.assertEqual(report.inliers, int(mask.sum()))


if __name__ == "__main__":
    unittest.main()
