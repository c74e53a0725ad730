# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Components written in Python: a sampler or a score of one's own in the search that the package runs."""

from __future__ import annotations

import abc
import typing
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from . import _arguments
from ._arguments import integer, optionalArray
from ._backend import native
from ._enumerations import ProblemType
from ._errors import fail
from ._params import Params, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._estimate import _Estimate, _Mask

Rng = native.Rng


class Correspondences(typing.NamedTuple):
    """The points as components see them: those with finite coordinates, in a fixed pseudo-random order, in coordinates of the
    search (about unit size; E: of the normalized image plane)."""

    data: npt.NDArray[np.float64]  #: N x columns; of two views x1, y1, x2, y2
    inputIndex: npt.NDArray[np.int32]  #: N, the row of the caller's arrays
    scores: Optional[npt.NDArray[np.float32]]  #: N, Params.scores, lower is better; None if there are none
    threshold: float  #: Params.threshold times Params.reach in these coordinates, not squared
    sampleSize: int  #: points of a minimal sample


class _Component(abc.ABC):
    def start(self, points: Correspondences) -> None:
        """A run begins. Called once a run, before anything else; the arrays are copies and may be kept. Default: nothing."""

    def _begin(self, *points: Any) -> None:
        self.start(Correspondences(*points))


class Sampler(_Component):
    """How minimal samples are drawn; to be subclassed.

    sample() is called once a sample, by one thread. A call costs about a microsecond beside what it does itself: 5000 samples
    of fundamental matrices of 1000 matches take 10 milliseconds with the one below, 5 with that of C++.

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

    #: Whether the last sample counts for the criteria of termination as one that is uniform among all points. False for one from a
    #: part of the points, which may never meet the best model; sample() may set it.
    counts: bool = True

    @abc.abstractmethod
    def sample(self, rng: native.Rng, iteration: int) -> typing.Sequence[int]:
        """Draws a sample.

        rng -- random numbers of this iteration, the same ones for the same Params.seed
        iteration -- number of the sample, from 0 on

        Returns sampleSize distinct rows of Correspondences.data."""


class Score(_Component):
    """What errors are worth; to be subclassed.

    accumulate() is called for each block of points of each model, by Params.threads threads at once, which wait for the
    interpreter's lock. A call takes about 10 microseconds with NumPy, as below: the homography of 1000 matches takes 14 times
    as long as with the score of C++, a fundamental matrix 12 times; with `wholeModel`, one call a model, 3 to 4 times.

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

    #: True: the cost is no sum over the points; accumulate() is called once for a model, with all of them.
    wholeModel: bool = False

    @abc.abstractmethod
    def accumulate(self, squaredErrors: npt.NDArray[np.float32], squaredThreshold: float) -> Tuple[float, int]:
        """Rates a block of points.

        squaredErrors -- float32, a copy; NaN and infinite ones are outliers
        squaredThreshold -- in the unit of the errors

        Returns (cost, inliers): the sum of the costs of the points, each between 0 (perfect) and 1 (outlier), and the number
        of inliers."""


class Components:
    """The parts of an estimator that can be replaced; None is the part that Params has chosen."""

    def __init__(self, usac: native.Usac) -> None:
        self._usac = usac
        self._sampler: Optional[Sampler] = None
        self._score: Optional[Score] = None

    @property
    def sampler(self) -> Optional[Sampler]:
        """How minimal samples are drawn."""
        return self._sampler

    @sampler.setter
    def sampler(self, value: Optional[Sampler]) -> None:
        if value is not None and not isinstance(value, Sampler):
            raise fail("sampler: an object of a subclass of usacv20.Sampler is expected, not {}".format(_arguments.shown(value)))
        self._usac.setSampler(value)
        self._sampler = value

    @property
    def score(self) -> Optional[Score]:
        """What errors are worth."""
        return self._score

    @score.setter
    def score(self, value: Optional[Score]) -> None:
        if value is not None and not isinstance(value, Score):
            raise fail("score: an object of a subclass of usacv20.Score is expected, not {}".format(_arguments.shown(value)))
        self._usac.setScore(value)
        self._score = value


class Usac:
    """One estimation: points, parameters and the components that do the work; made by Usac.create()."""

    def __init__(self, usac: native.Usac) -> None:
        self._usac = usac
        self._components = Components(usac)

    @classmethod
    def create(cls, problem: int, points1: npt.ArrayLike, points2: npt.ArrayLike, params: Optional[Params] = None,
               cameraMatrix1: Optional[npt.ArrayLike] = None, cameraMatrix2: Optional[npt.ArrayLike] = None,
               distCoeffs1: Optional[npt.ArrayLike] = None, distCoeffs2: Optional[npt.ArrayLike] = None) -> Usac:
        """Reads the points and builds the components that `params` names.

        problem -- ProblemType
        points1, points2 -- N points each, as the function estimate* of the problem has them
        params -- Params, None for the default
        cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 -- for ESSENTIAL and ABSOLUTE_POSE, as for estimateEssential"""
        number = integer(problem, "problem", None, 0, len(ProblemType) - 1)
        return cls(native.Usac(
            number, _arguments.array(points1, "points1"), _arguments.array(points2, "points2"), optionsOf(params),
            optionalArray(cameraMatrix1, "cameraMatrix1"), optionalArray(cameraMatrix2, "cameraMatrix2"),
            optionalArray(distCoeffs1, "distCoeffs1"), optionalArray(distCoeffs2, "distCoeffs2")))

    @property
    def components(self) -> Components:
        """What can be replaced before run(): components.sampler, components.score."""
        return self._components

    @property
    def points(self) -> Correspondences:
        """Copies of the points as the components see them."""
        return Correspondences(*self._usac.points())

    def setPoints(self, points1: npt.ArrayLike, points2: npt.ArrayLike) -> None:
        """Other points for the next run, of any number. The object keeps its memory."""
        self._usac.setPoints(_arguments.array(points1, "points1"), _arguments.array(points2, "points2"))

    def run(self, mask: _Mask = None) -> _Estimate:
        """Runs the estimation; may be called again, with the same result. An exception in a component ends the run with it.

        mask -- Nx1 array of uint8 that receives the mask, or None

        Returns (model, mask, report) as the function estimate* of the problem."""
        _arguments.checkOutput(mask, "mask")
        model, inliers, report = self._usac.run()
        return model, _arguments.output(mask, inliers), Report._of(report)


for _class in (Correspondences, Sampler, Score, Components, Usac):
    _class.__module__ = __name__.rpartition(".")[0]
del _class
