#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Counts the configurations that estimateTwoViewGeometry gives to synthetic pairs. Pairs with wrong
focal lengths should be UNCALIBRATED (on a plane PLANAR_OR_PANORAMIC), so that a mapper does not use
their essential matrix; pairs with right ones should not, whatever wrong matches they have.

    configurations.py --scenes 20
    configurations.py --kinds repeated --motions general forward side short --threshold 4

Images have 640 x 480 pixels, a focal length of 600 pixels, and noise with a standard deviation of 0.4
pixels in each coordinate. Some of the right matches are on a tilted plane, which the optical axis of
camera 1 meets at depth 6; the others are at depths of 4 to 9. With the motion `general`, the camera
rotates about this point of the plane by 0.05 to 0.3 radians and is also shifted by 0.5 to 1.2 (in the
unit of the depths). The kinds of pairs:

wrong     the focal length of both cameras is given too small or too large, by factors of 0.5 to 4; 60
          to 300 right matches, up to 90 % on a plane; no wrong matches, or half as many as right ones
          (uniform, in 3 or in 10 clusters)
right     right focal lengths; 20 to 300 right matches, up to all on a plane; 0 to 300 wrong matches
          (uniform, in 3 or in 10 clusters)
repeated  right focal lengths; the wrong matches are copies of right ones whose second point is shifted
          by 10, 20 or 40 pixels to the left or right, as if it was matched with the next window of a
          facade

