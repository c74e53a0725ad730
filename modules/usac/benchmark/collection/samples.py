#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Measures how many samples a pair of images needs, and the time that pairs without overlap take.

    samples.py counted                                      # synthetic collections, scattered matches
    samples.py counted --database DB --cameras cameras.json # and pairs of photographs
    samples.py cost

counted: measures c, the number of samples that a sample of USACV20 counts as when the needed number is
computed (countedAs() of src/two_view/rules.cpp). c exceeds 1 because models are also found from samples
with outliers. Pairs are estimated with several limits of the number of samples. If I of N matches are
right, a fraction p = C(I, m) / C(N, m) of the samples of m matches has only right ones, and n samples
are assumed to miss the model with probability (1 - p)^(c n). I is the number of right matches among the
inliers, with the limit that finds the most. For each model (E, F) and each range of I with at least ten
pairs, the table has the number of pairs, the c of maximum likelihood, in brackets the range of c whose
log-likelihood is less than 2 below the maximum, and the number of missed pairs for each limit. A pair
is missed if its result is wrong or has fewer than I / 2 right inliers. There are three kinds of pairs:

- collections: pairs of synthetic collections (rings of cameras, streets and courts) with all matches;
- scattered: a quarter of the matches is right; right and wrong matches are anywhere in both images;
- photographs: of the right matches of a pair in COLMAP's database (Sampson distance below 0.6 px with
  the true cameras), 16 to 50 are drawn, and three times as many random pairs of keypoints are added.

