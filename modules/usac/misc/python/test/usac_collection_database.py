# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Writes databases for tests from arrays, in the formats of several COLMAP versions."""

import contextlib
import os
import shutil
import sqlite3
import tempfile
import unittest

import numpy as np

from usac_common import IN_TREE

if not IN_TREE:
    from usacv20.collection._database import DatabaseSource, matchesHash
    from usacv20.collection._pair import CollectionError

IMAGES = 2147483647
SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV = range(5)
# Differences between versions of COLMAP: in later versions, prior poses of images are in a separate
# table, and there are rigs, frames, and cameras of verified pairs.
_OLD_IMAGES = ", prior_qw REAL, prior_qx REAL, prior_qy REAL, prior_qz REAL, prior_tx REAL, prior_ty REAL, prior_tz REAL"
_PRIORS = """CREATE TABLE pose_priors (image_id INTEGER PRIMARY KEY NOT NULL, position BLOB, coordinate_system INTEGER NOT NULL,
position_covariance BLOB, FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);"""
_RIGS = """CREATE TABLE rigs (rig_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, ref_sensor_id INTEGER NOT NULL,
ref_sensor_type INTEGER NOT NULL);
CREATE TABLE rig_sensors (rig_id INTEGER NOT NULL, sensor_id INTEGER NOT NULL, sensor_type INTEGER NOT NULL,
sensor_from_rig BLOB, FOREIGN KEY(rig_id) REFERENCES rigs(rig_id) ON DELETE CASCADE);
CREATE TABLE frames (frame_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, rig_id INTEGER NOT NULL,
FOREIGN KEY(rig_id) REFERENCES rigs(rig_id) ON DELETE CASCADE);
CREATE TABLE frame_data (frame_id INTEGER NOT NULL, data_id INTEGER NOT NULL, sensor_id INTEGER NOT NULL,
sensor_type INTEGER NOT NULL, FOREIGN KEY(frame_id) REFERENCES frames(frame_id) ON DELETE CASCADE);
CREATE TABLE pose_priors (pose_prior_id INTEGER PRIMARY KEY NOT NULL, corr_data_id INTEGER NOT NULL,
corr_sensor_id INTEGER NOT NULL, corr_sensor_type INTEGER NOT NULL, position BLOB, position_covariance BLOB, gravity BLOB,
coordinate_system INTEGER NOT NULL);"""
_CAMERAS = """ALTER TABLE two_view_geometries ADD COLUMN camera1 BLOB;
ALTER TABLE two_view_geometries ADD COLUMN camera2 BLOB;"""
# For each version of COLMAP: additional columns of the tables images and descriptors, SQL statements
# for further tables and columns, and user_version.
SCHEMAS = {"3.8": (_OLD_IMAGES, "", "", 3800), "3.9": (_OLD_IMAGES, "", "", 3900), "3.11": ("", "", _PRIORS, 3900),
           "4.0": ("", "type INTEGER NOT NULL, ", _RIGS, 4000),
           "4.2": ("", "type INTEGER NOT NULL, ", _RIGS + _CAMERAS, 4020100)}


def _script(schema):
    images, descriptors, others, version = SCHEMAS[schema]
    return """
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, model INTEGER NOT NULL, width INTEGER NOT NULL,
height INTEGER NOT NULL, params BLOB, prior_focal_length INTEGER NOT NULL);
CREATE TABLE images (image_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, name TEXT NOT NULL UNIQUE, camera_id INTEGER NOT NULL
{}, CONSTRAINT image_id_check CHECK(image_id >= 0 and image_id < 2147483647),
FOREIGN KEY(camera_id) REFERENCES cameras(camera_id));
CREATE UNIQUE INDEX index_name ON images(name);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE descriptors (image_id INTEGER PRIMARY KEY NOT NULL, {}rows INTEGER NOT NULL, cols INTEGER NOT NULL,
data BLOB, FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE matches (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB);
CREATE TABLE two_view_geometries (pair_id INTEGER PRIMARY KEY NOT NULL, rows INTEGER NOT NULL, cols INTEGER NOT NULL,
data BLOB, config INTEGER NOT NULL, F BLOB, E BLOB, H BLOB, qvec BLOB, tvec BLOB);
{}
PRAGMA user_version = {};""".format(images, descriptors, others, version)


def pairId(first, second):
    return min(first, second) * IMAGES + max(first, second)


