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
from ._params import Params, optionsOf
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
    """The rules of estimateTwoViewGeometry in addition to the options of a search. The defaults are
    those of COLMAP, except inlierRatio."""

    minInliers: int = 15  # least number of inliers of an accepted model; >= 1
    # Least expected inlier ratio, 0..1: the limit of samples is chosen so that a pair with this
    # ratio is found with Params.confidence. Pairs with a lower ratio may be missed.
    inlierRatio: float = 0.25
    # Inlier ratios of some pairs of the same collection, each above 0 and up to 1. If given, the
    # confidence refers to a right pair of this collection, see samples(). Empty: unknown.
    ratios: Tuple[float, ...] = ()
    planarRatio: float = 0.8  # 0..1; if a homography has more than this fraction of the inliers, the pair is planar or panoramic
    calibrationRatio: float = 0.95  # 0..1; if E has less than this fraction of F's inliers, the focal lengths are taken as wrong

    def check(self) -> None:
        """Raises usacv20.error, which names the field, if a value is wrong."""
        self._native.check()

    def samples(self, params: Params, sampleSize: int, matches: int) -> int:
        """Returns the number of samples needed to find a pair that must be kept; at least 500.
        params.maxIterations is ignored.

        params -- its confidence is used, and whether its local optimization is that of USACV20
        sampleSize -- points of a minimal sample: 5 for E, 7 for F, 4 for H
        matches -- number of matches of the pair

        Samples are drawn without replacement: with I inliers among N matches, a fraction C(I, m) /
        C(N, m) of the samples of m matches consists of inliers. I is inlierRatio times N, but at
        least minInliers. If `ratios` are given, the confidence is the mean over these k ratios and
        one further pair. That pair stands for pairs with a lower ratio than all others, which have
        a probability of 1 / (k + 1); its ratio is uniform between inlierRatio and the least of
        `ratios`. For E and F a sample of USACV20 counts as up to four samples, because models are
        also found from samples with an outlier."""
        return int(self._native.samples(optionsOf(params), sampleSize, matches))

    def reached(self, params: Params, sampleSize: int, matches: int) -> float:
        """Returns the probability, 0..1, that a pair is found if its inlier ratio is inlierRatio. The
        number of samples is samples(), but at most params.maxIterations."""
        return float(self._native.reached(optionsOf(params), sampleSize, matches))

    @property
    def _native(self) -> Any:
        rules = native.TwoViewRules()
        rules.minInliers = _arguments.integer(self.minInliers, "minInliers")
        for name in ("inlierRatio", "planarRatio", "calibrationRatio"):
            setattr(rules, name, _arguments.real(getattr(self, name), name))
        rules.ratios = [_arguments.real(ratio, "ratios") for ratio in self.ratios]
        return rules


class TwoViewPair(typing.NamedTuple):
    """The matches of two images and the known parameters of their cameras."""

    points1: npt.ArrayLike  # N points of image 1 in pixels, as for estimateHomography
    points2: npt.ArrayLike  # the N corresponding points of image 2
    cameraMatrix1: _Optional = None  # 3x3; None: the focal length of image 1 is unknown
    cameraMatrix2: _Optional = None  # likewise of image 2; needed even if both images have the same camera
    distCoeffs1: _Optional = None  # 4, 5, 8, 12 or 14 coefficients of camera 1, which need cameraMatrix1; None: none
    distCoeffs2: _Optional = None
    imageSize1: _Size = None  # width and height of image 1 in pixels; None: unknown, so watermarks are not detected
    imageSize2: _Size = None
    taken1: _Optional = None  # points of image 1 with distortion, for watermarks, if points1 are undistorted; None: points1
    taken2: _Optional = None
    scores: _Optional = None  # of the matches, used instead of Params.scores so that pairs can share Params; None: Params.scores


class TwoViewGeometry(typing.NamedTuple):
    """The result for a pair of images. Arrays are of float64, or None if unknown. Pixels are
    without distortion."""

    configuration: TwoViewConfiguration
    mask: npt.NDArray[np.uint8]  # N x 1; 1: an inlier of E if there is E, otherwise of F, otherwise of H
    inliers: int  # number of inliers in the mask
    F: _Double  # 3x3, x2^T F x1 = 0 in pixels, unit norm
    E: _Double  # 3x3, in normalized image planes, singular values (1, 1, 0)/sqrt(2); None if the mask is not that of E
    H: _Double  # 3x3, maps pixels of image 1 to image 2, h33 = 1; None if it has fewer than minInliers inliers
    # 3x3, X2 = R X1 + t, for CALIBRATED, PLANAR and PANORAMIC pairs, and for a watermark if the
    # cameras are calibrated. For a plane it may be one of two equally possible motions, if no
    # matches off the plane select one.
    R: _Double
    t: _Double  # 3x1, unit length; 0 for a pure rotation
    rotations: _Double  # k x 3 x 3, the rotations that agree with the matches, if the focal lengths are known
    report: Report  # of the search for the model of the mask, or for the best refused model
    iterations: int  # number of samples drawn, without those for H among the inliers of E or F
    milliseconds: float  # wall time
    reason: str  # the reason if there are no inliers, one line without a period; empty if there are inliers


