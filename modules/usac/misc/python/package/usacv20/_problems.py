# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The functions of each problem: an estimation with all options and a report, and many of them in one call."""

# Written by misc/python/make_names.py; changes are made there or in the headers.

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Union

from ._batch import POSES, estimateMany
from ._enumerations import ProblemType
from ._estimate import POSE, estimate, oneOrTwoCameras
from ._params import Params

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._batch import _Arrays, _Estimates, _Lists, _ParamsOfEach
    from ._estimate import _Estimate, _Mask

__all__ = [
    "estimateAbsolutePose", "estimateAbsolutePoses", "estimateAffinities2D", "estimateAffinity2D", "estimateEssential",
    "estimateEssentials", "estimateFundamental", "estimateFundamentals", "estimateHomographies", "estimateHomography",
    "estimateRigid3D", "estimateRigids3D", "estimateSimilarities2D", "estimateSimilarities3D", "estimateSimilarity2D",
    "estimateSimilarity3D", "estimateTranslation2D", "estimateTranslations2D"]


def estimateHomography(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                       mask: _Mask = None) -> _Estimate:
    """Estimates the homography that maps image 1 to image 2.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, with h33 = 1 (unit Frobenius norm where h33 is 0); None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.HOMOGRAPHY, points1, points2, params, mask)


def estimateHomographies(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Many estimations of estimateHomography in one call, side by side.

    points1, points2 -- lists of the same length; each entry is what estimateHomography takes
    params -- Params for all, or a list with one (or None) for each: match scores differ from pair to pair
    threads -- how many estimations at once, 0: all cores. The result does not depend on it
    returnExceptions -- a mistake in an entry, one list of points longer than the other, say: True: its exception stands in the
        place of the result, the others go on; False: it is raised when all are done, and names the entry

    Returns a list of (model, mask, report), one for each entry, in this order: each to the bit what estimateHomography
    returns. The interpreter's lock is released meanwhile."""
    return estimateMany(ProblemType.HOMOGRAPHY, points1, points2, params, threads, returnExceptions)


def estimateFundamental(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                        mask: _Mask = None) -> _Estimate:
    """Estimates the fundamental matrix F with x2^T F x1 = 0.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the Sampson distance in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, rank 2, unit Frobenius norm; None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.FUNDAMENTAL, points1, points2, params, mask)


def estimateFundamentals(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateFundamental."""
    return estimateMany(ProblemType.FUNDAMENTAL, points1, points2, params, threads, returnExceptions)


def estimateEssential(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                      cameraMatrix2: Union[npt.ArrayLike, Params, None] = None, distCoeffs1: Optional[npt.ArrayLike] = None,
                      distCoeffs2: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                      mask: _Mask = None) -> _Estimate:
    """Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

    estimateEssential(points1, points2, cameraMatrix[, params[, mask]])
    estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2[, distCoeffs1[, distCoeffs2[, params[, mask]]]])

    points1, points2 -- N points of each image in pixels: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point
        number, any layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    cameraMatrix1, cameraMatrix2 -- 3x3 camera matrices; without the second the first holds for both images
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 numbers, the distortion as in cv2.undistortPoints; None: none
    params -- Params, None for the default; params.threshold is the Sampson distance in pixels; internally it is divided by the
        mean of the four focal lengths
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, singular values (1, 1, 0)/sqrt(2); None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    cameraMatrix2, distCoeffs1, params, mask = oneOrTwoCameras(cameraMatrix2, distCoeffs1, distCoeffs2, params, mask)
    return estimate(ProblemType.ESSENTIAL, points1, points2, params, mask, cameraMatrix1, cameraMatrix2, distCoeffs1,
                    distCoeffs2)


def estimateEssentials(points1: _Lists, points2: _Lists, cameraMatrices1: _Arrays, cameraMatrices2: _Arrays = None,
                       distCoeffs1: _Arrays = None, distCoeffs2: _Arrays = None, params: _ParamsOfEach = None,
                       threads: int = 0, returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateEssential.

    cameraMatrices1, cameraMatrices2, distCoeffs1, distCoeffs2 -- one array for all, or a list with an array for each. A camera
        matrix is a 3x3 array; without one for image 2, that of image 1 holds for both images. Distortion coefficients of None
        mean no distortion"""
    return estimateMany(ProblemType.ESSENTIAL, points1, points2, params, threads, returnExceptions, cameraMatrices1,
                        cameraMatrices2, distCoeffs1, distCoeffs2)


