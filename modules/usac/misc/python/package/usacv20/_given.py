# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Functions without a search: least-squares fit to given points, and errors of a given model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np

from ._arguments import array, optionalArray
from ._backend import native
from ._estimate import NO_POINTS, problemOf
from ._params import Params, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Estimate

    _Optional = Optional[npt.ArrayLike]


def _cameras(cameraMatrix1: Any, cameraMatrix2: Any, distCoeffs1: Any, distCoeffs2: Any) -> Tuple[Any, Any, Any, Any]:
    return (optionalArray(cameraMatrix1, "cameraMatrix1"), optionalArray(cameraMatrix2, "cameraMatrix2"),
            optionalArray(distCoeffs1, "distCoeffs1"), optionalArray(distCoeffs2, "distCoeffs2"))


def _result(found: Tuple[Any, Any, Any]) -> _Estimate:
    model, mask, report = found
    return model, NO_POINTS.copy() if mask is None else mask, Report._of(report)


def fitModel(problem: Union[int, str], points1: npt.ArrayLike, points2: npt.ArrayLike, weights: _Optional = None, chosen: _Optional = None,
             params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
             distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> _Estimate:
    """Fits a model to all points or to chosen points by least squares without a search, as OpenCV's
    method 0 does.

    problem -- ProblemType, or its name
    points1, points2 -- N points each, as the first two arguments of the function estimate* of the
    problem
    weights -- N weights of the squared errors, at least 0; None: all 1
    chosen -- N numbers or truth values, nonzero for points to use, for example the mask of an
    estimation; None: all points
    params -- Params; `threshold` determines the mask, `residual` the error that is minimized
    cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 -- if that function has them; for a
    single camera, the first of each

    Returns (model, mask, report) as the function estimate* of the problem. report.stop is
    STOP_NO_SEARCH, or the reason why there is no model. Wrong matches are not excluded and distort
    the model."""
    return _result(native.fitModel(problemOf(problem), array(points1, "points1"), array(points2, "points2"), optionsOf(params),
                                   optionalArray(weights, "weights"), optionalArray(chosen, "chosen"),
                                   *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)))


def refineModel(problem: Union[int, str], model: npt.ArrayLike, points1: npt.ArrayLike, points2: npt.ArrayLike, chosen: _Optional = None,
                params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
                distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> _Estimate:
    """Refines a known model.

    model -- as the function estimate* of the problem returns it
    chosen -- N numbers or truth values, nonzero for inliers: least squares over these, starting
    from the model. None: the final polishing of an estimation (params.polishing), starting from the
    model, with the inliers that it finds

    The other arguments and the results are those of fitModel."""
    return _result(native.refineModel(problemOf(problem), array(model, "model"), array(points1, "points1"),
                                      array(points2, "points2"), optionsOf(params), optionalArray(chosen, "chosen"),
                                      *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)))


def modelErrors(problem: Union[int, str], model: npt.ArrayLike, points1: npt.ArrayLike, points2: npt.ArrayLike,
                params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
                distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> npt.NDArray[np.float64]:
    """Returns the error of each point under a model. The mask of an estimation is 1 exactly where
    this error is at most report.threshold.

    model -- as the function estimate* of the problem returns it
    params -- Params, of which only the field residual is used

    The other arguments are those of fitModel. Returns an Nx1 array of float64, not squared, in the
    unit of params.threshold (pixels; motions of space: the unit of points2). The error is not
    finite for points that are not finite, that are behind a camera, or that its lens cannot image.
    """
    found = native.modelErrors(problemOf(problem), array(model, "model"), array(points1, "points1"), array(points2, "points2"),
                               optionsOf(params), *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2))
    return np.empty((0, 1)) if found is None else found
