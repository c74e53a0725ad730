# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""solvePnPRansac with OpenCV's arguments. Either a flag or a Params gives the options."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, overload

import numpy as np

from ._arguments import array, bind, checkOutput, integer, isInteger, optionalArray, output, points, real, shown, signed
from ._backend import IN_TREE, native
from ._enumerations import USACV20, ProblemType
from ._errors import fail, warn
from ._estimate import POSE, pointsAndOptions
from ._find import flag, isOptions, refuseBesideParams, warnOf
from ._params import Params

if TYPE_CHECKING:
    import numpy.typing as npt

    _Vector = Optional[npt.NDArray[np.float64]]
    _Indices = Optional[npt.NDArray[np.int32]]

_NAME = "solvePnPRansac"
_FLAG = ("objectPoints", "imagePoints", "cameraMatrix", "distCoeffs", "rvec", "tvec", "useExtrinsicGuess", "iterationsCount",
         "reprojectionError", "confidence", "inliers", "flags")
_PARAMS = ("objectPoints", "imagePoints", "cameraMatrix", "distCoeffs", "rvec", "tvec", "inliers", "params")
_DEFAULTS: Dict[str, Any] = dict(rvec=None, tvec=None, useExtrinsicGuess=False, iterationsCount=100, reprojectionError=8.0,
                                 confidence=0.99, inliers=None, flags=USACV20)


def _opencvFlag(value: int) -> int:
    """Converts a flag to its value in the OpenCV that this package was built with. The values of
    SOLVEPNP_* differ between OpenCV 4 and 5: if a cv2 of the other version was imported, the flag
    is interpreted as a value of that cv2 and converted by name."""
    cv2 = sys.modules.get("cv2")
    own: Dict[str, int] = {} if IN_TREE else native.solvePnPFlags
    theirs: Dict[str, int] = {name: int(getattr(cv2, name)) for name in dir(cv2)
                              if name.startswith("SOLVEPNP_") and name != "SOLVEPNP_MAX_COUNT"}
    if all(theirs.get(name, number) == number for name, number in own.items()):
        return value
    if not 0 <= value <= max(max(own.values()), max(theirs.values())):
        return value  # a flag with the same value in all versions, or no flag
    names = sorted(name for name, number in theirs.items() if number == value)
    for name in names:
        if name in own:
            return own[name]
    raise fail("flags: {} is {} of the imported cv2 {}, which the OpenCV of this package does not have".format(
        value, names[0] if names else "no flag", getattr(cv2, "__version__", "")))


def _truth(value: Any, name: str) -> bool:
    if value is None or isinstance(value, (bool, np.bool_)) or isInteger(value):
        return bool(value)
    raise fail("{}: True or False is expected, not {}".format(name, shown(value)))


@overload
def solvePnPRansac(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                   distCoeffs: Optional[npt.ArrayLike], rvec: _Vector = ..., tvec: _Vector = ..., useExtrinsicGuess: bool = ...,
                   iterationsCount: int = ..., reprojectionError: float = ..., confidence: float = ..., inliers: _Indices = ...,
                   flags: int = ...) -> Tuple[bool, _Vector, _Vector, _Indices]: ...
@overload
def solvePnPRansac(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                   distCoeffs: Optional[npt.ArrayLike], rvec: _Vector = ..., tvec: _Vector = ..., inliers: _Indices = ..., *,
                   params: Params) -> Tuple[bool, npt.NDArray[Any], _Vector, _Vector, _Indices]: ...
@overload
def solvePnPRansac(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                   distCoeffs: Optional[npt.ArrayLike], rvec: _Vector, tvec: _Vector, inliers: _Indices,
                   params: Params) -> Tuple[bool, npt.NDArray[Any], _Vector, _Vector, _Indices]: ...
@overload
def solvePnPRansac(objectPoints: npt.ArrayLike, imagePoints: npt.ArrayLike, cameraMatrix: npt.ArrayLike,
                   distCoeffs: Optional[npt.ArrayLike], rvec: _Vector = ..., tvec: _Vector = ..., *, flags: Params,
                   inliers: _Indices = ...) -> Tuple[bool, _Vector, _Vector, _Indices]: ...


