# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The threshold of a collection, from the noise of its keypoints (--threshold auto).

The noise is nearly the same in all pairs of a scene and a camera, so some of the pairs tell that of all.

1. Some pairs are chosen by a hash of their keys.
2. Of each E (both focal lengths known) or F is estimated, at first with a quality that is marginalized over the noise, then
   with the threshold that came out, until it stays. A plane or a rotation leaves F undetermined, but not the errors of the
   matches under it, which are all that is used: so H is not needed.
3. Sampson's errors under the model are compared with those of matches that are wrong for certain, of point i with point j of
   the same two images. Where there are the most errors beyond expectation is the radius of the right matches, as in an
   a-contrario RANSAC @cite moisan2004probabilistic. Pairs in which that may be chance, or in which right matches would not be
   much denser than wrong ones, tell nothing: pairs without overlap, or with clusters of wrong matches.
4. To the errors of a pair a mixture is fitted by expectation and maximization: right matches (half normal), right matches that
   are located badly (the same, `TAIL` times as wide), wrong matches (uniform) @cite torr2000mlesac. Real keypoints need the
   second: its part is 0.2 to 0.4 on photographs, and 0 with normal noise.
5. Of all pairs: the median of the noise; and as heavy a tail as all but `FEW_PAIRS` of them have at least, as wrong matches
   close to right ones look like a tail in some pairs. All pairs have the same weight: between them the noise differs by more
   than the 5 % to which 200 matches tell it.

