# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Chooses `native`, the compiled part: cv2._native.usacv20 inside OpenCV, otherwise the extension
module `_native`. Both provide the same functions, but only the extension module has the classes Usac
and Rng."""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING

__all__ = ["IN_TREE", "native"]

IN_TREE = __name__.startswith("cv2.")


def _inSubInterpreter() -> bool:
    for name in ("_interpreters", "_xxsubinterpreters"):  # the names since Python 3.13 and before
        try:
            interpreters = importlib.import_module(name)
        except ImportError:
            continue
        return bool(interpreters.get_current() != interpreters.get_main())
    return False


if TYPE_CHECKING:
    from . import _native as native
elif IN_TREE:
    import cv2

    from ._intree import Native

    native = Native(cv2)  # raises ImportError if this cv2 was built without the module; cv2 itself still works
else:
    if _inSubInterpreter():  # the import of the compiled part would not return
        raise ImportError("usacv20: it can be imported in the main interpreter only, not in a sub-interpreter")
    import numpy  # noqa: F401  # first: Ctrl-C while the compiled part imports it would become an ImportError
    try:
        from . import _native as native
    except ImportError as failure:
        raise ImportError("usacv20: the compiled part was not found or cannot be loaded ({}); it works with one version of "
                          "Python only, and this is {}.{}: install the package with "
                          "this version".format(failure, *sys.version_info[:2])) from failure
