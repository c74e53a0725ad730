# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimation of the relation between two images from their matches."""

from __future__ import annotations

import dataclasses
import typing
from typing import TYPE_CHECKING, Any, List, Optional, Tuple, Union

import numpy as np

from . import _arguments
from ._backend import native
from ._enumerations import TwoViewConfiguration
from ._errors import fail
from ._estimate import NO_POINTS
from ._params import Params, checkRows, optionsOf
from ._report import Report

if TYPE_CHECKING:
    import numpy.typing as npt

    _Double = Optional[npt.NDArray[np.float64]]
    _Optional = Optional[npt.ArrayLike]
    _Size = Optional[Tuple[int, int]]

_POINTS = ("points1", "points2")
_ARRAYS = ("cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2")


@dataclasses.dataclass(frozen=True)
class TwoViewRules:
    """The rules by which estimateTwoViewGeometry accepts models and chooses a configuration. The
    defaults are those of COLMAP."""

    minInliers: int = 15  # minimum number of inliers of an accepted model; >= 1
    # Smallest expected inlier ratio, 0..1. The maximum number of samples is chosen so that the
    # model of a pair with this ratio is found with probability Params.confidence. Models of pairs
    # with a smaller ratio can be found, too, but less reliably.
    inlierRatio: float = 0.25
    # Inlier ratios of some image pairs of the same collection, each above 0 and at most 1.
    # Params.confidence is then the probability that the model of a pair is found, averaged over
    # pairs with these ratios, see samples(). Empty: the ratios are unknown.
    ratios: Tuple[float, ...] = ()
    # The pair is planar or panoramic if more than this fraction of the inliers of the accepted model
    # are also inliers of a homography; 0..1.
    planarRatio: float = 0.8
    # The focal lengths are considered wrong if the number of inliers of E is clearly less than this
    # fraction of the number of inliers of F, see estimateTwoViewGeometry; 0..1.
    calibrationRatio: float = 0.95

    def check(self) -> None:
        """Raises usacv20.error, whose message names the first invalid field, if there is one."""
        self._native.check()

    def samples(self, params: Params, sampleSize: int, matches: int) -> int:
        """Returns the number of samples needed to find the model of an acceptable pair, at least
        500, regardless of params.maxIterations.

        params -- options, of which only `confidence` matters, and whether sampler, score, local
        optimization and polishing are those of USACV20
        sampleSize -- number of points in a sample: 5 for E, 7 for F, 4 for H
        matches -- number of matches of the pair

        Samples are drawn without replacement: with I inliers among N matches, a sample of m points
        consists of inliers with probability C(I, m) / C(N, m). I is inlierRatio times N, rounded up,
        but at least minInliers. With k `ratios`, the confidence is met on average over k pairs with
        these ratios and one more pair, whose ratio is uniformly distributed between inlierRatio and
        the smallest of `ratios`. The additional pair has the weight 1 / (k + 1), which is the
        probability that a new pair has a smaller ratio than k others. For E and F with these options
        of USACV20, a sample counts as up to four samples, because models are also found from samples
        with an outlier."""
        return int(self._native.samples(optionsOf(params), sampleSize, matches))

    def reached(self, params: Params, sampleSize: int, matches: int) -> float:
        """Returns the probability, 0..1, that the model of a pair is found if its inlier ratio is
        inlierRatio. The number of samples is samples(), but at most params.maxIterations. The
        arguments are those of samples()."""
        return float(self._native.reached(optionsOf(params), sampleSize, matches))

    @property
    def _native(self) -> Any:
        rules = native.TwoViewRules()
        rules.minInliers = _arguments.integer(self.minInliers, "minInliers")
        for name in ("inlierRatio", "planarRatio", "calibrationRatio"):
            setattr(rules, name, _arguments.real(getattr(self, name), name))
        rules.ratios = [_arguments.real(ratio, "ratios") for ratio in _arguments.elements(self.ratios, "ratios", "a list of numbers")]
        return rules


class TwoViewPair(typing.NamedTuple):
    """The input of estimateTwoViewGeometry: the matches of two images and, if known, their cameras.
    """

    points1: npt.ArrayLike  # N points of image 1 in pixels, as for estimateHomography
    points2: npt.ArrayLike  # their N counterparts in image 2
    cameraMatrix1: _Optional = None  # 3x3; None: the focal length of image 1 is unknown
    cameraMatrix2: _Optional = None  # the same for image 2; it is not copied from image 1, even if the camera is the same
    distCoeffs1: _Optional = None  # 4, 5, 8, 12 or 14 coefficients of camera 1; they require cameraMatrix1; None: no distortion
    distCoeffs2: _Optional = None  # the same for camera 2
    imageSize1: _Size = None  # width and height of image 1 in pixels; None: unknown, and watermarks are not detected
    imageSize2: _Size = None  # the same for image 2
    # Original (distorted) points of image 1, if points1 have been undistorted. They are used for the
    # detection of watermarks; None: points1 are used.
    taken1: _Optional = None
    taken2: _Optional = None  # the same for image 2
    # N scores of the matches, used instead of Params.scores, so that pairs can share their Params.
    # None: Params.scores.
    scores: _Optional = None
    # N standard deviations of the errors of the matches, used instead of Params.sigmas. None:
    # Params.sigmas, which must not be covariances.
    sigmas: _Optional = None


