#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Compares COLMAP's verification of the pairs of a collection with `usacv20-collection verify`, on
the same matches.

    compare_colmap.py WORK --images FOLDER --cameras cameras.json --repeats 3
    compare_colmap.py WORK --database matches.db --cameras cameras.json --pairs

WORK is a folder for databases. Without --database, colmap first extracts and matches features of the
images; if WORK has the result of an earlier run (matches.db), it is reused. Then each verification
fills two_view_geometries in its own copy of the database. COLMAP's verification is the command
geometric_verifier of version 4, or matches_importer of version 3.8. Finally `colmap mapper`, or
`global_mapper` (--mapper), reconstructs the scene from each copy. --colmap is the path of COLMAP's
program; the default is colmap on the PATH. cameras.json has {name of an image: {"K": 3 x 3, "R": 3 x 3,
"t": 3}} with x ~ K (R X + t) and the center of the first pixel at (0, 0).

Focal lengths (--focal):
known    K of cameras.json with prior_focal_length 1; the mapper does not refine the focal lengths
unknown  those of the database, but with prior_focal_length 0
given    those of the database, with its prior_focal_length

Columns about the verification:
CPU s         median over --repeats runs of the user plus system time of the whole process, in seconds;
              each repeat runs every verification once
(range)       smallest and largest of these times
pairs         number of verified pairs

Columns about the reconstruction, medians over --seeds runs of the mapper:
registered    number of registered images
reprojection  mean reprojection error in pixels
AUC 1, 3, 5   area under the cumulative curve of the errors of the relative poses of all pairs of
              images, up to 1, 3 and 5 degrees; images that are not registered count as wrong
(range)       largest minus smallest AUC 1

With --pairs, a list follows of the pairs for which COLMAP and the first other verification find
different configurations. For each such pair, the list has the number of matches and the number of
inliers of each of the two verifications. The number in brackets after each of these numbers says how
many of the matches or inliers agree with the true cameras (both points are at most --limit pixels from
the epipolar lines).

Needs colmap (Debian 12 has 3.8, sid 4.2.1), NumPy and the package usacv20."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import sqlite3
import sys
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "modules", "usac", "misc", "python", "test"))

import usac_colmap as uc  # noqa: E402

Floats = npt.NDArray[np.float64]
PINHOLE = 1  # COLMAP's number of this camera model
PROGRAM: Optional[str] = None  # the value of --colmap
CONFIGURATIONS = ("-", "degenerate", "calibrated", "uncalibrated", "planar", "panoramic", "planar or panoramic", "watermark",
                  "multiple", "calibrated rig")
# COLMAP distinguishes these configurations (planar, panoramic, planar or panoramic) only with an option, so
# --pairs does not list differences among them.
PLANE_OR_TURN = {4, 5, 6}


class TrueCamera(NamedTuple):
    K: Floats  # in COLMAP's convention: the outer corner of the first pixel is at (0, 0), its center at (0.5, 0.5)
    R: Floats
    t: Floats


def readCameras(path: str) -> Dict[str, TrueCamera]:
    with open(path) as file:
        entries = json.load(file)
    half = np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
    return {name: TrueCamera(np.array(entry["K"]) + half, np.array(entry["R"]), np.array(entry["t"]))
            for name, entry in entries.items()}


def makeDatabase(path: str, images: str) -> None:
    """Extracts and matches the features of a folder of images; all images share one camera."""
    part = path + ".part"
    if os.path.exists(part):
        os.remove(part)
    program = PROGRAM or uc.find() or ""
    steps: Sequence[Tuple[str, Dict[str, Any]]] = (
        ("feature_extractor", dict(image_path=images, ImageReader__single_camera=1)), ("exhaustive_matcher", {}))
    for command, given in steps:
        uc.colmap(command, program, database_path=part, **given, **uc.withoutGpu(program, command))
    os.rename(part, path)


def setFocal(database: str, mode: str, cameras: Dict[str, TrueCamera]) -> None:
    """Sets the cameras of the database according to `mode`, a value of --focal."""
    connection = sqlite3.connect(database)
    with connection:
        if mode == "unknown":
            connection.execute("UPDATE cameras SET prior_focal_length = 0")
        elif mode == "known":
            sizes = dict(connection.execute("SELECT name, width || ' ' || height FROM images JOIN cameras USING (camera_id)"))
            connection.execute("DELETE FROM cameras")
            numbers: Dict[bytes, int] = {}
            for name, size in sizes.items():
                K = cameras[name].K
                params = K[[0, 1, 0, 1], [0, 1, 2, 2]].tobytes()
                if params not in numbers:
                    numbers[params] = len(numbers) + 1
                    connection.execute("INSERT INTO cameras VALUES (?, ?, ?, ?, ?, 1)",
                                       (numbers[params], PINHOLE, *map(int, size.split()), params))
                connection.execute("UPDATE images SET camera_id = ? WHERE name = ?", (numbers[params], name))
    connection.close()


