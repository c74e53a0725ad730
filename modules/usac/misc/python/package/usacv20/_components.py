# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""A search whose sampler or score is written in Python."""

from __future__ import annotations

import abc
import typing
import weakref
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from . import _arguments
from ._arguments import integer, optionalArray
from ._backend import native
from ._enumerations import ProblemType
from ._errors import fail
from ._estimate import countOf, pointsAndOptions, pointsOf
from ._params import Params, checkRows, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Estimate, _Mask

Rng = native.Rng


class Correspondences(typing.NamedTuple):
    """The points that the components receive: only points with finite coordinates, in a fixed
    pseudo-random order, and in the coordinates of the search. For E, the points are on the
    normalized image plane; for H and F, they are shifted and scaled to about unit size."""

    data: npt.NDArray[np.float64]  #: N x number of columns; for two views, the columns are x1, y1, x2, y2
    inputIndex: npt.NDArray[np.int32]  #: N, row of each point in the caller's arrays
    scores: Optional[npt.NDArray[np.float32]]  #: N, Params.scores in the order of these points; None: no scores
    threshold: float  #: threshold of the search in the unit of `data`, not squared; initially Params.threshold times Params.reach
    sampleSize: int  #: number of points in a minimal sample


class _Component(abc.ABC):
    def start(self, points: Correspondences) -> None:
        """Called at the beginning of each run with the points of the search. If there are more than
        32768 points, the search uses only some of them, and start() is called again, with all
        points, before the final polishing. The arrays are copies, so that a component can keep them.
        The default implementation does nothing."""

    def _begin(self, *points: Any) -> None:
        self.start(Correspondences(*points))


class Sampler(_Component):
    """Base class of samplers, which draw the minimal samples.

    One thread calls sample() once for each sample. A call has an overhead of about a microsecond:
    5000 samples for a fundamental matrix from 1000 matches take 10 milliseconds with the sampler
    below, and 5 milliseconds with the uniform sampler of C++.

    >>> import numpy as np, usacv20
    >>> class Uniform(usacv20.Sampler):
    ...     def start(self, points):
    ...         self.points = points
    ...     def sample(self, rng, iteration):
    ...         return rng.distinct(len(self.points.data), self.points.sampleSize)
    >>> points1 = np.random.RandomState(1).uniform(0, 640, (100, 2))
    >>> points2 = points1 @ np.array([[0.9, -0.1], [0.1, 0.9]]) + [5, 8]
    >>> points2[:50] = points1[:50] + 100 * np.random.RandomState(2).normal(size=(50, 2))
    >>> usac = usacv20.Usac.create(usacv20.SIMILARITY, points1, points2)
    >>> usac.components.sampler = Uniform()
    >>> model, mask, report = usac.run()
    >>> np.round(model, 6).tolist(), int(mask[50:].sum())
    ([[0.9, 0.1, 5.0], [-0.1, 0.9, 8.0]], 50)
    """

    #: True: the termination criteria count the last sample like one drawn uniformly from all
    #: points. Set this attribute to False for samples from a subset of the points, because such
    #: samples might never consist of inliers of the best model. sample() can set it for each sample.
    counts: bool = True

    @abc.abstractmethod
    def sample(self, rng: native.Rng, iteration: int) -> typing.Sequence[int]:
        """Draws a sample.

        rng -- random number generator of this iteration; the same Params.seed gives the same
        numbers
        iteration -- number of samples drawn before this one

        Returns Correspondences.sampleSize distinct row indices of Correspondences.data."""


