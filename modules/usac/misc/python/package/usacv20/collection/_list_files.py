# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads a pair for the command `pairs` from a `.corr` file or from arrays with commonly used names.
"""

from __future__ import annotations

import json
import os
import zipfile
import zlib
from typing import TYPE_CHECKING, Any, Callable, Dict, List, NoReturn, Optional, Tuple

import numpy as np

from ._pair import CollectionError, Key, Pair, View

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[Any]
    _Points = npt.NDArray[np.float64]
    _Get = Callable[[str], Optional[_Array]]  # returns the array of a name, or None if there is none

# Names of the arrays with the points of image 1 and of image 2. If these names begin with
# `keypoints`, there can also be an array of matches (MATCHES).
POINTS = (("points1", "points2"), ("mkpts0", "mkpts1"), ("keypoints0", "keypoints1"), ("keypoints1", "keypoints2"))
MATCHES = ("matches0", "matches")
SCORES = (("scores", True), ("matching_scores0", True), ("matching_scores", True), ("match_confidence", True),
          ("confidence", True), ("mconf", True), ("ratios", False))  # True: higher is better
SIZES = ("size", "image_size")
# Exceptions of NumPy for a file that is not a valid NPZ file. MemoryError is one of them, because a
# damaged header can state any size.
UNREADABLE: Any = (OSError, ValueError, EOFError, KeyError, MemoryError, NotImplementedError, zipfile.BadZipFile, zlib.error)
# COLMAP's guess for an unknown focal length, as a multiple of the larger side of the image
# (default_focal_length_factor).
_FOCAL_LENGTH = 1.2


def fail(message: str) -> NoReturn:
    raise CollectionError(message)


def _view(name: str, points: _Points, matrix: Optional[_Points], size: Optional[Tuple[int, int]]) -> View:
    """Returns a view of an image without distortion. If the camera matrix is unknown, it is guessed
    from the size of the image or, if the size is also unknown, from the extent of the points;
    focalKnown is then False."""
    width, height = size or (0, 0)
    if matrix is not None:
        return View(name, points, points, matrix, True, width, height)
    extent = (width, height) if width and height else tuple(points.max(axis=0) + 1) if len(points) else (1, 1)
    focal = _FOCAL_LENGTH * max(float(max(extent)), 1.0)
    guess = np.array([[focal, 0, (extent[0] - 1) / 2], [0, focal, (extent[1] - 1) / 2], [0, 0, 1]], np.float64)
    return View(name, points, points, guess, False, width, height)


def _numbers(array: Any, name: str, columns: int) -> npt.NDArray[np.float64]:
    """Converts an array to N x columns numbers of double precision, or to N numbers if columns is
    0. Raises CollectionError if the array is not numeric, its shape does not fit, or a number is
    not finite."""
    try:
        numbers = np.ascontiguousarray(array, np.float64)
    except (TypeError, ValueError):
        fail("{}: no array of numbers".format(name))
    if numbers.size == 0:
        numbers = numbers.reshape((0, columns) if columns else 0)
    if numbers.ndim != (2 if columns else 1) or (columns and numbers.shape[1] != columns):
        expected = "N x {}".format(columns) if columns else "N"
        fail("{}: {} numbers are expected, not {}".format(name, expected, " x ".join(str(n) for n in numbers.shape)))
    wrong = ~(np.isfinite(numbers).all(axis=1) if columns else np.isfinite(numbers))
    if wrong.any():
        fail("{}: row {} is not finite".format(name, int(wrong.argmax())))
    return numbers


def _matrix(array: Any, name: str) -> _Points:
    matrix = _numbers(array, name, 3)
    if matrix.shape != (3, 3) or matrix[0, 0] <= 0 or matrix[1, 1] <= 0 or not np.allclose(matrix[2], (0, 0, 1)):
        fail("{}: no camera matrix".format(name))
    return matrix


def _size(array: Any, name: str) -> Tuple[int, int]:
    size = _numbers(np.ravel(array), name, 0)
    if len(size) != 2 or (size < 0).any() or (size >= 2**31).any():
        fail("{}: width and height are expected".format(name))
    return int(size[0]), int(size[1])


def _ofBoth(get: _Get, stem: str, each: Callable[[Any, str], Any]) -> Tuple[Any, Any]:
    """Returns the converted arrays stem1 and stem2, or stem0 and stem1; (None, None) if there are
    no such arrays. Raises CollectionError if only one of the two exists."""
    zero = get(stem + "0")
    names = (stem + "1", stem + "2") if zero is None else (stem + "0", stem + "1")
    arrays = [get(name) for name in names]
    if arrays[0] is None and arrays[1] is None:
        return None, None
    for array, name, other in zip(arrays, names, names[::-1]):
        if array is None:
            fail("{}, but no {}".format(other, name))
    return each(arrays[0], names[0]), each(arrays[1], names[1])


def _rows(matches: Any, name: str, points: List[_Points], names: Tuple[str, str]) -> npt.NDArray[np.int64]:
    """Returns M x 2 indices of keypoints. `matches` either has this form, or contains for each
    keypoint of image 1 the index of its match in image 2 (negative: no match)."""
    if not isinstance(matches, np.ndarray):  # an empty or textual dataset of HDF5
        fail("{}: no array of numbers".format(name))
    if matches.size and matches.dtype.kind not in "iu":
        fail("{}: whole numbers are expected".format(name))
    rows = matches.astype(np.int64)
    if rows.ndim == 1 and (rows.size or not len(points[0])):
        if len(rows) != len(points[0]):
            fail("{}: {} numbers for {} keypoints of {}".format(name, len(rows), len(points[0]), names[0]))
        first = np.flatnonzero(rows >= 0)
        rows = np.column_stack((first, rows[first]))
    elif not rows.size:
        rows = rows.reshape(0, 2)
    elif rows.ndim != 2 or rows.shape[1] != 2:
        fail("{}: N or N x 2 numbers are expected, not {}".format(name, " x ".join(str(n) for n in rows.shape)))
    for side in (0, 1):
        wrong = (rows[:, side] < 0) | (rows[:, side] >= len(points[side]))
        if wrong.any():
            fail("{}: keypoint {} of {}, which has {}".format(name, rows[wrong.argmax(), side], names[side], len(points[side])))
    return rows


def _scores(get: _Get, rows: npt.NDArray[np.int64], count: int) -> Tuple[Optional[_Points], bool]:
    """Returns scores of the matches, and True if higher scores are better. `count` is the number of
    keypoints of image 1. If there are no scores, or if all scores are equal, None is returned in
    their place."""
    for name, higherIsBetter in SCORES:
        array = get(name)
        if array is None:
            continue
        array = np.ravel(array)
        if len(array) not in (len(rows), count):
            fail("{}: {} numbers for {} matches".format(name, len(array), len(rows)))
        # Keypoints without a match can have scores that are not finite.
        scores = _numbers(array if len(array) == len(rows) else array[rows[:, 0]], name, 0)
        return (scores if len(scores) and scores.min() < scores.max() else None), higherIsBetter
    return None, True


def pairOfArrays(key: Key, read: _Get, names: Tuple[str, str]) -> Pair:
    """Returns the pair of an NPZ file or of an HDF5 group. `read` returns an array by its name and
    is called at most once for each name. `names` are the names of the two images. Raises
    CollectionError if arrays are missing or invalid."""
    known: Dict[str, Optional[_Array]] = {}

    def get(name: str) -> Optional[_Array]:
        if name not in known:
            known[name] = read(name)
        return known[name]

    found = next((n for n in POINTS if get(n[0]) is not None and get(n[1]) is not None), None)
    if found is None:
        half = next((n for both in POINTS for n in both if get(n) is not None), None)
        fail("no " + " or ".join("{}, {}".format(*n) for n in POINTS[:3]) + ("" if half is None else ", only " + half))
    points = [_numbers(get(name), name, 2) for name in found]
    sizes, matrices = (None, None), _ofBoth(get, "K", _matrix)
    both = get("K")
    if matrices[0] is None and both is not None:
        matrices = (_matrix(both, "K"),) * 2
    for stem in SIZES:
        sizes = _ofBoth(get, stem, _size) if sizes[0] is None else sizes
    count, given = len(points[0]), next((n for n in MATCHES if found[0].startswith("keypoints") and get(n) is not None), None)
    if given is not None:
        rows = _rows(get(given), given, points, found)
        points = [points[side][rows[:, side]] for side in (0, 1)]
    else:
        if len(points[0]) != len(points[1]):
            fail("{} and {}: {} and {} points".format(found[0], found[1], len(points[0]), len(points[1])))
        rows = np.column_stack((np.arange(count), np.arange(count)))
    scores, higherIsBetter = _scores(get, rows, count)
    views = [_view(names[side], points[side], matrices[side], sizes[side]) for side in (0, 1)]
    return Pair(key, views[0], views[1], rows.astype(np.uint32), scores, higherIsBetter)


def pairOfNpz(key: Key, path: str) -> Pair:
    """Returns the pair of an NPZ file. Raises CollectionError if the file cannot be read or its
    arrays are invalid."""
    try:
        # The file is opened here, because numpy.load does not close a damaged file.
        with open(path, "rb") as file, np.load(file, allow_pickle=False) as arrays:
            if isinstance(arrays, np.ndarray):
                raise ValueError("one array only")
            return pairOfArrays(key, lambda name: arrays[name] if name in arrays.files else None, _sides(key))
    except UNREADABLE as error:
        fail(error.strerror if isinstance(error, OSError) and error.strerror else "no NPZ file, or a damaged one")


def _sides(key: Key) -> Tuple[str, str]:
    return "{} (1)".format(key), "{} (2)".format(key)


def _rowByRow(lines: List[str]) -> _Points:
    """Parses the lines of a .corr file. This is slower than numpy.loadtxt, but allows lines with and
    without a score in one file, and its error messages name the line."""
    rows: List[List[float]] = []
    for number, line in enumerate(lines, 1):
        try:
            row = [float(token) for token in line.split()]
        except ValueError:
            row = [0.0]
        if len(row) not in (0, 4, 5):
            fail("line {} of the .corr file: 'x1 y1 x2 y2 score' is expected".format(number))
        if row:
            rows.append(row if len(row) == 5 else row + [1.0])
    return np.array(rows, np.float64).reshape(-1, 5)


def _correspondences(path: str) -> _Points:
    """Returns the rows of a .corr file, each with a score; a missing score is 1."""
    try:
        with open(path, encoding="ascii") as file:
            text = file.read()
    except UnicodeDecodeError:
        fail("the .corr file is no text")
    except OSError as error:
        fail("the .corr file: {}".format(error.strerror))
    lines = text.splitlines()
    try:
        rows = np.loadtxt(lines, np.float64, comments=None, ndmin=2) if text.strip() else np.empty((0, 5))
    except ValueError:
        return _rowByRow(lines)
    return rows if rows.shape[1] == 5 else _rowByRow(lines)


def _description(path: str) -> Dict[str, Any]:
    """Returns the JSON object in `path`, the .json file next to a .corr file; an empty dictionary
    if there is no such file."""
    if not os.path.exists(path):
        return {}
    try:
        with open(path, encoding="utf-8") as text:
            description = json.load(text)
    except json.JSONDecodeError as error:
        fail("line {} of the .json file: {}".format(error.lineno, error.msg))
    except UnicodeDecodeError:
        fail("the .json file is no text")
    except OSError as error:
        fail("the .json file: {}".format(error.strerror))
    if not isinstance(description, dict):
        fail("the .json file: an object is expected")
    return description


def pairOfCorr(key: Key, path: str) -> Pair:
    """Returns the pair of a .corr file. Sizes and camera matrices come from the .json file next to
    it; doc/benchmark.md describes both files. Raises CollectionError if a file cannot be read or is
    invalid."""
    rows = _correspondences(path)
    wrong = ~np.isfinite(rows).all(axis=1)
    if wrong.any():
        fail("match {} of the .corr file is not finite".format(int(wrong.argmax())))
    description = _description(os.path.splitext(path)[0] + ".json")
    columns = {"points1": rows[:, 0:2], "points2": rows[:, 2:4], "ratios": rows[:, 4]}

    def get(name: str) -> Any:
        if name in columns:
            return columns[name]
        return description.get(name) if name in ("K1", "K2", "size1", "size2") else None

    try:
        return pairOfArrays(key, get, _sides(key))
    except CollectionError as error:
        fail("the .json file: {}".format(error))
