# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates pairs with usacv20.estimateTwoViewGeometries. doc/collections.md describes the
rules by which models are accepted, and how they differ from COLMAP's rules."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, List, Optional, Union

import numpy as np

from .._two_view import TwoViewGeometry, TwoViewPair, estimateTwoViewGeometries
from ._pair import Configuration, Pair, TwoView, View
from ._poses import quaternion
from ._settings import Settings

if TYPE_CHECKING:
    import numpy.typing as npt


def verifyPairs(pairs: typing.Sequence[Pair], settings: Settings) -> List[TwoView]:
    """Estimates the two-view geometry of each pair and returns the results in the same order. A
    result depends only on its pair and the settings."""
    found = estimateTwoViewGeometries([_given(pair, settings) for pair in pairs], settings.params(), settings.rules, threads=1,
                                      returnExceptions=True)
    return [_result(pair, geometry) for pair, geometry in zip(pairs, found)]


def _given(pair: Pair, settings: Settings) -> TwoViewPair:
    first, second = pair.first, pair.second
    sizes = [(view.width, view.height) if settings.watermarks and min(view.width, view.height) > 0 else None
             for view in (first, second)]
    return TwoViewPair(first.points, second.points, _camera(first), _camera(second), None, None, sizes[0], sizes[1], _taken(first),
                       _taken(second), _scores(pair))


def _camera(view: View) -> Optional[npt.NDArray[np.float64]]:
    return view.matrix if view.focalKnown else None


def _taken(view: View) -> Optional[npt.NDArray[np.float64]]:
    return None if view.taken is view.points else view.taken


def _scores(pair: Pair) -> Optional[npt.NDArray[np.float64]]:
    """Returns the scores of the matches, negated if lower scores are better, because
    Settings.params declares higher scores to be better; None if there are no scores."""
    return pair.scores if pair.scores is None or pair.higherIsBetter else -pair.scores


def _result(pair: Pair, found: Union[TwoViewGeometry, Exception]) -> TwoView:
    count = len(pair.matches)
    if isinstance(found, Exception):
        reason = str(found).strip().splitlines()[-1]
        return TwoView(pair.key, Configuration.UNDEFINED, _NONE.copy(), None, None, None, None, None, reason, count, 0, 1.0, 0.0)
    inliers = np.ascontiguousarray(pair.matches[found.mask.ravel() != 0], np.uint32)
    rotations = None if found.rotations is None else np.array([quaternion(R) for R in found.rotations])
    return TwoView(pair.key, Configuration(found.configuration), inliers, found.F, found.E, found.H,
                   None if found.R is None else quaternion(found.R), None if found.t is None else found.t.ravel(), found.reason, count,
                   found.iterations, min(found.report.chance, 1.0), found.milliseconds, rotations)


_NONE = np.empty((0, 2), np.uint32)