class TwoViewGeometry(typing.NamedTuple):
    """The result for a pair of images. Matrices are arrays of float64, and None if they were not
    determined. F and H refer to undistorted pixels."""

    configuration: TwoViewConfiguration
    # N x 1, 1 for inliers of the accepted model: E, F or H. 0 x 1 if the call was stopped before it began this pair.
    mask: npt.NDArray[np.uint8]
    inliers: int  # number of inliers in the mask
    F: _Double  # 3x3, x2^T F x1 = 0 in pixels, unit Frobenius norm
    E: _Double  # 3x3, for normalized image planes, singular values (1, 1, 0)/sqrt(2); set if `mask` marks the inliers of E
    # 3x3, maps pixels of image 1 to image 2, h33 = 1; set if at least minInliers of the inliers in
    # `mask` are inliers of H.
    H: _Double
    # 3x3, X2 = R X1 + t; set if E is set (planar pair: of the two motions compatible with the plane
    # the one that estimateRelativePose prefers), or if the camera only rotates
    # (TWO_VIEW_PANORAMIC). None for a planar pair of which only H was accepted, see `rotations`.
    R: _Double
    t: _Double  # the translation that belongs to R, 3x1, unit length; 0 for a pure rotation
    # k x 3 x 3: for cameras with known focal lengths, the k rotations compatible with the matches; if
    # the matches are correct, one of the rotations is the true one.
    rotations: _Double
    report: Report  # report on the search for the model of the mask, or for the best rejected model
    iterations: int  # number of samples drawn, not counting those from which H was estimated among the inliers of E or F
    milliseconds: float  # elapsed time
    reason: str  # the reason why there are no inliers, one line without a period; empty if there are inliers


def _size(size: Any, name: str) -> Any:
    if size is None:
        return None
    try:
        width, height = size
    except (TypeError, ValueError):
        raise fail("{}: (width, height) is expected, not {}".format(name, _arguments.shown(size))) from None
    return _arguments.integer(width, name, low=0), _arguments.integer(height, name, low=0)


def _numbers(given: Any, name: str) -> Any:
    if given is None:
        return None
    numbers = _arguments.array(given, name)
    if not _arguments.isList(numbers):
        raise fail("{}: N numbers are expected, N x 1 or 1 x N, not the shape {}".format(name, numbers.shape))
    return np.ravel(numbers).astype(np.float32)


def _read(pair: TwoViewPair, place: str, params: Optional[Params]) -> Tuple[Any, ...]:
    """Returns the converted fields of a pair in the order that the compiled part expects. `place` names the pair in messages,
    for example pairs[3]; empty: the fields are arguments of the called function, and messages name only the argument."""
    prefix = place + "." if place else ""
    scores, sigmas = _numbers(pair.scores, prefix + "scores"), _numbers(pair.sigmas, prefix + "sigmas")
    taken = (None if given is None else _arguments.points(given, prefix + name)
             for given, name in ((pair.taken1, "taken1"), (pair.taken2, "taken2")))
    points = [_arguments.points(getattr(pair, name), prefix + name) for name in _POINTS]
    if sigmas is None or sigmas.size == 0:
        checkRows(params, _arguments.count(points[0]), place + ": " if place else "")
    return (*points,
            *(_arguments.optionalArray(getattr(pair, name), prefix + name) for name in _ARRAYS),
            _size(pair.imageSize1, prefix + "imageSize1"), _size(pair.imageSize2, prefix + "imageSize2"),
            *taken, scores, sigmas)


def _pairOf(value: Any, name: str) -> TwoViewPair:
    given = tuple(_arguments.elements(value, name, "a TwoViewPair"))
    if not len(_POINTS) <= len(given) <= len(TwoViewPair._fields):
        raise fail("{}: a TwoViewPair is expected, not {} values".format(name, len(given)))
    return TwoViewPair(*given)


def _rules(rules: Optional[TwoViewRules]) -> Any:
    if rules is not None and not isinstance(rules, TwoViewRules):
        raise fail("rules: a TwoViewRules is expected, not {}".format(_arguments.shown(rules)))
    return (TwoViewRules() if rules is None else rules)._native


def _geometry(found: Any) -> TwoViewGeometry:
    configuration, mask, inliers, F, E, H, R, t, rotations, report, iterations, milliseconds, reason, _ = found
    return TwoViewGeometry(TwoViewConfiguration(configuration), NO_POINTS.copy() if mask is None else mask, inliers, F, E, H, R, t,
                           None if rotations is None else rotations.reshape(-1, 3, 3), Report._of(report), iterations, milliseconds,
                           reason)


