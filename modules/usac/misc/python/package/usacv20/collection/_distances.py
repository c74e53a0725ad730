# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Errors of matches under a model, in pixels."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, List

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]


def sampsonDistances(F: _Array, points1: _Array, points2: _Array, shifts: typing.Sequence[int] = (0,)) -> List[_Array]:
    """Of N x 2 pixels, in pixels: the error of a match under x2^T F x1 = 0 to first order @cite hartley2003multiple (11.4.3).

    shifts -- for each of them point i of the first image is matched with point i - shift of the second, around the end;
        0 to the number of the points"""
    lines2 = points1 @ F[:, :2].T + F[:, 2]
    lines1 = points2 @ F[:2, :2] + F[2, :2]
    squares2 = lines2[:, 0]**2 + lines2[:, 1]**2
    squares1 = lines1[:, 0]**2 + lines1[:, 1]**2
    # Twice one after the other, of which slices are what np.roll would copy.
    x, y, squares = np.tile(points2[:, 0], 2), np.tile(points2[:, 1], 2), np.tile(squares1, 2)
    count = len(points2)
    result = []
    for shift in shifts:
        part = slice(count - shift, 2 * count - shift)
        algebraic = x[part] * lines2[:, 0] + y[part] * lines2[:, 1] + lines2[:, 2]
        with np.errstate(all="ignore"):
            result.append(np.abs(algebraic) / np.sqrt(squares2 + squares[part]))
    return result
