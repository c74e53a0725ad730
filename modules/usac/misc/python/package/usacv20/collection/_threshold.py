# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates the threshold of a collection from the noise of its keypoints (--threshold auto).

The noise is nearly equal in all pairs of a scene and a camera, so a sample of the pairs is
sufficient.

1. Some pairs are chosen by a hash of their keys.
2. For each of these pairs, E (both focal lengths known) or F is estimated with a threshold that is
   estimated from its matches (Params.automatic()). The model itself is not used: a plane or a
   rotation leaves F undetermined, but not the errors of the matches, so H is not needed.
   Report.sigma is the standard deviation of accurately located matches, the core noise.
   Report.threshold is the error that a fraction `QUANTILE` of all correct matches does not exceed,
   including badly located matches, which are 20 to 40 % of the matches in photographs.
   Report.threshold divided by `IN_SIGMAS` is called the total noise.
3. The noise of the collection is the product of two statistics of the pairs: the median of the core
   noise, and the quantile `FEW_PAIRS` of the ratio of total noise to core noise. A low quantile is
   used, because in some pairs wrong matches close to correct matches increase the ratio. All pairs
   have equal weight, because the noise differs between pairs by more than the 5 % accuracy of an
   estimate from 200 matches.

The threshold is `IN_SIGMAS` times this noise, so that a fraction `QUANTILE` of the correct matches
are inliers."""

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

# doc/measurements/collections_tables.md lists results with half and twice these values.

SAMPLE = 100  # maximum number of pairs that are used
MORE = 10  # at most MORE * SAMPLE pairs are read in search of pairs with many matches
LEAST_MATCHES = 50  # pairs with at least this number of matches are preferred
CHUNK = 50  # number of pairs that are read at once

QUANTILE = 0.95  # fraction of the correct matches within the threshold @cite hartley2003multiple (table 4.2)
IN_SIGMAS = 1.96  # threshold / standard deviation, if a fraction QUANTILE of normally distributed errors is within it

WIDEST = 12.0  # largest plausible threshold in pixels: three times that of COLMAP
CONFIDENCE, ITERATIONS = 0.99, 500  # confidence and maximum number of samples; pairs for which no model is found are left out
SIGNIFICANCE = 1e-4  # largest Report.chance of a pair that is used
MOST = 1000  # maximum number of matches of a pair that are used

# If fewer pairs are used, a warning is given. Estimates from three pairs differ by at most 10 % from
# the true noise. So do 79 % of the estimates from a single pair, but the worst one is wrong by a
# factor of 3.8.
ENOUGH = 3

LEAST_INLIERS = 30  # minimum number of inliers of a pair that is used, in addition to the number of the model's parameters
FEW_PAIRS = 0.25  # quantile of the ratio of total noise to core noise

# Smallest threshold in pixels: WIDEST / 1024, rounded; with THRESHOLD_ESTIMATED, this is the smallest
# threshold that can be estimated. It is about 12 times the spacing of float32 numbers just below 2^14.
SMALLEST = 0.012


@dataclass(frozen=True)
class ThresholdEstimate:
    """The threshold and its statistics over the sampled pairs."""

    threshold: float  # pixels, rounded to three digits, so that the printed value is equal to the used value
    sigma: float  # pixels, noise of the collection, see the top of this file
    spread: float  # half of the interquartile range of the total noise of the pairs, relative to sigma
    asked: int  # number of pairs in the sample
    used: int  # number of pairs with an estimate of the noise
    ratios: Tuple[float, ...] = ()  # inlier ratios of the used pairs, sorted

    def describe(self) -> str:
        """Returns one sentence for a log."""
        if not self.used:
            return ("{:g} px, COLMAP's, as none of {} pairs gave an estimate of the noise: too few matches agree; "
                    "--threshold PIXELS sets another".format(self.threshold, self.asked))
        text = "{:g} px, as the noise of a coordinate is {:.3g} px ({} of {} pairs gave an estimate, spread {:.0%})".format(
            self.threshold, self.sigma, self.used, self.asked, self.spread)
        return text + ("; an estimate from so few pairs may be wrong by a factor of 4" if self.used < ENOUGH else "")


def samplePairs(source: Source, count: int = SAMPLE) -> List[Pair]:
    """Returns a sample of the pairs, which does not depend on the order of the keys. Pairs with
    many matches are preferred. Only slightly more than `count` pairs are kept in memory, and at
    most MORE * count pairs are read; all keys are enumerated once."""
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
    """Returns a hash of a key. Sorting by this hash gives a pseudo-random order, which is the same
    in all processes."""
    return hashlib.blake2b(str(key).encode("utf-8", "surrogatepass"), digest_size=8).digest()


def estimateThreshold(pairs: typing.Sequence[Pair], settings: Settings) -> ThresholdEstimate:
    """Estimates the noise of the pairs and the corresponding threshold. If no pair yields an
    estimate, COLMAP's threshold is returned. Of the settings, only the seed is used."""
    told = [noise for noise in _noise(pairs, settings.seed) if noise is not None]
    if not told:
        return ThresholdEstimate(Settings().threshold, math.nan, math.nan, len(pairs), 0)
    cores, sigmas, ratios = np.array(told).T
    sigma = float(np.median(cores) * np.quantile(sigmas / cores, FEW_PAIRS))
    low, high = np.quantile(sigmas, [0.25, 0.75])
    return ThresholdEstimate(float("{:.3g}".format(max(IN_SIGMAS * sigma, SMALLEST))), sigma, float(high - low) / 2 / sigma, len(pairs),
                             len(told), tuple(sorted(round(float(ratio), 2) for ratio in ratios)))


class _Noise(typing.NamedTuple):
    """The estimated noise of a pair."""

    core: float  # pixels, core noise: Report.sigma, see the top of this file
    sigma: float  # pixels, total noise: Report.threshold / IN_SIGMAS
    ratio: float  # inlier ratio


def _noise(pairs: typing.Sequence[Pair], seed: int) -> List[Optional[_Noise]]:
    """Returns the noise of each pair; None for a pair without an estimate."""
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
    """Returns at most MOST points, evenly spread over the list."""
    return points[::-(-len(points) // MOST) or 1]
