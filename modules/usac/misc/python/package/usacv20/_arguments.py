# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Checks arguments and converts them to the types that the C++ functions accept. An invalid argument
raises usacv20.error, whose message names the argument."""

from __future__ import annotations

import enum
import inspect
import operator
import typing
from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Tuple

import numpy as np

from ._errors import fail, warn

if TYPE_CHECKING:
    import numpy.typing as npt

Function = typing.TypeVar("Function", bound=typing.Callable[..., Any])
INT_MIN, INT_MAX = -2**31, 2**31 - 1
# The number types of arrays that C++ reads without a conversion, in native byte order.
_TAKEN = frozenset(np.dtype(kind) for kind in ("u1", "i1", "u2", "i2", "i4", "f4", "f8"))


def bind(function: str, names: typing.Sequence[str], required: int, defaults: typing.Mapping[str, Any], args: Tuple[Any, ...],
         kwargs: Dict[str, Any]) -> Dict[str, Any]:
    """Returns the arguments of a call by their names. Raises TypeError if an argument is missing, unknown or given twice, or
    if there are too many arguments."""
    if len(args) > len(names):
        raise TypeError("{}() takes at most {} arguments ({} given)".format(function, len(names), len(args)))
    values = dict(defaults)
    values.update(zip(names, args))
    for name, value in kwargs.items():
        if name not in names:
            raise TypeError("{}() got an unexpected keyword argument '{}'; it has {}".format(function, name, ", ".join(names)))
        if name in names[:len(args)]:
            raise TypeError("{}() got multiple values for argument '{}'".format(function, name))
        values[name] = value
    for name in names[:required]:
        if name not in values:
            raise TypeError("{}() missing required argument '{}'".format(function, name))
    return values


def signed(names: typing.Sequence[str], required: int, defaults: typing.Mapping[str, Any]) -> typing.Callable[[Function], Function]:
    """Returns a decorator for a function of (*args, **kwargs). The decorator sets the signature that
    help(), code completion and notebooks show: the given names, and `params` as a keyword-only
    argument."""
    kinds = inspect.Parameter
    parameters = [kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=kinds.empty if i < required else defaults.get(name))
                  for i, name in enumerate(names)]
    parameters.append(kinds("params", kinds.KEYWORD_ONLY, default=None))

    def mark(function: Function) -> Function:
        setattr(function, "__signature__", inspect.Signature(parameters))
        return function

    return mark


def shown(value: Any) -> str:
    """Returns a text for a message: type and shape of an array, or any other value in at most 60 characters."""
    if isinstance(value, np.ndarray):
        return "an array of {} with shape {}".format(value.dtype, value.shape)
    try:
        text = repr(value)
    except Exception:  # raised for integers of more than 4300 digits
        text = "a value of type " + type(value).__name__
    return text if len(text) <= 60 else text[:57] + "..."


def isReal(value: Any) -> bool:
    """Returns True for integers and floating-point numbers of Python and NumPy, and for 0-dimensional NumPy arrays of such a
    number. Returns False for bool."""
    if isinstance(value, (bool, np.bool_)):
        return False
    if isinstance(value, (int, float, np.integer, np.floating)):
        return True
    return isinstance(value, np.ndarray) and value.ndim == 0 and value.dtype.kind in "iuf"


def isInteger(value: Any) -> bool:
    """Does the same as isReal(), but for integers only."""
    return isReal(value) and not isinstance(value, (float, np.floating)) and getattr(value, "dtype", np.dtype(int)).kind in "iu"


def isOfAnother(value: Any, enumeration: type) -> bool:
    """Returns True if the value is an enumerator of an enumeration other than `enumeration`, in which its integer value has a
    different meaning or none."""
    return isinstance(value, enum.Enum) and not isinstance(value, enumeration)


def real(value: Any, name: str, default: Optional[float] = None) -> float:
    """Converts a number to float. None is replaced with the default, as in cv2, or is an error if there is no default."""
    if value is None and default is not None:
        return default
    if not isReal(value):
        raise fail("{}: a number is expected, not {}".format(name, shown(value)))
    try:
        return float(value)
    except OverflowError:  # an integer
        raise fail("{}: a number below 1.8e308 is expected, not {}".format(name, shown(value))) from None


def integer(value: Any, name: str, default: Optional[int] = None, low: int = INT_MIN, high: int = INT_MAX) -> int:
    """Converts an integer to int. Integers outside low .. high raise usacv20.error. None is replaced with the default, as in
    cv2, or is an error if there is no default."""
    if value is None and default is not None:
        return default
    if not isInteger(value):
        raise fail("{}: an integer is expected, not {}".format(name, shown(value)))
    number = operator.index(value)
    if not low <= number <= high:
        raise fail("{}: {} .. {} is expected, not {}".format(name, low, high, shown(number)))
    return number


def elements(value: Any, name: str, expected: str) -> typing.Iterator[Any]:
    """Returns an iterator over the elements of `value`. Raises usacv20.error if `value` is not
    iterable; `expected` describes the expected value in the message."""
    try:
        return iter(value)
    except TypeError:
        raise fail("{}: {} is expected, not {}".format(name, expected, shown(value))) from None


def refuseMasked(value: Any, name: str) -> None:
    """Raises usacv20.error for a numpy.ma array with masked elements, because a conversion would lose
    the mask."""
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise fail("{}: masked arrays are not accepted, because the mask would be lost: give only the unmasked rows, the same "
                   "rows of all arrays, or filled(numpy.nan); rows with NaN are never inliers".format(name))


def _converted(value: Any, name: str) -> npt.NDArray[Any]:
    if type(value).__name__ == "UMat":
        value = value.get()
    refuseMasked(value, name)
    try:
        given = np.asarray(value)
    except Exception as failure:  # for example, rows have different lengths, or __array__ raises an exception
        raise fail("{}: an array of numbers is expected ({})".format(name, failure)) from failure
    kind = given.dtype.kind
    if value is None or kind not in "biuf":
        raise fail("{}: an array of numbers is expected, not {}".format(name, shown(value)))
    if given.ndim == 0:
        raise fail("{}: an array is expected, not the number {}".format(name, shown(value)))
    if kind == "b":
        return given.astype(np.uint8)
    native = given.dtype.newbyteorder("=")
    # float16 becomes float32; uint32, 64-bit integers (exact up to 2**53) and long double become
    # float64.
    if native not in _TAKEN:
        native = np.dtype(np.float32 if native == np.float16 else np.float64)
    return np.require(given, native, "A")


def array(value: Any, name: str) -> npt.NDArray[Any]:
    """Returns an array that C++ can read: `value` itself if it is an aligned array of a supported
    number type, with any strides, otherwise a converted copy."""
    if type(value) is np.ndarray and value.dtype in _TAKEN and value.ndim > 0 and value.flags.aligned:
        given = value
    else:
        given = _converted(value, name)
    if max(given.shape) > INT_MAX:
        raise fail("{}: at most {} rows and columns are expected, not the shape {}".format(name, INT_MAX, given.shape))
    return given


def optionalArray(value: Any, name: str) -> Optional[npt.NDArray[Any]]:
    """Does the same as array(), but returns None for None."""
    return None if value is None else array(value, name)


def isList(given: npt.NDArray[Any]) -> bool:
    """Returns True for a one-dimensional array, a row, a column, and an empty array."""
    return given.size == 0 or sum(side != 1 for side in given.shape) <= 1


_MODELS = {6: (2, 3), 9: (3, 3), 12: (3, 4)}  # number of entries of the models of this module: their shape


def checkModelShape(given: npt.NDArray[Any], name: str, kind: Callable[[str], Exception] = fail) -> None:
    """Raises an exception, made by `kind`, if a matrix has as many numbers as some model of this module, but another shape, such
    as that of a transposed matrix. Rows, columns and one-dimensional arrays are accepted. Other numbers of entries are refused
    later, when the model is used."""
    shape = _MODELS.get(given.size)
    if shape is not None and given.shape != shape and not isList(given):
        raise kind("{}: a {}x{} matrix, or a row or a column, is expected for {} numbers, not the shape {}".format(
            name, *shape, given.size, given.shape))


def checkSquare(given: npt.NDArray[Any], name: str, kind: Callable[[str], Exception] = fail) -> None:
    """Raises an exception, made by `kind`, if a matrix that is not empty is not square."""
    if given.size > 0 and (given.ndim != 2 or given.shape[0] != given.shape[1]):
        raise kind("{}: a square matrix is expected, not the shape {}".format(name, given.shape))


def _three(given: npt.NDArray[Any]) -> Optional[npt.NDArray[Any]]:
    """Returns 2-D points as rows of three homogeneous coordinates, in the way in which C++
    interprets the shape of the array. Returns None if C++ does not interpret the points as
    homogeneous."""
    if given.ndim == 3:
        return given.reshape(-1, 3) if given.shape[2] == 3 else None
    if given.ndim == 1:
        return given[None] if len(given) == 3 else None
    if given.ndim != 2:
        return None
    rows, cols = given.shape
    if cols == 1 or 1 < rows < cols:
        return given.T if rows == 3 else None
    return given if cols == 3 else None


def count(given: npt.NDArray[Any], plane: bool = True) -> int:
    """Returns the number of 2-D points (if `plane` is true) or 3-D points, in the way in which C++ interprets the shape of the
    array. C++ refuses some shapes; the result is then meaningless."""
    if given.size == 0:
        return 0
    if given.ndim == 3 and given.shape[2] > 1:
        return int(given.shape[0] * given.shape[1])
    rows, cols = (*given.shape, 1)[:2]
    perColumn = cols == 1 or 1 < rows < cols if plane else rows == 3 and cols != 3
    return int(cols if perColumn else rows)


# Constants of _looksLikeColumn, where w is the third column:
# _ROWS -- minimum number of rows
# _MOST_ROWS -- if there are more rows, only every k-th row is examined, where k is their number
# divided by _MOST_ROWS, rounded down
# _SURE -- number of standard errors that are added to the slope of the regression
# _INDEPENDENT -- w is regarded as independent only if slope + _SURE standard errors is below this limit
# _EXPLAINED -- fraction of the variance of w: if a linear function of the first two columns
# explains at least this fraction, w is regarded as such a function
#
# With these values, columns of feature sizes (1.6 times powers of 2) are recognized in 1, 60 and 100
# of 100 lists that have 60, 200 and 1000 rows, respectively. Third coordinates of homogeneous points
# are not mistaken for such columns, except in 5 % of the lists from cameras whose principal point is
# in an image corner. With half and twice the value of _ROWS or _MOST_ROWS, and with _EXPLAINED 0.8
# and 0.95, the results are the same, except that with twice the value of _ROWS, lists of 60 rows are
# too short. With half the value of _SURE, 50 of 100 lists of 60 rows are recognized, and 67 % of the
# lists from these cameras are mistaken for such columns; with twice the value, 0 and 0 %. With
# _INDEPENDENT 0.25, 80 of 100 lists of 1000 rows are recognized, and 0 % of the lists from these
# cameras are mistaken for such columns; with _INDEPENDENT 0.75, 100 and 55 %.
_ROWS, _MOST_ROWS, _SURE, _INDEPENDENT, _EXPLAINED = 50, 1000, 4.0, 0.5, 0.9


def _looksLikeColumn(rows: npt.NDArray[Any]) -> bool:
    """Returns True if the third column w looks statistically independent of the first two columns, as
    the size of a feature is. Returns False if there are too few rows, if a number is negative, or if
    a number of the third column is 0.

    Homogeneous coordinates (w x, w y, w) are larger for larger w: the regression of log(w x) on
    log(w) has slope 1 if w is independent of the image coordinate x, for example if w is a depth.
    For points under a projective map, w is a linear function of the first two columns. No criterion
    is certain: for homogeneous points of a box seen by a camera whose principal point is in a corner
    of the image, w looks independent of w x and w y, too."""
    some = np.asarray(rows[::max(len(rows) // _MOST_ROWS, 1)], np.float64)
    some = some[np.isfinite(some).all(1)]
    if len(some) < _ROWS or some.min() < 0 or some[:, 2].min() <= 0:
        return False
    some = some[(some > 0).all(1)]
    if len(some) < _ROWS:
        return False
    some /= some.max(0)  # prevents overflow of squares
    centered = some - some.mean(0)
    w = centered[:, 2]
    solution = np.linalg.lstsq(centered[:, :2], w, rcond=None)[0]
    if np.square(w - centered[:, :2] @ solution).sum() <= (1 - _EXPLAINED) * np.square(w).sum():
        return False  # w is a linear function of the first two columns, or constant
    logs = np.log(some)
    logs -= logs.mean(0)
    spread = np.square(logs[:, 2]).sum()
    for k in range(2):
        slope = logs[:, k] @ logs[:, 2] / spread
        error = np.sqrt(np.square(logs[:, k] - slope * logs[:, 2]).sum() / spread / (len(some) - 2))
        if not slope + _SURE * error < _INDEPENDENT:
            return False
    return True


def points(value: Any, name: str, plane: bool = True) -> npt.NDArray[Any]:
    """Converts a list of 2-D points (if `plane` is true) or 3-D points like array(). Raises
    usacv20.error for an array of several lists. A third column of 2-D points is a homogeneous
    coordinate, by which C++ divides: usacv20.error is raised if the column looks like confidences
    (0..1, not all 1), and a warning is given if it looks like sizes of features."""
    given = array(value, name)
    if given.ndim == 3 and min(given.shape[0], given.shape[1]) > 1 and given.shape[2] > 1:
        raise fail("{}: one list of points is expected, Nx{k} or Nx1x{k}, not the shape {}; for the lists of many pairs there "
                   "are estimateHomographies and similar functions".format(name, given.shape, k=2 if plane else 3))
    rows = _three(given) if plane and given.size else None
    if rows is not None and np.isfinite(rows[:, 2]).any():
        third = rows[:, 2]
        known = third[np.isfinite(third)]
        if known.min() >= 0 and known.max() <= 1 and known.min() < 1:
            raise fail("{}: the third coordinate is homogeneous (x and y are divided by it), but its values from {:g} to {:g} "
                       "look like a confidence: give x and y alone, points[:, :2], and the confidences as Params.scores; divide "
                       "homogeneous points by their third coordinate first".format(
                           name, known.min(), known.max()))
        if _looksLikeColumn(rows):
            warn("{}: the third coordinate is homogeneous (x and y are divided by it), but looks independent of x and "
                 "y: if it is the size or a score of a feature, give x and y alone, points[:, :2]".format(name))
    return given


def checkOutput(given: Any, name: str) -> None:
    """Raises usacv20.error unless `given` is None, a UMat (which is ignored), or an array that a result can be written to."""
    if given is None or type(given).__name__ == "UMat":
        return
    if not isinstance(given, np.ndarray):
        raise fail("{}: an array that receives the result is expected, or None, not {}".format(name, shown(given)))
    if not given.flags.writeable:
        raise fail("{}: the array must receive the result, but it is read-only".format(name))


def checkMask(given: Any, name: str) -> None:
    """Does the same as checkOutput() for a mask, and raises usacv20.error for an array of a type other than uint8 and bool."""
    checkOutput(given, name)
    if isinstance(given, np.ndarray) and given.dtype not in (np.uint8, np.bool_):
        raise fail("{}: an array of uint8 or bool is expected for the mask, not of {}".format(name, given.dtype))


def outputMask(given: Any, mask: Any, name: str) -> Any:
    """Writes a mask, or None if there are no points, to the caller's array like output(). Raises
    usacv20.error if this array, unless it is empty, has another shape than Nx1 or N."""
    if mask is None:
        return np.empty((0, 1), np.uint8)
    if isinstance(given, np.ndarray) and given.size > 0 and given.shape not in (mask.shape, mask.shape[:1]):
        raise fail("{}: an array of the shape ({}, 1) is expected for the mask, not {}".format(name, len(mask), given.shape))
    return output(given, mask)


def output(given: Any, result: Any) -> Any:
    """Writes the result to the caller's array and returns this array if its type and size fit, as
    in cv2; otherwise, or if the array is read-only, returns the result. The caller's array for a mask,
    which is the only result of type uint8, can also have the type bool."""
    if result is None or not isinstance(given, np.ndarray):
        return result
    if given.dtype != result.dtype and not (given.dtype == np.bool_ and result.dtype == np.uint8):
        return result
    if not given.flags.writeable:  # possible for initial values only: checkOutput() refuses other read-only arrays
        return result
    if given.shape != result.shape and given.shape != result.shape[:1]:
        return result
    given[...] = result.reshape(given.shape)
    return given
