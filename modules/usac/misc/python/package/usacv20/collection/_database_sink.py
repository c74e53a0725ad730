# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Results in a COLMAP database: its table two_view_geometries, and two tables of our own for the report and for --resume."""

from __future__ import annotations

import datetime
import json
import os
import sqlite3
import typing
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._pair import CollectionError, Configuration, Key, TwoView
from ._sqlite import checkInput, columns, connect, explained

VERSION = 1  # of our own tables
RUNS, PAIRS = "usacv20_runs", "usacv20_pairs"
RUNNING, INTERRUPTED, FINISHED = "running", "interrupted", "finished"

# As COLMAP 3.8 makes it.
_GEOMETRIES = """CREATE TABLE IF NOT EXISTS two_view_geometries (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL,
cols INTEGER NOT NULL, data BLOB, config INTEGER NOT NULL, F BLOB, E BLOB, H BLOB, qvec BLOB, tvec BLOB)"""
_OWN = (
    """CREATE TABLE IF NOT EXISTS {} (run_id INTEGER PRIMARY KEY NOT NULL, version INTEGER NOT NULL, settings TEXT NOT NULL,
state TEXT NOT NULL, started TEXT NOT NULL, updated TEXT NOT NULL)""".format(RUNS),
    """CREATE TABLE IF NOT EXISTS {} (pair_id INTEGER PRIMARY KEY NOT NULL, run_id INTEGER NOT NULL,
configuration INTEGER NOT NULL, reason TEXT NOT NULL, matches INTEGER NOT NULL, inliers INTEGER NOT NULL,
iterations INTEGER NOT NULL, chance REAL, milliseconds REAL)""".format(PAIRS),
)
_NEEDED = ("pair_id", "rows", "cols", "data", "config")
_MATRICES = ("F", "E", "H", "qvec", "tvec")  # versions before 3.8 have some of them
_SIZES = {"F": 9, "E": 9, "H": 9, "qvec": 4, "tvec": 3}


