# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Results of the command `pairs` as arrays in an NPZ or HDF5 file, written and read in blocks.

For N pairs in the order of their names:
- names: N texts; images: N x 2 texts, empty for pairs whose image names are unknown; if the image
  names of all pairs are unknown, the array is missing
- configurations: N integers, see Configuration; matches, iterations, chances,
  milliseconds: N numbers each, see TwoView
- F, E, H: N x 3 x 3, quaternions: N x 4, translations: N x 3; NaN: not estimated or not found
- reasons: the distinct reasons as texts; reason: N indices into `reasons`. An empty text means that
  the pair is not refused
- inliers: a row for each inlier, ordered by pairs, with the indices of its keypoints in both images
  or, if there are no keypoints, the index of the match in both columns; offsets: N + 1 numbers;
  the inliers of pair i are inliers[offsets[i]:offsets[i + 1]]
- settings: a JSON text with the settings that the results depend on"""

from __future__ import annotations

import contextlib
import os
import sqlite3
import typing
import zipfile
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple, cast

import numpy as np

from ._list_files import UNREADABLE, fail
from ._list_hdf5 import openFile, useH5py
from ._pair import Configuration, TwoView

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[Any]

_BLOCK = 4096  # maximum number of pairs in memory at a time
_MODELS = (("quaternions", "quaternion", (4,)), ("translations", "translation", (3,)), ("F", "F", (3, 3)), ("E", "E", (3, 3)),
           ("H", "H", (3, 3)))
_NUMBERS = (("configurations", "configuration", "<i4"), ("matches", "matches", "<i8"), ("iterations", "iterations", "<i8"),
            ("chances", "chance", "<f8"), ("milliseconds", "milliseconds", "<f8"))


class _Writer(typing.Protocol):
    def array(self, name: str, dtype: str, shape: Tuple[int, ...], blocks: typing.Iterator[_Array]) -> None:
        """Writes an array from blocks of rows."""

    def close(self) -> None:
        """Completes the file."""


class _NpzWriter:
    def __init__(self, path: str) -> None:
        self._zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1)

    def array(self, name: str, dtype: str, shape: Tuple[int, ...], blocks: typing.Iterator[_Array]) -> None:
        header = {"descr": dtype, "fortran_order": False, "shape": shape}
        with self._zip.open(name + ".npy", "w", force_zip64=True) as out:
            np.lib.format.write_array_header_1_0(cast(typing.BinaryIO, out), header)  # type: ignore[no-untyped-call]
            for block in blocks:
                out.write(np.ascontiguousarray(block, dtype).tobytes())

    def close(self) -> None:
        self._zip.close()


class _Hdf5Writer:
    def __init__(self, path: str) -> None:
        self._h5py = useH5py()
        self._file = self._h5py.File(path, "w")

    def array(self, name: str, dtype: str, shape: Tuple[int, ...], blocks: typing.Iterator[_Array]) -> None:
        text = dtype.startswith("<U")
        array = self._file.create_dataset(name, shape, self._h5py.string_dtype() if text else dtype)
        row = 0
        for block in blocks:
            array[row:row + len(block)] = block.astype(object) if text else block
            row += len(block)

    def close(self) -> None:
        self._file.close()


def check(path: str) -> None:
    """Raises CollectionError if a file at this path needs h5py, and h5py is missing."""
    if not path.lower().endswith(".npz"):
        useH5py()


class _Table:
    """The columns of the table of results, in blocks of rows."""

    def __init__(self, connection: sqlite3.Connection, table: str) -> None:
        self._connection, self._table = connection, table

    def value(self, expression: str) -> int:
        found = self._connection.execute("SELECT {} FROM {}".format(expression, self._table)).fetchone()[0]
        return int(found or 0)

    def settings(self) -> str:
        return str(self._connection.execute("SELECT settings FROM {}_runs".format(self._table)).fetchone()[0])

    def blocks(self, columns: str, make: Callable[[List[Tuple[Any, ...]]], _Array]) -> typing.Iterator[_Array]:
        cursor = self._connection.execute("SELECT {} FROM {} ORDER BY name".format(columns, self._table))
        while True:
            rows = cursor.fetchmany(_BLOCK)
            if not rows:
                return
            yield make(rows)

    def reasons(self) -> List[str]:
        return [reason for reason, in self._connection.execute(
            "SELECT DISTINCT reason FROM {} ORDER BY reason".format(self._table))]

    def offsets(self) -> typing.Iterator[_Array]:
        last = 0
        yield np.zeros(1, np.int64)
        for block in self.blocks("inliers", lambda rows: np.array(rows, np.int64)[:, 0]):
            ends = last + np.cumsum(block)
            last = int(ends[-1])
            yield ends


def _model(rows: List[Tuple[Any, ...]], shape: Tuple[int, ...]) -> _Array:
    none = np.full(shape, np.nan, "<f8").tobytes()
    return np.frombuffer(b"".join(none if row[0] is None else row[0] for row in rows), "<f8").reshape((-1,) + shape)


def _writeAll(writer: _Writer, table: _Table) -> None:
    settings = table.settings()
    writer.array("settings", "<U{}".format(len(settings)), (1,), iter([np.array([settings])]))
    count, reasons = table.value("COUNT(*)"), table.reasons()
    numbers = {reason: number for number, reason in enumerate(reasons)}
    text = "<U{}".format(max(table.value("MAX(LENGTH(name))"), 1))
    writer.array("names", text, (count,), table.blocks("name", lambda rows: np.array(rows)[:, 0]))
    if table.value("COUNT(image1)"):
        text = "<U{}".format(max(table.value("MAX(MAX(LENGTH(image1), LENGTH(image2)))"), 1))
        writer.array("images", text, (count, 2), table.blocks("IFNULL(image1, ''), IFNULL(image2, '')", np.array))
    for name, column, dtype in _NUMBERS:
        writer.array(name, dtype, (count,), table.blocks(column, lambda rows: np.array(rows, float)[:, 0]))
    for name, column, shape in _MODELS:
        writer.array(name, "<f8", (count,) + shape, table.blocks(column, lambda rows: _model(rows, shape)))  # noqa: B023
    writer.array("reasons", "<U{}".format(max([len(reason) for reason in reasons] + [1])), (len(reasons),),
                 iter([np.array(reasons)] if reasons else []))
    writer.array("reason", "<i4", (count,), table.blocks("reason", lambda rows: np.array([numbers[row[0]] for row in rows])))
    writer.array("offsets", "<i8", (count + 1,), table.offsets())
    writer.array("inliers", "<u4", (table.value("SUM(inliers)"), 2), table.blocks(
        "inlier_matches", lambda rows: np.frombuffer(b"".join(row[0] for row in rows), "<u4").reshape(-1, 2)))


def write(path: str, connection: sqlite3.Connection, table: str) -> None:
    """Writes the results in a table to an NPZ or HDF5 file. The file appears at its path only when
    it is complete."""
    made = path + ".new"
    try:
        writer: _Writer
        if path.lower().endswith(".npz"):
            writer = _NpzWriter(made)
        else:
            writer = _Hdf5Writer(made)
        _writeAll(writer, _Table(connection, table))
        writer.close()
        os.replace(made, path)
    except OSError as error:
        fail("{}: {}".format(path, error.strerror or error))


class _NpzArray:
    """An array of an NPZ file, read sequentially in blocks."""

    def __init__(self, stream: typing.IO[bytes]) -> None:
        version = np.lib.format.read_magic(stream)  # type: ignore[no-untyped-call]
        read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        self.shape, columnMajor, self._dtype = read(stream)  # type: ignore[no-untyped-call]
        if columnMajor and len(self.shape) > 1:
            raise ValueError("not in the order of rows")
        self._stream = stream

    def next(self, rows: int) -> _Array:
        shape = (rows,) + tuple(self.shape[1:])
        size = int(np.prod(shape)) * self._dtype.itemsize
        data = self._stream.read(size)
        if len(data) < size:
            raise EOFError
        return np.frombuffer(data, self._dtype).reshape(shape)


class _Hdf5Array:
    def __init__(self, array: Any) -> None:
        self.shape, self._row = array.shape, 0
        self._array = array.asstr() if array.dtype.kind == "O" else array

    def next(self, rows: int) -> _Array:
        self._row += rows
        return cast("_Array", self._array[self._row - rows:self._row])


def _results(open_: Callable[[str], Any]) -> typing.Iterator[TwoView]:
    names = ["names", "reason", "offsets", "inliers"] + [row[0] for row in _NUMBERS + _MODELS]
    arrays = {name: open_(name) for name in names}
    table = open_("reasons")
    reasons = [str(reason) for reason in table.next(table.shape[0])]
    (count,) = arrays["names"].shape
    end = int(arrays.pop("offsets").next(1)[0])
    offsets, inliers = open_("offsets"), arrays.pop("inliers")
    offsets.next(1)
    for start in range(0, count, _BLOCK):
        rows = min(_BLOCK, count - start)
        block: Dict[str, _Array] = {name: array.next(rows) for name, array in arrays.items()}
        for i, last in enumerate(int(last) for last in offsets.next(rows)):
            models: List[Optional[_Array]] = []
            for name, _, _ in _MODELS:
                model = np.array(block[name][i], np.float64)
                models.append(None if np.isnan(model).all() else model)
            quaternion, translation, F, E, H = models
            yield TwoView(str(block["names"][i]), Configuration(int(block["configurations"][i])),
                          inliers.next(last - end).astype(np.uint32), F, E, H, quaternion, translation,
                          reasons[int(block["reason"][i])], int(block["matches"][i]), int(block["iterations"][i]),
                          float(block["chances"][i]), float(block["milliseconds"][i]))
            end = last


@contextlib.contextmanager
def _arrays(path: str) -> typing.Iterator[Callable[[str], Any]]:
    """Yields a function that opens an array of the file by its name."""
    try:
        with open(path, "rb") as file:
            start = file.read(8)
        if start.startswith(b"PK"):
            with zipfile.ZipFile(path) as members:
                yield lambda name: _NpzArray(members.open(name + ".npy"))
        elif start == b"\x89HDF\r\n\x1a\n":
            with openFile(path) as group:
                yield lambda name: _Hdf5Array(group[name])
        else:
            raise ValueError
    except UNREADABLE + (IndexError, TypeError) as error:
        if isinstance(error, OSError) and error.strerror:
            fail("{}: {}".format(path, error.strerror))
        fail("{}: no results of the command `pairs`, or damaged ones".format(path))


def read(path: str) -> typing.Iterator[TwoView]:
    """Yields the results of a file. Raises CollectionError if the file is damaged."""
    with _arrays(path) as arrays:
        yield from _results(arrays)


def readSettings(path: str) -> str:
    """Returns the settings on which the results of a file depend. Raises CollectionError if the
    file is damaged."""
    with _arrays(path) as arrays:
        return str(arrays("settings").next(1)[0])
