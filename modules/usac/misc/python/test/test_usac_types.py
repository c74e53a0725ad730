#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the type annotations: this file, the package and the samples must pass mypy --strict. The
package must also pass mypy's stubtest."""

from __future__ import annotations

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from typing import Any, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from usac_common import FUNCTIONS, once, package, usac as module

if not module.__name__.startswith("cv2."):  # type annotations below refer to the package
    import usacv20

FOLDER = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.normpath(os.path.join(FOLDER, "..", "..", "..", "..", "..", "samples", "python"))
Points = npt.NDArray[np.float64]


def points() -> Tuple[Points, Points]:
    rng = np.random.RandomState(3)
    first: Points = rng.uniform(0, 640, (60, 2))
    return first, 2 * first + [3.0, 4.0]


class Uniform(usacv20.Sampler if not module.__name__.startswith("cv2.") else object):  # type: ignore[misc]
    data: npt.NDArray[np.float64]

    def start(self, points: usacv20.Correspondences) -> None:
        self.data = points.data

    def sample(self, rng: usacv20.Rng, iteration: int) -> List[int]:
        return [int(index) for index in rng.distinct(len(self.data), 4)]


@package
class TypedTest(unittest.TestCase):
    """Calls as in a program with type annotations. mypy checks the types (see test_this_file); the
    tests of this class check the values."""

    def test_flags(self) -> None:
        a, b = points()
        H: Optional[npt.NDArray[np.float64]]
        mask: npt.NDArray[np.uint8]
        H, mask = usacv20.findHomography(a, b, usacv20.USACV20, 3.0, maxIters=500)
        assert H is not None
        self.assertEqual((H.shape, int(mask.sum())), ((3, 3), 60))
        A, inliers = usacv20.estimateAffine2D(a.tolist(), b, None, usacv20.USACV20_FAST)
        assert A is not None
        np.testing.assert_allclose(A, [[2, 0, 3], [0, 2, 4]], atol=1e-6)

    def test_params(self) -> None:
        a, b = points()
        params = usacv20.Params(threshold=2.0)
        params.scores = np.arange(60)
        params.quality = usacv20.QUALITY_MSAC
        params.termination = usacv20.TERMINATION_SPRT | usacv20.TERMINATION_P_NAPSAC
        quality: usacv20.QualityType = params.quality
        threshold: float = params.threshold
        scores: npt.NDArray[Any] = params.scores
        self.assertEqual((quality.name, threshold, scores.shape), ("QUALITY_MSAC", 2.0, (60,)))
        model, mask, report = usacv20.estimateHomography(a, b, params)
        reason: usacv20.StopReason = report.stop
        self.assertNotEqual(reason, usacv20.STOP_NO_MODEL)
        self.assertEqual(report.inliers, int(mask.sum()))
        self.assertIsNotNone(usacv20.findHomography(a, b, params)[0])
        self.assertIsNotNone(usacv20.findHomography(a, b, method=params)[0])

    def test_pose(self) -> None:
        X = np.random.RandomState(1).uniform(-1, 1, (50, 3)) + [0, 0, 5.0]
        K = np.array([[500.0, 0, 320], [0, 500, 240], [0, 0, 1]])
        x = 500 * X[:, :2] / X[:, 2:] + [320.0, 240.0]
        found, rvec, tvec, inliers = usacv20.solvePnPRansac(X, x, K, None, flags=usacv20.USACV20)
        assert rvec is not None and inliers is not None
        self.assertEqual((found, len(inliers)), (True, 50))
        results = usacv20.solvePnPRansac(X, x, K, None, params=usacv20.Params())
        self.assertEqual(len(results), 5)

    def test_components(self) -> None:
        a, b = points()
        usac = usacv20.Usac.create(usacv20.HOMOGRAPHY, a, b)
        usac.components.sampler = Uniform()
        model, mask, report = usac.run()
        self.assertEqual(int(mask.sum()), 60)

    def test_errors(self) -> None:
        code: Union[int, None] = None
        try:
            usacv20.Params(threshold=-1).check()
        except usacv20.error as failure:
            code = failure.code
        self.assertEqual(code, -211)


# All runs of mypy have the same options, so that they share mypy's cache. Warnings about superfluous
# `type: ignore` comments and casts are off, because some are needed only with certain versions of
# NumPy's stubs.
OPTIONS = """[mypy]
strict = True
warn_redundant_casts = False
[mypy-usacv20.*]
warn_unused_ignores = False
[mypy-test_usac_types]
allow_untyped_calls = True
[mypy-usac_common,usac_camera]
follow_imports = silent
[mypy-cv2.*,matplotlib.*]
ignore_missing_imports = True
"""


@once
@package
class ToolTest(unittest.TestCase):

    cache = ""

    @classmethod
    def setUpClass(cls) -> None:
        cls.cache = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.cache)
        with open(os.path.join(cls.cache, "mypy.ini"), "w") as file:
            file.write(OPTIONS)

    def tool(self, name: str, *arguments: str) -> Tuple[int, str]:
        run = subprocess.run([sys.executable, "-m", name, *arguments], cwd=self.cache, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True,
                             env=dict(os.environ, MYPY_CACHE_DIR=self.cache, MYPYPATH=self.path))
        return run.returncode, run.stdout

    def passes(self, name: str, *arguments: str) -> None:
        code, output = self.tool(name, *arguments)
        self.assertEqual(code, 0, output)

    def setUp(self) -> None:
        try:
            import mypy.version  # noqa: F401
        except ImportError:
            self.skipTest("mypy was not found")
        # mypy searches folders like site-packages itself and refuses them in MYPYPATH.
        path = os.path.dirname(os.path.dirname(str(usacv20.__file__)))
        self.path = os.pathsep.join(folder for folder in (path, SAMPLES, FOLDER) if not folder.endswith("-packages"))

    def test_package(self) -> None:
        self.passes("mypy", "-p", "usacv20")

    def test_stubs(self) -> None:
        # For functions with overloads, Python's module inspect shows only one signature, so stubtest
        # must skip these functions. test_usac_newcomers.py tests their signatures.
        with open(os.path.join(self.cache, "allowed.txt"), "w") as file:
            file.write(r"usacv20(\._\w+)?\.({})".format("|".join(FUNCTIONS)))
        self.passes("mypy.stubtest", "usacv20", "--allowlist", "allowed.txt")

    def test_this_file(self) -> None:
        self.passes("mypy", os.path.abspath(__file__))

    def test_samples(self) -> None:
        files = sorted(glob.glob(os.path.join(SAMPLES, "*.py")))
        if not files:
            self.skipTest("the samples are not here")
        self.passes("mypy", *files)

    def test_mistakes_are_found(self) -> None:
        wrong = ("usacv20.findHomography([[1, 2]], [[1, 2]], '3')", "usacv20.Params().threshold = 'two'",
                 "usacv20.estimateHomography([[1, 2]], [[1, 2]], 3.0)", "usacv20.Params().quality.nothing",
                 "usacv20.findFundamentalMat([[1, 2]], [[1, 2]], usacv20.Params(), 3.0)", "usacv20.Params(treshold=2)",
                 "usacv20.Params(threshold='2')")
        with open(os.path.join(self.cache, "wrong.py"), "w") as file:
            file.write("import usacv20\n" + "\n".join(wrong) + "\n")
        _, output = self.tool("mypy", "wrong.py")
        lines = {int(line.split(":")[1]) for line in output.splitlines() if ": error: " in line}
        self.assertEqual(lines, set(range(2, 2 + len(wrong))), output)


if __name__ == "__main__":
    unittest.main()
