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
    """The rules of estimateTwoViewGeometry beside the options of a search. The defaults are COLMAP's but for inlierRatio."""

    minInliers: int = 15  # of a model that counts, at least; >= 1
    # Least part of the matches that is expected to be right, 0..1: no more samples are drawn than find such a pair with
    # Params.confidence. Pairs with less are found, too, but not all.
    inlierRatio: float = 0.25
    # Parts of the matches that are right in some pairs of the same collection, each above 0 and up to 1: the confidence is then
    # that of a right pair of this collection, see samples(). None of them: not known.
    ratios: Tuple[float, ...] = ()
    planarRatio: float = 0.8  # 0..1, of the inliers; a homography with more of them makes the pair planar or panoramic
    calibrationRatio: float = 0.95  # 0..1; E with less of F's inliers tells that the focal lengths are wrong

    def check(self) -> None:
        """Raises usacv20.error, which names the field, if a value is wrong."""
        self._native.check()

    def samples(self, params: Params, sampleSize: int, matches: int) -> int:
        """Returns the number of samples that find a pair that is to be kept, whatever params.maxIterations says; at least 500.

        params -- its confidence counts, and whether its local optimization is that of USACV20
        sampleSize -- points of a sample: 5 for E, 7 for F, 4 for H
        matches -- of the pair

        Samples are drawn without replacement: of I right ones among N matches the part C(I, m) / C(N, m) is right. I is
        inlierRatio of N, but minInliers or more. With ratios the mean over those and one pair more has the confidence: that one
        has any ratio between inlierRatio and the least of them, as a pair is worse than all of k others with a chance of
        1 / (k + 1). Of E a sample of USACV20 counts as up to four, as its local optimization makes a model of one with a wrong
        point, too."""
        return int(self._native.samples(optionsOf(params), sampleSize, matches))

    def reached(self, params: Params, sampleSize: int, matches: int) -> float:
        """Returns the probability, 0..1, that one of these samples, but not more than params.maxIterations, is right, if a part inlierRatio
        of the matches is."""
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
    """The matches of two images, and what is known of their cameras."""

    points1: npt.ArrayLike  # N points of image 1 in pixels, as for estimateHomography
    points2: npt.ArrayLike  # their N counterparts in image 2
    cameraMatrix1: _Optional = None  # 3x3; None: the focal length of image 1 is not known
    cameraMatrix2: _Optional = None  # the same of image 2, also if it is the same camera
    distCoeffs1: _Optional = None  # 4, 5, 8, 12 or 14 coefficients of camera 1, which need cameraMatrix1; None: none
    distCoeffs2: _Optional = None
    imageSize1: _Size = None  # width and height of image 1 in pixels; None: not known, and no watermark is looked for
    imageSize2: _Size = None
    taken1: _Optional = None  # points of image 1 as taken, if points1 have no distortion any more, for watermarks; None: points1
    taken2: _Optional = None
    scores: _Optional = None  # of the matches, instead of Params.scores, so that pairs share Params; None: Params.scores


class TwoViewGeometry(typing.NamedTuple):
    """The result for a pair of images. Arrays are of float64, and None where they are not known; pixels are those without distortion."""

    configuration: TwoViewConfiguration
    mask: npt.NDArray[np.uint8]  # N x 1; 1: an inlier of E, else of F, else of H
    inliers: int  # how many these are
    F: _Double  # 3x3, x2^T F x1 = 0 in pixels, unit norm
    E: _Double  # 3x3, of image planes, singular values (1, 1, 0)/sqrt(2), where the essential matrix tells the inliers
    H: _Double  # 3x3, pixels of image 1 to image 2, h33 = 1, of at least minInliers of the inliers
    # 3x3, X2 = R X1 + t, of CALIBRATED, PLANAR and PANORAMIC pairs (of a plane one of two motions that see it alike, unless matches
    # off it decide), and of a watermark of calibrated cameras
    R: _Double
    t: _Double  # 3x1, unit length; 0 where the camera has only turned
    rotations: _Double  # k x 3 x 3, of cameras whose focal lengths are given: those that the matches allow
    report: Report  # of the search for the model that tells the inliers, or for the best one that was refused
    iterations: int  # samples drawn, except for H among the inliers of E or F
    milliseconds: float  # of the clock
    reason: str  # why there are no inliers, one line without a period; empty: there are


def _size(size: Any, name: str) -> Any:
    if size is None:
        return None
    try:
        width, height = size
    except (TypeError, ValueError):
        raise fail("{}: (width, height) is expected, not {}".format(name, _arguments.shown(size))) from None
    return _arguments.integer(width, name, low=0), _arguments.integer(height, name, low=0)


def _read(pair: TwoViewPair, prefix: str) -> Tuple[Any, ...]:
    """Returns the arguments in the order of the compiled part."""
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
    """Determines the relation between two images from their matches, as one of COLMAP's configurations.

    points1, points2 -- N points of each image in pixels, as for estimateHomography
    cameraMatrix1, cameraMatrix2 -- 3x3, of each image by itself; None: its focal length is not known
    distCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 coefficients as for cv2.undistortPoints, which need the matrix; None: none
    params -- Params of each search. threshold is the Sampson distance of E and F in pixels without distortion, from which that of
        H follows; significance 0: 1e-4; initialModel has to be empty. THRESHOLD_ESTIMATED: the first model that is accepted sets
        the threshold of the pair, report.threshold
    rules -- TwoViewRules; None: the defaults
    imageSize1, imageSize2 -- (width, height) in pixels; None: no watermark is looked for

    Returns a TwoViewGeometry: configuration, mask, F, E, H, R, t and a report; if a pair is refused, `reason` says why.

    An essential matrix E is estimated where both focal lengths are known, else a fundamental matrix F; with E, F starts from it.
    Where E is refused F is searched for in 500 samples, and the square of the significance is asked of it. Where F tells that the
    focal lengths are wrong E is tried once more, from F. H is estimated of the inliers, else of all matches. CALIBRATED: E has
    rules.calibrationRatio of F's inliers, but for what F wins by chance, or most are on a plane. usacv20.error names an argument
    that is wrong."""
    pair = TwoViewPair(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2, imageSize1, imageSize2)
    return _geometry(native.estimateTwoViewGeometry(_read(pair, ""), optionsOf(params), _rules(rules)))


def estimateTwoViewGeometries(pairs: typing.Iterable[TwoViewPair], params: Optional[Params] = None,
                              rules: Optional[TwoViewRules] = None, threads: int = 0,
                              returnExceptions: bool = False) -> List[Union[TwoViewGeometry, Exception]]:
    """Calls estimateTwoViewGeometry for many pairs, in parallel in C++.

    pairs -- TwoViewPair(points1, points2, ...), of any sizes, with and without cameras, mixed
    params, rules -- of all pairs; scores are those of the pairs
    threads -- how many pairs at once, 0: all cores. The result does not depend on it
    returnExceptions -- a mistake in a pair: True: its exception stands in the place of the result, the others go on; False: it is
        raised when all are done, and names the pair

    Returns a list with a TwoViewGeometry for each pair, in this order. The interpreter's lock is released meanwhile."""
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
