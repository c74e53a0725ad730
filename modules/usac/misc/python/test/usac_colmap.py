#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs COLMAP for tests and benchmarks: its verification of given matches and its mappers. Reads the
results and compares the camera poses with true ones.

The program is `colmap` on the PATH (version 3.8 in Debian 12), or a given command of this or a later
version. This command can be a script that enters a chroot, if the folder of temporary files has the
same path in the chroot."""

from __future__ import annotations

import functools
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
    """Raised if COLMAP is missing or a program has failed."""


class Usage(NamedTuple):
    """The output of a program that has run, and its CPU time."""

    output: str
    cpuSeconds: float  # user and system


class Model(NamedTuple):
    """A reconstruction made by COLMAP."""

    poses: Dict[str, Pose]  # poses of the registered images by name
    points: int
    reprojectionError: float  # pixels, mean over the observations; 0: there are no points


class Verified(NamedTuple):
    """A row of two_view_geometries."""

    configuration: int
    inliers: npt.NDArray[np.uint32]  # K x 2: indices of keypoints


def find() -> Optional[str]:
    return shutil.which("colmap")


@functools.lru_cache(maxsize=None)
def options(program: str, command: str) -> str:
    """Returns the help text of a command, which shows the names of its options. These names differ
    between versions of COLMAP."""
    return runProgram([program, command, "--help"]).output


def withoutGpu(program: str, command: str) -> Dict[str, object]:
    """Returns the options with which a COLMAP command that extracts or matches features runs on one
    core, without a GPU."""
    groups = ("FeatureExtraction", "FeatureMatching", "SiftExtraction", "SiftMatching")
    known = options(program, command)
    group = next(name for name in groups if "--{}.use_gpu".format(name) in known)
    return {group + "__use_gpu": 0, group + "__num_threads": 1}


def runProgram(command: Sequence[str]) -> Usage:
    """Runs a program; raises ColmapError if it fails. The CPU time is wrong if another child process
    ends during the call, because it is measured for all child processes together."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                         env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode != 0:
        raise ColmapError("{} has failed ({}): {}".format(" ".join(command[:3]), run.returncode, run.stdout[-2000:]))
    return Usage(run.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def colmap(command: str, program: Optional[str] = None, **options: object) -> Usage:
    """Runs a COLMAP command.

    program -- None: the program on the PATH
    options -- options of the command, with two underscores instead of a dot: Mapper__num_threads"""
    program = program or find()
    if program is None:
        raise ColmapError("there is no program colmap (Debian: apt-get install colmap)")
    words = [word for name, value in options.items() for word in ("--" + name.replace("__", "."), str(value))]
    return runProgram([program, command, *words])


def pairsOf(database: str) -> List[Tuple[str, str]]:
    """Returns the names of the two images of each pair in the table `matches`."""
    connection = sqlite3.connect(database)
    names = dict(connection.execute("SELECT image_id, name FROM images"))
    pairs = [(names[key // MAX_IMAGES], names[key % MAX_IMAGES])
             for key, in connection.execute("SELECT pair_id FROM matches ORDER BY pair_id")]
    connection.close()
    return pairs


def clear(database: str) -> None:
    """Removes all verified pairs from the database."""
    connection = sqlite3.connect(database)
    with connection:
        connection.execute("DELETE FROM two_view_geometries")
    connection.close()


def verifyByColmap(database: str, program: Optional[str] = None) -> Usage:
    """Runs COLMAP's own verification on one core. Its results replace all rows of the table
    two_view_geometries. Version 3 has no command that only verifies, so matches_importer is used with
    a list of the pairs. This command verifies pairs that have matches, and needs no descriptors."""
    clear(database)
    program = program or find() or ""
    if program and "geometric_verifier" in runProgram([program, "help"]).output:
        return colmap("geometric_verifier", program, database_path=database, num_threads=1)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "pairs.txt")
        with open(path, "w") as file:
            file.writelines("{} {}\n".format(*pair) for pair in pairsOf(database))
        known = withoutGpu(program, "matches_importer") if program else {}
        return colmap("matches_importer", program or None, database_path=database, match_list_path=path, match_type="pairs", **known)


def verified(database: str) -> Dict[int, Verified]:
    """Returns the table two_view_geometries as {pair_id: row}."""
    connection = sqlite3.connect(database)
    rows = connection.execute("SELECT pair_id, rows, data, config FROM two_view_geometries").fetchall()
    connection.close()
    return {key: Verified(config, np.frombuffer(data or b"", np.uint32).reshape(count, 2)) for key, count, data, config in rows}


def mapper(database: str, images: Optional[str] = None, program: Optional[str] = None, command: str = "mapper", seed: int = 0,
           fixed: bool = False) -> Tuple[Model, Usage]:
    """Runs COLMAP's command `mapper` or `global_mapper` on one core. Returns (largest model, usage). If
    no model was made, the model is empty; the CPU time is NaN if the command reports this as a failure.

    images -- folder of the images, from which the points get colors; None: no colors
    fixed -- True: focal lengths and distortion are not refined"""
    program = program or find() or ""
    group = "GlobalMapper" if command == "global_mapper" else "Mapper"
    known = options(program, command) if program else ""
    given: Dict[str, object] = {group + "__num_threads": 1}
    if group + ".extract_colors" in known:
        given[group + "__extract_colors"] = int(images is not None)
    if group + ".structure_less_registration_fallback" in known:  # switched off: in Debian's 4.2.1 it crashes (double free)
        given[group + "__structure_less_registration_fallback"] = 0
    given[group + "__random_seed" if group + ".random_seed" in known else "random_seed"] = seed
    if fixed:
        given.update({group + "__ba_refine_focal_length": 0, group + "__ba_refine_extra_params": 0})
    with tempfile.TemporaryDirectory() as folder:
        try:
            usage = colmap(command, program or None, database_path=database, image_path=images or folder, output_path=folder, **given)
        except ColmapError as error:
            if "failed to create" not in str(error).lower():
                raise
            usage = Usage(str(error), float("nan"))
        models = [readModel(os.path.join(folder, name)) for name in sorted(os.listdir(folder))
                  if os.path.isdir(os.path.join(folder, name))]
    return max(models, key=lambda model: len(model.poses), default=Model({}, 0, 0.0)), usage


def readModel(folder: str) -> Model:
    """Reads a reconstruction from COLMAP's files images.bin and points3D.bin."""
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
    """Returns the angle between two directions in degrees."""
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))


