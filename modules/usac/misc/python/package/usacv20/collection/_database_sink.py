# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Writes results to a COLMAP database: to its table two_view_geometries, and to two additional
tables for the report and for --resume."""

from __future__ import annotations

import datetime
import json
import os
import sqlite3
import typing
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from ._database import IMAGES, matchesHash
from ._loops import Edge
from ._pair import CollectionError, Configuration, Key, TwoView
from ._sqlite import checkInput, columns, connect, explained

# Version of the additional tables and of the contents of rows. Version 1 stored zeros for
# unknown matrices; versions 1 and 2 stored no rotations; versions 1 to 3 stored no hash of the matches,
# but stored the motion of WATERMARK pairs.
VERSION = 4
RUNS, PAIRS = "usacv20_runs", "usacv20_pairs"
RUNNING, INTERRUPTED, FINISHED = "running", "interrupted", "finished"

# The table two_view_geometries as COLMAP 3.8 creates it.
_GEOMETRIES = """CREATE TABLE IF NOT EXISTS two_view_geometries (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL,
cols INTEGER NOT NULL, data BLOB, config INTEGER NOT NULL, F BLOB, E BLOB, H BLOB, qvec BLOB, tvec BLOB)"""
_OWN = (
    """CREATE TABLE IF NOT EXISTS {} (run_id INTEGER PRIMARY KEY NOT NULL, version INTEGER NOT NULL, settings TEXT NOT NULL,
state TEXT NOT NULL, started TEXT NOT NULL, updated TEXT NOT NULL)""".format(RUNS),
    """CREATE TABLE IF NOT EXISTS {} (pair_id INTEGER PRIMARY KEY NOT NULL, run_id INTEGER NOT NULL,
configuration INTEGER NOT NULL, reason TEXT NOT NULL, matches INTEGER NOT NULL, inliers INTEGER NOT NULL,
iterations INTEGER NOT NULL, chance REAL, milliseconds REAL, rotations BLOB, matches_hash INTEGER)""".format(PAIRS),
)
_ADDED = (("rotations", "BLOB"), ("matches_hash", "INTEGER"))  # columns that tables of earlier versions do not have
_NEEDED = ("pair_id", "rows", "cols", "data", "config")
_LINKS = (Configuration.CALIBRATED, Configuration.PANORAMIC)  # configurations with a unique, well-determined rotation
_NO_MOTION = (Configuration.PLANAR, Configuration.WATERMARK)  # configurations whose motion is not written, see _row
_MATRICES = ("F", "E", "H", "qvec", "tvec")  # COLMAP before 3.8 has only some of these columns
# Prefix of the reasons of pairs that contradict other pairs. --resume estimates these pairs again,
# because new pairs may support them.
CONTRADICTED = "loop: "
_SIZES = {"F": 9, "E": 9, "H": 9, "qvec": 4, "tvec": 3}


class DatabaseSink:
    """Writes to the table two_view_geometries of an existing COLMAP database and to two additional
    tables; other tables are not changed.

    path -- path of the database
    settings -- settings that the results depend on; values are JSON values
    resume -- True: results of earlier runs with the same settings are kept. Raises CollectionError
    if the last run had other settings or was made by another version of the tool. If there was no
    run, a new run is started
    keep -- True: `edges` also returns pairs of earlier runs with the same settings, even if no run is
    resumed. If `keep` is false and no run is resumed, the first commit removes the records of earlier
    runs from the additional tables

    A refused pair has a row without inliers in two_view_geometries, which shows COLMAP that the pair
    was examined. Rows of other pairs and of faults are kept, no matter which program wrote them. If two sinks write to one database, even in different
    processes, the sink that started to write last continues. The other sink raises CollectionError
    at its next commit, which then changes nothing."""

    def __init__(self, path: str, settings: typing.Mapping[str, Any], resume: bool = False, keep: bool = False) -> None:
        self.path = os.path.abspath(path)
        self._settings = json.loads(json.dumps(dict(settings), sort_keys=True))
        self.replaced = 0  # number of rows of two_view_geometries from another program or an earlier run that were replaced
        self._run: Optional[int] = None
        self._newest: Optional[int] = None  # newest run in the database when this sink last wrote or was opened
        self._same = ""  # comma-separated ids of the earlier runs with the same settings, for SQL statements
        self._keep = keep
        self._resumed = False
        self._closed = False
        self._connection = connect(self.path, write=True)
        try:
            checkInput(self._connection, self.path)
            with explained(self.path):
                self._wal = self._connection.execute("PRAGMA journal_mode").fetchone()[0] == "wal"
                if self._wal:
                    # With this setting a commit survives the death of the process, and the database
                    # stays intact if the machine fails.
                    self._connection.execute("PRAGMA synchronous = NORMAL")
                self._matrices = self._checkTable()
                self._newest = self._newestRun()
                self._readRuns(resume)
                self._try()
        except BaseException:
            self._connection.close()
            raise

    @property
    def resumed(self) -> bool:
        """True if the results are added to those of an earlier run."""
        return self._resumed

    def done(self, key: Key) -> bool:
        """Returns True if a resumed run has no work left for a pair. Faults count as not done, because
        the database may have been repaired. So do pairs that were refused because they contradict other
        pairs, because new pairs may support them. A pair must be done again if its matches have
        changed, or if its configuration or number of inliers in two_view_geometries is not what this
        tool has written."""
        if not self._resumed:
            return False
        with explained(self.path):
            found = self._connection.execute(
                "SELECT p.matches_hash, m.rows, m.cols, m.data FROM {} AS p JOIN two_view_geometries AS g USING (pair_id) "
                "JOIN matches AS m USING (pair_id) WHERE pair_id = ? AND p.run_id IN ({}) AND p.configuration != {:d} "
                "AND p.configuration = g.config AND p.inliers = g.rows AND p.reason NOT GLOB '{}*'".format(
                    PAIRS, self._same, Configuration.UNDEFINED, CONTRADICTED), (int(key),)).fetchall()
        return bool(found) and found[0][0] == matchesHash(*found[0][1:])

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        if self._closed:
            raise CollectionError("{}: results come after the database was closed".format(self.path))
        with explained(self.path):
            self._transaction(lambda: self._write(results))

    def edges(self) -> List[Edge]:
        """Returns the accepted pairs with known rotations of this run and, if rows of earlier runs are
        kept, of the earlier runs with the same settings."""
        runs = ", ".join(filter(None, [self._same, "" if self._run is None else str(self._run)]))
        with explained(self.path):
            if not runs or not columns(self._connection, PAIRS):
                return []
            return [Edge(key, key // IMAGES, key % IMAGES, inliers, np.frombuffer(rotations, "<f8").reshape(-1, 4), configuration in _LINKS)
                    for key, inliers, configuration, rotations in self._connection.execute(
                        "SELECT pair_id, inliers, configuration, rotations FROM {} WHERE inliers > 0 AND rotations IS NOT NULL "
                        "AND run_id IN ({})".format(PAIRS, runs))]

    def refuse(self, pairs: typing.Mapping[Key, str]) -> int:
        """Refuses committed pairs for the given reasons. Returns how many of these pairs were
        accepted by this run."""
        def own() -> int:
            kept = self._connection.execute("SELECT count(*) FROM {} WHERE run_id = ? AND inliers > 0".format(PAIRS), (self._run,))
            return int(kept.fetchone()[0])
        with explained(self.path):
            before = own()
            self._transaction(lambda: self._refuse(pairs))
            return before - own()

    def _refuse(self, pairs: typing.Mapping[Key, str]) -> None:
        self._begin()
        self._connection.executemany("UPDATE two_view_geometries SET rows = 0, data = NULL, config = {:d}{} WHERE pair_id = ?".format(
            Configuration.DEGENERATE, "".join(", {} = NULL".format(name) for name in self._matrices)), ((key,) for key in pairs))
        self._connection.executemany("UPDATE {} SET configuration = {:d}, reason = ?, inliers = 0, rotations = NULL WHERE pair_id = ?"
                                     .format(PAIRS, Configuration.DEGENERATE),
                                     ((CONTRADICTED + reason, key) for key, reason in pairs.items()))

    def close(self, finished: bool = True) -> None:
        """Closes the database.

        finished -- False: some pairs are not done, and --resume can process them later"""
        if self._closed:
            return
        self._closed = True
        try:
            with explained(self.path):
                self._transaction(lambda: self._finish(FINISHED if finished else INTERRUPTED))
                if self._wal:  # moves all data to the main file, even if other programs have the database open
                    self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()
        finally:
            self._connection.close()

    def _try(self) -> None:
        """Raises CollectionError if the database cannot be written. This is tested before the
        estimation, so that no work is lost."""
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            self._connection.execute("CREATE TABLE usacv20_trial (a)")
        finally:
            self._connection.execute("ROLLBACK")

    def _transaction(self, action: Any) -> None:
        before = self._run, self._newest, self.replaced
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            newest = self._newestRun()
            if newest != self._newest:
                raise CollectionError("{}: another run of this tool (number {}) has begun on this database meanwhile; this one ends "
                                      "here".format(self.path, newest))
            action()
            self._connection.execute("COMMIT")
        except BaseException:
            self._run, self._newest, self.replaced = before
            if self._connection.in_transaction:
                self._connection.execute("ROLLBACK")
            raise

    def _newestRun(self) -> Optional[int]:
        if not columns(self._connection, RUNS):
            return None
        newest: Optional[int] = self._connection.execute("SELECT MAX(run_id) FROM {}".format(RUNS)).fetchone()[0]
        return newest

    def _checkTable(self) -> List[str]:
        """Returns the names of the columns for matrices in two_view_geometries. Raises
        CollectionError if a required column is missing."""
        found = columns(self._connection, "two_view_geometries")
        if not found:
            return list(_MATRICES)  # the table will be created
        missing = [name for name in _NEEDED if name not in found]
        if missing:
            raise CollectionError("{}: its table two_view_geometries has no column {}".format(self.path, missing[0]))
        return [name for name in _MATRICES if name in found]

    def _readRuns(self, resume: bool) -> None:
        """Finds the earlier runs whose results are used. `resume` as in __init__."""
        if not (resume or self._keep) or not columns(self._connection, RUNS) or not columns(self._connection, PAIRS):
            return
        stored = [(run, version, json.loads(settings)) for run, version, settings in self._connection.execute(
            "SELECT run_id, version, settings FROM {} ORDER BY run_id".format(RUNS))]
        if resume and stored:
            self._checkLast(*stored[-1][1:])
            self._resumed = True
        self._same = ", ".join(str(int(run)) for run, version, used in stored if version == VERSION and not self._differing(used))

    def _checkLast(self, version: int, before: typing.Mapping[str, Any]) -> None:
        """Raises CollectionError if the last run cannot be resumed; `version` and `before` are its version
        and settings."""
        if version != VERSION:
            raise CollectionError("{}: --resume: the last run is of another version of this tool: verify without --resume to "
                                  "begin anew".format(self.path))
        differing = ["{} is {} and was {}".format(name, json.dumps(self._settings.get(name)), json.dumps(before.get(name)))
                     for name in self._differing(before)]
        if differing:
            raise CollectionError("{}: --resume: the settings are not those of the last run: {}".format(
                self.path, "; ".join(differing)))

    def _differing(self, before: typing.Mapping[str, Any]) -> List[str]:
        """Returns the names of the settings that differ from those of an earlier run."""
        return [name for name in sorted(set(before) | set(self._settings)) if before.get(name) != self._settings.get(name)]

    def _write(self, results: typing.Sequence[TwoView]) -> None:
        self._begin()
        names = ["pair_id", "rows", "cols", "data", "config"] + self._matrices
        found = [result for result in results if result.configuration != Configuration.UNDEFINED]
        self.replaced += sum(len(self._connection.execute("SELECT 1 FROM two_view_geometries WHERE pair_id = ?", (result.key,)).fetchall())
                             for result in found)
        self._connection.executemany(
            "INSERT OR REPLACE INTO two_view_geometries ({}) VALUES ({})".format(", ".join(names), ", ".join("?" * len(names))),
            map(self._row, found))
        self._connection.executemany(
            "INSERT OR REPLACE INTO {} (pair_id, run_id, configuration, reason, matches, inliers, iterations, chance, "
            "milliseconds, rotations, matches_hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)".format(PAIRS),
            ((result.key, self._run, int(result.configuration), result.reason, int(result.matches), len(result.inliers),
              int(result.iterations), float(result.chance), float(result.milliseconds), _rotations(result), result.matchesHash)
             for result in results))
        self._connection.execute("UPDATE {} SET state = ?, updated = ? WHERE run_id = ?".format(RUNS),
                                 (RUNNING, _now(), self._run))

    def _begin(self) -> None:
        if self._run is not None:
            return
        begun = self._resumed or self._keep
        for statement in (_GEOMETRIES,) + (() if begun else ("DROP TABLE IF EXISTS {}".format(PAIRS),)) + _OWN:
            self._connection.execute(statement)
        there = columns(self._connection, PAIRS)
        for name, kind in _ADDED:
            if name not in there:  # the table was made by an older version of this tool
                self._connection.execute("ALTER TABLE {} ADD COLUMN {} {}".format(PAIRS, name, kind))
        self._newest = self._run = self._connection.execute(
            "INSERT INTO {} (version, settings, state, started, updated) VALUES (?, ?, ?, ?, ?)".format(RUNS),
            (VERSION, json.dumps(self._settings, sort_keys=True), RUNNING, _now(), _now())).lastrowid

    def _finish(self, state: str) -> None:
        if self._run is None and state == INTERRUPTED:
            return  # nothing was written, so nothing is removed
        self._begin()
        self._connection.execute("UPDATE {} SET state = ?, updated = ? WHERE run_id = ?".format(RUNS), (state, _now(), self._run))

    def _row(self, result: TwoView) -> Tuple[Any, ...]:
        """Returns the row of a result. An unknown matrix is stored as NULL: COLMAP 4 would read zeros
        as a pose; COLMAP 3.8 writes zeros, but also reads NULL. The motion of a PLANAR pair is one
        of two possible motions and is not written: COLMAP 4's global mapper would use a stored
        motion as the true one, but determines the motion from other pairs if none is stored (AUC at
        1 degree of 20 synthetic images: 0.957 without the motion, 0.627 with it). The motion of a
        WATERMARK pair is that of a mark in the images, not of the cameras; COLMAP stores none
        either."""
        count = len(result.inliers)
        motion = (None, None) if result.configuration in _NO_MOTION else (result.quaternion, result.translation)
        given = {"F": result.F, "E": result.E, "H": result.H, "qvec": motion[0], "tvec": motion[1]}
        data = np.ascontiguousarray(result.inliers, "<u4").tobytes() if count else None
        matrices = [_blob(given[name], _SIZES[name]) if count else None for name in self._matrices]
        return (result.key, count, 2, data, int(result.configuration), *matrices)


def _rotations(result: TwoView) -> Optional[bytes]:
    return None if result.rotations is None else np.ascontiguousarray(result.rotations, "<f8").tobytes()


def _blob(values: Any, size: int) -> Optional[bytes]:
    """Returns a matrix as bytes, row by row; None for None. Raises ValueError if the matrix does
    not have `size` entries."""
    if values is None:
        return None
    table = np.asarray(values, "<f8")
    if table.size != size:
        raise ValueError("{} numbers are expected, not {}".format(size, table.size))
    return table.astype("<f8").tobytes()


def _now() -> str:
    return datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")


def lastRun(connection: sqlite3.Connection) -> Optional[Dict[str, Any]]:
    """Returns the columns of the last run as a dictionary, in which the settings are converted to a
    dictionary; None if there was no run."""
    if not columns(connection, RUNS):
        return None
    rows = connection.execute("SELECT run_id, version, settings, state, started, updated FROM {} "
                              "ORDER BY run_id DESC LIMIT 1".format(RUNS)).fetchall()
    if not rows:
        return None
    found = dict(zip(("run_id", "version", "settings", "state", "started", "updated"), rows[0]))
    found["settings"] = json.loads(found["settings"])
    return found
