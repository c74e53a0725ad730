# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs one estimation of any problem, with all options and a report; used by the functions in _problems.py."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

import numpy as np

from . import _arguments
from ._backend import native
from ._enumerations import ARGUMENTS, ProblemType
from ._errors import calling, fail
from ._params import Params, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    _Estimate = Tuple[Optional[npt.NDArray[np.float64]], npt.NDArray[np.uint8], Report]
    _Mask = Optional[npt.NDArray[np.uint8]]

NO_POINTS = np.empty((0, 1), np.uint8)
NAMES = ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2")  # the names of the C++ arguments


#: For each value of ARGUMENTS, whether the points of the first and of the second array are 2-D
#: points.
_IN_PLANE = {"IMAGES": (True, True), "CAMERAS": (True, True), "POSE": (False, True), "SPACES": (False, False)}
POSE = ("objectPoints", "imagePoints", "cameraMatrix", "", "distCoeffs", "")  # used instead of NAMES for absolute poses


def inPlane(problem: int) -> Tuple[bool, bool]:
    """Returns whether the points of the first and of the second array are 2-D points."""
    return _IN_PLANE[ARGUMENTS[problem]]


def pointsOf(problem: int, points1: Any, points2: Any, names: Tuple[str, ...] = NAMES
             ) -> Tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    """Converts the points of both arrays like _arguments.points(). `names` are the caller's names of
    the arguments, for messages."""
    plane1, plane2 = inPlane(problem)
    return _arguments.points(points1, names[0], plane1), _arguments.points(points2, names[1], plane2)


def countOf(problem: int, points1: npt.NDArray[Any]) -> int:
    """Returns the number of points in the first array of a problem, from pointsOf()."""
    return _arguments.count(points1, inPlane(problem)[0])


def pointsAndOptions(problem: int, points1: Any, points2: Any, params: Any, names: Tuple[str, ...] = NAMES
                     ) -> Tuple[npt.NDArray[Any], npt.NDArray[Any], Any]:
    """Does the same as pointsOf(), and adds the options as an object of the compiled part. Raises
    usacv20.error if params.sigmas have rows for another number of points."""
    given = pointsOf(problem, points1, points2, names)
    return (*given, optionsOf(params, count=countOf(problem, given[0])))


def problemOf(problem: Union[int, str]) -> int:
    """Returns the integer value of a ProblemType that is given as an enumerator, an integer or a
    name. Raises usacv20.error for anything else."""
    if isinstance(problem, str) and problem.upper() in ProblemType.__members__:
        return int(ProblemType[problem.upper()])
    known = _arguments.isInteger(problem) and not _arguments.isOfAnother(problem, ProblemType)
    if not known or not 0 <= int(problem) < len(ProblemType):
        raise fail("problem: a ProblemType is expected, {}, not {}".format(", ".join(ProblemType.__members__),
                                                                           _arguments.shown(problem)))
    return int(problem)


def estimate(problem: int, points1: Any, points2: Any, params: Any, mask: Any, cameraMatrix1: Any = None,
             cameraMatrix2: Any = None, distCoeffs1: Any = None, distCoeffs2: Any = None,
             names: Tuple[str, ...] = NAMES, maskName: str = "mask") -> _Estimate:
    """Estimates a model of any problem. `names` and `maskName` are the caller's names of the array
    arguments and of the mask, for messages."""
    _arguments.checkMask(mask, maskName)
    model, inliers, report = calling(
        dict(zip(NAMES, names)), native.estimate, problem, *pointsAndOptions(problem, points1, points2, params, names),
        _arguments.optionalArray(cameraMatrix1, names[2]), _arguments.optionalArray(cameraMatrix2, names[3]),
        _arguments.optionalArray(distCoeffs1, names[4]), _arguments.optionalArray(distCoeffs2, names[5]))
    return model, _arguments.outputMask(mask, inliers, maskName), Report._ofCall(report)


def oneOrTwoCameras(cameraMatrix2: Any, distCoeffs1: Any, distCoeffs2: Any, params: Any, mask: Any) -> Tuple[Any, Any, Any, Any]:
    """Converts the arguments of the form (..., cameraMatrix, params, mask), in which both images
    have the same camera, to those of the form with two cameras; arguments of the latter form are
    not changed. Returns cameraMatrix2, distCoeffs1, params, mask."""
    if not isinstance(cameraMatrix2, Params):
        return cameraMatrix2, distCoeffs1, params, mask
    if params is not None or distCoeffs2 is not None or (mask is not None and distCoeffs1 is not None):
        raise fail("cameraMatrix2: a 3x3 matrix is expected, not a Params, beside other arguments")
    return None, None, cameraMatrix2, distCoeffs1 if mask is None else mask


def estimateModel(problem: Union[int, str], points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
                  mask: _Mask = None, cameraMatrix1: Optional[npt.ArrayLike] = None, cameraMatrix2: Optional[npt.ArrayLike] = None,
                  distCoeffs1: Optional[npt.ArrayLike] = None, distCoeffs2: Optional[npt.ArrayLike] = None) -> _Estimate:
    """Estimates a model of any kind, like estimateHomography and similar functions, for a program
    that chooses the problem only at run time.

    problem -- ProblemType, or its name as a string
    points1, points2 -- N points each, in the layouts that the function estimate* of the problem
    accepts; ABSOLUTE_POSE: objectPoints and imagePoints
    params, mask -- as in the function estimate* of the problem
    cameraMatrix1, distCoeffs1 -- for ESSENTIAL and ABSOLUTE_POSE
    cameraMatrix2, distCoeffs2 -- for ESSENTIAL; None: the same as cameraMatrix1, and no distortion

    Returns (model, mask, report), the same results as from the function estimate* of the problem.
    """
    return estimate(problemOf(problem), points1, points2, params, mask, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)