The threshold is that within which `QUANTILE` of the right matches are."""

from __future__ import annotations

import copy
import hashlib
import heapq
import math
import typing
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Optional, Tuple

import numpy as np

from .._problems import estimateEssentials, estimateFundamentals
from .._params import Params
from ._distances import sampsonDistances
from ._pair import Fault, Key, Pair, Source
from ._settings import Settings

if TYPE_CHECKING:
    import numpy.typing as npt

    _Numbers = npt.NDArray[np.float64]

# Half and double of these: doc/collections.md.

SAMPLE = 100  # pairs that are looked at
MORE = 10  # times as many are read to find such with matches
LEAST_MATCHES = 50  # of a pair that is preferred
CHUNK = 50  # pairs that are read at once

QUANTILE = 0.95  # of the right matches @cite hartley2003multiple (table 4.2)
IN_SIGMAS = 1.96  # what that is of a normal distribution with one degree of freedom
MEDIAN_IN_SIGMAS = 0.6745

FIRST = 1.0  # pixels, threshold of the first round, whose search finds the scale by itself
CONFIDENCE, ITERATIONS = 0.99, 500  # pairs that need more are left out
AGAIN = 100  # samples of a round that starts from the models of the one before
ROUNDS, SETTLED = 4, 0.05  # most rounds; relative change that ends them
MOST = 1000  # matches of a pair that are looked at
SHIFTS = 3  # wrong matches for each match

# Pairs below which a warning is due: three are within 10 %; of single ones 79 % are, the worst was wrong by 3.8.
ENOUGH = 3

LEAST_INLIERS = 30  # beyond the parameters
# Logarithm of the chance for each inlier. Measured: clusters of wrong matches 0.2 to 0.7; right ones 0.4 to 7, median 2 to 6.
LEAST_EVIDENCE = 1.0
FEW_PAIRS = 0.25

WINDOW = 10.0  # sigma of the first guess: right matches with their tail, and wrong ones beside them
BINS = 200
TAIL, LARGEST_TAIL = 3.0, 0.5
STEPS = 50

SMALLEST = 0.01  # pixels, a threshold: ten times what float32 leaves of coordinates up to 2^14


@dataclass(frozen=True)
class ThresholdEstimate:
    """What the sample tells of the collection."""

    threshold: float  # pixels, rounded to three digits, so that what is printed is what is used
    sigma: float  # pixels, noise of a coordinate: of normal noise with the same QUANTILE
    spread: float  # half of the distance between the quartiles of the pairs, as a part of sigma
    asked: int  # pairs
    used: int  # pairs that tell the noise
    ratios: Tuple[float, ...] = ()  # of those pairs, in order: the part of the matches that is within the threshold

    def describe(self) -> str:
        """One sentence for a log."""
        if not self.used:
            return ("{:g} px, COLMAP's, as none of {} pairs that were looked at tells the noise: in none enough matches agree; "
                    "--threshold PIXELS sets another".format(self.threshold, self.asked))
        text = "{:g} px, as the noise of a coordinate is {:.3g} px ({} of {} pairs tell it, apart by {:.0%})".format(
            self.threshold, self.sigma, self.used, self.asked, self.spread)
        return text + ("; so few may be wrong by a factor of 4" if self.used < ENOUGH else "")


def samplePairs(source: Source, count: int = SAMPLE) -> List[Pair]:
    """Pairs that do not depend on the order of the keys, those with many matches preferred. Not many more than `count` are held,
    and not more than MORE times as many are read; each of the keys is seen once."""
    keys = heapq.nsmallest(MORE * count, source.keys(), key=_mark)
    many: List[Pair] = []
    few: List[Pair] = []
    for begin in range(0, len(keys), CHUNK):
        for pair in source.load(keys[begin:begin + CHUNK]):
            if not isinstance(pair, Fault):
                (many if len(pair.matches) >= LEAST_MATCHES else few).append(pair)
        few = few[:max(count - len(many), 0)]
        if len(many) >= count:
            break
    return (many + few)[:count]


def _mark(key: Key) -> bytes:
    """Orders keys as if by chance, in any process alike."""
    return hashlib.blake2b(str(key).encode("utf-8", "surrogatepass"), digest_size=8).digest()


def estimateThreshold(pairs: typing.Sequence[Pair], settings: Settings) -> ThresholdEstimate:
    """The noise of the pairs and the threshold for it; COLMAP's threshold where no pair tells the noise. Of the settings the seed is
    used."""
    params = Params.magsacPlusPlus()
    threshold = FIRST
    left: List[Tuple[Pair, Optional[_Model]]] = [(pair, None) for pair in pairs]
    for step in range(ROUNDS):
        params.threshold, params.seed = threshold, settings.seed
        params.confidence, params.maxIterations = CONFIDENCE, ITERATIONS if step == 0 else AGAIN
        models = _models(left, params)
        found = [None if model is None else _errors(pair, model) for (pair, _), model in zip(left, models)]
        left = [(pair, model) for (pair, _), model, errors in zip(left, models, found) if errors is not None]
        told = [errors for errors in found if errors is not None]
        if not told:
            return ThresholdEstimate(Settings().threshold, math.nan, math.nan, len(pairs), 0)
        cores, sigmas = _noise(told)
        sigma = float(np.median(cores) * np.quantile(sigmas / cores, FEW_PAIRS))
        before, threshold = threshold, max(IN_SIGMAS * sigma, SMALLEST)
        if step > 0 and abs(threshold - before) <= SETTLED * before:
            break
        params = Params()
    low, high = np.quantile(sigmas, [0.25, 0.75])
    ratios = sorted(round(float(np.mean(pair.errors <= threshold)), 2) for pair in told)
    return ThresholdEstimate(float("{:.3g}".format(threshold)), sigma, float(high - low) / 2 / sigma, len(pairs), len(left),
                             tuple(ratios))


class _Model(typing.NamedTuple):
    F: _Numbers
    parameters: int
    estimated: _Numbers  # E or F


def _models(pairs: typing.Sequence[Tuple[Pair, Optional[_Model]]], params: Params) -> List[Optional[_Model]]:
    """Of each pair, from its model of the round before; None: there is none that is significant."""
    result: List[Optional[_Model]] = [None] * len(pairs)
    for calibrated in (False, True):
        which = [i for i, (pair, _) in enumerate(pairs) if (pair.first.focalKnown and pair.second.focalKnown) == calibrated]
        if not which:
            continue
        chosen = [pairs[i][0] for i in which]
        first, second = [_some(pair.first.points) for pair in chosen], [_some(pair.second.points) for pair in chosen]
        options = [_from(pairs[i][1], params) for i in which]
        outcomes: List[Any]
        if calibrated:
            outcomes = estimateEssentials(first, second, [pair.first.matrix for pair in chosen],
                                          [pair.second.matrix for pair in chosen], params=options, returnExceptions=True)
        else:
            outcomes = estimateFundamentals(first, second, options, returnExceptions=True)
        for i, outcome in zip(which, outcomes):
            if isinstance(outcome, Exception) or outcome[0] is None:
                continue
            F = outcome[0]
            if calibrated:
                F = np.linalg.inv(pairs[i][0].second.matrix).T @ F @ np.linalg.inv(pairs[i][0].first.matrix)
            result[i] = _Model(F, 5 if calibrated else 7, outcome[0])
    return result


def _from(before: Optional[_Model], params: Params) -> Params:
    if before is None:
        return params
    result = copy.copy(params)
    result.setInitialModel(before.estimated)
    return result


def _some(points: _Numbers) -> _Numbers:
    """Of many points a part, spread evenly."""
    return points[::-(-len(points) // MOST) or 1]


class _Errors(typing.NamedTuple):
    """Of a pair that tells the noise."""

    errors: _Numbers  # sorted, pixels
    guess: float  # of sigma
    correction: float  # of sigma, as the model has been fitted to the same matches


def _errors(pair: Pair, model: _Model) -> Optional[_Errors]:
    """None: the pair tells nothing."""
    a, b = _some(pair.first.points), _some(pair.second.points)
    count = len(a)
    if count <= LEAST_INLIERS + model.parameters:
        return None
    right, *others = sampsonDistances(model.F, a, b, [count * k // (SHIFTS + 1) for k in range(SHIFTS + 1)])
    errors, wrong = _sorted(right), _sorted(np.concatenate(others))
    inliers, evidence = _inliers(errors, wrong, model.parameters)
    # A model with one more match than its parameters can be chosen in count^(parameters + 1) ways.
    if inliers < LEAST_INLIERS + model.parameters or evidence < max(
            (model.parameters + 1) * math.log(count), LEAST_EVIDENCE * inliers):
        return None
    guess = max(float(np.median(errors[:inliers])) / MEDIAN_IN_SIGMAS, SMALLEST / IN_SIGMAS)
    return _Errors(errors, guess, math.sqrt(inliers / (inliers - model.parameters)))


def _sorted(errors: _Numbers) -> _Numbers:
    result: _Numbers = np.sort(np.where(np.isnan(errors), np.inf, errors))
    return result


def _inliers(errors: _Numbers, wrong: _Numbers, parameters: int) -> Tuple[int, float]:
    """How many of the errors are the least likely by chance, and minus the logarithm of Chernoff's bound of that chance."""
    count, total = len(errors), len(wrong)
    few = max(total // 100, 10)  # the least wrong ones: their density is that at 0
    density = few / total / max(float(wrong[few - 1]), 1e-9)
    within = np.searchsorted(wrong, errors, side="right") / total
    chance = np.clip(np.where(errors < wrong[few - 1], errors * density, within), 1e-9, 1 - 1e-9)
    part = np.clip((np.arange(1, count + 1) - parameters) / (count - parameters), 1e-9, 1 - 1e-9)
    divergence = part * np.log(part / chance) + (1 - part) * np.log((1 - part) / (1 - chance))
    divergence[part <= chance] = 0
    best = int(np.argmax(divergence))
    return best + 1, float((count - parameters) * divergence[best])


def _noise(told: typing.Sequence[_Errors]) -> Tuple[_Numbers, _Numbers]:
    """Of each pair: sigma of the right matches without the tail, and of the normal distribution that has their QUANTILE.
    Expectation and maximization of all pairs at once, in units of their guesses."""
    counts = np.array([np.histogram(pair.errors / pair.guess, BINS, (0, WINDOW))[0] for pair in told], float)
    x = (np.arange(BINS) + 0.5) * (WINDOW / BINS)
    members = counts.sum(axis=1, keepdims=True)
    sigma, right, tail = (np.full((len(told), 1), start) for start in (1.0, 0.7, 0.1))
    for _ in range(STEPS):
        core = right * (1 - tail) * _halfNormal(x, sigma)
        far = right * tail * _halfNormal(x, TAIL * sigma)
        weight = counts / (core + far + (1 - right) / WINDOW)
        core, far = core * weight, far * weight
        inside, outside = core.sum(axis=1, keepdims=True), far.sum(axis=1, keepdims=True)
        right = np.clip((inside + outside) / members, 0.01, 0.99)
        tail = np.minimum(outside / (inside + outside), LARGEST_TAIL)
        sigma = np.sqrt(((core + far / TAIL**2) * x * x).sum(axis=1, keepdims=True) / (inside + outside))
    cores = np.array([pair.guess * pair.correction for pair in told]) * sigma[:, 0]
    return cores, cores * [_quantile(part) / IN_SIGMAS for part in tail[:, 0]]


def _halfNormal(x: "np.ndarray[Any, Any]", sigma: "np.ndarray[Any, Any]") -> _Numbers:
    density: _Numbers = math.sqrt(2 / math.pi) / sigma * np.exp(-0.5 * (x / sigma)**2)
    return density


def _quantile(tail: float) -> float:
    """Within how many sigma QUANTILE of the right matches are, by bisection."""
    low, high = 0.0, TAIL * IN_SIGMAS
    while high - low > 1e-6:
        middle = (low + high) / 2
        z = middle / math.sqrt(2)
        if (1 - tail) * math.erf(z) + tail * math.erf(z / TAIL) < QUANTILE:
            low = middle
        else:
            high = middle
    return high
