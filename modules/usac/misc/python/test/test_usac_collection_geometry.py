#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the collection tool's verification of single image pairs: configuration (calibrated,
planar, ...), relative pose, inliers and number of samples."""

import itertools
import math
import pickle
import re
import unittest

import numpy as np

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


def rotationOf(vector):
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def matrixOf(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


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


def rightSamples(sample, matches, right):
    """Returns the probability that a sample of `sample` matches, drawn without replacement, has only
    right matches; `right` of all `matches` matches are right."""
    part = 1.0
    for i in range(sample):
        part *= (right - i) / (matches - i)
    return part


def missedBySample(sample, matches, ratio):
    """Returns the logarithm of the probability that a sample for E does not lead to the model of a pair
    with this inlier ratio. A sample counts as one to four samples, because local optimization also
    finds models from samples with an outlier."""
    counted = min(max((ratio * matches / 11.5)**2, 1), 4)
    return counted * math.log1p(-rightSamples(sample, matches, math.ceil(ratio * matches - 1e-9)))


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
        for seed in range(5):
            scene = Scene(seed)
            result = verified(scene)
            self.check(scene, result, Configuration.CALIBRATED)
            K1 = np.linalg.inv(K)
            F = K1.T @ result.E @ K1
            np.testing.assert_allclose(result.F, F / np.linalg.norm(F), atol=1e-12)
            ones = np.ones((len(scene.matches), 1))
            x1, x2 = np.hstack([scene.pair.first.points, ones]), np.hstack([scene.pair.second.points, ones])
            a, b = x1 @ result.F.T, x2 @ result.F
            distance = np.abs((x2 * a).sum(axis=1)) / np.sqrt((a[:, :2]**2).sum(axis=1) + (b[:, :2]**2).sum(axis=1))
            np.testing.assert_array_equal(distance <= 2, scene.marked(result))

    def test_each_of_the_four_motions(self):
        for move in ((1., 0, 0), (-1., 0, 0), (0, 0, 1.5), (0, 0, -1.5), (0, 1., 0)):
            for turn in ((0, 0, 0), (0, 0, 1.), (0, 0, 3.), (0.1, 0.1, -2.)):
                scene = Scene(3, turn=turn, move=move)
                self.check(scene, verified(scene), Configuration.CALIBRATED, 2.)

    def test_focal_length_not_known(self):
        result = verified(Scene(2, known=False))
        self.check(Scene(2), result, Configuration.UNCALIBRATED)
        self.assertIsNone(result.E)
        self.assertIsNone(result.quaternion)
        self.assertIsNone(result.translation)
        self.assertIsNotNone(result.F)

    def test_one_focal_length_not_known(self):
        scene = Scene(2)
        pair = scene.pair._replace(second=scene.pair.second._replace(focalKnown=False))
        self.assertEqual(verifyPairs([pair], Settings(threshold=2))[0].configuration, Configuration.UNCALIBRATED)

    def test_samples_by_the_other_pairs(self):
        """If the inlier ratios of some pairs of the collection are known, the number of samples must be
        the smallest (but at least 500) with which the model of a random pair is found with probability
        `confidence`. The random pair is, with equal probabilities, any of these pairs or one further
        pair with a lower ratio."""
        plain = Settings()
        self.assertEqual(Settings(ratios=(0.25,) * 9).needed(5, 80), plain.needed(5, 80))
        self.assertEqual(Settings(ratios=(0.1, 0.2)).needed(5, 80), plain.needed(5, 80))
        before = plain.needed(5, 80)
        for count in (1, 10, 100):
            settings = Settings(ratios=(0.45,) * count)
            needed = settings.needed(5, 80)
            self.assertLess(needed, before)
            # The further pair is represented by eight ratios between 0.25 and 0.45, each with an eighth
            # of the weight of a pair.
            tail = [0.25 + 0.2 * (i + 0.5) / 8 for i in range(8)]
            logs = np.array([missedBySample(5, 80, ratio) for ratio in [0.45] * count + tail])
            weights = np.array([1.] * count + [1 / 8] * 8) / (count + 1)
            self.assertLessEqual(weights @ np.exp(needed * logs), 0.001)
            self.assertTrue(needed == 500 or weights @ np.exp((needed - 2) * logs) > 0.001)
            before = needed
        self.assertEqual(Settings(ratios=(0.9,) * 3, inlierRatio=0.9).needed(5, 80), 500)
        with self.assertRaisesRegex(CollectionError, "ratios"):
            Settings(ratios=(0.5, 0.0))

    def test_samples_that_count_more_than_once(self):
        """For E and F, a sample of USACV20 counts as up to four samples, because models are also
        found from samples with an outlier. The resulting smaller number of samples must still find a
        model for each of 100 pairs with an inlier ratio of 0.25, as a larger number does."""
        settings = Settings(threshold=1)
        full = math.log(0.001) / math.log1p(-rightSamples(5, 200, 50))
        self.assertLess(settings.needed(5, 200), full / 3.9)
        self.assertEqual(settings.needed(5, 60), math.ceil(math.log(0.001) / math.log1p(-rightSamples(5, 60, 15)) / (15 / 11.5)**2))
        self.assertEqual(settings.needed(7, 200), math.ceil(math.log(0.001) / math.log1p(-rightSamples(7, 200, 50)) / 4))
        self.assertEqual(Settings(method="USACV20_FAST", threshold=1).needed(5, 200), math.ceil(full))
        pairs = []
        for seed in range(100):
            pair = Scene(1000 + seed, count=200, wrong=0).pair
            pair.second.points[50:] = np.random.RandomState(seed).uniform(0, SIZE, (150, 2))  # inlier ratio 0.25
            pairs.append(pair)
        found = [[result.configuration for result in verifyPairs(pairs, Settings(threshold=1, **options))]
                 for options in ({}, {"maxIterations": 10000, "inlierRatio": 0.18}, {"maxIterations": 1000})]
        for configurations in found:
            self.assertNotIn(Configuration.DEGENERATE, configurations)
            # With 1000 samples, the first search for E finds a worse model than F for 6 pairs. E is
            # then searched for again, starting from F.
            self.assertGreaterEqual(configurations.count(Configuration.CALIBRATED), 99)
        # Pairs with unknown focal lengths, so that only F is estimated; the inlier ratio is 0.4.
        scenes = [Scene(2000 + seed, count=100, wrong=0, known=False) for seed in range(60)]
        for seed, scene in enumerate(scenes):
            scene.pair.second.points[40:] = np.random.RandomState(seed).uniform(0, SIZE, (60, 2))
        for options in ({}, {"method": "USACV20_FAST"}):  # FAST: four times as many samples, but a weaker local optimization
            results = verifyPairs([scene.pair for scene in scenes], Settings(threshold=1, inlierRatio=0.4, **options))
            self.assertLessEqual(sum(len(result.inliers) == 0 for result in results), 1)

    def test_fundamental_matrix_alone(self):
        """All matches are wrong. If E is refused, F must be searched for with only about 500 samples,
        and must be refused, too. The search for E draws at most as many samples as the search for F of
        a pair with an unknown focal length."""
        for seed in range(6):
            pair = Scene(seed, wrong=1.0, count=300).pair
            known = verifyPairs([pair], Settings(threshold=2, maxIterations=2000))[0]
            unknown = verifyPairs([pair._replace(first=pair.first._replace(focalKnown=False))],
                                  Settings(threshold=2, maxIterations=2000))[0]
            self.assertEqual(known.configuration, Configuration.DEGENERATE)
            self.assertLessEqual(known.iterations, unknown.iterations + 500 + 50)

    def test_one_chance(self):
        """The result of a refused pair has a reason and the false-alarm probability `chance`. If the
        reason also contains a probability, both must belong to the same model and must be equal."""
        seen = 0
        for seed in range(12):
            result = verifyPairs([Scene(seed, wrong=1.0, count=80).pair], Settings(threshold=2, maxIterations=300))[0]
            match = re.search("with a chance of ([^;]+)", result.reason)
            if match:
                self.assertEqual("{:.2g}".format(result.chance), match.group(1))
                seen += 1
        self.assertGreater(seen, 3)

    def test_wrong_focal_length(self):
        scene = Scene(2, focal=0.4, count=1000)
        result = verified(scene)
        self.check(scene, result, Configuration.UNCALIBRATED)
        self.assertIsNone(result.quaternion)

    def test_plane(self):
        for seed in range(5):
            scene = Scene(seed, planar=1)
            result = verified(scene)
            # Points of a plane determine E only weakly, and the search chooses the E that fits the
            # most matches. Therefore 2.7 % of the wrong matches are inliers of the estimated E
            # (mean of 40 seeds; at most 5.3 %). For the true E, 0.8 % are inliers (at most 3.5 %).
            self.check(scene, result, Configuration.PLANAR, None, wrong=0.08)
            # A plane is compatible with two motions. E must belong to the returned motion.
            cross = np.cross(np.eye(3), result.translation)
            E = -cross @ matrixOf(result.quaternion)
            self.assertAlmostEqual(abs(np.sum(E * result.E)), np.sqrt(2), places=6)
            right = scene.right
            moved = np.c_[scene.pair.first.points[right], np.ones(right.sum())] @ result.H.T
            error = np.linalg.norm(moved[:, :2] / moved[:, 2:] - scene.pair.second.points[right], axis=1)
            self.assertGreater(np.mean(error < 2), 0.9)

    def test_most_on_a_plane(self):
        scene = Scene(3, planar=0.9, count=500)
        self.check(scene, verified(scene), Configuration.PLANAR, 2.)
        scene = Scene(3, planar=0.6, count=500)
        self.check(scene, verified(scene), Configuration.CALIBRATED, 2.)

    def test_rotation(self):
        for turn in ((0.02, -0.2, 0.05), (0, 0.1, 0), (0, 0, 1.5)):
            scene = Scene(4, turn=turn, move=(0., 0, 0))
            result = verified(scene)
            self.check(scene, result, Configuration.PANORAMIC, wrong=0.08)  # E is weakly determined, as in test_plane
            np.testing.assert_array_equal(result.translation, [0, 0, 0])
            angle = (np.trace(matrixOf(result.quaternion).T @ scene.R) - 1) / 2
            self.assertLess(np.degrees(np.arccos(min(1, angle))), 0.1)

    def test_plane_of_cameras_not_known(self):
        for planar, move in ((1, (-1., .2, .1)), (0, (0., 0, 0))):
            result = verified(Scene(4, planar=planar, move=move, known=False))
            self.assertEqual(result.configuration, Configuration.PLANAR_OR_PANORAMIC)
            self.assertIsNone(result.quaternion)

    def test_no_overlap(self):
        kept = 0
        for seed in range(50):
            result = verified(Scene(seed, wrong=1., known=seed % 2 == 0))
            kept += result.configuration != Configuration.DEGENERATE
            if result.configuration == Configuration.DEGENERATE:
                self.assertEqual((len(result.inliers), result.F, result.E, result.H), (0, None, None, None))
                self.assertRegex(result.reason, "^[EFH]: .+")
        self.assertEqual(kept, 0)

    def test_few_matches(self):
        self.assertEqual(verified(Scene(1, count=14)).reason, "14 matches, 15 are needed")
        self.assertEqual(verified(Scene(1, count=0)).reason, "0 matches, 15 are needed")
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
            pair = scene.pair._replace(scores=scores, higherIsBetter=higher)
            ranked = verifyPairs([pair], Settings(threshold=2, maxIterations=40))[0]
            self.assertEqual(ranked.configuration, Configuration.CALIBRATED)
            self.assertGreater(scene.marked(ranked)[scene.right].mean(), 0.95)
            turned = verifyPairs([pair._replace(higherIsBetter=not higher)], Settings(threshold=2, maxIterations=40))[0]
            self.assertEqual(turned.configuration, Configuration.DEGENERATE)

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

    def test_methods(self):
        for method in ("USACV20_FAST", "USACV20_ACCURATE", "USACV20_MAGSAC"):
            scene = Scene(1, wrong=0.2)
            self.check(scene, verified(scene, method=method), Configuration.CALIBRATED, 2.)

    def test_samples_that_keep_a_pair(self):
        """There are so few matches that all possible samples can be enumerated; the first `right`
        matches are right. The number of samples to draw must follow from the fraction of the possible
        samples that have only right matches."""
        for sample, matches, ratio, right in ((4, 12, 0.5, 6), (5, 14, 0.36, 6), (7, 16, 0.5, 8), (5, 15, 0.01, 5), (5, 10, 0.1, 5)):
            settings = Settings(inlierRatio=ratio, minInliers=1, confidence=0.99999, maxIterations=10**9, method="USACV20_FAST")
            samples = list(itertools.combinations(range(matches), sample))
            part = sum(max(chosen) < right for chosen in samples) / len(samples)
            needed = next(n for n in itertools.count(500) if 1 - (1 - part)**n >= settings.confidence)
            self.assertEqual(settings.iterations(sample, matches), needed)
            self.assertAlmostEqual(settings.reached(sample, matches), 1 - (1 - part)**needed, places=12)
        # For 75 matches and an inlier ratio of 0.25, at least 19 matches are right. 7070 samples would
        # be enough if each drawn match were right with probability 0.25. But matches are drawn without
        # replacement, so 7070 samples reach only a confidence of 0.9915, and more are needed.
        part = math.factorial(19) * math.factorial(70) / (math.factorial(14) * math.factorial(75))
        wide = Settings(maxIterations=20000, method="USACV20_FAST")  # USACV20_FAST: each sample counts once
        self.assertEqual(wide.iterations(5, 75), math.ceil(math.log(0.001) / math.log(1 - part)))
        self.assertEqual(wide.iterations(5, 75), 10250)
        self.assertAlmostEqual(Settings(maxIterations=7070, method="USACV20_FAST").reached(5, 75), 0.9915, places=4)
        # The number of right matches must be 7, although 0.07 * 100 is slightly above 7 in floating
        # point and the number is rounded up.
        self.assertEqual(Settings(inlierRatio=0.07, minInliers=1).needed(4, 100),
                         Settings(inlierRatio=0, minInliers=7).needed(4, 100))
        # First: minInliers is used if it is larger than ratio * matches. Second: if all 15 matches
        # must be right, the minimum of 500 samples is enough. Third: maxIterations is the limit.
        self.assertEqual(wide.needed(5, 24), Settings(inlierRatio=15 / 24, method="USACV20_FAST").needed(5, 24))
        self.assertEqual((wide.needed(7, 15), wide.reached(7, 15)), (500, 1))
        self.assertEqual(Settings(maxIterations=20).iterations(5, 300), 20)

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

    def test_a_refused_pair_says_that_the_limit_has_cut(self):
        random = Scene(3, wrong=1, count=75)
        fast = dict(method="USACV20_FAST")
        found = verified(random, **fast)
        self.assertEqual(found.configuration, Configuration.DEGENERATE)
        self.assertRegex(found.reason, r"^E: .*; all 10000 samples drawn, confidence 0\.9988 for E$")
        unknown = random.pair._replace(first=random.pair.first._replace(focalKnown=False))
        self.assertRegex(verifyPairs([unknown], Settings(threshold=2))[0].reason, r"all 10000 samples drawn, confidence 0\.6377 for F$")
        self.assertNotIn("confidence", verified(random, maxIterations=300000, **fast).reason)
        self.assertNotIn("confidence", verified(random, maxIterations=10250, **fast).reason)
        self.assertRegex(verifyPairs([unknown], Settings(threshold=2, maxIterations=10250))[0].reason, r"confidence 0\.6468 for F$")
        self.assertRegex(verified(Scene(3, wrong=1, count=75, known=False)).reason, "^F: .* confidence 0.6377 for F$")
        self.assertNotIn("confidence", verified(Scene(3, wrong=1, count=30)).reason)

    def test_mistakes(self):
        for settings, said in (({"threshold": -1}, "threshold"), ({"threshold": float("nan")}, "threshold"),
                               ({"method": "RANSAC"}, "method: one of USACV20, "), ({"confidence": 2}, "confidence"),
                               ({"method": "USACV20_PROSAC"}, "method: "),
                               ({"maxIterations": 0}, "maxIterations"), ({"minInliers": 0}, "min-inliers"),
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
