# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The settings of the verification of pairs."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Tuple

from .._enumerations import ScoreOrder, UsacV20Method
from .._params import Params
from .._two_view import TwoViewRules
from ._pair import CollectionError

# Not USACV20_PARALLEL, as the pairs are what is parallel; not USACV20_PROSAC, as matches of a collection come in no order: scores
# are for all other methods. USACV20_AUTO: each pair has a threshold of its own.
METHODS = {flag.name: flag for flag in UsacV20Method if flag not in (UsacV20Method.USACV20_PARALLEL, UsacV20Method.USACV20_PROSAC)}


@dataclasses.dataclass(frozen=True)
class Settings:
    """Options of the verification. Defaults are those of COLMAP unless a comment says otherwise."""

    threshold: float = 4.0  # pixels, largest error of an inlier; USACV20_AUTO: the largest plausible one
    method: str = "USACV20"  # one of METHODS
    confidence: float = 0.999
    # Largest number of samples of a model; COLMAP's limit. With the other defaults it may end a search before `confidence` is
    # reached (see `reached`). F, from 37 matches on: if less than 42 % (37 matches) to 35 % (many) are right; if a quarter is
    # right, the probability of an all-inlier sample is then 0.15 (60 matches), 0.39 (300), 0.45 (2000). E: if a quarter of 58 to
    # 64 matches is right, with a probability of at least 0.996. H: never.
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
        try:
            self.params().check()
            self.rules.check()
        except Exception as mistake:
            raise CollectionError(getattr(mistake, "err", "") or str(mistake))

    def asDict(self) -> Dict[str, Any]:
        """Returns the settings for a file: two runs that have them in common count as one."""
        return dict(dataclasses.asdict(self), ratios=list(self.ratios))

    @property
    def rules(self) -> TwoViewRules:
        return TwoViewRules(self.minInliers, self.inlierRatio, self.ratios, self.planarRatio, self.calibrationRatio)

    def needed(self, sample: int, matches: int) -> int:
        """Returns how many samples of so many points find a pair that is to be kept, with `confidence`, see TwoViewRules.samples."""
        return self.rules.samples(self.params(), sample, matches)

    def iterations(self, sample: int, matches: int) -> int:
        """Returns how many samples are drawn at most: those that are needed, or `maxIterations`, if that is less."""
        return min(self.maxIterations, self.needed(sample, matches))

    def reached(self, sample: int, matches: int) -> float:
        """Returns the probability that one of those samples is right, if `inlierRatio` of the matches is: less than `confidence` where
        `maxIterations` is less than is needed."""
        return self.rules.reached(self.params(), sample, matches)

    def params(self) -> Params:
        """Returns the options of the estimator, without the scores, which the pairs have."""
        params = Params.fromMethod(METHODS[self.method])
        params.threshold, params.confidence, params.maxIterations, params.seed, params.significance = (
            self.threshold, self.confidence, self.maxIterations, self.seed, self.significance)
        params.scoreOrder = ScoreOrder.SCORES_HIGHER_IS_BETTER
        return params