class DatabaseSink:
    """Writes to a COLMAP database that exists; its other tables stay as they are.

    path -- of the database
    settings -- what the results depend on; values are those of JSON
    resume -- True: go on with the last run. CollectionError if its settings are others. Without a last run one begins. Rows that
        were in two_view_geometries before a run are removed together with the first commit

    A pair that is refused has a row without inliers, by which COLMAP knows that it was looked at. A fault has none."""

    def __init__(self, path: str, settings: typing.Mapping[str, Any], resume: bool = False) -> None:
        self.path = os.path.abspath(path)
        self._settings = json.loads(json.dumps(dict(settings), sort_keys=True))
        self.removed = 0  # rows of two_view_geometries that another program, or an earlier run, has left
        self._run: Optional[int] = None
        self._resumed = False
        self._closed = False
        self._connection = connect(self.path, write=True)
        try:
            checkInput(self._connection, self.path)
            with explained(self.path):
                self._wal = self._connection.execute("PRAGMA journal_mode").fetchone()[0] == "wal"
                if self._wal:
                    # A commit survives the death of the process, and the database that of the machine.
                    self._connection.execute("PRAGMA synchronous = NORMAL")
                self._matrices = self._checkTable()
                if resume:
                    self._resume()
                self._try()
        except BaseException:
            self._connection.close()
            raise

    @property
    def resumed(self) -> bool:
        """True: the results are added to those of an earlier run."""
        return self._resumed

    def done(self, key: Key) -> bool:
        """Faults, which have no row, are not: the database may have been repaired meanwhile."""
        if not self._resumed:
            return False
        with explained(self.path):
            return bool(self._connection.execute(
                "SELECT 1 FROM {} JOIN two_view_geometries USING (pair_id) WHERE pair_id = ?".format(PAIRS),
                (int(key),)).fetchall())

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        if self._closed:
            raise CollectionError("{}: results come after the database was closed".format(self.path))
        with explained(self.path):
            self._transaction(lambda: self._write(results))

    def close(self, finished: bool = True) -> None:
        """finished -- False: pairs are left for --resume."""
        if self._closed:
            return
        self._closed = True
        try:
            with explained(self.path):
                self._transaction(lambda: self._finish(FINISHED if finished else INTERRUPTED))
                if self._wal:  # all is in the one file then, even if other programs keep it open
                    self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()
        finally:
            self._connection.close()

    def _try(self) -> None:
        """What cannot be written is known before hours of work."""
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            self._connection.execute("CREATE TABLE usacv20_trial (a)")
        finally:
            self._connection.execute("ROLLBACK")

    def _transaction(self, action: Any) -> None:
        run, removed = self._run, self.removed
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            action()
            self._connection.execute("COMMIT")
        except BaseException:
            self._run, self.removed = run, removed
            if self._connection.in_transaction:
                self._connection.execute("ROLLBACK")
            raise

    def _checkTable(self) -> List[str]:
        """The columns for matrices that the table of the results has."""
        found = columns(self._connection, "two_view_geometries")
        if not found:
            return list(_MATRICES)  # it will be made
        missing = [name for name in _NEEDED if name not in found]
        if missing:
            raise CollectionError("{}: its table two_view_geometries has no column {}".format(self.path, missing[0]))
        return [name for name in _MATRICES if name in found]

    def _resume(self) -> None:
        if not columns(self._connection, RUNS) or not columns(self._connection, PAIRS):
            return
        last = self._connection.execute("SELECT run_id, version, settings FROM {} ORDER BY run_id DESC LIMIT 1".format(
            RUNS)).fetchall()
        if not last:
            return
        run, version, settings = last[0]
        if version != VERSION:
            raise CollectionError("{}: --resume: the last run is of another version of this tool".format(self.path))
        before = json.loads(settings)
        differing = ["{} is {} and was {}".format(name, json.dumps(self._settings.get(name)), json.dumps(before.get(name)))
                     for name in sorted(set(before) | set(self._settings)) if before.get(name) != self._settings.get(name)]
        if differing:
            raise CollectionError("{}: --resume: the settings are not those of the last run: {}".format(
                self.path, "; ".join(differing)))
        self._run, self._resumed = run, True

    def _write(self, results: typing.Sequence[TwoView]) -> None:
        self._begin()
        names = ["pair_id", "rows", "cols", "data", "config"] + self._matrices
        faults = [(result.key,) for result in results if result.configuration == Configuration.UNDEFINED]
        self._connection.executemany("DELETE FROM two_view_geometries WHERE pair_id = ?", faults)
        self._connection.executemany(
            "INSERT OR REPLACE INTO two_view_geometries ({}) VALUES ({})".format(", ".join(names), ", ".join("?" * len(names))),
            (self._row(result) for result in results if result.configuration != Configuration.UNDEFINED))
        self._connection.executemany(
            "INSERT OR REPLACE INTO {} (pair_id, run_id, configuration, reason, matches, inliers, iterations, chance, "
            "milliseconds) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)".format(PAIRS),
            ((result.key, self._run, int(result.configuration), result.reason, int(result.matches), len(result.inliers),
              int(result.iterations), float(result.chance), float(result.milliseconds)) for result in results))
        self._connection.execute("UPDATE {} SET state = ?, updated = ? WHERE run_id = ?".format(RUNS),
                                 (RUNNING, _now(), self._run))

    def _begin(self) -> None:
        if self._run is not None:
            return
        for statement in (_GEOMETRIES, "DROP TABLE IF EXISTS {}".format(PAIRS)) + _OWN:
            self._connection.execute(statement)
        self.removed = self._connection.execute("DELETE FROM two_view_geometries").rowcount
        self._run = self._connection.execute(
            "INSERT INTO {} (version, settings, state, started, updated) VALUES (?, ?, ?, ?, ?)".format(RUNS),
            (VERSION, json.dumps(self._settings, sort_keys=True), RUNNING, _now(), _now())).lastrowid

    def _finish(self, state: str) -> None:
        if self._run is None and state == INTERRUPTED:
            return  # nothing was written, and nothing is removed
        self._begin()
        self._connection.execute("UPDATE {} SET state = ?, updated = ? WHERE run_id = ?".format(RUNS), (state, _now(), self._run))

    def _row(self, result: TwoView) -> Tuple[Any, ...]:
        """Zeros stand for a matrix that is not known, NULL for all if there are no inliers, as COLMAP has it."""
        count = len(result.inliers)
        given = {"F": result.F, "E": result.E, "H": result.H, "qvec": result.quaternion, "tvec": result.translation}
        data = np.ascontiguousarray(result.inliers, "<u4").tobytes() if count else None
        matrices = [_blob(given[name], _SIZES[name]) if count else None for name in self._matrices]
        return (result.key, count, 2, data, int(result.configuration), *matrices)


def _blob(values: Any, size: int) -> bytes:
    """Row by row."""
    table = np.zeros(size) if values is None else np.asarray(values, "<f8")
    if table.size != size:
        raise ValueError("{} numbers, not {}".format(size, table.size))
    return table.astype("<f8").tobytes()


def _now() -> str:
    return datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")


def lastRun(connection: sqlite3.Connection) -> Optional[Dict[str, Any]]:
    """The columns of the last run, settings as a dict; None: there was none."""
    if not columns(connection, RUNS):
        return None
    rows = connection.execute("SELECT run_id, version, settings, state, started, updated FROM {} "
                              "ORDER BY run_id DESC LIMIT 1".format(RUNS)).fetchall()
    if not rows:
        return None
    found = dict(zip(("run_id", "version", "settings", "state", "started", "updated"), rows[0]))
    found["settings"] = json.loads(found["settings"])
    return found
