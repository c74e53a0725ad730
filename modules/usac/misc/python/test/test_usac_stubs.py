#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the stubs (.pyi) of cv2 and cv2.usacv20 for type checkers. The build of OpenCV 4.9 and later
writes stubs if all OpenCV modules that the stubs refer to are built."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from usac_common import FLAGS, inTree, usac

PROGRAM = """
import cv2
import numpy as np
import numpy.typing as npt
from cv2 import usacv20

points = np.zeros((10, 2))
method: int = cv2.USACV20
params = usacv20.Params(threshold=2, quality=usacv20.QualityType.QUALITY_MSAC)
model, mask = usacv20.findHomography(points, points, usacv20.USACV20_FAST, 3.0)
H, inliers, report = usacv20.estimateHomography(points, points, params)
matrix: npt.NDArray[np.float64] = np.eye(3) if H is None else H
reason: str = report.stop.name
results = usacv20.estimateHomographies([points], [points], params)
WRONG: str = usacv20.Params().threshold
"""


@inTree
class StubTest(unittest.TestCase):

    def setUp(self):
        folder = os.path.dirname(usac.__file__)
        self.loader = os.path.dirname(os.path.dirname(folder))
        self.stub = os.path.join(os.path.dirname(folder), "__init__.pyi")
        if not os.path.exists(self.stub):
            self.skipTest("this cv2 has no stubs")

    def test_names(self):
        with open(self.stub) as file:
            text = file.read()
        for name in FLAGS:
            self.assertRegex(text, "(?m)^{}: int$".format(name))
        self.assertRegex(text, "(?m)^from cv2 import usacv20")

    def test_the_layer_is_not_hidden(self):
        self.assertFalse(os.path.exists(os.path.join(os.path.dirname(usac.__file__), "__init__.pyi")))

    def test_program(self):
        try:
            import mypy.version  # noqa: F401
        except ImportError:
            self.skipTest("mypy was not found")
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        program = os.path.join(folder, "program.py")
        with open(program, "w") as file:
            file.write(PROGRAM)
        # mypy finds cv2 in the current folder; --follow-imports=silent hides errors in cv2's own stubs.
        run = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "--cache-dir", folder, program],
                             cwd=self.loader, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        found = [int(line) for line in re.findall(r"program\.py:(\d+): error", run.stdout)]
        self.assertEqual(found, [PROGRAM.splitlines().index("WRONG: str = usacv20.Params().threshold") + 1], run.stdout)
        self.assertNotIn("usacv20" + os.sep, run.stdout)


if __name__ == "__main__":
    unittest.main()