class Rival(NamedTuple):
    """A verification that is compared: COLMAP's, or `usacv20-collection verify` with options."""

    name: str
    options: Tuple[str, ...]  # options of usacv20-collection verify; empty: COLMAP's verification is run

    def verify(self, database: str) -> float:
        """Verifies all pairs of the database; returns the CPU time in seconds."""
        if not self.options:
            return uc.verifyByColmap(database, PROGRAM).cpuSeconds
        uc.clear(database)
        return uc.runProgram([sys.executable, "-m", "usacv20.collection", "verify", "--threads", "1", "--no-progress",
                              *self.options, database]).cpuSeconds


def reconstruct(database: str, mode: str, cameras: Dict[str, TrueCamera], seeds: int, command: str) -> List[List[float]]:
    """Returns a row for each seed of the mapper: number of registered images, mean reprojection error
    in pixels, and AUC up to 1, 3 and 5 degrees (NaN without true cameras)."""
    truth = {name: (camera.R, camera.t) for name, camera in cameras.items()}
    lines = []
    for seed in range(seeds):
        model, _ = uc.mapper(database, program=PROGRAM, command=command, seed=seed, fixed=mode == "known")
        errors = uc.relativeErrors(model.poses, truth) if truth else np.array([])
        auc = [uc.areaUnderCurve(errors, limit) if truth else np.nan for limit in (1, 3, 5)]
        lines.append([len(model.poses), model.reprojectionError, *auc])
    return lines


def compare(options: argparse.Namespace, source: str, mode: str, cameras: Dict[str, TrueCamera],
            rivals: Sequence[Rival]) -> None:
    databases = {rival.name: os.path.join(options.work, "{}-{}.db".format(mode, rival.name.replace(" ", "_")))
                 for rival in rivals}
    for path in databases.values():
        shutil.copy(source, path)
        os.chmod(path, 0o644)
        setFocal(path, mode, cameras)
    times: Dict[str, List[float]] = {rival.name: [] for rival in rivals}
    for _ in range(options.repeats):
        for rival in rivals:
            times[rival.name].append(rival.verify(databases[rival.name]))
    print("\nfocal lengths {}:".format(mode))
    print("{:<24}{:>9}{:>12}{:>8}{:>12}{:>14}{:>10}{:>8}{:>8}{:>9}".format(
        "", "CPU s", "(range)", "pairs", "registered", "reprojection", "AUC 1", "AUC 3", "AUC 5", "(range)"))
    for rival in rivals:
        kept = sum(len(pair.inliers) > 0 for pair in uc.verified(databases[rival.name]).values())
        lines = np.array(reconstruct(databases[rival.name], mode, cameras, options.seeds, options.mapper))
        median, spread = np.median(lines, axis=0), np.ptp(lines, axis=0)
        cpu = times[rival.name]
        print("{:<24}{:9.2f}{:6.2f}{:6.2f}{:8}{:12.0f}{:14.4f}{:10.4f}{:8.4f}{:8.4f}{:9.4f}".format(
            rival.name, float(np.median(cpu)), min(cpu), max(cpu), kept, *median.tolist(), float(spread[2])), flush=True)
    if options.pairs:
        showPairs(databases[rivals[0].name], databases[rivals[1].name], rivals[0].name, rivals[1].name, cameras, options.limit)


def epipolarErrors(points: Tuple[Floats, Floats], first: TrueCamera, second: TrueCamera) -> Floats:
    """Returns the error of each match in pixels: the distance of its point from the true epipolar line
    of the other point, in the image where this distance is larger."""
    R, t = uc.between((first.R, first.t), (second.R, second.t))
    cross = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]])
    F = np.linalg.inv(second.K).T @ cross @ R @ np.linalg.inv(first.K)
    a, b = (np.column_stack([x, np.ones(len(x))]) for x in points)
    lines2, lines1 = a @ F.T, b @ F
    product = np.abs((b * lines2).sum(1))
    return np.asarray(product / np.minimum(np.hypot(*lines1[:, :2].T), np.hypot(*lines2[:, :2].T)))


