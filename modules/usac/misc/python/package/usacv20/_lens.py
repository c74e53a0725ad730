# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Removes lens distortion from points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

from ._arguments import array, optionalArray, points as pointsOf
from ._backend import native

if TYPE_CHECKING:
    import numpy.typing as npt


def removeDistortion(points: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                     distCoeffs: Optional[npt.ArrayLike] = None) -> npt.NDArray[np.float64]:
    """Removes lens distortion: returns the pixels at which the same camera without distortion would
    see the points. Inverts the distortion model of cv2.projectPoints to double precision.
    cv2.undistortPoints makes five iterations by default; its errors reach a tenth of a pixel in the
    image corners of an ordinary lens.

    points -- N points of the original (distorted) image in pixels; any type and layout that
    estimateHomography accepts
    cameraMatrix -- 3x3
    distCoeffs -- 4, 5, 8, 12 or 14 coefficients as for cv2.undistortPoints; None: no distortion

    Returns an Nx2 array of float64 in pixels: NaN for points that are not finite or are outside the
    field of view of the lens, that is, beyond the radius up to which the radial distortion is
    monotonic."""
    result = native.removeDistortion(pointsOf(points, "points"), array(cameraMatrix, "cameraMatrix"),
                                     optionalArray(distCoeffs, "distCoeffs"))
    return np.empty((0, 2)) if result is None else result
