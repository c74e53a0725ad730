# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The threshold of a collection, from the noise of its keypoints (--threshold auto).

The noise is nearly the same in all pairs of a scene and a camera, so some of the pairs tell that of all.

1. Some pairs are chosen by a hash of their keys.
2. Of each E (both focal lengths known) or F is estimated with a threshold that is found in its matches (Params.automatic()). A
   plane or a rotation leaves F undetermined, but not the errors of the matches under it, which are all that is used: so H is not
   needed. Report.sigma is the noise of the matches that are located well, Report.threshold contains `QUANTILE` of all right ones,
   also of those that are located badly: real keypoints have some, their part is 0.2 to 0.4 on photographs.
3. Of all pairs: the median of the noise; and as heavy a tail as all but `FEW_PAIRS` of them have at least, as wrong matches
   close to right ones look like a tail in some pairs. All pairs have the same weight: between them the noise differs by more
   than the 5 % to which 200 matches tell it.

The threshold is that within which `QUANTILE` of the right matches are."""

from __future__ import annotations

import hashlib
import heapq
import math
import typing
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Optional, Tuple

import numpy as np

from .._problems import estimateEssentials, estimateFundamentals
from .._params import Params
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

WIDEST = 12.0  # pixels, the largest threshold that is plausible: three times COLMAP's
CONFIDENCE, ITERATIONS = 0.99, 500  # pairs that need more are left out
SIGNIFICANCE = 1e-4  # largest Report.chance of a pair that tells the noise
MOST = 1000  # matches of a pair that are looked at

# Pairs below which a warning is due: three are within 10 %; of single ones 79 % are, the worst was wrong by 3.8.
ENOUGH = 3

LEAST_INLIERS = 30  # beyond the parameters
FEW_PAIRS = 0.25

SMALLEST = 0.012  # pixels, a threshold: the least that is told with WIDEST, ten times what float32 leaves of coordinates up to 2^14


@dataclass(frozen=True)
class ThresholdEstimate:
    """What the sampled pairs tell of the collection."""

    threshold: float  # pixels, rounded to three digits, so that what is printed is what is used
    sigma: float  # pixels, noise of a coordinate: of normal noise with the same QUANTILE
    spread: float  # half of the distance between the quartiles of the pairs, as a part of sigma
    asked: int  # pairs
    used: int  # pairs that tell the noise
    ratios: Tuple[float, ...] = ()  # of those pairs, in order: the part of the matches that are inliers

    def describe(self) -> str:
        """Returns one sentence for a log."""
        if not self.used:
            return ("{:g} px, COLMAP's, as none of {} pairs that were looked at tells the noise: in none enough matches agree; "
                    "--threshold PIXELS sets another".format(self.threshold, self.asked))
        text = "{:g} px, as the noise of a coordinate is {:.3g} px ({} of {} pairs tell it, apart by {:.0%})".format(
            self.threshold, self.sigma, self.used, self.asked, self.spread)
        return text + ("; so few may be wrong by a factor of 4" if self.used < ENOUGH else "")


def samplePairs(source: Source, count: int = SAMPLE) -> List[Pair]:
    """Returns pairs that do not depend on the order of the keys, preferring those with many matches. Not many more than `count` are held,
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
    """Estimates the noise of the pairs and the threshold for it; COLMAP's threshold if no pair tells the noise. Of the settings the seed is
    used."""
    told = [noise for noise in _noise(pairs, settings.seed) if noise is not None]
    if not told:
        return ThresholdEstimate(Settings().threshold, math.nan, math.nan, len(pairs), 0)
    cores, sigmas, ratios = np.array(told).T
    sigma = float(np.median(cores) * np.quantile(sigmas / cores, FEW_PAIRS))
    low, high = np.quantile(sigmas, [0.25, 0.75])
    return ThresholdEstimate(float("{:.3g}".format(max(IN_SIGMAS * sigma, SMALLEST))), sigma, float(high - low) / 2 / sigma, len(pairs),
                             len(told), tuple(sorted(round(float(ratio), 2) for ratio in ratios)))


class _Noise(typing.NamedTuple):
    """The noise of a pair that tells it."""

    core: float  # pixels, sigma of the matches that are located well
    sigma: float  # pixels, of the normal distribution that has the QUANTILE of all right matches
    ratio: float  # part of the matches that are inliers


def _noise(pairs: typing.Sequence[Pair], seed: int) -> List[Optional[_Noise]]:
    """Returns the noise of each pair; None: the pair tells nothing."""
    params = Params.automatic(threshold=WIDEST, confidence=CONFIDENCE, maxIterations=ITERATIONS, significance=SIGNIFICANCE, seed=seed)
    result: List[Optional[_Noise]] = [None] * len(pairs)
    for calibrated in (False, True):
        which = [i for i, pair in enumerate(pairs) if (pair.first.focalKnown and pair.second.focalKnown) == calibrated]
        if not which:
            continue
        chosen = [pairs[i] for i in which]
        first, second = [_some(pair.first.points) for pair in chosen], [_some(pair.second.points) for pair in chosen]
        outcomes: List[Any]
        if calibrated:
            outcomes = estimateEssentials(first, second, [pair.first.matrix for pair in chosen],
                                          [pair.second.matrix for pair in chosen], params=params, returnExceptions=True)
        else:
            outcomes = estimateFundamentals(first, second, params, returnExceptions=True)
        for i, points, outcome in zip(which, first, outcomes):
            if isinstance(outcome, Exception) or outcome[0] is None:
                continue
            report = outcome[2]
            if report.sigma > 0 and report.inliers >= LEAST_INLIERS + (5 if calibrated else 7):
                result[i] = _Noise(report.sigma, report.threshold / IN_SIGMAS, report.inliers / len(points))
    return result


def _some(points: _Numbers) -> _Numbers:
    """Returns an evenly spread part of many points."""
    return points[::-(-len(points) // MOST) or 1]
