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

SIZE_MAX = 2**64 - 1


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
    if isOptions("findHomography", _HOMOGRAPHY, "method", 2, 2, args, kwargs):
        v = bind("findHomography", _HOMOGRAPHY_OF_PARAMS, 3, dict(mask=None), args, kwargs)
    else:
        v = bind("findHomography", _HOMOGRAPHY, 2, _HOMOGRAPHY_DEFAULTS, args, kwargs)
        if isinstance(v["method"], Params):
            refuseBesideParams("findHomography", v, _HOMOGRAPHY_DEFAULTS, ("ransacReprojThreshold", "maxIters", "confidence"))
            v["params"] = v["method"]
    if "params" in v:
        return estimate(ProblemType.HOMOGRAPHY, v["srcPoints"], v["dstPoints"], v["params"], v["mask"],
                        names=("srcPoints", "dstPoints", "", "", "", ""))[:2]
    checkMask(v["mask"], "mask")
    method = flag(v["method"])
    return found(native.findHomography(
        points(v["srcPoints"], "srcPoints"), points(v["dstPoints"], "dstPoints"), method,
        real(v["ransacReprojThreshold"], "ransacReprojThreshold", 3.0), integer(v["maxIters"], "maxIters", 2000),
        real(v["confidence"], "confidence", 0.995)), method, v["mask"])


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
    if isOptions("findFundamentalMat", _FUNDAMENTAL, "method", 2, 2, args, kwargs):
        v = bind("findFundamentalMat", _FUNDAMENTAL_OF_PARAMS, 3, dict(mask=None), args, kwargs)
    else:
        last = args[5] if len(args) == 6 else None
        if isinstance(last, np.ndarray) and last.ndim > 0:  # OpenCV also has a form in which the sixth argument is the mask
            args, kwargs = args[:5], dict(kwargs, mask=last)
        v = bind("findFundamentalMat", _FUNDAMENTAL, 2, _FUNDAMENTAL_DEFAULTS, args, kwargs)
        if isinstance(v["method"], Params):
            refuseBesideParams("findFundamentalMat", v, _FUNDAMENTAL_DEFAULTS, ("ransacReprojThreshold", "confidence", "maxIters"))
            v["params"] = v["method"]
    if "params" in v:
        return estimate(ProblemType.FUNDAMENTAL, v["points1"], v["points2"], v["params"], v["mask"])[:2]
    checkMask(v["mask"], "mask")
    method = flag(v["method"])
    return found(native.findFundamentalMat(
        points(v["points1"], "points1"), points(v["points2"], "points2"), method,
        real(v["ransacReprojThreshold"], "ransacReprojThreshold", 3.0), real(v["confidence"], "confidence", 0.99),
        integer(v["maxIters"], "maxIters", 1000)), method, v["mask"])


_MAP = ("from_", "to", "inliers", "method", "ransacReprojThreshold", "maxIters", "confidence", "refineIters")
_MAP_OF_PARAMS = ("pts1", "pts2", "params", "inliers")
_MAP_NAMES = {"from": "from_"}  # C++ name: Python name; `from` is a keyword of Python
_MAP_DEFAULTS: Dict[str, Any] = dict(inliers=None, method=USACV20, ransacReprojThreshold=3.0, maxIters=2000, confidence=0.99,
                                     refineIters=10)


def _findMap(function: str, problem: int, args: Tuple[Any, ...], kwargs: Dict[str, Any]) -> Any:
    if isOptions(function, _MAP, "method", 3, 2, args, kwargs):
        v = bind(function, _MAP_OF_PARAMS, 3, dict(inliers=None), args, kwargs)
        return estimate(problem, v["pts1"], v["pts2"], v["params"], v["inliers"], names=("pts1", "pts2", "", "", "", ""),
                        maskName="inliers")[:2]
    v = bind(function, _MAP, 2, _MAP_DEFAULTS, args, kwargs)
    if isinstance(v["method"], Params):
        refuseBesideParams(function, v, _MAP_DEFAULTS, ("ransacReprojThreshold", "maxIters", "confidence", "refineIters"))
        return estimate(problem, v["from_"], v["to"], v["method"], v["inliers"], names=("from_", "to", "", "", "", ""),
                        maskName="inliers")[:2]
    checkMask(v["inliers"], "inliers")
    method = flag(v["method"])
    return found(calling(
        _MAP_NAMES, getattr(native, function), points(v["from_"], "from_"), points(v["to"], "to"), method,
        real(v["ransacReprojThreshold"], "ransacReprojThreshold", 3.0),
        integer(v["maxIters"], "maxIters", 2000, 0, _arguments.INT_MAX),
        real(v["confidence"], "confidence", 0.99),
        integer(v["refineIters"], "refineIters", 10, 0, _arguments.INT_MAX)), method, v["inliers"], "inliers")


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
    return _findMap("estimateAffine2D", ProblemType.AFFINITY, args, kwargs)


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
    return _findMap("estimateAffinePartial2D", ProblemType.SIMILARITY, args, kwargs)
