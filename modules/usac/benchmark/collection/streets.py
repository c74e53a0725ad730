#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes synthetic collections of photographs of streets and courts with repeated windows and known
cameras, and counts the pairs that the verification keeps, that is, accepts.

    streets.py --seeds 3 --layout street court
    streets.py --significance 1e-4 1e-8 1e-12

Each facade has a grid of windows of one kind, and unique points; a scene has windows of one or two
kinds. All windows of a kind have the same parts (in front of and behind the plane of the facade) and
nearly the same descriptors; descriptors change with the viewing direction. Matches are mutual nearest
neighbors of the descriptors that pass a ratio test of 0.8. So images without a common point have
matches between different windows, and many of these matches agree with a motion that no camera has
made. Scales and angles of keypoints follow from the surface, with noise as in photographs: between
the two keypoints of a right match they differ with standard deviations of 0.13 octaves and 3.5
degrees (those of the Gaussian part of the differences that were measured with COLMAP's SIFT on eleven
surveyed collections).

Columns, with sums over --seeds collections; only pairs with at least 15 matches count:
layout         kind of the scene, see --layout
chance         --significance, the largest false-alarm probability of an accepted pair
loops          yes: pairs that contradict a path of other pairs are refused; no: they are kept
overlap, kept  number of pairs with overlap (at least 30 common points), and how many of these are kept
without, kept  number of pairs without a common point, and how many of these are kept
calibrated     number of the kept pairs without a common point that are CALIBRATED, so that a mapper
               uses their wrong poses