def _size(size: Any, name: str) -> Any:
    if size is None:
        return None
    try:
        width, height = size
    except (TypeError, ValueError):
        raise fail("{}: (width, height) is expected, not {}".format(name, _arguments.shown(size))) from None
    return _arguments.integer(width, name, low=0), _arguments.integer(height, name, low=0)


def _read(pair: TwoViewPair, prefix: str) -> Tuple[Any, ...]:
    """Returns the arguments of a pair in the order of the compiled part."""
    scores = None if pair.scores is None else np.ravel(_arguments.array(pair.scores, prefix + "scores")).astype(np.float32)
    return (*(_arguments.points(getattr(pair, name), prefix + name) for name in _POINTS),
            *(_arguments.optionalArray(getattr(pair, name), prefix + name) for name in _ARRAYS),
            _size(pair.imageSize1, prefix + "imageSize1"), _size(pair.imageSize2, prefix + "imageSize2"),
            _arguments.optionalArray(pair.taken1, prefix + "taken1"), _arguments.optionalArray(pair.taken2, prefix + "taken2"), scores)


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
    cameraMatrix1, cameraMatrix2 -- 3x3, for each image separately; None: its focal length is
    unknown
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 coefficients as for cv2.undistortPoints, which
    need the matrix; None: none
    params -- Params of each search. threshold is the Sampson distance of E and F in pixels without
    distortion; that of H is derived from it. significance 0 means 1e-4; initialModel and sigmas have to be
    empty. THRESHOLD_ESTIMATED: the first accepted model sets the threshold of the pair,
    report.threshold
    rules -- TwoViewRules; None: the defaults
    imageSize1, imageSize2 -- (width, height) in pixels; None: watermarks are not detected

    Returns a TwoViewGeometry: configuration, mask, F, E, H, R, t and a report; if a pair is
    refused, `reason` says why.

    If both focal lengths are known, an essential matrix E is estimated, and a fundamental matrix F
    starting from E; otherwise F only. If E is refused, F is searched for with 500 samples and must
    pass the square of the significance. If F shows that the focal lengths are wrong, E is tried
    once more, starting from F. H is estimated from the inliers, or from all matches if there are
    none. A pair is CALIBRATED if E has at least rules.calibrationRatio of F's inliers, not counting
    those that F gains by chance, or if most inliers are on a plane. usacv20.error names a wrong
    argument."""
    pair = TwoViewPair(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2, imageSize1, imageSize2)
    return _geometry(native.estimateTwoViewGeometry(_read(pair, ""), optionsOf(params), _rules(rules)))


def estimateTwoViewGeometries(pairs: typing.Iterable[TwoViewPair], params: Optional[Params] = None,
                              rules: Optional[TwoViewRules] = None, threads: int = 0,
                              returnExceptions: bool = False) -> List[Union[TwoViewGeometry, Exception]]:
    """Calls estimateTwoViewGeometry for many pairs, in parallel in C++.

    pairs -- TwoViewPair(points1, points2, ...), of any sizes, with or without cameras
    params, rules -- for all pairs; scores are those of the pairs
    threads -- number of pairs at once, 0: all cores. The result does not depend on it
    returnExceptions -- what happens if a pair is wrong. True: its exception replaces its result;
    False: the exception is raised after all pairs are done, and names the pair

    Returns a list with a TwoViewGeometry for each pair, in the same order. The interpreter's lock
    is released during the call."""
    mistakes = {}
    read = []
    for i, pair in enumerate(pairs):
        try:
            read.append(_read(TwoViewPair(*pair), "pairs[{}].".format(i)))
        except Exception as mistake:
            if not returnExceptions:
                raise
            mistakes[i] = mistake
            read.append((NO_POINTS, NO_POINTS) + (None,) * 9)
    results: List[Union[TwoViewGeometry, Exception]] = []
    for i, found in enumerate(native.estimateTwoViewGeometries(read, optionsOf(params), _rules(rules),
                                                               _arguments.integer(threads, "threads", low=0))):
        wrong = mistakes.get(i) or (fail("pairs[{}]: {}".format(i, found[-1])) if found[-1] else None)
        if wrong is not None and not returnExceptions:
            raise wrong
        results.append(_geometry(found) if wrong is None else wrong)
    return results


for _type in (TwoViewRules, TwoViewPair, TwoViewGeometry):
    _type.__module__ = __name__.rpartition(".")[0]
