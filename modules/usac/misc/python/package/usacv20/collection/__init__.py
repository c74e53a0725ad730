# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates the two-view geometry of all pairs of a collection of images: python3 -m
usacv20.collection --help

    verify DATABASE   estimates all pairs of a COLMAP database, replacing COLMAP's own verification
    pairs LIST        estimates all pairs of a folder or file of matches
    report DATABASE   describes the results of a run

doc/collections.md describes the rules, the files and the costs."""

import importlib
import typing

from ._pair import CollectionError, Configuration, TwoView

if typing.TYPE_CHECKING:
    from ._engine import Summary
    from ._scores import ColumnScores, HlocScores
    from ._verify import verify

__all__ = ["CollectionError", "ColumnScores", "Configuration", "HlocScores", "Summary", "TwoView", "readResults", "verify"]

_LATER = {"Summary": "_engine", "ColumnScores": "_scores", "HlocScores": "_scores", "verify": "_verify"}


def __getattr__(name: str) -> typing.Any:
    """Imports a name at its first use, so that the command starts fast and can be interrupted
    early."""
    if name not in _LATER:
        raise AttributeError("module {!r} has no attribute {!r}".format(__name__, name))
    return getattr(importlib.import_module("." + _LATER[name], __name__), name)


def readResults(path: str) -> typing.Iterator[TwoView]:
    """Yields the results of the command `pairs`, sorted by the names of the pairs.

    path -- SQLite, NPZ or HDF5 file that the command has written, or OUTPUT.part of an interrupted
    run

    Raises CollectionError if the file is damaged or has no results."""
    from ._list_results import readResults as read  # imported here, because the other commands do not need it
    return read(path)