def writeDatabase(path, cameras, images, keypoints, matches, schema="3.8", wal=True):
    """Writes a database.

    cameras -- {camera_id: (model, width, height, parameters, whether the focal length is known)}
    images -- {image_id: (name, camera_id)}
    keypoints -- {image_id: array with N rows and 2, 4 or 6 columns}
    matches -- {(image_id, image_id): M x 2 indices of keypoints}, or an iterable of such items; the
    smaller image_id is first
    schema -- version of COLMAP, a key of SCHEMAS
    wal -- True: journal mode WAL, as COLMAP sets it"""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        if wal:
            connection.execute("PRAGMA journal_mode = WAL")
        connection.executescript(_script(schema))
        connection.executemany("INSERT INTO cameras VALUES (?, ?, ?, ?, ?, ?)", (
            (key, model, width, height, np.asarray(params, "<f8").tobytes(), int(known))
            for key, (model, width, height, params, known) in cameras.items()))
        connection.executemany("INSERT INTO images (image_id, name, camera_id) VALUES (?, ?, ?)", (
            (key, name, camera) for key, (name, camera) in images.items()))
        connection.executemany("INSERT INTO keypoints VALUES (?, ?, ?, ?)", (
            (key, *np.shape(points), np.asarray(points, "<f4").tobytes()) for key, points in keypoints.items()))
        items = matches.items() if hasattr(matches, "items") else matches
        connection.executemany("INSERT INTO matches VALUES (?, ?, 2, ?)", (
            (pairId(*key), len(numbers), np.asarray(numbers, "<u4").tobytes() or None) for key, numbers in items))


def change(path, statement, *arguments):
    """Executes an SQL statement that changes a database, for example to damage it."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(statement, arguments)


def rows(path, statement, *arguments):
    with contextlib.closing(sqlite3.connect(path)) as connection:
        return connection.execute(statement, arguments).fetchall()


def dump(path, *tables):
    """Returns {table: list of all its rows}; the rows are sorted by their first column."""
    return {table: rows(path, "SELECT * FROM {} ORDER BY 1".format(table)) for table in tables}


INPUT = ("cameras", "images", "keypoints", "descriptors", "matches")


def smallDatabase(path, images=6, points=60, seed=0, distorted=False, columns=2, **keywords):
    """Writes a database with all pairs of a few images; returns (keypoints, matches) in the form that
    writeDatabase accepts. Keypoints and matches are random, but match i of a pair belongs to
    keypoint i of the first image."""
    rng = np.random.RandomState(seed)
    camera = (OPENCV, 640, 480, (600, 610, 320, 240, -0.1, 0.02, 0.001, -0.002), True) if distorted else (
        SIMPLE_PINHOLE, 640, 480, (600, 320, 240), False)
    numbers = range(1, images + 1)
    keypoints = {i: np.hstack([rng.uniform(0, [640, 480], (points, 2)), rng.rand(points, columns - 2)]) for i in numbers}
    matches = {(i, j): np.column_stack([np.arange(points), rng.permutation(points)])[:points - i]
               for i in numbers for j in numbers if i < j}
    writeDatabase(path, {1: camera}, {i: ("image{}.jpg".format(i), 1) for i in numbers}, keypoints, matches, **keywords)
    return keypoints, matches


class DatabaseCase(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.path = os.path.join(self.folder, "a.db")

    def source(self, path=None, **keywords):
        source = DatabaseSource(path or self.path, **keywords)
        self.addCleanup(source.close)
        return source

    def load(self, **keywords):
        source = self.source(**keywords)
        return source.load(list(source.keys()))

    def hashed(self, *results):
        """Returns results with the hashes of the matches in the database, as the engine passes them to a
        sink."""
        matches = "SELECT rows, cols, data FROM matches WHERE pair_id = ?"
        return [result._replace(matchesHash=matchesHash(*rows(self.path, matches, result.key)[0])) for result in results]

    def refused(self, words, function, *args, **keywords):
        """Asserts that a call raises a CollectionError whose message is one line and contains all of
        the words."""
        with self.assertRaises(CollectionError) as context:
            function(*args, **keywords)
        message = str(context.exception)
        for word in words:
            self.assertIn(word, message)
        self.assertNotIn("\n", message)


def flat(item):
    """Converts loaded data (arrays in nested lists and tuples) to values that == compares exactly."""
    if isinstance(item, np.ndarray):
        return item.dtype.str, item.shape, item.tobytes()
    if isinstance(item, (list, tuple)):
        return type(item).__name__, [flat(part) for part in item]
    return item


def same(first, second):
    return flat(first) == flat(second)
