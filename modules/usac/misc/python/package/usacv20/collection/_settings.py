# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""How pairs are verified."""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Any, Dict, Optional, Tuple

import numpy as np

from .._enumerations import ScoreOrder, UsacV20Method
from .._params import Params
from ._pair import CollectionError, Pair

# Not USACV20_PARALLEL, as the pairs are what is parallel; not USACV20_PROSAC, as matches of a collection come in no order: scores
# are for all other methods.
METHODS = {flag.name: flag for flag in UsacV20Method
           if flag not in (UsacV20Method.USACV20_PARALLEL, UsacV20Method.USACV20_PROSAC)}

# A right sample is not always a good one: its points may be near to each other. That many cost less than 2 ms.
LEAST_ITERATIONS = 500

# The local optimization makes a model of a sample with a wrong point right, too, the more easily the more points are right. Of E, a
# sample counts as (right matches / EASY)^2 that have to be right, at most EASIEST. Measured with USACV20, 200 scenes each, from
# what a quarter of the samples or less finds: 1.2 (18 right matches), 1.5 (20), 2.1 (24), more than 12 (40 and 50). Of F and H and
# the other presets it was not measured, they count as 1.
EASY, EASIEST = 15, 4
# Ratios that stand for those between the least of a collection and `inlierRatio`. 4: up to 25 % fewer samples; 16: within 11 %, 64: within 16 %.
TAIL = 8


@dataclasses.dataclass(frozen=True)
class Settings:
    """Options of the verification. Those without another source have the defaults of COLMAP's."""

    threshold: float = 4.0  # pixels, largest error of an inlier
    method: str = "USACV20"  # one of METHODS
    confidence: float = 0.999
    # Samples of a model; COLMAP's limit. With the other defaults it ends the search before `confidence` (see `reached`):
    # F of 37 matches or more unless 0.42 of them (37 matches) to 0.35 (many) are right: of pairs with a quarter right it finds
    # 0.15 (60 matches), 0.39 (300), 0.45 (2000); E with a quarter right of 58 to 64 matches: 0.996 (60) and more; H never.
    maxIterations: int = 10000
    # Least part of the matches that is expected to be right; pairs with less are found, too, but not with `confidence`.
    inlierRatio: float = 0.25
    # Inlier ratios of some pairs of the collection, those that tell its threshold (see `needed`); none: not known.
    ratios: Tuple[float, ...] = ()
    seed: int = 0
    minInliers: int = 15  # of a pair that is kept
    # Largest Report.chance of a pair that is kept: of pairs without overlap at most this part is taken for one with. A
    # hundredth of what is asked of a single pair, as most pairs of a collection have no overlap.
    significance: float = 1e-4
    planarRatio: float = 0.8  # of the inliers; a homography with more of them makes the pair planar or panoramic
    calibrationRatio: float = 0.95  # E with less of the inliers of F tells that the focal lengths are wrong
    watermarks: bool = True  # pairs whose matches are a picture's frame or mark are named as such

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            raise CollectionError("method: one of {} is expected, not {}".format(", ".join(METHODS), self.method))
        if self.minInliers < 1:
            raise CollectionError("min-inliers: a positive number is expected, not {}".format(self.minInliers))
        for name in ("planarRatio", "calibrationRatio", "inlierRatio"):
            if not 0 <= getattr(self, name) <= 1:
                raise CollectionError("{}: a number from 0 to 1 is expected, not {}".format(name, getattr(self, name)))
        if not all(0 < ratio <= 1 for ratio in self.ratios):
            raise CollectionError("ratios: numbers above 0 and up to 1 are expected, not {}".format(self.ratios))
        try:
            self.params().check()
        except Exception as mistake:
            raise CollectionError(getattr(mistake, "err", "") or str(mistake))

    def asDict(self) -> Dict[str, Any]:
        """For a file: what two runs must have in common to be one."""
        return dict(dataclasses.asdict(self), ratios=list(self.ratios))

    @property
    def leastMatches(self) -> int:
        """Pairs with less are refused at once: any seven matches have an F that fits."""
        return max(self.minInliers, 8)

    @functools.lru_cache(maxsize=4096)  # many pairs have as many matches
    def needed(self, sample: int, matches: int) -> int:
        """Samples of so many points that find a pair that is to be kept: with `confidence` one of them is right. No limit.

        Of a collection with `ratios` that is the mean over its pairs: those that are known and one more, which has any ratio
        between the least of them and `inlierRatio`, as a pair has less than the least of k others with a chance of 1 / (k + 1).
        Ratios below `inlierRatio` count as that, so that the samples never are more than without them."""
        lost = 1 - min(self.confidence, 1 - 1e-15)
        ratios = [max(ratio, self.inlierRatio) for ratio in self.ratios]
        between = min(ratios, default=self.inlierRatio) - self.inlierRatio
        tail = [self.inlierRatio + between * (i + 0.5) / TAIL for i in range(TAIL)]
        weights = np.array([1.0] * len(ratios) + [1 / TAIL] * TAIL) / (len(ratios) + 1)
        logarithms = np.array([self._missedBySample(sample, matches, ratio) for ratio in ratios + tail])
        if logarithms.max() <= math.log(lost):
            return LEAST_ITERATIONS

        def enough(samples: int) -> bool:
            with np.errstate(invalid="ignore"):
                return bool(weights @ np.exp(samples * logarithms) <= lost)

        low, high = 0, math.ceil(math.log(lost) / float(logarithms.max()))
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if enough(middle) else (middle, high)
        return max(LEAST_ITERATIONS, high)

    def iterations(self, sample: int, matches: int) -> int:
        """Samples that are drawn at most: those that are needed, or `maxIterations`, if that is less."""
        return min(self.maxIterations, self.needed(sample, matches))

    def reached(self, sample: int, matches: int) -> float:
        """The chance that one of those samples is right, if `inlierRatio` of the matches is: less than `confidence` where
        `maxIterations` is less than is needed."""
        return -math.expm1(self.iterations(sample, matches) * self._missedBySample(sample, matches, self.inlierRatio))

    def _missedBySample(self, sample: int, matches: int, ratio: float) -> float:
        """Logarithm of the chance that one sample does not find a pair."""
        right = self._rightSamples(sample, matches, ratio)
        easy = max(ratio * matches, self.minInliers) / EASY if sample == 5 and self.method == "USACV20" else 1
        return -math.inf if right == 1 else min(max(easy * easy, 1), EASIEST) * math.log1p(-right)

    def _rightSamples(self, sample: int, matches: int, ratio: float) -> float:
        """The part of the samples, drawn without replacement, whose points all are right. A model has at least a sample."""
        count = math.ceil(ratio * matches)
        if matches and (count - 1) / matches >= ratio:  # 0.07 * 100 is more than 7
            count -= 1
        count = max(count, self.minInliers, sample)
        part = 1.0
        for i in range(sample):
            part *= min((count - i) / max(matches - i, 1), 1)
        return part

    def params(self, pair: Optional[Pair] = None) -> Params:
        """Options of the estimator, with the scores of a pair."""
        params = Params.fromMethod(METHODS[self.method])
        params.threshold, params.confidence, params.maxIterations, params.seed, params.significance = (
            self.threshold, self.confidence, self.maxIterations, self.seed, self.significance)
        if pair is not None and pair.scores is not None:
            params.scores = pair.scores
            params.scoreOrder = (ScoreOrder.SCORES_HIGHER_IS_BETTER if pair.higherIsBetter
                                 else ScoreOrder.SCORES_LOWER_IS_BETTER)
        return params