@signed(_FLAG, 4, _DEFAULTS)
def solvePnPRansac(*args: Any, **kwargs: Any) -> Any:
    """solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs[, rvec[, tvec[, useExtrinsicGuess[, iterationsCount[,
        reprojectionError[, confidence[, inliers[, flags]]]]]]]]) -> retval, rvec, tvec, inliers
    solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs[, rvec[, tvec[, inliers[, params]]]])
        -> retval, cameraMatrix, rvec, tvec, inliers

    cv2.solvePnPRansac with a flag of this module or of OpenCV, or with all options: the pose of a camera, x ~ K (R X + t).

    objectPoints -- N 3-D points: Nx3, 3xN, Nx1x3 or 1xNx3, any number type
    imagePoints -- their N image points in pixels: Nx2, 2xN, Nx1x2 or 1xNx2
    cameraMatrix -- 3x3 camera matrix K
    distCoeffs -- 4, 5, 8, 12 or 14 distortion coefficients; None: no distortion
    rvec, tvec -- arrays of 3 float64 that receive rotation vector and translation, or None
    useExtrinsicGuess -- True: rvec and tvec hold an initial pose, which is scored and optimized before the first sample. They
        can then also be lists, arrays of other types or read-only arrays; these are not written to, and the pose is returned
        in new arrays. Default False
    iterationsCount -- maximum number of samples; default 100
    reprojectionError -- inlier threshold in pixels of the original (distorted) image; default 8
    confidence -- confidence of the search, see Params.confidence; default 0.99
    inliers -- array of int32 that receives the indices of the inliers if its size is their number, or None
    flags -- one of USACV20* (default USACV20) or a flag of OpenCV, which is passed to OpenCV. The values of SOLVEPNP_* differ
        between OpenCV 4 and 5; if a cv2 has been imported, they must be those of this cv2
    params -- Params. The form with this argument returns five results, as in OpenCV; a Params in place of `flags` is accepted,
        too, and then there are four results
    retval -- False if there is no pose; rvec and tvec are then returned as they were given
    rvec, tvec -- as results: 3x1 arrays of float64
    inliers -- as a result: Mx1 array of int32, the indices of the inliers in ascending order; None if there are no inliers"""
    options = isOptions(_NAME, _FLAG, "flags", 11, 7, args, kwargs)
    if options:
        v = bind(_NAME, _PARAMS, 4, dict(rvec=None, tvec=None, inliers=None), args, kwargs)
    else:
        v = bind(_NAME, _FLAG, 3, dict(_DEFAULTS, distCoeffs=None), args, kwargs)
    for name in ("rvec", "tvec", "inliers"):
        if not v.get("useExtrinsicGuess") or name == "inliers":
            checkOutput(v[name], name)
    if isinstance(v["inliers"], np.ndarray) and v["inliers"].dtype != np.int32:
        raise fail("inliers: an array of int32 is expected for the indices of the inliers, not of {}".format(v["inliers"].dtype))
    if options or isinstance(v["flags"], Params):
        if not options:
            refuseBesideParams(_NAME, v, _DEFAULTS, ("useExtrinsicGuess", "iterationsCount", "reprojectionError", "confidence"))
        camera = array(v["cameraMatrix"], "cameraMatrix")
        objectPoints, imagePoints, params = pointsAndOptions(
            ProblemType.ABSOLUTE_POSE, v["objectPoints"], v["imagePoints"], v["params" if options else "flags"], POSE)
        result = native.solvePnPRansacOfParams(objectPoints, imagePoints, camera, optionalArray(v["distCoeffs"], "distCoeffs"),
                                               params)
        warn(native.lastWarning())
        retval, rvec, tvec, inliers = _results(result, v)
        return (retval, camera, rvec, tvec, inliers) if options else (retval, rvec, tvec, inliers)
    return _results(_withFlag(v), v)


def _withFlag(v: Dict[str, Any]) -> Any:
    guess = _truth(v["useExtrinsicGuess"], "useExtrinsicGuess")
    # The arrays are copied, so that the caller's arrays do not change if there is no pose.
    rvec = array(v["rvec"], "rvec").copy() if guess and v["rvec"] is not None else None
    tvec = array(v["tvec"], "tvec").copy() if guess and v["tvec"] is not None else None
    method = flag(v["flags"], "flags")
    result = native.solvePnPRansac(
        points(v["objectPoints"], "objectPoints", False), points(v["imagePoints"], "imagePoints"),
        array(v["cameraMatrix"], "cameraMatrix"), optionalArray(v["distCoeffs"], "distCoeffs"), rvec, tvec, guess,
        integer(v["iterationsCount"], "iterationsCount", 100), real(v["reprojectionError"], "reprojectionError", 8.0),
        real(v["confidence"], "confidence", 0.99), _opencvFlag(method))
    warnOf(method)
    return result


def _results(result: Any, v: Dict[str, Any]) -> Tuple[Any, Any, Any, Any]:
    """Returns the results as cv2 does. They are also written to the caller's arrays if the types and
    sizes of these arrays fit."""
    retval, rvec, tvec, inliers = result
    if not retval:
        given = [value if value is None or isinstance(value, np.ndarray) else np.asarray(value) for value in (v["rvec"], v["tvec"])]
        return retval, rvec if given[0] is None else given[0], tvec if given[1] is None else given[1], inliers
    return retval, output(v["rvec"], rvec), output(v["tvec"], tvec), output(v["inliers"], inliers)
