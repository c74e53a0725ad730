#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Measures the speed (pairs per second) and memory of `python3 -m usacv20.collection verify` on a
synthetic COLMAP database of any size.

usage: throughput.py [--images N] [--overlap PART] [--matches M] [--threads N ...] [--folder FOLDER]
[-- options of verify]

The database has all N (N - 1) / 2 pairs of N images. A pair has overlap with probability PART. Pairs
with overlap have M matches, half of them right. All other pairs have M / 4 random matches. The database
is written row by row and stays in FOLDER for the next run. For each number of threads, the program
prints the number of pairs, the seconds, pairs per second, CPU milliseconds per pair, the seconds of
reading, estimating and writing, and the largest resident memory in megabytes, which must not grow with
N."""

import argparse
import os
import re
import sqlite3
import subprocess
import sys

import numpy as np

KEYPOINTS, WIDTH, HEIGHT, FOCAL, NOISE = 1000, 1600, 1200, 1400., 0.7
TABLES = """
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, model INTEGER NOT NULL, width INTEGER NOT NULL,
height INTEGER NOT NULL, params BLOB, prior_focal_length INTEGER NOT NULL);
CREATE TABLE images (image_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, name TEXT NOT NULL UNIQUE, camera_id INTEGER NOT NULL);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB);
CREATE TABLE matches (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB);
"""


def rotation(rng):
    q, r = np.linalg.qr(np.eye(3) + rng.uniform(-0.15, 0.15, (3, 3)))
    return q * np.sign(np.diag(r))


def images(count, rng):
    """Yields the number, name and keypoints (pixels) of each image. In every image, keypoint i shows
    point i of the scene."""
    X = rng.uniform([-3, -2.2, 7], [3, 2.2, 12], (KEYPOINTS, 3))
    for number in range(count):
        x = (X + rng.uniform(-1, 1, 3)) @ rotation(rng).T
        x = x[:, :2] / x[:, 2:] * FOCAL + [WIDTH / 2, HEIGHT / 2] + rng.normal(0, NOISE, (KEYPOINTS, 2))
        yield number + 1, "image{:06d}.jpg".format(number), x.astype(np.float32)


def matches(count, overlap, most, rng):
    for first in range(1, count + 1):
        for second in range(first + 1, count + 1):
            seen = rng.uniform() < overlap
            number = most if seen else most // 4
            rows = np.stack([rng.permutation(KEYPOINTS)[:number], rng.permutation(KEYPOINTS)[:number]], axis=1)
            if seen:
                rows[:number // 2, 1] = rows[:number // 2, 0]
            yield first * 2147483647 + second, number, 2, rows.astype(np.uint32).tobytes()


def make(path, options):
    rng = np.random.RandomState(1)
    connection = sqlite3.connect(path + ".part")
    connection.executescript(TABLES)
    camera = np.array([FOCAL, WIDTH / 2, HEIGHT / 2]).tobytes()
    connection.execute("INSERT INTO cameras VALUES (1, 0, ?, ?, ?, 1)", (WIDTH, HEIGHT, camera))
    for number, name, points in images(options.images, rng):
        connection.execute("INSERT INTO images VALUES (?, ?, 1)", (number, name))
        connection.execute("INSERT INTO keypoints VALUES (?, ?, 2, ?)", (number, len(points), points.tobytes()))
    connection.executemany("INSERT INTO matches VALUES (?, ?, ?, ?)",
                           matches(options.images, options.overlap, options.matches, rng))
    connection.commit()
    connection.close()
    os.rename(path + ".part", path)


def measure(path, threads, more):
    run = subprocess.Popen([sys.executable, "-m", "usacv20.collection", "verify", path, "--threads", str(threads), "--no-progress"] + more,
                           stdout=subprocess.PIPE, universal_newlines=True)
    text = run.stdout.read()
    _, status, used = os.wait4(run.pid, 0)
    if status:
        sys.exit("verify has failed")
    line = re.search(r"([0-9]+) pairs in ([0-9.]+) s", text)
    parts = re.search(r"reading ([0-9.]+), estimating ([0-9.]+); writing ([0-9.]+)", text)
    pairs, seconds = int(line.group(1)), float(line.group(2))
    cpu = used.ru_utime + used.ru_stime
    print("{:7d} {:9d} {:9.1f} {:9.0f} {:9.3f} {:9.1f} {:10.1f} {:9.1f} {:9.0f}".format(
        threads, pairs, seconds, pairs / seconds, 1000 * cpu / pairs, *map(float, parts.groups()), used.ru_maxrss / 1024), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--images", type=int, default=142)
    parser.add_argument("--overlap", type=float, default=0.3)
    parser.add_argument("--matches", type=int, default=300)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--folder", default=".")
    arguments = sys.argv[1:]
    more = arguments[arguments.index("--") + 1:] if "--" in arguments else []
    options = parser.parse_args(arguments[:arguments.index("--")] if "--" in arguments else arguments)
    path = os.path.join(options.folder, "throughput_{}_{:g}_{}.db".format(options.images, options.overlap, options.matches))
    if not os.path.exists(path):
        make(path, options)
    print("threads     pairs   seconds   pairs/s    cpu ms   reading estimating   writing    rss MB")
    for threads in options.threads:
        measure(path, threads, more)


if __name__ == "__main__":
    main()
