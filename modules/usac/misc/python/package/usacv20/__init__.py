# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""USACv20: robust estimation of homographies, affinities, similarities, fundamental and essential matrices, camera
poses, motions of space.

Three levels of use:

1. A flag in the place of cv2.RANSAC: cv2.USACV20, cv2.USACV20_FAST, cv2.USACV20_ACCURATE, cv2.USACV20_PROSAC,
   cv2.USACV20_MAGSAC, cv2.USACV20_PARALLEL.

       H, mask = cv2.findHomography(points1, points2, cv2.USACV20, 3.0)
       A, inliers = cv2.estimateAffine2D(points1, points2, None, cv2.USACV20, 3.0)
       found, rvec, tvec, inliers = cv2.solvePnPRansac(objectPoints, imagePoints, K, None, flags=cv2.USACV20)

   The flags are integers, from 0x4000 on; a program may keep them in a variable or a file.

2. All options, match scores among them, in the place of the flag.

       params = cv2.usacv20.Params()
       params.scores = [match.distance for match in matches]
       H, mask = cv2.findHomography(points1, points2, params)

3. The same with a report of what the estimator learned.

       H, mask, report = cv2.usacv20.estimateHomography(points1, points2, params)

Where there is no model (too few or degenerate points, or random ones, see Params.significance) the model is None, the mask zero,
and report.stop says why; report.chance bounds the probability that random matches give as good a model. A flag does not tell
whether maxIters ended the search; with Params.fromMethod(cv2.USACV20) report.stop == STOP_MAX_ITERATIONS does.

