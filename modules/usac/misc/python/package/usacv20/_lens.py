# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Removal of the distortion of a lens from points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

from ._arguments import array, optionalArray, points as pointsOf
from ._backend import native

if TYPE_CHECKING:
    import numpy.typing as npt


def removeDistortion(points: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                     distCoeffs: Optional[npt.ArrayLike] = None) -> npt.NDArray[np.float64]:
    """Returns where the same camera would see the points if its lens had no distortion, in double
    precision; this is the inverse of the distortion of cv2.projectPoints. In contrast,
    cv2.undistortPoints makes five iterations by default and is up to a tenth of a pixel off in the
    corners of an ordinary lens.

    points -- N points of the image as it was taken, pixels; any type and layout that
    estimateHomography takes
    cameraMatrix -- 3x3
    distCoeffs -- 4, 5, 8, 12 or 14 coefficients as for cv2.undistortPoints, or None

    Returns an Nx2 array of float64, pixels. NaN for points that are not finite, and beyond the
    radius where the radial terms fold the image back, which the lens cannot image."""
    result = native.removeDistortion(pointsOf(points, "points"), array(cameraMatrix, "cameraMatrix"),
                                     optionalArray(distCoeffs, "distCoeffs"))
    return np.empty((0, 2)) if result is None else result
