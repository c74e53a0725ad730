# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads pairs from a database of COLMAP 3.8 or later. Tables and columns that this file does not name
can be missing."""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import os
import sqlite3
import threading
import typing
from collections import OrderedDict
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple, Union

import numpy as np

from ._cameras import Camera, blobOf, sizeOf
from ._pair import CollectionError, Fault, Key, Pair, View
from ._sqlite import checkInput, connect, explained, tidy

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]
    _Matches = npt.NDArray[np.uint32]

# COLMAP's pair_id is this number times the smaller image_id, plus the larger image_id.
IMAGES = 2147483647
CACHE = 256 << 20  # maximum number of bytes of keypoints that each process keeps in memory
_PAGE = 4096  # number of keys in a query; a single query for all keys would prevent other connections from writing
_COLUMNS = (2, 4, 6)  # allowed numbers of columns of keypoints: x, y; x, y, scale, orientation; x, y, 2x2 affine shape


class Scores(typing.Protocol):
    """A source of scores of matches. Objects must be picklable."""

    higherIsBetter: bool

    def of(self, key: int, first: str, second: str, matches: _Matches,
           connection: sqlite3.Connection) -> Optional[_Array]:
        """Returns a score for each match, of which there is at least one, or None if there are no
        scores. `key` is the pair_id; `first` and `second` are the names of the images. If this method
        raises CollectionError, the pair becomes a Fault."""


class _Image(typing.NamedTuple):
    """The data of an image that pairs need."""

    name: str
    camera: Optional[Camera]
    taken: npt.NDArray[np.float32]  # N x 2, keypoints of the original (distorted) image in pixels
    ideal: Optional[_Array]  # N x 2, the keypoints without distortion; None: the camera has no distortion
    finite: bool  # True: all coordinates of `taken` are finite
    seen: Optional[npt.NDArray[np.bool_]]  # N entries, True where the point of `ideal` is finite; None: all of them are, or `ideal` is None
    fault: str  # why the image cannot be used; empty: it can be used


class _Wrong(Exception):
    """Raised if a pair cannot be used. The message does not contain the names of the images."""


class _Cache:
    """Keeps the most recently used images in limited memory, for all threads of a process."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._bytes = 0
        self._images: OrderedDict[int, Tuple[_Image, int]] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, number: int) -> Optional[_Image]:
        with self._lock:
            found = self._images.get(number)
            if found is None:
                return None
            self._images.move_to_end(number)
            return found[0]

    def put(self, number: int, image: _Image) -> None:
        size = 1000 + image.taken.nbytes + (0 if image.ideal is None else image.ideal.nbytes)
        with self._lock:
            if number in self._images:  # another thread has added it
                return
            self._images[number] = image, size
            self._bytes += size
            while self._bytes > self._limit and len(self._images) > 1:
                self._bytes -= self._images.popitem(last=False)[1][1]


