#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the estimation of one inlier threshold for a collection from the noise of its matches
(--threshold auto). Noise and thresholds are in pixels."""

import math
import unittest

import numpy as np

from usac_common import IN_TREE, once, package

if not IN_TREE:
    from usac_collection_noise import NONE, NoisyPair, noisyPairs
    from usacv20.collection import _threshold as threshold
    from usacv20.collection._pair import Fault, Pair, View
    from usacv20.collection._settings import Settings
    from usacv20.collection._threshold import IN_SIGMAS, QUANTILE, estimateThreshold, samplePairs


def estimate(scenes, **settings):
    return estimateThreshold([scene.pair for scene in scenes], Settings(**settings))


@once
@package
class NoiseTest(unittest.TestCase):

    def assertNoise(self, found, sigma, part):
        self.assertLess(abs(math.log(found.sigma / sigma)), math.log(1 + part), found)

    def test_noise_and_size_of_image(self):
        for size, sigma in (((640, 480), 0.3), ((1600, 1200), 1), ((6000, 4000), 3)):
            with self.subTest(size=size, sigma=sigma):
                found = estimate(noisyPairs(1, 24, size=size, sigma=sigma, matches=300))
                self.assertNoise(found, sigma, 0.1)
                self.assertLess(abs(found.threshold / (IN_SIGMAS * sigma) - 1), 0.12)
        self.assertEqual(estimate(noisyPairs(9, 12, none=0, sigma=0.0, matches=300)).threshold, threshold.SMALLEST)

    def test_unknown_focal_lengths(self):
        scenes = noisyPairs(2, 24, known=False, matches=300)
        self.assertNoise(estimate(scenes), 1, 0.1)
        mixed = scenes + noisyPairs(3, 24, known=True, matches=300)
        self.assertNoise(estimate(mixed), 1, 0.1)

    def test_focal_lengths_that_are_not_known_are_not_used(self):
        scenes = noisyPairs(2, 16, none=0, known=False, matches=300)
        wrong = [scene.pair._replace(first=scene.pair.first._replace(matrix=np.diag([9000., 9000, 1]))) for scene in scenes]
        self.assertEqual(estimateThreshold(wrong, Settings()), estimate(scenes))

    def test_most_pairs_without_overlap(self):
        scenes = noisyPairs(5, 60, none=0.9)
        right = sum(scene.kind != NONE for scene in scenes)
        found = estimate(scenes)
        self.assertNoise(found, 1, 0.15)
        self.assertEqual(found.asked, 60)
        self.assertLessEqual(found.used, right)
        self.assertGreaterEqual(found.used, right - 1)

    def test_no_pair_tells(self):
        """If no pair gives an estimate of the noise, the threshold must be that of COLMAP (4 pixels),
        and the description must say so."""
        scenes = noisyPairs(6, 40, none=1.0)
        few = [NoisyPair(i, matches=12, wrong=0) for i in range(5)]
        for given in ([], few, scenes):
            found = estimate(given)
            self.assertEqual((found.threshold, found.used, found.asked), (4.0, 0, len(given)))
            self.assertRegex(found.describe(), "^4 px, COLMAP's, as none of {} pairs .* --threshold PIXELS".format(len(given)))

    def test_pairs_that_cannot_be_used_do_not_count(self):
        scenes = noisyPairs(7, 12, none=0, matches=300)
        a, b = scenes[0].pair.first, scenes[0].pair.second
        broken = [scenes[0].pair._replace(first=a._replace(points=points), second=b._replace(points=b.points[:len(points)]))
                  for points in (np.full((300, 2), np.nan), np.zeros((300, 2)), np.empty((0, 2)))]
        alone, beside = estimate(scenes), estimateThreshold([scene.pair for scene in scenes] + broken, Settings())
        self.assertEqual((beside.threshold, beside.used, beside.asked), (alone.threshold, alone.used, alone.asked + 3))

    def test_heavy_tails_count(self):
        """The noise has a heavy tail. The threshold must be a quantile of the errors of all right
        matches, not a multiple of the standard deviation of the accurately located ones."""
        scenes = noisyPairs(8, 40, none=0, heavy=0.8, matches=600, size=(6000, 4000))
        rng = np.random.RandomState(1)
        factors = np.exp(rng.normal(0, 0.8, (10**6, 2)))  # standard deviations of the noise of the two keypoints of each match
        true = np.quantile(np.abs(rng.normal(0, 1, 10**6)) * np.sqrt((factors**2).mean(axis=1)), QUANTILE)
        found = estimate(scenes)
        self.assertLess(abs(found.threshold / true - 1), 0.25)
        self.assertGreater(found.threshold, 1.4 * IN_SIGMAS)

    def test_sentence(self):
        found = estimate(noisyPairs(11, 16, none=0, matches=200))
        self.assertRegex(found.describe(), r"^{:g} px, .* {:.3g} px .*{} of 16 pairs.* {:.0f} %".format(
            found.threshold, found.sigma, found.used, 100 * found.spread).replace(" %", " ?%"))
        self.assertEqual(found.threshold, float("{:.3g}".format(found.threshold)))
        self.assertGreater(found.spread, 0)
        for count in (1, 3):
            found = estimate([NoisyPair(seed, "general", matches=300) for seed in range(count)])
            self.assertEqual((found.used, "may be wrong" in found.describe()), (count, count < 3))


class Store(object):
    """A source of pairs without points. It counts the passes over the keys and the pairs that are
    read, and stores the largest number of pairs read in one call."""

    def __init__(self, keys, matches=lambda key: 60, faults=()):
        self.order, self.matches, self.faults = list(keys), matches, faults
        self.largest = self.read = self.passes = 0

    def keys(self):
        self.passes += 1
        return iter(self.order)

    def __len__(self):
        return len(self.order)

    def load(self, keys):
        self.largest = max(self.largest, len(keys))
        self.read += len(keys)
        none = np.empty((0, 2))
        view = View("", none, none, np.eye(3), False, 0, 0)
        return [Fault(key, "broken") if key in self.faults else Pair(
            key, view, view, np.zeros((self.matches(key), 2), np.uint32), None, False) for key in keys]

    def fingerprint(self):
        return ""


@once
@package
class SampleTest(unittest.TestCase):

    def chosen(self, keys, count=20, **options):
        return [pair.key for pair in samplePairs(Store(keys, **options), count)]

    def test_order_does_not_matter(self):
        for keys in (list(range(1000)), ["a{}.jpg b{}.jpg".format(i, i + 1) for i in range(1000)]):
            found = self.chosen(keys)
            self.assertEqual(len(set(found)), 20)
            self.assertEqual(found, self.chosen(keys[::-1]))
        self.assertEqual(self.chosen(range(10), 3), [6, 2, 4])  # the same in all processes
        self.assertEqual(self.chosen([np.int64(i) for i in range(10)], 3), [6, 2, 4])
        self.assertEqual(sorted(self.chosen(range(7))), list(range(7)))

    def test_which_are_preferred(self):
        for rate, expected in ((5, 20), (20, 9)):  # many matches, but in the second collection there are too few such pairs
            found = self.chosen(range(1000), matches=lambda key: 500 if key % rate == 0 else 20)
            self.assertEqual((len(found), sum(key % rate == 0 for key in found)), (20, expected))
        found = self.chosen(range(100), faults=set(range(0, 100, 2)))
        self.assertEqual([key % 2 for key in found], [1] * 20)
        self.assertEqual(self.chosen(range(100), faults=set(range(100))), [])

    def test_not_more_is_read_than_needed(self):
        store = Store(range(100000))
        samplePairs(store, 100)
        self.assertEqual((store.passes, store.read), (1, 100))
        store = Store(range(100000), matches=lambda key: 0)
        self.assertEqual(len(samplePairs(store, 100)), 100)
        self.assertEqual((store.passes, store.read), (1, 100 * threshold.MORE))
        self.assertLessEqual(store.largest, threshold.CHUNK)


if __name__ == "__main__":
    unittest.main()
