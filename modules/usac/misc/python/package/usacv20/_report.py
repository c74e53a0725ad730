# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Report: statistics and results of one estimation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from ._backend import native
from ._enumerations import StopReason
from ._errors import warn
from ._fields import EnumField, Field

if TYPE_CHECKING:
    import numpy.typing as npt


def _restored(values: Dict[str, Any]) -> Report:
    report = Report()
    for name, value in values.items():
        setattr(report._native, name, value)
    return report


class Sample(Field[Tuple[int, ...]]):
    """A descriptor of a read-only field whose value is a tuple of point indices."""

    def read(self, instance: Any) -> Any:
        return tuple(int(row) for row in getattr(instance._native, self.name))


class Covariance(Field["Optional[npt.NDArray[np.float64]]"]):
    """A descriptor of a read-only field whose value is a matrix, or None."""

    def read(self, instance: Any) -> Any:
        value = getattr(instance._native, self.name)
        return None if value is None or value.size == 0 else value


class Report:
    """Statistics and results of one estimation. Times are elapsed times and do not influence the
    result. Report() creates a report that does not belong to a run."""

    __slots__ = ("_native",)
    __hash__ = None  # type: ignore[assignment]

    _native: Any

    stop = EnumField(StopReason, "StopReason: why the search ended, or why there is no model.")
    iterations = Field[int]("Number of minimal samples drawn.")
    rejectedSamples = Field[int]("""Number of samples rejected by a check before a model is computed (orientation, matches that
        share a point).""")
    degenerateSamples = Field[int]("Number of samples that determine no model (repeated or collinear points, no real solution).")
    models = Field[int]("Number of models computed from the samples.")
    rejectedModels = Field[int]("Number of models rejected by a check before they are scored (orientation, singular matrix).")
    refusedModels = Field[int]("Number of models rejected by the pre-emptive verification.")
    droppedModels = Field[int]("""Number of models that were not better than the best model that any sample had given so far,
        before local optimization; up to Params.runnersUp of these are optimized nevertheless.""")
    localOptimizations = Field[int]("Number of local optimizations.")
    localImprovements = Field[int]("Number of local optimizations whose result was better than the best model so far.")
    degenerate = Field[bool]("""True if DEGENERACY_DEGENSAC found a dominant plane in the sample or among the inliers of a model that it
        examined (F only).""")
    inliers = Field[int]("Number of inliers: rows of the mask that are 1.")
    sample = Sample("""The minimal sample of the search that led to the model, as row indices of the caller's points. Empty if
        there is no model, or if the model did not come from a minimal sample, for example from Params.initialModel.""")
    inlierRatio = Field[float]("`inliers` as a fraction of all rows of the mask, 0..1.")
    independentInliers = Field[int]("""Number of inliers without repetitions: in each image, inliers in the same square of
        a grid with the threshold as side count once; this is the smaller of the two images' numbers. 0 (not computed) if the
        run was stopped (Params.maxTime, progress) and has more than 50 000 inliers.""")
    chance = Field[float]("""Upper bound of the probability that the same search finds a model with as many independent
        inliers in random matches of the same points, 0..1. Also set if the model was rejected because of this value; 1 if no
        model was found.""")
    threshold = Field[float]("""Threshold of the mask, in the unit of Params.threshold: Params.threshold itself or, with
        THRESHOLD_ESTIMATED or QUALITY_LMEDS, a threshold estimated from the data.""")
    sigma = Field[float]("""Standard deviation of each component of the inliers' errors, in the unit of Params.threshold. For F
        and E it is about that of the points' coordinates; for maps it combines the noise of both arrays. 0 if it was not
        estimated: there is no model, there are too few inliers, or the threshold was given and Params.covariance is 0.""")
    covariance = Covariance("""Covariance of the parameters of the returned model, a d x d array of float64; None if there is no
        model, if Params.covariance is 0, or for a mere fit (fitModel, or refineModel with `chosen`). The parameters are: for
        an absolute pose and a rigid motion (d = 6) the rotation vector w in radians and the translation dt of
        [exp(w) R, t + dt]; for a 3-D similarity (7) the same and the relative change of the scale; for an affinity (6) the
        entries, row by row; for a similarity (4) a, b, tx, ty of [a -b tx; b a ty]; for a 2-D translation (2) its two
        coordinates; for a homography (8), F (7) and E (5) see tangentOfModel. All entries are NaN if the covariance is
        not determined (F and E without a translation, F of a plane, too few inliers, POLISHING_NONE). covarianceOfModel,
        covarianceOfPose and pointCovariance compute the covariance of the entries, of a motion and of points.""")
    priorChance = Field[float]("""Probability, 0..1, of a difference at least as large as that between the initial model and
        the model from the points, if Params.initialCovariance and the covariance of the model from the points describe the
        errors of the two models. If it is below 0.001, the prior was not used. It is also 0 if there is no prior, or if the
        covariance of the model from the points is not determined.""")
    wideThreshold = Field[bool]("""True if `threshold` is at least half of the longest side of the box that contains nearly all
        points of the second array. A model that maps all points to a single point can then have most points as inliers, and
        the number of inliers means nothing. The threshold is probably in the wrong unit, for example in pixels with points of the
        normalized image plane.""")
    warning = Field[str]("""What makes the result doubtful although the call is valid; empty if nothing does: `wideThreshold`; a
        camera matrix under which most points are more than 80 degrees off the axis of the camera (E, absolute pose); or the
        principal point at the same corner of the box of all points in both images (E), as if the camera matrix were that of
        images of another size. Functions that estimate a single model give this text as a UsacWarning, too.""")
    cost = Field[float]("""Cost of the returned model per correspondence; 0 (best) .. 1. MSAC: mean of
        min(error^2 / threshold^2, 1).""")
    setupMs = Field[float]("""Milliseconds before the search: reading and ordering the points, and the samples that
        THRESHOLD_ESTIMATED needs to estimate the threshold.""")
    searchMs = Field[float]("Milliseconds in the hypothesize-and-verify loop without the local optimization.")
    localMs = Field[float]("Milliseconds in all local optimizations.")
    polishMs = Field[float]("Milliseconds after the search: final polishing, mask, `chance` and `covariance`.")

    def __init__(self) -> None:
        self._native = native.Report()

    @classmethod
    def _of(cls, values: Any) -> Report:
        result = cls.__new__(cls)
        result._native = values
        return result

    @classmethod
    def _ofCall(cls, values: Any) -> Report:
        """Gives report.warning as a UsacWarning, too."""
        warn(values.warning)
        return cls._of(values)

    def describe(self) -> str:
        """Returns one sentence for a log. It ends with "no better than chance" if `chance` is above
        0.01 and a model is returned nevertheless, because there are few points or
        Params.significance allows it."""
        return str(self._native.describe())

    def asDict(self) -> Dict[str, Any]:
        """Returns a dictionary of the fields by name, for a table or a file: numbers, truth values,
        `stop` as text, `sample` as a tuple, and `covariance` as lists or None."""
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
