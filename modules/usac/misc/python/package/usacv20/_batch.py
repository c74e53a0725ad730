# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs many estimations in one call, in parallel in C++; used by the functions in _problems.py."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _arguments
from ._backend import native
from ._errors import fail, inWordsOf
from ._estimate import NAMES, NO_POINTS, countOf, inPlane
from ._params import Params, checkRows, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Estimate

    _Estimates = List[Union[_Estimate, Exception]]
    _Lists = typing.Iterable[npt.ArrayLike]
    _ParamsOfEach = Union[Params, typing.Sequence[Optional[Params]], None]
    _Arrays = Union[npt.ArrayLike, typing.Sequence[Optional[npt.ArrayLike]], None]

_ARRAYS = ("points1", "points2", "cameraMatrices1", "cameraMatrices2", "distCoeffs1", "distCoeffs2")
POSES = ("objectPoints", "imagePoints", "cameraMatrices", "", "distCoeffs", "")  # used instead of _ARRAYS for absolute poses


class _Mistakes:
    """Collects exceptions, with the index of the task that raised each. If `kept` is false, the first
    exception is raised at once."""

    def __init__(self, kept: bool) -> None:
        self.kept = kept
        self.found: Dict[int, Exception] = {}

    def guard(self, task: int, make: typing.Callable[[], Any], instead: Any) -> Any:
        """Returns the result of make(), or `instead` if make() raises an exception that is
        collected."""
        try:
            return make()
        except Exception as mistake:
            if not self.kept:
                raise
            self.found.setdefault(task, mistake)
            return instead


def _dimensions(value: Any) -> int:
    """Returns the number of dimensions of a value. The number is 2 for a list of lists of different
    lengths, which cannot be converted to an array; the later conversion then raises an exception that
    names the argument."""
    try:
        return int(np.ndim(value))
    except ValueError:
        return 2


def _oneOrEach(given: Any, name: str, count: int) -> List[Any]:
    """Returns a list of arrays with one entry for each task, or with a single entry for all tasks;
    the list is empty if `given` is None. `given` is a list of arrays, a 3-dimensional array, or a
    single array, which can also be a list of numbers or of rows of numbers. Raises usacv20.error
    if the number of arrays is neither 1 nor the number of tasks."""
    if given is None:
        return []
    isList = isinstance(given, (list, tuple)) and any(item is None or _dimensions(item) >= 1 for item in given)
    if isList and all(isinstance(item, (list, tuple)) and all(_dimensions(number) == 0 for number in item) for item in given):
        isList = name.startswith("dist")  # a list of lists is one camera matrix, but several arrays of distortion coefficients
    if isinstance(given, np.ndarray):
        isList = given.ndim == 3
    entries = list(given) if isList else [given]
    if len(entries) not in (1, count):
        raise fail("{}: 1 or {} arrays are expected, not {}".format(name, count, len(entries)))
    return entries


def _arrays(given: List[Any], name: str, mistakes: _Mistakes) -> List[Any]:
    take = _arguments.optionalArray
    if len(given) == 1:  # an error in an array that all tasks share is raised at once
        return [take(given[0], name)]
    return [mistakes.guard(i, lambda: take(entry, "{}[{}]".format(name, i)), NO_POINTS)  # noqa: B023, called at once
            for i, entry in enumerate(given)]


def _lists(given: Any, name: str) -> List[Any]:
    """Returns a list with the points of each task. Raises usacv20.error if `given` has the shape of
    the points of a single pair."""
    if isinstance(given, np.ndarray) and given.dtype != object:
        _arguments.refuseMasked(given, name)
        onePair = given.ndim != 3 or (given.shape[1] == 1 and given.shape[0] > 1)
    else:
        given = list(_arguments.elements(given, name, "a list with the points of each pair"))
        onePair = any(_dimensions(point) == 0 and np.size(point) == 1 for entry in given[:1] for point in _some(entry))
    if onePair:
        raise fail("{}: a list with the points of each pair is expected; for a single pair, as here, there are "
                   "estimateHomography and similar functions".format(name))
    return list(given)


def _some(entry: Any) -> List[Any]:
    """Returns a list with the first row of an entry; an empty list if there is none."""
    return list(entry[:1]) if isinstance(entry, (list, tuple)) or (isinstance(entry, np.ndarray) and entry.ndim > 0) else []


def _pointsOf(given: List[Any], name: str, plane: bool, mistakes: _Mistakes) -> List[Any]:
    return [mistakes.guard(i, lambda: _arguments.points(entry, "{}[{}]".format(name, i), plane), NO_POINTS)  # noqa: B023
            for i, entry in enumerate(given)]


def _withRows(problem: int, points1: List[Any], params: List[Optional[Params]], name: str, mistakes: _Mistakes) -> List[Any]:
    """Returns `points1`. A task for which params.sigmas have rows for another number of points raises
    usacv20.error or, if exceptions are collected, gets no points."""
    def check(i: int, given: Any) -> Any:
        checkRows(params[i if len(params) > 1 else 0], countOf(problem, given), "{}[{}]: ".format(name, i))
        return given

    return [mistakes.guard(i, lambda: check(i, given), NO_POINTS) for i, given in enumerate(points1)]  # noqa: B023


def estimateMany(problem: int, points1: _Lists, points2: _Lists, params: _ParamsOfEach, threads: int, returnExceptions: bool,
                 cameraMatrices1: _Arrays = None, cameraMatrices2: _Arrays = None, distCoeffs1: _Arrays = None,
                 distCoeffs2: _Arrays = None, names: Tuple[str, ...] = _ARRAYS) -> _Estimates:
    """Estimates a model of the same problem for each entry of the lists. `names` are the caller's
    names of the six array arguments, for messages."""
    first, second = _lists(points1, names[0]), _lists(points2, names[1])
    count = len(first)
    if len(second) != count:
        raise fail("{} and {}: lists of the same length are expected, not of {} and {}".format(names[0], names[1], count,
                                                                                              len(second)))
    options = [params] if params is None or isinstance(params, Params) else list(_arguments.elements(
        params, "params", "a {}.Params, or a list with one for each task,".format(Params.__module__)))
    if len(options) not in (1, count):
        raise fail("params: one for all tasks or one for each of the {} tasks is expected, not {}".format(count, len(options)))
    prepared = [optionsOf(given, "params" if len(options) == 1 else "params[{}]".format(i)) for i, given in enumerate(options)]
    mistakes = _Mistakes(returnExceptions)
    camera1, camera2, lens1, lens2 = (
        _arrays(_oneOrEach(given, name, count), name, mistakes)
        for given, name in zip((cameraMatrices1, cameraMatrices2, distCoeffs1, distCoeffs2), names[2:]))
    plane1, plane2 = inPlane(problem)
    first = _withRows(problem, _pointsOf(first, names[0], plane1, mistakes), options, names[0], mistakes)
    found = native.estimateBatch(problem, first, _pointsOf(second, names[1], plane2, mistakes), prepared, camera1, camera2, lens1,
                                 lens2, _arguments.integer(threads, "threads", low=0))
    words = dict(zip(NAMES, names))
    results: _Estimates = []
    for i, (model, mask, report, wrong) in enumerate(found):
        mistake = mistakes.found.get(i) or (fail("{}[{}]: {}".format(names[0], i, inWordsOf(words, wrong))) if wrong else None)
        if mistake is None:
            results.append((model, NO_POINTS.copy() if mask is None else mask, Report._ofCall(report)))
        elif returnExceptions:
            results.append(mistake)
        else:
            raise mistake
    return results
