# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""What two images are to each other: the rules that turn estimated models into a configuration.

The rules are COLMAP's, with differences that are marked (*).

1. An essential matrix E is estimated where both focal lengths are known, else a fundamental matrix F. With a significant E (see
   Params.significance) of at least `minInliers` inliers F starts from E (*), else it is searched for, too; where E was refused,
   though the focal lengths are known, in few samples, and the square of the significance is asked of it (*).
2. A homography H is estimated from the inliers of E, else of F (*). Its error has two coordinates and the noise of both images,
   that of E and F one coordinate, so that H's threshold is sqrt(2 5.991 / 3.841) = 1.77 times theirs: as much of the right
   matches, 0.95, is within it @cite hartley2003multiple (table 4.2) (*). From afar to near H magnifies the noise, so it is
   estimated towards the image with the smaller part of the scene's picture, and its inliers are counted by the Sampson distance,
   with sqrt(5.991 / 3.841) times the threshold (*). With more than `planarRatio` of them the scene is a plane,
   or the camera has only turned. Where there is neither E nor F, H is estimated from all matches.
3. CALIBRATED: E has at least `calibrationRatio` of the inliers of F, but for the two matches that F's two degrees of freedom
   more can win from any points, or H has more than `planarRatio` of E's (*): with a plane F can choose an epipole that suits
   wrong matches, and its surplus tells nothing of the focal lengths. UNCALIBRATED: F has at least `minInliers`, and E has not,
   or too few, even one that starts from F (*).
   PLANAR_OR_PANORAMIC: H explains as much as said in 2. Of cameras whose focal lengths are known a rotation is fitted to H's
   inliers (*): PANORAMIC if it has more than `planarRatio` of E's, else PLANAR.
4. WATERMARK: at least 0.7 of the inliers lie in the border of both images, a tenth of the diagonal wide, and have one and the
   same motion there.
5. DEGENERATE: none of these, or less than `minInliers`.

