# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The threshold of a collection from the noise of its matches (--threshold auto)."""

from __future__ import annotations

import hashlib
import heapq
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Iterator, List, NamedTuple, Optional, Protocol, Sequence, Tuple

import numpy as np

from .._batch import estimateEssentials, estimateFundamentals
from .._params import Params
from ._pair import CollectionError, Fault, Pair, Source

if TYPE_CHECKING:
    import numpy.typing as npt

    from .._report import Report

    Numbers = npt.NDArray[np.float64]
    Model = Optional[Numbers]

SAMPLE = 100
CHUNK = 16
LEAST_MATCHES = 50

QUANTILE = 0.99
IN_SIGMAS = 2.5758  # of a normal distribution, within which QUANTILE of it lie
MEDIAN_IN_SIGMAS = 0.6745

FIRST = 1.0
SETTLED = 0.05
ROUNDS = 4

MOST = 2000
LEAST_INLIERS = 30
LEAST_EVIDENCE = 1.0
PART_OF_PAIRS = 0.25
WINDOW = 10.0
BINS = 200
TAIL = 3.0
LARGEST_TAIL = 0.5
STEPS = 50


class Settings(Protocol):
    """What is used of the settings of the tool."""

    @property
    def confidence(self) -> float: ...
    @property
    def maxIterations(self) -> int: ...
    @property
    def seed(self) -> int: ...


@dataclass(frozen=True)
class ThresholdEstimate:
    threshold: float
    sigma: float
    spread: float
    asked: int
    used: int


def mark(key: object) -> bytes:
    return hashlib.blake2b(repr(key).encode(), digest_size=8).digest()


def samplePairs(source: Source, count: int = SAMPLE) -> List[Pair]:
    keys = heapq.nsmallest(count * 4, source.keys(), key=mark)
    pairs: List[Pair] = []
    rest: List[Pair] = []
    for begin in range(0, len(keys), CHUNK):
        for pair in source.load(keys[begin:begin + CHUNK]):
            if not isinstance(pair, Fault):
                (pairs if len(pair.matches) >= LEAST_MATCHES else rest).append(pair)
        if len(pairs) >= count:
            break
    return (pairs + rest)[:count]


class Noise(NamedTuple):
    core: float
    tail: float
    sigma: float
    inliers: int


def sampson(F: Numbers, first: Numbers, second: Numbers) -> Numbers:
    ones = np.ones((len(first), 1))
    a, b = np.hstack([first, ones]), np.hstack([second, ones])
    forth, back = a @ F.T, b @ F
    norm = np.sqrt((forth[:, :2] ** 2).sum(1) + (back[:, :2] ** 2).sum(1))
    error: Numbers = np.abs((b * forth).sum(1)) / np.maximum(norm, np.finfo(float).tiny)
    return error


