#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the functions of cv2 with the flags of the module: in a cv2 that was built with the
module, and in any other cv2 after usacv20.patch_cv2()."""

import importlib
import os
import pickle
import subprocess
import sys
import threading
import types
import unittest

import numpy as np

from usac_common import (FLAGS, FUNCTIONS, GENERAL, IN_TREE, LMEDS, NATIVE, PLANE, RANSAC, RHO, SOLVEPNP_EPNP, THRESHOLD, USAC_DEFAULT,
                         USAC_MAGSAC, bits, cv, forms, formsOfOpencv, inTree, needsCv2, outcome, package, paramsForms, usac)
from usac_pose import formsOfPose, paramsFormsOfPose

opencv = importlib.import_module(usac.__name__ + "._opencv")


@needsCv2
class Cv2Test(unittest.TestCase):
    """Base class of tests during which the functions of cv2 accept the module's flags. If the package
    is tested, cv2 is patched for each test."""

    def setUp(self):
        if not IN_TREE:
            self.addCleanup(usac.patch_cv2().undo)


class WrapperTest(Cv2Test):

    def test_is_in_place(self):
        for name in FUNCTIONS:  # also fails if cv2's loader has ignored an ImportError of the package
            self.assertIsNot(getattr(cv, name), getattr(NATIVE, name), name)
            self.assertIs(getattr(cv, name).__wrapped__, getattr(NATIVE, name))
        self.assertTrue(os.path.isfile(usac.__file__))

    def test_keeps_name_and_documentation(self):
        for name in FUNCTIONS:
            self.assertEqual(getattr(cv, name).__name__, name)
            self.assertTrue(getattr(cv, name).__doc__.startswith(getattr(NATIVE, name).__doc__))
            self.assertIn("USACV20", getattr(cv, name).__doc__)
            self.assertIs(pickle.loads(pickle.dumps(getattr(cv, name))), getattr(cv, name))

    def test_gives_what_the_function_of_the_module_gives(self):
        params = usac.Params(threshold=THRESHOLD)
        flag = max(FLAGS.values())
        calls = ([(function, args, kwargs) for _, function, _, args, kwargs in forms(flag) + paramsForms(params)]
                 + [("solvePnPRansac", args, kwargs) for args, kwargs in formsOfPose(flag) + paramsFormsOfPose(params)])
        for function, args, kwargs in calls:
            self.assertEqual(bits(getattr(cv, function)(*args, **kwargs)), bits(getattr(usac, function)(*args, **kwargs)),
                             "{} {} {}".format(function, len(args), sorted(kwargs)))


@inTree
class LoaderTest(unittest.TestCase):

    def test_import_is_silent(self):
        run = subprocess.Popen([sys.executable, "-c", "import cv2; cv2.findHomography.__wrapped__"],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual((run.communicate()[0], run.returncode), (b"", 0))

    def test_package_of_another_build_is_passed_over(self):
        native = importlib.import_module("cv2.usacv20._intree").Native
        self.assertRaises(ImportError, native, types.SimpleNamespace(_native=types.ModuleType("cv2")))

    def test_constants_of_cv2(self):
        names = [name for name in dir(cv._native) if "USACV20" in name]
        self.assertEqual(names, sorted(FLAGS))  # only the plain names, without the name of an enum class as a prefix
        for name, value in FLAGS.items():
            self.assertIs(type(getattr(cv, name)), int)
            self.assertEqual(getattr(cv, name), value)

    def test_is_not_undone(self):
        with usac.patch_cv2():
            pass
        usac.unpatch_cv2()
        self.assertIsNot(cv.findHomography, NATIVE.findHomography)


@package
@needsCv2
class PatchTest(unittest.TestCase):

    def functions(self):
        return {name: getattr(cv, name) for name in FUNCTIONS}

    def original(self):
        return {name: getattr(NATIVE, name) for name in FUNCTIONS}

    def test_is_undone_exactly(self):
        before = dict(vars(cv))
        self.assertEqual(self.functions(), self.original())  # importing the package must not change cv2
        for undo in (lambda patch: patch.undo(), lambda patch: usac.unpatch_cv2(), lambda patch: usac.unpatch_cv2(cv)):
            patch = usac.patch_cv2(cv)
            self.assertEqual(cv.findHomography(PLANE.points1, PLANE.points2, usac.USACV20)[0].shape, (3, 3))
            self.assertFalse(set(self.functions().values()) & set(self.original().values()))
            undo(patch)
            self.assertEqual(vars(cv), before)
            patch.undo()
            usac.unpatch_cv2()
            self.assertEqual(vars(cv), before)

    def test_with_statement(self):
        with self.assertRaises(KeyError), usac.patch_cv2():
            outer = self.functions()
            with usac.patch_cv2():
                self.assertEqual(self.functions(), outer)
            self.assertEqual(self.functions(), outer)
            self.assertIsNot(cv.findHomography, NATIVE.findHomography)
            raise KeyError
        self.assertEqual(self.functions(), self.original())

    def test_beside_another_patch(self):
        patch = usac.patch_cv2()
        ours = cv.findHomography
        cv.findHomography = lambda *args, **kwargs: ours(*args, **kwargs)
        try:
            patch.undo()
            self.assertEqual(cv.findHomography.__name__, "<lambda>")
            self.assertEqual(cv.findFundamentalMat, NATIVE.findFundamentalMat)
            a, b = PLANE.points1, PLANE.points2
            self.assertEqual(bits(cv.findHomography(a, b, RANSAC)), bits(NATIVE.findHomography(a, b, RANSAC)))
            # The call reaches OpenCV's own function, which does not support the flag.
            self.assertRaises(cv.error, cv.findHomography, a, b, usac.USACV20)
        finally:
            cv.findHomography = NATIVE.findHomography

    def test_of_a_module(self):
        other = types.SimpleNamespace(**self.functions())
        with usac.patch_cv2(other):
            self.assertEqual(self.functions(), self.original())
            self.assertEqual(bits(other.findHomography(PLANE.points1, PLANE.points2, usac.USACV20)),
                             bits(usac.findHomography(PLANE.points1, PLANE.points2, usac.USACV20)))
        self.assertEqual(vars(other), self.original())


class LockTest(unittest.TestCase):

    def test_threads(self):
        """Threads that patch and unpatch a module at the same time leave it as it was."""
        def work():
            for _ in range(200):
                usac.patch_cv2(module)
                usac.unpatch_cv2(module)

        functions = {name: lambda: None for name in FUNCTIONS}
        module, interval = types.SimpleNamespace(**functions), sys.getswitchinterval()
        sys.setswitchinterval(1e-5)
        try:
            threads = [threading.Thread(target=work) for _ in range(8)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        finally:
            sys.setswitchinterval(interval)
        usac.unpatch_cv2(module)
        self.assertEqual(vars(module), functions)


class RouteTest(unittest.TestCase):
    """Tests whether a call reaches OpenCV's function ("opencv") or this module's function
    ("usacv20"). Both are replaced by functions that only record the call."""

    def setUp(self):
        self.cv, ours = types.ModuleType("cv2"), types.ModuleType("ours")
        for name in FUNCTIONS:
            self.record(self.cv, name, "opencv")
            self.record(ours, name, "usacv20")
        self.patch = opencv.Patch(self.cv, {name: getattr(ours, name) for name in FUNCTIONS})

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
        for method in (0, RANSAC, LMEDS, RHO, USAC_DEFAULT, USAC_MAGSAC, 0x3fff, max(FLAGS.values()) + 1, -1,
                       2**40, True, None, "RANSAC", 16384.0):
            for function, args, kwargs in self.allForms(method):
                self.check("opencv", function, *args, **kwargs)
        for flag in FLAGS.values():
            for method in (flag, np.int32(flag), np.int64(flag), np.uint16(flag)):
                for function, args, kwargs in self.allForms(method):
                    self.check("usacv20", function, *args, **kwargs)
        for params, route in ((object(), "opencv"), (None, "opencv"), (usac.Params(), "usacv20")):
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
                    ("findHomography", (a, a, RANSAC, n, None, n, 0.99)), ("findHomography", (n, n)),
                    ("findHomography", (a, a, float(n))), ("findHomography", (a, a, np.array([n]))),
                    ("findFundamentalMat", (a, a, RANSAC, n, n, n, None)), ("findEssentialMat", (a, a, K, RANSAC, 0.99, 1., n)),
                    ("findEssentialMat", (a, a, K, None, 0.99, 1., n)), ("findEssentialMat", (a, a, n, pp, RANSAC, 0.99, 1., n)),
                    ("findEssentialMat", (a, a, np.float32(n), pp, RANSAC, n, n, n)), ("findEssentialMat", (a, a, n, pp)),
                    ("findEssentialMat", (a, a, K, None, K, None, RANSAC, 0.99, n)), ("findEssentialMat", (n, a, K)),
                    ("findEssentialMat", (a, a, K, a, K, a, None, n))):
                self.check("opencv", function, *args)
            self.check("opencv", "findHomography", a, a, method=RANSAC, maxIters=n)
            self.check("opencv", "findEssentialMat", a, a, focal=n, pp=pp, method=RANSAC)
            self.check("opencv", "findEssentialMat", a, a, K, method=RANSAC, maxIters=n)
            self.check("usacv20", "findEssentialMat", a, a, n, pp, n)
            self.check("usacv20", "findEssentialMat", a, a, focal=1.0, pp=pp, method=n)
            for function in ("estimateAffine2D", "estimateAffinePartial2D"):
                self.check("opencv", function, a, a, None, RANSAC, n, n, n, n)
                self.check("opencv", function, a, a, n, LMEDS)
                self.check("opencv", function, n, n, maxIters=n)
                self.check("usacv20", function, a, a, None, n)
            self.check("opencv", "solvePnPRansac", a, a, K, None, n, n, n, n, n, n, n)
            self.check("opencv", "solvePnPRansac", a, a, K, None, None, None, n, iterationsCount=n, flags=SOLVEPNP_EPNP)
            self.check("usacv20", "solvePnPRansac", a, a, K, None, None, None, True, 9, 8., 0.9, None, n)


class UnchangedTest(Cv2Test):
    """Calls without a flag or Params of this module must give exactly the same results as OpenCV's
    own function."""

    def compare(self, function, args, kwargs):
        expected = outcome(getattr(NATIVE, function), args, kwargs)
        self.assertEqual(outcome(getattr(cv, function), args, kwargs), expected,
                         "{} {} {}".format(function, len(args), sorted(kwargs)))
        return expected

    def test_flags_of_opencv(self):
        found = 0
        for _, function, _, args, kwargs in formsOfOpencv():  # without USAC flags for essential matrices, which RouteTest covers
            expected = self.compare(function, args, kwargs)
            self.assertEqual(outcome(getattr(usac, function), args, kwargs), expected,
                             "{} {} {}".format(function, len(args), sorted(kwargs)))
            found += isinstance(expected[0], tuple)
        self.assertGreater(found, 100)  # makes sure that models are compared, not only exceptions

    def test_params_of_opencv(self):
        for _, function, _, args, kwargs in paramsForms(cv.UsacParams()):
            if function != "findEssentialMat":
                self.compare(function, args, kwargs)

    def test_defaults_of_opencv(self):
        p, g = PLANE, GENERAL
        self.compare("findHomography", (p.points1, p.points2, None), {})
        self.compare("findFundamentalMat", (g.points1, g.points2), {})
        for args in ((), (g.K1,), (g.focal, g.pp), (g.K1, None, g.K1, None)):
            self.compare("findEssentialMat", (g.points1, g.points2) + args, {})

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