The inliers are those of E or F, as H's are among them. The pose is known for CALIBRATED, PLANAR and PANORAMIC pairs; it is that
of E but for a PANORAMIC pair, which has a rotation only. Of a PLANAR pair it is one of the two motions that see a plane alike
@cite longuet1986reconstruction, unless matches off the plane decide."""

from __future__ import annotations

import dataclasses
import math
import typing
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from .._batch import estimateEssentials, estimateFundamentals, estimateHomographies
from .._enumerations import StopReason
from .._params import Params
from .._report import Report
from ._distances import area, mapDistances, sampsonDistances
from ._pair import Configuration, Pair, TwoView, View
from ._poses import directions, essentialOf, motionOfEssential, quaternion, rotation, rotationsOfPlane
from ._settings import LEAST_ITERATIONS, Settings

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]
    _Mask = npt.NDArray[np.bool_]

_SAMPLE = {"E": 5, "F": 7, "H": 4}  # points of a minimal sample
# F has seven degrees of freedom, E five: each more can be spent on a match, right or wrong.
_FREEDOM_MORE = 2
# F where E was refused, though the focal lengths are known, tells that these are wrong: what is asked of it is the significance to
# this power, 10^-8 by default, and it is searched for in LEAST_ITERATIONS samples only.
_ALONE = 2
_DEVIATIONS = 3  # of a count: one in a thousand is larger by chance
# F that starts from E draws as good as no samples of its own: its local optimization does the work.
_ITERATIONS_FROM_E = 10
# An H with most of the points is found within 17 samples with a chance of 1 - 10^-4 (0.8^4 of the samples are right).
_ITERATIONS_IN_INLIERS = 100
# Parts of the threshold, see 2.: of an error in one image, of the distance in both.
_PLANAR_REACH, _PLANAR_DISTANCE = (2 * 5.991 / 3.841)**0.5, (5.991 / 3.841)**0.5
# As COLMAP has them: the border as part of the diagonal, and the part of the inliers that make a watermark.
_BORDER, _WATERMARK = 0.1, 0.7


class _Model(typing.NamedTuple):
    """A model of one pair and what it explains."""

    matrix: _Array
    mask: _Mask  # of all matches
    report: Report

    @property
    def inliers(self) -> int:
        return int(np.count_nonzero(self.mask))


class _Work:
    """One pair on its way through the rules."""

    def __init__(self, pair: Pair) -> None:
        self.pair = pair
        self.models: Dict[str, _Model] = {}
        self.iterations = 0
        self.milliseconds = 0.0
        self.chance = 1.0  # of the best model that was refused
        self.reason = ""
        self.limited: List[str] = []  # models whose search the limit of the samples has ended before its confidence
        self.mistake = ""

    @property
    def calibrated(self) -> bool:
        return self.pair.first.focalKnown and self.pair.second.focalKnown

    def take(self, name: str, result: Any, settings: Settings, among: Optional[_Mask] = None) -> None:
        """What a batch has returned for this pair; `among`: the matches that it was given."""
        if isinstance(result, Exception):
            self.mistake = str(result).strip().splitlines()[-1]
            return
        matrix, mask, report = result
        self.iterations += report.iterations
        self.milliseconds += report.setupMs + report.searchMs + report.localMs + report.polishMs
        found = mask.ravel() != 0
        if among is not None:
            whole = np.zeros(len(among), bool)
            whole[among] = found
            found = whole
        model = None if matrix is None else _Model(matrix, found, report)
        if model is not None and model.inliers >= settings.minInliers:
            self.models[name] = model
        elif among is None:
            why = _why(report) if model is None else "{} inliers, {} are needed".format(model.inliers, settings.minInliers)
            if not self.reason or report.chance < self.chance:  # both are of the best model that was refused
                self.reason, self.chance = "{}: {}".format(name, why), min(report.chance, 1.0)
            self._limit(name, report.iterations, settings)

    def _limit(self, name: str, drawn: int, settings: Settings) -> None:
        sample, matches = _SAMPLE[name], len(self.pair.matches)
        if drawn >= settings.maxIterations < settings.needed(sample, matches):
            # Rounded down, so that it never looks like the one that was asked for.
            self.limited.append("{:g} for {}".format(math.floor(1e4 * settings.reached(sample, matches)) / 1e4, name))


def _why(report: Report) -> str:
    """There is no model."""
    if report.stop == StopReason.STOP_NOT_SIGNIFICANT:
        return "random matches would give as good a model with a chance of {:.2g}".format(report.chance)
    return report.stop.name[len("STOP_"):].lower().replace("_", " ")


def verifyPairs(pairs: typing.Sequence[Pair], settings: Settings) -> List[TwoView]:
    """The two-view geometry of each pair, in their order. A result depends on its pair and the settings only."""
    works = [_Work(pair) for pair in pairs]
    enough = [work for work in works if len(work.pair.matches) >= settings.leastMatches]
    _estimateEpipolar("E", [work for work in enough if work.calibrated], settings)
    _estimateEpipolar("F", enough, settings)
    _improveEssentials(enough, settings)
    _estimateHomographies(enough, settings)
    return [_result(work, settings) for work in works]


def _estimateEpipolar(name: str, works: List[_Work], settings: Settings) -> None:
    """E or F of many pairs, in one call of the package."""
    points1, points2 = [work.pair.first.points for work in works], [work.pair.second.points for work in works]
    params = _options(name, works, [None] * len(works), settings)
    if name == "E":
        results = estimateEssentials(points1, points2, [work.pair.first.matrix for work in works],
                                     [work.pair.second.matrix for work in works], params=params, threads=1, returnExceptions=True)
    else:
        results = estimateFundamentals(points1, points2, params, threads=1, returnExceptions=True)
    for work, result in zip(works, results):
        work.take(name, result, settings)


def _improveEssentials(works: List[_Work], settings: Settings) -> None:
    """Where F would tell that the focal lengths are wrong, the search of E may have missed what F has found: E starts from it."""
    chosen = [work for work in works if work.calibrated and "F" in work.models and _base(work, settings) is work.models["F"]]
    options = []
    for work in chosen:
        params = settings.params(work.pair)
        params.maxIterations = min(settings.maxIterations, _ITERATIONS_FROM_E)
        params.setInitialModel(essentialOf(work.models["F"].matrix, work.pair.first.matrix, work.pair.second.matrix))
        options.append(params)
    results = estimateEssentials([work.pair.first.points for work in chosen], [work.pair.second.points for work in chosen],
                                 [work.pair.first.matrix for work in chosen], [work.pair.second.matrix for work in chosen],
                                 params=options, threads=1, returnExceptions=True) if chosen else []
    for work, result in zip(chosen, results):
        before = work.models.get("E")
        found = None if isinstance(result, Exception) or result[0] is None else np.count_nonzero(result[1])
        if found is not None and (before is None or found > before.inliers):
            work.take("E", result, settings)


def _estimateHomographies(works: List[_Work], settings: Settings) -> None:
    """H of the matches that E or F explains, else of all, in one call of the package."""
    amongs = [_among(work) for work in works]
    sides = [(_rows(work.pair.first.points, among), _rows(work.pair.second.points, among)) for work, among in zip(works, amongs)]
    # H's error is measured in its second image: there the points are to be the nearer together.
    back = [among is not None and area(b) > area(a) for among, (a, b) in zip(amongs, sides)]
    results = estimateHomographies(
        [side[swapped] for side, swapped in zip(sides, back)], [side[not swapped] for side, swapped in zip(sides, back)],
        _options("H", works, amongs, dataclasses.replace(settings, threshold=_PLANAR_REACH * settings.threshold)),
        threads=1, returnExceptions=True)
    for work, result, among, (first, second), swapped in zip(works, results, amongs, sides, back):
        if not isinstance(result, Exception) and result[0] is not None and among is not None:
            H: Any = np.linalg.inv(result[0]) if swapped else result[0]
            mask = mapDistances(H, first, second) <= _PLANAR_DISTANCE * settings.threshold
            result = H / (H[2, 2] or 1), mask, result[2]
        work.take("H", result, settings, among)


def _options(name: str, works: List[_Work], amongs: typing.Sequence[Optional[_Mask]], settings: Settings) -> List[Params]:
    plain: Dict[Tuple[int, float], Params] = {}
    return [_params(name, work, among, settings) or _plain(name, work, settings, plain) for work, among in zip(works, amongs)]


def _among(work: _Work) -> Optional[_Mask]:
    """The matches that a homography is asked to explain; None: all."""
    model = work.models.get("E") or work.models.get("F")
    return None if model is None else model.mask


def _base(work: _Work, settings: Settings) -> Optional[_Model]:
    """E, F or H, whichever tells the inliers."""
    E, F, H = (work.models.get(name) for name in "EFH")
    if E is None or F is None or H is not None and H.inliers > settings.planarRatio * E.inliers:
        return E or F or H
    surplus = settings.calibrationRatio * F.inliers - E.inliers - _FREEDOM_MORE
    if surplus <= 0:
        return E
    error = sampsonDistances(_fundamental(E.matrix, work.pair), work.pair.first.points, work.pair.second.points)
    beside = (error > settings.threshold) & (error <= 3 * settings.threshold)  # twice as wide as the band of the inliers
    return E if surplus <= _DEVIATIONS * np.sqrt(np.count_nonzero(beside) / 2) else F


def _rows(points: _Array, among: Optional[_Mask]) -> _Array:
    return points if among is None else points[among]


def _plain(name: str, work: _Work, settings: Settings, made: Dict[Tuple[int, float], Params]) -> Params:
    """Options of all pairs that need as many iterations as this one."""
    limits = _limits(name, work, settings)
    if limits not in made:
        made[limits] = settings.params()
        made[limits].maxIterations, made[limits].significance = limits
    return made[limits]


def _limits(name: str, work: _Work, settings: Settings) -> Tuple[int, float]:
    """Most iterations, and the largest chance."""
    if name == "F" and work.calibrated and "E" not in work.models:
        return min(settings.maxIterations, LEAST_ITERATIONS), settings.significance**_ALONE
    return settings.iterations(_SAMPLE[name], len(work.pair.matches)), settings.significance


def _params(name: str, work: _Work, among: Optional[_Mask], settings: Settings) -> Optional[Params]:
    """Options of this pair; None: those of any."""
    fromE = name == "F" and "E" in work.models
    if among is None and not fromE and work.pair.scores is None:
        return None
    params = settings.params(work.pair)
    params.maxIterations, params.significance = _limits(name, work, settings)
    if among is not None:
        params.maxIterations = min(params.maxIterations, _ITERATIONS_IN_INLIERS)
        params.significance = 1  # its part of the inliers is what counts
        if len(params.scores):
            params.scores = params.scores[among]
    elif fromE:
        params.maxIterations = min(params.maxIterations, _ITERATIONS_FROM_E)
        params.setInitialModel(_fundamental(work.models["E"].matrix, work.pair))
    return params


def _fundamental(E: _Array, pair: Pair) -> _Array:
    F: _Array = np.linalg.inv(pair.second.matrix).T @ E @ np.linalg.inv(pair.first.matrix)
    return F / np.linalg.norm(F)


def _result(work: _Work, settings: Settings) -> TwoView:
    """The rules."""
    pair, F, H = work.pair, work.models.get("F"), work.models.get("H")
    base = _base(work, settings)
    if work.mistake or base is None:
        return _refused(work, settings)
    calibrated = base is work.models.get("E")
    configuration = Configuration.CALIBRATED if calibrated else Configuration.UNCALIBRATED
    pose: Optional[Tuple[_Array, _Array]] = None
    if calibrated:
        pose = _motion(base, pair)
    if H is not None and H.inliers > settings.planarRatio * base.inliers:
        configuration = Configuration.PLANAR_OR_PANORAMIC
        if work.calibrated and (calibrated or base is H):
            turn = _turn(H, base, pair, settings)
            configuration = Configuration.PLANAR if turn is None else Configuration.PANORAMIC
            pose = pose if turn is None else (turn, np.zeros(3))
    if settings.watermarks and _isWatermark(base.mask, pair, settings.threshold):
        configuration = Configuration.WATERMARK
    rotations = _rotations(configuration, base, H, pose, pair) if work.calibrated else None
    return TwoView(
        pair.key, configuration, np.ascontiguousarray(pair.matches[base.mask], np.uint32),
        _fundamental(base.matrix, pair) if calibrated else None if F is None else F.matrix,
        base.matrix if calibrated else None, None if H is None else H.matrix,
        None if pose is None else quaternion(pose[0]), None if pose is None else pose[1], "", len(pair.matches),
        work.iterations, base.report.chance, work.milliseconds, rotations)


def _rotations(configuration: Configuration, base: _Model, H: Optional[_Model], pose: Optional[Tuple[_Array, _Array]],
               pair: Pair) -> Optional[_Array]:
    """Those that are possible, one of which is right if the pair is."""
    if configuration == Configuration.WATERMARK:
        return None
    found = [] if pose is None else [pose[0]]
    if configuration == Configuration.PLANAR and H is not None:
        found += rotationsOfPlane(np.linalg.inv(pair.second.matrix) @ H.matrix @ pair.first.matrix)
    elif configuration == Configuration.UNCALIBRATED:
        found = [motionOfEssential(essentialOf(base.matrix, pair.first.matrix, pair.second.matrix), *_views(pair, base.mask))[0]]
    return np.array([quaternion(R) for R in found]) if found else None


def _refused(work: _Work, settings: Settings) -> TwoView:
    count = len(work.pair.matches)
    needed = settings.leastMatches
    reason = work.mistake or (work.reason if count >= needed else "{} matches, {} are needed".format(count, needed))
    if work.limited and not work.mistake:
        reason += "; all {} samples drawn, confidence {}".format(settings.maxIterations, ", ".join(work.limited))
    configuration = Configuration.UNDEFINED if work.mistake else Configuration.DEGENERATE
    return TwoView(work.pair.key, configuration, np.empty((0, 2), np.uint32), None, None, None, None, None, reason, count,
                   work.iterations, work.chance, work.milliseconds)


def _views(pair: Pair, mask: _Mask) -> Tuple[_Array, _Array]:
    def of(view: View) -> _Array:
        return directions(view.points[mask], view.matrix)
    return of(pair.first), of(pair.second)


def _motion(E: _Model, pair: Pair) -> Tuple[_Array, _Array]:
    return motionOfEssential(E.matrix, *_views(pair, E.mask))


def _turn(H: _Model, base: _Model, pair: Pair, settings: Settings) -> Optional[_Array]:
    """The rotation of the camera that explains the inliers of `base`; None: there is none."""
    R = rotation(*_views(pair, H.mask))
    mapped = pair.second.matrix @ R @ np.linalg.inv(pair.first.matrix)
    error = mapDistances(mapped, pair.first.points[base.mask], pair.second.points[base.mask])
    right = np.count_nonzero(error <= _PLANAR_DISTANCE * settings.threshold)
    return R if right > settings.planarRatio * base.inliers else None


def _isWatermark(mask: _Mask, pair: Pair, threshold: float) -> bool:
    """A picture's frame, mark or date stays where it is in the image, whatever the camera sees."""
    inside = mask.copy()
    count = np.count_nonzero(mask)
    for view in (pair.first, pair.second):
        if view.width <= 0 or view.height <= 0:
            return False
        margin = _BORDER * float(np.hypot(view.width, view.height))
        x, y = view.taken[:, 0], view.taken[:, 1]
        inside &= (x < margin) | (y < margin) | (x > view.width - margin) | (y > view.height - margin)
        if np.count_nonzero(inside) < _WATERMARK * count:
            return False
    motion = pair.second.taken[inside] - pair.first.taken[inside]
    same = np.linalg.norm(motion - np.median(motion, axis=0), axis=1) <= _PLANAR_REACH * threshold
    return bool(np.count_nonzero(same) >= _WATERMARK * count)