def estimateAffinity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                       mask: _Mask = None) -> _Estimate:
    """Estimates the affine map from image 1 to image 2, x2 = A x1 + t.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, [A t], as returned by cv2.estimateAffine2D and used by cv2.warpAffine; None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.AFFINITY, points1, points2, params, mask)


def estimateAffinities2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateAffinity2D."""
    return estimateMany(ProblemType.AFFINITY, points1, points2, params, threads, returnExceptions)


def estimateSimilarity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the similarity (rotation, uniform scale and translation) from image 1 to image 2.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, rows (a, -b, x) and (b, a, y), as returned by cv2.estimateAffinePartial2D; None if there is
        none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.SIMILARITY, points1, points2, params, mask)


def estimateSimilarities2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateSimilarity2D."""
    return estimateMany(ProblemType.SIMILARITY, points1, points2, params, threads, returnExceptions)


def estimateAbsolutePose(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                         distCoeffs: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the pose of a calibrated camera from 3-D points and their images: x ~ K (R X + t).

    objectPoints -- N points of space: Nx3, 3xN, Nx1x3 or 1xNx3
    imagePoints -- N pixels, as the points of estimateHomography
    cameraMatrix -- 3x3 camera matrix
    distCoeffs -- distortion as in cv2.projectPoints; None: none
    params -- Params, None for the default; params.threshold is the reprojection error in pixels, in the original (distorted)
        image
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [R t]; None if there is none. cv2.Rodrigues turns R into a vector
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.ABSOLUTE_POSE, objectPoints, imagePoints, params, mask, cameraMatrix, None,
                    distCoeffs, names=POSE)


def estimateAbsolutePoses(objectPoints: _Lists, imagePoints: _Lists, cameraMatrices: _Arrays, distCoeffs: _Arrays = None,
                          params: _ParamsOfEach = None, threads: int = 0, returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateAbsolutePose.

    cameraMatrices, distCoeffs -- one array for all, or a list with an array for each. A camera matrix is a 3x3 array; without
        one for image 2, that of image 1 holds for both images. Distortion coefficients of None mean no distortion"""
    return estimateMany(ProblemType.ABSOLUTE_POSE, objectPoints, imagePoints, params, threads, returnExceptions,
                        cameraMatrices, None, distCoeffs, names=POSES)


def estimateRigid3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                    mask: _Mask = None) -> _Estimate:
    """Estimates the rigid motion that maps 3-D points to their counterparts: X2 = R X1 + t.

    points1, points2 -- N points of each space: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params, None for the default; params.threshold is the distance between R X1 + t and X2, in the unit of the
        points; the default 1.5 is therefore rarely suitable
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [R t]; None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.RIGID_3D, points1, points2, params, mask)


def estimateRigids3D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                     returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateRigid3D."""
    return estimateMany(ProblemType.RIGID_3D, points1, points2, params, threads, returnExceptions)


def estimateSimilarity3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the similarity (rotation, uniform scale and translation) between 3-D points: X2 = s R X1 + t, s > 0.

    points1, points2 -- N points of each space: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params, None for the default; params.threshold is the distance between s R X1 + t and X2, in the unit of points2
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [s R t]; None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.SIMILARITY_3D, points1, points2, params, mask)


def estimateSimilarities3D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateSimilarity3D."""
    return estimateMany(ProblemType.SIMILARITY_3D, points1, points2, params, threads, returnExceptions)


def estimateTranslation2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                          mask: _Mask = None) -> _Estimate:
    """Estimates the translation from image 1 to image 2, x2 = x1 + t.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any type of integer or floating-point number, any
        layout; with 3 in the place of 2, homogeneous coordinates (x, y, confidence is refused)
    params -- Params, None for the default; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, rows (1, 0, x) and (0, 1, y), as used by cv2.warpAffine and of the form of
        estimateAffinity2D; cv2.estimateTranslation2D of OpenCV 5 returns its last column; None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model

    Points with NaN or infinite coordinates are never inliers. usacv20.error names an argument that is wrong."""
    return estimate(ProblemType.TRANSLATION_2D, points1, points2, params, mask)


def estimateTranslations2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but with estimateTranslation2D."""
    return estimateMany(ProblemType.TRANSLATION_2D, points1, points2, params, threads, returnExceptions)
