#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of how the collection tool reads COLMAP databases, intact or damaged, and of its error
messages for databases that cannot be read, written or copied."""

import contextlib
import os
import pickle
import sqlite3
import unittest
from unittest import mock

import numpy as np

from usac_collection_database import (OPENCV, SCHEMAS, DatabaseCase, change, flat, pairId, rows, same, smallDatabase)
from usac_common import IN_TREE, once, package

if not IN_TREE:
    from usacv20.collection import _database, _sqlite
    from usacv20.collection._cameras import Camera
    from usacv20.collection._database import DatabaseSource
    from usacv20.collection._database_sink import DatabaseSink
    from usacv20.collection._pair import Fault, Pair


@once
@package
class SourceTest(DatabaseCase):

    def test_pairs(self):
        for schema in SCHEMAS:
            for columns in (2, 4, 6):
                path = os.path.join(self.folder, "{}.{}.db".format(schema, columns))
                keypoints, matches = smallDatabase(path, schema=schema, columns=columns)
                change(path, "ALTER TABLE matches ADD COLUMN added REAL")
                change(path, "CREATE TABLE other (a, b)")
                source = self.source(path)
                keys = list(source.keys())
                self.assertEqual(keys, [pairId(*key) for key in sorted(matches)])
                self.assertEqual(len(source), len(keys))
                for pair, (key, numbers) in zip(source.load(keys), sorted(matches.items())):
                    self.assertEqual((pair.first.name, pair.second.name), tuple("image{}.jpg".format(i) for i in key))
                    np.testing.assert_array_equal(pair.matches, numbers)
                    for side, view in enumerate((pair.first, pair.second)):
                        points = keypoints[key[side]][numbers[:, side], :2].astype(np.float32)
                        np.testing.assert_array_equal(view.taken, points)
                        self.assertIs(view.points, view.taken)
                        self.assertEqual((view.width, view.height, view.focalKnown, view.matrix[0, 0]), (640, 480, False, 600))

    def test_points_without_a_direction(self):
        """The distorted radius of this lens has a maximum. Keypoints beyond this radius correspond to
        no direction. Matches of such keypoints and the scores of these matches must be left out."""
        smallDatabase(self.path, distorted=True)
        before = self.load(scores=Column())
        change(self.path, "UPDATE cameras SET params = ?", np.array([600, 610, 320, 240, -0.9, 0, 0, 0], "<f8").tobytes())
        camera = Camera.fromColmap(*rows(self.path, "SELECT * FROM cameras")[0])
        left = 0
        for old, new in zip(before, self.load(scores=Column())):
            ideal = np.hstack([camera.ideal(old.first.taken), camera.ideal(old.second.taken)])
            seen = np.isfinite(ideal).all(axis=1)
            left += np.count_nonzero(~seen)
            for name in ("matches", "scores"):
                np.testing.assert_array_equal(getattr(new, name), getattr(old, name)[seen])
            np.testing.assert_array_equal(old.scores, old.matches[:, 1] + len(old.first.name))
            self.assertFalse(old.higherIsBetter)
            for view, all_ in ((new.first, old.first), (new.second, old.second)):
                np.testing.assert_array_equal(view.taken, all_.taken[seen])
                np.testing.assert_allclose(view.points, camera.ideal(view.taken), atol=1e-6)
        self.assertTrue(0 < left < sum(len(pair.matches) for pair in before))

    def test_names_that_are_not_utf_8(self):
        smallDatabase(self.path)
        change(self.path, "UPDATE images SET name = CAST(X'E92E6A7067' AS TEXT) WHERE image_id = 2")
        change(self.path, "UPDATE images SET name = CAST(X'EA2E6A7067' AS TEXT) WHERE image_id = 3")
        self.assertEqual([(pair.first.name, pair.second.name) for pair in self.load() if pair.key == pairId(2, 3)],
                         [(r"\xe9.jpg", r"\xea.jpg")])
        self.assertEqual(self.source().fingerprint(), self.source().fingerprint())
        self.assertEqual(_sqlite.decoded("\u00e9\u4e2d.jpg".encode()), "\u00e9\u4e2d.jpg")

    def test_pages_of_keys(self):
        smallDatabase(self.path, images=8)
        keys = list(self.source().keys())
        for size in (1, 4, 7, 28):
            with mock.patch.object(_database, "_PAGE", size):
                self.assertEqual(list(self.source().keys()), keys)

    def test_cache(self):
        """The cache has room for three of the six images. If it is full, images must be dropped and
        read again when needed; the pairs must be the same as without a limit."""
        smallDatabase(self.path, distorted=True)
        limit = 3 * (1000 + 60 * 24)
        source = self.source(cache=limit)
        keys = list(source.keys())
        self.assertTrue(same(source.load(keys), self.load()))
        self.assertEqual(len(source._cache._images), 3)
        self.assertLessEqual(source._cache._bytes, limit)
        self.assertTrue(same(source.load(keys[::-1]), self.load()[::-1]))

    def test_pickled(self):
        smallDatabase(self.path)
        source = self.source(cache=12345)
        keys = list(source.keys())
        again = pickle.loads(pickle.dumps(source))
        self.addCleanup(again.close)
        self.assertTrue(same(again.load(keys), source.load(keys)))
        self.assertEqual(again.fingerprint(), source.fingerprint())
        self.assertNotEqual(again.fingerprint(), self.source(scores=Column()).fingerprint())
        source.close()
        self.assertTrue(same(again.load(keys), source.load(keys)))  # a closed source must open its connection again

    def test_nothing_is_left_or_changed(self):
        for wal in (True, False):
            with contextlib.suppress(FileNotFoundError):
                os.remove(self.path)
            smallDatabase(self.path, wal=wal)
            with open(self.path, "rb") as file:
                before = file.read()
            source = DatabaseSource(self.path)
            self.assertEqual(len(source.load(list(source.keys()))), 15)
            with self.assertRaises(sqlite3.OperationalError):
                source.connection().execute("DELETE FROM matches")
            source.close()
            self.assertEqual(os.listdir(self.folder), ["a.db"])
            with open(self.path, "rb") as file:
                self.assertEqual(file.read(), before)


class Column(object):
    higherIsBetter = False

    def of(self, key, first, second, matches, connection):
        return matches[:, 1] + float(len(first))


@once
@package
class FaultTest(DatabaseCase):
    """The tests change or damage parts of the database. For pairs that need a damaged part, the source
    must return a Fault (with the reason) instead of a Pair. All other pairs must be unchanged."""

    def faults(self, words, expected, *statements):
        """Executes the SQL statements on a new database. Then the source must return a Fault for each
        `expected` pair of images and for no other pair, and each reason must contain all of the
        words."""
        with contextlib.suppress(FileNotFoundError):
            os.remove(self.path)
        smallDatabase(self.path)
        before = self.load()
        for statement in statements:
            change(self.path, *statement)
        after = self.load()
        keys = {pairId(*pair) for pair in expected}
        self.assertEqual({item.key for item in after if isinstance(item, Fault)}, keys)
        for old, new in zip(before, after):
            self.assertEqual(old.key, new.key)
            if isinstance(new, Pair):
                self.assertTrue(same(old, new))
                continue
            for word in words:
                self.assertIn(word, new.reason)
            self.assertNotIn("\n", new.reason)
            for view in (old.first, old.second):
                if not any("DELETE FROM images" in statement[0] for statement in statements):
                    self.assertIn(view.name, new.reason)

    def test_matches(self):
        key = pairId(2, 4)
        numbers = np.column_stack([np.arange(20), np.arange(20)]).astype("<u4")
        numbers[7, 1] = 60
        self.faults(["image2.jpg - image4.jpg", "match 7", "keypoint 60 of image4.jpg", "has 60"], [(2, 4)],
                    ("UPDATE matches SET rows = 20, data = ? WHERE pair_id = ?", numbers.tobytes(), key))
        numbers[7] = 2 ** 32 - 1, 0
        self.faults(["match 7", "keypoint 4294967295 of image2.jpg"], [(2, 4)],
                    ("UPDATE matches SET rows = 20, data = ? WHERE pair_id = ?", numbers.tobytes(), key))
        self.faults(["21 rows of 2", "160 bytes"], [(2, 4)],
                    ("UPDATE matches SET rows = 21, data = ? WHERE pair_id = ?", numbers.tobytes(), key))
        self.faults(["20 rows of 3"], [(2, 4)],
                    ("UPDATE matches SET rows = 20, cols = 3, data = ? WHERE pair_id = ?", numbers.tobytes(), key))
        self.faults(["58 rows of 2", "0 bytes"], [(2, 4)], ("UPDATE matches SET data = NULL WHERE pair_id = ?", key))
        for value in (7, 0, 1.5, "text"):
            self.faults(["58 rows of 2", "no blob"], [(2, 4)], ("UPDATE matches SET data = ? WHERE pair_id = ?", value, key))
        self.faults(["many rows of 2"], [(2, 4)], ("UPDATE matches SET rows = 'many' WHERE pair_id = ?", key))

    def test_keypoints(self):
        pairs = [(1, 3), (2, 3), (3, 4), (3, 5), (3, 6)]
        table = np.ones((60, 2), "<f4")
        for words, statement in (
                (["60 rows of 2", "479 bytes"], ("UPDATE keypoints SET data = ? WHERE image_id = 3", table.tobytes()[:-1])),
                (["60 rows of 2", "no blob"], ("UPDATE keypoints SET data = 7 WHERE image_id = 3",)),
                (["of image3.jpg", "3 columns"], ("UPDATE keypoints SET cols = 3 WHERE image_id = 3",)),
                (["image3.jpg, which has none"], ("DELETE FROM keypoints WHERE image_id = 3",)),
                (["image3.jpg, which has none"], ("UPDATE keypoints SET rows = 0, data = NULL WHERE image_id = 3",)),
                (["image 3 is not in the table images"], ("DELETE FROM images WHERE image_id = 3",)),
                (["camera 9 of image3.jpg"], ("UPDATE images SET camera_id = 9 WHERE image_id = 3",))):
            self.faults(words, pairs, statement)

    def test_keypoints_without_a_place(self):
        """Keypoint 59 of image 3 has a coordinate that is NaN or infinite. The source must return a
        Fault only for pairs with a match of this keypoint."""
        for value, text in ((np.nan, "(1, nan)"), (np.inf, "(1, inf)")):
            table = np.ones((60, 2), "<f4")
            table[59, 1] = value
            smallDatabase(self.path)
            matched = [key for (key, numbers) in smallDatabase(self.path + "2")[1].items()
                       if 3 in key and 59 in numbers[:, key.index(3)]]
            self.assertGreater(len(matched), 0)
            self.assertLess(len(matched), 5)
            change(self.path, "UPDATE keypoints SET data = ? WHERE image_id = 3", table.tobytes())
            faults = [item for item in self.load() if isinstance(item, Fault)]
            self.assertEqual([item.key for item in faults], [pairId(*key) for key in matched])
            for fault, key in zip(faults, matched):
                self.assertIn("image{}.jpg - image{}.jpg: match ".format(*key), fault.reason)
                self.assertIn("keypoint 59 of image3.jpg is at " + text, fault.reason)
            os.remove(self.path)
            os.remove(self.path + "2")

    def test_cameras(self):
        everything = [(i, j) for i in range(1, 7) for j in range(i + 1, 7)]
        self.faults(["FOV"], everything, ("UPDATE cameras SET model = 7",))
        self.faults(["camera 2", "model", "77"], [(1, 3), (2, 3), (3, 4), (3, 5), (3, 6)],
                    ("INSERT INTO cameras VALUES (2, 77, 640, 480, ?, 0)", np.ones(3).tobytes()),
                    ("UPDATE images SET camera_id = 2 WHERE image_id = 3",))
        self.faults(["camera 1"], everything, ("UPDATE cameras SET model = ?", OPENCV))
        for value in (7, "text"):
            self.faults(["camera 1", "no blob"], everything, ("UPDATE cameras SET params = ?", value))
        for value in ("wide", 640.5, -1, 2**40):
            self.faults(["camera 1", "width and height"], everything, ("UPDATE cameras SET width = ?", value))
            self.faults(["camera 1", "width and height"], everything, ("UPDATE cameras SET height = ?", value))

    def test_itself(self):
        smallDatabase(self.path)
        change(self.path, "INSERT INTO matches VALUES (?, 0, 2, NULL)", pairId(2, 2))
        self.assertEqual([item.reason for item in self.load() if isinstance(item, Fault)],
                         ["image2.jpg - image2.jpg: an image is matched with itself"])


@once
@package
class WholeTest(DatabaseCase):
    """Tests of databases that as a whole cannot be read, written or copied. Each attempt must raise a
    CollectionError whose message names the reason."""

    def unusable(self, *words, **keywords):
        path = keywords.get("path", self.path)
        words = (os.path.basename(path),) + words
        self.refused(words, lambda: list(self.source(path).keys()))
        self.refused(words, self.source(path).load, [pairId(1, 2)])
        self.refused(words, DatabaseSink, path, {})
        self.refused(words, _sqlite.copyDatabase, path, os.path.join(self.folder, "copy.db"))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "copy.db")))

    def test_no_file(self):
        self.unusable("no such file")
        self.assertEqual(os.listdir(self.folder), [])
        self.unusable("not a file", path=self.folder)

    def test_another_file(self):
        with open(self.path, "wb") as file:
            file.write(b"number;name\n" * 1000)
        self.unusable("not a database of SQLite")
        with open(self.path, "wb"):
            pass
        self.unusable("empty")

    def test_cut_off(self):
        smallDatabase(self.path)
        with open(self.path, "rb") as file:
            whole = file.read()
        for size in (50, 4096, len(whole) // 2, len(whole) - 1):
            with open(self.path, "wb") as file:
                file.write(whole[:size])
            self.unusable("damaged" if size else "empty")

    def test_damaged_inside(self):
        smallDatabase(self.path, images=12)
        page = rows(self.path, "SELECT rootpage FROM sqlite_master WHERE name = 'matches'")[0][0]
        with open(self.path, "r+b") as file:
            file.seek((page - 1) * 4096)
            file.write(b"\xee" * 4096)
        source = self.source()
        self.refused(["a.db", "damaged"], lambda: list(source.keys()))
        self.refused(["a.db", "damaged"], source.load, [pairId(1, 2)])

    def test_foreign(self):
        change(self.path, "CREATE TABLE cameras (name TEXT)")
        self.unusable("not a database of COLMAP", "cameras", "camera_id")
        os.remove(self.path)
        smallDatabase(self.path)
        change(self.path, "ALTER TABLE matches RENAME COLUMN cols TO columns")
        self.unusable("matches", "column cols")
        change(self.path, "DROP TABLE matches")
        self.unusable("no table matches")

    def test_locked(self):
        for wal in (True, False):
            with contextlib.suppress(FileNotFoundError):
                os.remove(self.path)
            smallDatabase(self.path, wal=wal)
            sink = DatabaseSink(self.path, {})
            with mock.patch.object(_sqlite, "PATIENCE", 0.1), contextlib.closing(sqlite3.connect(self.path)) as other:
                other.execute("BEGIN EXCLUSIVE")
                self.refused(["a.db", "another program", "locked"], DatabaseSink, self.path, {})
                if wal:
                    self.assertEqual(len(self.load()), 15)  # in WAL mode, a writer does not block readers
                else:
                    self.refused(["a.db", "another program", "locked"], self.load)
            sink.close(finished=False)

    def test_read_only(self):
        for wal in (True, False):
            for mode in (0o444, 0o644):  # permissions of the database file; the folder is always read-only
                with contextlib.suppress(FileNotFoundError):
                    os.remove(self.path)
                smallDatabase(self.path, wal=wal)
                with contextlib.closing(DatabaseSource(self.path)) as source:
                    expected = flat(source.load(list(source.keys())))
                self.assertEqual(os.listdir(self.folder), ["a.db"])
                os.chmod(self.path, mode)
                os.chmod(self.folder, 0o555)
                try:
                    self.assertEqual(self.asNobody(self.reads, expected), "")
                finally:
                    os.chmod(self.folder, 0o755)

    def reads(self, expected):
        source = DatabaseSource(self.path)
        self.assertEqual(flat(source.load(list(source.keys()))), expected)
        self.refused(["a.db", "read-only"], DatabaseSink, self.path, {})
        self.refused(["b.db", "cannot be written"], _sqlite.copyDatabase, self.path, os.path.join(self.folder, "b.db"))

    def asNobody(self, function, *args):
        """Calls a function in a child process without superuser rights, because the superuser can
        write to read-only files. Returns the exception as text, or "" if there was none."""
        reader, writer = os.pipe()
        child = os.fork()
        if not child:
            text = ""
            try:
                if os.getuid() == 0:
                    os.setgid(65534)
                    os.setuid(65534)
                function(*args)
            except BaseException as error:
                text = repr(error)
            os.write(writer, text.encode())
            os._exit(0)
        os.close(writer)
        with os.fdopen(reader) as file:
            text = file.read()
        os.waitpid(child, 0)
        return text


if __name__ == "__main__":
    unittest.main()
