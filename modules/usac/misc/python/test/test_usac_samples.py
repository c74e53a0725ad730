#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs the Python samples of the module on OpenCV's sample images, either with the package usacv20
and any cv2, or with cv2.usacv20.

OPENCV_SAMPLES_DATA_PATH  environment variable with the folder of these images (samples/data of
OpenCV's source); without these images the tests are skipped
"""

import os
import subprocess
import sys
import tempfile
import unittest

from usac_common import IN_TREE, needsCv2, once, usac

FOLDER = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.normpath(os.path.join(FOLDER, "..", "..", "..", "..", "..", "samples", "python"))
IMAGES = os.environ.get("OPENCV_SAMPLES_DATA_PATH", "")


@once
@needsCv2
class SampleTest(unittest.TestCase):
    """A sample must exit with code 0. All samples except `walkthrough` do so only if they find a model
    whose error, if known, is within a limit that the sample sets."""

    def setUp(self):
        if not os.path.isdir(SAMPLES):
            self.skipTest("the samples are not here")
        if not os.path.isfile(os.path.join(IMAGES, "graf1.png")):
            self.skipTest("OPENCV_SAMPLES_DATA_PATH does not name the folder of OpenCV's sample images")

    def run_sample(self, name, *arguments, picture="jpg"):
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "picture." + picture)
            run = subprocess.run([sys.executable, os.path.join(SAMPLES, name + ".py"), "--output", output] + list(arguments),
                                 cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
            self.assertEqual(run.returncode, 0, run.stdout)
            self.assertTrue(os.path.isfile(output), run.stdout)
            self.assertIn("USACV20", run.stdout)

    def test_homography(self):
        self.run_sample("homography", "--runs=1")

    def test_fundamental(self):
        self.run_sample("fundamental", "--runs=1", "--features=3000")

    def test_essential(self):
        self.run_sample("essential", "--runs=1")

    def test_absolute_pose(self):
        self.run_sample("absolute_pose", "--runs=1")
        self.run_sample("absolute_pose", "box.png", "--runs=1")

    def test_stabilize(self):
        self.run_sample("stabilize")

    def test_walkthrough(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib was not found")
        self.run_sample("walkthrough", "--runs=1", "--features=3000", picture="png")

    def test_the_module_is_the_one_under_test(self):
        code = "import sys; sys.path.insert(0, sys.argv[1]); import tools; print(tools.usacv20.__name__)"
        name = subprocess.run([sys.executable, "-c", code, SAMPLES], stdout=subprocess.PIPE, universal_newlines=True).stdout.strip()
        self.assertEqual(name, usac.__name__)
        self.assertEqual(name.startswith("cv2."), IN_TREE)


if __name__ == "__main__":
    unittest.main()
