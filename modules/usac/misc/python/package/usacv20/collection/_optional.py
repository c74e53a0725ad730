# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Imports libraries that only some commands need."""

from __future__ import annotations

import importlib
from typing import Any

from ._pair import CollectionError

_DEBIAN = {"h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "distributed": "python3-distributed",
           "tqdm": "python3-tqdm"}


def need(module: str, purpose: str) -> Any:
    """Imports a module, for example "matplotlib.pyplot". Raises CollectionError with the name of
    the missing package if that fails."""
    try:
        return importlib.import_module(module)
    except ImportError:
        name = module.split(".")[0]
        raise CollectionError("{} is needed {} (pip install {}; Debian: {})".format(name, purpose, name, _DEBIAN[name]))
