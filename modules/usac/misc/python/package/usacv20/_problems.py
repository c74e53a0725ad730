# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Two functions for each problem: one estimation with all options and a report, and many such estimations in one call."""

# Written by misc/python/make_names.py. Edit that script or the headers instead of this file.

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

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and
        memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not
        all 1 (confidences) raises usacv20.error
    params -- Params; None: the default. params.threshold is the maximum distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, with h33 = 1 (unit Frobenius norm if h33 is nearly 0); None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.HOMOGRAPHY, points1, points2, params, mask)


def estimateHomographies(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Runs estimateHomography for many pairs of images in one call, in parallel.

    points1, points2 -- lists of the same length, with an entry for each estimation, in the forms that estimateHomography
        accepts
    params -- Params for all estimations, or a list with a Params (or None) for each, for example because match scores differ
    threads -- number of estimations that run at once, at most the number of OpenCV's threads; 0: this number. The results do
        not depend on it
    returnExceptions -- what happens if an entry is wrong, for example if its lists of points differ in length. True: the
        exception replaces the result of this entry. False: the exception of one such entry is raised and names the entry

    Returns a list with (model, mask, report) for each entry, in the same order. Except for the times in the report, each
    result is bit-identical to that of estimateHomography. If usacv20.progress stops the call, the mask of an entry that was
    not begun has the shape (0, 1). The global interpreter lock is released during the call."""
    return estimateMany(ProblemType.HOMOGRAPHY, points1, points2, params, threads, returnExceptions)


def estimateFundamental(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                        mask: _Mask = None) -> _Estimate:
    """Estimates the fundamental matrix F with x2^T F x1 = 0.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and
        memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not
        all 1 (confidences) raises usacv20.error
    params -- Params; None: the default. params.threshold is the maximum Sampson distance in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, rank 2, unit Frobenius norm; None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.FUNDAMENTAL, points1, points2, params, mask)


def estimateFundamentals(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateFundamental."""
    return estimateMany(ProblemType.FUNDAMENTAL, points1, points2, params, threads, returnExceptions)


def estimateEssential(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                      cameraMatrix2: Union[npt.ArrayLike, Params, None] = None, distCoeffs1: Optional[npt.ArrayLike] = None,
                      distCoeffs2: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                      mask: _Mask = None) -> _Estimate:
    """Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

    estimateEssential(points1, points2, cameraMatrix[, params[, mask]])
    estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2[, distCoeffs1[, distCoeffs2[, params[, mask]]]])

    points1, points2 -- N points of each image in pixels: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any
        type and memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1
        that are not all 1 (confidences) raises usacv20.error
    cameraMatrix1, cameraMatrix2 -- 3x3 camera matrices of image 1 and image 2; cameraMatrix2 None: the same as cameraMatrix1
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 distortion coefficients of camera 1 and camera 2, as in cv2.undistortPoints;
        None: no distortion
    params -- Params; None: the default. params.threshold is the maximum Sampson distance in pixels. On the normalized image
        planes, a pixel is the mean of 1 / f over both cameras, with f = (fx + fy) / 2. If the cameras differ, it is thus
        smaller than a pixel of the camera with the shorter focal length and larger than that of the other
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x3 array of float64, singular values (1, 1, 0)/sqrt(2); None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    cameraMatrix2, distCoeffs1, params, mask = oneOrTwoCameras(cameraMatrix2, distCoeffs1, distCoeffs2, params, mask)
    return estimate(ProblemType.ESSENTIAL, points1, points2, params, mask, cameraMatrix1, cameraMatrix2, distCoeffs1,
                    distCoeffs2)


def estimateEssentials(points1: _Lists, points2: _Lists, cameraMatrices1: _Arrays, cameraMatrices2: _Arrays = None,
                       distCoeffs1: _Arrays = None, distCoeffs2: _Arrays = None, params: _ParamsOfEach = None,
                       threads: int = 0, returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateEssential.

    cameraMatrices1, cameraMatrices2, distCoeffs1, distCoeffs2 -- one array for all estimations, or a list with an array for
        each. A camera matrix is a 3x3 array; None for image 2: the same as for image 1. Distortion coefficients None: no
        distortion"""
    return estimateMany(ProblemType.ESSENTIAL, points1, points2, params, threads, returnExceptions, cameraMatrices1,
                        cameraMatrices2, distCoeffs1, distCoeffs2)


def estimateAffinity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                       mask: _Mask = None) -> _Estimate:
    """Estimates the affine map from image 1 to image 2, x2 = A x1 + t.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and
        memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not
        all 1 (confidences) raises usacv20.error
    params -- Params; None: the default. params.threshold is the maximum distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, [A t], as returned by cv2.estimateAffine2D and used by cv2.warpAffine; None if there is no
        model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.AFFINITY, points1, points2, params, mask)


