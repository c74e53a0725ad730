# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Writes and reads the results of the command `pairs`: an SQLite table, or arrays in an NPZ or HDF5
file.

SQLite: the table usacv20_results has a row for each pair; see COLUMNS. Matrices are little-endian
doubles, row by row; inliers are little-endian unsigned integers of 32 bits.

Arrays: see _list_columns.py. The length of an array is stored before its contents, so the arrays
are written at the end of a run. Until then the results are in the file OUTPUT.part, an SQLite
database as described above."""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import sqlite3
import typing
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union

import numpy as np

from . import _list_columns
from ._list_files import fail
from ._pair import CollectionError, Configuration, Key, TwoView
from ._sqlite import columns, connect, explained, opened

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._lists import ListSource as _ListSource

SQLITE = (".sqlite", ".sqlite3", ".db")
ARRAYS = (".npz", ".h5", ".hdf5")
TABLE, RUNS = "usacv20_results", "usacv20_results_runs"
# Small columns come first, because SQLite reads a row from its beginning.
COLUMNS = (("name", "TEXT PRIMARY KEY NOT NULL"), ("image1", "TEXT"), ("image2", "TEXT"), ("configuration", "INTEGER NOT NULL"),
           ("reason", "TEXT NOT NULL"), ("matches", "INTEGER NOT NULL"), ("inliers", "INTEGER NOT NULL"),
           ("iterations", "INTEGER NOT NULL"), ("chance", "REAL"), ("milliseconds", "REAL"), ("quaternion", "BLOB"),
           ("translation", "BLOB"), ("F", "BLOB"), ("E", "BLOB"), ("H", "BLOB"), ("inlier_matches", "BLOB NOT NULL"))
_PAIRS = "SELECT {} FROM {} ORDER BY name".format(", ".join(name for name, _ in COLUMNS), TABLE)
_BLOCK = 1000  # number of pairs in a transaction when a complete file is copied to OUTPUT.part
_THERE = "this file exists already (--resume continues its run)"
_OTHER = "the results are of a run with other settings"


def settingsText(run: typing.Mapping[str, object]) -> str:
    return json.dumps(dict(run), sort_keys=True, default=str)


def storedSettings(path: str) -> Optional[Dict[str, Any]]:
    """Returns the settings of the run that wrote OUTPUT.part or, if that does not exist, OUTPUT;
    `path` is OUTPUT. Returns None if neither file exists, or if the settings cannot be read."""
    for name in (path + ".part", path):
        if not os.path.isfile(name):
            continue
        try:
            if _extension(name) in ARRAYS:
                text = _list_columns.readSettings(name)
            else:
                with contextlib.closing(connect(name)) as connection:
                    text = connection.execute("SELECT settings FROM {}".format(RUNS)).fetchone()[0]
            found = json.loads(text)
        except (CollectionError, sqlite3.Error, TypeError, ValueError):
            return None  # the sink reports the error
        return found if isinstance(found, dict) else None
    return None


def _blob(array: Optional[npt.NDArray[np.float64]]) -> Optional[bytes]:
    return None if array is None else np.ascontiguousarray(array, "<f8").tobytes()


def _array(blob: Optional[bytes], *shape: int) -> Optional[npt.NDArray[np.float64]]:
    return None if blob is None else np.frombuffer(blob, "<f8").astype(np.float64).reshape(shape)


def _row(result: TwoView, images: Optional[Tuple[str, str]]) -> Tuple[Any, ...]:
    inliers = np.ascontiguousarray(result.inliers, "<u4")
    return (str(result.key), *(images or (None, None)), int(result.configuration), result.reason, int(result.matches),
            len(inliers), int(result.iterations), float(result.chance), float(result.milliseconds), _blob(result.quaternion),
            _blob(result.translation), _blob(result.F), _blob(result.E), _blob(result.H), inliers.tobytes())


def _twoView(row: typing.Sequence[Any]) -> TwoView:
    name, _, _, configuration, reason, matches, _, iterations, chance, ms, quaternion, translation, F, E, H, inliers = row
    return TwoView(name, Configuration(configuration), np.frombuffer(inliers, "<u4").astype(np.uint32).reshape(-1, 2),
                   _array(F, 3, 3), _array(E, 3, 3), _array(H, 3, 3), _array(quaternion, 4), _array(translation, 3), reason,
                   matches, iterations, np.nan if chance is None else chance, np.nan if ms is None else ms)


class SqliteSink:
    """An SQLite database of results. A commit stores all of its pairs or none of them."""

    def __init__(self, path: str, source: Optional[_ListSource], run: typing.Mapping[str, object], resume: bool) -> None:
        """source: provides the names of the images of the pairs. run, resume: as in openResults.
        Raises CollectionError if the file cannot be used."""
        if os.path.exists(path) and not resume:
            fail("{}: {}".format(path, _THERE))
        self._path, self._source = path, source
        self._connection: Optional[sqlite3.Connection] = None
        try:
            with explained(path):
                self._connection = opened(path)
                self._create(settingsText(run))
        except BaseException:
            self.close()
            raise

    def _create(self, run: str) -> None:
        assert self._connection is not None
        self._connection.execute("BEGIN IMMEDIATE")
        tables = {name for name, in self._connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        if not tables:
            self._connection.execute("CREATE TABLE {} ({})".format(TABLE, ", ".join(" ".join(column) for column in COLUMNS)))
            self._connection.execute("CREATE TABLE {} (settings TEXT NOT NULL)".format(RUNS))
            self._connection.execute("INSERT INTO {} VALUES (?)".format(RUNS), (run,))
        elif not {TABLE, RUNS} <= tables:
            fail("{}: there is such a file already, but not of this command".format(self._path))
        elif self._connection.execute("SELECT settings FROM {}".format(RUNS)).fetchall() != [(run,)]:
            fail("{}: {}".format(self._path, _OTHER))
        self._connection.execute("COMMIT")

    def done(self, key: Key) -> bool:
        """Returns True if the pair has a result. Faults count as not done, because the file of the
        pair may have been repaired."""
        if self._connection is None:
            return False
        with explained(self._path):
            return bool(self._connection.execute("SELECT 1 FROM {} WHERE name = ? AND configuration != {:d}".format(
                TABLE, Configuration.UNDEFINED), (str(key),)).fetchall())

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        if self._connection is None:
            fail("{}: results come after the file was closed".format(self._path))
        rows = [_row(result, None if self._source is None else self._source.images(result.key)) for result in results]
        statement = "INSERT OR REPLACE INTO {} VALUES ({})".format(TABLE, ", ".join("?" * len(COLUMNS)))
        with explained(self._path):
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                self._connection.executemany(statement, rows)
                self._connection.execute("COMMIT")
            except BaseException:
                if self._connection.in_transaction:
                    self._connection.execute("ROLLBACK")
                raise

    def close(self, finished: bool = True) -> None:
        """Closes the database. `finished` has no effect, because a table that lacks some pairs needs
        no special treatment."""
        if self._connection is not None:
            self._connection.close()
            self._connection = None


class ArraySink:
    """An NPZ or HDF5 file of results, which is made from OUTPUT.part at the end of a run."""

    def __init__(self, path: str, source: _ListSource, run: typing.Mapping[str, object], resume: bool) -> None:
        """Has the same arguments as SqliteSink."""
        _list_columns.check(path)
        self._path, self._part = path, path + ".part"
        there, begun = os.path.exists(path), os.path.exists(self._part)
        if there and not resume:
            fail("{}: {}".format(path, _THERE))
        if there and not begun:
            self._restore(source, run)
        self._rows: Optional[SqliteSink] = SqliteSink(self._part, source, run, resume)
        self._changed = begun or not there

    def _restore(self, source: _ListSource, run: typing.Mapping[str, object]) -> None:
        """Makes OUTPUT.part from a complete file, because new pairs may have been added to the
        list, or faults may have been repaired. OUTPUT.part always contains all pairs of OUTPUT."""
        if _list_columns.readSettings(self._path) != settingsText(run):
            fail("{}: {}".format(self._path, _OTHER))
        made = self._part + ".new"
        if os.path.exists(made):
            os.remove(made)
        with contextlib.closing(SqliteSink(made, source, run, False)) as rows:
            results = _list_columns.read(self._path)
            for block in iter(lambda: list(itertools.islice(results, _BLOCK)), []):
                rows.commit(block)
        os.replace(made, self._part)

    def done(self, key: Key) -> bool:
        return self._rows is not None and self._rows.done(key)

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        if self._rows is None:
            fail("{}: results come after the file was closed".format(self._path))
        self._changed = self._changed or len(results) > 0
        self._rows.commit(results)

    def close(self, finished: bool = True) -> None:
        """Writes the file from OUTPUT.part if there are new results, and removes OUTPUT.part.

        finished -- False: some pairs are not done; if there are new results, the file is not written,
        and OUTPUT.part is kept for --resume"""
        if self._rows is None:
            return
        self._rows.close()
        self._rows = None
        if self._changed and not finished:
            return
        if self._changed:
            with explained(self._part), contextlib.closing(connect(self._part)) as connection:
                _list_columns.write(self._path, connection, TABLE)
        os.remove(self._part)


def openResults(path: str, source: _ListSource, run: typing.Mapping[str, object],
                resume: bool = False) -> Union[SqliteSink, ArraySink]:
    """Returns the sink for a file, chosen by the extension of its name. `run` contains the settings,
    that is, everything that the results depend on, except for the pairs. `resume` continues a run
    only if that run had the same settings. Raises CollectionError if the file cannot be used."""
    checkExtension(path)
    if _extension(path) in ARRAYS:
        return ArraySink(path, source, run, resume)
    return SqliteSink(path, source, run, resume)


def _extension(path: str) -> str:
    return os.path.splitext(path)[1].lower()


def checkExtension(path: str) -> None:
    """Raises CollectionError if the extension belongs to none of the formats."""
    if _extension(path) not in SQLITE + ARRAYS:
        fail("{}: results go to files {} or {}{}".format(
            path, ", ".join(SQLITE + ARRAYS[:-1]), ARRAYS[-1],
            "; there is no library for Parquet in Debian" if _extension(path) == ".parquet" else ""))


def readResults(path: str) -> typing.Iterator[TwoView]:
    """Yields the results of the command `pairs` in the order of the names of the pairs, from its
    SQLite, NPZ or HDF5 file, or from OUTPUT.part of an interrupted run. Raises CollectionError if
    the file is damaged or has no results."""
    try:
        with open(path, "rb") as file:
            start = file.read(16)
    except OSError as error:
        fail("{}: {}".format(path, error.strerror))
    if not start.startswith(b"SQLite format 3"):
        yield from _list_columns.read(path)
        return
    try:
        with explained(path), contextlib.closing(connect(path)) as connection:
            if not columns(connection, TABLE):
                fail("{}: no results of the command `pairs`".format(path))
            for row in connection.execute(_PAIRS):
                yield _twoView(row)
    except ValueError:
        fail("{}: the results are damaged".format(path))
