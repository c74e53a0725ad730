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
