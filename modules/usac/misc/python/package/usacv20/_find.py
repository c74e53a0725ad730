# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""findHomography, findFundamentalMat, estimateAffine2D and estimateAffinePartial2D with OpenCV's
arguments. Either a flag or a Params gives the options."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, overload

import numpy as np

from . import _arguments
from ._arguments import bind, checkMask, integer, isInteger, isOfAnother, outputMask, points, real, shown, signed
from ._backend import native
from ._enumerations import USACV20, ProblemType, UsacV20Method
from ._errors import calling, fail, warn
from ._estimate import estimate
from ._params import Params

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Mask

    _Found = Tuple[Optional[npt.NDArray[np.float64]], npt.NDArray[np.uint8]]


def isOptions(function: str, names: typing.Sequence[str], method: str, flagPlace: int, paramsPlace: int, args: Tuple[Any, ...],
              kwargs: Dict[str, Any]) -> bool:
    """Returns True if a call has the argument list with `params`, and False if it has the argument
    list with a flag. If the flag and `params` have different positions in these lists, a call with a
    Params in the position of the flag counts as a call with a flag. Raises usacv20.error if a Params
    is in any other position, or if both arguments are given by name."""
    if "params" in kwargs:
        if method in kwargs:
            raise fail("{}: params and {} are both given, but only one of them can select the options".format(function, method))
        return True
    for place, value in enumerate(args):
        if isinstance(value, Params):
            if place not in (flagPlace, paramsPlace):
                wanted = names[place] if place < len(names) else "no argument"
                raise fail("{}: a Params is the argument {} of {}, where {} is expected".format(
                    function, place + 1, function, wanted))
            return place == paramsPlace
    return False


def refuseBesideParams(function: str, values: Dict[str, Any], defaults: Dict[str, Any], others: typing.Sequence[str]) -> None:
    """Raises usacv20.error if one of the arguments `others` is given in addition to a Params. These
    arguments belong to calls with a flag; a Params has fields with the same meaning."""
    for name in others:
        if values[name] is not defaults[name] and values[name] is not None:
            raise fail("{}: {} is given together with a Params, which has a field for it".format(function, name))


def flag(value: Any, name: str = "method") -> int:
    """Returns a flag as an integer; None is replaced with USACV20."""
    other = isOfAnother(value, UsacV20Method) and type(value).__module__ == UsacV20Method.__module__
    if value is not None and (other or not isInteger(value)):
        raise fail("{}: one of the flags USACV20*, a flag of OpenCV or a Params is expected, not {}".format(name, shown(value)))
    return integer(value, name, int(USACV20))


def warnOf(method: int) -> None:
    """Gives the warning of a call with a flag, which has no report."""
    if native.isUsacV20Method(method):
        warn(native.lastWarning())


def found(result: Any, method: int, given: Any, name: str = "mask") -> Any:
    """Returns (model, mask) of a call with the flag `method`. `result` comes from the compiled part;
    its mask is written to the caller's array `given`, the argument `name`."""
    warnOf(method)
    model, mask = result
    return model, outputMask(given, mask, name)


_NAMES = {"from": "from_"}  # C++ name: Python name; `from` is a keyword of Python


def _find(problem: int, function: str, names: Tuple[str, ...], namesOfParams: Tuple[str, ...], defaults: Dict[str, Any],
          args: Tuple[Any, ...], kwargs: Dict[str, Any]) -> Any:
    """Calls the function of the compiled part with a flag, or estimates with a Params.

    names, namesOfParams -- the arguments of a call with a flag and with a Params; the last one of the
    latter is the mask
    defaults -- the optional arguments, with the numbers in the order of the function of the compiled part"""
    mask = namesOfParams[3]
    numbers = [name for name in defaults if name not in ("method", mask)]
    first, second = namesOfParams[:2]
    if isOptions(function, names, "method", names.index("method"), 2, args, kwargs):
        v = bind(function, namesOfParams, 3, {mask: None}, args, kwargs)
    else:
        v = bind(function, names, 2, defaults, args, kwargs)
        first, second = names[:2]
        if isinstance(v["method"], Params):
            refuseBesideParams(function, v, defaults, numbers)
            v["params"] = v["method"]
    if "params" in v:
        return estimate(problem, v[first], v[second], v["params"], v[mask], names=(first, second, "", "", "", ""),
                        maskName=mask)[:2]
    checkMask(v[mask], mask)
    method = flag(v["method"])
    low = 0 if "refineIters" in defaults else _arguments.INT_MIN
    values = [real(v[name], name, defaults[name]) if isinstance(defaults[name], float) else
              integer(v[name], name, defaults[name], low) for name in numbers]
    result = calling(_NAMES, getattr(native, function), points(v[first], first), points(v[second], second), method, *values)
    return found(result, method, v[mask], mask)