class Score(_Component):
    """Base class of scores, which convert the errors of points to costs.

    accumulate() is called for each block of points of each model. Params.threads threads call it,
    but only one of them at a time, because of the global interpreter lock. A call of the score
    below, which uses NumPy, takes about 10 microseconds: the estimation of a homography from 1000
    matches takes 14 times as long as with the score of C++, and the estimation of a fundamental
    matrix 12 times as long. If `wholeModel` is True, so that there is one call for each model, both
    estimations take 3 to 4 times as long as with the score of C++.

    >>> import numpy as np, usacv20
    >>> class Truncated(usacv20.Score):  # the cost of MSAC
    ...     def accumulate(self, squaredErrors, squaredThreshold):
    ...         ratios = squaredErrors / squaredThreshold
    ...         inliers = ratios <= 1
    ...         return float(np.where(inliers, ratios, 1).sum()), int(inliers.sum())
    >>> points1 = np.random.RandomState(1).uniform(0, 640, (100, 2))
    >>> points2 = points1 * 2 + [5, 8]
    >>> points2[:50] = points1[:50] + 100 * np.random.RandomState(2).normal(size=(50, 2))
    >>> usac = usacv20.Usac.create(usacv20.HOMOGRAPHY, points1, points2)
    >>> usac.components.score = Truncated()
    >>> model, mask, report = usac.run()
    >>> int(mask[50:].sum()), bool(np.allclose(model, [[2, 0, 5], [0, 2, 8], [0, 0, 1]], atol=1e-6))
    (50, True)
    """

    #: True: the cost is not a sum over the points (for example, it is a median), so accumulate() is
    #: called once for each model, with all points. False: it is called for blocks of points.
    wholeModel: bool = False

    #: accumulate() counts a point as an inlier if its error is at most this fraction of the
    #: threshold; above 0 and at most 1. Points with larger errors only add to the cost.
    inlierPart: float = 1.0

    @abc.abstractmethod
    def accumulate(self, squaredErrors: npt.NDArray[np.float32], squaredThreshold: float) -> Tuple[float, int]:
        """Returns the cost and the number of inliers of a block of points.

        squaredErrors -- array of float32, a copy; points with NaN or infinite errors are outliers
        squaredThreshold -- squared threshold, in the unit of squaredErrors

        Returns (cost, inliers): the sum of the costs of the points, each between 0 (perfect) and 1
        (outlier), and the number of inliers."""


def _weak(component: Optional[_Component]) -> Any:
    """Returns a weak proxy, which the compiled part keeps and Components keeps alive, or None for
    None. The garbage collector cannot see references of the compiled part: with a strong one, a
    component that refers back to its Usac would keep both alive forever."""
    return None if component is None else weakref.proxy(component)


def _noComponent(name: str) -> str:
    return "components.{}: Python can replace components.sampler and components.score; {}".format(
        name, "the others can be replaced in C++ only (samples/custom_residual.cpp); Params selects among the existing ones")


def _notCopied(value: Any) -> TypeError:
    return TypeError("{}: it cannot be copied or pickled, because it belongs to one estimation; create another with "
                     "Usac.create()".format(type(value).__name__))


