#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""A camera in NumPy for tests without cv2: rotation vectors, projection, and lens distortion with
five coefficients."""

import numpy as np


def rotation(vector):
    """Returns the rotation matrix of a rotation vector (radians), computed with Rodrigues' formula."""
    vector = np.asarray(vector, float).ravel()
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross.dot(cross)


def distort(points, coefficients):
    """Applies a lens distortion to points of the normalized image plane. coefficients -- k1, k2, p1,
    p2, k3; None: no distortion"""
    if coefficients is None:
        return points
    k1, k2, p1, p2, k3 = np.ravel(coefficients)[:5]
    x, y = points.T
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    return np.stack([x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
                     y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y], axis=1)


def project(X, rvec, tvec, K, coefficients=None):
    """Projects N 3-D points to pixels. rvec, tvec -- pose: X_camera = R(rvec) X + tvec"""
    seen = X.dot(rotation(rvec).T) + np.ravel(tvec)
    return distort(seen[:, :2] / seen[:, 2:], coefficients).dot(K[:2, :2].T) + K[:2, 2]


def normalize(pixels, K, coefficients=None):
    """Converts pixels to points of the normalized image plane and removes the lens distortion."""
    seen = (pixels - K[:2, 2]).dot(np.linalg.inv(K[:2, :2]).T)
    points = seen
    for _ in range(100):  # fixed-point iteration, which converges linearly for a weak distortion
        points = points + seen - distort(points, coefficients)
    return points