_HOMOGRAPHY = ("srcPoints", "dstPoints", "method", "ransacReprojThreshold", "mask", "maxIters", "confidence")
_HOMOGRAPHY_OF_PARAMS = ("srcPoints", "dstPoints", "params", "mask")
_HOMOGRAPHY_DEFAULTS: Dict[str, Any] = dict(method=USACV20, ransacReprojThreshold=3.0, mask=None, maxIters=2000, confidence=0.995)


@overload
def findHomography(srcPoints: npt.ArrayLike, dstPoints: npt.ArrayLike, method: int = ..., ransacReprojThreshold: float = ...,
                   mask: _Mask = ..., maxIters: int = ..., confidence: float = ...) -> _Found: ...
@overload
def findHomography(srcPoints: npt.ArrayLike, dstPoints: npt.ArrayLike, params: Params, mask: _Mask = ...) -> _Found: ...
@overload
def findHomography(srcPoints: npt.ArrayLike, dstPoints: npt.ArrayLike, *, method: Params, mask: _Mask = ...) -> _Found: ...


@signed(_HOMOGRAPHY, 2, _HOMOGRAPHY_DEFAULTS)
def findHomography(*args: Any, **kwargs: Any) -> Any:
    """findHomography(srcPoints, dstPoints[, method[, ransacReprojThreshold[, mask[, maxIters[, confidence]]]]]) -> retval, mask
    findHomography(srcPoints, dstPoints, params[, mask]) -> retval, mask

    cv2.findHomography with a flag of this module or of OpenCV, or with all options.

    srcPoints, dstPoints -- N points of each image: Nx2, 2xN, Nx1x2 or 1xNx2, any number type; with 3 coordinates instead of
        2 the points are homogeneous
    method -- one of USACV20* (default USACV20) or a flag of OpenCV, which is passed to OpenCV unchanged
    ransacReprojThreshold -- inlier threshold, distance in image 2 in pixels; default 3
    mask -- Nx1 array of uint8 or bool that receives the mask, or None
    maxIters -- maximum number of samples; default 2000
    confidence -- confidence of the search, see Params.confidence; default 0.995
    params -- Params in place of the flag; method=params is accepted, too
    retval -- homography, 3x3 array of float64; None if there is no model
    mask -- as a result: Nx1 array of uint8, 1 for inliers"""
    return _find(ProblemType.HOMOGRAPHY, "findHomography", _HOMOGRAPHY, _HOMOGRAPHY_OF_PARAMS, _HOMOGRAPHY_DEFAULTS, args,
                 kwargs)


_FUNDAMENTAL = ("points1", "points2", "method", "ransacReprojThreshold", "confidence", "maxIters", "mask")
_FUNDAMENTAL_OF_PARAMS = ("points1", "points2", "params", "mask")
_FUNDAMENTAL_DEFAULTS: Dict[str, Any] = dict(method=USACV20, ransacReprojThreshold=3.0, confidence=0.99, maxIters=1000, mask=None)


@overload
def findFundamentalMat(points1: npt.ArrayLike, points2: npt.ArrayLike, method: int = ..., ransacReprojThreshold: float = ...,
                       confidence: float = ..., maxIters: Optional[int] = ..., mask: _Mask = ...) -> _Found: ...
@overload
def findFundamentalMat(points1: npt.ArrayLike, points2: npt.ArrayLike, method: int, ransacReprojThreshold: float,
                       confidence: float, mask: npt.NDArray[np.uint8]) -> _Found: ...
@overload
def findFundamentalMat(points1: npt.ArrayLike, points2: npt.ArrayLike, params: Params, mask: _Mask = ...) -> _Found: ...
@overload
def findFundamentalMat(points1: npt.ArrayLike, points2: npt.ArrayLike, *, method: Params, mask: _Mask = ...) -> _Found: ...


@signed(_FUNDAMENTAL, 2, _FUNDAMENTAL_DEFAULTS)
def findFundamentalMat(*args: Any, **kwargs: Any) -> Any:
    """findFundamentalMat(points1, points2[, method[, ransacReprojThreshold[, confidence[, maxIters[, mask]]]]]) -> retval, mask
    findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence, mask) -> retval, mask
    findFundamentalMat(points1, points2, params[, mask]) -> retval, mask

    cv2.findFundamentalMat with a flag of this module or of OpenCV, or with all options.

    points1, points2 -- N points of each image in pixels, as for findHomography
    method -- one of USACV20* (default USACV20) or a flag of OpenCV, which is passed to OpenCV unchanged
    ransacReprojThreshold -- inlier threshold, Sampson distance in pixels; default 3
    confidence -- confidence of the search, see Params.confidence; default 0.99
    maxIters -- maximum number of samples; default (also for None) 1000
    mask -- Nx1 array of uint8 or bool that receives the mask, or None
    params -- Params in place of the flag; method=params is accepted, too
    retval -- fundamental matrix, 3x3 array of float64; None if there is no model. With OpenCV's flags and seven points: up
        to three matrices, stacked in an array of up to 9x3
    mask -- as a result: Nx1 array of uint8, 1 for inliers"""
    last = args[5] if len(args) == 6 else None
    if isinstance(last, np.ndarray) and last.ndim > 0:  # OpenCV also has a form in which the sixth argument is the mask
        args, kwargs = args[:5], dict(kwargs, mask=last)
    return _find(ProblemType.FUNDAMENTAL, "findFundamentalMat", _FUNDAMENTAL, _FUNDAMENTAL_OF_PARAMS, _FUNDAMENTAL_DEFAULTS,
                 args, kwargs)


