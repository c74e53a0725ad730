#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of Params, Report and the enumerations as Python objects: construction, comparison, copies,
repr() and documentation."""

import copy
import enum
import importlib
import inspect
import os
import pickle
import pydoc
import subprocess
import sys
import unittest

import numpy as np

from usac_common import IN_TREE, PLANE, THRESHOLD, bits, cv, fields, inTree, needsCv2, package, usac

native = importlib.import_module(usac.__name__ + "._backend").native


class EnumerationTest(unittest.TestCase):

    def classes(self):
        return [value for value in vars(usac).values() if isinstance(value, type) and issubclass(value, enum.IntEnum)
                or isinstance(value, type) and issubclass(value, enum.IntFlag)]

    def members(self):
        return {name: int(value) for type_ in self.classes() for name, value in type_.__members__.items()}

    @inTree
    def test_names_and_values_are_those_of_the_generator(self):
        self.assertEqual(self.members(), native.enumerators())

    def test_what_is_written_by_a_script_is_up_to_date(self):
        script = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "make_names.py")
        if not os.path.exists(os.path.join(os.path.dirname(script), "..", "..", "src")):
            self.skipTest("the sources are not here")
        run = subprocess.run([sys.executable, script, "--check"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             universal_newlines=True)
        self.assertEqual((run.returncode, run.stdout), (0, ""))

    def test_constants(self):
        self.assertEqual(len(self.classes()), 16)
        for name, value in self.members().items():
            self.assertEqual(getattr(usac, name), value)
            self.assertEqual(getattr(usac, name).name, name)

    def test_are_integers(self):
        self.assertIsInstance(usac.QUALITY_MSAC, int)
        self.assertEqual(usac.Params().quality, 1)
        self.assertIs(usac.Params().quality, usac.QualityType.QUALITY_MSAC)
        both = usac.TERMINATION_SPRT | usac.TERMINATION_EXACT
        self.assertIsInstance(both, usac.TerminationFlags)
        self.assertEqual(usac.Params(termination=both).termination, both)
        self.assertEqual(pickle.loads(pickle.dumps(usac.USACV20_FAST)), usac.USACV20_FAST)


class ParamsTest(unittest.TestCase):

    def test_names_and_defaults_are_those_of_cpp(self):
        default = native.Params()
        names = {name for name in dir(default) if name[0] != "_" and not callable(getattr(default, name))}
        self.assertEqual(set(fields(usac.Params())), names)
        for name in names - {"scores", "sigmas", "initialModel", "initialCovariance"}:
            self.assertEqual(getattr(usac.Params(), name), getattr(default, name), name)

    def test_construction_by_names(self):
        params = usac.Params(threshold=2, scores=[3, 1, 2], quality=usac.QUALITY_LMEDS, seed=np.int64(7), confidence=np.float32(0.5))
        self.assertEqual((params.threshold, params.quality, params.seed, params.confidence), (2.0, usac.QUALITY_LMEDS, 7, 0.5))
        self.assertIsInstance(params.threshold, float)
        np.testing.assert_array_equal(params.scores, np.float32([3, 1, 2]))
        for wrong in (dict(threshold="2"), dict(seed=1.5), dict(seed=True), dict(quality="QUALITY_BEST"),
                      dict(threshold=[1, 2]), dict(scores="abc"), dict(scores=np.zeros((3, 2))), dict(scores=[1j]),
                      dict(scores=5), dict(initialModel="abc"), dict(scores=[[1], [2, 3]])):
            with self.assertRaisesRegex(TypeError, list(wrong)[0]):
                usac.Params(**wrong)
        self.assertEqual(usac.Params(threshold=None, scores=None), usac.Params())
        self.assertRaises(TypeError, setattr, params, "threshold", None)
        self.assertEqual(set(inspect.signature(usac.Params).parameters), set(fields(params)))
        with self.assertRaisesRegex(usac.error, "seed"):
            usac.Params(seed=2**31)
        for name, method in (("threshold", usac.Params.fromMethod), ("check", usac.Params().check)):
            self.assertRaises(usac.error, method, "text")

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

    def test_changed_scores_count(self):
        good = PLANE.inliers.astype(np.float32)
        params = usac.Params(threshold=THRESHOLD, scores=-good)
        expected = bits(usac.findHomography(PLANE.points1, PLANE.points2, params))
        params.scores[:] = good
        usac.findHomography(PLANE.points1, PLANE.points2, params)
        params.scores *= -1
        self.assertEqual(bits(usac.findHomography(PLANE.points1, PLANE.points2, params)), expected)
        params.scores = None
        self.assertEqual(bits(usac.findHomography(PLANE.points1, PLANE.points2, params)),
                         bits(usac.findHomography(PLANE.points1, PLANE.points2, usac.Params(threshold=THRESHOLD))))

    def test_nan_is_the_worst_score(self):
        good = np.where(PLANE.inliers, 0, 1).astype(np.float32)
        worst, nan = good.copy(), good.copy()
        worst[good == 1], nan[good == 1] = np.finfo(np.float32).max, np.nan
        run = lambda scores, **more: bits(usac.estimateHomography(PLANE.points1, PLANE.points2, usac.Params(scores=scores, **more))[:2])
        self.assertEqual(run(nan), run(worst))
        with self.assertRaisesRegex(usac.error, "scores"):
            run(nan, sampler=usac.SAMPLER_IMPORTANCE, scoreOrder=usac.SCORES_HIGHER_IS_BETTER)
        self.assertEqual(usac.Params(scores=nan), usac.Params(scores=nan))

    def test_comparison(self):
        self.assertEqual(usac.Params(), usac.Params())
        self.assertEqual(usac.Params(), usac.Params.usacV20())
        self.assertFalse(usac.Params() != usac.Params())
        for name in fields(usac.Params()):
            value = getattr(usac.Params(), name)
            other = usac.Params(**{name: [1.0] if isinstance(value, np.ndarray) else value + 1})
            self.assertNotEqual(other, usac.Params(), name)
            self.assertNotEqual(repr(other), repr(usac.Params()), name)
        self.assertNotEqual(usac.Params(), 5)
        self.assertRaises(TypeError, hash, usac.Params())

    def test_copies(self):
        params = usac.Params(threshold=2, scores=[1, 2, 3], termination=0, initialModel=np.eye(3), quality=99)
        for method in (copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value)),
                       lambda value: pickle.loads(pickle.dumps(value, 2)), lambda value: copy.deepcopy([value])[0]):
            other = method(params)
            self.assertIsInstance(other, usac.Params)
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


class ReportTest(unittest.TestCase):

    def test_object(self):
        report = usac.estimateHomography(PLANE.points1, PLANE.points2)[2]
        self.assertIsInstance(report.stop, usac.StopReason)
        self.assertIn("stop=STOP_", repr(report))
        self.assertTrue(repr(report).startswith("Report("))
        self.assertEqual(pickle.loads(pickle.dumps(report)), report)
        self.assertEqual(copy.deepcopy(report), report)
        self.assertNotEqual(report, usac.Report())
        self.assertEqual(pickle.loads(pickle.dumps(report)).describe(), report.describe())
        self.assertRaises(AttributeError, setattr, report, "inliers", 3)
        default = native.Report()
        names = {name for name in dir(default) if name[0] != "_" and not callable(getattr(default, name))}
        self.assertEqual(set(fields(report)), names)


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
            text = pydoc.render_doc(type_, renderer=pydoc.plaintext)
            for name in fields(type_()):
                self.assertIn(" {}\n".format(name), text)
                self.assertGreater(len(inspect.getdoc(getattr(type_, name))), 15, name)
                self.assertIn(" ".join(inspect.getdoc(getattr(type_, name)).split())[:30], " ".join(text.split()))
        for field in fields(usac.Params()):
            self.assertIn("Default", inspect.getdoc(getattr(usac.Params, field)))

    def test_all(self):
        found = {}
        exec("from {} import *".format(usac.__name__), found)
        self.assertLessEqual(set(usac.__all__), set(found))
        self.assertLessEqual(set(usac.__all__), set(dir(usac)))
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


@inTree
class InTreeTest(unittest.TestCase):

    def test_error_is_that_of_cv2(self):
        self.assertIs(usac.error, cv.error)
        self.assertTrue(IN_TREE)


class AnyProblemTest(unittest.TestCase):
    """estimateModel(problem, ...) must return the same result as the function for this problem, for
    example estimateHomography."""

    def test_same_as_the_function(self):
        s = PLANE
        for problem, function in (("homography", usac.estimateHomography), (usac.AFFINITY, usac.estimateAffinity2D),
                                  (usac.ProblemType.FUNDAMENTAL, usac.estimateFundamental)):
            params = usac.Params(threshold=2, seed=3)
            own = usac.estimateModel(problem, s.points1, s.points2, params)
            other = function(s.points1, s.points2, params)
            self.assertEqual(bits(own[:2]), bits(other[:2]), problem)
        self.assertEqual(bits(usac.estimateModel(usac.ESSENTIAL, s.points1, s.points2, None, None, s.K1)[:2]),
                         bits(usac.estimateEssential(s.points1, s.points2, s.K1)[:2]))

    def test_mistakes(self):
        with self.assertRaises(usac.error) as raised:
            usac.estimateModel("plane", PLANE.points1, PLANE.points2)
        self.assertIn("problem", str(raised.exception))
        with self.assertRaises(usac.error) as raised:
            usac.estimateModel(usac.ESSENTIAL, PLANE.points1, PLANE.points2)
        self.assertIn("cameraMatrix1", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
