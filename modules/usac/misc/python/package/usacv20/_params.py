# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Params, the options of the estimator."""

from __future__ import annotations

import difflib
import enum
import typing
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Type, Union

import numpy as np

from . import _enumerations as e
from ._arguments import array, checkModelShape, checkSquare, integer
from ._backend import native
from ._errors import fail
from ._fields import Covariance, Field, Integer, Model, Noise, Option, Real, Scores, Set

if TYPE_CHECKING:
    import numpy.typing as npt

    _Name = Union[int, str, None]

P = typing.TypeVar("P", bound="Params")


# Argument names of OpenCV's functions, and the fields of Params with the same meaning.
_OPENCV = {"ransacReprojThreshold": "threshold", "reprojectionError": "threshold", "maxIters": "maxIterations",
           "iterationsCount": "maxIterations", "prob": "confidence", "refineIters": "polishingSteps"}


def _unknown(function: str, name: str) -> TypeError:
    near = [_OPENCV[name]] if name in _OPENCV else difflib.get_close_matches(name, _FIELDS, 1)
    return TypeError("{}() got an unexpected keyword argument '{}'; {}".format(
        function, name, "did you mean {}?".format(near[0]) if near else "it has the fields of Params, see help(usacv20.Params)"))


def _restored(type_: Type[P], values: Dict[str, Any]) -> P:
    return type_(**values)


def _matrix(given: Optional[npt.ArrayLike], name: str) -> "npt.NDArray[Any]":
    matrix = np.empty(0) if given is None else array(given, name)
    if matrix.ndim > 2:
        raise fail("{}: a matrix is expected, not {} dimensions".format(name, matrix.ndim))
    return matrix