class DatabaseSource:
    """A Source of the pairs in the table `matches`, in the order of pair_id.

    path -- path of the database
    scores -- source of the scores of the matches; None: there are no scores
    cache -- maximum number of bytes of keypoints that each process keeps in memory

    If the file is damaged or is not a COLMAP database, the first use of this object raises
    CollectionError. A single damaged pair becomes a Fault. Matches with a point that corresponds to
    no direction in front of the camera (see Camera.ideal) are left out of a Pair."""

    def __init__(self, path: str, scores: Optional[Scores] = None, cache: int = CACHE) -> None:
        self.path = os.path.abspath(path)
        self.scores = scores
        self._cacheSize = cache
        self._prepare()

    def _prepare(self) -> None:
        self._cache = _Cache(self._cacheSize)
        self._opened: List[sqlite3.Connection] = []
        self._local = threading.local()
        self._lock = threading.Lock()
        self._process = os.getpid()
        self._count: Optional[int] = None

    def __getstate__(self) -> Dict[str, Any]:
        return {"path": self.path, "scores": self.scores, "_cacheSize": self._cacheSize}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._prepare()

    def connection(self) -> sqlite3.Connection:
        """Returns the connection of this thread, which is opened at its first use."""
        if self._process != os.getpid():  # a connection does not survive a fork
            self._prepare()
        found: Optional[sqlite3.Connection] = getattr(self._local, "connection", None)
        if found is None:
            found = connect(self.path)
            try:
                checkInput(found, self.path)
            except BaseException:
                found.close()
                raise
            self._local.connection = found
            with self._lock:
                self._opened.append(found)
        return found

    def close(self) -> None:
        """Closes the connections of all threads, none of which must be in use. The next use of the
        source opens new connections."""
        opened = self._opened if self._process == os.getpid() else []
        self._prepare()
        for connection in opened:
            connection.close()
        if opened:
            tidy(self.path)

    def __del__(self) -> None:
        with contextlib.suppress(Exception):
            self.close()

    def keys(self) -> typing.Iterator[Key]:
        last = -(1 << 63)
        while True:
            with explained(self.path):
                page = self.connection().execute("SELECT pair_id FROM matches WHERE pair_id > ? ORDER BY pair_id LIMIT ?",
                                                 (last, _PAGE)).fetchall()
            if not page:
                return
            for (key,) in page:
                yield int(key)
            last = page[-1][0]

    def __len__(self) -> int:
        if self._count is None:
            with explained(self.path):
                self._count = int(self.connection().execute("SELECT count(*) FROM matches").fetchone()[0])
        return self._count

    def counts(self) -> Dict[str, Any]:
        """Returns the number of rows of each input table and, for keypoints and matches, their total
        number."""
        with explained(self.path):
            return {table: self.connection().execute("SELECT count(*), {} FROM {}".format(total, table)).fetchone()
                    for table, total in (("cameras", "0"), ("images", "0"), ("keypoints", "total(rows)"),
                                         ("matches", "total(rows)"))}

    def fingerprint(self) -> str:
        """Returns a fingerprint of the first and the last rows of the input tables, and of the scores
        of the first pair. The fingerprint does not change when results are written."""
        digest = hashlib.sha256()
        for table, key, values in (("cameras", "camera_id", "model, width, height, params, prior_focal_length"),
                                   ("images", "image_id", "name, camera_id"), ("keypoints", "image_id", "rows, cols, data"),
                                   ("matches", "pair_id", "rows, cols, data")):
            for order in ("ASC", "DESC"):
                with explained(self.path):
                    rows = self.connection().execute("SELECT {0}, {1} FROM {2} ORDER BY {0} {3} LIMIT 4".format(
                        key, values, table, order)).fetchall()
                digest.update(repr(rows).encode())
        for first in itertools.islice(self.keys(), 1):  # adds the scores of the first pair, which can come from another file
            item = self.load([first])[0]
            digest.update(repr(item if isinstance(item, Fault) else item.scores is not None and item.scores.tobytes()).encode())
        return digest.hexdigest()

    def load(self, keys: typing.Sequence[Key]) -> List[Union[Pair, Fault]]:
        with explained(self.path):
            connection = self.connection()
            return [self._load(connection, int(key)) for key in keys]

    def _load(self, connection: sqlite3.Connection, key: int) -> Union[Pair, Fault]:
        numbers = divmod(key, IMAGES)
        first, second = (self._image(connection, number) for number in numbers)
        try:
            for image in (first, second):
                if image.fault:
                    raise _Wrong(image.fault)
            if numbers[0] == numbers[1]:
                raise _Wrong("an image is matched with itself")
            matches, stored = _matches(connection, key)
            for side, image in enumerate((first, second)):
                _check(matches, side, image)
            scores = self._scores(connection, key, first.name, second.name, matches)
        except _Wrong as wrong:
            return Fault(key, "{} - {}: {}".format(first.name, second.name, wrong))
        seen = _seen(matches, first, second)
        if seen is not None:
            matches, scores = matches[seen], None if scores is None else scores[seen]
        views = [_view(image, matches[:, side]) for side, image in enumerate((first, second))]
        return Pair(key, views[0], views[1], matches, scores, self.scores is None or self.scores.higherIsBetter, stored)

    def _scores(self, connection: sqlite3.Connection, key: int, first: str, second: str, matches: _Matches) -> Optional[_Array]:
        if self.scores is None or not len(matches):  # COLMAP's rows without matches have no scores
            return None
        try:
            found = self.scores.of(key, first, second, matches, connection)
        except CollectionError as error:
            raise _Wrong(str(error)) from error
        if found is not None and found.shape != (len(matches),):
            raise _Wrong("{} scores of {} matches".format(len(found), len(matches)))
        return found

    def _image(self, connection: sqlite3.Connection, number: int) -> _Image:
        image = self._cache.get(number)
        if image is None:
            image = _readImage(connection, number)
            self._cache.put(number, image)
        return image


