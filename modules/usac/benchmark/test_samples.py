#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the samples stabilize and absolute_pose, in C++ and Python, on images that the tests make
and on synthetic data that the samples make themselves.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; the C++ samples are
taken from the same folder."""

import os
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))


def cpp(name):
    return [os.path.join(os.path.dirname(os.environ.get("USAC_BENCHMARK", "")), "example_usac_" + name)]


def python(name):
    return [sys.executable, os.path.join(HERE, "..", "..", "..", "samples", "python", name + ".py")]


needsCpp = unittest.skipUnless(os.path.isfile(cpp("stabilize")[0]), "there are no samples beside USAC_BENCHMARK")
needsPython = unittest.skipUnless(hasattr(cv2, "_native") and hasattr(cv2, "usacv20"), "this cv2 has no module usac")


def texture(width, height):
    """Returns an image with features everywhere: the sum of smooth noise of three sizes."""
    rng, image = np.random.RandomState(1), np.zeros((height, width, 3))
    for size in (4, 12, 40):
        noise = rng.uniform(-1, 1, (height // size + 2, width // size + 2, 3))
        image += cv2.resize(noise, (width, height), interpolation=cv2.INTER_CUBIC)
    return cv2.normalize(image, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)


class SampleTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = os.path.join(self.folder.name, "picture.jpg")

    def run_sample(self, command, *args):
        """Runs a sample, which must succeed and write a picture; returns its standard output."""
        done = subprocess.run(command + list(args) + ["--output=" + self.output], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIsNotNone(cv2.imread(self.output))
        return done.stdout


class StabilizeTest(SampleTest):

    def check(self, command):
        image = os.path.join(self.folder.name, "image.png")
        cv2.imwrite(image, texture(480, 360))
        lines = self.run_sample(command, "--image=" + image).splitlines()
        line, = [line for line in lines if line.startswith("USACV20")]
        self.assertLess(float(line.split()[1].rstrip(",")), 0.2, line)  # mean error in pixels

        frames = os.path.join(self.folder.name, "frames")
        os.mkdir(frames)
        wide = texture(400, 300)
        for k, shift in enumerate((20, 26, 15, 22, 18)):
            cv2.imwrite(os.path.join(frames, "%02d.png" % k), wide[shift:shift + 240, 60 - shift:380 - shift])
        lines = self.run_sample(command, frames).splitlines()
        self.assertIn("5 frames", lines)
        line, = [line for line in lines if line.startswith("USACV20")]
        self.assertIn("unknown", line)
        picture = cv2.imread(self.output)
        left, right = picture[:240, :320], picture[:240, 320:640]
        sharpness = [cv2.Laplacian(half[30:-30, 30:-30], cv2.CV_64F).var() for half in (left, right)]
        # The right half of the picture is the mean of the stabilized frames. This half must be sharper
        # than the left half, the mean of the original frames.
        self.assertGreater(sharpness[1], 2 * sharpness[0])

    @needsCpp
    def test_cpp(self):
        self.check(cpp("stabilize"))

    @needsPython
    def test_python(self):
        self.check(python("stabilize"))


class AbsolutePoseTest(SampleTest):

    def row(self, text, method, which=0):
        """Returns the columns of the line of a method in a table of the output. If the method has
        several lines, `which` is the number of the line, from 0."""
        return [line for line in text.splitlines() if line.startswith(method + " ")][which][len(method):].split()

    def check(self, command):
        self.check_made(self.run_sample(command, "--runs=1"))
        camera = os.path.join(self.folder.name, "camera.yml")
        storage = cv2.FileStorage(camera, cv2.FILE_STORAGE_WRITE)
        storage.write("camera_matrix", np.float64([[700, 0, 330], [0, 710, 235], [0, 0, 1]]))
        storage.write("distortion_coefficients", np.float64([[-0.25, 0.05, 0.002, -0.001, 0]]))
        storage.release()
        self.check_made(self.run_sample(command, "--runs=1", "--camera=" + camera))
        self.check_given(command)

    def check_made(self, made):
        for method, which in (("USACV20", 0), ("USACV20", 1), ("with scores", 0), ("with scores", 1), ("with the last", 0)):
            degrees, _, place = self.row(made, method, which)[:3]
            self.assertLess(float(degrees), 0.3, made)
            self.assertLess(float(place), 0.02, made)
        self.assertLessEqual(int(self.row(made, "with the last")[-2]), int(self.row(made, "with scores", 1)[-2]), made)

    def check_given(self, command):
        names = [os.path.join(self.folder.name, name) for name in ("object.png", "scene.png", "next.png")]
        images = [texture(400, 300), texture(640, 480)[::-1].copy(), texture(640, 480)[::-1].copy()]
        for k, shift in ((1, 60), (2, 70)):
            images[k][shift:shift + 300, 100:500] = images[0]
        for name, image in zip(names, images):
            cv2.imwrite(name, image)
        given = self.run_sample(command, *(names + ["--runs=1", "--focal=800"]))
        self.assertIn("unknown", self.row(given, "with the last"))
        pose = np.float64([float(number) for number in "".join(
            c if c in "0123456789.-+e" else " " for c in given.rsplit("[R t] =", 1)[1].split("]\n\n")[0]).split()]).reshape(3, 4)
        place = 800 * pose[:2, 3] / pose[2, 3] + [319.5, 239.5]  # image point of the object's center in pixels
        self.assertLess(np.abs(place - [300, 220]).max(), 1, given)
        self.assertLess(abs(pose[2, 3] - 2), 0.02, given)  # depth 2: the object (width 1) is 400 pixels wide at focal length 800
        self.assertLess(np.abs(pose[:, :3] - np.diag([1, -1, -1])).max(), 0.02, given)

    @needsCpp
    def test_cpp(self):
        self.check(cpp("absolute_pose"))

    @needsPython
    def test_python(self):
        self.check(python("absolute_pose"))


if __name__ == "__main__":
    unittest.main()