def showPairs(path1: str, path2: str, name1: str, name2: str, cameras: Dict[str, TrueCamera], limit: float) -> None:
    connection = sqlite3.connect(path1)
    names = dict(connection.execute("SELECT image_id, name FROM images"))
    points = {image: np.frombuffer(data, np.float32).reshape(rows, cols)[:, :2].astype(float)
              for image, rows, cols, data in connection.execute("SELECT * FROM keypoints")}
    matches = {key: np.frombuffer(data or b"", np.uint32).reshape(rows, 2)
               for key, rows, data in connection.execute("SELECT pair_id, rows, data FROM matches ORDER BY pair_id")}
    connection.close()
    tables = [uc.verified(path1), uc.verified(path2)]
    print("\npairs with other configurations: inliers (of these, within {} px of the true epipolar lines), {} | {}".format(
        limit, name1, name2))

    def right(key: int, rows: npt.NDArray[np.uint32]) -> str:
        a, b = key // uc.MAX_IMAGES, key % uc.MAX_IMAGES
        if names[a] not in cameras or names[b] not in cameras:
            return "?"
        errors = epipolarErrors((points[a][rows[:, 0]], points[b][rows[:, 1]]), cameras[names[a]], cameras[names[b]])
        return str(int(np.count_nonzero(errors <= limit)))

    for key, rows in matches.items():
        found = [table.get(key) for table in tables]
        configurations = [0 if row is None or not len(row.inliers) else row.configuration for row in found]
        if configurations[0] != configurations[1] and not set(configurations) <= PLANE_OR_TURN:
            texts = ["{} {} ({})".format(CONFIGURATIONS[configuration], 0 if row is None else len(row.inliers),
                                         "0" if row is None else right(key, row.inliers))
                     for configuration, row in zip(configurations, found)]
            print("{} {}: {} matches ({}): {} | {}".format(names[key // uc.MAX_IMAGES], names[key % uc.MAX_IMAGES], len(rows),
                                                            right(key, rows), *texts))


def main() -> int:
    parser = argparse.ArgumentParser(description="Compares COLMAP's verification of the pairs of a collection with that of "
                                                 "usacv20.")
    parser.add_argument("work", metavar="WORK", help="folder for databases")
    parser.add_argument("--images", metavar="FOLDER")
    parser.add_argument("--database", metavar="FILE",
                        help="COLMAP's database with keypoints and matches; only copies of it are changed")
    parser.add_argument("--cameras", metavar="FILE", help="cameras.json, the true cameras")
    parser.add_argument("--focal", nargs="+", choices=("known", "unknown", "given"), default=["known", "unknown"])
    parser.add_argument("--threshold", nargs="+", default=["4"],
                        help="thresholds of usacv20 in pixels, or auto; one verification for each (default 4, that of COLMAP)")
    parser.add_argument("--method", nargs="+", default=["USACV20"], help="methods of usacv20; one verification for each")
    parser.add_argument("--repeats", type=int, default=5, help="runs of each verification (default %(default)s)")
    parser.add_argument("--seeds", type=int, default=3, help="runs of the mapper for each verification (default %(default)s)")
    parser.add_argument("--colmap", metavar="PROGRAM",
                        help="COLMAP's program, for its verification and its mapper (default: colmap on the PATH)")
    parser.add_argument("--mapper", choices=("mapper", "global_mapper"), default="mapper", help="default %(default)s")
    parser.add_argument("--pairs", action="store_true",
                        help="list the pairs for which the verifications find different configurations")
    parser.add_argument("--limit", type=float, default=4.0,
                        help="--pairs: largest distance of a right match from the true epipolar lines, pixels")
    options = parser.parse_args()
    if options.images is None and options.database is None:
        parser.error("--images or --database is needed")
    if "known" in options.focal and options.cameras is None:
        parser.error("--focal known needs --cameras")
    global PROGRAM
    PROGRAM = options.colmap
    cameras = readCameras(options.cameras) if options.cameras else {}
    os.makedirs(options.work, exist_ok=True)
    source = options.database or os.path.join(options.work, "matches.db")
    if options.database is not None and not os.path.exists(source):
        parser.error("there is no file " + source)
    if not os.path.exists(source):
        makeDatabase(source, options.images)
    rivals = [Rival("COLMAP", ())] + [Rival("{} {}".format(method, threshold), ("--method", method, "--threshold", threshold))
                                      for method in options.method for threshold in options.threshold]
    for mode in options.focal:
        compare(options, source, mode, cameras, rivals)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (uc.ColmapError, OSError, sqlite3.Error, KeyError, ValueError) as mistake:
        print("compare_colmap.py: {!s}".format(mistake), file=sys.stderr)
        sys.exit(1)
