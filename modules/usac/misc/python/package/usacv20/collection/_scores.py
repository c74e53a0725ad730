# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Scores of the matches in a database, from hloc's file of matches or from an additional column of
the table of matches."""

from __future__ import annotations

import hashlib
import os
import sqlite3
import typing
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from ._optional import need
from ._pair import CollectionError

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]
    _Matches = npt.NDArray[np.uint32]


_MEMBERS = ("matches0", "matching_scores0")
_UNREADABLE: Any = (OSError, KeyError, RuntimeError, TypeError, ValueError, MemoryError)  # exceptions of h5py and NumPy


class HlocScores:
    """Scores in an HDF5 file of hloc. The file has a group for each pair; the name of the group
    consists of the names of both images, with - instead of /. In the group, `matches0` contains for
    each keypoint of the first image the index of the matching keypoint, or -1; `matching_scores0`
    contains the scores."""

    higherIsBetter = True

    def __init__(self, path: str) -> None:
        self.path = os.path.abspath(path)
        self._file: Any = None
        self._open()

    def __getstate__(self) -> Dict[str, Any]:
        return {"path": self.path, "_file": None}

    def describe(self, before: Any = None) -> Any:
        """Returns a description of the scores, which is stored with the settings of a run: the name of
        the file, and the name and a hash of a group. The description does not depend on the folder or
        the size of the file, because the file can be moved and can grow between two runs.

        before -- description that was stored by the run that is continued: its group is used, so that
        the descriptions are equal if the scores in this group are equal. Runs of earlier versions
        stored only the name of the file. None: no run is continued; the first group is used"""
        file = os.path.basename(self.path)
        if before == file:
            return file
        group = before.get("group") if isinstance(before, dict) else None
        if not isinstance(group, str):
            group = self._firstGroup()
        return {"file": file, "group": group, "hash": self._hash(group)}

    def _firstGroup(self) -> str:
        """Returns the name of the first group that contains arrays; an empty string if there are no
        groups. If a group is damaged, returns the name of the group that contains it."""
        name, group = "", self._open()
        while True:
            try:
                member = next(iter(group), None)
                child = None if member is None else group.get(member)
            except _UNREADABLE:
                child = None
            if not hasattr(child, "keys"):
                return name.lstrip("/")
            name, group = "{}/{}".format(name, member), child

    def _hash(self, group: str) -> Optional[str]:
        """Returns a hash of the arrays in a group; None if it has no arrays that can be read."""
        digest = hashlib.sha256()
        try:
            for member in _MEMBERS:
                digest.update(np.asarray(self._open()[group][member][:]).tobytes())
        except _UNREADABLE:
            return None
        return digest.hexdigest()[:16]

    def _open(self) -> Any:
        if self._file is None:
            h5py = need("h5py", "to read " + self.path)
            try:
                self._file = h5py.File(self.path, "r")
            except OSError as mistake:
                raise CollectionError("scores: {} is no HDF5 file that can be read: {}".format(self.path, mistake))
        return self._file

    def of(self, pairId: int, name1: str, name2: str, matches: _Matches, connection: sqlite3.Connection) -> Optional[_Array]:
        """Returns a score for each match. Raises CollectionError if the file does not contain the
        pair, or if one of the matches is not among the matches that the file has for this pair."""
        for first, second, order in ((name1, name2, (0, 1)), (name2, name1, (1, 0))):
            for name in _groupNames(first, second):
                group = self._group(name)
                if group is not None:
                    return self._read(group, matches[:, order[0]], matches[:, order[1]], name)
        raise CollectionError("{} has no scores of this pair".format(self.path))

    def _group(self, name: str) -> Any:
        """Returns the group of a pair; None if there is no such group. Raises CollectionError if the
        group is damaged or does not have the two arrays."""
        file = self._open()
        try:
            if name not in file:
                return None
            group = file[name]
            complete = hasattr(group, "keys") and all(member in group for member in _MEMBERS)
        except _UNREADABLE as mistake:
            raise CollectionError("{}: the group {} is damaged: {}".format(
                self.path, name, " ".join(str(mistake).split()))) from None
        if not complete:
            raise CollectionError("{}: matches0 and matching_scores0 are expected in {}".format(self.path, name))
        return group

    def _read(self, group: Any, first: npt.NDArray[np.uint32], second: npt.NDArray[np.uint32], name: str) -> _Array:
        try:
            partners, scores = (np.asarray(group[member][:], np.float64) for member in _MEMBERS)
        except _UNREADABLE:
            raise CollectionError("{}: matches0 and matching_scores0 in {} are no arrays of numbers, or damaged".format(
                self.path, name)) from None
        if len(first) and (int(first.max()) >= min(len(partners), len(scores)) or np.any(partners[first] != second)):
            raise CollectionError("{} has other matches of this pair than the database".format(self.path))
        result: _Array = scores[first]
        return result


def _groupNames(first: str, second: str) -> typing.Iterator[str]:
    """Yields the names that the group of a pair can have, in the current and in older versions of
    hloc."""
    first, second = first.replace("/", "-"), second.replace("/", "-")
    yield first + "/" + second
    yield first + "_" + second


class ColumnScores:
    """Scores in a column of the table `matches` of the database, whose blobs have one float32 or
    float64 for each match of the pair."""

    def __init__(self, column: str, higherIsBetter: bool) -> None:
        if '"' in column:
            raise CollectionError("scores-column: {!r} is no name of a column".format(column))
        self.column = column
        self.higherIsBetter = higherIsBetter

    def describe(self, before: Any = None) -> Any:
        """Returns a description of the scores, which is stored with the settings of a run. `before` is
        not used."""
        return "matches.{}, {} is better".format(self.column, "higher" if self.higherIsBetter else "lower")

    def of(self, pairId: int, name1: str, name2: str, matches: _Matches, connection: sqlite3.Connection) -> Optional[_Array]:
        """Returns a score for each match. Raises CollectionError if the number of scores is not the
        number of matches."""
        row: Optional[Tuple[Any]] = connection.execute(
            'SELECT matches."{}" FROM matches WHERE pair_id = ?'.format(self.column), (pairId,)).fetchone()
        blob = row[0] if row is not None else None
        size = len(blob) if isinstance(blob, bytes) else 0
        types = {4 * len(matches): np.float32, 8 * len(matches): np.float64}
        if blob is None or size not in types:
            raise CollectionError("column {} has {} bytes, not 4 or 8 for each of {} matches".format(
                self.column, size, len(matches)))
        return np.frombuffer(blob, types[size]).astype(np.float64)
