#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of Params, Report, the enumerations and other objects in Python: fields, construction,
comparison, copies, repr(), that their values reach the estimator and come back; and of errors,
documentation and imports."""

import copy
import enum
import importlib
import inspect
import json
import pickle
import pydoc
import subprocess
import sys
import unittest

import numpy as np

from usac_common import (DISTORTED, ERRORS, FINDER, FLAGS, GENERAL, IN_TREE, PLANE, ErrorCase, bits, cv, estimate, fields,
                         needsCv2, package, usac)
from usac_pose import POSE

native = importlib.import_module(usac.__name__ + "._backend").native
ARRAYS = {"scores", "sigmas", "initialModel", "initialCovariance"}
PRESETS = ("usacV20", "fast", "accurate", "sorted", "trustedScores", "parallel", "automatic", "ransac", "msac", "lmeds", "mlesac", "prosac",
           "loRansac", "floRansac", "gcRansac", "usac2013", "paper", "magsac", "magsacPlusPlus")


class FieldsTest(ErrorCase):

    def test_names_and_defaults_are_those_of_cpp(self):
        default = native.Params()
        names = {name for name in dir(default) if name[0] != "_" and not callable(getattr(default, name))}
        self.assertEqual(set(fields(usac.Params())), names)
        self.assertEqual(set(inspect.signature(usac.Params).parameters), names)
        for name in names - ARRAYS:
            self.assertEqual(getattr(usac.Params(), name), getattr(default, name), name)

    def test_can_be_read_and_written(self):
        params = usac.Params()
        for name in set(fields(params)) - ARRAYS:
            value = getattr(params, name) + (0.25 if isinstance(getattr(params, name), float) else 1)
            setattr(params, name, value)
            self.assertEqual(getattr(params, name), value, name)
            self.assertRaises(TypeError, setattr, params, name, "text")
            self.assertRaises(TypeError, setattr, params, name, None)
            self.assertRaises(AttributeError, delattr, params, name)
            self.assertEqual(getattr(params, name), value, name)
        self.assertRaises(AttributeError, setattr, params, "treshold", 1.0)

    def test_construction_by_names(self):
        params = usac.Params(threshold=2, scores=[3, 1, 2], quality=usac.QUALITY_LMEDS, seed=np.int64(7), confidence=np.float32(0.5))
        self.assertEqual((params.threshold, params.quality, params.seed, params.confidence), (2.0, usac.QUALITY_LMEDS, 7, 0.5))
        self.assertIsInstance(params.threshold, float)
        for wrong in (dict(threshold="2"), dict(seed=1.5), dict(seed=True), dict(quality="QUALITY_BEST"),
                      dict(threshold=[1, 2]), dict(scores="abc"), dict(scores=np.zeros((3, 2))), dict(scores=[1j]),
                      dict(scores=5), dict(initialModel="abc"), dict(scores=[[1], [2, 3]])):
            self.refused(TypeError, list(wrong), usac.Params, **wrong)
        self.assertEqual(usac.Params(threshold=None, scores=None), usac.Params())
        self.refused(usac.error, ("seed",), usac.Params, seed=2**31)
        self.assertRaises(usac.error, usac.Params.fromMethod, "text")
        self.assertRaises(usac.error, usac.Params().check, "text")

    def test_names_of_enumerators(self):
        params = usac.Params(sampler="prosac", ordering="input-order", quality="QUALITY_MAGSAC", localOptimization="none",
                             termination="sprt|standard", degeneracy="repeated", thresholdType="estimated")
        self.assertEqual(params, usac.Params(sampler=usac.SAMPLER_PROSAC, ordering=usac.ORDERING_INPUT_ORDER,
                                             quality=usac.QUALITY_MAGSAC, localOptimization=usac.LOCAL_OPTIMIZATION_NONE,
                                             termination=usac.TERMINATION_SPRT | usac.TERMINATION_STANDARD,
                                             degeneracy=usac.DEGENERACY_REPEATED, thresholdType=usac.THRESHOLD_ESTIMATED))
        self.assertIs(params.sampler, usac.SAMPLER_PROSAC)
        self.assertEqual(usac.Params(quality="magsac++").quality, usac.QUALITY_MAGSAC_PLUS_PLUS)
        params.sampler = "p_napsac"
        self.assertEqual(params.sampler, usac.SAMPLER_P_NAPSAC)
        self.refused(TypeError, ("sampler", "SAMPLER_PROSAC", "SAMPLER_IMPORTANCE", "'prosak'"), usac.Params, sampler="prosak")
        self.refused(TypeError, ("termination", "TERMINATION_SPRT"), usac.Params, termination="sprt|never")
        self.refused(TypeError, ("quality", "''"), usac.Params, quality="")
        self.refused(TypeError, ("quality", "msac|magsac"), usac.Params, quality="msac|magsac")

    def test_enumerators_of_another_enumeration(self):
        self.refused(TypeError, ("sampler", "SamplerType", "QUALITY_MSAC"), usac.Params, sampler=usac.QUALITY_MSAC)
        self.refused(TypeError, ("termination", "DEGENERACY"), usac.Params, termination=usac.DEGENERACY_REPEATED)
        self.refused(TypeError, ("quality",), setattr, usac.Params(), "quality", usac.USACV20)
        self.refused(ERRORS, ("method", "QUALITY_MSAC"), usac.findHomography, PLANE.points1, PLANE.points2, usac.QUALITY_MSAC)
        self.assertEqual(usac.Params(sampler=1).sampler, usac.SAMPLER_PROSAC)

    def test_presets(self):
        for name in PRESETS:
            preset = getattr(usac.Params, name)
            params, expected = preset(threshold=2, scores=[1, 2], seed=None), preset()
            expected.threshold, expected.scores = 2.0, [1, 2]
            self.assertEqual(params, expected, name)
            params.check(2)
            self.assertEqual(getattr(usac.Params(), name)(), preset())
            self.refused(TypeError, (name, "treshold"), preset, treshold=2)
        self.assertRaises(usac.error, usac.Params.trustedScores().check)  # it needs scores or ORDERING_INPUT_ORDER
        presets = {"USACV20": "usacV20", "USACV20_FAST": "fast", "USACV20_ACCURATE": "accurate", "USACV20_PROSAC": "sorted",
                   "USACV20_MAGSAC": "magsacPlusPlus", "USACV20_PARALLEL": "parallel", "USACV20_AUTO": "automatic"}
        for flag, preset in presets.items():
            self.assertEqual(usac.Params.fromMethod(FLAGS[flag], threshold=2), getattr(usac.Params, preset)(threshold=2))
        self.assertEqual(len({repr(usac.Params.fromMethod(flag)) for flag in FLAGS.values()}), len(FLAGS))
        self.assertEqual(usac.Params.usacV20(), usac.Params())
        self.assertIs(usac.Params.automatic().thresholdType, usac.THRESHOLD_ESTIMATED)

    def test_replace(self):
        params = usac.Params.fast(scores=[3, 1])
        other = params.replace(threshold=3, quality="magsac")
        self.assertEqual((params.threshold, other.threshold, other.quality), (1.5, 3.0, usac.QUALITY_MAGSAC))
        self.assertEqual(other.replace(threshold=1.5, quality=params.quality), params)
        other.scores[0] = 7
        self.assertEqual(params.scores[0], 3)
        self.assertEqual(len(params.replace(scores=None).scores), 0)

    def test_fields_that_are_none(self):
        for call, name, hint in ((usac.Params.fast, "treshold", "threshold"), (usac.Params().replace, "maxIters", "maxIterations"),
                                 (usac.Params.accurate, "ransacReprojThreshold", "threshold"), (usac.Params.fast, "xyz", "help")):
            with self.assertRaisesRegex(TypeError, "'{}'.*{}".format(name, hint)):
                call(**{name: 2})

    def test_comparison(self):
        self.assertEqual(usac.Params(), usac.Params())
        self.assertFalse(usac.Params() != usac.Params())
        for name in fields(usac.Params()):
            value = getattr(usac.Params(), name)
            other = usac.Params(**{name: [1.0] if isinstance(value, np.ndarray) else value + 1})
            self.assertNotEqual(other, usac.Params(), name)
            self.assertNotEqual(repr(other), repr(usac.Params()), name)
        self.assertEqual(usac.Params(scores=[np.nan]), usac.Params(scores=[np.nan]))
        self.assertNotEqual(usac.Params(), 5)
        self.assertRaises(TypeError, hash, usac.Params())

    def test_copies(self):
        params = usac.Params(threshold=2, scores=[1, 2, 3], termination=0, initialModel=np.eye(3), quality=99)
        for method in (copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value)),
                       lambda value: pickle.loads(pickle.dumps(value, 2))):
            other = method(params)
            self.assertEqual(other, params)
            other.scores[0], other.threshold = 9, 5
            self.assertEqual((params.scores[0], params.threshold), (1, 2))

    def test_repr(self):
        self.assertEqual(repr(usac.Params()), "Params()")
        params = usac.Params(threshold=2, scores=[1, 2], quality=usac.QUALITY_INLIERS, degeneracy=0,
                             termination=usac.TERMINATION_SPRT | usac.TERMINATION_EXACT)
        self.assertEqual(repr(params), "Params(threshold=2.0, scores=<2 values>, quality=QUALITY_INLIERS, "
                         "termination=TERMINATION_SPRT|TERMINATION_EXACT, degeneracy=0)")
        self.assertEqual(eval(repr(usac.Params(seed=3, polishing=usac.POLISHING_NONE)), vars(usac)),
                         usac.Params(seed=3, polishing=0))

    def test_subclass(self):
        class Strict(usac.Params):
            pass
        self.assertIsInstance(Strict.magsac(), Strict)
        self.assertIsInstance(copy.copy(Strict(threshold=3)), Strict)
        self.assertEqual(bits(usac.findHomography(PLANE.points1, PLANE.points2, Strict(threshold=3))),
                         bits(usac.findHomography(PLANE.points1, PLANE.points2, usac.Params(threshold=3))))

    def test_check_names_the_field(self):
        usac.Params().check(10)
        for name, wrong in (("threshold", float("nan")), ("confidence", 1.0), ("maxIterations", 0), ("sampler", 99)):
            params = usac.Params(**{name: wrong})
            for function, args in ((params.check, ()), (FINDER.findHomography, (PLANE.points1, PLANE.points2, params)),
                                   (usac.estimateHomography, (PLANE.points1, PLANE.points2, params))):
                self.refused(usac.error, (name,), function, *args)


class ArraysTest(ErrorCase):

    def test_scores_live_in_the_object(self):
        params = usac.Params()
        for scores in ([1, 2, 3], (1., 2., 3.), np.array([1, 2, 3]), np.array([[1], [2], [3]]), np.array([[1, 2, 3]], np.uint8),
                       np.array([1., 2., 3.], ">f8"), np.array([1, 0, 2, 0, 3, 0])[::2], np.float16([1, 2, 3]),
                       np.array([[[1]], [[2]], [[3]]]), range(1, 4)):
            params.scores = scores
            self.assertEqual((params.scores.dtype, params.scores.shape), (np.float32, (3,)))
            np.testing.assert_array_equal(params.scores, [1, 2, 3])
        given = np.float32([1, 2, 3])
        params.scores = given
        params.scores[0] = 5
        self.assertEqual(params.scores.tolist(), [5, 2, 3])
        self.assertEqual(given.tolist(), [1, 2, 3])
        for none in (None, [], np.zeros((0, 1)), np.zeros(0, np.float32)):
            params.scores = none
            self.assertEqual(params.scores.shape, (0,))
        params.check(300)

    def test_scores_reach_the_estimator(self):
        good = PLANE.inliers.astype(np.float32)
        run = lambda params: bits(FINDER.findHomography(PLANE.points1, PLANE.points2, params))
        params = usac.Params(scores=good, scoreOrder=usac.SCORES_HIGHER_IS_BETTER)
        higher = run(params)
        params.scoreOrder, params.scores = usac.SCORES_LOWER_IS_BETTER, -good
        self.assertEqual(run(params), higher)
        params.scores[:] = good
        run(params)
        params.scores *= -1  # a change of the array counts in the next call
        self.assertEqual(run(params), higher)
        params.scores = None
        self.assertEqual(run(params), run(usac.Params()))
        for wrong in (good[1:], np.full(len(good), np.nan)):
            params.scores = wrong
            self.refused(usac.error, ("scores",), run, params)
        self.refused(TypeError, ("scores", "bool", "True"), usac.Params, scores=PLANE.inliers)
        self.refused(ERRORS, ("scores", "mask"), usac.Params, scores=np.ma.masked_array([1.0, 2.0], mask=[True, False]))

    def test_sigmas(self):
        count = len(PLANE.points1)
        angles = np.arange(count)
        ones = np.array([np.cos(angles), np.sin(angles)]).T
        covariances = np.eye(2) + 8 * ones[:, :, None] * ones[:, None, :]
        triangles = covariances[:, [0, 0, 1], [0, 1, 1]]
        numbers = np.where(angles % 2, 4, 1)
        for sigmas, of in ((triangles, covariances), (np.hstack([triangles, np.zeros((count, 3))]), covariances),
                           (numbers, np.eye(2) * numbers[:, None, None]**2)):
            params = usac.Params(threshold=3, sigmas=sigmas)
            model, mask, report = usac.estimateHomography(PLANE.points1, PLANE.points2, params)
            mapped = np.c_[PLANE.points1, np.ones(count)] @ model.T
            off = mapped[:, :2] / mapped[:, 2:] - PLANE.points2
            np.testing.assert_array_equal(mask.ravel() != 0, np.sqrt(np.einsum("ni,nij,nj->n", off, np.linalg.inv(of), off)) <= 3)
        for wrong in (np.ones((count, 2)), np.ones((count, 3, 1))):
            self.refused(TypeError, ("sigmas",), usac.Params, sigmas=wrong)
        for wrong in (np.ones((count, 3)), np.ones((count - 1, 3)), [1], np.zeros(count)):
            params.sigmas = wrong
            self.refused(usac.error, ("sigmas",), usac.estimateHomography, PLANE.points1, PLANE.points2, params)

    def test_sigmas_for_another_number_of_matches(self):
        # Without their shape, these sigmas would fit the wrong count, too: 60 numbers, for example, are one
        # for each of 60 matches or three for each of 20.
        rows3, rows6 = np.tile([4., 1, 3], (20, 1)), np.tile([4., 1, 3, 2, 0, 2], (30, 1))
        for sigmas, count in ((rows3, 60), (rows6, 60), (rows3.reshape(60, 1), 20)):
            for params in (usac.Params(sigmas=sigmas), usac.Params().replace(sigmas=sigmas), usac.Params(sigmas=sigmas).replace(),
                           copy.copy(usac.Params(sigmas=sigmas)), pickle.loads(pickle.dumps(usac.Params(sigmas=sigmas)))):
                self.refused(usac.error, ("sigmas",), params.check, count)
            a, b, pose = PLANE.points1[:count], PLANE.points2[:count], (POSE.X[:count], POSE.x[:count], POSE.K, POSE.d)
            for call in (lambda: usac.estimateHomography(a, b, params), lambda: FINDER.findHomography(a.T, b.T, params),
                         lambda: usac.estimateRelativePose(a, b, PLANE.K1, params=params),
                         lambda: usac.fitModel(usac.HOMOGRAPHY, a, b, params=params),
                         lambda: usac.refineModel("HOMOGRAPHY", np.eye(3), a, b, params=params),
                         lambda: usac.modelErrors("HOMOGRAPHY", np.eye(3), a[:, None], b[None], params=params),
                         lambda: usac.estimateAbsolutePose(*pose, params), lambda: FINDER.solvePnPRansac(*pose, params=params)):
                self.refused(usac.error, ("sigmas",), call)
        for sigmas, count in ((rows3, 20), (rows6, 30), (np.ones((60, 1)), 60), (np.ones((1, 60)), 60), ([[1, 0, 1]], 1),
                              ([[1, 2, 1]], 3), (rows3.ravel(), 20), (rows6.ravel(), 30), (rows3, -1), (None, 60)):
            params = usac.Params(sigmas=sigmas)
            params.check(count)
            params.replace().check(count)
            params.replace(sigmas=params.sigmas).check(count)


class ReportTest(unittest.TestCase):

    def test_object(self):
        for problem, scene in (("Homography", PLANE), ("Fundamental", GENERAL), ("Essential", DISTORTED)):
            model, mask, report = estimate(problem, scene, usac.Params())
            self.assertLess(scene.error(problem, model), 1.0)
            self.assertIsInstance(report, usac.Report)
            self.assertEqual((report.inliers, report.inlierRatio), (int(mask.sum()), mask.mean()))
            self.assertTrue(report.iterations > 0 and report.models > 0 and 0 < report.cost < 1 and report.searchMs >= 0)
            self.assertIsInstance(report.stop, usac.StopReason)
            self.assertIsInstance(report.degenerate, bool)
            self.assertIs(report.wideThreshold, False)
            self.assertEqual(len(set(report.sample)), {"Homography": 4, "Fundamental": 7, "Essential": 5}[problem])
            self.assertGreater(len(report.describe()), 10)
            self.assertTrue(repr(report).startswith("Report("))
            for name in fields(report):
                self.assertIn(name + "=", repr(report))
            values = report.asDict()
            self.assertEqual((values["inliers"], values["stop"]), (report.inliers, report.stop.name))
            self.assertEqual(json.loads(json.dumps(values))["iterations"], report.iterations)
            self.assertEqual(copy.deepcopy(report), report)
            self.assertEqual(pickle.loads(pickle.dumps(report)), report)
            self.assertEqual(pickle.loads(pickle.dumps(report)).describe(), report.describe())
            self.assertNotEqual(report, usac.Report())
            self.assertRaises(AttributeError, setattr, report, "inliers", 3)
        default = native.Report()
        names = {name for name in dir(default) if name[0] != "_" and not callable(getattr(default, name))}
        self.assertEqual(set(fields(report)), names)
        self.assertEqual(usac.Report().stop, usac.STOP_NOT_RUN)

    def test_estimated_threshold(self):
        a, b = PLANE.points1, PLANE.points2
        result = FINDER.findHomography(a, b, usac.USACV20_AUTO, 10.0)
        params = usac.Params.automatic(threshold=10, confidence=0.995, maxIterations=2000)
        *expected, report = usac.estimateHomography(a, b, params)
        self.assertEqual(bits(result), bits(expected))
        self.assertTrue(0 < 1.5 * report.sigma < report.threshold < 5, report)
        report = usac.estimateHomography(a, b, usac.Params(threshold=10))[2]
        self.assertEqual((report.threshold, report.sigma), (10, 0))


class EnumerationTest(unittest.TestCase):

    def test_constants(self):
        classes = [value for value in vars(usac).values() if isinstance(value, type) and issubclass(value, (enum.IntEnum, enum.IntFlag))]
        members = {name: int(value) for type_ in classes for name, value in type_.__members__.items()}
        self.assertEqual(len(classes), 16)
        for name, value in members.items():
            self.assertEqual(getattr(usac, name), value)
            self.assertEqual(getattr(usac, name).name, name)
        if IN_TREE:
            self.assertEqual(members, native.enumerators())

    def test_are_integers(self):
        self.assertIsInstance(usac.QUALITY_MSAC, int)
        self.assertEqual(usac.Params().quality, 1)
        self.assertIs(usac.Params().quality, usac.QualityType.QUALITY_MSAC)
        both = usac.TERMINATION_SPRT | usac.TERMINATION_EXACT
        self.assertIsInstance(both, usac.TerminationFlags)
        self.assertEqual(usac.Params(termination=both).termination, both)
        self.assertEqual(pickle.loads(pickle.dumps(usac.USACV20_FAST)), usac.USACV20_FAST)


@package
class CopyTest(unittest.TestCase):
    """Objects with a state of the compiled part that cannot be copied."""

    def test_refused(self):
        usac_ = usac.Usac.create(usac.HOMOGRAPHY, PLANE.points1, PLANE.points2)
        with usac.progress(lambda report: True) as progress:
            for value in (usac.Rng(1), usac_, usac_.components, usac_._usac, progress._native, native.Params(), native.Report()):
                for copied in [copy.copy, copy.deepcopy] + [lambda v, k=k: pickle.dumps(v, k) for k in range(pickle.HIGHEST_PROTOCOL + 1)]:
                    with self.assertRaisesRegex(TypeError, type(value).__name__ + ".* copied or pickled"):
                        copied(value)


class TextTest(unittest.TestCase):

    def test_everything_has_a_text(self):
        for name in usac.__all__:
            value = getattr(usac, name)
            if inspect.isclass(value) or inspect.isfunction(value):
                self.assertGreater(len(inspect.getdoc(value) or ""), 20, name)
        for type_ in (usac.Params, usac.Report):
            text = " ".join(pydoc.render_doc(type_, renderer=pydoc.plaintext).split())
            for name in fields(type_()):
                self.assertIn(" ".join(inspect.getdoc(getattr(type_, name)).split())[:30], text)

    def test_all(self):
        found = {}
        exec("from {} import *".format(usac.__name__), found)
        self.assertLessEqual(set(usac.__all__), set(found) & set(dir(usac)))
        self.assertRaises(AttributeError, getattr, usac, "nonsense")

    def test_errors(self):
        with self.assertRaises(usac.error) as context:
            usac.findHomography(PLANE.points1, PLANE.points2, usac.USACV20, -1.0)
        self.assertIn("ransacReprojThreshold", str(context.exception))
        self.assertEqual(context.exception.code, -211)
        self.assertIn("ransacReprojThreshold", context.exception.err)
        self.assertGreater(context.exception.line, 0)
        if cv is not None:
            self.assertTrue(issubclass(usac.error, cv.error))
        self.assertTrue(not IN_TREE or usac.error is cv.error)
        self.assertIs(usac.error, usac.error)


@package
class ImportTest(unittest.TestCase):

    def run_python(self, code, *options):
        run = subprocess.run([sys.executable, *options, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual((run.stdout, run.returncode), (b"", 0), code)

    def test_needs_numpy_only(self):
        self.run_python("""import sys
sys.modules['cv2'] = None
import usacv20, numpy
assert usacv20.error.__mro__[1:] == Exception.__mro__
assert usacv20.findHomography(numpy.eye(3, 2), numpy.eye(3, 2))[0] is None
try: usacv20.findHomography(1, 2)
except usacv20.error as failure: assert 'srcPoints' in str(failure)
try: usacv20.patch_cv2()
except ImportError: pass
else: raise SystemExit('no ImportError')""")

    @needsCv2
    def test_does_not_import_cv2(self):
        self.run_python("""import sys, usacv20
assert 'cv2' not in sys.modules
usacv20.error
import cv2
assert issubclass(usacv20.error, cv2.error) and usacv20.error is not cv2.error
assert not hasattr(cv2.findHomography, '__wrapped__')""")


if __name__ == "__main__":
    unittest.main()
