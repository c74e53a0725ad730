# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""How sure a model is: what Report.covariance means for its entries, for the motion of a camera, and for points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from ._arguments import array, optionalArray
from ._backend import native
from ._estimate import problemOf

if TYPE_CHECKING:
    import numpy.typing as npt

    _Numbers = npt.NDArray[np.float64]
    _Optional = Optional[npt.ArrayLike]


def tangentOfModel(problem: Union[int, str], model: npt.ArrayLike) -> _Numbers:
    """Derivatives of the entries of a model by the parameters of Report.covariance, an n x d array: n entries row by row.

    problem -- ProblemType, or its name, see fitModel
    model -- as the function estimate* of the problem returns it; another scale of H, F and E is changed to that first"""
    found: Any = native.tangentOfModel(problemOf(problem), array(model, "model"))
    result: _Numbers = found
    return result


def covarianceOfModel(problem: Union[int, str], model: npt.ArrayLike, covariance: npt.ArrayLike) -> _Numbers:
    """Covariance of the entries of a model, n x n, of rank d at most: T C T^T with T of tangentOfModel.

    covariance -- Report.covariance

    The other arguments are those of tangentOfModel."""
    found: Any = native.covarianceOfModel(problemOf(problem), array(model, "model"), array(covariance, "covariance"))
    result: _Numbers = found
    return result


def covarianceOfPose(essential: npt.ArrayLike, covariance: npt.ArrayLike, R: npt.ArrayLike, t: npt.ArrayLike) -> _Numbers:
    """Covariance of rotation and direction of translation from that of an essential matrix.

    essential -- 3x3, a multiple of [t]x R
    covariance -- Report.covariance of it, 5x5
    R, t -- the motion, as estimateRelativePose or cv2.recoverPose has it; any length of t

    Returns a 6x6 array of rank 5: of the rotation vector w in radians, where exp(w) R is the rotation with an error, and of t / |t|,
    whose errors are perpendicular to it."""
    found: Any = native.covarianceOfPose(array(essential, "essential"), array(covariance, "covariance"), array(R, "R"), array(t, "t"))
    result: _Numbers = found
    return result


def pointCovariance(problem: Union[int, str], model: npt.ArrayLike, covariance: npt.ArrayLike, points1: npt.ArrayLike,
                    points2: _Optional = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None) -> _Numbers:
    """How sure a model is at given points: the error that the model alone makes there, in squared units of points2.

    problem, model, covariance -- as for covarianceOfModel
    points1 -- N points of image 1, or of space
    points2 -- F, E: their N counterparts
    cameraMatrix1, cameraMatrix2 -- 3x3, for ESSENTIAL and, the first, ABSOLUTE_POSE; points of E are in pixels without distortion

    Returns an N x k x k array, the covariance of the place to which each point is mapped, projected (without distortion) or moved:
    k = 2, motions of space 3; F and E: N x 1 x 1, the variance of the signed distance from the epipolar line in image 2. NaN where
    that is not finite."""
    found: Any = native.pointCovariance(problemOf(problem), array(model, "model"), array(covariance, "covariance"),
                                        array(points1, "points1"), optionalArray(points2, "points2"),
                                        optionalArray(cameraMatrix1, "cameraMatrix1"),
                                        optionalArray(cameraMatrix2, "cameraMatrix2"))
    if found is None:
        return np.empty((0, 1, 1))
    size = round(found.shape[1] ** 0.5)
    result: _Numbers = found.reshape(-1, size, size)
    return result
