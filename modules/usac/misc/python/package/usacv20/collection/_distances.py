# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Errors of matches under a model, in pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]


def sampsonDistances(F: _Array, points1: _Array, points2: _Array) -> _Array:
    """Of N x 2 pixels, in pixels: the error of a match under x2^T F x1 = 0 to first order @cite hartley2003multiple (11.4.3)."""
    lines2 = points1 @ F[:, :2].T + F[:, 2]
    lines1 = points2 @ F[:2] + F[2]
    algebraic = np.einsum("ij,ij->i", points2, lines2[:, :2]) + lines2[:, 2]
    with np.errstate(all="ignore"):
        result: _Array = np.abs(algebraic) / np.sqrt((lines1[:, :2]**2).sum(axis=1) + (lines2[:, :2]**2).sum(axis=1))
    return result


def area(points: _Array) -> float:
    """The square of the area that the points cover, up to a factor; some of them tell it."""
    x, y = (points[:: len(points) // 200 + 1] - points[0]).T
    n = len(x)
    xx, xy, yy = (a @ b / n - a.sum() * b.sum() / (n * n) for a, b in ((x, x), (x, y), (y, y)))
    return float(xx * yy - xy * xy)


def mapDistances(H: _Array, first: _Array, second: _Array) -> _Array:
    """Sampson distances: to first order, of a match to the nearest one that H maps exactly, in both images. Infinite where H
    takes the point to the other side of the camera than most of the points."""
    x, y = first[:, 0], first[:, 1]
    with np.errstate(all="ignore"):
        w = H[2, 0] * x + H[2, 1] * y + H[2, 2]
        u, v = (H[0, 0] * x + H[0, 1] * y + H[0, 2]) / w, (H[1, 0] * x + H[1, 1] * y + H[1, 2]) / w
        ux, uy, vx, vy = ((row[k] - moved * H[2, k]) / w for row, moved in ((H[0], u), (H[1], v)) for k in (0, 1))
        a, b, c = 1 + ux * ux + uy * uy, ux * vx + uy * vy, 1 + vx * vx + vy * vy  # the covariance of the error
        eu, ev = second[:, 0] - u, second[:, 1] - v
        squared = (c * eu * eu - 2 * b * eu * ev + a * ev * ev) / (a * c - b * b)
        return np.where(w * np.median(w) > 0, np.sqrt(np.maximum(squared, 0)), np.inf)
