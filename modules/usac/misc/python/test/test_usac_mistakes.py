#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of common mistakes of callers, and of unusual but valid arguments. A wrong value must raise
usacv20.error with the name of the argument. A wrong number of arguments or an unknown name must
raise TypeError. Valid arguments must be accepted."""

import unittest

import numpy as np

from usac_common import DISTORTED, FINDER, GENERAL, PLANE, RANSAC, bits, usac
from usac_pose import POSE


class MistakeCase(unittest.TestCase):

    def refused(self, word, function, *args, **kwargs):
        with self.assertRaises(usac.error, msg="{} {}".format(word, sorted(kwargs))) as context:
            function(*args, **kwargs)
        message = str(context.exception)
        self.assertRegex(message, word)
        self.assertLess(len(message), 400)


class CallTest(MistakeCase):
    """Tests of arguments at wrong positions, of wrong scalars, and of Params together with other
    options."""

    def test_number_behind_params(self):
        a, b, p = GENERAL.points1, GENERAL.points2, usac.Params()
        self.refused("mask", usac.findFundamentalMat, a, b, p, 3.0)
        self.refused("mask", FINDER.findFundamentalMat, a, b, p, 3.0)
        self.refused("mask", usac.findHomography, a, b, p, 3)
        self.refused("inliers", usac.estimateAffine2D, a, b, p, 3.0)
        self.refused("mask", usac.findEssentialMat, a, b, GENERAL.K1, p, 0.99)
        self.refused("mask", usac.estimateHomography, a, b, p, 3.0)

    def test_numbers_beside_params(self):
        a, b, K, p = GENERAL.points1, GENERAL.points2, GENERAL.K1, usac.Params()
        for name, function, args in (
                ("maxIters", usac.findHomography, (a, b)), ("ransacReprojThreshold", usac.findHomography, (a, b)),
                ("confidence", usac.findFundamentalMat, (a, b)), ("prob", usac.findEssentialMat, (a, b, K)),
                ("threshold", usac.findEssentialMat, (a, b, K)), ("refineIters", usac.estimateAffine2D, (a, b))):
            self.refused(name, function, *args, method=p, **{name: 5})
        self.refused("reprojectionError", usac.solvePnPRansac, POSE.X, POSE.x, POSE.K, POSE.d, flags=p, reprojectionError=1.0)
        self.refused("params", usac.findHomography, a, b, method=usac.USACV20, params=p)
        self.refused("params", usac.findEssentialMat, a, b, K, method=usac.USACV20, params=p)

    def test_params_in_no_place(self):
        a, b, p = GENERAL.points1, GENERAL.points2, usac.Params()
        self.refused("Params", usac.findHomography, a, b, usac.USACV20, p)
        self.refused("srcPoints", usac.findHomography, p, a)
        self.refused("cameraMatrix", usac.findEssentialMat, a, b, p)
        # In this position the flag, the integer 16384, would be a focal length.
        self.refused("cameraMatrix", usac.findEssentialMat, a, b, usac.USACV20)
        self.refused("Params", usac.solvePnPRansac, POSE.X, POSE.x, POSE.K, p)
        self.refused("params", usac.estimateHomography, a, b, usac.USACV20)
        self.refused("cameraMatrix2", usac.estimateEssential, a, b, GENERAL.K1, p, None, None, p)
        mask = np.zeros((len(a), 1), np.uint8)
        self.refused("cameraMatrix2", usac.estimateEssential, a, b, GENERAL.K1, p, distCoeffs1=np.zeros(5), mask=mask)

    def test_shape_of_a_call(self):
        a, b, K, p = GENERAL.points1, GENERAL.points2, GENERAL.K1, usac.Params()
        for word, args, kwargs in (("dstPoints", (a,), {}), ("srcPoints", (), {}), ("nonsense", (a, b), dict(nonsense=1)),
                                   ("srcPoints", (a, b), dict(srcPoints=a)), ("at most 7", (a, b, 8, 1, None, 5, 0.9, 1), {}),
                                   ("at most 4", (a, b, p, None, 1), {})):
            with self.assertRaisesRegex(TypeError, word):
                usac.findHomography(*args, **kwargs)
        for args in ((a,), (a, b, K, None, K, None, 8, 1, 1, None, 1)):
            self.assertRaises(TypeError, usac.findEssentialMat, *args)
        self.assertRaises(TypeError, usac.Params, treshold=2)
        self.assertRaises(TypeError, usac.Params, 2.0)

    def test_numbers(self):
        a, b, K = GENERAL.points1, GENERAL.points2, GENERAL.K1
        for word, function, args, kwargs in (
                ("method", usac.findHomography, (a, b, "USACV20"), {}), ("method", usac.findHomography, (a, b, 16384.0), {}),
                ("method", usac.findFundamentalMat, (a, b, 2**40), {}), ("method", usac.findHomography, (a, b, True), {}),
                ("ransacReprojThreshold", usac.findHomography, (a, b, 16384, "3"), {}),
                ("ransacReprojThreshold", usac.findHomography, (a, b, 16384, a), {}),
                ("maxIters", usac.findHomography, (a, b), dict(maxIters=2.5)),
                ("maxIters", usac.findHomography, (a, b), dict(maxIters=2**31)),
                ("confidence", usac.findFundamentalMat, (a, b), dict(confidence="0.9")),
                ("pp", usac.findEssentialMat, (a, b, 1.0, 3.0), {}), ("pp", usac.findEssentialMat, (a, b, 1.0, (1, "2")), {}),
                ("focal", usac.findEssentialMat, (a, b), dict(focal=K)),
                ("useExtrinsicGuess", usac.solvePnPRansac, (POSE.X, POSE.x, K, None, None, None, "no"), {}),
                ("flags", usac.solvePnPRansac, (POSE.X, POSE.x, K, None), dict(flags="USACV20")),
                ("ransacReprojThreshold", usac.findHomography, (a, b, 16384, 10**400), {}),
                ("focal", usac.findEssentialMat, (a, b), dict(focal=10**400)), ("maxTime", usac.Params, (), dict(maxTime=10**5000)),
                ("inlierRatio", usac.TwoViewRules(inlierRatio=10**400).check, (), {}),
                ("seed", usac.Params, (), dict(seed=10**5000)), ("problem", usac.fitModel, (10**400, a, b), {})):
            self.refused(word, function, *args, **kwargs)
        self.assertEqual(bits(usac.findHomography(a, b, np.array(usac.USACV20), np.float32(3), None, np.uint8(200), np.array(0.5))),
                         bits(usac.findHomography(a, b, usac.USACV20, 3.0, None, 200, 0.5)))


def readOnly(array):
    result = array.copy()
    result.setflags(write=False)
    return result


def essential(K1, K2=None, d1=None, d2=None, scene=GENERAL):
    return usac.estimateEssential(scene.points1, scene.points2, K1, K2, d1, d2, usac.Params())[:2]


class ArrayTest(MistakeCase):

    def test_other_orders_of_bytes(self):
        a, b, K = GENERAL.points1, GENERAL.points2, GENERAL.K1
        expected = bits(usac.findEssentialMat(a, b, K))
        for kind in (">f8", "<f8"):
            self.assertEqual(bits(usac.findEssentialMat(a.astype(kind), b.astype(kind), K.astype(kind))), expected)
        narrow = np.float32(a), np.float32(b)
        self.assertEqual(bits(usac.findHomography(a.astype(">f4"), b.astype(">f4"))), bits(usac.findHomography(*narrow)))

    def test_other_types(self):
        a, b = np.clip(np.rint(PLANE.points1 / 6), 0, 127), np.clip(np.rint(PLANE.points2 / 6), 0, 127)
        expected = bits(usac.findHomography(a, b))
        self.assertIsNotNone(expected[0])
        for kind in (np.uint8, np.int8, np.uint16, np.int16, np.int32, np.float32, np.int64, np.uint32, np.uint64, np.longdouble,
                     ">i2", ">u8", np.float16):
            self.assertEqual(bits(usac.findHomography(a.astype(kind), b.astype(kind))), expected, kind)
        self.assertEqual(bits(usac.findHomography(a.tolist(), tuple(map(tuple, b)))), expected)
        truth = a > 50, b > 50
        self.assertEqual(bits(usac.findHomography(*truth)), bits(usac.findHomography(np.uint8(truth[0]), np.uint8(truth[1]))))
        large = a + 2.0**40  # does not fit into an integer of 32 bits
        self.assertEqual(bits(usac.findHomography(large.astype(np.int64), b)), bits(usac.findHomography(large, b)))

    def test_what_is_no_array_of_numbers(self):
        a, K = PLANE.points1, PLANE.K1
        for wrong in (a.astype(complex), a.astype(object), a.astype(str), a.astype("S8"), np.zeros(9, "f8,f8"), "points", None, 3.0,
                      7, object(), {}, [[1, 2], [3]], ["a", "b"], np.array(a, "M8[s]"), usac.Params()):
            self.refused("points1", usac.estimateHomography, wrong, a)
            self.refused("points2", usac.estimateFundamental, a, wrong)
            self.refused("srcPoints", usac.findHomography, wrong, a)
            self.refused("to", usac.estimateAffine2D, a, wrong)
            self.refused("objectPoints", usac.solvePnPRansac, wrong, a, K, None)
            self.refused("cameraMatrix1", usac.estimateEssential, a, a, wrong if wrong is not None else 3)
            if wrong is not None:
                self.refused("distCoeffs", usac.estimateAbsolutePose, POSE.X, POSE.x, K, wrong)

    def test_huge(self):
        wide = np.broadcast_to(np.array([[1.0, 2.0]]), (2**31 + 5, 2))  # a view that needs only 16 bytes of memory
        self.refused("points1", usac.estimateHomography, wide, wide)
        self.refused("srcPoints", usac.findHomography, wide, wide, RANSAC)
        self.refused("points2", usac.estimateHomography, PLANE.points1, wide.T)

    def test_layouts(self):
        a, b = PLANE.points1, PLANE.points2
        expected = bits(usac.findHomography(a, b))
        raw = np.zeros(a.nbytes + 1, np.uint8)
        raw[1:] = np.frombuffer(a.tobytes(), np.uint8)
        unaligned = raw[1:].view(np.float64).reshape(a.shape)
        self.assertFalse(unaligned.flags.aligned)
        box = np.zeros((len(a), 3, 4))
        box[:, 1, 1:3] = a
        for other in (unaligned, box[:, 1, 1:3], box[:, 1:2, 1:3], np.asfortranarray(a), a[::-1][::-1], a.T, a[None], a[:, None],
                      np.asfortranarray(a)[:, None], np.stack([a, a], 2)[..., 0], a.view(np.ndarray)[..., ::-1][..., ::-1],
                      np.ma.masked_array(a), np.lib.stride_tricks.as_strided(a, a.shape, a.strides, writeable=False),
                      np.repeat(a, 2, axis=0)[::2], np.ascontiguousarray(a.T)):
            self.assertEqual(bits(FINDER.findHomography(other, b, usac.USACV20)), expected)
            self.assertEqual(bits(usac.estimateHomography(b, other)[:2]), bits(usac.estimateHomography(b, a)[:2]))
        same = np.broadcast_to(a[:1], a.shape)
        self.assertIsNone(usac.findHomography(same, b)[0])

    def test_masks(self):
        a, b, count = PLANE.points1, PLANE.points2, len(PLANE.points1)
        mask = usac.findHomography(a, b)[1]
        for wrong in ("mask", 3, [0] * count, object()):
            self.refused("mask", usac.findHomography, a, b, mask=wrong)
            self.refused("mask", usac.estimateHomography, a, b, mask=wrong)
        locked = np.zeros((count, 1), np.uint8)
        locked.setflags(write=False)
        self.refused("mask", usac.findHomography, a, b, mask=locked)
        self.assertFalse(locked.any())
        flat, apart = np.full(count, 7, np.uint8), np.full((count, 3), 7, np.uint8)
        self.assertIs(usac.findHomography(a, b, mask=flat)[1], flat)
        np.testing.assert_array_equal(flat, mask.ravel())
        usac.findHomography(a, b, mask=apart[:, 1:2])
        np.testing.assert_array_equal(apart[:, 1:2], mask)
        self.assertEqual(set(apart[:, ::2].ravel()), {7})
        for shape in ((count, 2), (count - 1, 1), (count + 1,), (1, count)):  # cv2 leaves such an array as it was
            wrong = np.zeros(shape, np.uint8)
            self.refused("mask", usac.findHomography, a, b, mask=wrong)
            self.refused("mask", usac.estimateHomography, a, b, mask=wrong)
            self.refused("inliers", FINDER.estimateAffine2D, a, b, wrong, usac.USACV20)
        self.assertEqual(bits(usac.findHomography(a, b, mask=np.zeros(0, np.uint8))[1]), bits(mask))
        for shape in ((count, 1), count):
            given = np.zeros(shape, bool)
            self.assertIs(usac.findHomography(a, b, mask=given)[1], given)
            np.testing.assert_array_equal(given.ravel(), mask.ravel() != 0)
        for kind in ("float64", "int32"):
            wrong = np.zeros((count, 1), kind)
            self.refused("mask: .*uint8.*" + kind, usac.findHomography, a, b, mask=wrong)
            self.refused("mask", usac.estimateFundamental, a, b, None, wrong)
            self.refused("inliers", usac.estimateAffine2D, a, b, wrong)
        self.refused("inliers.*int32", usac.solvePnPRansac, POSE.X, POSE.x, POSE.K, None, inliers=np.zeros(len(POSE.X), bool))

    def test_read_only_arrays(self):
        a, b, K, d = (readOnly(x) for x in (DISTORTED.points1, DISTORTED.points2, DISTORTED.K1, DISTORTED.d1))
        for flag in (usac.USACV20, usac.USACV20_MAGSAC):
            self.assertEqual(bits(FINDER.findHomography(a, b, flag)),
                             bits(FINDER.findHomography(DISTORTED.points1, DISTORTED.points2, flag)))
        self.assertEqual(bits(usac.estimateEssential(a, b, K, K, d, d, usac.Params())[:2]),
                         bits(essential(DISTORTED.K1, DISTORTED.K1, DISTORTED.d1, DISTORTED.d1, DISTORTED)))


class CameraTest(MistakeCase):

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
            self.refused("cameraMatrix1", essential, wrong)
            self.refused("cameraMatrix2", essential, K, wrong)

    def test_distortion(self):
        K, d = DISTORTED.K1, DISTORTED.d1
        expected = bits(essential(K, K, d, d, DISTORTED))
        for other in (d[None], d[:, None], np.hstack([d, np.zeros(3)]), np.hstack([d, np.zeros(9)]), np.repeat(d, 2)[::2]):
            self.assertEqual(bits(essential(K, K, other, other, DISTORTED)), expected)
        for length in (4, 5, 8, 12, 14):
            self.assertEqual(bits(essential(K, K, np.zeros(length))), bits(essential(K)))
        for wrong in (np.zeros(3), np.ones(6), np.full(5, np.nan), np.zeros((2, 2))):
            self.refused("distCoeffs2", essential, K, K, None, wrong)


if __name__ == "__main__":
    unittest.main()
