# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Functions without a search: fitting a model to given points, refining a known model, and
computing the errors of points under a model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np

from ._arguments import array, optionalArray, shown
from ._backend import native
from ._errors import fail
from ._estimate import NO_POINTS, pointsAndOptions, problemOf
from ._params import Params
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Estimate

    _Optional = Optional[npt.ArrayLike]

_MOST_ENTRIES = 12  # number of entries of the largest model


def _cameras(cameraMatrix1: Any, cameraMatrix2: Any, distCoeffs1: Any, distCoeffs2: Any) -> Tuple[Any, Any, Any, Any]:
    return (optionalArray(cameraMatrix1, "cameraMatrix1"), optionalArray(cameraMatrix2, "cameraMatrix2"),
            optionalArray(distCoeffs1, "distCoeffs1"), optionalArray(distCoeffs2, "distCoeffs2"))


def _model(value: Any) -> npt.NDArray[Any]:
    """Converts a model with array(). This is done before the points are read, so that the message is
    about the model if the caller has passed points in its place."""
    given = array(value, "model")
    if given.size > _MOST_ENTRIES:
        raise fail("model: a matrix of at most {} numbers is expected, not {}".format(_MOST_ENTRIES, shown(given)))
    return given


def _perPoint(value: Any, name: str, points: Tuple[Any, ...], instead: str) -> Any:
    """Converts a list with one number for each point, using optionalArray(). Raises usacv20.error for
    an empty list if there are points, because C++ would treat an empty list like None."""
    given = optionalArray(value, name)
    if given is not None and given.size == 0 and points[0].size > 0:
        raise fail("{}: one number for each point is expected, or None for {}, not an empty list".format(name, instead))
    return given


def _result(found: Tuple[Any, Any, Any]) -> _Estimate:
    model, mask, report = found
    return model, NO_POINTS.copy() if mask is None else mask, Report._ofCall(report)


def fitModel(problem: Union[int, str], points1: npt.ArrayLike, points2: npt.ArrayLike, weights: _Optional = None, chosen: _Optional = None,
             params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
             distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> _Estimate:
    """Fits a model to all points, or to a subset, by least squares without a search, like OpenCV's
    method 0.

    problem -- ProblemType, or its name as a string
    points1, points2 -- N points each, in the layouts that the function estimate* of the problem
    accepts; ABSOLUTE_POSE: objectPoints and imagePoints
    weights -- N weights of the squared errors, at least 0; None: all are 1
    chosen -- mask of the points to fit, for example the inliers: N numbers or truth values, 0 for
    points that are left out; None: all points
    params -- Params; `threshold` is the threshold of the mask, and `residual` selects the error that
    is minimized
    cameraMatrix1, distCoeffs1 -- for ESSENTIAL and ABSOLUTE_POSE
    cameraMatrix2, distCoeffs2 -- for ESSENTIAL; None: the same as cameraMatrix1, and no distortion

    Returns (model, mask, report) like the function estimate* of the problem. report.stop is
    STOP_NO_SEARCH, gives the reason why there is no model, or is STOP_TIME or STOP_CANCELLED if the
    fit ended early (Params.maxTime, progress). The fit is not robust: outliers are
    not detected and affect it fully."""
    number = problemOf(problem)
    given = pointsAndOptions(number, points1, points2, params)
    return _result(native.fitModel(number, *given, _perPoint(weights, "weights", given, "equal weights"),
                                   _perPoint(chosen, "chosen", given, "all points"),
                                   *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)))


def refineModel(problem: Union[int, str], model: npt.ArrayLike, points1: npt.ArrayLike, points2: npt.ArrayLike, chosen: _Optional = None,
                params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
                distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> _Estimate:
    """Refines a known model.

    model -- as the function estimate* of the problem returns it
    chosen -- mask of the inliers: N numbers or truth values, 0 for other points. With a mask, a
    least-squares fit to these inliers is made, starting from the model. None: the model is polished
    as at the end of an estimation (params.polishing), which selects the inliers itself

    The other arguments and the results are those of fitModel."""
    number = problemOf(problem)
    start, given = _model(model), pointsAndOptions(number, points1, points2, params)
    return _result(native.refineModel(number, start, *given, _perPoint(chosen, "chosen", given, "all points"),
                                      *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)))


def modelErrors(problem: Union[int, str], model: npt.ArrayLike, points1: npt.ArrayLike, points2: npt.ArrayLike,
                params: Optional[Params] = None, cameraMatrix1: _Optional = None, cameraMatrix2: _Optional = None,
                distCoeffs1: _Optional = None, distCoeffs2: _Optional = None) -> npt.NDArray[np.float64]:
    """Returns the error of each point under a model. The mask of an estimation is 1 exactly where
    this error is at most report.threshold.

    model -- as the function estimate* of the problem returns it
    params -- Params, of which only the fields `residual` and `sigmas` are used

    The other arguments are those of fitModel. Returns an Nx1 array of float64: the errors, not
    squared, in the unit of params.threshold (pixels; 3-D motions: the unit of points2). The error
    is infinite or NaN for points that are not finite, outside the field of view of a lens, or
    (absolute pose) behind the camera."""
    number = problemOf(problem)
    found = native.modelErrors(number, _model(model), *pointsAndOptions(number, points1, points2, params),
                               *_cameras(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2))
    return np.empty((0, 1)) if found is None else found
