#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the enumerations, of objects that cannot be copied, of errors, documentation and imports."""

import copy
import enum
import importlib
import inspect
import pickle
import pydoc
import subprocess
import sys
import unittest

from usac_common import IN_TREE, PLANE, cv, fields, needsCv2, package, usac

native = importlib.import_module(usac.__name__ + "._backend").native


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
