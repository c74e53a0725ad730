#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the functions for many estimations in one call. These functions must return the same
results as single calls, whether one camera matrix is given for all pairs or one for each pair, and
they must refuse wrong arguments."""

import unittest

import numpy as np

from usac_common import ERRORS, Scene, bits, usac
from usac_pose import POSE

THREADS = (0, 1, 3)


def pairs(planar, count=9):
    """Returns the points of `count` image pairs, as a list for image 1 and a list for image 2. The
    pairs have the first 60, 85, 110, ... correspondences of the same scene."""
    scene = Scene(planar)
    parts = [slice(0, 60 + 25 * i) for i in range(count)]
    return [scene.points1[part] for part in parts], [scene.points2[part] for part in parts]


def spaces(count=6):
    rng = np.random.RandomState(3)
    turn = np.array([[0., -1, 0], [1, 0, 0], [0, 0, 1]])
    first = [rng.uniform(-1, 1, (30 + 10 * i, 3)) for i in range(count)]
    second = [X.dot(turn.T) + [0.3, 0.2, 0.1] + rng.normal(0, 0.001, X.shape) for X in first]
    for X in second:
        X[::3] = rng.uniform(-1, 1, X[::3].shape)
    return first, second


def values(result):
    """Returns the parts of a result that must be equal in each run; the times in the report differ."""
    model, mask, report = result
    return bits((model, mask)), report.iterations, report.cost, report.stop


class BatchTest(unittest.TestCase):

    def check(self, many, one, first, second, params=None, **cameras):
        each = params if isinstance(params, list) else [params] * len(first)
        expected = [values(one(a, b, *cameras.values(), params=options)) for a, b, options in zip(first, second, each)]
        self.assertTrue(all(result[0][0] is not None for result in expected))
        for threads in THREADS:
            found = many(first, second, *cameras.values(), params=params, threads=threads)
            self.assertEqual([values(result) for result in found], expected)

    def test_same_as_one_by_one(self):
        plane, general, space = pairs(True), pairs(False), spaces()
        self.check(usac.estimateHomographies, usac.estimateHomography, *plane)
        self.check(usac.estimateAffinities2D, usac.estimateAffinity2D, *plane, params=usac.Params(threshold=20))
        self.check(usac.estimateSimilarities2D, usac.estimateSimilarity2D, *plane, params=usac.Params(threshold=20))
        self.check(usac.estimateTranslations2D, usac.estimateTranslation2D, *plane, params=usac.Params(threshold=40))
        self.check(usac.estimateFundamentals, usac.estimateFundamental, *general)
        params = usac.Params(threshold=0.01)
        self.check(usac.estimateRigids3D, usac.estimateRigid3D, *space, params=params)
        self.check(usac.estimateSimilarities3D, usac.estimateSimilarity3D, *space, params=params)

        params = [usac.Params(threshold=1 + i % 3, scores=np.arange(len(a))[::-1 if i % 2 else 1]) for i, a in enumerate(plane[0])]
        params[4] = None
        self.check(usac.estimateHomographies, usac.estimateHomography, *plane, params=params)

    def test_cameras(self):
        first, second = pairs(False)
        K = Scene(False).K1
        expected = [values(usac.estimateEssential(a, b, K)) for a, b in zip(first, second)]
        lens = [0.0] * 5
        for cameras in ((K,), (K.tolist(),), ([K] * len(first),), (np.stack([K] * len(first)),), (K, K), (K, [K] * len(first))):
            self.assertEqual([values(result) for result in usac.estimateEssentials(first, second, *cameras)], expected)
        for lenses in (lens, np.array(lens), [lens] * len(first), [None] * len(first)):
            self.assertEqual([values(result) for result in usac.estimateEssentials(first, second, K, K, lenses)], expected)

    def test_poses(self):
        objects, images = [POSE.X[:n] for n in (100, 150, 300)], [POSE.x[:n] for n in (100, 150, 300)]
        expected = [values(usac.estimateAbsolutePose(X, x, POSE.K, POSE.d)) for X, x in zip(objects, images)]
        for lenses in (POSE.d, [POSE.d] * 3):
            found = usac.estimateAbsolutePoses(objects, images, POSE.K, lenses)
            self.assertEqual([values(result) for result in found], expected)

    def test_mistakes(self):
        first, second = pairs(True)
        wrong = list(second)
        wrong[3] = wrong[3][1:]
        with self.assertRaisesRegex(ERRORS, r"points1\[3\].*points1 and points2"):
            usac.estimateHomographies(first, wrong)
        wrong[5] = "points"
        with self.assertRaisesRegex(ERRORS, r"points2\[5\]"):
            usac.estimateHomographies(first, wrong)
        found = usac.estimateHomographies(first, wrong, returnExceptions=True)
        self.assertIsInstance(found[3], ERRORS)
        self.assertIsInstance(found[5], ERRORS)
        for i, (a, b) in enumerate(zip(first, second)):
            if i not in (3, 5):
                self.assertEqual(values(found[i]), values(usac.estimateHomography(a, b)))
        for call, words in (((first, second[1:]), "points1 and points2"), ((first, second, [None] * 3), "params"),
                            ((first, second, "fast"), "params"), ((first, second, None, -1), "threads"),
                            ((first, second, None, 1.5), "threads")):
            with self.assertRaisesRegex(ERRORS, words):
                usac.estimateHomographies(*call)
        with self.assertRaisesRegex(ERRORS, "cameraMatrices1"):
            usac.estimateEssentials(first, second, [np.eye(3)] * 2)
        for both in (False, True):  # a wrong camera matrix for all pairs is an error even with returnExceptions
            with self.assertRaisesRegex(ERRORS, "cameraMatrices1"):
                usac.estimateEssentials(first, second, "K", returnExceptions=both)

    def test_no_lists(self):
        first, second = pairs(True, 2)
        ragged = [[1, [2, 3]], [4, 5]]
        for call, words in (((5, 5), "points1: a list"), ((first, 5), "points2: a list"), ((first, None), "points2: a list"),
                            ((first, second, 5), "params: a .*Params, or a list"), (([5, 5], second), r"points1\[0\]"),
                            (([np.array(5)] * 2, second), r"points1\[0\]"), (([ragged] * 2, second), r"points1\[0\]")):
            with self.assertRaisesRegex(ERRORS, words):
                usac.estimateHomographies(*call)
        for wrong in (5, ragged, [ragged, ragged], [ragged, np.eye(3)]):
            with self.assertRaisesRegex(ERRORS, "cameraMatrices2"):
                usac.estimateEssentials(first, second, np.eye(3), wrong)

    def test_names_of_cameras(self):
        """A message names the pair, and the wrong argument by its name in the called function."""
        X, x, K = [POSE.X], [POSE.x], POSE.K
        for call, words in (((X, x, K[:2]), "cameraMatrices: "), ((X, x, K, [1, 2]), "distCoeffs: "),
                            ((X, [POSE.x[1:]], K), "objectPoints and imagePoints: ")):
            with self.assertRaisesRegex(ERRORS, r"objectPoints\[0\]: " + words):
                usac.estimateAbsolutePoses(*call)
        for call, words in (((K[:2],), "cameraMatrices1: "), ((K, K[:2]), "cameraMatrices2: "), ((K, K, [1, 2]), "distCoeffs1: ")):
            with self.assertRaisesRegex(ERRORS, r"points1\[0\]: " + words):
                usac.estimateEssentials(x, x, *call)

    def test_sigmas_for_another_number_of_matches(self):
        first, second = pairs(True)
        # 20 rows for 60 matches; without their shape, they would be read as the standard deviations of 60 matches
        params = usac.Params(sigmas=np.tile([4., 1, 3], (20, 1)))
        with self.assertRaisesRegex(ERRORS, r"^points1\[0\]: sigmas"):
            usac.estimateHomographies(first[:1], second[:1], params)
        each = [usac.Params(sigmas=np.tile([4., 1, 3], (len(a), 1))) for a in first]
        each[0] = params
        with self.assertRaisesRegex(ERRORS, r"^points1\[0\]: sigmas"):
            usac.estimateHomographies(first, second, each)
        found = usac.estimateHomographies(first, second, each, returnExceptions=True)
        self.assertRegex(str(found[0]), r"^points1\[0\]: sigmas")
        for i in range(1, len(first)):
            self.assertEqual(values(found[i]), values(usac.estimateHomography(first[i], second[i], each[i])))
        with self.assertRaisesRegex(ERRORS, r"^objectPoints\[0\]: sigmas"):
            usac.estimateAbsolutePoses([POSE.X[:60]], [POSE.x[:60]], POSE.K, POSE.d, params)

    def test_none(self):
        self.assertEqual(usac.estimateHomographies([], []), [])
        (model, mask, report), = usac.estimateHomographies([np.zeros((2, 2))], [np.zeros((2, 2))])
        self.assertIsNone(model)
        self.assertEqual(mask.shape, (2, 1))
        self.assertEqual(report.stop, usac.STOP_TOO_FEW_POINTS)

    def test_iterators(self):
        first, second = pairs(True, 4)
        found = usac.estimateHomographies((points for points in first), iter(second))
        self.assertEqual([values(r) for r in found], [values(usac.estimateHomography(a, b)) for a, b in zip(first, second)])


if __name__ == "__main__":
    unittest.main()
