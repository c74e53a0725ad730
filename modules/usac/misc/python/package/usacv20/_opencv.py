# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes the functions of a cv2 accept the flags and the Params of this module."""

from __future__ import annotations

import functools
import importlib
import numbers
import threading
import typing
from typing import Any, Callable, Dict, Optional, Tuple

from ._enumerations import UsacV20Method
from ._essential import findEssentialMat
from ._find import estimateAffine2D, estimateAffinePartial2D, findFundamentalMat, findHomography
from ._params import Params
from ._pose import solvePnPRansac

OURS: typing.Mapping[str, Callable[..., Any]] = {
    "findHomography": findHomography, "findFundamentalMat": findFundamentalMat, "findEssentialMat": findEssentialMat,
    "estimateAffine2D": estimateAffine2D, "estimateAffinePartial2D": estimateAffinePartial2D, "solvePnPRansac": solvePnPRansac}

_FLAGS = frozenset(int(flag) for flag in UsacV20Method)
_MARK = "_usacv20Patch"
_lock = threading.RLock()  # held while functions of a cv2 are replaced or restored


def _essentialPlace(args: Tuple[Any, ...]) -> int:
    """Returns the position of `method` in the argument list of findEssentialMat that the call uses.
    """
    if len(args) > 2 and isinstance(args[2], numbers.Real):
        return 4  # (points1, points2, focal, pp, method, ...)
    if len(args) > 4 and args[4] is not None and not isinstance(args[4], numbers.Real):
        return 6  # (points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2, method, ...)
    return 3      # (points1, points2, cameraMatrix, method, ...)


_PLACES: typing.Mapping[str, Callable[[Tuple[Any, ...]], int]] = {
    "findHomography": lambda args: 2, "findFundamentalMat": lambda args: 2, "findEssentialMat": _essentialPlace,
    "estimateAffine2D": lambda args: 3, "estimateAffinePartial2D": lambda args: 3, "solvePnPRansac": lambda args: 11}


def _isOurs(name: str, args: Tuple[Any, ...], kwargs: typing.Mapping[str, Any]) -> bool:
    """Returns True if the flag in a call is a flag of this module, or if any argument is a Params.
    """
    key = "flags" if name == "solvePnPRansac" else "method"
    place = _PLACES[name](args)
    value = kwargs.get(key, args[place] if place < len(args) else None)
    if isinstance(value, numbers.Integral) and int(value) in _FLAGS:
        return True
    return any(isinstance(value, Params) for value in args) or any(isinstance(value, Params) for value in kwargs.values())


class Patch:
    """Replaces functions of a cv2. The originals are restored by undo() or at the end of a
    with-statement."""

    def __init__(self, cv2: Any, ours: typing.Mapping[str, Callable[..., Any]] = OURS, permanent: bool = False) -> None:
        self._cv2 = cv2
        self.permanent = permanent  # True: unpatch_cv2() has no effect; for an OpenCV built with the module
        self._active = True
        self._functions: Dict[str, Tuple[Any, Any]] = {}
        for name, function in ours.items():
            original = getattr(cv2, name)
            wrapper = self._wrap(name, original, function)
            self._functions[name] = original, wrapper
            setattr(cv2, name, wrapper)

    def _wrap(self, name: str, original: Any, ours: Callable[..., Any]) -> Any:
        @functools.wraps(original)
        def function(*args: Any, **kwargs: Any) -> Any:
            if self._active and _isOurs(name, args, kwargs):
                return ours(*args, **kwargs)
            return original(*args, **kwargs)

        function.__doc__ = "{}\n\nWith one of the flags USACV20*, or with a usacv20.Params in place of the flag:\n\n{}".format(
            original.__doc__, ours.__doc__)
        setattr(function, _MARK, self)
        return function

    def undo(self) -> None:
        """Restores the original functions. If other code has meanwhile replaced a patched function
        with a wrapper of its own, that wrapper stays in place; the patched function, which the
        wrapper calls, then passes all calls to the original function."""
        with _lock:
            self._active = False
            for name, (original, wrapper) in self._functions.items():
                if getattr(self._cv2, name, None) is wrapper:
                    setattr(self._cv2, name, original)
            self._functions = {}

    def __enter__(self) -> Patch:
        return self

    def __exit__(self, *failure: object) -> None:
        self.undo()


def _present(cv2: Any) -> Optional[Patch]:
    patch = getattr(getattr(cv2, "findHomography", None), _MARK, None)
    return patch if isinstance(patch, Patch) else None


def patch_cv2(cv2: Any = None) -> Patch:
    """Makes findHomography, findFundamentalMat, findEssentialMat, estimateAffine2D,
    estimateAffinePartial2D and solvePnPRansac of a cv2 accept the flags of this module, as in
    cv2.findHomography(a, b, usacv20.USACV20, 3.0), and its Params. All other calls reach the
    functions of cv2 unchanged.

    cv2 -- the module to patch; None: the module that `import cv2` imports

    Returns an object whose method undo() undoes the change; at the end of a with-statement, undo()
    is called automatically. If this cv2 is patched already, the call and the returned object have no
    effect. Modules that imported one of the functions by name before the call continue to use the
    original function."""
    cv2 = importlib.import_module("cv2") if cv2 is None else cv2
    with _lock:
        return Patch(cv2, {} if _present(cv2) else OURS)


def unpatch_cv2(cv2: Any = None) -> None:
    """Undoes patch_cv2(), no matter which code has called it. Does nothing if this cv2 is not
    patched."""
    cv2 = importlib.import_module("cv2") if cv2 is None else cv2
    with _lock:
        patch = _present(cv2)
        if patch and not patch.permanent:
            patch.undo()