Columns: kind and motion, the number of pairs, and how many of them get each configuration; `changed`
is the sum of UNCALIBRATED and PLANAR_OR_PANORAMIC, which have no essential matrix."""

from __future__ import annotations

import argparse
import itertools
import sys
from typing import Iterator, List, NamedTuple, Tuple

import numpy as np
import numpy.typing as npt

import usacv20

Floats = npt.NDArray[np.float64]

SIZE, FOCAL, NOISE = np.array([640.0, 480.0]), 600.0, 0.4  # pixels
DEPTH = 6.0  # at which the optical axis of camera 1 meets the plane; the motion `general` rotates about this point
NAMES = ("UNDEFINED", "DEGENERATE", "CALIBRATED", "UNCALIBRATED", "PLANAR", "PANORAMIC", "PLANAR_OR_PANORAMIC", "WATERMARK")
CLUSTER = 15.0  # standard deviation of the points of a cluster, pixels
FOCAL_FACTORS = (0.5, 0.67, 1.5, 2, 3, 4)


class Cell(NamedTuple):
    """One combination of the properties of a pair; each kind of pairs has many combinations."""

    right: int  # number of right matches
    planar: float  # fraction of the right matches that are on a plane
    wrong: int  # number of wrong matches
    clusters: int  # number of clusters of wrong matches; 0: their points are uniform
    # Horizontal distance of a wrong match's second point from that of the right match of which it is a copy, pixels. 0: wrong
    # matches are not copies of right ones.
    shift: float
    factor: float  # the given focal length, divided by the true one


def cells(kind: str) -> Iterator[Cell]:
    if kind == "wrong":
        for factor, planar, right, (part, clusters) in itertools.product(
                FOCAL_FACTORS, (0, 0.35, 0.5, 0.65, 0.8, 0.9), (60, 150, 300), ((0, 0), (0.5, 0), (0.5, 3), (0.5, 10))):
            yield Cell(right, planar, int(part * right), clusters, 0, factor)
    elif kind == "right":
        for right, planar, wrong, clusters in itertools.product(
                (20, 40, 60, 150, 300), (0, 0.5, 0.8, 0.9, 1), (0, 20, 60, 150, 300), (0, 3, 10)):
            if wrong or not clusters:
                yield Cell(right, planar, wrong, clusters, 0, 1)
    else:
        for right, planar, part, shift in itertools.product((60, 150, 300), (0, 0.5, 0.8), (0.3, 0.6, 1), (10, 20, 40)):
            yield Cell(right, planar, int(part * right), 0, shift, 1)


def rotation(rng: np.random.RandomState, angle: float) -> Floats:
    axis = rng.normal(size=3)
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def motion(rng: np.random.RandomState, name: str) -> Tuple[Floats, Floats]:
    """Returns rotation and translation of the second camera."""
    angle = rng.uniform(0.05, 0.3)
    if name == "general":
        R, t, axis = rotation(rng, angle), rng.normal(size=3), np.array([0, 0, DEPTH])
        return R, t * rng.uniform(0.5, 1.2) / np.linalg.norm(t) + axis - R @ axis
    little = 0.05 * rng.normal(size=2)
    t = {"forward": np.array([*little, -1]), "side": np.array([0.8, *little]), "short": 0.1 * rng.normal(size=3)}[name]
    return rotation(rng, angle / 5), t


def rightMatches(rng: np.random.RandomState, cell: Cell, name: str) -> Tuple[Floats, Floats]:
    R, t = motion(rng, name)
    normal = np.array([*rng.uniform(-0.6, 0.6, 2), 1])
    K, first, second = np.diag([FOCAL, FOCAL, 1]), np.empty((0, 2)), np.empty((0, 2))
    K[:2, 2] = SIZE / 2
    for count, onPlane in ((round(cell.planar * cell.right), True), (cell.right, False)):
        while len(first) < count:
            points = rng.uniform(0, SIZE, (500, 2))
            rays = np.c_[(points - SIZE / 2) / FOCAL, np.ones(500)]
            depths = DEPTH / np.maximum(rays @ normal, 0.1) if onPlane else rng.uniform(4, 9, 500)
            seen = (rays * depths[:, None]) @ R.T + t
            projected = (seen @ K.T)[:, :2] / np.maximum(seen[:, 2:], 0.1)
            visible = (depths > 1) & (depths < 30) & (seen[:, 2] > 0.5) & np.all((projected > 0) & (projected < SIZE), axis=1)
            first = np.r_[first, points[visible]][:count]
            second = np.r_[second, projected[visible]][:count]
    return first + NOISE * rng.normal(size=first.shape), second + NOISE * rng.normal(size=second.shape)


def wrongMatches(rng: np.random.RandomState, cell: Cell, first: Floats, second: Floats) -> Tuple[Floats, Floats]:
    n = cell.wrong
    if cell.shift:
        shifts = np.c_[rng.choice((-cell.shift, cell.shift), n), np.zeros(n)]
        return first[:n] + NOISE * rng.normal(size=(n, 2)), second[:n] + shifts + NOISE * rng.normal(size=(n, 2))
    if not cell.clusters:
        return rng.uniform(0, SIZE, (n, 2)), rng.uniform(0, SIZE, (n, 2))
    chosen = np.arange(n) % cell.clusters
    one, two = (rng.uniform(0, SIZE, (cell.clusters, 2))[chosen] + CLUSTER * rng.normal(size=(n, 2)) for _ in range(2))
    return one, two


def pairOf(cell: Cell, name: str, seed: int) -> usacv20.TwoViewPair:
    rng = np.random.RandomState([seed, cell.right, cell.wrong, cell.clusters, round(100 * cell.planar), int(cell.shift),
                                 round(100 * cell.factor)])
    first, second = rightMatches(rng, cell, name)
    more = wrongMatches(rng, cell, first, second)
    order = rng.permutation(cell.right + cell.wrong)
    K = np.array([[cell.factor * FOCAL, 0, SIZE[0] / 2], [0, cell.factor * FOCAL, SIZE[1] / 2], [0, 0, 1]])
    return usacv20.TwoViewPair(np.r_[first, more[0]][order], np.r_[second, more[1]][order], K, K)


def row(kind: str, name: str, found: List[usacv20.TwoViewGeometry]) -> str:
    counts = np.bincount([int(one.configuration) for one in found], minlength=len(NAMES))
    numbers = [len(found), counts[3] + counts[6], *counts]
    return "| {} | {} | {} |".format(kind, name, " | ".join(map(str, numbers)))


def main() -> int:
    parser = argparse.ArgumentParser(description="Counts the configurations of synthetic pairs.")
    parser.add_argument("--kinds", nargs="+", choices=("wrong", "right", "repeated"), default=["wrong", "right", "repeated"])
    parser.add_argument("--motions", nargs="+", choices=("general", "forward", "side", "short"), default=["general"],
                        help="of the camera; short: a baseline of about a fortieth of the depth")
    parser.add_argument("--threshold", type=float, default=1, help="pixels (default %(default)s)")
    parser.add_argument("--samples", type=int, help="largest number of samples of a search (default: that of Params)")
    parser.add_argument("--scenes", type=int, default=20, help="pairs of each cell (default %(default)s)")
    parser.add_argument("--cells", action="store_true", help="a row for each cell, too")
    options = parser.parse_args()
    params = usacv20.Params()
    params.threshold = options.threshold
    if options.samples:
        params.maxIterations = options.samples
    print("| kind | motion | pairs | changed | {} |\n|---|---|{}".format(" | ".join(NAMES), (2 + len(NAMES)) * "---:|"))
    for kind, name in itertools.product(options.kinds, options.motions):
        found: List[usacv20.TwoViewGeometry] = []
        for cell in cells(kind):
            pairs = [pairOf(cell, name, seed) for seed in range(options.scenes)]
            found += usacv20.estimateTwoViewGeometries(pairs, params)
            if options.cells:
                print(row(" ".join("{}={:g}".format(*item) for item in cell._asdict().items()), name, found[-len(pairs):]))
        print(row(kind, name, found), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
