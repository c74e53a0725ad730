#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""A synthetic collection of images with known cameras. Its matches can be written to a database in
the format of COLMAP 3.8.

The scene is a square building. One side is a flat mural, three sides are grids of equal windows
with balconies (repeated structure), and statues stand in front of all four sides. Four images are
taken close to the mural and show only points of its plane. Three images are taken from one position
in different directions. All others are taken from a ring around the building; images from opposite
sides of the ring show no common points. Two such opposite images show the same logo near their
lower right corners.
"""

from __future__ import annotations

import enum
import itertools
import sqlite3
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from usac_camera import distort, rotation

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

MAX_IMAGES = 2147483647  # pair_id = MAX_IMAGES * smaller image_id + larger image_id
# For each camera model: COLMAP's number, and the coefficients of the lens distortion, first the radial
# ones, then the tangential ones.
MODELS: Dict[str, Tuple[int, Tuple[float, ...]]] = {
    "SIMPLE_PINHOLE": (0, ()),
    "PINHOLE": (1, ()),
    "SIMPLE_RADIAL": (2, (-0.06,)),
    "RADIAL": (3, (-0.06, 0.02)),
    "OPENCV": (4, (-0.08, 0.02, 0.001, -0.0008)),
    "OPENCV_FISHEYE": (5, (-0.02, 0.006, -0.002, 0.0004)),
}
SCHEMA = """
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, model INTEGER NOT NULL, width INTEGER NOT NULL,
    height INTEGER NOT NULL, params BLOB, prior_focal_length INTEGER NOT NULL);
CREATE TABLE images (image_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, name TEXT NOT NULL UNIQUE, camera_id INTEGER NOT NULL,
    prior_qw REAL, prior_qx REAL, prior_qy REAL, prior_qz REAL, prior_tx REAL, prior_ty REAL, prior_tz REAL,
    CONSTRAINT image_id_check CHECK(image_id >= 0 and image_id < 2147483647),
    FOREIGN KEY(camera_id) REFERENCES cameras(camera_id));
