# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The settings of the verification of pairs."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Tuple

import numpy as np

from .._enumerations import ScoreOrder, UsacV20Method
from .._params import Params
from .._two_view import TwoViewRules
from ._pair import CollectionError

# USACV20_PARALLEL is excluded because the pairs are already processed in parallel. USACV20_PROSAC is
# excluded because it requires sorted matches, and the matches of a collection are not sorted. All
# other methods use the scores of the matches, if there are any. With USACV20_AUTO, each pair has its
# own threshold.
METHODS = {flag.name: flag for flag in UsacV20Method if flag not in (UsacV20Method.USACV20_PARALLEL, UsacV20Method.USACV20_PROSAC)}


@dataclasses.dataclass(frozen=True)
class Settings:
    """Options of the verification. Numerical defaults are those of COLMAP unless a comment says
    otherwise."""

    threshold: float = 4.0  # maximum error of an inlier in pixels; USACV20_AUTO: upper limit of the estimated threshold
    method: str = "USACV20"  # one of METHODS
    confidence: float = 0.999
    # Maximum number of samples for a model, equal to COLMAP's limit. With the other defaults, this
    # limit can end a search for F before `confidence` is reached (see `reached`), but not a search
    # for E or H. This happens for pairs with at least 44 matches, if the inlier ratio is below 0.33
    # (with 60 matches) or 0.29 (with many matches). If the inlier ratio is 0.25, F is then found
    # with a probability of about 0.49 (60 matches), 0.86 (300 matches) or 0.91 (2000 matches).
    maxIterations: int = 10000
    # Smallest expected inlier ratio. Pairs with a smaller ratio can be found, too, but with a
    # probability below `confidence`.
    inlierRatio: float = 0.25
    # Inlier ratios of some pairs of the collection, from the estimation of the collection's
    # threshold; used by `needed`. Empty: the ratios are unknown.
    ratios: Tuple[float, ...] = ()
    seed: int = 0
    minInliers: int = 15  # minimum number of inliers of an accepted pair
    # Largest Report.chance of an accepted pair: at most this fraction of the pairs with random
    # matches is accepted by mistake. The default is a hundredth of the usual limit for single
    # estimations (0.01), because most pairs of a collection have no overlap.
    significance: float = 1e-4
    # The pair is planar or panoramic if more than this fraction of the inliers are also inliers of a
    # homography.
    planarRatio: float = 0.8
    # The focal lengths count as wrong if the number of inliers of E is clearly less than this fraction
    # of the number of inliers of F, see estimateTwoViewGeometry.
    calibrationRatio: float = 0.95
    watermarks: bool = True  # True: detects pairs whose matches belong to a frame or mark in the images

    def __post_init__(self) -> None:
        for name, value in vars(self).copy().items():
            if isinstance(value, np.generic):  # such as numpy.float32, which cannot be stored as JSON
                object.__setattr__(self, name, value.item())
        if self.method not in METHODS:
            raise CollectionError("method: one of {} is expected, not {}".format(", ".join(METHODS), self.method))
        if self.minInliers < 1:
            raise CollectionError("min-inliers: a positive number is expected, not {}".format(self.minInliers))
        if self.significance == 0:  # in Params, 0 means the default
            raise CollectionError("significance: a number above 0 and at most 1 is expected, not 0")
        try:
            self.params().check()
            self.rules.check()
        except Exception as mistake:
            raise CollectionError(getattr(mistake, "err", "") or str(mistake))

    def asDict(self) -> Dict[str, Any]:
        """Returns the settings as a dictionary that can be stored. A run can be continued
        (--resume) with equal settings only."""
        return dict(dataclasses.asdict(self), ratios=list(self.ratios))

    @property
    def rules(self) -> TwoViewRules:
        return TwoViewRules(self.minInliers, self.inlierRatio, self.ratios, self.planarRatio, self.calibrationRatio)

    def needed(self, sample: int, matches: int) -> int:
        """Returns the number of samples of `sample` points with which the model of an acceptable
        pair is found with probability `confidence`, see TwoViewRules.samples."""
        return self.rules.samples(self.params(), sample, matches)

    def iterations(self, sample: int, matches: int) -> int:
        """Returns the maximum number of samples: the needed number, but at most `maxIterations`."""
        return min(self.maxIterations, self.needed(sample, matches))

    def reached(self, sample: int, matches: int) -> float:
        """Returns the probability that a pair with the inlier ratio `inlierRatio` is found with the
        maximum number of samples. It is less than `confidence` if `maxIterations` is less than the
        needed number."""
        return self.rules.reached(self.params(), sample, matches)

    def params(self) -> Params:
        """Returns the options of the estimator, without scores, which belong to the pairs."""
        params = Params.fromMethod(METHODS[self.method])
        params.threshold, params.confidence, params.maxIterations, params.seed, params.significance = (
            self.threshold, self.confidence, self.maxIterations, self.seed, self.significance)
        params.scoreOrder = ScoreOrder.SCORES_HIGHER_IS_BETTER
        return params
