#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of calls as first-time users write them. Each call must work as the user intends, or raise an
error that explains what is wrong."""

import inspect
import pydoc
import subprocess
import sys
import unittest
import warnings

import numpy as np

from usac_common import ERRORS, FINDER, FUNCTIONS, GENERAL, PLANE, RANSAC, ErrorCase, bits, cv, once, package, usac
from usac_pose import POSE


class PointsTest(ErrorCase):

    def test_one_pair_for_many(self):
        a, b = PLANE.points1, PLANE.points2
        for first, second in ((a, b), (a.tolist(), b.tolist()), ([tuple(p) for p in a], list(b)), (a[:, None], b[:, None]), (a.T, b.T)):
            self.refused(ERRORS, ("points1", "estimateHomography"), usac.estimateHomographies, first, second)
        self.refused(ERRORS, ("points2",), usac.estimateHomographies, [a], b)
        self.refused(ERRORS, ("objectPoints",), usac.estimateAbsolutePoses, POSE.X, POSE.x, POSE.K)
        expected = bits(usac.estimateHomography(a, b)[:2])
        for first, second in (([a], [b]), (a[None], b[None]), ([a.tolist()], (b,)), ([a[:, None]], [b[None]])):
            found = usac.estimateHomographies(first, second)
            self.assertEqual([bits(result[:2]) for result in found], [expected])
        self.assertEqual(usac.estimateHomographies([[], a], [[], b])[0][0], None)

    def test_many_pairs_for_one(self):
        many = np.stack([PLANE.points1, PLANE.points2])
        self.refused(ERRORS, ("points1", "(2, 300, 2)", "estimateHomographies"), usac.estimateHomography, many, many)
        self.refused(ERRORS, ("srcPoints",), FINDER.findHomography, many, many, usac.USACV20)
        self.refused(ERRORS, ("dstPoints",), usac.findHomography, PLANE.points1, many, RANSAC)
        self.refused(ERRORS, ("objectPoints",), usac.solvePnPRansac, np.stack([POSE.X, POSE.X]), POSE.x, POSE.K, None)

    def test_masked_arrays(self):
        a, b = PLANE.points1, PLANE.points2
        masked = np.ma.masked_array(a, mask=a > 300)
        self.refused(ERRORS, ("points1", "mask", "nan"), usac.estimateHomography, masked, b)
        self.refused(ERRORS, ("dstPoints",), usac.findHomography, a, np.ma.masked_array(b, mask=b > 300))
        self.refused(ERRORS, ("points1[0]",), usac.estimateHomographies, [masked], [b])
        self.assertEqual(bits(usac.findHomography(np.ma.masked_array(a), b)), bits(usac.findHomography(a, b)))
        filled = usac.estimateHomography(masked.filled(np.nan), b)[1]  # the solution that the error message suggests
        self.assertFalse(filled[(a > 300).any(axis=1)].any())

    def test_confidences(self):
        a, b = PLANE.points1, PLANE.points2
        confidences = np.random.RandomState(1).uniform(0.2, 1, (len(a), 1))
        scored = np.hstack([a, confidences])
        for wrong in (scored, scored.T, scored[:, None], scored[None], scored.tolist(), np.float32(scored)):
            self.refused(ERRORS, ("points1", "confidence", "Params.scores"), usac.estimateHomography, wrong, b)
            self.refused(ERRORS, ("dstPoints", "confidence"), usac.findHomography, a, wrong, RANSAC)
        self.refused(ERRORS, ("imagePoints",), usac.solvePnPRansac, POSE.X, np.hstack([POSE.x, 0 * POSE.x[:, :1] + 0.5]), POSE.K, None)
        expected = bits(usac.estimateHomography(a, b)[:2])
        for scale in (1, 2, 4):  # homogeneous coordinates must be accepted
            self.assertEqual(bits(usac.estimateHomography(scale * np.hstack([a, np.ones((len(a), 1))]), b)[:2]), expected)
        space = np.hstack([a / 640, confidences])  # the third coordinate of 3-D points must not be mistaken for a confidence
        self.assertIsNotNone(usac.estimateRigid3D(space, space, usac.Params(threshold=0.01))[0])

    def test_sizes_of_features(self):
        """A third column with values above 1 can be a homogeneous coordinate, so it must be accepted.
        If the column looks like sizes of features instead, there must be a warning."""
        rng = np.random.RandomState(2)
        n = 500
        a = rng.uniform(0, 640, (n, 2))
        b = a * [1.1, 0.9] + [10, 20]
        ones, depth = np.ones((n, 1)), rng.uniform(4, 8, (n, 1))
        sizes = 1.6 * 2.0 ** rng.uniform(0, 4, (n, 1))
        for wrong in (np.hstack([a, sizes]), np.hstack([a, sizes]).T, np.hstack([a, sizes])[:, None], np.hstack([a, 1 + 30 * rng.rand(n, 1)])):
            with self.assertWarnsRegex(UserWarning, r"points1: the third coordinate.*points\[:, :2\]") as seen:
                usac.estimateHomography(wrong, b)
            self.assertEqual(len(seen.warnings), 1)
            with self.assertWarnsRegex(UserWarning, "dstPoints"):
                usac.findHomography(a, wrong, usac.USACV20)
        H = np.array([[1.1, 0.1, 5], [-0.05, 0.9, 3], [4e-4, -2e-4, 1]])
        box = rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (n, 3))
        projected = np.hstack([a, ones]) @ H.T
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for right in (np.hstack([a, ones]), 7 * np.hstack([a, ones]), depth * np.hstack([a, ones]), projected,
                          projected + rng.normal(0, [1, 1, 1e-3], (n, 3)), box, box @ np.array([[800, 0, 640], [0, 800, 360], [0, 0, 1.]]).T,
                          np.hstack([a, sizes])[:40], np.full((n, 3), np.nan), np.full((n, 3), 2.0), np.hstack([a, ones * 1e300]),
                          np.hstack([a, np.r_[sizes[1:], [[np.inf]]]])[:30]):
                usac.estimateHomography(right, b[:len(right)])
            usac.estimateRigid3D(np.hstack([a, sizes]), np.hstack([a, sizes]))


class WordTest(ErrorCase):
    """Error messages must use the argument names of the called function."""

    def test_names_of_arguments(self):
        a, b, K, X, x = GENERAL.points1, GENERAL.points2, GENERAL.K1, POSE.X, POSE.x
        for word, others, function, args, kwargs in (
                ("ransacReprojThreshold", " threshold:", "findHomography", (a, b, usac.USACV20, -1.0), {}),
                ("maxIters", "maxIterations", "findHomography", (a, b, usac.USACV20), dict(maxIters=0)),
                ("confidence", "", "findHomography", (a, b, usac.USACV20), dict(confidence=2.0)),
                ("srcPoints and dstPoints", "points1", "findHomography", (a, b[1:], usac.USACV20), {}),
                ("dstPoints", "points2", "findHomography", (a, b[:, :1], usac.USACV20), {}),
                ("points1 and points2", "srcPoints", "findFundamentalMat", (a, b[1:], usac.USACV20), {}),
                ("prob", "confidence", "findEssentialMat", (a, b, K, usac.USACV20, 2.0), {}),
                ("threshold", "ransacReproj", "findEssentialMat", (a, b, K, usac.USACV20, 0.99, -1.0), {}),
                ("cameraMatrix:", "cameraMatrix1", "findEssentialMat", (a, b, K[:2], usac.USACV20), {}),
                ("cameraMatrix2", "", "findEssentialMat", (a, b, K, None, K[:2], None, usac.USACV20), {}),
                ("from_ and to", "points1", "estimateAffine2D", (a, b[1:], None, usac.USACV20), {}),
                ("ransacReprojThreshold", " threshold:", "estimateAffinePartial2D", (a, b, None, usac.USACV20, -1.0), {}),
                ("reprojectionError", " threshold:", "solvePnPRansac", (X, x, POSE.K, None),
                 dict(reprojectionError=-1.0, flags=usac.USACV20)),
                ("objectPoints and imagePoints", "points1", "solvePnPRansac", (X, x[1:], POSE.K, None), dict(flags=usac.USACV20)),
                ("iterationsCount", "maxIterations", "solvePnPRansac", (X, x, POSE.K, None), dict(iterationsCount=0, flags=usac.USACV20)),
                ("cameraMatrix:", "cameraMatrix1", "solvePnPRansac", (X, x, POSE.K[:2], None), dict(flags=usac.USACV20))):
            for where in {usac, FINDER}:
                with self.assertRaises(ERRORS, msg="{} {}".format(function, word)) as context:
                    getattr(where, function)(*args, **kwargs)
                self.assertIn(word, str(context.exception))
                self.assertIn(word, context.exception.err)
                if others:
                    self.assertNotIn(others, str(context.exception))

    def test_fields_keep_their_names(self):
        self.refused(ERRORS, ("threshold",), usac.findHomography, PLANE.points1, PLANE.points2, usac.Params(threshold=-1))
        self.refused(ERRORS, ("srcPoints and dstPoints",), usac.findHomography, PLANE.points1, PLANE.points2[1:], usac.Params())
        self.refused(ERRORS, ("objectPoints[0]", "imagePoints"), usac.estimateAbsolutePoses, [POSE.X], [POSE.x[1:]], POSE.K)
        self.refused(ERRORS, ("cameraMatrix:",), usac.estimateAbsolutePose, POSE.X, POSE.x, POSE.K[:2])

    def test_signatures(self):
        names = set(FUNCTIONS) | {name for name in dir(usac) if name.startswith(("estimate", "find"))}
        self.assertGreater(len(names), 20)
        for name in names:
            parameters = inspect.signature(getattr(usac, name)).parameters.values()
            self.assertFalse([p for p in parameters if p.kind in (p.VAR_POSITIONAL, p.VAR_KEYWORD)], name)
            self.assertIn("params", [p.name for p in parameters], name)

    def test_help(self):
        text = pydoc.plain(pydoc.render_doc(usac))
        # The text has about 750 lines with Python 3.11 and 1800 with 3.14; with the text of all
        # enumerations it would have about 6000 lines.
        self.assertLess(len(text.splitlines()), 2500)
        for name in FUNCTIONS + ("estimateHomography", "Params", "Report", "draw_matches", "USACV20_FAST"):
            self.assertIn(name, text)


class PictureTest(ErrorCase):

    def setUp(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            if cv is None:
                self.skipTest("neither cv2 nor matplotlib was found")

    def scene(self):
        image1, image2 = np.full((480, 640), 100, np.uint8), np.full((500, 600, 3), 50, np.uint8)
        a, b = np.array([[100., 200], [300, 60], [20, 400]]), np.array([[50., 100], [250, 300], [590, 490]])
        return image1, image2, a, b, np.array([[1], [0], [1]], np.uint8)

    def check(self, picture, a, b, good):
        """The dots of inliers must be green and the dots of outliers magenta. The line of an inlier
        must be green at the tested point; an outlier must have no line."""
        self.assertEqual((picture.shape, picture.dtype), ((500, 1240, 3), np.uint8))
        for p, q, inlier in zip(a, b + [640, 0], good):
            places = [p, q] + ([0.3 * p + 0.7 * q] if inlier else [])
            for x, y in places:
                near = picture[int(y) - 1:int(y) + 2, int(x) - 1:int(x) + 2].reshape(-1, 3).astype(int)
                green = near[:, 1] - near[:, [0, 2]].max(axis=1)
                self.assertGreater((green if inlier else -green).max(), 40, (x, y, near))
        between = picture[int(0.3 * a[1, 1] + 0.7 * b[1, 1]), int(0.3 * a[1, 0] + 0.7 * (b[1, 0] + 640))]
        self.assertEqual(len(set(between.tolist())), 1)  # three equal channels, gray: the outlier has no line

    def test_matches(self):
        image1, image2, a, b, mask = self.scene()
        draw = usac.draw_matches
        picture = draw(image1, image2, a, b, mask)
        self.check(picture, a, b, mask.ravel())
        self.assertEqual(picture[450, 320, 0], 76 + 70)  # the gray value 100 of image 1, made paler: 0.3 * 255 + 0.7 * 100
        for args in ((image1, image2, a[:, None], b.T, mask.ravel() != 0), (image1 / 255.0, image2, a.tolist(), np.float32(b), mask)):
            np.testing.assert_allclose(draw(*args).astype(int), picture, atol=1)
        everything = draw(image1, image2, a, b)
        self.assertGreater(int((everything != draw(image1, image2, a, b, lines=0)).any(axis=2).sum()), 1000)
        far = np.array([[np.nan, 3], [1e30, 3], [-1e6, 2]])
        np.testing.assert_array_equal(draw(image1, image2, far, b), draw(image1, image2, np.zeros((0, 2)), np.zeros((0, 2))))
        self.assertEqual(draw(image1, image2, [], []).shape, picture.shape)

    def test_mistakes(self):
        image1, image2, a, b, mask = self.scene()
        for word, args in (("image1", (None, image2, a, b)), ("image2", (image1, np.zeros((4, 4, 2)), a, b)), ("image1", ("a.png", image2, a, b)),
                           ("image1: an image", ([[1], [1, 2]], image2, a, b)), ("image2: an image", (image1, [[1], [1, 2]], a, b)),
                           ("points1 and points2", (image1, image2, a, b[1:])), ("mask", (image1, image2, a, b, mask[1:])),
                           ("points2", (image1, image2, a, np.zeros((3, 5)))), ("lines", (image1, image2, a, b, mask, -1))):
            self.refused(ERRORS, (word,), usac.draw_matches, *args)

    @once
    @package
    def test_without_cv2_and_without_both(self):
        """Runs in another process where cv2, or both cv2 and matplotlib, cannot be imported."""
        code = "import sys; sys.modules.update({}); import numpy as np, usacv20; print(usacv20.draw_matches({}).shape)"
        image = "np.zeros((20, 30)), np.zeros((20, 30)), [[1, 2]], [[3, 4]]"
        for missing, words in (("cv2=None", "(20, 60, 3)"), ("cv2=None, matplotlib=None", "ImportError: draw_matches: cv2 or matplotlib")):
            run = subprocess.run([sys.executable, "-c", code.replace("{}", "dict({})", 1).format(missing, image)],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
            self.assertIn(words, run.stdout)


if __name__ == "__main__":
    unittest.main()
