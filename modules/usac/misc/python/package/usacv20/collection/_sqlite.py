# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Opens and copies SQLite databases, and converts errors of SQLite to messages for the user."""

from __future__ import annotations

import contextlib
import os
import pathlib
import sqlite3
import typing
from typing import Dict, List, Optional, Tuple

from ._pair import CollectionError

PATIENCE = 5.0  # maximum number of seconds to wait for a lock of another connection

# Required tables and their columns, which COLMAP 3.8 and all later versions have.
INPUT: Dict[str, typing.Sequence[str]] = {
    "cameras": ("camera_id", "model", "width", "height", "params", "prior_focal_length"),
    "images": ("image_id", "name", "camera_id"),
    "keypoints": ("image_id", "rows", "cols", "data"),
    "matches": ("pair_id", "rows", "cols", "data"),
}

# A part of SQLite's message, and the message for the user; {} are the path and SQLite's message.
_MEANINGS = (
    ("file is not a database", "{}: this is not a database of SQLite"),
    ("malformed", "{}: the database is damaged or was cut off ({})"),
    ("file is encrypted", "{}: this is not a database of SQLite"),
    ("locked", "{}: another program keeps the database locked"),
    ("readonly", "{}: the database cannot be written: the file or its folder is read-only"),
    ("unable to open", "{}: the database cannot be opened; its folder may be read-only"),
    ("disk is full", "{}: the disk is full"),
)


@contextlib.contextmanager
def explained(path: str) -> typing.Iterator[None]:
    """Converts exceptions of SQLite to a CollectionError of one line."""
    try:
        yield
    except sqlite3.Error as error:
        message = " ".join(str(error).split())
        for part, meaning in _MEANINGS:
            if part in message:
                raise CollectionError(meaning.format(path, message)) from error
        raise CollectionError("{}: SQLite says: {}".format(path, message)) from error


def connect(path: str, write: bool = False) -> sqlite3.Connection:
    """Opens an existing database. Transactions start and end only by explicit statements.

    write -- False: the database is opened read-only. If SQLite cannot create the files that it
    needs next to a database in WAL mode (because the folder is read-only), the database is read
    without these files, provided that no program is writing to it"""
    if not os.path.exists(path):
        raise CollectionError("{}: there is no such file".format(path))
    if not os.path.isfile(path):
        raise CollectionError("{}: this is not a file".format(path))
    if not os.access(path, os.R_OK):
        raise CollectionError("{}: the file cannot be read: permission denied".format(path))
    with explained(path):
        connection = _open(path, "mode=rw" if write else "mode=ro")
        if write:
            return connection
        try:
            connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
        except sqlite3.OperationalError:
            connection.close()
            journal = path + "-wal"
            if os.access(os.path.dirname(os.path.abspath(path)), os.W_OK) or os.path.exists(journal) and os.path.getsize(journal):
                raise
            connection = _open(path, "mode=ro&immutable=1")
        except BaseException:
            connection.close()
            raise
        return connection


def _open(path: str, options: str) -> sqlite3.Connection:
    return opened("{}?{}".format(pathlib.Path(os.path.abspath(path)).as_uri(), options), uri=True)


def opened(path: str, uri: bool = False) -> sqlite3.Connection:
    """Returns a connection with the options that all connections of the tool share."""
    connection = sqlite3.connect(path, uri=uri, timeout=PATIENCE, isolation_level=None, check_same_thread=False)
    connection.text_factory = decoded
    return connection


def decoded(text: bytes) -> str:
    """Converts a text of a database. Bytes that are not UTF-8 become escapes such as \\xe9: COLMAP stores
    the names of image files as they are, in any encoding. Unlike surrogates, escapes can be printed
    and stored everywhere, and unlike replacement characters, they keep different names different."""
    return text.decode("utf-8", "backslashreplace")


def columns(connection: sqlite3.Connection, table: str) -> List[str]:
    """Returns the names of the columns in the order of the table; an empty list if there is no such
    table."""
    return [row[1] for row in connection.execute('PRAGMA table_info("{}")'.format(table.replace('"', '""')))]


def checkInput(connection: sqlite3.Connection, path: str) -> None:
    """Raises CollectionError if the file is not a COLMAP database, or if it is damaged."""
    with explained(path):
        if os.path.getsize(path) == 0:
            raise CollectionError("{}: the file is empty".format(path))
        for table, needed in INPUT.items():
            found = columns(connection, table)
            if not found:
                raise CollectionError("{}: this is not a database of COLMAP: it has no table {}".format(path, table))
            for name in needed:
                if name not in found:
                    raise CollectionError("{}: this is not a database of COLMAP: its table {} has no column {}".format(
                        path, table, name))
        # SQLite detects missing pages, but it reads the missing end of a truncated page as zeros.
        if os.path.getsize(path) % int(connection.execute("PRAGMA page_size").fetchone()[0]):
            raise CollectionError("{}: the database is damaged or was cut off in the middle of a page".format(path))


def knownCameras(connection: sqlite3.Connection) -> Tuple[int, int]:
    """Returns how many of the cameras of the images have a known focal length, and the number of these cameras."""
    known, every = connection.execute("SELECT total(prior_focal_length != 0), count(*) FROM cameras "
                                      "WHERE camera_id IN (SELECT camera_id FROM images)").fetchone()
    return int(known), int(every)


def focalNote(known: int, every: int) -> str:
    """Returns what the numbers of knownCameras mean for the results; an empty text if all focal lengths are known."""
    if known == every:
        return ""
    return "{} of {} cameras {} a known focal length: only F and H{}".format(
        known, every, "has" if 1 in (known, every) else "have", " for pairs with one of the others" if known else "")


def tidy(path: str) -> None:
    """Removes the empty files that a reader leaves next to a database in WAL mode, unless another
    program uses them."""
    journal = path + "-wal"
    try:
        if os.path.exists(journal) and not os.path.getsize(journal) and os.access(path, os.W_OK):
            with contextlib.closing(_open(path, "mode=rw")) as connection:
                connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    except (OSError, sqlite3.Error):
        pass  # these files are harmless


def copyDatabase(source: str, target: str) -> None:
    """Copies the current state of a database, even if other programs are using it. `target` must
    not exist."""
    folder = os.path.dirname(os.path.abspath(target))
    if not os.path.isdir(folder):
        raise CollectionError("{}: there is no folder {}".format(target, folder))
    reader = connect(source)
    try:
        checkInput(reader, source)
        try:
            os.close(os.open(target, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        except FileExistsError:
            raise CollectionError("{}: this file exists already and is not overwritten".format(target)) from None
        except OSError as error:
            raise CollectionError("{}: the copy cannot be written: {}".format(target, error.strerror)) from error
        try:
            with explained(target), contextlib.closing(connect(target, write=True)) as writer:
                reader.backup(writer, pages=4096)
            tidy(target)
        except BaseException:
            _remove(target)
            raise
    finally:
        reader.close()
        tidy(source)


@contextlib.contextmanager
def copied(source: str, target: Optional[str]) -> typing.Iterator[None]:
    """Copies a database as copyDatabase does; None as `target`: no copy is made. If the body of the `with` statement
    raises an exception, the copy is removed."""
    if target:
        copyDatabase(source, target)
    try:
        yield
    except BaseException:
        if target:
            _remove(target)
        raise


def _remove(path: str) -> None:
    for name in (path, path + "-journal", path + "-wal", path + "-shm"):  # SQLite's files remain if the disk is full
        with contextlib.suppress(FileNotFoundError):
            os.remove(name)