def poseError(estimate: Pose, truth: Pose) -> float:
    """Returns the larger of the errors of the rotation and of the direction of the translation, in
    degrees. If the true translation is zero, only the error of the rotation is returned."""
    D = estimate[0] @ truth[0].T
    skew = np.array([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]])
    turned = float(np.degrees(np.arctan2(np.linalg.norm(skew), np.trace(D) - 1)))
    if np.linalg.norm(truth[1]) < 1e-9:
        return turned
    return max(turned, angle(estimate[1], truth[1]))


def between(first: Pose, second: Pose) -> Pose:
    """Returns the relative pose R, t of two cameras: x2 = R x1 + t for points in camera coordinates."""
    R = second[0] @ first[0].T
    return R, second[1] - R @ first[1]


def relativeErrors(estimate: Dict[str, Pose], truth: Dict[str, Pose]) -> Floats:
    """Returns the errors of the relative poses of all pairs of images, in degrees. The error of a pair
    is infinite if one or both of its images are not registered."""
    names = sorted(truth)
    errors = []
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            known = a in estimate and b in estimate
            errors.append(poseError(between(estimate[a], estimate[b]), between(truth[a], truth[b])) if known else np.inf)
    return np.array(errors)


def areaUnderCurve(errors: Floats, limit: float) -> float:
    """Returns the area under the cumulative distribution of the errors from 0 to the limit, divided
    by the limit: a number from 0 to 1."""
    inside = np.sort(errors[errors <= limit])
    x = np.concatenate([[0], inside, [limit]])
    share = np.append(np.arange(len(inside) + 1), len(inside)) / len(errors)
    return float((np.diff(x) * (share[1:] + share[:-1])).sum() / 2 / limit)
