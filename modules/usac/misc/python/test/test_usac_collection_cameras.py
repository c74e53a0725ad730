#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the cameras of a COLMAP database: COLMAP's numbers for camera models, and the removal of
lens distortion."""

import unittest

import numpy as np

from usac_common import cv, needsCv2, once, package

try:
    from usacv20.collection._cameras import Camera
    from usacv20.collection._pair import CollectionError
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    Camera = None

# For each lens: COLMAP's number and name of the camera model, and the parameters. Focal lengths and
# principal point are in pixels.
LENSES = ((2, "SIMPLE_RADIAL", [800, 400, 300, -.2]), (3, "RADIAL", [800, 400, 300, -.25, .06]),
          (4, "OPENCV", [800, 810, 400, 300, -.25, .06, 1e-3, -2e-3]),
          (6, "FULL_OPENCV", [800, 810, 400, 300, -.25, .06, 1e-3, -2e-3, .01, .02, .01, .003]))
FISHEYES = ((5, "OPENCV_FISHEYE", [400, 410, 400, 300, -.02, .006, 1e-3, -2e-3]),
            (8, "SIMPLE_RADIAL_FISHEYE", [400, 400, 300, .05]), (9, "RADIAL_FISHEYE", [400, 400, 300, .05, -.01]),
            (14, "SIMPLE_FISHEYE", [400, 400, 300]), (15, "FISHEYE", [400, 410, 400, 300]))

# For each of these fisheye lenses: k1 to k4, and the angle (degrees) at which the distorted radius has
# its first maximum; 90: it increases up to 90 degrees. Plain Newton's method fails for the first four.
STEEP = (((.4, -.1, 0, 0), 90), ((.5, -.15, 0, 0), 90), ((.33, .13, -.2, 0), 66.9), ((1, -.5, 0, 0), 69.5),
         ((-.4, .05, 0, 0), 59.3), ((0, 0, 0, -1e-320), 90))


def camera(model, params, known=1):
    return Camera.fromColmap(7, model, 800, 600, np.array(params, np.float64).tobytes(), known)


def seen(lens, points):
    """Returns the pixels at which the camera sees the points (u, v, 1), computed from the definition
    of the distortion instead of with the package."""
    k1, k2, p1, p2, k3, k4, k5, k6 = lens.distortion
    u, v = points.T
    r2 = u * u + v * v
    if lens.fisheye:
        r = np.sqrt(r2)
        angle = np.arctan(r)
        scale = angle * (1 + k1 * angle**2 + k2 * angle**4 + k3 * angle**6 + k4 * angle**8) / np.where(r > 0, r, 1)
        du, dv = u * scale, v * scale
    else:
        scale = (1 + k1 * r2 + k2 * r2**2 + k3 * r2**3) / (1 + k4 * r2 + k5 * r2**2 + k6 * r2**3)
        du = u * scale + 2 * p1 * u * v + p2 * (r2 + 2 * u * u)
        dv = v * scale + p1 * (r2 + 2 * v * v) + 2 * p2 * u * v
    return np.stack([du, dv, np.ones_like(u)], axis=1) @ lens.matrix[:2].T


def grid(extent):
    return np.stack(np.meshgrid(np.linspace(-extent, extent, 21), np.linspace(-extent, extent, 21)), axis=-1).reshape(-1, 2)


@once
@package
class CamerasTest(unittest.TestCase):

    def test_without_distortion(self):
        for model, name, params, matrix in (
                (0, "SIMPLE_PINHOLE", [800, 400, 300], [[800, 0, 400], [0, 800, 300], [0, 0, 1]]),
                (1, "PINHOLE", [800, 810, 400, 300], [[800, 0, 400], [0, 810, 300], [0, 0, 1]])):
            got = camera(model, params, known=0)
            self.assertEqual((got.id, got.model, got.width, got.height, got.focalKnown, got.distorted),
                             (7, name, 800, 600, False, False))
            np.testing.assert_array_equal(got.matrix, matrix)
            points = np.random.RandomState(1).uniform(0, 800, (9, 2))
            np.testing.assert_allclose(got.ideal(points), points, atol=1e-9)

    def test_distortion_is_removed(self):
        for model, name, params in LENSES + FISHEYES:
            lens = camera(model, params)
            self.assertEqual((lens.model, lens.distorted, lens.focalKnown), (name, True, True))
            points = grid(1.5 if lens.fisheye else 0.5)
            expected = np.c_[points, np.ones(len(points))] @ lens.matrix[:2].T
            np.testing.assert_allclose(lens.ideal(seen(lens, points)), expected, atol=1e-6, err_msg=name)

    @needsCv2
    def test_distortion_is_that_of_OpenCV(self):
        points, zero = np.c_[grid(0.5), np.ones(21 * 21)], np.zeros(3)
        for model, name, params in LENSES:
            lens = camera(model, params)
            taken, _ = cv.projectPoints(points, zero, zero, lens.matrix, np.array(lens.distortion))
            np.testing.assert_allclose(taken[:, 0], seen(lens, points[:, :2]), atol=1e-9, err_msg=name)
        for model, name, params in FISHEYES:
            lens = camera(model, params)
            taken, _ = cv.fisheye.projectPoints(points[:, None], zero, zero, lens.matrix,
                                                np.array(lens.distortion)[[0, 1, 4, 5]])
            np.testing.assert_allclose(taken[:, 0], seen(lens, points[:, :2]), atol=1e-9, err_msg=name)

    def test_what_no_direction_is_mapped_to_is_not_a_number(self):
        # The distorted radius r (1 - 0.2 r^2) is at most 0.86, or 688 pixels. Pixels farther from the
        # center correspond to no direction and must become NaN.
        lens = camera(2, [800, 400, 300, -.2])
        got = lens.ideal(np.array([[400 + 680, 300], [400 + 695, 300], [400., 300 + 2000], [np.nan, 3], [np.inf, 3]]))
        self.assertTrue(np.isfinite(got[0]).all())
        self.assertTrue(np.isnan(got[1:]).any(axis=1).all())
        fisheye = camera(8, [400, 400, 300, 0])
        # A direction 90 degrees from the optical axis is seen 628 pixels from the center. Pixels at
        # this distance or farther correspond to no point of an image without distortion.
        got = fisheye.ideal(np.array([[400 + 400 * 1.5, 300], [400 + 400 * 1.6, 300], [np.nan, 3], [np.inf, 3]]))
        np.testing.assert_allclose(got[0], [400 + 400 * np.tan(1.5), 300], rtol=1e-9)
        self.assertTrue(np.isnan(got[1:]).any(axis=1).all())

    def test_fisheyes_up_to_the_edge(self):
        for coefficients, edge in STEEP:
            lens = camera(5, [400, 410, 400, 300] + list(coefficients))
            angles = np.radians(np.concatenate([np.linspace(0, edge - 0.5, 500), [edge - 0.1]]))
            for direction in ((1, 0), (-0.6, 0.8)):
                points = np.tan(angles)[:, None] * direction
                expected = np.c_[points, np.ones(len(points))] @ lens.matrix[:2].T
                np.testing.assert_allclose(lens.ideal(seen(lens, points)), expected, rtol=1e-6, atol=1e-6,
                                           err_msg=str(coefficients))
                center, last = lens.matrix[:2, 2], seen(lens, np.tan(np.radians([[edge - 0.01]])) * direction)
                beyond = center + 1.01 * (last - center)
                self.assertTrue(np.isnan(lens.ideal(beyond)).all(), coefficients)

    def test_fisheyes_with_absurd_numbers(self):
        for coefficients in ([1e308] * 4, [-1e308, 1e308, 0, 0], [0, 0, 0, -1e308]):
            got = camera(5, [400, 410, 400, 300] + coefficients).ideal(np.array([[400., 300], [800, 300]]))
            np.testing.assert_array_equal(got[0], [400, 300])

    def test_mistakes(self):
        for model, params, said in ((7, [800, 400, 300, .5, .1], "camera 7: its model FOV "), (10, [1] * 12, "THIN_PRISM_FISHEYE"),
                                    (12, [1] * 4, "SIMPLE_DIVISION"), (13, [1] * 5, "model DIVISION"), (16, [1] * 6, "EUCM"),
                                    (17, [1] * 2, "EQUIRECTANGULAR"),
                                    (99, [1], "of number 99"), (0, [800, 400], "SIMPLE_PINHOLE has 3 parameters"),
                                    (0, [0, 400, 300], "f=0"), (1, [800, np.nan, 400, 300], "fy=nan"), (1, [800, -1, 0, 0], "fy=-1")):
            with self.assertRaisesRegex(CollectionError, said):
                camera(model, params)
        with self.assertRaisesRegex(CollectionError, "not 5 bytes"):
            Camera.fromColmap(7, 0, 800, 600, b"12345", 1)


if __name__ == "__main__":
    unittest.main()
