# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Two-view geometry: relative pose, fundamental matrix, and errors of correspondences. Needs NumPy
only."""

import numpy as np


def relative_pose(camera1, camera2):
    """Returns R, t of camera 2 relative to camera 1: x2 = R x1 + t for points in camera coordinates."""
    R = camera2.R @ camera1.R.T
    return R, camera2.t - R @ camera1.t


def fundamental(K1, K2, R, t):
    cross = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]])
    return np.linalg.inv(K2).T @ cross @ R @ np.linalg.inv(K1)


def _homogeneous(points):
    return np.column_stack((points, np.ones(len(points))))


def sampson_distance(F, points1, points2):
    """Returns the first-order (Sampson) distance in pixels of each correspondence from the epipolar
    geometry x2' F x1 = 0."""
    x1, x2 = _homogeneous(points1), _homogeneous(points2)
    lines2, lines1 = x1 @ F.T, x2 @ F
    gradient = (lines1[:, :2] ** 2).sum(axis=1) + (lines2[:, :2] ** 2).sum(axis=1)
    return np.abs((x2 * lines2).sum(axis=1)) / np.sqrt(np.maximum(gradient, np.finfo(float).tiny))


def transfer_error(H, points1, points2):
    """Returns the distances in pixels between points2 and the points1 mapped by H. The distance is
    infinite if H maps a point to infinity."""
    mapped = _homogeneous(points1) @ H.T
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = np.linalg.norm(mapped[:, :2] / mapped[:, 2:] - points2, axis=1)
    return np.where(np.isfinite(distance), distance, np.inf)


def in_front(K1, K2, R, t, points1, points2):
    """Returns for each correspondence whether its point is in front of both cameras: the depths a and b
    in a R x1 + t = b x2 are positive, where x1 and x2 are normalized homogeneous coordinates."""
    rays1 = _homogeneous(points1) @ np.linalg.inv(K1).T @ R.T
    rays2 = _homogeneous(points2) @ np.linalg.inv(K2).T
    normals = np.cross(rays1, rays2)
    return ((normals * np.cross(rays2, t)).sum(axis=1) > 0) & ((normals * np.cross(rays1, t)).sum(axis=1) > 0)
