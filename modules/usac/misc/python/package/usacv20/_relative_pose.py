# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimation of the motion of a camera between two views."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Optional, Tuple

import numpy as np

from . import _arguments
from ._arguments import array, count, optionalArray, points
from ._backend import native
from ._estimate import NO_POINTS
from ._params import Params, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    _Double = Optional[npt.NDArray[np.float64]]
    _Optional = Optional[npt.ArrayLike]


class RelativePose(typing.NamedTuple):
    """The results of estimateRelativePose other than the motion."""

    report: Report  # report on the search for the essential matrix; its `inliers` is the number of inliers in the mask
    essential: _Double  # [t]x R, 3x3, singular values (1, 1, 0)/sqrt(2); None if there is no model
    behind: int  # number of inliers of the essential matrix that are triangulated behind a camera; the mask is 0 for them
    onPlane: int  # number of inliers on a dominant plane (more than 80 % of all inliers); 0 if there is none
    # If there is a dominant plane: rotation, 3x3, of the second of the two motions that are
    # compatible with the homography of the plane. None if there is no such motion.
    otherR: _Double
    otherT: _Double  # translation of the second motion, 3x1, unit length; None if otherR is None
    otherInliers: int  # number of inliers of the second motion in front of both cameras


def estimateRelativePose(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                         distCoeffs1: _Optional = None, cameraMatrix2: _Optional = None, distCoeffs2: _Optional = None,
                         params: Optional[Params] = None, mask: Optional[npt.NDArray[np.uint8]] = None
                         ) -> Tuple[_Double, _Double, npt.NDArray[np.uint8], RelativePose]:
    """Estimates the motion of a calibrated camera between two views, X2 = R X1 + t up to the length
    of t.

    points1, points2 -- N points of each original (distorted) image in pixels; layouts as in
    estimateHomography
    cameraMatrix1, cameraMatrix2 -- 3x3; cameraMatrix2 None: the same as cameraMatrix1
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 distortion coefficients of camera 1 and camera 2,
    as for cv2.undistortPoints; None: no distortion
    params -- Params; `threshold` is the Sampson distance in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (R, t, mask, pose):
    R, t -- a rotation, 3x3, and a vector of unit length, 3x1. If there is no model, both are None,
    and pose.report.stop gives the reason
    mask -- Nx1 array of uint8, 1 where the Sampson distance is at most the threshold and the
    triangulated point is in front of both cameras or at infinity
    pose -- RelativePose: the report and the essential matrix. If more than 80 % of the inliers are
    on a plane, two motions are possible. The motion with the smaller sum of truncated squared errors
    is returned, so that the points off the plane decide; the other motion is in pose.otherR and
    pose.otherT"""
    _arguments.checkMask(mask, "mask")
    first, second = points(points1, "points1"), points(points2, "points2")
    options = optionsOf(params, count=count(first))
    R, t, inliers, report, essential, behind, onPlane, otherR, otherT, otherInliers = native.estimateRelativePose(
        first, second, array(cameraMatrix1, "cameraMatrix1"),
        optionalArray(distCoeffs1, "distCoeffs1"), optionalArray(cameraMatrix2, "cameraMatrix2"),
        optionalArray(distCoeffs2, "distCoeffs2"), options)
    return (R, t, _arguments.outputMask(mask, inliers, "mask"),
            RelativePose(Report._ofCall(report), essential, behind, onPlane, otherR, otherT, otherInliers))


RelativePose.__module__ = __name__.rpartition(".")[0]