class Params:
    """All options of the estimator.

    Fields can be given by name to the constructor, Params(threshold=2, scores=distances), and to
    the presets, Params.fast(threshold=2), or assigned later; None means the default. Params() is
    Params.usacV20(). Enumerators can also be given by name: Params(sampler="prosac",
    termination="sprt|standard"). A value of a wrong type or an enumerator of another enumeration
    raises TypeError at once. Any other invalid value raises usacv20.error, which names the field,
    when the estimator is created or in check(). Objects can be compared, copied and pickled; repr()
    shows the fields that differ from the default. Pixels are those of image 2; for 3-D motions,
    "pixels" means the unit of points2."""

    __slots__ = ("_native", "_scores", "_sigmas", "_sigmasColumns", "_initialModel", "_initialCovariance", "_filled", "_fixed")
    __hash__ = None  # type: ignore[assignment]  # as for all mutable classes

    _native: Any
    _sigmasColumns: int
    _filled: bool
    _fixed: bool

    threshold = Real("""Inlier threshold in pixels, not squared; > 0. H, affine maps: distance in image 2. F, E: Sampson
        distance. Absolute pose: reprojection error in the original (distorted) image. 3-D motions: distance between a mapped
        point and its counterpart, in the unit of the points. Default 1.5.""")
    thresholdType = Option(e.ThresholdType, """ThresholdType of threshold. With THRESHOLD_ESTIMATED, threshold is the upper
        limit of the estimated threshold, which follows from the noise of the inliers, see Report.threshold. Default
        THRESHOLD_GIVEN.""")
    confidence = Real("""Probability that the search does not miss a better model (TERMINATION_P_NAPSAC: a significantly
        better one, see relaxation), unless maxIterations ends it first; in (0, 1). Default 0.99.""")
    maxIterations = Integer("Upper bound of the number of minimal samples; >= 1. Default 5000.")
    maxTime = Real("""Milliseconds after which a run ends with the best model so far; 0..1e9, 0: no limit. A run ends at most
        about 5 ms late for 10 000 points, and 0.1 s late for a million; report.stop is then STOP_TIME. This is the only
        option by which the result depends on the machine. Default 0.""")
    seed = Integer("Seed of the pseudo-random sequence; the same seed and input give the same bits. Default 0.")
    threads = Integer("""Number of threads that compute and score models; 0..1024, 0: that of OpenCV (cv2.getNumThreads()).
        The result does not depend on it. Default 1.""")
    sampler = Option(e.SamplerType, "SamplerType: how samples are drawn. Default SAMPLER_P_NAPSAC.")
    ordering = Option(e.OrderingType, "OrderingType: where the order of the points comes from. Default ORDERING_AUTO.")
    scores = Scores(np.float32, """Score of each correspondence: an array of N float32, or an empty one. Assigned numbers of shape
        N, N x 1 or 1 x N are copied into this array; its elements can be changed in place. NaN is the worst score;
        SAMPLER_IMPORTANCE takes scores as probabilities and raises usacv20.error for NaN. Default none.""")
    sigmas = Noise(np.float32, """Noise of each correspondence. N numbers: standard deviations of errors, 1e-6..1e6, in pixels or up to a
        common factor, such as the scales of keypoints. N x 3: covariances xx, xy, yy of the points in image 2, in square pixels,
        without noise in image 1. N x 6: those of the points in image 2, then in image 1. Covariances need image points (an
        absolute pose has one image: N x 3) and RESIDUAL_STANDARD; variances are 1e-12..1e12, 1 - xy^2 / (xx yy) is 1e-6 or more, and
        three zeros are an exact point of image 1. Each error is divided by its standard deviation in score,
        fits, mask and covariance: threshold, Report.threshold, Report.sigma and modelErrors refer to the divided errors. The
        stored array has one dimension; if the number of assigned rows is not that of the matches, usacv20.error is raised.
        Default none.""")
    initialModel = Model(np.float64, """Entries, row by row, of an initial model, such as that of the previous frame; an
        array of float64, empty if there is none; see setInitialModel(). It is scored and optimized before the first sample,
        like a model of a sample. Default none.""")
    initialCovariance = Covariance(np.float64, """Covariance of initialModel, d x d numbers for the parameters of
        Report.covariance; an array of float64, empty if there is none. With it, the initial model is a prior: the result is
        the mean of the initial model and the model estimated from the points, weighted by the inverses of their covariances.
        If the two models contradict each other, the result is the model from the points alone, see Report.priorChance.
        Default none.""")
    scoreOrder = Option(e.ScoreOrder, "ScoreOrder: whether low or high scores are better. Default SCORES_LOWER_IS_BETTER.")
    neighborhood = Option(e.NeighborhoodType, "NeighborhoodType: which points are neighbors. Default NEIGHBORHOOD_GRID.")
    neighbors = Integer("""Number of neighbors of a point for NEIGHBORHOOD_KNN in the finest of four layers; each further
        layer has twice as many; 1..1000. Default 10.""")
    neighborRadius = Real("""Radius for NEIGHBORHOOD_RADIUS in the finest of four layers, in pixels of the joint space (x1,
        y1, x2, y2), doubled for each further layer; > 0. Default 40.""")
    residual = Option(e.ResidualType, "ResidualType: which error of a point is minimized. Default RESIDUAL_STANDARD.")
    quality = Option(e.QualityType, "QualityType: how a model is scored. Default QUALITY_MSAC.")
    reach = Real("""Search, local optimization and polishing use this multiple of threshold, the mask uses threshold itself;
        1..10. Meant for scores and fits that are marginalized over the noise scale. Default 1; magsac() 3,
        magsacPlusPlus() 2.4.""")
    widestReach = Real("""Upper bound to which reach grows during the search if the errors of the best model show that
        reach times threshold is too small for the noise; 1..1e6. The mask still uses threshold and may then be empty for a
        correct model. Default 1; magsac() and magsacPlusPlus() 1000.""")
    verification = Option(e.VerificationType, """VerificationType: how bad models are rejected early. Default
        VERIFICATION_SPRT.""")
    tddPoints = Integer("Number of points that must be inliers for VERIFICATION_TDD; 1..100. Default 1.")
    localOptimization = Option(e.LocalOptimizationType, """LocalOptimizationType: how each model that is better than all
        before is improved. Default LOCAL_OPTIMIZATION_GRAPH_CUT.""")
    localIterations = Integer("""Iterations of one local optimization: alternations of labeling and fitting, steps of the
        shrinking threshold, or re-weightings; 1..1000. Default 5.""")
    localSampleMultiple = Integer("""Size of the inner samples of a local optimization, as a multiple of the minimal sample
        size; 2..100. Default 3.""")
    localSamples = Integer("""Number of inner samples of a local optimization (with graph cuts: of each alternation). If this is
        not 0, LOCAL_OPTIMIZATION_GRAPH_CUT draws at least 4 if there are few inliers; 0..1000. Default 1; accurate(),
        loRansac() 10, floRansac() 4, gcRansac() and paper() 20.""")
    spatialWeight = Real("Weight of the spatial coherence in the graph cut; 0 (none) .. 10. Default 0.14.")
    runnersUp = Integer("""Maximum number of runners-up: models that were not the best one, but are optimized when the search
        is about to end, because they have the most inliers that are outliers of the best model; 0..100. Default 16.""")
    orderedEvery = Integer("""Samplers that prefer some points draw one in this many samples in their own way; the others are
        uniform among all points, and in general only the uniform samples count for the termination criteria. If the order
        of the points is known (scores), the first 8 samples are uniform; with TERMINATION_ORDER, every second sample then
        follows the order, and every sample once the order is confirmed. 1: all samples are drawn in the sampler's way, and
        all count, as in the papers; 1..1000. Default 8.""")
    termination = Set(e.TerminationFlags, """Set of TerminationFlags; 0: all maxIterations samples are drawn. Default
        TERMINATION_SPRT | TERMINATION_P_NAPSAC | TERMINATION_EXACT | TERMINATION_ORDER.""")
    relaxation = Real("""For TERMINATION_P_NAPSAC and TERMINATION_ORDER: how many more inliers than the best model a
        "significantly" better model has, as a fraction of the inliers of the best model; the fraction is reduced if these
        inliers are few; 0..1. Default 0.05.""")
    persistence = Integer("Factor on the number of samples that the termination criteria ask for; 1..100. Default 1.")
    degeneracy = Set(e.DegeneracyFlags, "Set of DegeneracyFlags. Default all.")
    polishing = Option(e.PolishingType, "PolishingType: how the best model is refined at the end. Default POLISHING_ROBUST.")
    polishingSteps = Integer("""Maximum number of fits of the polishing, each with the inliers or weights of the previous
        one; six more for POLISHING_ROBUST with more than 32768 points; 1..100. Default 6.""")
    significance = Real("""Largest Report.chance with which a model is returned, a probability; 0..1. 1: a model is returned
        whatever its chance is. Default 0: the bound is 0.01, or 1 if there are so few independent points that even a model
        with a quarter of them as inliers would have a chance above 0.01.""")
    covariance = Integer("""1: Report.covariance and, with THRESHOLD_GIVEN, Report.sigma are computed (0.1 ms for 200
        points, 0.3 ms for 1000 or more); 0..1. Default 0.""")

    def __init__(self, *,
                 threshold: Optional[float] = None, thresholdType: _Name = None, confidence: Optional[float] = None,
                 maxIterations: Optional[int] = None, maxTime: Optional[float] = None, seed: Optional[int] = None, threads: Optional[int] = None,
                 sampler: _Name = None, ordering: _Name = None, scores: Optional[npt.ArrayLike] = None,
                 sigmas: Optional[npt.ArrayLike] = None, initialModel: Optional[npt.ArrayLike] = None,
                 initialCovariance: Optional[npt.ArrayLike] = None, scoreOrder: _Name = None,
                 neighborhood: _Name = None, neighbors: Optional[int] = None,
                 neighborRadius: Optional[float] = None, residual: _Name = None, quality: _Name = None,
                 reach: Optional[float] = None, widestReach: Optional[float] = None, verification: _Name = None,
                 tddPoints: Optional[int] = None, localOptimization: _Name = None,
                 localIterations: Optional[int] = None, localSampleMultiple: Optional[int] = None,
                 localSamples: Optional[int] = None, spatialWeight: Optional[float] = None,
                 runnersUp: Optional[int] = None, orderedEvery: Optional[int] = None, termination: _Name = None,
                 relaxation: Optional[float] = None, persistence: Optional[int] = None,
                 degeneracy: _Name = None, polishing: _Name = None,
                 polishingSteps: Optional[int] = None, significance: Optional[float] = None,
                 covariance: Optional[int] = None) -> None:
        fields = dict(locals())
        self._start(native.Params())
        for name in _FIELDS:
            if fields[name] is not None:
                setattr(self, name, fields[name])

    def _start(self, options: Any) -> None:
        self._native = options
        self._filled = False
        self.scores = None
        self.sigmas = None
        self.initialModel = None
        self.initialCovariance = None

    @classmethod
    def _of(cls: Type[P], options: Any) -> P:
        result = cls.__new__(cls)
        result._start(options)
        return result

    @classmethod
    def _preset(cls: Type[P], name: str, fields: Dict[str, Any]) -> P:
        return cls._of(getattr(native.Params, name)())._with(name, fields)

    def _with(self: P, function: str, fields: Dict[str, Any]) -> P:
        """Sets the given fields; None keeps the value of the preset."""
        for name, value in fields.items():
            if name not in _FIELDS:
                raise _unknown("Params." + function, name)
            if value is not None:
                setattr(self, name, value)
        return self

    def _fix(self: P) -> P:
        """Makes all fields read-only."""
        self.scores.setflags(write=False)
        self.sigmas.setflags(write=False)
        self.initialModel.setflags(write=False)
        self.initialCovariance.setflags(write=False)
        self._fixed = True
        return self

    if not TYPE_CHECKING:  # without this test, type checkers would accept any attribute

        def __setattr__(self, name: str, value: Any) -> None:
            if getattr(self, "_fixed", False) and name in _FIELDS:
                raise AttributeError("params.{}: the options of an estimator are read-only; to set others for the next run: "
                                     "usac.params = usac.params.replace({}=...)".format(name, name))
            super().__setattr__(name, value)

    def replace(self: P, **fields: Any) -> P:
        """Returns a copy with other values of some fields, as in params.replace(threshold=3). None
        means the default of Params()."""
        unknown = [name for name in fields if name not in _FIELDS]
        if unknown:
            raise _unknown("Params.replace", unknown[0])
        values = dict(self._items(), sigmas=self._sigmasInRows())
        values.update(fields)
        return type(self)(**values)

    def _prepared(self) -> Any:
        """Returns the options as an object of the compiled part, with the current contents of the
        arrays, which a program may have changed in place."""
        options = self._native
        arrays = self.scores, self.sigmas, self.initialModel, self.initialCovariance
        filled = any(array.size for array in arrays)
        if self._filled or filled:
            options.scores, options.sigmas, options.initialModel, options.initialCovariance = arrays
            self._filled = filled
        return options

    def check(self, count: int = -1) -> None:
        """Raises usacv20.error, whose message names the first field with an invalid value, if there is one.

        count -- number of correspondences, -1 if unknown"""
        number = integer(count, "count")
        self._prepared().check(number)
        if number >= 0:
            self._checkRows(number, "")

    def _checkRows(self, count: int, prefix: str) -> None:
        """Raises usacv20.error, whose message begins with `prefix`, if sigmas were assigned in rows, but not in `count`
        rows. The compiled part gets only the numbers without their shape and might assign them to the wrong matches."""
        columns = self._sigmasColumns
        if columns > 0 and len(self.sigmas) != columns * count:
            raise fail("{}sigmas: a row for each of the {} correspondences is expected, not the shape {} x {}".format(
                prefix, count, len(self.sigmas) // columns, columns))

    def setInitialModel(self, model: Optional[npt.ArrayLike], covariance: Optional[npt.ArrayLike] = None) -> None:
        """Sets initialModel and initialCovariance.

        model -- 3x3 for H, F and E, 2x3 for affine maps, similarities and translations, 3x4 for absolute poses and 3-D motions, or
            the numbers of such a matrix, row by row, as a list, a row or a column; any number type; None or an empty array: no initial
            model
        covariance -- d x d, such as Report.covariance, any number type; None or an empty array: no covariance

        Raises usacv20.error, whose message names the argument, for another shape, such as that of a transposed matrix."""
        entries, variances = _matrix(model, "model"), _matrix(covariance, "covariance")
        checkModelShape(entries, "model")
        checkSquare(variances, "covariance")
        self.initialModel, self.initialCovariance = entries, variances

    def _items(self) -> typing.Iterator[Tuple[str, Any]]:
        return ((name, getattr(self, name)) for name in _FIELDS)

    def _sigmasInRows(self) -> "npt.NDArray[np.float32]":
        """Returns sigmas in the shape in which they were assigned, for copies."""
        return self.sigmas.reshape(-1, self._sigmasColumns) if self._sigmasColumns > 0 else self.sigmas

    def _differing(self) -> typing.Iterator[Tuple[str, Any]]:
        """Yields the fields whose values differ from the default."""
        default = Params()
        return ((name, value) for name, value in self._items() if not _same(value, getattr(default, name)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Params):
            return NotImplemented
        return all(_same(value, getattr(other, name)) for name, value in self._items())

    def __repr__(self) -> str:
        return "{}({})".format(type(self).__name__, ", ".join("{}={}".format(name, _shown(value))
                                                              for name, value in self._differing()))

    def __copy__(self: P) -> P:
        return self.replace()

    def __deepcopy__(self: P, memo: Dict[int, Any]) -> P:
        return self.__copy__()

    def __reduce__(self) -> Tuple[Any, ...]:
        values = {name: value if isinstance(value, (float, np.ndarray)) else int(value) for name, value in self._differing()}
        if "sigmas" in values:
            values["sigmas"] = self._sigmasInRows()
        return _restored, (type(self), values)

    @classmethod
    def fromMethod(cls: Type[P], method: int, **fields: Any) -> P:
        """Returns the preset of a flag, one of USACV20*; anything else raises usacv20.error."""
        return cls._of(native.Params.fromMethod(integer(method, "method")))._with("fromMethod", fields)

    @classmethod
    def usacV20(cls: Type[P], **fields: Any) -> P:
        """Returns the configuration chosen in the paper of USACv20, with robust polishing; the same as Params()."""
        return cls._preset("usacV20", fields)

    @classmethod
    def fast(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_FAST: early termination and a short local optimization."""
        return cls._preset("fast", fields)

    @classmethod
    def accurate(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_ACCURATE: three times the samples that the standard criterion asks for, and a long
        local optimization."""
        return cls._preset("accurate", fields)

    @classmethod
    def sorted(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_PROSAC: PROSAC sampling of points that the caller has
        sorted, best first. If `scores` are given, they determine the order instead."""
        return cls._preset("sorted", fields)

    @classmethod
    def trustedScores(cls: Type[P], **fields: Any) -> P:
        """Returns a preset for an order of the points that the caller trusts (`scores`, or
        ORDERING_INPUT_ORDER): like usacV20(), but all samples are drawn as in PROSAC, whose
        termination criterion can end the search. If the order is wrong, the search can miss the
        model."""
        return cls._preset("trustedScores", fields)

    @classmethod
    def parallel(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_PARALLEL: like usacV20(), with all threads of OpenCV and the same result."""
        return cls._preset("parallel", fields)

    @classmethod
    def automatic(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_AUTO: like usacV20(), with an estimated threshold of at most 5 pixels."""
        return cls._preset("automatic", fields)

    @classmethod
    def ransac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of RANSAC of 1981: uniform samples, scores by the number of inliers, least squares."""
        return cls._preset("ransac", fields)

    @classmethod
    def msac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of MSAC: like ransac(), with truncated squared errors."""
        return cls._preset("msac", fields)

    @classmethod
    def lmeds(cls: Type[P], **fields: Any) -> P:
        """Returns the options of LMedS: like ransac(), with the median of the squared errors; `threshold` is not used."""
        return cls._preset("lmeds", fields)

    @classmethod
    def mlesac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of MLESAC: like ransac(), with the likelihood of a mixture of inliers and outliers."""
        return cls._preset("mlesac", fields)

    @classmethod
    def prosac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of PROSAC: like ransac(), with PROSAC's samples and termination. The
        caller has sorted the points, best first, or gives `scores`."""
        return cls._preset("prosac", fields)

    @classmethod
    def loRansac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of LO-RANSAC: like ransac(), but each new best model is refined by ten inner samples."""
        return cls._preset("loRansac", fields)

    @classmethod
    def floRansac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of FLO-RANSAC: like msac(), but each new best model is refined by inner samples and fits of
        bounded size."""
        return cls._preset("floRansac", fields)

    @classmethod
    def gcRansac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of GC-RANSAC: like msac(), but each new best model is refined by graph cuts and inner samples."""
        return cls._preset("gcRansac", fields)

    @classmethod
    def usac2013(cls: Type[P], **fields: Any) -> P:
        """Returns the options of USAC of 2013: PROSAC samples of sorted points, SPRT, LO-RANSAC, DEGENSAC."""
        return cls._preset("usac2013", fields)

    @classmethod
    def paper(cls: Type[P], **fields: Any) -> P:
        """Returns the options of USACv20 to the letter of its paper, for comparisons: usacV20() without its additions. For H,
        F and E only."""
        return cls._preset("paper", fields)

    @classmethod
    def magsac(cls: Type[P], **fields: Any) -> P:
        """Returns the options of MAGSAC: uniform samples; score, termination and fits are marginalized over the noise scale."""
        return cls._preset("magsac", fields)

    @classmethod
    def magsacPlusPlus(cls: Type[P], **fields: Any) -> P:
        """Returns the preset of USACV20_MAGSAC: P-NAPSAC samples, SPRT, the robust loss of MAGSAC++ and re-weighted fits."""
        return cls._preset("magsacPlusPlus", fields)


_FIELDS = tuple(name for name, value in vars(Params).items() if isinstance(value, Field))


def _same(value: Any, other: Any) -> bool:
    if isinstance(value, np.ndarray):
        return np.array_equal(value, other, equal_nan=True)
    return bool(value == other or (value != value and other != other))


def _shown(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return "<{} values>".format(len(value))
    if isinstance(value, enum.IntFlag):
        return "|".join(str(bit.name) for bit in type(value) if bit & value) or "0"
    return str(getattr(value, "name", None) or repr(value))


def optionsOf(params: Any, name: str = "params", count: Optional[int] = None) -> Any:
    """Returns the options as an object of the compiled part; None as `params` means the defaults. Raises
    usacv20.error if sigmas were assigned in rows, but not in `count` rows; None as `count`: this is not checked."""
    if params is None:
        return native.Params()
    if not isinstance(params, Params):
        raise fail("{}: a {} is expected, not {!r}".format(name, Params.__module__ + ".Params", type(params).__name__))
    if count is not None:
        checkRows(params, count)
    return params._prepared()


def checkRows(params: Optional[Params], count: int, prefix: str = "") -> None:
    """Raises usacv20.error, whose message begins with `prefix`, if sigmas were assigned in rows, but not in `count` rows."""
    if params is not None:
        params._checkRows(count, prefix)


Params.__module__ = __name__.rpartition(".")[0]
_restored.__module__ = __name__
UsacParams = Params  # the same class by another name