CREATE UNIQUE INDEX index_name ON images(name);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
    FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE descriptors (image_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
    FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE matches (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB);
CREATE TABLE two_view_geometries (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
    config INTEGER NOT NULL, F BLOB, E BLOB, H BLOB, qvec BLOB, tvec BLOB);
PRAGMA user_version = 3800;
"""


class Kind(enum.Enum):
    """The true relation between the two images of a pair."""

    GENERAL = "general"
    PLANAR = "planar"  # all right matches are of points in one plane
    ROTATION = "rotation"  # both images are taken from the same position
    NONE = "none"  # fewer than 30 common points; the matches are random
    WATERMARK = "watermark"  # no common points except a logo


class Label(enum.IntEnum):
    """The true kind of a match."""

    RANDOM = 0
    RIGHT = 1
    # A point of a window is matched to the corresponding point of another window. In a pair of
    # images, all matches of this kind have the same offset between the two windows.
    COPY = 2
    LOGO = 3


class Recipe(NamedTuple):
    """The parameters of a collection; equal recipes give identical databases."""

    images: int = 23  # at least 12
    noise: float = 0.5  # standard deviation of each coordinate, pixels
    density: float = 1.0  # factor of the number of points; 1: about 370 keypoints in an image on average
    wrong: Tuple[float, float] = (0.3, 0.7)  # range of the fraction of wrong matches in pairs with overlap
    lone: Tuple[float, float] = (0.1, 0.3)  # in pairs without overlap: range of (number of matches) / (smaller number of keypoints)
    lonePairs: float = 1.0  # probability that a pair without overlap has matches at all
    copies: float = 0.3  # about this fraction of the wrong matches are of Label.COPY; fewer if few windows are visible
    # For each camera: its model, and whether its focal length is known. The images use the cameras in
    # turn.
    cameras: Tuple[Tuple[str, bool], ...] = (("SIMPLE_RADIAL", True),)
    columns: int = 6  # number of columns of the table of keypoints: 2, 4 or 6
    size: Tuple[int, int] = (1600, 1200)
    seed: int = 0


class Lens(NamedTuple):
    """A camera with its true parameters. The database can have other parameters, see stored()."""

    model: str
    params: Floats
    focalKnown: bool

    def split(self) -> Tuple[Floats, Floats]:
        """Returns (K, parameters of the lens distortion)."""
        # number of image axes that share a focal length: 2 (models with one focal length) or 1 (fx and fy)
        own = 2 if self.model in ("SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL") else 1
        fx, fy, cx, cy = self.params[[0, 0, 1, 2]] if own == 2 else self.params[:4]
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), self.params[3 if own == 2 else 4:]

    def project(self, seen: Floats) -> Floats:
        """Projects points in camera coordinates to pixels."""
        K, lens = self.split()
        plane = seen[:, :2] / seen[:, 2:]
        if self.model == "OPENCV_FISHEYE":
            radius = np.maximum(np.linalg.norm(plane, axis=1, keepdims=True), 1e-12)
            theta = np.arctan(radius)
            plane = plane * theta * (1 + sum(k * theta ** (2 * i + 2) for i, k in enumerate(lens))) / radius
        elif len(lens):
            plane = distort(plane, np.concatenate([lens, np.zeros(5 - len(lens))]))
        return np.asarray(plane @ K[:2, :2].T + K[:2, 2], float)

    def stored(self, size: Tuple[int, int]) -> Floats:
        """Returns the parameters for the database. If the focal length is unknown, it is replaced by
        COLMAP's guess, 1.2 times the longer side, and the distortion by 0."""
        if self.focalKnown:
            return self.params
        params = self.params.copy()
        center = len(params) - len(self.split()[1]) - 2
        params[:center] = 1.2 * max(size)
        params[center + 2:] = 0
        return params


class Space(NamedTuple):
    """The P points of the scene."""

    points: Floats  # P x 3
    normals: Floats  # P x 3, surface normals; points are visible only from the front
    sides: Integers  # P: side of the building; 0 is the side with the mural
    flat: npt.NDArray[np.bool_]  # P: true if the point lies in the plane of its side
    windows: Integers  # 3 sides x COLUMNS x ROWS x parts of a window: indices of points


class PairTruth(NamedTuple):
    """A pair of images (numbered from 0) and its matches with their ground truth."""

    first: int
    second: int
    kind: Kind
    matches: npt.NDArray[np.uint32]  # M x 2: indices of keypoints
    labels: Integers  # M, values of Label
    flatShare: float  # fraction of the right matches in the plane with the most right matches

    @property
    def pairId(self) -> int:
        return MAX_IMAGES * (self.first + 1) + self.second + 1

    @property
    def right(self) -> npt.NDArray[np.bool_]:
        return np.asarray(self.labels == Label.RIGHT)


def frame(side: int) -> Tuple[Floats, Floats]:
    """Returns (outward normal, direction to the right seen from outside) of a side of the building."""
    angle = side * np.pi / 2
    return np.array([np.cos(angle), np.sin(angle), 0]), np.array([-np.sin(angle), np.cos(angle), 0])


HALF_WIDTH, HEIGHT = 2.5, 4.0  # half the width, and the height of the building; its vertical axis is the z axis
COLUMNS, ROWS = 5, 3  # numbers of columns and rows of windows on a side


def buildSpace(rng: np.random.RandomState, density: float) -> Space:
    points: List[Floats] = []
    normals: List[Floats] = []
    sides: List[int] = []
    flat: List[bool] = []

    def add(side: int, across: float, up: float, before: float, normal: Optional[Floats] = None) -> int:
        out, along = frame(side)
        points.append((HALF_WIDTH + before) * out + across * along + np.array([0, 0, up]))
        normals.append(out if normal is None else normal)
        sides.append(side)
        flat.append(before == 0)
        return len(points) - 1

    for across, up in rng.uniform([-2.4, 0.2], [2.4, 3.8], (int(170 * density), 2)):
        add(0, across, up, 0)
    # positions of the points of a window and its balcony: across, up, distance in front of the wall
    parts = rng.uniform([0.05, 0.05, 0.1], [0.85, 1.15, 0.9], (int(12 * density), 3))
    parts[::2, 2] = 0
    windows = np.zeros((3, COLUMNS, ROWS, len(parts)), int)
    for side, column, row, part in itertools.product(range(3), range(COLUMNS), range(ROWS), range(len(parts))):
        across, up, before = parts[part]
        windows[side, column, row, part] = add(side + 1, across + column - HALF_WIDTH, up + row * 1.3, before)
    for side in range(4):
        for statue in range(4):
            center = np.array([rng.uniform(2.0, 2.8) * (-1) ** statue, rng.uniform(0.6, 2.5), rng.uniform(0.9, 2.0)])
            radii = rng.uniform([0.3, 0.4, 0.3], [0.6, 1.0, 0.6])
            for direction in rng.normal(size=(int((45 if side else 70) * density), 3)):
                direction /= np.linalg.norm(direction)
                out, along = frame(side)
                normal = direction[0] * along + direction[2] * out + np.array([0, 0, direction[1]])
                across, up, before = center + radii * direction
                add(side, across, up, before, normal)
    return Space(np.array(points), np.array(normals), np.array(sides), np.array(flat), windows)


def lookAt(center: Floats, target: Floats, roll: float) -> Tuple[Floats, Floats]:
    """Returns R, t of a camera at `center` that looks at `target` (axes: x right, y down, z forward).
    roll -- rotation about the viewing direction in radians"""
    ahead = (target - center) / np.linalg.norm(target - center)
    right = np.cross(ahead, [0, 0, 1.0])
    right /= np.linalg.norm(right)
    R: Floats = rotation([0, 0, roll]) @ np.array([right, np.cross(ahead, right), ahead])
    return R, -R @ center


class Collection:
    """The true cameras, keypoints and matches of a collection."""

    def __init__(self, recipe: Recipe = Recipe()) -> None:
        self.recipe = recipe
        self.rng = np.random.RandomState(recipe.seed)
        self.space = buildSpace(self.rng, recipe.density)
        self.lenses = [self._lens(model, known) for model, known in recipe.cameras]
        self.names: List[str] = []
        self.rotations: List[Floats] = []
        self.translations: List[Floats] = []
        self._placeCameras()
        self.keypoints: List[Floats] = []
        self.pointOf: List[Integers] = []  # for each image and keypoint, the index of the point of the scene, or -1
        for image in range(recipe.images):
            self._detect(image)
        ring = [i for i, name in enumerate(self.names) if name.startswith("ring")]
        self.marked = (ring[0], ring[len(ring) // 2])
        self._logo = self._addLogo()
        self.pairs = [self._match(i, j) for i, j in itertools.combinations(range(recipe.images), 2)]
        keep = self.rng.uniform(size=len(self.pairs)) < recipe.lonePairs
        self.pairs = [pair for i, pair in enumerate(self.pairs) if keep[i] or pair.kind is not Kind.NONE]

    def _lens(self, model: str, known: bool) -> Lens:
        focal, (width, height) = 0.875 * max(self.recipe.size), self.recipe.size
        focals = (focal,) if model in ("SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL") else (focal, 1.01 * focal)
        return Lens(model, np.array([*focals, 0.51 * width, 0.49 * height, *MODELS[model][1]]), known)

    def lens(self, image: int) -> Lens:
        return self.lenses[image % len(self.lenses)]

    def center(self, image: int) -> Floats:
        return np.asarray(-self.rotations[image].T @ self.translations[image])

    def relative(self, first: int, second: int) -> Tuple[Floats, Floats]:
        """Returns R, t of the second camera relative to the first: x2 = R x1 + t, where x1 and x2 are
        a point in the coordinates of the two cameras."""
        R = self.rotations[second] @ self.rotations[first].T
        return R, self.translations[second] - R @ self.translations[first]

    def fromOneSpot(self, first: int, second: int) -> bool:
        return bool(np.linalg.norm(self.center(first) - self.center(second)) < 1e-9)

    def _place(self, name: str, center: Sequence[float], target: Sequence[float], roll: float) -> None:
        R, t = lookAt(np.array(center, float), np.array(target, float), roll)
        self.names.append(name)
        self.rotations.append(R)
        self.translations.append(t)

    def _placeCameras(self) -> None:
        rng, close, turning = self.rng, 4, 3
        ring = self.recipe.images - close - turning
        for i in range(ring):
            angle, radius = 2 * np.pi * (i + rng.uniform(-0.2, 0.2)) / ring, rng.uniform(8, 10)
            self._place("ring{:02}.png".format(i), [radius * np.cos(angle), radius * np.sin(angle), rng.uniform(0.5, 4.5)],
                        np.array([0, 0, HEIGHT / 2]) + rng.uniform(-0.4, 0.4, 3), rng.uniform(-0.1, 0.1))
        for i in range(close):
            self._place("close{:02}.png".format(i), [HALF_WIDTH + rng.uniform(2.6, 3.4), 0.8 * i - 1.2, rng.uniform(1.0, 3.0)],
                        [HALF_WIDTH, 0.3 * i - 0.45, HEIGHT / 2], rng.uniform(-0.2, 0.2))
        for i in range(turning):
            self._place("turning{:02}.png".format(i), [-5.6, 5.4, 1.7], [0.9 * i - 0.9, 0.9 * i - 0.9, 1.8 + 0.3 * i],
                        0.15 * i - 0.15)

    def _detect(self, image: int) -> None:
        """Adds the keypoints of an image: most of the visible points with noise, and random keypoints
        that show no point."""
        rng, size, space = self.rng, np.array(self.recipe.size), self.space
        seen = space.points @ self.rotations[image].T + self.translations[image]
        pixels = self.lens(image).project(np.where(seen[:, 2:] > 0.5, seen, 1))
        rays = self.center(image) - space.points
        facing = (rays * space.normals).sum(1) > 0.25 * np.linalg.norm(rays, axis=1)
        before = np.array([frame(side)[0] @ self.center(image) > HALF_WIDTH + 0.3 for side in range(4)])[space.sides]
        inside = (seen[:, 2] > 0.5) & (pixels > 10).all(1) & (pixels < size - 10).all(1)
        visible = facing & before & inside
        if self.names[image].startswith("close"):
            visible &= space.flat & (space.sides == 0)
        found = np.flatnonzero(visible & (rng.uniform(size=len(visible)) < 0.85))
        clutter = len(found) // 2
        points = np.concatenate([found, np.full(clutter, -1)])
        pixels = np.concatenate([pixels[found] + rng.normal(0, self.recipe.noise, (len(found), 2)),
                                 rng.uniform(0, size, (clutter, 2))])
        order = rng.permutation(len(points))
        self.keypoints.append(pixels[order].astype(np.float32).astype(float))
        self.pointOf.append(points[order])

    def _addLogo(self) -> Integers:
        """Adds the logo to two images; returns the matches of its points. The logo is near the border,
        because COLMAP searches for watermarks only within a tenth of the diagonal from the border."""
        size, count = np.array(self.recipe.size), 40
        shape = size - self.rng.uniform([20, 15], [0.3 * size[0], 0.08 * size[1]], (count, 2))
        numbers = []
        for image, shift in zip(self.marked, ((0, 0), (3, -2))):
            pixels = shape + shift + self.rng.normal(0, self.recipe.noise, (count, 2))
            numbers.append(np.arange(count) + len(self.keypoints[image]))
            self.keypoints[image] = np.concatenate([self.keypoints[image], pixels]).astype(np.float32).astype(float)
            self.pointOf[image] = np.concatenate([self.pointOf[image], np.full(count, -1)])
        return np.stack(numbers, axis=1)

    def _match(self, first: int, second: int) -> PairTruth:
        """Returns one-to-one matches in random order: some of the common points and copies (Label.COPY)
        if there are enough common points, the logo for two images, and random pairs of keypoints."""
        rng, enough = self.rng, 30
        a, b = self.pointOf[first], self.pointOf[second]
        common = np.intersect1d(a[a >= 0], b[b >= 0])
        logo = (first, second) == self.marked
        most = min(len(a), len(b))
        share = rng.uniform(*self.recipe.wrong)
        if len(common) < enough or logo:
            groups = [(self._logo, Label.LOGO)] if logo else []
            wrong = int(rng.uniform(*self.recipe.lone) * most)
        else:
            common = rng.permutation(common)[:int((1 - share) * most)]
            wrong = int(len(common) * share / (1 - share))
            # No copies for two images from the same position: copies and right matches would together
            # agree with one epipolar geometry and would wrongly indicate a translation.
            most = 0 if self.fromOneSpot(first, second) else min(int(self.recipe.copies * wrong), len(common) // 3)
            copies = self._copies(a, b, most)
            common = common[~np.isin(common, np.concatenate([a[copies[:, 0]], b[copies[:, 1]]]))]
            groups = [(np.stack([_whereIn(a, common), _whereIn(b, common)], axis=1), Label.RIGHT), (copies, Label.COPY)]
            wrong = int(len(common) * share / (1 - share)) - len(copies)
        used = np.concatenate([group for group, _ in groups] + [np.zeros((0, 2), int)])
        left = [rng.permutation(np.setdiff1d(np.arange(len(c)), used[:, side])) for side, c in enumerate((a, b))]
        wrong = max(0, min(wrong, len(left[0]), len(left[1])))
        groups.append((np.stack([left[0][:wrong], left[1][:wrong]], axis=1), Label.RANDOM))
        matches = np.concatenate([group for group, _ in groups]).astype(np.uint32)
        labels = np.concatenate([np.full(len(group), int(label)) for group, label in groups])
        labels[(a[matches[:, 0]] >= 0) & (a[matches[:, 0]] == b[matches[:, 1]])] = Label.RIGHT  # a random match can be right by chance
        order = rng.permutation(len(matches))
        return self._truth(first, second, matches[order], labels[order])

    def _copies(self, a: Integers, b: Integers, most: int) -> Integers:
        """Returns at most `most` wrong matches due to repeated structure: points of windows matched to
        the corresponding points of other windows. The offset between the windows is the same for
        all matches; of six offsets, the one with the most matches is chosen."""
        windows = self.space.windows
        best = np.zeros((0, 2), int)
        for across, up in ((1, 0), (-1, 0), (2, 0), (-2, 0), (0, 1), (0, -1)):
            source = windows[:, max(0, -across):COLUMNS - max(0, across), max(0, -up):ROWS - max(0, up)]
            target = windows[:, max(0, across):COLUMNS + min(0, across), max(0, up):ROWS + min(0, up)]
            group = np.stack([_whereIn(a, source.ravel()), _whereIn(b, target.ravel())], axis=1)
            group = group[(group >= 0).all(1)]
            best = group if len(group) > len(best) else best
        return self.rng.permutation(best)[:most]

    def _truth(self, first: int, second: int, matches: npt.NDArray[np.uint32], labels: Integers) -> PairTruth:
        points = self.pointOf[first][matches[labels == Label.RIGHT, 0]]
        share = 0.0
        if len(points):
            share = max(float((self.space.flat & (self.space.sides == side))[points].mean()) for side in range(4))
        kind = Kind.GENERAL if share < 1 else Kind.PLANAR
        if (first, second) == self.marked:
            kind = Kind.WATERMARK
        elif len(points) < 5:
            kind = Kind.NONE
        elif self.fromOneSpot(first, second):
            kind = Kind.ROTATION
        return PairTruth(first, second, kind, matches, labels, share)

    def write(self, path: str) -> None:
        """Writes a new database, without descriptors and without verified pairs."""
        with sqlite3.connect(path) as database:
            database.executescript(SCHEMA)
            for number, lens in enumerate(self.lenses, 1):
                params = lens.stored(self.recipe.size).tobytes()
                database.execute("INSERT INTO cameras VALUES (?, ?, ?, ?, ?, ?)",
                                 (number, MODELS[lens.model][0], *self.recipe.size, params, int(lens.focalKnown)))
            for image, (name, pixels) in enumerate(zip(self.names, self.keypoints)):
                database.execute("INSERT INTO images (image_id, name, camera_id) VALUES (?, ?, ?)",
                                 (image + 1, name, image % len(self.lenses) + 1))
                columns = np.zeros((len(pixels), self.recipe.columns), np.float32)
                columns[:, :2] = pixels
                columns[:, 2:] = {2: [], 4: [3, 0], 6: [3, 0, 0, 3]}[self.recipe.columns]  # scale and angle, or affine shape
                database.execute("INSERT INTO keypoints VALUES (?, ?, ?, ?)", (image + 1, *columns.shape, columns.tobytes()))
            database.executemany("INSERT INTO matches VALUES (?, ?, ?, ?)", self._rows())
        database.close()

    def _rows(self) -> Iterator[Tuple[Any, ...]]:
        for pair in self.pairs:
            yield pair.pairId, len(pair.matches), 2, pair.matches.tobytes()


def _whereIn(pointOf: Integers, points: Integers) -> Integers:
    """Returns for each of the points the index of the keypoint that shows this point, or -1."""
    number = np.full(max(int(points.max(initial=0)), int(pointOf.max(initial=0))) + 1, -1)
    known = pointOf >= 0
    number[pointOf[known]] = np.flatnonzero(known)
    return number[points]
