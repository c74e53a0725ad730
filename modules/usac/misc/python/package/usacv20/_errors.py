# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The exception of the package, `usacv20.error`, and its warning, UsacWarning."""

from __future__ import annotations

import importlib
import importlib.util
import re
import sys
import typing
import warnings
from typing import Any, Callable, List, Type

_PACKAGE = __name__.rpartition(".")[0]
_made: List[Type[Exception]] = []


class UsacWarning(UserWarning):
    """Given for a valid call whose result is doubtful, for example because a camera matrix or the
    unit of a threshold seems to be wrong; the text is report.warning."""


UsacWarning.__module__ = _PACKAGE


def warn(message: str) -> None:
    """Gives a UsacWarning for the line that has called the package; does nothing if the message is
    empty."""
    if not message:
        return
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and str(frame.f_globals.get("__name__")).startswith(_PACKAGE):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, UsacWarning, stacklevel=level)


_ABOUT = """Raised for an invalid argument, which the message names, or for a failure of a component.

A subclass of cv2.error where cv2 can be imported. Errors that the compiled part has found have the attributes code, err, file,
func, line and msg, like those of cv2."""


def _cv2Error() -> Type[Exception]:
    """Returns cv2.error, or Exception if cv2 cannot be imported for any reason."""
    try:
        if "cv2" not in sys.modules and importlib.util.find_spec("cv2") is None:
            return Exception
        found = getattr(importlib.import_module("cv2"), "error", None)
    except Exception:
        return Exception
    return found if isinstance(found, type) and issubclass(found, Exception) else Exception


def errorClass() -> Type[Exception]:
    """Returns the class usacv20.error. The class is created at its first use, so that importing the package does not import
    cv2."""
    if not _made:
        base = _cv2Error()
        if _PACKAGE.startswith("cv2."):
            _made.append(base)
        else:
            names = {"__module__": _PACKAGE, "__doc__": _ABOUT, "code": 0, "err": "", "file": "", "func": "", "line": 0, "msg": ""}
            _made.append(type("error", (base,), names))
    return _made[0]  # if two threads append a class at the same time, both return the first


def fail(message: str) -> Exception:
    """Returns a usacv20.error with this message; the caller raises it."""
    return errorClass()(message)


_ATTRIBUTES = ("code", "err", "file", "func", "line", "msg")


def calling(names: typing.Mapping[str, str], function: Callable[..., Any], *args: Any) -> Any:
    """Calls a function of the compiled part. In the messages of its errors, the names of C++
    arguments are replaced with the caller's names; `names` maps the C++ names to the caller's names.
    """
    try:
        return function(*args)
    except Exception as mistake:  # not BaseException, so that KeyboardInterrupt is not caught
        if not isinstance(mistake, errorClass()):
            raise
        old = str(getattr(mistake, "err", ""))
        new = inWordsOf(names, old)
        if new == old:
            raise
        attributes = {name: getattr(mistake, name) for name in _ATTRIBUTES if hasattr(mistake, name)}
        attributes.update(err=new, msg=str(attributes.get("msg", "")).replace(old, new, 1))
        renamed = fromNative(str(mistake).replace(old, new, 1), **attributes)
    raise renamed


def inWordsOf(names: typing.Mapping[str, str], message: str) -> str:
    """Returns a message of the form "argument: description" with the name of the argument replaced
    with the caller's name."""
    head, colon, rest = message.partition(":")
    return re.sub(r"\w+", lambda word: names.get(word.group()) or word.group(), head) + colon + rest if colon else message


def fromNative(message: str, **attributes: Any) -> Exception:
    """Returns a usacv20.error for an exception of C++, with the attributes of that exception."""
    result = fail(message)
    for name, value in attributes.items():
        setattr(result, name, value)
    return result
