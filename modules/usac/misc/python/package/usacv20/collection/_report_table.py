# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Gives the report a single table of results, wherever they come from: a COLMAP database written by
this tool or by COLMAP alone, or a database of the command `pairs`."""

from __future__ import annotations

import json
import os
import re
import typing
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from ._list_results import RUNS, TABLE
from ._pair import CollectionError, Configuration
from ._sqlite import columns, connect, decoded, explained, knownCameras, tidy

if TYPE_CHECKING:
    import numpy.typing as npt

OURS, COLMAP, PAIRS = "usacv20", "colmap", "pairs"  # origin of the results
FAULT, REFUSED, VERIFIED = 0, 1, 2

_IMAGES = 2147483647  # COLMAP's pair_id is this number times the smaller image_id, plus the larger image_id
_NUMBER = re.compile(r"(?<![A-Za-z0-9_])[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?", re.IGNORECASE)
_BLOCK = 4096  # maximum number of rows in memory at a time
_NAMES = "(SELECT name FROM images WHERE image_id = {})"
_OF_COLMAP = ("IFNULL({}, '?') || ' - ' || IFNULL({}, '?') AS name, p.pair_id / {} AS first, p.pair_id % {} AS second".format(
    _NAMES.format("p.pair_id / {}".format(_IMAGES)), _NAMES.format("p.pair_id % {}".format(_IMAGES)), _IMAGES, _IMAGES))
_OF_PAIRS = ("name, (SELECT number FROM temp.nodes WHERE image = image1) AS first, "
             "(SELECT number FROM temp.nodes WHERE image = image2) AS second")
_VALUES = "configuration, reason, matches, inliers, iterations, chance, milliseconds"
_VIEWS = {
    OURS: "SELECT {}, {} FROM usacv20_pairs AS p".format(_OF_COLMAP, _VALUES),
    PAIRS: "SELECT {}, {} FROM {} AS p".format(_OF_PAIRS, _VALUES, TABLE),
    # COLMAP stores a refused pair as a row without inliers.
    COLMAP: "SELECT {}, CASE WHEN p.rows > 0 THEN p.config ELSE 1 END AS configuration, '' AS reason, "
            "IFNULL(m.rows, 0) AS matches, p.rows AS inliers, NULL AS iterations, NULL AS chance, NULL AS milliseconds "
            "FROM two_view_geometries AS p LEFT JOIN matches AS m ON m.pair_id = p.pair_id".format(_OF_COLMAP)}
_STATE = "CASE WHEN configuration = {:d} THEN {} WHEN configuration = {:d} OR reason != '' THEN {} ELSE {} END".format(
    Configuration.UNDEFINED, FAULT, Configuration.DEGENERATE, REFUSED, VERIFIED)


class Row(typing.NamedTuple):
    """The result of a pair. Values that are missing in the file are None."""

    name: str
    configuration: Configuration
    state: int
    reason: str
    matches: int
    inliers: int
    iterations: Optional[int]
    chance: Optional[float]
    milliseconds: Optional[float]


_ROW = "name, configuration, state, reason, matches, inliers, iterations, chance, milliseconds"


def _row(values: typing.Sequence[Any]) -> Row:
    known = int(values[1]) in list(Configuration)
    return Row(values[0], Configuration(values[1]) if known else Configuration.UNDEFINED, *values[2:])


def withoutNumbers(reason: str) -> str:
    """Returns a reason with all numbers replaced by N, so that similar reasons become equal."""
    return _NUMBER.sub("N", reason)


class Results:
    """A file of results, opened for reading. Raises CollectionError if the file has no results."""

    def __init__(self, path: str) -> None:
        self.path = path
        if os.path.isfile(path):
            with open(path, "rb") as file:
                start = file.read(4)
            if start in (b"PK\3\4", b"\x89HDF"):
                raise CollectionError("{}: a report can be made on a database or on results of `pairs` in an SQLite file, but "
                                      "not in NPZ or HDF5 files".format(path))
        self._connection = connect(path)
        try:
            with explained(path):
                self.kind = self._kind()
                self._prepare()
        except BaseException:
            self._connection.close()
            raise

    def _kind(self) -> str:
        if columns(self._connection, TABLE):
            return PAIRS
        if not columns(self._connection, "images") or not columns(self._connection, "matches"):
            raise CollectionError("{}: neither a COLMAP database nor results of the command `pairs`".format(self.path))
        if columns(self._connection, "usacv20_pairs"):
            return OURS
        if columns(self._connection, "two_view_geometries"):
            return COLMAP
        raise CollectionError("{}: no pair has been verified yet".format(self.path))

    def _prepare(self) -> None:
        self._connection.create_function("withoutNumbers", 1, withoutNumbers, deterministic=True)
        self._connection.create_function("decoded", 1, decoded, deterministic=True)
        if self.kind == PAIRS:
            self._connection.execute("CREATE TEMP TABLE nodes (number INTEGER PRIMARY KEY, image TEXT UNIQUE)")
            self._connection.execute(
                "INSERT INTO temp.nodes (image) SELECT image1 FROM {0} WHERE image1 IS NOT NULL UNION "
                "SELECT image2 FROM {0} WHERE image2 IS NOT NULL ORDER BY 1".format(TABLE))
        self._connection.execute("CREATE TEMP VIEW results AS SELECT *, {} AS state FROM ({})".format(_STATE, _VIEWS[self.kind]))

    def __enter__(self) -> Results:
        return self

    def __exit__(self, *error: object) -> None:
        self._connection.close()
        tidy(self.path)

    def rows(self, sql: str, *values: Any) -> typing.Iterator[Tuple[Any, ...]]:
        with explained(self.path):
            cursor = self._connection.execute(sql, values)
            for block in iter(lambda: cursor.fetchmany(_BLOCK), []):
                yield from block

    def value(self, sql: str, *values: Any) -> Any:
        """Returns the first column of the first row; None if there is no row."""
        with explained(self.path):
            found = self._connection.execute(sql, values).fetchone()
        return None if found is None else found[0]

    def pairs(self, where: str = "1", order: str = "name", most: int = -1,
              values: typing.Sequence[Any] = ()) -> typing.Iterator[Row]:
        """Yields the pairs for which the SQL condition `where` holds.

        most -- maximum number of pairs; -1: all
        values -- values of the parameters in `where`"""
        for row in self.rows("SELECT {} FROM results WHERE {} ORDER BY {} LIMIT {:d}".format(_ROW, where, order, most), *values):
            yield _row(row)

    def reasons(self, most: int) -> List[Tuple[str, int, str]]:
        """Returns (reason, count, example) for each kind of reason of the pairs that are not
        verified, the most frequent kinds first. In the reason, N replaces numbers, and the name of
        the pair is removed. The example is the name of such a pair."""
        name = "decoded(CAST(name AS BLOB))"  # reasons contain the decoded names
        prefix = "substr(reason, 1, length({0}) + 2) = {0} || ': '".format(name)
        kind = "withoutNumbers(CASE WHEN {} THEN substr(reason, length({}) + 3) ELSE reason END)".format(prefix, name)
        return [(reason, count, example) for reason, count, example in self.rows(
            "SELECT {} AS kind, COUNT(*), MIN(name) FROM results WHERE state != {} GROUP BY kind ORDER BY 2 DESC, 1 "
            "LIMIT {:d}".format(kind, VERIFIED, most))]

    def histogram(self, value: str, edges: typing.Sequence[float], where: str) -> List[int]:
        """Returns the number of pairs with edges[i] <= value < edges[i + 1] for each i. Values
        outside of all bins are counted in the first or last bin; unknown values are ignored."""
        cases = " ".join("WHEN {} < {!r} THEN {}".format(value, edge, i) for i, edge in enumerate(edges[1:-1]))
        counts = [0] * (len(edges) - 1)
        for number, count in self.rows("SELECT CASE {} ELSE {} END, COUNT(*) FROM results WHERE {} AND {} IS NOT NULL "
                                       "GROUP BY 1".format(cases, len(edges) - 2, where, value)):
            counts[number] = count
        return counts

    def quantiles(self, value: str, parts: typing.Sequence[float], where: str) -> List[float]:
        """Returns quantiles over the pairs whose value is known; an empty list if there are no such
        pairs."""
        where = "{} AND {} IS NOT NULL".format(where, value)
        count = self.value("SELECT COUNT(*) FROM results WHERE {}".format(where))
        return [self.value("SELECT {} FROM results WHERE {} ORDER BY 1 LIMIT 1 OFFSET {:d}".format(
            value, where, min(int(part * count), count - 1))) for part in parts] if count else []

    def images(self) -> npt.NDArray[np.int64]:
        """Returns the sorted numbers of all images; an empty array if the results do not contain
        the images."""
        sql = "SELECT number FROM temp.nodes ORDER BY 1" if self.kind == PAIRS else "SELECT image_id FROM images ORDER BY 1"
        return np.fromiter((number for number, in self.rows(sql)), np.int64)

    def names(self, images: npt.NDArray[np.int64]) -> Tuple[List[str], npt.NDArray[np.int64]]:
        """Returns the names of the images in alphabetical order and the rank of each image in this
        order. The numbers of images cannot be used for sorting: COLMAP 4 assigns them in the order
        in which its threads finish."""
        sql = "SELECT number, image FROM temp.nodes" if self.kind == PAIRS else "SELECT image_id, name FROM images"
        known: Dict[int, Any] = {number: name for number, name in self.rows(sql)}
        order = sorted(range(len(images)), key=lambda i: (str(known[int(images[i])]), i))
        ranks = np.empty(len(images), np.int64)
        ranks[order] = np.arange(len(images))
        return [str(known[int(images[i])]) for i in order], ranks

    def links(self, where: str = "1") -> typing.Iterator[Tuple[int, int, int, int]]:
        """Yields the ids of the two images, the number of inliers and the state of each pair whose images are known."""
        for first, second, inliers, state in self.rows(
                "SELECT first, second, inliers, state FROM results WHERE first IS NOT NULL AND {}".format(where)):
            yield first, second, inliers, state

    def pairOf(self, first: int, second: int) -> Optional[Row]:
        """Returns the pair of two images; None if there is no such pair."""
        return next(self.pairs("(first = ? AND second = ?) OR (first = ? AND second = ?)", "name", 1,
                               (first, second, second, first)), None)

    def settings(self) -> Dict[str, Any]:
        """Returns the settings of the last run; an empty dictionary if they are unknown."""
        sql = {OURS: "SELECT settings FROM usacv20_runs ORDER BY run_id DESC LIMIT 1",
               PAIRS: "SELECT settings FROM {}".format(RUNS)}.get(self.kind)
        try:
            found = json.loads(self.value(sql) or "{}") if sql else {}
        except ValueError:
            found = {}
        return found if isinstance(found, dict) else {}

    def cameras(self) -> Tuple[int, int]:
        """Returns how many cameras have a known focal length, and the number of cameras; 0 and 0 if the file has no cameras.
        """
        with explained(self.path):
            return knownCameras(self._connection) if columns(self._connection, "cameras") else (0, 0)

    def left(self) -> int:
        """Returns the number of pairs that were not processed; 0 if this number is unknown."""
        table = {OURS: "usacv20_pairs", COLMAP: "two_view_geometries"}.get(self.kind)
        return 0 if table is None else int(self.value(
            "SELECT COUNT(*) FROM matches WHERE pair_id NOT IN (SELECT pair_id FROM {})".format(table)))

    def changed(self) -> int:
        """Returns the number of rows in COLMAP's table that differ from what this tool has written;
        0 if this tool has not written to the file."""
        if self.kind != OURS:
            return 0
        if not columns(self._connection, "two_view_geometries"):
            return int(self.value("SELECT COUNT(*) FROM results WHERE state != {}".format(FAULT)))
        return int(self.value(
            "SELECT COUNT(*) FROM two_view_geometries AS g LEFT JOIN usacv20_pairs AS p USING (pair_id) "
            "WHERE p.pair_id IS NULL OR p.inliers != g.rows OR p.configuration != g.config"))