def significantRadius(errors: Numbers, wrong: Numbers, parameters: int) -> Tuple[float, float]:
    """(radius, evidence)."""
    n = len(errors)
    few = max(10, len(wrong) // 100)
    density = few / len(wrong) / max(wrong[few - 1], 1e-9)
    inside = np.searchsorted(wrong, errors, side="right") / len(wrong)
    p = np.clip(np.where(errors < wrong[few - 1], errors * density, inside), 1e-9, 1 - 1e-9)
    part = (np.arange(1, n + 1) - parameters) / (n - parameters)
    k = np.clip(part, 1e-9, 1 - 1e-9)
    evidence = np.where(part > p, k * np.log(k / p) + (1 - k) * np.log((1 - k) / (1 - p)), 0)
    best = int(np.argmax(evidence))
    return best, float((n - parameters) * evidence[best])


def normal(x: Numbers, sigma: float) -> Numbers:
    density: Numbers = math.sqrt(2 / math.pi) / sigma * np.exp(-x * x / (2 * sigma * sigma))
    return density


def fit(errors: Numbers, sigma: float) -> Tuple[float, float]:
    """(sigma of the core, part of the tail)"""
    window = WINDOW * sigma
    counts, edges = np.histogram(errors, BINS, (0, window))
    x = (edges[1:] + edges[:-1]) / 2
    right, tail = 0.7, 0.1
    for _ in range(STEPS):
        near, far = right * (1 - tail) * normal(x, sigma), right * tail * normal(x, TAIL * sigma)
        total = near + far + (1 - right) / window
        near, far = counts * near / total, counts * far / total
        members = near.sum() + far.sum()
        right = float(np.clip(members / counts.sum(), 0.01, 0.99))
        tail = min(float(far.sum() / members), LARGEST_TAIL)
        sigma = math.sqrt(float(((near + far / TAIL ** 2) * x * x).sum() / members))
    return sigma, tail


def quantile(sigma: float, tail: float) -> float:
    low, high = 0.0, 2 * TAIL * IN_SIGMAS * sigma
    for _ in range(40):
        middle = (low + high) / 2
        z = middle / sigma / math.sqrt(2)
        if (1 - tail) * math.erf(z) + tail * math.erf(z / TAIL) < QUANTILE:
            low = middle
        else:
            high = middle
    return low


def noiseOf(pair: Pair, F: Numbers, parameters: int) -> Optional[Noise]:
    a, b = pair.first.points, pair.second.points
    step = -(-len(a) // MOST)
    a, b = a[::step], b[::step]
    n = len(a)
    errors = np.sort(sampson(F, a, b))
    wrong = np.sort(np.concatenate([sampson(F, a, np.roll(b, n * k // 4, 0)) for k in (1, 2, 3)]))
    best, evidence = significantRadius(errors, wrong, parameters)
    if best + 1 < LEAST_INLIERS + parameters or evidence < max((parameters + 1) * math.log(n), LEAST_EVIDENCE * (best + 1)):
        return None
    core, tail = fit(errors, float(np.median(errors[:best + 1])) / MEDIAN_IN_SIGMAS)
    core *= math.sqrt((best + 1) / (best + 1 - parameters))
    return Noise(core, tail, quantile(core, tail) / IN_SIGMAS, best + 1)


def isCalibrated(pair: Pair) -> bool:
    return pair.first.focalKnown and pair.second.focalKnown


def models(pairs: Sequence[Pair], params: Params) -> List[Optional[Tuple[Numbers, int]]]:
    result: List[Optional[Tuple[Numbers, int]]] = [None] * len(pairs)
    for calibrated in (False, True):
        chosen = [i for i, pair in enumerate(pairs) if isCalibrated(pair) == calibrated]
        if not chosen:
            continue
        first, second = [pairs[i].first.points for i in chosen], [pairs[i].second.points for i in chosen]
        if calibrated:
            found = estimateEssentials(first, second, [pairs[i].first.matrix for i in chosen], [pairs[i].second.matrix for i in chosen], params=params, returnExceptions=True)
        else:
            found = estimateFundamentals(first, second, params, returnExceptions=True)
        for i, outcome in zip(chosen, found):
            if isinstance(outcome, Exception) or outcome[0] is None:
                continue
            M = outcome[0]
            if calibrated:
                M = np.linalg.inv(pairs[i].second.matrix).T @ M @ np.linalg.inv(pairs[i].first.matrix)
            result[i] = (M, 5 if calibrated else 7)
    return result


def estimateThreshold(pairs: Sequence[Pair], settings: Settings, debug=False) -> ThresholdEstimate:
    params = Params.magsacPlusPlus()
    threshold = FIRST
    left = list(pairs)
    for r in range(ROUNDS):
        params.threshold = threshold
        params.maxIterations, params.confidence, params.seed = settings.maxIterations, settings.confidence, settings.seed
        found = [noiseOf(pair, *model) if model is not None else None for pair, model in zip(left, models(left, params))]
        left = [pair for pair, noise in zip(left, found) if noise is not None]
        noises = [n for n in found if n is not None]
        if not noises:
            raise CollectionError("nothing")
        core = float(np.median([n.core for n in noises]))
        sigma = core * float(np.quantile([n.sigma / n.core for n in noises], PART_OF_PAIRS))
        if debug: print("core", round(core, 3), "old", float(np.median([n.sigma for n in noises])))
        if debug: print("   round", r, "thr %.3f" % threshold, len(left), "sigma %.3f" % sigma, np.round(np.quantile([n.sigma for n in noises], [0, .1, .25, .75, .9, 1]), 3)); 
        if debug > 1: print([(p.key, round(n.sigma, 2), n.inliers) for p, n in zip(left, noises)])
        previous, threshold = threshold, IN_SIGMAS * sigma
        if r and abs(threshold / previous - 1) < SETTLED:
            break
        params = Params()
    return ThresholdEstimate(threshold, sigma, 0, len(pairs), len(left))
