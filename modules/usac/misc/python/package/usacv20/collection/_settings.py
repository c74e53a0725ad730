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

# USACV20_PARALLEL is excluded because the pairs are processed in parallel. USACV20_PROSAC is
# excluded because it needs sorted matches, and those of a collection are not sorted. All other
# methods use the scores of the matches, if there are any. With USACV20_AUTO each pair has its own
# threshold.
METHODS = {flag.name: flag for flag in UsacV20Method if flag not in (UsacV20Method.USACV20_PARALLEL, UsacV20Method.USACV20_PROSAC)}


@dataclasses.dataclass(frozen=True)
class Settings:
    """Options of the verification. Defaults are those of COLMAP unless a comment says otherwise."""

    threshold: float = 4.0  # pixels, largest error of an inlier; USACV20_AUTO: upper limit of the estimated threshold
    method: str = "USACV20"  # one of METHODS
    confidence: float = 0.999
    # Largest number of samples of a model, equal to COLMAP's limit. With the other defaults it may
    # end a search for F before `confidence` is reached (see `reached`), but not one for E or H.
    # This happens for at least 44 matches with an inlier ratio below 0.33 (60 matches) to 0.29
    # (many matches). For an inlier ratio of 0.25, the probability that F is found is then at least
    # 0.49 (60 matches), 0.86 (300), 0.91 (2000).
    maxIterations: int = 10000
    # Least expected inlier ratio. Pairs with a lower ratio may be found, too, but with less than
    # `confidence`.
    inlierRatio: float = 0.25
    # Inlier ratios of some pairs of the collection, from the estimation of its threshold (see
    # `needed`); empty: unknown.
    ratios: Tuple[float, ...] = ()
    seed: int = 0
    minInliers: int = 15  # least number of inliers of an accepted pair
    # Largest Report.chance of an accepted pair: at most this fraction of the pairs without overlap
    # is accepted by mistake. It is a hundredth of the limit for single pairs, as most pairs of a
    # collection have no overlap.
    significance: float = 1e-4
    planarRatio: float = 0.8  # if a homography has more than this fraction of the inliers, the pair is planar or panoramic
    calibrationRatio: float = 0.95  # if E has less than this fraction of F's inliers, the focal lengths are considered wrong
    watermarks: bool = True  # detects pairs whose matches belong to a frame or mark in the images

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
        """Returns the settings for a file. Runs with equal settings can be continued (--resume)."""
        return dict(dataclasses.asdict(self), ratios=list(self.ratios))

    @property
    def rules(self) -> TwoViewRules:
        return TwoViewRules(self.minInliers, self.inlierRatio, self.ratios, self.planarRatio, self.calibrationRatio)

    def needed(self, sample: int, matches: int) -> int:
        """Returns the number of samples of `sample` points that find a pair that must be kept with
        `confidence`, see TwoViewRules.samples."""
        return self.rules.samples(self.params(), sample, matches)

    def iterations(self, sample: int, matches: int) -> int:
        """Returns the limit of samples: the needed number, but at most `maxIterations`."""
        return min(self.maxIterations, self.needed(sample, matches))

    def reached(self, sample: int, matches: int) -> float:
        """Returns the probability that these samples find a pair whose inlier ratio is
        `inlierRatio`. It is less than `confidence` if `maxIterations` is less than the needed
        number."""
        return self.rules.reached(self.params(), sample, matches)

    def params(self) -> Params:
        """Returns the options of the estimator, without scores, which belong to the pairs."""
        params = Params.fromMethod(METHODS[self.method])
        params.threshold, params.confidence, params.maxIterations, params.seed, params.significance = (
            self.threshold, self.confidence, self.maxIterations, self.seed, self.significance)
        params.scoreOrder = ScoreOrder.SCORES_HIGHER_IS_BETTER
        return params
