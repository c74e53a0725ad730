#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of Params, Report and the estimate functions in Python."""

import copy
import pickle
import threading
import unittest

import numpy as np

from usac_common import (DISTORTED, FINDER, FLAGS, GENERAL, PLANE, RANSAC, THRESHOLD, bits, cv, estimate, fields,
                         paramsForms, usac, values)
from usac_pose import POSE


class ParamsTest(unittest.TestCase):

    def test_fields_can_be_read_and_written(self):
        params = usac.Params()
        self.assertLessEqual({"threshold", "confidence", "maxIterations", "seed", "threads", "sampler", "ordering", "scores",
                              "scoreOrder", "quality", "verification", "localOptimization", "termination", "persistence",
                              "degeneracy", "polishing", "polishingSteps", "runnersUp", "orderedEvery", "widestReach",
                              "significance", "covariance", "sigmas", "initialModel", "initialCovariance"}, set(fields(params)))
        for name in fields(params):
            if name in ("scores", "sigmas", "initialModel", "initialCovariance"):
                continue
            value = getattr(params, name) + (0.25 if isinstance(getattr(params, name), float) else 1)
            setattr(params, name, value)
            self.assertEqual(getattr(params, name), value, name)
            self.assertRaises(TypeError, setattr, params, name, "text")
            self.assertRaises(AttributeError, delattr, params, name)
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
            self.assertRaises((TypeError, usac.error), setattr, params, "scores", wrong)

    def test_sigmas(self):
        params = usac.Params(threshold=3, sigmas=np.where(np.arange(len(PLANE.points1)) % 2, 4, 1))
        model, mask, report = usac.estimateHomography(PLANE.points1, PLANE.points2, params)
        mapped = np.c_[PLANE.points1, np.ones(len(PLANE.points1))] @ model.T
        errors = np.linalg.norm(mapped[:, :2] / mapped[:, 2:] - PLANE.points2, axis=1) / params.sigmas
        np.testing.assert_array_equal(mask.ravel() != 0, errors <= 3)
        self.assertEqual(report.threshold, 3)
        for wrong in ([1], np.zeros(len(PLANE.points1))):
            params.sigmas = wrong
            with self.assertRaisesRegex(usac.error, "sigmas"):
                usac.estimateHomography(PLANE.points1, PLANE.points2, params)

    def test_covariances_of_points(self):
        count = len(PLANE.points1)
        angles = np.arange(count)
        ones = np.array([np.cos(angles), np.sin(angles)]).T
        covariances = np.eye(2) + 8 * ones[:, :, None] * ones[:, None, :]
        triangles = covariances[:, [0, 0, 1], [0, 1, 1]]
        params = usac.Params(threshold=3, sigmas=triangles)
        self.assertEqual(params.sigmas.shape, (3 * count,))
        model, mask, _ = usac.estimateHomography(PLANE.points1, PLANE.points2, params)
        mapped = np.c_[PLANE.points1, np.ones(count)] @ model.T
        off = mapped[:, :2] / mapped[:, 2:] - PLANE.points2
        errors = np.sqrt(np.einsum("ni,nij,nj->n", off, np.linalg.inv(covariances), off))
        np.testing.assert_array_equal(mask.ravel() != 0, errors <= 3)
        self.assertGreater(mask.sum(), 0)
        both = usac.Params(threshold=3, sigmas=np.hstack([triangles, np.zeros((count, 3))]))
        np.testing.assert_array_equal(usac.estimateHomography(PLANE.points1, PLANE.points2, both)[0], model)
        for wrong in (np.ones((count, 2)), np.ones((count, 3, 1))):
            with self.assertRaisesRegex(TypeError, "sigmas"):
                params.sigmas = wrong
        for wrong in (np.ones((count, 3)), np.ones((count - 1, 3))):
            params.sigmas = wrong
            with self.assertRaisesRegex(usac.error, "sigmas"):
                usac.estimateHomography(PLANE.points1, PLANE.points2, params)

    def test_sigmas_for_another_number_of_matches(self):
        # Without their shape, these sigmas would fit the wrong count, too: 60 numbers, for example, are one
        # for each of 60 matches or three for each of 20.
        rows3, rows6 = np.tile([4., 1, 3], (20, 1)), np.tile([4., 1, 3, 2, 0, 2], (30, 1))
        scene = lambda count: (PLANE.points1[:count], PLANE.points2[:count])
        for sigmas, count in ((rows3, 60), (rows6, 60), (np.ones((20, 3)), 60), (rows3.reshape(60, 1), 20)):
            for params in (usac.Params(sigmas=sigmas), usac.Params().replace(sigmas=sigmas), usac.Params(sigmas=sigmas).replace(),
                           copy.copy(usac.Params(sigmas=sigmas)), pickle.loads(pickle.dumps(usac.Params(sigmas=sigmas)))):
                with self.assertRaisesRegex(usac.error, "sigmas"):
                    params.check(count)
            a, b = scene(count)
            for call in (lambda: usac.estimateHomography(a, b, params), lambda: FINDER.findHomography(a, b, params),
                         lambda: usac.estimateFundamental(a.T, b.T, params),
                         lambda: usac.estimateRelativePose(a, b, PLANE.K1, params=params),
                         lambda: usac.fitModel(usac.HOMOGRAPHY, a, b, params=params),
                         lambda: usac.refineModel("HOMOGRAPHY", np.eye(3), a, b, params=params),
                         lambda: usac.modelErrors("HOMOGRAPHY", np.eye(3), a[:, None], b[None], params=params),
                         lambda: usac.estimateAbsolutePose(POSE.X[:count], POSE.x[:count], POSE.K, POSE.d, params),
                         lambda: FINDER.solvePnPRansac(POSE.X[:count].T, POSE.x[:count], POSE.K, POSE.d, params=params)):
                with self.assertRaisesRegex(usac.error, "sigmas"):
                    call()
        for sigmas, count in ((rows3, 20), (rows6, 30), (np.ones((60, 1)), 60), (np.ones((1, 60)), 60), ([[1, 0, 1]], 1),
                              ([[1, 2, 1]], 3), (rows3.ravel(), 20), (rows6.ravel(), 30), (rows3, -1), (None, 60)):
            params = usac.Params(sigmas=sigmas)
            params.check(count)
            params.replace().check(count)
            params.replace(sigmas=params.sigmas).check(count)
            if count > 10:
                usac.estimateHomography(*scene(count), params)

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
        with self.assertRaises(usac.error) as context:
            FINDER.findHomography(PLANE.points1, PLANE.points2, params)
        self.assertIn("scores", str(context.exception))

    def test_presets(self):
        for name in ("usacV20", "fast", "accurate", "sorted", "parallel", "automatic", "ransac", "msac", "lmeds", "mlesac", "prosac",
                     "loRansac", "floRansac", "gcRansac", "usac2013", "paper", "magsac", "magsacPlusPlus"):
            params = getattr(usac.Params, name)()
            self.assertIsInstance(params, usac.Params)
            params.check()
            self.assertEqual(values(getattr(usac.Params(), name)()), values(params))
        trusted = usac.Params.trustedScores()
        with self.assertRaises(usac.error):
            trusted.check()  # this preset needs scores or ORDERING_INPUT_ORDER, and neither is set
        trusted.scores = [0.5, 0.25]
        trusted.check(2)
        presets = {"USACV20": "usacV20", "USACV20_FAST": "fast", "USACV20_ACCURATE": "accurate", "USACV20_PROSAC": "sorted",
                   "USACV20_MAGSAC": "magsacPlusPlus", "USACV20_PARALLEL": "parallel", "USACV20_AUTO": "automatic"}
        for flag, preset in presets.items():
            self.assertEqual(values(usac.Params.fromMethod(FLAGS[flag])), values(getattr(usac.Params, preset)()))
        self.assertEqual(values(usac.Params.usacV20()), values(usac.Params()))
        self.assertEqual(len({repr(usac.Params.fromMethod(flag)) for flag in FLAGS.values()}), len(FLAGS))
        self.assertEqual(repr(usac.Params()), "Params()")

    def test_check_names_the_field(self):
        usac.Params().check()
        usac.Params().check(10)
        for name, wrong in (("threshold", float("nan")), ("threshold", 0), ("confidence", 1.0), ("confidence", 0.0),
                            ("maxIterations", 0), ("sampler", 99), ("quality", -1), ("threads", -1), ("significance", 1.5),
                            ("significance", float("nan"))):
            params = usac.Params()
            setattr(params, name, wrong)
            for function, args in ((params.check, ()),
                                   (FINDER.findHomography, (PLANE.points1, PLANE.points2, params)),
                                   (usac.estimateHomography, (PLANE.points1, PLANE.points2, params))):
                with self.assertRaises(usac.error) as context:
                    function(*args)
                self.assertIn(name, str(context.exception))

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
            for name in ("rejectedSamples", "degenerateSamples", "rejectedModels", "refusedModels", "droppedModels",
                         "localOptimizations", "localImprovements", "independentInliers", "chance", "threshold",
                         "setupMs", "searchMs", "localMs", "polishMs"):
                self.assertGreaterEqual(getattr(report, name), 0, name)
            self.assertIsInstance(report.degenerate, bool)
            self.assertIs(report.wideThreshold, False)
            self.assertIsInstance(report.describe(), str)
            self.assertGreater(len(report.describe()), 10)
            for name in fields(report):
                self.assertIn(name + "=", repr(report))
        self.assertEqual(usac.Report().stop, usac.STOP_NOT_RUN)

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
        FINDER.findHomography(np.eye(3, 2), np.eye(3, 2), usac.USACV20, 3.0, given)
        self.checkZeroMask(given, 3)

    def test_mistakes_raise(self):
        a, b, K, params = GENERAL.points1, GENERAL.points2, GENERAL.K1, usac.Params()
        for word, function, args in (
                ("points", usac.estimateHomography, (a, b[1:], params)),
                ("points", usac.estimateFundamental, (a, b[1:], params)),
                ("points", usac.estimateEssential, (a, b[1:], K, None, None, None, params)),
                ("Points", FINDER.findHomography, (a, b[1:], usac.USACV20)),
                ("points", usac.estimateHomography, (np.ones((9, 1)), np.ones((9, 1)), params)),
                ("cameraMatrix", usac.estimateEssential, (a, b, np.eye(2), None, None, None, params)),
                ("cameraMatrix", usac.estimateEssential, (a, b, np.zeros((3, 3)), None, None, None, params)),
                ("cameraMatrix", FINDER.findEssentialMat, (a, b, np.eye(2), usac.USACV20)),
                ("hreshold", FINDER.findHomography, (a, b, usac.USACV20, -1.0)),
                ("hreshold", FINDER.findHomography, (a, b, usac.USACV20, float("nan"))),
                ("onfidence", FINDER.findFundamentalMat, (a, b, usac.USACV20, 3.0, 1.5)),
                ("max", FINDER.findEssentialMat, (a, b, K, usac.USACV20, 0.99, 1.0, -5)),
                ("method", usac.Params.fromMethod, (RANSAC,)),
                ("method", usac.findHomography, (a, b, 12345)),
                ("method", usac.findFundamentalMat, (a, b, -1)),
                ("method", usac.findEssentialMat, (a, b, K, max(FLAGS.values()) + 1)),
                ("params", usac.estimateHomography, (a, b, 3.0)),
                ("params", usac.estimateHomography, (a, b, object())),
                ("", usac.estimateHomography, ("a", "b", params)),
                ("", FINDER.findHomography, (a, "b", usac.USACV20))):
            with self.assertRaises(usac.error, msg="{} {}".format(word, args[2:])) as context:
                function(*args)
            self.assertIn(word, str(context.exception))

    def test_is_reproducible(self):
        def run():
            return [bits(estimate(*case)[:2]) for case in (("Homography", PLANE, usac.Params()),
                                                           ("Fundamental", GENERAL, usac.Params()),
                                                           ("Essential", DISTORTED, usac.Params()))]
        expected = run()
        if cv is not None:
            cv.setRNGSeed(99)
            cv.randu(np.zeros((9, 9)), 0, 1)
        usac.findHomography(PLANE.points1, PLANE.points2, RANSAC)
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
        for prefix, count in (("SAMPLER_", 3), ("ORDERING_", 4), ("SCORES_", 2), ("QUALITY_", 2), ("VERIFICATION_", 2),
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
