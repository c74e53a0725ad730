# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The functions that estimate a model with all options and report what they learned."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np

from . import _arguments
from ._backend import native
from ._enumerations import ProblemType
from ._errors import calling, fail
from ._params import Params, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    _Estimate = Tuple[Optional[npt.NDArray[np.float64]], npt.NDArray[np.uint8], Report]
    _Mask = Optional[npt.NDArray[np.uint8]]

NO_POINTS = np.empty((0, 1), np.uint8)
NAMES = ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2")  # in C++


def inPlane(problem: int) -> Tuple[bool, bool]:
    """Whether the points of both arrays are those of a plane."""
    space = problem in (ProblemType.RIGID_3D, ProblemType.SIMILARITY_3D)
    return not space and problem != ProblemType.ABSOLUTE_POSE, not space


def estimate(problem: int, points1: Any, points2: Any, params: Any, mask: Any, cameraMatrix1: Any = None,
             cameraMatrix2: Any = None, distCoeffs1: Any = None, distCoeffs2: Any = None,
             names: Tuple[str, ...] = NAMES, maskName: str = "mask") -> _Estimate:
    """Any of the problems; `names` are those of the arguments that are arrays, as the caller knows them."""
    options = optionsOf(params)
    _arguments.checkMask(mask, maskName)
    plane1, plane2 = inPlane(problem)
    model, inliers, report = calling(
        dict(zip(NAMES, names)), native.estimate, problem, _arguments.points(points1, names[0], plane1),
        _arguments.points(points2, names[1], plane2), options,
        _arguments.optionalArray(cameraMatrix1, names[2]), _arguments.optionalArray(cameraMatrix2, names[3]),
        _arguments.optionalArray(distCoeffs1, names[4]), _arguments.optionalArray(distCoeffs2, names[5]))
    return model, _arguments.output(mask, NO_POINTS.copy() if inliers is None else inliers), Report._of(report)


def estimateHomography(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                       mask: _Mask = None) -> _Estimate:
    """Estimates the homography that maps image 1 to image 2.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, or None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.HOMOGRAPHY, points1, points2, params, mask)


def estimateAffinity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                       mask: _Mask = None) -> _Estimate:
    """Estimates the affine map of image 1 to image 2. Arguments and results are those of estimateHomography, but the model is the
    2x3 array [A t] of cv2.estimateAffine2D and cv2.warpAffine, x2 = A x1 + t."""
    return estimate(ProblemType.AFFINITY, points1, points2, params, mask)


def estimateSimilarity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates rotation, uniform scale and translation from image 1 to image 2. Arguments and results are those of
    estimateAffinity2D; the model has the rows (a, -b, x) and (b, a, y), as that of cv2.estimateAffinePartial2D."""
    return estimate(ProblemType.SIMILARITY, points1, points2, params, mask)


def estimateFundamental(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                        mask: _Mask = None) -> _Estimate:
    """Estimates the fundamental matrix F with x2^T F x1 = 0, 3x3 of rank 2. Arguments and results are those of
    estimateHomography; params.threshold is the Sampson distance in pixels."""
    return estimate(ProblemType.FUNDAMENTAL, points1, points2, params, mask)


def estimateEssential(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                      cameraMatrix2: Union[npt.ArrayLike, Params, None] = None, distCoeffs1: Optional[npt.ArrayLike] = None,
                      distCoeffs2: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                      mask: _Mask = None) -> _Estimate:
    """Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

    estimateEssential(points1, points2, cameraMatrix[, params[, mask]])
    estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2[, distCoeffs1[, distCoeffs2[, params[, mask]]]])

    points1, points2 -- N points of each image in pixels, as for estimateHomography
    cameraMatrix1, cameraMatrix2 -- 3x3 camera matrices; without the second the first holds for both images
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 numbers, the distortion as in cv2.undistortPoints; None: none
    params -- Params, None for the default; params.threshold is the Sampson distance in pixels

    The mask and the results are those of estimateHomography; E is 3x3."""
    if isinstance(cameraMatrix2, Params):  # the first of the two forms
        if params is not None or distCoeffs2 is not None:
            raise fail("cameraMatrix2: a 3x3 matrix is expected, not a Params, beside other arguments")
        cameraMatrix2, params, distCoeffs1, mask = None, cameraMatrix2, None, distCoeffs1 if mask is None else mask
    return estimate(ProblemType.ESSENTIAL, points1, points2, params, mask, cameraMatrix1, cameraMatrix2, distCoeffs1,
                    distCoeffs2)


_POSE = ("objectPoints", "imagePoints", "cameraMatrix", "", "distCoeffs", "")


def estimateAbsolutePose(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                         distCoeffs: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the pose of a calibrated camera from points of space and their images, x ~ K (R X + t).

    objectPoints -- N points of space: Nx3, 3xN, Nx1x3 or 1xNx3
    imagePoints -- N pixels, as the points of estimateHomography
    cameraMatrix -- 3x3 camera matrix
    distCoeffs -- distortion as in cv2.projectPoints; None: none
    params -- Params; params.threshold is the reprojection error in pixels of the image as it was taken

    Returns (model, mask, report) as estimateHomography; the model is a 3x4 array, [R t]."""
    return estimate(ProblemType.ABSOLUTE_POSE, objectPoints, imagePoints, params, mask, cameraMatrix, None, distCoeffs,
                    names=_POSE)


def estimateRigid3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                    mask: _Mask = None) -> _Estimate:
    """Estimates rotation and translation of space, X2 = R X1 + t.

    points1, points2 -- N points of each space in one unit: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params; params.threshold is the distance in space 2, in the unit of the points: its default will rarely do

    Returns (model, mask, report) as estimateHomography; the model is a 3x4 array, [R t]."""
    return estimate(ProblemType.RIGID_3D, points1, points2, params, mask)


def estimateSimilarity3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates rotation, uniform scale and translation of space, X2 = s R X1 + t, s > 0. Arguments and results are those
    of estimateRigid3D; points1 may have any unit, and the model is [s R t]."""
    return estimate(ProblemType.SIMILARITY_3D, points1, points2, params, mask)
