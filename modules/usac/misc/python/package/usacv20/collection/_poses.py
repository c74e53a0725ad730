# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The motion between two cameras, of an essential matrix or of directions that a rotation takes to each other.

Directions are N x 3 with z = 1: K^-1 (x, y, 1). A motion takes a point X of the first camera to R X + t of the second."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Tuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]

# Only the signs of depths are asked for, and these many tell them; the same bound for every pair.
_MOST_FOR_SIGNS = 500


def directions(points: _Array, matrix: _Array) -> _Array:
    """Of pixels without distortion, by the matrix of the camera."""
    result = np.empty((len(points), 3))
    result[:, 0] = (points[:, 0] - matrix[0, 2]) / matrix[0, 0]
    result[:, 1] = (points[:, 1] - matrix[1, 2]) / matrix[1, 1]
    result[:, 2] = 1
    return result


def motionOfEssential(E: _Array, first: _Array, second: _Array) -> Tuple[_Array, _Array]:
    """Rotation and unit translation: of the four motions that E allows the one with which most points are in front of both
    cameras @cite hartley2003multiple (9.6.2). `first` and `second` are the directions of the inliers."""
    U, _, V = np.linalg.svd(E)
    U, V = U * np.linalg.det(U), V * np.linalg.det(V)
    W = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    t = U[:, 2]
    step = -(-len(first) // _MOST_FOR_SIGNS) or 1
    a, b = first[::step], second[::step]
    best = (-1, np.eye(3), t)
    for R in (U @ W @ V, U @ W.T @ V):
        depths = _depthSigns(a @ R.T, b, t)
        for sign in (1, -1):
            best = max(best, (int(np.count_nonzero(depths == sign)), R, sign * t), key=lambda motion: motion[0])
    return best[1], best[2]


def _depthSigns(a: _Array, b: _Array, t: _Array) -> npt.NDArray[np.int8]:
    """1 where the point z1 a + t = z2 b has both depths positive, -1 where it has with -t, else 0. The depths are those of the
    least squares, times a positive number."""
    aa, ab, bb = np.einsum("ij,ij->i", a, a), np.einsum("ij,ij->i", a, b), np.einsum("ij,ij->i", b, b)
    at, bt = a @ t, b @ t
    z1, z2 = bt * ab - at * bb, bt * aa - at * ab
    return np.where((z1 > 0) & (z2 > 0), 1, np.where((z1 < 0) & (z2 < 0), -1, 0)).astype(np.int8)


def rotation(first: _Array, second: _Array) -> _Array:
    """The rotation that takes directions nearest to directions, by least squares of unit vectors @cite umeyama1991least."""
    a = first / np.linalg.norm(first, axis=1)[:, None]
    b = second / np.linalg.norm(second, axis=1)[:, None]
    U, _, V = np.linalg.svd(b.T @ a)
    U[:, 2] *= np.linalg.det(U) * np.linalg.det(V)
    result: _Array = U @ V
    return result


def essentialOf(F: _Array, matrix1: _Array, matrix2: _Array) -> _Array:
    """The essential matrix nearest to a fundamental matrix of two cameras."""
    U, _, V = np.linalg.svd(matrix2.T @ F @ matrix1)
    U[:, 2] = 0
    E: _Array = U @ V
    return E


def rotationsOfPlane(H: _Array) -> Tuple[_Array, _Array]:
    """The two rotations with which cameras can see a plane so that H takes directions of the first to those of the second, the
    same twice if H is a rotation (Ma, Soatto, Kosecka, Sastry: An invitation to 3-D vision, algorithm 5.2)."""
    H = H / np.linalg.svd(H, compute_uv=False)[1] * (1 if np.linalg.det(H) > 0 else -1)
    values, vectors = np.linalg.eigh(H.T @ H)
    low, middle, high = np.maximum(values, 0)
    v3, v2, v1 = vectors.T
    a, b = math.sqrt(max(1 - low, 0)), math.sqrt(max(high - 1, 0))
    if high - low < 1e-12:
        return _nearest(H), _nearest(H)
    result = []
    for sign in (1, -1):
        u = (a * v1 + sign * b * v3) / math.sqrt(high - low)
        U, W = np.column_stack([v2, u, np.cross(v2, u)]), np.column_stack([H @ v2, H @ u, np.cross(H @ v2, H @ u)])
        result.append(_nearest(W @ U.T))
    return result[0], result[1]


def _nearest(matrix: _Array) -> _Array:
    U, _, V = np.linalg.svd(matrix)
    U[:, 2] *= np.linalg.det(U) * np.linalg.det(V)
    R: _Array = U @ V
    return R


def quaternion(R: _Array) -> _Array:
    """(w, x, y, z) with w >= 0 of a rotation: of the four columns of the quaternion's square the one with the largest norm."""
    xx, yy, zz = R[0, 0], R[1, 1], R[2, 2]
    square = np.array([
        [1 + xx + yy + zz, R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]],
        [R[2, 1] - R[1, 2], 1 + xx - yy - zz, R[0, 1] + R[1, 0], R[0, 2] + R[2, 0]],
        [R[0, 2] - R[2, 0], R[0, 1] + R[1, 0], 1 - xx + yy - zz, R[1, 2] + R[2, 1]],
        [R[1, 0] - R[0, 1], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], 1 - xx - yy + zz]])
    q: _Array = square[int(np.argmax(np.diag(square)))]
    q = q / np.linalg.norm(q)
    return -q if q[0] < 0 else q
