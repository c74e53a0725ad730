# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Uncertainty of a model. The functions propagate Report.covariance to the entries of the model, to
the motion of a camera, and to points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from ._arguments import array, optionalArray, points
from ._backend import native
from ._enumerations import ProblemType
from ._estimate import inPlane, problemOf

if TYPE_CHECKING:
    import numpy.typing as npt

    _Numbers = npt.NDArray[np.float64]
    _Optional = Optional[npt.ArrayLike]


def tangentOfModel(problem: Union[int, str], model: npt.ArrayLike) -> _Numbers:
    """Returns the derivatives of the n entries of a model (in row-major order) with respect to its d
    parameters, whose covariance is Report.covariance: an n x d array.

    The parameters of H, F and E are directions in which a matrix of unit norm can vary and remain
    valid; those of other models are listed in help(usacv20.Report).

    problem -- ProblemType, or its name as a string
    model -- as the function estimate* of the problem returns it. H, F and E are first converted to
    the scale and sign of the models that estimate* returns"""
    found: Any = native.tangentOfModel(problemOf(problem), array(model, "model"))
    result: _Numbers = found
    return result


def covarianceOfModel(problem: Union[int, str], model: npt.ArrayLike, covariance: npt.ArrayLike) -> _Numbers:
    """Returns the covariance of the entries of a model, an n x n array of rank d or less: T C T^T,
    where T is the result of tangentOfModel and C is `covariance`.

    covariance -- Report.covariance, d x d

    The other arguments are those of tangentOfModel."""
    found: Any = native.covarianceOfModel(problemOf(problem), array(model, "model"), array(covariance, "covariance"))
    result: _Numbers = found
    return result


def covarianceOfPose(essential: npt.ArrayLike, covariance: npt.ArrayLike, R: npt.ArrayLike, t: npt.ArrayLike) -> _Numbers:
    """Returns the covariance of the rotation and of the direction of the translation, from the
    covariance of an essential matrix.

    essential -- 3x3, a multiple of [t]x R
    covariance -- Report.covariance of this matrix, 5x5
    R, t -- rotation and translation that estimateRelativePose or cv2.recoverPose returns; t can
    have any length

    Returns a 6x6 array of rank 5. The first three rows and columns belong to the rotation vector w
    in radians, where exp(w) R is the rotation with an error; the last three belong to t / |t|, whose
    errors are perpendicular to t."""
    found: Any = native.covarianceOfPose(array(essential, "essential"), array(covariance, "covariance"), array(R, "R"), array(t, "t"))
    result: _Numbers = found
    return result


def pointCovariance(problem: Union[int, str], model: npt.ArrayLike, covariance: npt.ArrayLike, points1: npt.ArrayLike,
                    points2: _Optional = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None) -> _Numbers:
    """Returns the uncertainty of a model at given points: the covariance that the error of the
    model alone causes there, without the noise of a measured point, in squared units of points2
    (pixels).

    problem, model, covariance -- as in covarianceOfModel
    points1 -- N points of image 1; absolute pose and 3-D motions: 3-D points
    points2 -- F and E: the N corresponding points of image 2; not used for other problems
    cameraMatrix1 -- 3x3, for ESSENTIAL and ABSOLUTE_POSE
    cameraMatrix2 -- 3x3, for ESSENTIAL; None: the same as cameraMatrix1. Points for E are in pixels
    without distortion

    Returns an N x k x k array: the covariance of the point to which each point is mapped, projected
    (without distortion) or moved, with k = 2 in images and k = 3 in space. F and E: N x 1 x 1, the
    variance of the signed distance of the point of image 2 from its epipolar line. The entries are
    NaN where the result is not finite."""
    number = problemOf(problem)
    plane1, plane2 = inPlane(number)
    found: Any = native.pointCovariance(number, array(model, "model"), array(covariance, "covariance"),
                                        points(points1, "points1", plane1),
                                        None if points2 is None else points(points2, "points2", plane2),
                                        optionalArray(cameraMatrix1, "cameraMatrix1"),
                                        optionalArray(cameraMatrix2, "cameraMatrix2"))
    size = 1 if number in (ProblemType.FUNDAMENTAL, ProblemType.ESSENTIAL) else 2 if plane2 else 3
    result: _Numbers = np.empty((0, size, size)) if found is None else found.reshape(-1, size, size)
    return result
