#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of installing the package. If something is missing, the last line of the output must be an
error message that names what is missing."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from usac_common import once, package, usac

FOLDER = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(FOLDER, "..", "..", ".."))


@once
@package
class MissingTest(unittest.TestCase):

    def check(self, words, **environment):
        with tempfile.TemporaryDirectory() as folder:
            values = dict(os.environ, **environment)
            values.pop("USACV20_BUILD_DIR", None)
            run = subprocess.run([sys.executable, os.path.join(ROOT, "setup.py"), "-q", "build_ext", "--build-lib", folder], env=values,
                                 cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.assertNotEqual(run.returncode, 0)
        last = run.stderr.strip().splitlines()[-1]
        self.assertTrue(last.startswith(("error: usacv20: ", "usacv20: ")), run.stderr)
        self.assertRegex(last, words)
        self.assertNotIn("Traceback", run.stderr)
        return run.stderr

    def without(self, name):
        return self.check(name, CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_{}=ON".format(name))

    def test_no_compiler(self):
        self.check("no C.. compiler", CXX="/nowhere/c++")

    def test_no_cmake(self):
        self.check("CMake was not found", PATH="/nowhere")

    def test_no_opencv(self):
        self.without("OpenCV")

    def test_no_eigen(self):
        self.check("Eigen was not found", CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON")

    def test_no_pybind11(self):
        self.without("pybind11")

    def test_no_headers_of_python(self):
        self.check("headers of", CMAKE_ARGS="-DCMAKE_DISABLE_FIND_PACKAGE_Python=ON")

    def test_compiler_that_fails(self):
        self.check("has failed", CMAKE_ARGS="-DCMAKE_CXX_FLAGS=--nonsense")

    def test_old_python(self):
        code = "import sys; sys.version_info = (3, 6, 0, 'final', 0); sys.argv = ['setup.py', 'build']; exec(open('setup.py').read())"
        run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual((run.returncode, run.stdout), (1, b""))
        self.assertEqual(run.stderr, b"usacv20: Python 3.8 or later is needed, this is 3.6\n")

    def test_builds_at_the_same_time(self):
        """Simultaneous builds of the same sources must run one after another and leave no files. The sources
        are a copy, because other programs might build the package from the original ones."""
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "modules", "usac")
            for part in ("cmake", "misc", "include"):
                shutil.copytree(os.path.join(ROOT, part), os.path.join(copy, part))
            for name in ("setup.py", "pyproject.toml", "MANIFEST.in", "README.md"):
                shutil.copy(os.path.join(ROOT, name), copy)
            shutil.copy(os.path.join(ROOT, "..", "..", "LICENSE"), folder)
            before = sorted(os.listdir(copy))
            runs = [subprocess.Popen([sys.executable, "setup.py", "-q", "egg_info"], cwd=copy, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, universal_newlines=True) for _ in range(6)]
            for run in runs:
                output = run.communicate()[0]
                self.assertEqual(run.returncode, 0, output)
            self.assertEqual(sorted(os.listdir(copy)), before)

    def test_compiled_part_of_another_python(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.dirname(usac.__file__), os.path.join(folder, "whole"))
            os.mkdir(os.path.join(folder, "usacv20"))
            for name in os.listdir(os.path.join(folder, "whole")):
                if name.endswith(".py"):
                    os.symlink(os.path.join(folder, "whole", name), os.path.join(folder, "usacv20", name))
            run = subprocess.run([sys.executable, "-c", "import usacv20"], env=dict(os.environ, PYTHONPATH=folder),
                                 stderr=subprocess.PIPE, universal_newlines=True)
        last = run.stderr.strip().splitlines()[-1]
        self.assertIn("ImportError: usacv20: the compiled part was not found", last)
        self.assertIn("{}.{}".format(*sys.version_info[:2]), last)


@once
@package
class NumPyTest(unittest.TestCase):

    def test_array_types_of_numpy_2(self):
        """With NumPy 2, a package built with pybind11 before 2.12 must raise an ImportError instead
        of giving wrong results."""
        code = "import numpy; numpy.__version__ = '{}.0.0'; import usacv20; print(usacv20.findHomography(*2 * [numpy.eye(4, 2)])[0])"
        one, two = (subprocess.run([sys.executable, "-c", code.format(major)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   universal_newlines=True) for major in (1, 2))
        self.assertEqual(one.returncode, 0, one.stderr)
        if two.returncode != 0:
            self.assertRegex(two.stderr.strip().splitlines()[-1],
                             r"ImportError: .*built with pybind11 2\.\d+, which knows NumPy 1 only, and this is NumPy 2\.0\.0")
        else:
            from usacv20 import _native
            self.assertGreaterEqual(_native.pybind11Version, (2, 12))


@package
class MetadataTest(unittest.TestCase):

    def test_metadata(self):
        from importlib import metadata
        try:
            found = metadata.metadata("usacv20")
        except metadata.PackageNotFoundError:
            self.skipTest("the package has not been installed")
        with open(os.path.join(ROOT, "cmake", "usac_version.cmake")) as file:
            self.assertIn("USAC_VERSION {})".format(found["Version"]), file.read())
            file.seek(0)
            self.assertIn("USAC_VERSION {})".format(usac.__version__), file.read())
        self.assertEqual(found["Requires-Python"], ">=3.8")
        self.assertTrue(any(name.startswith("numpy") for name in metadata.requires("usacv20")))
        files = {os.path.basename(str(file)) for file in metadata.files("usacv20")}
        self.assertLessEqual({"__init__.py", "py.typed", "_native.pyi"}, files)
        self.assertIn("LICENSE", files)
        self.assertFalse([name for name in files if name.endswith((".cpp", ".hpp", ".txt.in"))])


if __name__ == "__main__":
    unittest.main()
