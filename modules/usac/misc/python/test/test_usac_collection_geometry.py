#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the collection tool's verification of single image pairs: configuration (calibrated,
planar, ...), relative pose, inliers and number of samples."""

import pickle
import unittest

import numpy as np

from usac_camera import rotation as rotationOf
from usac_colmap import matrixOf
from usac_common import once, package

try:
    from usacv20.collection._geometry import verifyPairs
    from usacv20.collection._pair import CollectionError, Configuration, Pair, View
    from usacv20.collection._poses import quaternion
    from usacv20.collection._settings import Settings
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass

K = np.array([[900., 0, 500], [0, 900, 400], [0, 0, 1]])
SIZE = (1000, 800)
NOISE = 0.5


class Scene(object):
    """Two images of random points in space. With probability `planar` a point lies in a certain plane;
    with probability `wrong` a match is wrong. `noise` is the standard deviation of the noise in pixels;
    the stored focal length is the true one times `focal`."""

    def __init__(self, seed=1, planar=0., count=300, wrong=0.4, turn=(0.03, -0.2, 0.05), move=(-1., 0.2, 0.1), known=True,
                 focal=1., names=("a.jpg", "b.jpg"), key=5, noise=NOISE):
        rng = np.random.RandomState(seed)
        X = rng.uniform([-3, -2.5, 6], [3, 2.5, 12], (count, 3))
        flat = rng.uniform(size=count) < planar
        X[flat, 2] = 9 + 0.3 * X[flat, 0] - 0.2 * X[flat, 1]
        self.R, self.t = rotationOf(np.array(turn)), np.array(move)
        first, second = X @ K.T, (X @ self.R.T + self.t) @ K.T
        x1 = first[:, :2] / first[:, 2:] + rng.normal(0, noise, (count, 2))
        x2 = second[:, :2] / second[:, 2:] + rng.normal(0, noise, (count, 2))
        self.right = rng.uniform(size=count) >= wrong
        x2[~self.right] = rng.uniform(0, SIZE, (count, 2))[~self.right]
        matrix = K * np.array([[focal, focal, 1]])
        views = [View(name, points, points, matrix, known, *SIZE) for name, points in zip(names, (x1, x2))]
        self.matches = np.c_[rng.permutation(count), rng.permutation(count)].astype(np.uint32)
        self.pair = Pair(key, views[0], views[1], self.matches, None, True)

    def errors(self, result):
        """Returns the errors of the rotation and of the translation direction in degrees."""
        turn = np.trace(matrixOf(result.quaternion).T @ self.R)
        move = self.t @ result.translation / np.linalg.norm(self.t)
        return np.degrees(np.arccos(np.clip([(turn - 1) / 2, move], -1, 1)))

    def marked(self, result):
        """Returns a boolean for each match: True if the match is an inlier of the result."""
        inliers = set(map(tuple, result.inliers.tolist()))
        return np.array([tuple(match) in inliers for match in self.matches.tolist()])


def verified(scene, **settings):
    return verifyPairs([scene.pair], Settings(**dict({"threshold": 2.0}, **settings)))[0]


@once
@package
class GeometryTest(unittest.TestCase):

    def check(self, scene, result, configuration, degrees=1., wrong=0.05):
        self.assertEqual((result.key, result.configuration, result.reason), (5, configuration, ""))
        self.assertEqual(result.matches, len(scene.matches))
        marked = scene.marked(result)
        self.assertEqual(marked.sum(), len(result.inliers))
        self.assertGreater(marked[scene.right].mean(), 0.95)
        self.assertLess(marked[~scene.right].mean(), wrong)
        self.assertLess(result.chance, 1e-6)
        self.assertGreater(result.iterations, 0)
        if result.quaternion is not None and configuration != Configuration.PANORAMIC:
            if degrees is not None:
                self.assertLess(scene.errors(result).max(), degrees)
            self.assertAlmostEqual(np.linalg.norm(result.translation), 1, places=9)

    def test_calibrated(self):
        scene = Scene(1)
        result = verified(scene)
        self.check(scene, result, Configuration.CALIBRATED)
        K1 = np.linalg.inv(K)
        F = K1.T @ result.E @ K1
        np.testing.assert_allclose(result.F, F / np.linalg.norm(F), atol=1e-12)

    def test_each_of_the_four_motions(self):
        for move in ((1., 0, 0), (-1., 0, 0), (0, 0, 1.5), (0, 0, -1.5)):
            scene = Scene(3, turn=(0, 0, 1.), move=move)
            self.check(scene, verified(scene), Configuration.CALIBRATED, 2.)

    def test_focal_lengths_not_known(self):
        scene = Scene(2)
        for pair in (Scene(2, known=False).pair, scene.pair._replace(second=scene.pair.second._replace(focalKnown=False))):
            result = verifyPairs([pair], Settings(threshold=2))[0]
            self.check(scene, result, Configuration.UNCALIBRATED)
            self.assertEqual((result.E, result.quaternion, result.translation), (None, None, None))
            self.assertIsNotNone(result.F)
        result = verified(Scene(4, planar=1, known=False))
        self.assertEqual((result.configuration, result.quaternion), (Configuration.PLANAR_OR_PANORAMIC, None))

    def test_plane(self):
        scene = Scene(1, planar=1)
        result = verified(scene)
        # Points of a plane determine E only weakly, so more of the wrong matches are inliers.
        self.check(scene, result, Configuration.PLANAR, None, wrong=0.08)
        # A plane is compatible with two motions. E must belong to the returned motion.
        cross = np.cross(np.eye(3), result.translation)
        E = -cross @ matrixOf(result.quaternion)
        self.assertAlmostEqual(abs(np.sum(E * result.E)), np.sqrt(2), places=6)
        right = scene.right
        moved = np.c_[scene.pair.first.points[right], np.ones(right.sum())] @ result.H.T
        error = np.linalg.norm(moved[:, :2] / moved[:, 2:] - scene.pair.second.points[right], axis=1)
        self.assertGreater(np.mean(error < 2), 0.9)

    def test_rotation(self):
        scene = Scene(4, turn=(0.02, -0.2, 0.05), move=(0., 0, 0))
        result = verified(scene)
        self.check(scene, result, Configuration.PANORAMIC, wrong=0.08)  # E is weakly determined, as in test_plane
        np.testing.assert_array_equal(result.translation, [0, 0, 0])
        angle = (np.trace(matrixOf(result.quaternion).T @ scene.R) - 1) / 2
        self.assertLess(np.degrees(np.arccos(min(1, angle))), 0.1)

    def test_refused(self):
        for seed in range(6):
            result = verified(Scene(seed, wrong=1., known=seed % 2 == 0))
            self.assertEqual((result.configuration, len(result.inliers), result.F, result.E, result.H),
                             (Configuration.DEGENERATE, 0, None, None, None))
            self.assertRegex(result.reason, "^[EFH]: .+")
        self.assertEqual(verified(Scene(1, count=14)).reason, "14 matches, 15 are needed")
        self.assertEqual(verified(Scene(1, count=40, wrong=0), minInliers=20).configuration, Configuration.CALIBRATED)
        self.assertEqual(verified(Scene(1, count=40, wrong=0.6), minInliers=30).configuration, Configuration.DEGENERATE)

    def test_watermark(self):
        scene = Scene(6, wrong=1., count=200)
        rng = np.random.RandomState(6)
        mark = rng.uniform([20, 20], [300, 80], (120, 2))
        first, second = scene.pair.first.points.copy(), scene.pair.second.points.copy()
        first[:120], second[:120] = mark, mark + rng.normal(0, 0.3, (120, 2))
        views = [view._replace(points=points, taken=points) for view, points in ((scene.pair.first, first),
                                                                                 (scene.pair.second, second))]
        pair = scene.pair._replace(first=views[0], second=views[1])
        self.assertEqual(verifyPairs([pair], Settings(threshold=2))[0].configuration, Configuration.WATERMARK)
        without = verifyPairs([pair], Settings(threshold=2, watermarks=False))[0]
        self.assertIn(without.configuration, (Configuration.PANORAMIC, Configuration.PLANAR))
        # The same matches must not be classified as a watermark if they are not near the border of the
        # images.
        moved = pair._replace(first=views[0]._replace(taken=first + [300, 300]), second=views[1]._replace(taken=second + [300, 300]))
        self.assertNotEqual(verifyPairs([moved], Settings(threshold=2))[0].configuration, Configuration.WATERMARK)

    def test_scores(self):
        scene = Scene(7, wrong=0.96, count=2500)
        self.assertEqual(verified(scene, maxIterations=40).configuration, Configuration.DEGENERATE)
        for higher in (True, False):
            scores = np.where(scene.right == higher, 0.9, 0.1) + np.random.RandomState(1).uniform(-.05, .05, 2500)
            for turned, expected in ((False, Configuration.CALIBRATED), (True, Configuration.DEGENERATE)):
                pair = scene.pair._replace(scores=scores, higherIsBetter=higher != turned)
                self.assertEqual(verifyPairs([pair], Settings(threshold=2, maxIterations=40))[0].configuration, expected)

    def test_points_that_are_no_numbers(self):
        scene = Scene(1)
        points = scene.pair.first.points.copy()
        points[::10] = np.nan
        result = verifyPairs([scene.pair._replace(first=scene.pair.first._replace(points=points))], Settings(threshold=2))[0]
        self.assertEqual(result.configuration, Configuration.CALIBRATED)
        self.assertFalse(scene.marked(result)[::10].any())
        self.assertLess(scene.errors(result).max(), 1.)

    def test_what_stands_beside_a_pair_does_not_matter(self):
        pairs = [Scene(seed, planar=seed % 2, known=seed % 3 > 0, wrong=0.1 * (seed % 11), key=seed).pair for seed in range(12)]
        settings = Settings(threshold=2)
        together = verifyPairs(pairs, settings)
        alone = [verifyPairs([pair], settings)[0] for pair in pairs[::-1]][::-1]
        again = verifyPairs(pickle.loads(pickle.dumps(pairs)), pickle.loads(pickle.dumps(settings)))
        for first, *others in zip(together, alone, again):
            for other in others:
                for name in first._fields:
                    if name != "milliseconds":
                        np.testing.assert_array_equal(getattr(first, name), getattr(other, name), err_msg=name)
        self.assertGreater(len({result.configuration for result in together}), 3)
        self.assertEqual(verifyPairs([], settings), [])

    def test_where_the_limit_of_the_samples_cuts(self):
        """The numbers in the comment of Settings.maxIterations must be right."""
        default = Settings()
        cut = [[matches for matches in range(15, 500) if default.needed(sample, matches) > default.maxIterations]
               for sample in (5, 7, 4)]
        self.assertEqual(cut, [[], list(range(44, 500)), []])
        for matches, reached in ((60, 0.49), (300, 0.86), (2000, 0.91)):
            self.assertAlmostEqual(default.reached(7, matches), reached, delta=0.005)
        for ratio, matches in ((0.33, 60), (0.295, 10**5)):
            self.assertLessEqual(Settings(inlierRatio=ratio).needed(7, matches), default.maxIterations)
            self.assertGreater(Settings(inlierRatio=ratio - 0.03).needed(7, matches), default.maxIterations)
        self.assertLess(Settings(ratios=(0.45,) * 9).needed(5, 80), default.needed(5, 80))
        self.assertEqual(Settings(maxIterations=20).iterations(5, 300), 20)

    def test_a_refused_pair_says_that_the_limit_has_cut(self):
        found = verified(Scene(3, wrong=1, count=75), method="USACV20_FAST")
        self.assertRegex(found.reason, r"^E: .*; all 10000 samples drawn, confidence 0\.9988 for E$")
        self.assertRegex(verified(Scene(3, wrong=1, count=75, known=False)).reason, "^F: .* confidence 0.6377 for F$")
        self.assertNotIn("confidence", verified(Scene(3, wrong=1, count=30)).reason)

    def test_mistakes(self):
        for settings, said in (({"threshold": -1}, "threshold"), ({"threshold": float("nan")}, "threshold"),
                               ({"method": "RANSAC"}, "method: one of USACV20, "), ({"confidence": 2}, "confidence"),
                               ({"method": "USACV20_PROSAC"}, "method: "),
                               ({"maxIterations": 0}, "maxIterations"), ({"minInliers": 0}, "min-inliers"),
                               ({"ratios": (0.5, 0.0)}, "ratios"),
                               ({"planarRatio": 2}, "planarRatio"), ({"significance": -1}, "significance"),
                               ({"significance": 0.0}, "significance: a number above 0 ")):
            with self.assertRaisesRegex(CollectionError, said):
                Settings(**settings)

    def test_quaternions(self):
        rng = np.random.RandomState(2)
        vectors = list(rng.normal(size=(50, 3))) + [np.pi * np.eye(3)[i] for i in range(3)] + [np.zeros(3)]
        for vector in vectors:
            R = rotationOf(vector)
            q = quaternion(R)
            self.assertAlmostEqual(np.linalg.norm(q), 1, places=12)
            self.assertGreaterEqual(q[0], 0)
            np.testing.assert_allclose(matrixOf(q), R, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