def _readImage(connection: sqlite3.Connection, number: int) -> _Image:
    none = np.empty((0, 2), np.float32)
    rows = connection.execute("SELECT name, camera_id FROM images WHERE image_id = ?", (number,)).fetchall()
    if not rows:
        name = "image {}".format(number)
        return _Image(name, None, none, None, True, None, name + " is not in the table images")
    name, cameraNumber = str(rows[0][0]), rows[0][1]
    try:
        camera = _readCamera(connection, name, cameraNumber)
        taken = _readKeypoints(connection, name, number)
    except _Wrong as wrong:
        return _Image(name, None, none, None, True, None, str(wrong))
    ideal = camera.ideal(taken) if camera.distorted else None
    seen: Any = None if ideal is None else np.isfinite(ideal).all(axis=1)
    return _Image(name, camera, taken, ideal, bool(np.isfinite(taken).all()), None if seen is None or seen.all() else seen, "")


def _readCamera(connection: sqlite3.Connection, name: str, number: Any) -> Camera:
    rows = connection.execute("SELECT camera_id, model, width, height, params, prior_focal_length FROM cameras "
                              "WHERE camera_id = ?", (number,)).fetchall()
    if not rows:
        raise _Wrong("camera {} of {} is not in the table cameras".format(number, name))
    try:
        return Camera.fromColmap(*rows[0])
    except CollectionError as error:
        raise _Wrong("{}: {}".format(name, error)) from error


def _readKeypoints(connection: sqlite3.Connection, name: str, number: int) -> npt.NDArray[np.float32]:
    stored = connection.execute("SELECT rows, cols, data FROM keypoints WHERE image_id = ?", (number,)).fetchall()
    if not stored:
        return np.empty((0, 2), np.float32)
    rows, columns, data = stored[0]
    if columns not in _COLUMNS:
        raise _Wrong("keypoints of {} have {} columns, not 2, 4 or 6".format(name, columns))
    blob = blobOf(data)
    if blob is None or not isinstance(rows, int) or len(blob) != 4 * rows * columns:
        raise _Wrong("keypoints of {}: {} rows of {} numbers do not fit into {}".format(name, rows, columns, sizeOf(blob)))
    table = np.frombuffer(blob, "<f4").reshape(rows, columns)
    return table[:, :2].astype(np.float32)


def matchesHash(rows: Any, columns: Any, data: Any) -> int:
    """Returns a hash of a row of the table `matches`; the arguments are its columns rows, cols and data."""
    digest = hashlib.blake2b(repr((rows, columns)).encode(), digest_size=8)
    digest.update(data if isinstance(data, bytes) else b"")
    return int.from_bytes(digest.digest(), "little", signed=True)


def _matches(connection: sqlite3.Connection, key: int) -> Tuple[_Matches, int]:
    """Returns the matches of a pair and their hash."""
    stored = connection.execute("SELECT rows, cols, data FROM matches WHERE pair_id = ?", (key,)).fetchall()
    if not stored:
        raise _Wrong("the pair is no longer in the table matches")
    rows, columns, data = stored[0]
    blob = blobOf(data)
    if blob is None or not isinstance(rows, int) or (columns != 2 and rows) or len(blob) != 8 * rows:
        raise _Wrong("{} rows of {} numbers do not fit into {} of matches".format(rows, columns, sizeOf(blob)))
    return np.frombuffer(blob, "<u4").reshape(rows, 2).astype(np.uint32), matchesHash(rows, columns, data)


def _check(matches: _Matches, side: int, image: _Image) -> None:
    numbers = matches[:, side]
    count = len(image.taken)
    if len(numbers) and numbers.max() >= count:
        match = int(np.argmax(numbers >= count))
        raise _Wrong("match {} is of keypoint {} of {}, which has {}".format(match, numbers[match], image.name, count or "none"))
    if image.finite:
        return
    wrong = ~np.isfinite(image.taken[numbers]).all(axis=1)
    if wrong.any():
        match = int(np.argmax(wrong))
        x, y = image.taken[numbers[match]]
        raise _Wrong("match {}: keypoint {} of {} is at ({:g}, {:g})".format(match, numbers[match], image.name, x, y))


def _seen(matches: _Matches, first: _Image, second: _Image) -> Optional[npt.NDArray[np.bool_]]:
    """Returns an array with an entry for each match: True if both points correspond to a direction
    in front of the camera. Returns None if this holds for all matches."""
    result: Optional[npt.NDArray[np.bool_]] = None
    for side, image in enumerate((first, second)):
        if image.seen is not None:
            found = image.seen[matches[:, side]]
            result = found if result is None else result & found
    return None if result is None or result.all() else result


def _view(image: _Image, numbers: npt.NDArray[np.uint32]) -> View:
    camera = image.camera
    assert camera is not None
    taken = image.taken.take(numbers, axis=0).astype(np.float64)
    points = taken if image.ideal is None else image.ideal.take(numbers, axis=0)
    return View(image.name, points, taken, camera.matrix, camera.focalKnown, camera.width, camera.height)