class Components:
    """The components of an estimator that can be replaced; None means the component that Params
    selects.

    Python code can replace two components: `sampler` with a Sampler, and `score` with a Score. The
    other components and the problem can be replaced in C++ only."""

    __slots__ = ("_usac", "_sampler", "_score", "__weakref__")

    if not TYPE_CHECKING:  # without this test, type checkers would accept any attribute

        def __setattr__(self, name: str, value: Any) -> None:
            if not hasattr(type(self), name):
                raise AttributeError(_noComponent(name))
            super().__setattr__(name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(_noComponent(name))

    def __reduce_ex__(self, protocol: typing.SupportsIndex) -> typing.NoReturn:
        raise _notCopied(self)

    def __init__(self, usac: native.Usac) -> None:
        self._usac = usac
        self._sampler: Optional[Sampler] = None
        self._score: Optional[Score] = None

    @property
    def sampler(self) -> Optional[Sampler]:
        """The Sampler that draws the minimal samples. None: the sampler that Params selects."""
        return self._sampler

    @sampler.setter
    def sampler(self, value: Optional[Sampler]) -> None:
        if value is not None and not isinstance(value, Sampler):
            raise fail("sampler: an object of a subclass of usacv20.Sampler is expected, not {}".format(_arguments.shown(value)))
        self._usac.setSampler(_weak(value))
        self._sampler = value

    @property
    def score(self) -> Optional[Score]:
        """The Score that converts errors to costs. None: the score that Params selects."""
        return self._score

    @score.setter
    def score(self, value: Optional[Score]) -> None:
        if value is not None and not isinstance(value, Score):
            raise fail("score: an object of a subclass of usacv20.Score is expected, not {}".format(_arguments.shown(value)))
        if value is not None:
            _arguments.real(value.inlierPart, "score.inlierPart")
        self._usac.setScore(_weak(value))
        self._score = value


class Usac:
    """One estimation with its points, options and components; created by Usac.create()."""

    __slots__ = ("_usac", "_problem", "_components", "_params", "_count", "__weakref__")

    if not TYPE_CHECKING:  # without this test, type checkers would accept any attribute

        def __setattr__(self, name: str, value: Any) -> None:
            if not hasattr(type(self), name):
                where = "components.{}".format(name) if name in ("sampler", "score") else "components or params"
                raise AttributeError("Usac.{}: there is no such attribute; did you mean {}?".format(name, where))
            super().__setattr__(name, value)

    def __reduce_ex__(self, protocol: typing.SupportsIndex) -> typing.NoReturn:
        raise _notCopied(self)

    def __init__(self, usac: native.Usac, problem: int, params: Optional[Params], count: int) -> None:
        self._count = count  # number of points
        self._usac = usac
        self._problem = problem
        self._components = Components(usac)
        self._params = (Params() if params is None else params.replace())._fix()

    @classmethod
    def create(cls, problem: int, points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
               cameraMatrix1: Optional[npt.ArrayLike] = None, cameraMatrix2: Optional[npt.ArrayLike] = None,
               distCoeffs1: Optional[npt.ArrayLike] = None, distCoeffs2: Optional[npt.ArrayLike] = None) -> Usac:
        """Reads the points and creates the components that `params` selects.

        problem -- ProblemType
        points1, points2 -- N points each, in the layouts that the function estimate* of the problem
        accepts
        params -- Params; None: the defaults
        cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 -- for ESSENTIAL, as in
        estimateEssential; ABSOLUTE_POSE uses cameraMatrix1 and distCoeffs1"""
        if _arguments.isOfAnother(problem, ProblemType):
            raise fail("problem: a ProblemType is expected, not {!r}".format(problem))
        number = integer(problem, "problem", None, 0, len(ProblemType) - 1)
        given = pointsAndOptions(number, points1, points2, params)
        usac = native.Usac(
            number, *given, optionalArray(cameraMatrix1, "cameraMatrix1"), optionalArray(cameraMatrix2, "cameraMatrix2"),
            optionalArray(distCoeffs1, "distCoeffs1"), optionalArray(distCoeffs2, "distCoeffs2"))
        return cls(usac, number, params, countOf(number, given[0]))

    @property
    def components(self) -> Components:
        """The components that can be replaced before run(): components.sampler, components.score.
        """
        return self._components

    @property
    def params(self) -> Params:
        """A read-only copy of the options. Assign other options to this property before the next
        run: usac.params = usac.params.replace(threshold=2). Replaced components are kept. If a value is
        invalid, an exception is raised and nothing changes."""
        return self._params

    @params.setter
    def params(self, value: Params) -> None:
        self._renew(None, None, value, self._count)

    def _renew(self, points1: Any, points2: Any, params: Params, count: int) -> None:
        if not isinstance(params, Params):
            raise fail("params: a usacv20.Params is expected, not {}".format(_arguments.shown(params)))
        self._usac.renew(points1, points2, optionsOf(params, count=count))
        self._params, self._count = params.replace()._fix(), count

    def setScores(self, scores: Optional[npt.ArrayLike]) -> None:
        """Replaces Params.scores for the next run.

        scores -- one score for each point; None: no scores"""
        self._renew(None, None, self._params.replace(scores=scores), self._count)

    @property
    def points(self) -> Correspondences:
        """Copies of the points that the components receive."""
        return Correspondences(*self._usac.points())

    def setPoints(self, points1: npt.ArrayLike, points2: npt.ArrayLike, scores: Optional[npt.ArrayLike] = None) -> None:
        """Sets other points for the next run; their number N can differ from the previous one.
        Allocated memory is reused, unless scores are given.

        points1, points2 -- as in create()
        scores -- N new Params.scores; None: the previous scores, if any, are kept, and their number
        must be N"""
        given = pointsOf(self._problem, points1, points2)
        count = countOf(self._problem, given[0])
        if scores is None:
            checkRows(self._params, count)
            self._usac.setPoints(*given)
            self._count = count
        else:
            self._renew(*given, self._params.replace(scores=scores), count)

    def run(self, mask: _Mask = None) -> _Estimate:
        """Runs the estimation. Repeated calls return the same result. An exception in a component
        ends the run and is passed on to the caller.

        mask -- Nx1 array of uint8 or bool that receives the mask, or None

        Returns (model, mask, report) like the function estimate* of the problem."""
        _arguments.checkMask(mask, "mask")
        model, inliers, report = self._usac.run()
        return model, _arguments.outputMask(mask, inliers, "mask"), Report._ofCall(report)


for _class in (Correspondences, Sampler, Score, Components, Usac):
    _class.__module__ = __name__.rpartition(".")[0]
del _class