right          number of kept pairs of which at least half of the inliers are right
lost           number of such pairs that are kept without the check of loops, but refused by it
CPU s          CPU time of the verification in seconds"""

from __future__ import annotations

import argparse
import itertools
import os
import sqlite3
import sys
import tempfile
import time
from typing import Any, Dict, List, NamedTuple, Tuple

import numpy as np
import numpy.typing as npt

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "modules", "usac", "misc", "python", "test"))

import usac_colmap as uc  # noqa: E402
from usac_collection import MAX_IMAGES, SCHEMA, lookAt  # noqa: E402
from usacv20.collection import verify  # noqa: E402

Floats = npt.NDArray[np.float64]

SIZE, FOCAL = (1600, 1200), 1400.0  # pixels
DIMENSIONS = 8  # dimensions of a descriptor; few, so that descriptors of different points can be similar
PLACES = 100  # upper limit of the number of windows of a facade
OVERLAP = 30  # least number of points that both images of a pair with overlap can see
# Standard deviations of the differences in scale (octaves) and angle (radians) of two keypoints of a
# right match.
SCALE_NOISE, ANGLE_NOISE = 0.13, np.radians(3.5)


class Facade(NamedTuple):
    origin: Floats  # the lower left corner as seen from the front
    along: Floats  # horizontal unit vector to the right as seen from the front
    normal: Floats  # unit vector to the front
    length: float  # meters
    kind: int  # facades with the same number have the same windows


class Points(NamedTuple):
    """The points of the scene."""

    position: Floats  # P x 3, meters
    along: Floats  # P x 3, horizontal direction of the facade
    normal: Floats  # P x 3, normal of the facade
    size: Floats  # P, size of the feature in meters
    angle: Floats  # P, orientation of the feature in the plane of the facade, radians
    descriptor: Floats  # P x DIMENSIONS
    change: Floats  # P x DIMENSIONS x 2: change of the descriptor with the viewing direction


class Options(NamedTuple):
    layout: str = "street"
    images: int = 24
    noise: float = 0.4  # standard deviation of each coordinate of a keypoint, pixels; three times as large for a tenth of them
    # How different windows of a kind look: standard deviation of the descriptors of the same part in
    # different windows, divided by that of the descriptors of unrelated points.
    alike: float = 0.45
    # Fraction of the variance of these differences that is common to windows at the same place of
    # different facades of a kind.
    shared: float = 0.5
    unique: int = 60  # number of points that do not belong to a window, for each ten meters of facade
    known: bool = True  # the focal length is known
    seed: int = 0


UP = np.array([0, 0, 1.0])


def facades(layout: str) -> List[Facade]:
    x, y = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    if layout == "street":
        return [Facade(np.array([0, 8.0, 0]), x, -y, 60, 0), Facade(np.array([60.0, -8.0, 0]), -x, y, 60, 1)]
    if layout == "alike":  # both sides of the street have the same windows
        return [Facade(np.array([0, 8.0, 0]), x, -y, 60, 0), Facade(np.array([60.0, -8.0, 0]), -x, y, 60, 0)]
    return [Facade(np.array([-14.0, 14, 0]), x, -y, 28, 0), Facade(np.array([14.0, 14, 0]), -y, -x, 28, 1),
            Facade(np.array([14.0, -14, 0]), -x, y, 28, 0), Facade(np.array([-14.0, -14, 0]), y, x, 28, 1)]


def buildPoints(rng: np.random.RandomState, options: Options) -> Points:
    parts: Dict[int, Tuple[Any, ...]] = {}
    columns: List[Tuple[Any, ...]] = []
    period, storey = np.array([2.4, 3.4]), 3  # horizontal and vertical spacing of the windows in meters; number of rows
    for facade in facades(options.layout):
        if facade.kind not in parts:
            count = 24
            parts[facade.kind] = (rng.uniform([0.2, 0.3, -0.3], [1.8, 2.4, 0.5], (count, 3)), 0.05 * 2**rng.normal(0, 0.8, count),
                                  rng.choice([0, np.pi / 2, np.pi, -np.pi / 2], count) + rng.normal(0, 0.3, count),
                                  rng.normal(size=(count, DIMENSIONS)), 0.8 * rng.normal(size=(count, DIMENSIONS, 2)),
                                  rng.normal(size=(PLACES, count, DIMENSIONS)))
        local, size, angle, descriptor, change, places = parts[facade.kind]
        for column, row in itertools.product(range(int(facade.length / period[0])), range(storey)):
            shifted = local + np.array([column * period[0], row * period[1], 0])
            own = np.sqrt(1 - options.shared) * rng.normal(size=descriptor.shape)
            own += np.sqrt(options.shared) * places[column * storey + row]
            columns.append((facade, shifted, size * 2**rng.normal(0, 0.05, len(size)), angle + rng.normal(0, 0.03, len(size)),
                            descriptor + options.alike * own, change))
        count = int(options.unique * facade.length / 10)
        columns.append((facade, rng.uniform([0, 0, -0.2], [facade.length, 11, 0.6], (count, 3)), 0.05 * 2**rng.normal(0, 0.8, count),
                        rng.uniform(-np.pi, np.pi, count), rng.normal(size=(count, DIMENSIONS)),
                        0.8 * rng.normal(size=(count, DIMENSIONS, 2))))
    position, along, normal = [], [], []
    for facade, local, *_ in columns:
        position.append(facade.origin + local[:, :1] * facade.along + local[:, 1:2] * UP + local[:, 2:] * facade.normal)
        along.append(np.broadcast_to(facade.along, local.shape))
        normal.append(np.broadcast_to(facade.normal, local.shape))
    rest = [np.concatenate([column[i] for column in columns]) for i in range(2, 6)]
    return Points(np.concatenate(position), np.concatenate(along), np.concatenate(normal), *rest)


def cameras(rng: np.random.RandomState, options: Options) -> List[Tuple[Floats, Floats]]:
    result = []
    for i in range(options.images):
        if options.layout == "court":
            angle = 2 * np.pi * i / options.images
            center = np.array([-4 * np.cos(angle), -4 * np.sin(angle), 1.7]) + rng.uniform(-1.5, 1.5, 3) * [1, 1, 0.3]
            target = center + 10 * np.array([np.cos(angle), np.sin(angle), 0.3]) + rng.uniform(-2, 2, 3)
        else:
            side = 1 if i % 2 else -1
            center = np.array([4 + 52 * i / options.images, -side * 3.0, 1.7]) + rng.uniform(-1, 1, 3) * [1, 1, 0.3]
            target = center + np.array([rng.uniform(-5, 5), side * 10, rng.uniform(1, 3)])
        result.append(lookAt(center, target, rng.uniform(-0.05, 0.05)))
    return result


class Image(NamedTuple):
    keypoints: Floats  # N x 4: x, y, scale in pixels, angle in radians
    points: npt.NDArray[np.int64]  # N, index of the point in the scene; -1: clutter, a keypoint without a point of the scene
    descriptors: Floats
    visible: npt.NDArray[np.int64]  # indices of the scene's points that could be detected


def photograph(rng: np.random.RandomState, points: Points, camera: Tuple[Floats, Floats], noise: float) -> Image:
    R, t = camera
    ray = -R.T @ t - points.position
    distance = np.linalg.norm(ray, axis=1)
    facing = (ray * points.normal).sum(1) / distance
    seen = points.position @ R.T + t
    pixels = FOCAL * seen[:, :2] / np.maximum(seen[:, 2:], 0.1) + np.array(SIZE) / 2
    visible = np.flatnonzero((facing > 0.25) & (seen[:, 2] > 1) & (pixels > 5).all(1) & (pixels < np.array(SIZE) - 5).all(1))
    found = visible[rng.uniform(size=len(visible)) < 0.6]

    def tangent(direction: Floats) -> Floats:
        moved = direction @ R.T
        return np.asarray(FOCAL * (moved[:, :2] - moved[:, 2:] * seen[found, :2] / seen[found, 2:]) / seen[found, 2:])

    u, v = tangent(points.along[found]), tangent(np.broadcast_to(UP, (len(found), 3)))
    scale = points.size[found] * np.sqrt(np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))
    turned = np.cos(points.angle[found])[:, None] * u + np.sin(points.angle[found])[:, None] * v
    angle = np.arctan2(turned[:, 1], turned[:, 0])
    scale = scale * 2**rng.normal(0, SCALE_NOISE / np.sqrt(2), len(found))
    angle = angle + rng.normal(0, ANGLE_NOISE / np.sqrt(2), len(found))
    view = np.stack([(ray * points.along).sum(1), ray[:, 2]], axis=1)[found] / distance[found, None]
    descriptors = points.descriptor[found] + np.einsum("ndk,nk->nd", points.change[found], view)
    descriptors = descriptors + 0.2 * rng.normal(size=descriptors.shape)
    heavy = np.where(rng.uniform(size=(len(found), 1)) < 0.1, 3, 1)
    located = pixels[found] + noise * heavy * rng.normal(size=(len(found), 2))
    clutter = len(found) // 3
    table = np.concatenate([np.column_stack([located, scale, angle]), np.column_stack([
        rng.uniform(0, SIZE, (clutter, 2)), 4 * 2**rng.normal(0, 0.8, clutter), rng.uniform(-np.pi, np.pi, clutter)])])
    return Image(table, np.concatenate([found, np.full(clutter, -1)]),
                 np.concatenate([descriptors, rng.normal(size=(clutter, DIMENSIONS))]), visible)


def match(first: Image, second: Image) -> npt.NDArray[np.uint32]:
    """Returns the indices of mutual nearest neighbors that pass a ratio test in both directions, and
    whose descriptors differ by an angle of less than 0.7 radians."""
    a, b = (side.descriptors / np.linalg.norm(side.descriptors, axis=1, keepdims=True) for side in (first, second))
    angles = np.arccos(np.clip(a @ b.T, -1, 1))
    forth, back = angles.argmin(1), angles.argmin(0)
    two, other = np.partition(angles, 1, axis=1)[:, :2], np.partition(angles, 1, axis=0)[:2]
    rows = np.arange(len(a))
    good = (back[forth] == rows) & (two[:, 0] < 0.8 * two[:, 1]) & (other[0] < 0.8 * other[1])[forth] & (two[:, 0] < 0.7)
    return np.stack([rows[good], forth[good]], axis=1).astype(np.uint32)


class Street:
    """A synthetic collection with its ground truth."""

    def __init__(self, options: Options) -> None:
        rng = np.random.RandomState(options.seed)
        self.options = options
        points = buildPoints(rng, options)
        self.cameras = cameras(rng, options)
        self.images = [photograph(rng, points, camera, options.noise) for camera in self.cameras]
        self.common: Dict[int, int] = {}  # by pair_id: number of points that both images see
        self.matches: Dict[int, npt.NDArray[np.uint32]] = {}
        for i, j in itertools.combinations(range(options.images), 2):
            matches = match(self.images[i], self.images[j])
            if len(matches) >= 15:
                key = MAX_IMAGES * (i + 1) + j + 1
                self.matches[key] = matches
                self.common[key] = len(np.intersect1d(self.images[i].visible, self.images[j].visible))

    def right(self, key: int) -> int:
        """Returns the number of matches of a pair whose two keypoints are images of the same point of
        the scene."""
        i, j = divmod(key, MAX_IMAGES)
        a, b = self.images[i - 1].points[self.matches[key][:, 0]], self.images[j - 1].points[self.matches[key][:, 1]]
        return int(np.count_nonzero((a == b) & (a >= 0)))

    def write(self, path: str) -> None:
        with sqlite3.connect(path) as database:
            database.executescript(SCHEMA)
            params = np.array([FOCAL, FOCAL, SIZE[0] / 2, SIZE[1] / 2])
            database.execute("INSERT INTO cameras VALUES (1, 1, ?, ?, ?, ?)", (*SIZE, params.tobytes(), int(self.options.known)))
            for number, image in enumerate(self.images, 1):
                database.execute("INSERT INTO images (image_id, name, camera_id) VALUES (?, ?, 1)",
                                 (number, "{:03}.png".format(number)))
                x, y, scale, angle = image.keypoints.T
                table = np.column_stack([x, y, scale * np.cos(angle), -scale * np.sin(angle), scale * np.sin(angle),
                                         scale * np.cos(angle)]).astype(np.float32)
                database.execute("INSERT INTO keypoints VALUES (?, ?, ?, ?)", (number, *table.shape, table.tobytes()))
            database.executemany("INSERT INTO matches VALUES (?, ?, 2, ?)",
                                 [(key, len(rows), rows.tobytes()) for key, rows in self.matches.items()])
        database.close()


class Count(NamedTuple):
    """Counts of the pairs of a verified database."""

    overlap: int  # pairs with at least 15 matches and at least OVERLAP common points
    kept: int  # how many pairs of `overlap` are kept
    lone: int  # pairs with at least 15 matches and no common point
    loneKept: int  # how many pairs of `lone` are kept
    loneCalibrated: int  # how many pairs of `lone` are kept as CALIBRATED
    right: int  # kept pairs of which at least half of the inliers are right
    cpu: float  # seconds


def verified(street: Street, path: str, options: Dict[str, Any]) -> Tuple[Count, List[int]]:
    """Verifies the database; returns the counts, and the keys of the kept pairs of which at least half
    of the inliers are right."""
    begin = time.process_time()
    verify(path, threads=1, **options)
    cpu = time.process_time() - begin
    kept = {key: row for key, row in uc.verified(path).items() if len(row.inliers)}
    right = []
    for key, row in kept.items():
        i, j = divmod(key, MAX_IMAGES)
        a, b = street.images[i - 1].points[row.inliers[:, 0]], street.images[j - 1].points[row.inliers[:, 1]]
        if np.mean((a == b) & (a >= 0)) >= 0.5:
            right.append(key)
    overlap = {key for key, common in street.common.items() if common >= OVERLAP}
    lone = {key for key, common in street.common.items() if common == 0}
    loneKept = lone & set(kept)
    return Count(len(overlap), len(overlap & set(kept)), len(lone), len(loneKept),
                 sum(kept[key].configuration == 2 for key in loneKept), len(right), cpu), right


def main() -> int:
    parser = argparse.ArgumentParser(description="Counts the pairs that the verification keeps, in synthetic streets and courts "
                                                 "with repeated windows.")
    parser.add_argument("--layout", nargs="+", choices=("street", "alike", "court"), default=["street", "alike", "court"])
    parser.add_argument("--images", type=int, default=24)
    parser.add_argument("--seeds", type=int, default=3, help="collections of each layout (default %(default)s)")
    parser.add_argument("--unknown", action="store_true", help="the focal lengths are not known")
    parser.add_argument("--significance", type=float, nargs="+", default=[1e-4])
    parser.add_argument("--keep", metavar="FOLDER", help="folder in which the databases are kept; those that already exist are used again (default: they are removed)")
    options = parser.parse_args()
    print("{:<8}{:>8}{:>7}{:>9}{:>7}{:>8}{:>7}{:>12}{:>7}{:>6}{:>8}".format(
        "layout", "chance", "loops", "overlap", "kept", "without", "kept", "calibrated", "right", "lost", "CPU s"))
    with tempfile.TemporaryDirectory() as folder:
        for layout in options.layout:
            counts: Dict[Tuple[float, bool], List[Tuple[int, ...]]] = {}
            for seed in range(options.seeds):
                street = Street(Options(layout, options.images, known=not options.unknown, seed=seed))
                path = os.path.join(options.keep or folder,
                                    "{}{}{}_{}.db".format(layout, options.images, "_unknown" if options.unknown else "", seed))
                if not os.path.exists(path):
                    street.write(path)
                for chance in options.significance:
                    before: List[int] = []
                    for loops in (False, True):
                        count, right = verified(street, path, dict(significance=chance, loops=loops))
                        counts.setdefault((chance, loops), []).append((*count, len(set(before) - set(right))))
                        before = right
            for (chance, loops), rows in counts.items():
                total = np.sum(rows, axis=0)
                print("{:<8}{:8.0e}{:>7}{:9.0f}{:7.0f}{:8.0f}{:7.0f}{:12.0f}{:7.0f}{:6.0f}{:8.1f}".format(
                    layout, chance, "yes" if loops else "no", *total[[0, 1, 2, 3, 4, 5, 7, 6]]), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