_MAP = ("from_", "to", "inliers", "method", "ransacReprojThreshold", "maxIters", "confidence", "refineIters")
_MAP_OF_PARAMS = ("pts1", "pts2", "params", "inliers")
_MAP_DEFAULTS: Dict[str, Any] = dict(inliers=None, method=USACV20, ransacReprojThreshold=3.0, maxIters=2000, confidence=0.99,
                                     refineIters=10)


@overload
def estimateAffine2D(from_: npt.ArrayLike, to: npt.ArrayLike, inliers: _Mask = ..., method: int = ...,
                     ransacReprojThreshold: float = ..., maxIters: int = ..., confidence: float = ...,
                     refineIters: int = ...) -> _Found: ...
@overload
def estimateAffine2D(pts1: npt.ArrayLike, pts2: npt.ArrayLike, params: Params, inliers: _Mask = ...) -> _Found: ...
@overload
def estimateAffine2D(from_: npt.ArrayLike, to: npt.ArrayLike, inliers: _Mask = ..., *, method: Params) -> _Found: ...


@signed(_MAP, 2, _MAP_DEFAULTS)
def estimateAffine2D(*args: Any, **kwargs: Any) -> Any:
    """estimateAffine2D(from_, to[, inliers[, method[, ransacReprojThreshold[, maxIters[, confidence[, refineIters]]]]]])
        -> retval, inliers
    estimateAffine2D(pts1, pts2, params[, inliers]) -> retval, inliers

    cv2.estimateAffine2D with a flag of this module or of OpenCV, or with all options: the affine map x2 = A x1 + t.

    from_, to -- N points of each image in pixels, as for findHomography
    inliers -- Nx1 array of uint8 or bool that receives the mask, or None
    method -- one of USACV20* (default USACV20) or a flag of OpenCV, which is passed to OpenCV unchanged
    ransacReprojThreshold -- inlier threshold, distance in image 2 in pixels; default 3
    maxIters -- maximum number of samples; default 2000
    confidence -- confidence of the search, see Params.confidence; default 0.99
    refineIters -- maximum number of steps of the final polishing; 0: no polishing; default 10
    params -- Params in place of the flag; method=params is accepted, too
    retval -- affine map [A t], 2x3 array of float64; None if there is no model
    inliers -- as a result: Nx1 array of uint8, 1 for inliers"""
    return _find(ProblemType.AFFINITY, "estimateAffine2D", _MAP, _MAP_OF_PARAMS, _MAP_DEFAULTS, args, kwargs)


@overload
def estimateAffinePartial2D(from_: npt.ArrayLike, to: npt.ArrayLike, inliers: _Mask = ..., method: int = ...,
                            ransacReprojThreshold: float = ..., maxIters: int = ..., confidence: float = ...,
                            refineIters: int = ...) -> _Found: ...
@overload
def estimateAffinePartial2D(pts1: npt.ArrayLike, pts2: npt.ArrayLike, params: Params, inliers: _Mask = ...) -> _Found: ...
@overload
def estimateAffinePartial2D(from_: npt.ArrayLike, to: npt.ArrayLike, inliers: _Mask = ..., *, method: Params) -> _Found: ...


@signed(_MAP, 2, _MAP_DEFAULTS)
def estimateAffinePartial2D(*args: Any, **kwargs: Any) -> Any:
    """estimateAffinePartial2D(from_, to[, inliers[, method[, ransacReprojThreshold[, maxIters[, confidence[, refineIters]]]]]])
        -> retval, inliers
    estimateAffinePartial2D(pts1, pts2, params[, inliers]) -> retval, inliers

    cv2.estimateAffinePartial2D with a flag of this module or of OpenCV, or with all options: rotation, uniform scale and
    translation. Arguments and results are those of estimateAffine2D, but retval has the rows (a, -b, x) and (b, a, y)."""
    return _find(ProblemType.SIMILARITY, "estimateAffinePartial2D", _MAP, _MAP_OF_PARAMS, _MAP_DEFAULTS, args, kwargs)