def estimateTwoViewGeometry(points1: npt.ArrayLike, points2: npt.ArrayLike, cameraMatrix1: _Optional = None,
                            cameraMatrix2: _Optional = None, distCoeffs1: _Optional = None, distCoeffs2: _Optional = None,
                            params: Optional[Params] = None, rules: Optional[TwoViewRules] = None, *, imageSize1: _Size = None,
                            imageSize2: _Size = None) -> TwoViewGeometry:
    """Determines the relation between two images from their matches, as one of COLMAP's
    configurations.

    points1, points2 -- N points of each image in pixels, as for estimateHomography
    cameraMatrix1, cameraMatrix2 -- 3x3, for each image separately; None: the focal length of this
    image is unknown
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 coefficients as for cv2.undistortPoints, which
    require the camera matrix; None: no distortion
    params -- Params of each search. `threshold` is the Sampson distance of E and F in undistorted
    pixels; the threshold of H is derived from it. `significance` 0 means 1e-4 here. `initialModel`
    must be empty, and `quality` must not be QUALITY_LMEDS, which chooses a threshold for each model:
    E, F and H are compared at one threshold. With sigmas, thresholds and errors are multiples of the
    sigma of each match. With THRESHOLD_ESTIMATED, the threshold of the pair is report.threshold of
    the first accepted model (divided by 1.77 if this model is H)
    rules -- TwoViewRules; None: the defaults
    imageSize1, imageSize2 -- (width, height) in pixels; None: watermarks are not detected

    Returns a TwoViewGeometry: configuration, mask, F, E, H, R, t and a report. If no model is
    accepted, its field `reason` gives the reason.

    If both focal lengths are known, an essential matrix E is estimated, and then a fundamental
    matrix F starting from E; otherwise only F. If E is rejected, F is searched for with 500
    samples, and its report.chance must be at most the square of params.significance. If F is
    accepted, and E is rejected or has clearly fewer inliers, E is estimated once more, starting from
    F. H is estimated from the inliers of E (of F if E was rejected) or, if both were rejected, from
    all matches. The focal lengths are rejected if all of the following hold: the number of inliers
    of E is clearly less than rules.calibrationRatio times that of F; hardly any inliers of E are
    outliers of F; the inliers of both have hardly larger errors under F than under E; if most
    inliers of E are on a plane, the additional inliers of F are not due to chance. An invalid
    argument raises usacv20.error, whose message names the argument."""
    pair = TwoViewPair(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2, imageSize1, imageSize2)
    options = optionsOf(params)
    return _geometry(native.estimateTwoViewGeometry(_read(pair, "", params), options, _rules(rules)))


def estimateTwoViewGeometries(pairs: typing.Iterable[TwoViewPair], params: Optional[Params] = None,
                              rules: Optional[TwoViewRules] = None, threads: int = 0,
                              returnExceptions: bool = False) -> List[Union[TwoViewGeometry, Exception]]:
    """Calls estimateTwoViewGeometry for many pairs, in parallel in C++.

    pairs -- TwoViewPair(points1, points2, ...); the numbers of matches can differ, and pairs with
    and without cameras can be mixed
    params, rules -- for all pairs; `scores` and `sigmas` of a pair, if any, are used instead of those of params
    threads -- number of pairs that are processed at once, at most the number of OpenCV's threads; 0:
    the number of OpenCV's threads. The results do not depend on this number
    returnExceptions -- what happens if the estimation of a pair raises an exception. True: the
    exception replaces the result of this pair. False: the exception of one such pair is raised and
    names the pair

    Returns a list with a TwoViewGeometry for each pair, in the same order. The global interpreter
    lock is released during the call."""
    options = optionsOf(params)
    mistakes = {}
    read = []
    for i, pair in enumerate(_arguments.elements(pairs, "pairs", "a list of TwoViewPair")):
        try:
            place = "pairs[{}]".format(i)
            read.append(_read(_pairOf(pair, place), place, params))
        except Exception as mistake:
            if not returnExceptions:
                raise
            mistakes[i] = mistake
            read.append((NO_POINTS, NO_POINTS) + (None,) * (len(TwoViewPair._fields) - 2))
    results: List[Union[TwoViewGeometry, Exception]] = []
    for i, found in enumerate(native.estimateTwoViewGeometries(read, options, _rules(rules),
                                                               _arguments.integer(threads, "threads", low=0))):
        wrong = mistakes.get(i) or (fail("pairs[{}]: {}".format(i, found[-1])) if found[-1] else None)
        if wrong is not None and not returnExceptions:
            raise wrong
        results.append(_geometry(found) if wrong is None else wrong)
    return results


for _type in (TwoViewRules, TwoViewPair, TwoViewGeometry):
    _type.__module__ = __name__.rpartition(".")[0]
del _type
