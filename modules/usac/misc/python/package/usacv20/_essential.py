# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""findEssentialMat with the four argument lists of OpenCV's function. Either a flag or a Params gives
the options."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, overload

import numpy as np

from ._arguments import array, bind, checkMask, integer, isReal, optionalArray, points, real, shown, signed
from ._backend import native
from ._enumerations import USACV20, ProblemType, UsacV20Method
from ._errors import fail
from ._estimate import NAMES, estimate
from ._find import flag, found, refuseBesideParams
from ._params import Params

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Mask
    from ._find import _Found

_NAME = "findEssentialMat"
_ONE = ("points1", "points2", "cameraMatrix", "method", "prob", "threshold", "maxIters", "mask")
_FOCAL = ("points1", "points2", "focal", "pp", "method", "prob", "threshold", "maxIters", "mask")
_TWO = ("points1", "points2", "cameraMatrix1", "distCoeffs1", "cameraMatrix2", "distCoeffs2", "method", "prob", "threshold", "mask")
_PARAMS = ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "dist_coeff1", "dist_coeff2", "params", "mask")
_DEFAULTS: Dict[str, Any] = dict(method=USACV20, prob=0.999, threshold=1.0, maxIters=1000, mask=None)


def _placeOfParams(args: Tuple[Any, ...]) -> int:
    return next((place for place, value in enumerate(args) if isinstance(value, Params)), -1)


def _form(args: Tuple[Any, ...], kwargs: Dict[str, Any]) -> Tuple[str, ...]:
    """Returns the argument names of the argument list that a call uses. The names, types and number
    of the arguments, and the position of a Params, determine the list. A Params can replace the
    flag; in _TWO only as method=params, because a Params as 7th argument selects _PARAMS."""
    place = _placeOfParams(args)
    if "params" in kwargs or "dist_coeff1" in kwargs or "dist_coeff2" in kwargs or (place == 6):
        return _PARAMS
    if "focal" in kwargs or "pp" in kwargs or (len(args) > 2 and isReal(args[2])):
        return _FOCAL
    names = ("cameraMatrix1", "distCoeffs1", "cameraMatrix2", "distCoeffs2")
    if any(name in kwargs for name in names) or (len(args) > 4 and args[4] is not None and not isReal(args[4]) and place != 3):
        return _TWO
    return _ONE if len(args) > 2 or "cameraMatrix" in kwargs else _FOCAL


def _checkPlace(form: Tuple[str, ...], args: Tuple[Any, ...]) -> None:
    place = _placeOfParams(args)
    if place >= 0 and (place >= len(form) or form[place] not in ("method", "params")):
        raise fail("{}: a Params is argument {}, where {} is expected".format(
            _NAME, place + 1, form[place] if place < len(form) else "no argument"))
    if len(args) > 2 and isinstance(args[2], (UsacV20Method, Params)):
        raise fail("cameraMatrix: a 3x3 matrix is expected, or a focal length, not {}".format(shown(args[2])))


def _principalPoint(value: Any) -> Tuple[float, float]:
    try:
        x, y = value
    except (TypeError, ValueError):
        raise fail("pp: two numbers are expected, not {}".format(shown(value))) from None
    return real(x, "pp"), real(y, "pp")


@overload
def findEssentialMat(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix: npt.ArrayLike, method: int = ...,
                     prob: float = ..., threshold: float = ..., maxIters: Optional[int] = ..., mask: _Mask = ...) -> _Found: ...
@overload
def findEssentialMat(points1: npt.ArrayLike, points2: npt.ArrayLike, focal: float = ..., pp: Tuple[float, float] = ...,
                     method: int = ..., prob: float = ..., threshold: float = ..., maxIters: Optional[int] = ...,
                     mask: _Mask = ...) -> _Found: ...
@overload
def findEssentialMat(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                     distCoeffs1: Optional[npt.ArrayLike], cameraMatrix2: npt.ArrayLike, distCoeffs2: Optional[npt.ArrayLike],
                     method: int = ..., prob: float = ..., threshold: float = ..., mask: _Mask = ...) -> _Found: ...
@overload
def findEssentialMat(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: npt.ArrayLike,
                     cameraMatrix2: Optional[npt.ArrayLike], dist_coeff1: Optional[npt.ArrayLike],
                     dist_coeff2: Optional[npt.ArrayLike], params: Params, mask: _Mask = ...) -> _Found: ...
@overload
def findEssentialMat(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix: npt.ArrayLike, method: Params, *,
                     mask: _Mask = ...) -> _Found: ...


