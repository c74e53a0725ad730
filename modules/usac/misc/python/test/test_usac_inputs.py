#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests that points, camera matrices and distortion coefficients can be arrays of many types and
memory layouts, and that wrong arrays are refused. Also tests of extreme values of Params."""

import unittest

import numpy as np

from usac_common import DISTORTED, FINDER, GENERAL, PLANE, bits, usac


def readOnly(array):
    result = array.copy()
    result.setflags(write=False)
    return result


def essential(K1, K2=None, d1=None, d2=None, scene=GENERAL):
    return usac.estimateEssential(scene.points1, scene.points2, K1, K2, d1, d2, usac.Params())[:2]


class PointsTest(unittest.TestCase):

    def test_every_depth(self):
        a, b = np.clip(np.rint(PLANE.points1 / 6), 0, 127), np.clip(np.rint(PLANE.points2 / 6), 0, 127)
        expected = usac.estimateHomography(a, b, usac.Params())[:2]
        self.assertIsNotNone(expected[0])
        for kind in (np.uint8, np.int8, np.uint16, np.int16, np.int32, np.float32, np.float64):
            for p, q in ((a.astype(kind), b.astype(kind)), (a.astype(kind)[:, None], b), (a, b.astype(kind)[None])):
                self.assertEqual(bits(usac.estimateHomography(p, q, usac.Params())[:2]), bits(expected), kind)

    def test_read_only_arrays(self):
        a, b, K, d = (readOnly(x) for x in (DISTORTED.points1, DISTORTED.points2, DISTORTED.K1, DISTORTED.d1))
        for flag in (usac.USACV20, usac.USACV20_MAGSAC):
            self.assertEqual(bits(FINDER.findHomography(a, b, flag)),
                             bits(FINDER.findHomography(DISTORTED.points1, DISTORTED.points2, flag)))
        self.assertEqual(bits(usac.estimateEssential(a, b, K, K, d, d, usac.Params())[:2]),
                         bits(essential(DISTORTED.K1, DISTORTED.K1, DISTORTED.d1, DISTORTED.d1, DISTORTED)))

    def test_rows_that_are_not_finite(self):
        for bad in (np.nan, np.inf, -np.inf, 1e30, -1e300):
            a, b = PLANE.points1.copy(), PLANE.points2.copy()
            a[::5, 0] = bad
            b[2::5, 1] = bad
            model, mask, report = usac.estimateHomography(a, b, usac.Params())
            self.assertLess(PLANE.error("Homography", model), 1.0, bad)
            self.assertEqual(int(mask[::5].sum() + mask[2::5].sum()), 0, bad)
            self.assertEqual(report.inliers, int(mask.sum()))


class CameraTest(unittest.TestCase):

    def test_every_kind(self):
        K = GENERAL.K1
        wide = np.zeros((5, 7), np.float32)
        wide[1:4, 2:5] = K
        expected = bits(essential(K))
        for other in (np.float32(K), np.int32(K), np.asfortranarray(K), wide[1:4, 2:5], np.repeat(K, 2, axis=1)[:, ::2]):
            self.assertEqual(bits(essential(other)), expected)
            self.assertEqual(bits(essential(K, other)), expected)

    def test_wrong(self):
        K = GENERAL.K1
        for wrong in (K.T, K * 0, np.eye(4), np.full((3, 3), np.nan), K[:2], K[None, None]):
            with self.assertRaises(usac.error) as context:
                essential(wrong)
            self.assertIn("cameraMatrix1", str(context.exception))
            with self.assertRaises(usac.error) as context:
                essential(K, wrong)
            self.assertIn("cameraMatrix2", str(context.exception))

    def test_distortion(self):
        K, d = DISTORTED.K1, DISTORTED.d1
        expected = bits(essential(K, K, d, d, DISTORTED))
        for other in (d[None], d[:, None], np.hstack([d, np.zeros(3)]), np.hstack([d, np.zeros(9)]), np.repeat(d, 2)[::2]):
            self.assertEqual(bits(essential(K, K, other, other, DISTORTED)), expected)
        for length in (4, 5, 8, 12, 14):
            self.assertEqual(bits(essential(K, K, np.zeros(length))), bits(essential(K)))
        for wrong in (np.zeros(3), np.ones(6), np.full(5, np.nan), np.zeros((2, 2))):
            with self.assertRaises(usac.error) as context:
                essential(K, K, None, wrong)
            self.assertIn("distCoeffs2", str(context.exception))


class ParameterTest(unittest.TestCase):

    def test_extremes(self):
        for threshold in (1e-300, 1e-9, 1e9, 1e300):
            for preset in ("usacV20", "lmeds", "magsac", "magsacPlusPlus", "mlesac"):
                params = getattr(usac.Params, preset)()
                params.threshold, params.maxIterations, params.confidence = threshold, 50, 1 - 1e-16
                model, mask, report = usac.estimateHomography(PLANE.points1, PLANE.points2, params)
                self.assertEqual(mask.shape, (len(PLANE.points1), 1))
                self.assertEqual(report.inliers, int(mask.sum()))
                self.assertEqual(model is None, report.inliers == 0)
                self.assertLessEqual(report.iterations, 50)
                self.assertTrue(np.isfinite([report.cost, report.chance, report.threshold]).all())


if __name__ == "__main__":
    unittest.main()
