#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""COLMAP as a program: its verification of given matches, its mapper, what it writes, and how right that is."""

from __future__ import annotations

import os
import resource
import shutil
import sqlite3
import struct
import subprocess
import tempfile
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Pose = Tuple[Floats, Floats]  # R, t: x_camera = R x + t

MAX_IMAGES = 2147483647  # pair_id = MAX_IMAGES * smaller image_id + larger image_id


class ColmapError(Exception):
    """The program is missing or has failed."""


class Usage(NamedTuple):
    """What a program has said and what it has cost."""

    output: str
    cpuSeconds: float  # user and system


class Model(NamedTuple):
    """A reconstruction."""

    poses: Dict[str, Pose]  # by name of the image: those that are registered
    points: int
    reprojectionError: float  # pixels, mean over the observations; 0: no points


class Verified(NamedTuple):
    """A row of two_view_geometries."""

    configuration: int
    inliers: npt.NDArray[np.uint32]  # K x 2: numbers of keypoints
    hasF: bool
    hasE: bool
    hasH: bool


def find() -> Optional[str]:
    return shutil.which("colmap")


def runProgram(command: Sequence[str]) -> Usage:
    """Only the children of one call may end meanwhile: the CPU time is that of all of them."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                         env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode != 0:
        raise ColmapError("{} has failed ({}): {}".format(" ".join(command[:3]), run.returncode, run.stdout[-2000:]))
    return Usage(run.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def colmap(command: str, **options: object) -> Usage:
    """An option of a group has two underscores where COLMAP has a dot: Mapper__num_threads."""
    program = find()
    if program is None:
        raise ColmapError("there is no program colmap (Debian: apt-get install colmap)")
    words = [word for name, value in options.items() for word in ("--" + name.replace("__", "."), str(value))]
    return runProgram([program, command, *words])


def pairsOf(database: str) -> List[Tuple[str, str]]:
    """Names of the images of all pairs that have matches."""
    connection = sqlite3.connect(database)
    names = dict(connection.execute("SELECT image_id, name FROM images"))
    pairs = [(names[key // MAX_IMAGES], names[key % MAX_IMAGES])
             for key, in connection.execute("SELECT pair_id FROM matches ORDER BY pair_id")]
    connection.close()
    return pairs


def clear(database: str) -> None:
    """Forgets what was verified."""
    connection = sqlite3.connect(database)
    with connection:
        connection.execute("DELETE FROM two_view_geometries")
    connection.close()


def verifyByColmap(database: str, threads: int = 1, **options: object) -> Usage:
    """COLMAP's own verification in the place of what the table has. Where a pair has matches, COLMAP's importer of a list of
    pairs does not match again (so it needs no descriptors) and verifies only."""
    clear(database)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "pairs.txt")
        with open(path, "w") as file:
            file.writelines("{} {}\n".format(*pair) for pair in pairsOf(database))
        return colmap("matches_importer", database_path=database, match_list_path=path, match_type="pairs",
                      SiftMatching__use_gpu=0, SiftMatching__num_threads=threads, **options)


def verified(database: str) -> Dict[int, Verified]:
    """The table of a database by pair_id."""
    connection = sqlite3.connect(database)
    rows = connection.execute("SELECT pair_id, rows, data, config, F, E, H FROM two_view_geometries").fetchall()
    connection.close()
    return {key: Verified(config, np.frombuffer(data or b"", np.uint32).reshape(count, 2), bool(F), bool(E), bool(H))
            for key, count, data, config, F, E, H in rows}


def mapper(database: str, images: Optional[str] = None, threads: int = 1, **options: object) -> Tuple[Model, Usage]:
    """The largest model that the mapper makes, an empty one if it makes none; without a folder of images there are no colors."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            usage = colmap("mapper", database_path=database, image_path=images or folder, output_path=folder,
                           Mapper__extract_colors=int(images is not None), Mapper__num_threads=threads, **options)
        except ColmapError as error:
            if "failed to create sparse model" not in str(error):
                raise
            usage = Usage(str(error), float("nan"))
        models = [readModel(os.path.join(folder, name)) for name in sorted(os.listdir(folder))]
    return max(models, key=lambda model: len(model.poses), default=Model({}, 0, 0.0)), usage


def readModel(folder: str) -> Model:
    """images.bin and points3D.bin."""
    poses = {}
    with open(os.path.join(folder, "images.bin"), "rb") as file:
        data = file.read()
    count, = struct.unpack_from("<Q", data)
    offset = 8
    for _ in range(count):
        values = np.array(struct.unpack_from("<7d", data, offset + 4))
        end = data.index(b"\0", offset + 64)
        poses[data[offset + 64:end].decode()] = (matrixOf(values[:4]), values[4:])
        observations, = struct.unpack_from("<Q", data, end + 1)
        offset = end + 9 + 24 * observations
    with open(os.path.join(folder, "points3D.bin"), "rb") as file:
        data = file.read()
    count, = struct.unpack_from("<Q", data)
    offset, total, seen = 8, 0.0, 0
    for _ in range(count):
        error, length = struct.unpack_from("<dQ", data, offset + 35)
        offset += 51 + 8 * length
        total, seen = total + error * length, seen + length
    return Model(poses, count, total / max(seen, 1))


def matrixOf(quaternion: Floats) -> Floats:
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def angle(a: Floats, b: Floats) -> float:
    """Degrees between two directions."""
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))


def poseError(estimate: Pose, truth: Pose) -> float:
    """Degrees: the larger one of the errors of the rotation and of the direction of the translation, if there is one."""
    D = estimate[0] @ truth[0].T
    skew = np.array([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]])
    turned = float(np.degrees(np.arctan2(np.linalg.norm(skew), np.trace(D) - 1)))
    if np.linalg.norm(truth[1]) < 1e-9:
        return turned
    return max(turned, angle(estimate[1], truth[1]))


def between(first: Pose, second: Pose) -> Pose:
    """x2 ~ R x1 + t of two cameras."""
    R = second[0] @ first[0].T
    return R, second[1] - R @ first[1]


def relativeErrors(estimate: Dict[str, Pose], truth: Dict[str, Pose]) -> Floats:
    """Of all pairs of images; infinite where one of them is not registered."""
    names = sorted(truth)
    errors = []
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            known = a in estimate and b in estimate
            errors.append(poseError(between(estimate[a], estimate[b]), between(truth[a], truth[b])) if known else np.inf)
    return np.array(errors)


def areaUnderCurve(errors: Floats, limit: float) -> float:
    """The area below the share of the errors within a limit, from 0 to the limit, in terms of the limit."""
    inside = np.sort(errors[errors <= limit])
    x = np.concatenate([[0], inside, [limit]])
    share = np.append(np.arange(len(inside) + 1), len(inside)) / len(errors)
    return float((np.diff(x) * (share[1:] + share[:-1])).sum() / 2 / limit)