@signed(_ONE, 2, dict(_DEFAULTS, cameraMatrix=None))
def findEssentialMat(*args: Any, **kwargs: Any) -> Any:
    """findEssentialMat(points1, points2, cameraMatrix[, method[, prob[, threshold[, maxIters[, mask]]]]]) -> retval, mask
    findEssentialMat(points1, points2[, focal[, pp[, method[, prob[, threshold[, maxIters[, mask]]]]]]]) -> retval, mask
    findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2[, method[, prob[, threshold[,
        mask]]]]) -> retval, mask
    findEssentialMat(points1, points2, cameraMatrix1, cameraMatrix2, dist_coeff1, dist_coeff2, params[, mask]) -> retval, mask

    cv2.findEssentialMat with a flag of this module or of OpenCV, or with all options.

    points1, points2 -- N points of each image in pixels, as for findHomography
    cameraMatrix -- 3x3 camera matrix of both images
    cameraMatrix1, cameraMatrix2 -- 3x3 camera matrices of image 1 and image 2
    focal, pp -- focal length and principal point (x, y) of both images in pixels; default 1 and (0, 0)
    distCoeffs1, distCoeffs2, dist_coeff1, dist_coeff2 -- 4, 5, 8, 12 or 14 distortion coefficients of camera 1 and
        camera 2, as in cv2.undistortPoints; None: no distortion
    method -- one of USACV20* (default USACV20) or a flag of OpenCV, which is passed to OpenCV unchanged; a Params can
        replace the flag (in the third list above only as method=params)
    prob -- confidence of the search, see Params.confidence; default 0.999
    threshold -- inlier threshold, Sampson distance in pixels; default 1
    maxIters -- maximum number of samples; default (also for None) 1000
    mask -- Nx1 array of uint8 or bool that receives the mask, or None
    params -- Params
    retval -- essential matrix, 3x3 array of float64; None if there is no model. With OpenCV's flags and five points: up to
        ten matrices, stacked in an array of up to 30x3
    mask -- as a result: Nx1 array of uint8, 1 for inliers"""
    if "params" in kwargs and ("method" in kwargs or _placeOfParams(args) >= 0):
        raise fail("findEssentialMat: params is given twice, or together with method")
    if "params" in kwargs and "cameraMatrix" in kwargs:
        kwargs["method"] = kwargs.pop("params")
    elif "params" in kwargs and len(args) == 3 and not any(name in kwargs for name in _PARAMS[3:6]):
        kwargs["method"] = kwargs.pop("params")
    form = _form(args, kwargs)
    _checkPlace(form, args)
    if form is _PARAMS:
        v = bind(_NAME, form, 3, dict(cameraMatrix2=None, dist_coeff1=None, dist_coeff2=None, mask=None), args, kwargs)
        if "params" not in v:
            raise TypeError("findEssentialMat() missing required argument 'params'")
        return estimate(ProblemType.ESSENTIAL, v["points1"], v["points2"], v["params"], v["mask"], v["cameraMatrix1"],
                        v["cameraMatrix2"], v["dist_coeff1"], v["dist_coeff2"],
                        ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "dist_coeff1", "dist_coeff2"))[:2]
    place = _placeOfParams(args)
    if place >= 0 and len(args) == place + 2:  # a call of the form (..., params, mask)
        args, kwargs = args[:place + 1], dict(kwargs, mask=args[place + 1])
    defaults = dict(_DEFAULTS, focal=1.0, pp=(0.0, 0.0)) if form is _FOCAL else _DEFAULTS
    v = bind(_NAME, form, 2 if form is _FOCAL else form.index("method"), defaults, args, kwargs)
    v.setdefault("maxIters", defaults["maxIters"])
    if isinstance(v["method"], Params):
        refuseBesideParams(_NAME, v, defaults, ("prob", "threshold", "maxIters"))
        return _withParams(form, v)
    return _withFlag(form, v)


def _withParams(form: Tuple[str, ...], v: Dict[str, Any]) -> Any:
    cameras: Tuple[Any, ...] = (v.get("cameraMatrix"), None, None, None)
    names = ("cameraMatrix", "", "", "")
    if form is _FOCAL:
        focal, (x, y) = real(v["focal"], "focal"), _principalPoint(v["pp"])
        cameras = (np.array([[focal, 0, x], [0, focal, y], [0, 0, 1]]), None, None, None)
        names = ("focal, pp",) + names[1:]
    elif form is _TWO:
        cameras = (v["cameraMatrix1"], v["cameraMatrix2"], v["distCoeffs1"], v["distCoeffs2"])
        names = NAMES[2:]
    return estimate(ProblemType.ESSENTIAL, v["points1"], v["points2"], v["method"], v["mask"], cameras[0], cameras[1],
                    cameras[2], cameras[3], NAMES[:2] + names)[:2]


def _withFlag(form: Tuple[str, ...], v: Dict[str, Any]) -> Any:
    checkMask(v["mask"], "mask")
    points1, points2 = points(v["points1"], "points1"), points(v["points2"], "points2")
    method, prob, threshold = flag(v["method"]), real(v["prob"], "prob", 0.999), real(v["threshold"], "threshold", 1.0)
    maxIters = integer(v["maxIters"], "maxIters", 1000)
    if form is _ONE:
        result = native.findEssentialMat(points1, points2, array(v["cameraMatrix"], "cameraMatrix"), method, prob, threshold, maxIters)
    elif form is _FOCAL:
        result = native.findEssentialMatOfFocal(
            points1, points2, real(v["focal"], "focal", 1.0), _principalPoint((0.0, 0.0) if v["pp"] is None else v["pp"]), method,
            prob, threshold, maxIters)
    else:
        result = native.findEssentialMatOfCameras(
            points1, points2, array(v["cameraMatrix1"], "cameraMatrix1"), optionalArray(v["distCoeffs1"], "distCoeffs1"),
            array(v["cameraMatrix2"], "cameraMatrix2"), optionalArray(v["distCoeffs2"], "distCoeffs2"), method, prob, threshold)
    return found(result, method, v["mask"])
