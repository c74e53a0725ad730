# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Report: statistics and results of one estimation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from ._backend import native
from ._enumerations import StopReason
from ._fields import EnumField, Field

if TYPE_CHECKING:
    import numpy.typing as npt


def _restored(values: Dict[str, Any]) -> Report:
    report = Report()
    for name, value in values.items():
        setattr(report._native, name, value)
    return report


class Sample(Field[Tuple[int, ...]]):
    """A descriptor of the field with indices of points."""

    def read(self, instance: Any) -> Any:
        return tuple(int(row) for row in getattr(instance._native, self.name))


class Covariance(Field["Optional[npt.NDArray[np.float64]]"]):
    """A descriptor of the field with a matrix, or None."""

    def read(self, instance: Any) -> Any:
        value = getattr(instance._native, self.name)
        return None if value is None or value.size == 0 else value


class Report:
    """Statistics and results of one estimation. Times are measured with a steady clock and do not
    influence results. Report() belongs to no run."""

    __slots__ = ("_native",)
    __hash__ = None  # type: ignore[assignment]

    _native: Any

    stop = EnumField(StopReason, "StopReason: why the search ended, or why there is no model.")
    iterations = Field[int]("Minimal samples drawn.")
    rejectedSamples = Field[int]("Samples refused by a check of the sample (orientation, matches that share a point).")
    degenerateSamples = Field[int]("Samples that determine no model (repeated or collinear points, no real solution).")
    models = Field[int]("Models computed from the samples.")
    rejectedModels = Field[int]("Models refused by a check of the model itself (orientation, singular).")
    refusedModels = Field[int]("Models dropped by the pre-emptive verification.")
    droppedModels = Field[int]("Models that were no better than the best one.")
    localOptimizations = Field[int]("Local optimizations run.")
    localImprovements = Field[int]("Local optimizations that improved their model.")
    degenerate = Field[bool]("True if a so-far-the-best F came from a sample dominated by a plane.")
    inliers = Field[int]("Rows of the mask that are 1.")
    sample = Sample("""The sample that led to the model: rows of the points, as many as a minimal solver takes. Empty: there is no
        model, or it came from Params.initialModel or from a fit of all points.""")
    inlierRatio = Field[float]("inliers as a part of all rows of the mask, 0..1.")
    independentInliers = Field[int]("""Inliers that are more than a threshold apart from each other in both images:
        repeated matches count once. 0 if the run was stopped and has more than 50 000 inliers.""")
    chance = Field[float]("""Upper bound of the probability that the same search finds a model with as many independent
        inliers in random matches of the same points, 0..1. Also set if the model was refused for it; 1 if there was none.""")
    threshold = Field[float]("""Threshold of the mask in pixels, that of Params; THRESHOLD_ESTIMATED, QUALITY_LMEDS: estimated from
        the data.""")
    sigma = Field[float]("""Standard deviation of the noise of the inliers, in each component of the error, in the unit of
        Params.threshold; maps: of the noise of both arrays; F, E: about that of a coordinate. 0: not estimated.""")
    covariance = Covariance("""Covariance of the parameters of the returned model, a d x d array of float64; None if there is no model,
        or Params.covariance is 0.
        Parameters: absolute pose and rigid motion 6: rotation vector w (radians) and translation dt of [exp(w) R, t + dt]; with scale
        7: and the relative change of the scale; affinity 6: the entries, row by row; similarity 4: a, b, tx, ty of [a -b tx; b a ty];
        homography 8, F 7, E 5: see tangentOfModel. NaN: not determined (F and E of a plane, too few inliers, POLISHING_NONE).
        covarianceOfModel, covarianceOfPose and pointCovariance say what it means for the model and for points.""")
    priorChance = Field[float]("""Probability that the initial model and the model of the points differ by at least as much as they do, if
        Params.initialCovariance and the covariance of the points describe their errors, 0..1. Below 0.001 the prior was not used. 0
        also if there is no prior, or the covariance of the points is not determined.""")
    wideThreshold = Field[bool]("""True if the threshold is at least half of the longest side of the box in which nearly all points
        of the second array lie: then a model that maps everything to one place has them all as inliers. It is probably in another
        unit: pixels, say, beside points of the normalized image plane.""")
    cost = Field[float]("""Cost of the returned model per correspondence; 0 (best) .. 1. MSAC: mean of
        min(error^2 / threshold^2, 1).""")
    setupMs = Field[float]("Milliseconds: reading, scaling and ordering the points.")
    searchMs = Field[float]("Milliseconds: the hypothesize-and-verify loop without the local optimization.")
    localMs = Field[float]("Milliseconds: all local optimizations.")
    polishMs = Field[float]("Milliseconds: final polishing and the mask.")

    def __init__(self) -> None:
        self._native = native.Report()

    @classmethod
    def _of(cls, values: Any) -> Report:
        result = cls.__new__(cls)
        result._native = values
        return result

    def describe(self) -> str:
        """Returns one sentence for a log. It ends with "no better than chance" if `chance` is above
        0.01 although there is a model. This happens with few points, or if Params.significance
        allows it."""
        return str(self._native.describe())

    def asDict(self) -> Dict[str, Any]:
        """Returns the fields by name, for a table or a file: numbers, truth values, `stop` as text,
        and `covariance` as lists."""
        matrix = self.covariance
        return dict(self._values(), stop=self.stop.name, covariance=None if matrix is None else matrix.tolist())

    def _values(self) -> Dict[str, Any]:
        return dict({name: getattr(self._native, name) for name in _FIELDS}, sample=self.sample, covariance=self.covariance)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Report):
            return NotImplemented
        own, others = self._values(), other._values()
        matrices = own.pop("covariance"), others.pop("covariance")
        if matrices[0] is None or matrices[1] is None:
            return own == others and matrices[0] is matrices[1]
        return own == others and np.array_equal(*matrices, equal_nan=True)

    def __repr__(self) -> str:
        values = self.asDict()
        return "{}({})".format(type(self).__name__, ", ".join(
            "{}={}".format(name, value if name == "stop" else repr(value)) for name, value in values.items()))

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (self._values(),)


_FIELDS = tuple(name for name, value in vars(Report).items() if isinstance(value, Field))

Report.__module__ = __name__.rpartition(".")[0]