def estimateAffinities2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                         returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateAffinity2D."""
    return estimateMany(ProblemType.AFFINITY, points1, points2, params, threads, returnExceptions)


def estimateSimilarity2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the similarity (rotation, uniform scale and translation) from image 1 to image 2.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and
        memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not
        all 1 (confidences) raises usacv20.error
    params -- Params; None: the default. params.threshold is the maximum distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, rows (a, -b, x) and (b, a, y), as returned by cv2.estimateAffinePartial2D; None if there is
        no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.SIMILARITY, points1, points2, params, mask)


def estimateSimilarities2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateSimilarity2D."""
    return estimateMany(ProblemType.SIMILARITY, points1, points2, params, threads, returnExceptions)


def estimateAbsolutePose(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                         distCoeffs: Optional[npt.ArrayLike] = None, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the pose of a calibrated camera from 3-D points and their images: x ~ K (R X + t).

    objectPoints -- N 3-D points: Nx3, 3xN, Nx1x3 or 1xNx3
    imagePoints -- their N image points in pixels, in the forms of the points of estimateHomography
    cameraMatrix -- 3x3 camera matrix K
    distCoeffs -- 4, 5, 8, 12 or 14 distortion coefficients, as in cv2.projectPoints; None: no distortion
    params -- Params; None: the default. params.threshold is the maximum reprojection error in pixels, in the original
        (distorted) image
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [R t]; None if there is no model. cv2.Rodrigues turns R into a vector
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.ABSOLUTE_POSE, objectPoints, imagePoints, params, mask, cameraMatrix, None,
                    distCoeffs, names=POSE)


def estimateAbsolutePoses(objectPoints: _Lists, imagePoints: _Lists, cameraMatrices: _Arrays, distCoeffs: _Arrays = None,
                          params: _ParamsOfEach = None, threads: int = 0, returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateAbsolutePose.

    cameraMatrices, distCoeffs -- one array for all estimations, or a list with an array for each. A camera matrix is a 3x3
        array. Distortion coefficients None: no distortion"""
    return estimateMany(ProblemType.ABSOLUTE_POSE, objectPoints, imagePoints, params, threads, returnExceptions,
                        cameraMatrices, None, distCoeffs, names=POSES)


def estimateRigid3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                    mask: _Mask = None) -> _Estimate:
    """Estimates the rigid motion that maps 3-D points to their counterparts: X2 = R X1 + t.

    points1, points2 -- N 3-D points and their N counterparts: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params; None: the default. params.threshold is the maximum distance between R X1 + t and X2, in the unit of the
        points; the default 1.5 is therefore rarely suitable
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [R t]; None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.RIGID_3D, points1, points2, params, mask)


def estimateRigids3D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                     returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateRigid3D."""
    return estimateMany(ProblemType.RIGID_3D, points1, points2, params, threads, returnExceptions)


def estimateSimilarity3D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                         mask: _Mask = None) -> _Estimate:
    """Estimates the similarity (rotation, uniform scale and translation) between 3-D points: X2 = s R X1 + t, s > 0.

    points1, points2 -- N 3-D points and their N counterparts: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params; None: the default. params.threshold is the maximum distance between s R X1 + t and X2, in the unit of
        points2
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 3x4 array of float64, [s R t]; None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.SIMILARITY_3D, points1, points2, params, mask)


def estimateSimilarities3D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateSimilarity3D."""
    return estimateMany(ProblemType.SIMILARITY_3D, points1, points2, params, threads, returnExceptions)


def estimateTranslation2D(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                          mask: _Mask = None) -> _Estimate:
    """Estimates the translation from image 1 to image 2, x2 = x1 + t.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and
        memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not
        all 1 (confidences) raises usacv20.error
    params -- Params; None: the default. params.threshold is the maximum distance in image 2 in pixels
    mask -- Nx1 array of uint8 or bool that receives the mask, or None

    Returns (model, mask, report):
    model -- 2x3 array of float64, rows (1, 0, x) and (0, 1, y), as used by cv2.warpAffine and of the form of
        estimateAffinity2D; cv2.estimateTranslation2D of OpenCV 5 returns its last column; None if there is no model
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report; report.stop is the reason why the search ended, or why there is no model

    Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the
    argument."""
    return estimate(ProblemType.TRANSLATION_2D, points1, points2, params, mask)


def estimateTranslations2D(points1: _Lists, points2: _Lists, params: _ParamsOfEach = None, threads: int = 0,
                           returnExceptions: bool = False) -> _Estimates:
    """Like estimateHomographies, but runs estimateTranslation2D."""
    return estimateMany(ProblemType.TRANSLATION_2D, points1, points2, params, threads, returnExceptions)