cost: measures CPU milliseconds of pairs without and with overlap, with --threshold auto. Lost pairs are
counted, too: those that are found only with up to four times as many samples (confidence 1 - 10^-12
instead of 0.999) and without the inlier ratios of the collection. The last column counts the opposite:
pairs that are found only with the usual number of samples. A pair counts as found if at least half of
its inliers are right matches."""

from __future__ import annotations

import argparse
import dataclasses
import json
import math
import os
import sqlite3
import sys
import tempfile
import time
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Set, Tuple

import numpy as np
import numpy.typing as npt

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "modules", "usac", "misc", "python", "test"))

from compare_colmap import readCameras  # noqa: E402
from streets import OVERLAP, Options, Street  # noqa: E402
from usac_camera import rotation  # noqa: E402
from usac_collection import MAX_IMAGES, Collection, Kind, Label, Recipe  # noqa: E402
from usacv20 import Params, estimateEssentials, estimateFundamentals  # noqa: E402
from usacv20.collection._database import DatabaseSource  # noqa: E402
from usacv20.collection._geometry import verifyPairs  # noqa: E402
from usacv20.collection._pair import Pair  # noqa: E402
from usacv20.collection._settings import Settings  # noqa: E402
from usacv20.collection._threshold import estimateThreshold, samplePairs  # noqa: E402

Floats = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# Limits of the number of samples, by the size of a minimal sample: 5 for E, 7 for F.
LIMITS = {5: (125, 500, 2000, 10000), 7: (125, 500, 2000, 10000, 60000)}
# Ranges of the number of right matches, with a row of the table for each; the upper end is excluded.
RANGES = ((15, 20), (20, 25), (25, 30), (30, 40), (40, 50), (50, 70), (70, 10**6))
LIKELY = 2  # the range of c has all values whose log-likelihood is less than LIKELY below the maximum


class Matches(NamedTuple):
    first: Floats  # N x 2, pixels
    second: Floats
    K1: Floats
    K2: Floats
    right: Mask
    threshold: float  # pixels


class Truth(NamedTuple):
    right: Set[Tuple[int, int]]  # the right matches: indices of the keypoints in image 1 and image 2
    overlap: Optional[bool]  # None: there are common points, but fewer than OVERLAP, so the pair is not counted


def ofRing(collection: Collection) -> Dict[int, Truth]:
    return {pair.pairId: Truth(set(map(tuple, pair.matches[pair.labels == Label.RIGHT].tolist())),
                               pair.kind not in (Kind.NONE, Kind.WATERMARK)) for pair in collection.pairs}


def ofStreet(street: Street) -> Dict[int, Truth]:
    result = {}
    for key, matches in street.matches.items():
        i, j = divmod(key, MAX_IMAGES)
        a, b = street.images[i - 1].points[matches[:, 0]], street.images[j - 1].points[matches[:, 1]]
        common = street.common[key]
        result[key] = Truth(set(map(tuple, matches[(a == b) & (a >= 0)].tolist())), common >= OVERLAP if common == 0 or common >= OVERLAP else None)
    return result


def collections(seeds: int, known: bool, folder: str) -> Iterator[Tuple[str, str, Dict[int, Truth]]]:
    """Makes synthetic collections; yields for each its name, the path of its database, and the truth of
    its pairs as {pair_id: Truth}."""
    for seed in range(seeds):
        for name, wrong, noise in (("ring, 30 to 70 % wrong", (0.3, 0.7), 0.5), ("ring, 40 to 80 %", (0.4, 0.8), 0.5),
                                   ("ring, 50 to 80 %, noisy", (0.5, 0.8), 1.0)):
            ring = Collection(Recipe(images=30, wrong=wrong, noise=noise, seed=seed, cameras=(("SIMPLE_RADIAL", known),)))
            path = os.path.join(folder, "{}{}.db".format(name[5:10], seed))
            ring.write(path)
            yield name, path, ofRing(ring)
        for layout in ("street", "alike", "court"):
            street = Street(Options(layout, 24, known=known, seed=seed))
            path = os.path.join(folder, "{}{}.db".format(layout, seed))
            street.write(path)
            yield {"alike": "equal sides"}.get(layout, layout), path, ofStreet(street)


def pairsOf(path: str) -> Tuple[List[Pair], Settings]:
    source = DatabaseSource(path)
    found = estimateThreshold(samplePairs(source), Settings())
    pairs = [pair for pair in source.load(list(source.keys())) if isinstance(pair, Pair)]
    return pairs, dataclasses.replace(Settings(), threshold=found.threshold, ratios=found.ratios)


def inCollections(seeds: int, folder: str) -> Iterator[Matches]:
    for _, path, truth in collections(seeds, True, folder):
        pairs, settings = pairsOf(path)
        for pair in pairs:
            of = truth[pair.key]  # type: ignore[index]
            right = np.array([match in of.right for match in map(tuple, pair.matches.tolist())])
            if of.overlap and right.sum() >= RANGES[0][0]:
                yield Matches(pair.first.points, pair.second.points, pair.first.matrix, pair.second.matrix, right, settings.threshold)


def withWrong(rng: np.random.RandomState, first: Floats, second: Floats, wrong: Tuple[Floats, Floats], K1: Floats, K2: Floats,
              threshold: float) -> Matches:
    order = rng.permutation(len(first) + len(wrong[0]))
    return Matches(np.concatenate([first, wrong[0]])[order], np.concatenate([second, wrong[1]])[order], K1, K2, order < len(first), threshold)


def scattered(seeds: int) -> Iterator[Matches]:
    rng, K, size = np.random.RandomState(5), np.array([[1400, 0, 800], [0, 1400, 600], [0, 0, 1.0]]), np.array([1600, 1200])
    for right in (16, 20, 26, 36, 50, 80):
        for _ in range(20 * seeds):
            R, t = rotation(rng.normal(0, 0.12, 3)), rng.normal(0, 1, 3)
            X = rng.uniform([-4, -3, 5], [4, 3, 14], (100 * right, 3))
            Y = X @ R.T + 1.5 * t / np.linalg.norm(t)
            x, y = ((P / P[:, 2:] @ K.T)[:, :2] for P in (X, Y))
            seen = np.flatnonzero((Y[:, 2] > 1) & ((x > 0) & (x < size) & (y > 0) & (y < size)).all(1))[:right]
            first, second = (points[seen] + rng.normal(0, 0.4, (len(seen), 2)) for points in (x, y))
            wrong = rng.uniform(0, size, (2, 3 * len(seen), 2))
            yield withWrong(rng, first, second, (wrong[0], wrong[1]), K, K, 0.9)


def photographs(seeds: int, path: str, cameras: str) -> Iterator[Matches]:
    rng, true = np.random.RandomState(3), readCameras(cameras)
    database = sqlite3.connect(path)
    names = dict(database.execute("SELECT image_id, name FROM images"))
    points = {image: np.frombuffer(data, np.float32).reshape(rows, cols)[:, :2].astype(float)
              for image, rows, cols, data in database.execute("SELECT image_id, rows, cols, data FROM keypoints")}
    for key, rows, data in database.execute("SELECT pair_id, rows, data FROM matches WHERE rows > 0 ORDER BY pair_id"):
        i, j = divmod(key, MAX_IMAGES)
        matches = np.frombuffer(data, np.uint32).reshape(rows, 2)
        a, b = true[names[i]], true[names[j]]
        R = b.R @ a.R.T
        t = b.t - R @ a.t
        F = np.linalg.inv(b.K).T @ np.cross(t, R.T).T @ np.linalg.inv(a.K)
        x, y = (np.column_stack([points[image][matches[:, side]], np.ones(rows)]) for side, image in enumerate((i, j)))
        l1, l2 = y @ F, x @ F.T
        error = np.abs((y * l2).sum(1)) / np.sqrt((l1[:, :2]**2).sum(1) + (l2[:, :2]**2).sum(1))
        good = np.flatnonzero(error < 0.6)
        for right in (16, 20, 26, 36, 50):
            for _ in range(seeds if len(good) >= right else 0):
                taken = rng.choice(good, right, replace=False)
                first, second = (points[image][rng.choice(len(points[image]), 3 * right)] for image in (i, j))
                yield withWrong(rng, x[taken, :2], y[taken, :2], (first, second), a.K, b.K, 0.9)


def found(pairs: Sequence[Matches], m: int, limit: int) -> Tuple[npt.NDArray[np.int64], Mask]:
    """Estimates E (m = 5) or F (m = 7) of the pairs with at most `limit` samples of m matches. Returns
    two arrays with an entry for each pair, in the order of the pairs' thresholds: the number of right
    matches among the inliers, and whether the result is right (at least 15 inliers, of which at least
    half are right)."""
    right, good = [], []
    for threshold in sorted({pair.threshold for pair in pairs}):
        params = Params(threshold=threshold, confidence=0.9999, maxIterations=limit, significance=1e-4)
        some = [pair for pair in pairs if pair.threshold == threshold]
        lists = [pair.first for pair in some], [pair.second for pair in some]
        results = (estimateEssentials(*lists, [pair.K1 for pair in some], [pair.K2 for pair in some], params=params) if m == 5
                   else estimateFundamentals(*lists, params))
        for pair, result in zip(some, results):
            mask = np.zeros(len(pair.right), bool) if result[1] is None else np.asarray(result[1]).ravel() != 0
            right.append(int((mask & pair.right).sum()))
            good.append(mask.sum() >= 15 and 2 * right[-1] >= mask.sum())
    return np.array(right), np.array(good, bool)


def allInlier(right: npt.NDArray[np.int64], matches: npt.NDArray[np.int64], m: int) -> Floats:
    return np.prod([(right - i) / (matches - i) for i in range(m)], axis=0)


def countedRows(kind: str, pairs: List[Matches]) -> None:
    pairs.sort(key=lambda pair: pair.threshold)  # found() returns its results in this order
    matches = np.array([len(pair.right) for pair in pairs])
    for m, name in ((5, "E"), (7, "F")):
        tried = [found(pairs, m, limit) for limit in LIMITS[m]]
        most = np.max([right for right, _ in tried], axis=0)  # largest number of right inliers with any of the limits
        hit = np.array([good & (2 * right >= most) for right, good in tried])
        values = 2.0**np.arange(-2, 10, 0.25)
        for low, high in RANGES:
            here = (most >= low) & (most < high)
            if here.sum() < 10:
                continue
            logs = np.log1p(-np.minimum(allInlier(most[here], matches[here], m), 1 - 1e-12)) * np.array(LIMITS[m])[:, None]
            likelihood = []
            for value in values:
                missed = np.clip(np.exp(value * logs), 1e-12, 1 - 1e-12)
                likelihood.append(np.where(hit[:, here], np.log1p(-missed), np.log(missed)).sum())
            likely = values[np.array(likelihood) > max(likelihood) - LIKELY]
            print("| {} | {} | {} | {} | {:.1f} [{:.1f}, {:.1f}] | {} |".format(
                kind, name, "{} to {}".format(low, high - 1) if high < 10**6 else "{} and more".format(low), here.sum(),
                values[int(np.argmax(likelihood))], likely[0], likely[-1], " / ".join(str(n) for n in (~hit[:, here]).sum(1))), flush=True)


def counted(options: argparse.Namespace, folder: str) -> None:
    print("| pairs | model | right matches | number | counts as | missed, with {} (E) or {} (F) samples |\n|---|---|---|---|---|---|".format(
        *(" / ".join(map(str, LIMITS[m])) for m in (5, 7))))
    countedRows("collections", list(inCollections(options.seeds, folder)))
    countedRows("scattered", list(scattered(options.seeds)))
    if options.database:
        countedRows("photographs", list(photographs(options.seeds, options.database, options.cameras)))


def cost(options: argparse.Namespace, folder: str) -> None:
    print("| collection | without overlap | ms | samples | with overlap | ms | lost | also lost the other way |\n|---|---|---|---|---|---|---|---|")
    table: Dict[str, List[Any]] = {}
    for name, path, truth in collections(options.seeds, not options.unknown, folder):
        pairs, settings = pairsOf(path)
        rows = table.setdefault(name, [])
        for pair in pairs:
            of = truth[pair.key]  # type: ignore[index]
            begin = time.process_time()
            result = verifyPairs([pair], settings)[0]
            took = 1e3 * (time.process_time() - begin)
            if of.overlap is None:
                continue
            hits = []
            for inliers in (result.inliers, verifyPairs([pair], dataclasses.replace(settings, ratios=(), confidence=1 - 1e-12))[0].inliers
                            if of.overlap else np.empty((0, 2))):
                hits.append(len(inliers) > 0 and 2 * len(of.right & set(map(tuple, inliers.tolist()))) >= len(inliers))
            rows.append((of.overlap, took, result.iterations, *hits))
    for name, rows in table.items():
        overlap, took, samples, now, full = np.array(rows).T
        none, some = overlap == 0, overlap == 1
        print("| {} | {} | {:.2f} | {:.0f} | {} | {:.2f} | {:.0f} of {:.0f} | {:.0f} |".format(
            name, none.sum(), took[none].mean(), samples[none].mean(), some.sum(), took[some].mean(), (full * (1 - now)).sum(), full.sum(),
            (now * (1 - full)).sum()))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", choices=("counted", "cost"))
    parser.add_argument("--seeds", type=int, default=2, help="collections of each kind (default %(default)s)")
    parser.add_argument("--unknown", action="store_true", help="cost: the focal lengths are not known")
    parser.add_argument("--database", help="counted: COLMAP's database with keypoints and matches of photographs")
    parser.add_argument("--cameras", help="counted: the true cameras of these photographs, see compare_colmap.py")
    options = parser.parse_args()
    if bool(options.database) != bool(options.cameras):
        parser.error("--database and --cameras belong together")
    with tempfile.TemporaryDirectory() as folder:
        (counted if options.table == "counted" else cost)(options, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