The loader of cv2 imports this package and adds all else of the extension module's own `usacv20` to it: the enumerations,
Params, Report, isUsacV20Method, and find*, estimateAffine* and solvePnPRansac as the extension has them (with flags of the
module and of OpenCV alike).
"""

import functools
import numbers

import cv2

_native = getattr(cv2._native, "usacv20", None)
if _native is None:  # left over from another build; an ImportError makes the loader go on without this package
    raise ImportError("cv2 was built without the module usac")

Params = _native.Params
UsacParams = Params  # the same class by another name

_FLAGS = frozenset(value for name, value in vars(cv2._native).items() if name.startswith("USACV20"))


def estimateHomography(points1, points2, params=None, mask=None):
    """estimateHomography(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates the homography that maps image 1 to image 2.

    points1, points2 -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2 of any type that OpenCV knows; with 3 in the
        place of 2, homogeneous coordinates
    params -- Params; params.threshold is the distance in image 2 in pixels
    mask -- Nx1 array of uint8 that receives the mask, if given
    retval -- 3x3 array of float64, or None if there is none
    mask -- Nx1 array of uint8, 1 for inliers
    report -- Report: report.stop says why the search ended or why there is no model
    """
    return _native.estimateHomography(points1, points2, params, mask)


def estimateAffinity2D(points1, points2, params=None, mask=None):
    """estimateAffinity2D(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates the affine map of image 1 to image 2. Arguments and results are those of estimateHomography, but retval is the
    2x3 array [A t] of cv2.estimateAffine2D and cv2.warpAffine, x2 = A x1 + t.
    """
    return _native.estimateAffinity2D(points1, points2, params, mask)


def estimateSimilarity2D(points1, points2, params=None, mask=None):
    """estimateSimilarity2D(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates rotation, uniform scale and translation from image 1 to image 2. Arguments and results are those of
    estimateAffinity2D; retval has the rows (a, -b, x) and (b, a, y), as that of cv2.estimateAffinePartial2D.
    """
    return _native.estimateSimilarity2D(points1, points2, params, mask)


def estimateFundamental(points1, points2, params=None, mask=None):
    """estimateFundamental(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates the fundamental matrix F with x2^T F x1 = 0. Arguments and results are those of estimateHomography;
    params.threshold is the Sampson distance in pixels.
    """
    return _native.estimateFundamental(points1, points2, params, mask)


def estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2=None, distCoeffs1=None, distCoeffs2=None,
                      params=None, mask=None):
    """estimateEssential(points1, points2, cameraMatrix[, params[, mask]]) -> retval, mask, report
    estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2[, distCoeffs1[, distCoeffs2[, params[, mask]]]])
        -> retval, mask, report

    Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

    cameraMatrix1, cameraMatrix2 -- 3x3 camera matrices; without the second the first holds for both images
    distCoeffs1, distCoeffs2 -- distortion as in cv2.undistortPoints; None: none

    The other arguments and the results are those of estimateHomography; params.threshold is the Sampson distance in pixels.
    """
    if isinstance(cameraMatrix2, Params):  # the first of the two forms
        cameraMatrix2, params, distCoeffs1, mask = None, cameraMatrix2, None, distCoeffs1 if mask is None else mask
    return _native.estimateEssential(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2,
                                     params, mask)


def estimateAbsolutePose(objectPoints, imagePoints, cameraMatrix, distCoeffs=None, params=None, mask=None):
    """estimateAbsolutePose(objectPoints, imagePoints, cameraMatrix[, distCoeffs[, params[, mask]]]) -> retval, mask, report

    Estimates the pose of a calibrated camera from points of space and their images, x ~ K (R X + t).

    objectPoints -- N points of space: Nx3, 3xN, Nx1x3 or 1xNx3
    imagePoints -- N pixels, as the points of estimateHomography
    cameraMatrix -- 3x3 camera matrix
    distCoeffs -- distortion as in cv2.projectPoints; None: none
    params -- Params; params.threshold is the reprojection error in pixels of the image as it was taken
    retval -- 3x4 array of float64, [R t], or None if there is none

    The other arguments and results are those of estimateHomography.
    """
    return _native.estimateAbsolutePose(objectPoints, imagePoints, cameraMatrix, distCoeffs, params, mask)


def estimateRigid3D(points1, points2, params=None, mask=None):
    """estimateRigid3D(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates rotation and translation of space, X2 = R X1 + t.

    points1, points2 -- N points of each space in one unit: Nx3, 3xN, Nx1x3 or 1xNx3
    params -- Params; params.threshold is the distance in space 2, in the unit of the points: its default will rarely do
    retval -- 3x4 array of float64, [R t], or None if there is none

    The other arguments and results are those of estimateHomography.
    """
    return _native.estimateRigid3D(points1, points2, params, mask)


def estimateSimilarity3D(points1, points2, params=None, mask=None):
    """estimateSimilarity3D(points1, points2[, params[, mask]]) -> retval, mask, report

    Estimates rotation, uniform scale and translation of space, X2 = s R X1 + t, s > 0. Arguments and results are those
    of estimateRigid3D; points1 may have any unit, and retval is [s R t].
    """
    return _native.estimateSimilarity3D(points1, points2, params, mask)


def _isFlag(value):
    return isinstance(value, numbers.Integral) and value in _FLAGS


def _isNumberOrNone(value):
    return value is None or isinstance(value, numbers.Real)


def _essentialMethodPlace(args):
    if len(args) > 2 and isinstance(args[2], numbers.Real):
        return 4  # (points1, points2, focal, pp, method, ...)
    if len(args) > 4 and not _isNumberOrNone(args[4]):
        return 6  # (points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2, method, ...)
    return 3      # (points1, points2, cameraMatrix, method, ...)


def _argument(name, place, args, kwargs):
    if name in kwargs:
        return kwargs[name]
    return args[place] if place < len(args) else None


def _divert(name, methodPlace, paramsPlace, method="method"):
    """Makes cv2.<name> call usacv20.<name> where the arguments hold a flag or a Params of this module.

    methodPlace -- function that tells from the positional arguments at which place `method` is among them
    paramsPlace -- the place of `params`
    method -- name of the argument for the flag
    All other calls go to OpenCV's function as they are.
    """
    original = getattr(cv2._native, name)
    ours = getattr(_native, name)

    @functools.wraps(original)
    def find(*args, **kwargs):
        if (_isFlag(_argument(method, methodPlace(args), args, kwargs))
                or isinstance(_argument("params", paramsPlace, args, kwargs), Params)):
            return ours(*args, **kwargs)
        return original(*args, **kwargs)

    find.__doc__ = "{}\n\nWith `{}` one of cv2.USACV20* or `params` a cv2.usacv20.Params:\n\n{}".format(
        original.__doc__, method, ours.__doc__)
    setattr(cv2, name, find)


_divert("findHomography", lambda args: 2, 2)
_divert("findFundamentalMat", lambda args: 2, 2)
_divert("findEssentialMat", _essentialMethodPlace, 6)
_divert("estimateAffine2D", lambda args: 3, 2)
_divert("estimateAffinePartial2D", lambda args: 3, 2)
_divert("solvePnPRansac", lambda args: 11, 7, "flags")
