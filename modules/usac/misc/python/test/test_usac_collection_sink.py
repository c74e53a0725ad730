#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of DatabaseSink, which writes the results of the collection tool to a COLMAP database."""

import contextlib
import os
import sqlite3
import unittest

import numpy as np

from usac_collection_database import INPUT, SCHEMAS, DatabaseCase, change, dump, pairId, rows, smallDatabase
from usac_common import IN_TREE, once, package

if not IN_TREE:
    from usacv20.collection import _sqlite
    from usacv20.collection._database_sink import VERSION, DatabaseSink, lastRun
    from usacv20.collection._pair import CollectionError, Configuration, TwoView
    from usacv20.collection._sqlite import connect

TABLE = "two_view_geometries"


def found(first, second, inliers=30, **keywords):
    """Returns an accepted result. All entries of F, E and H differ, so that a test notices if entries
    or matrices are exchanged."""
    key = pairId(first, second)
    count = np.arange(first * 100 + second, dtype=float)
    values = dict(key=key, configuration=Configuration.CALIBRATED, inliers=np.arange(2 * inliers, dtype=np.uint32).reshape(-1, 2),
                  F=count[:9].reshape(3, 3), E=10 + count[:9].reshape(3, 3).T, H=20 + count[:9].reshape(3, 3),
                  quaternion=np.array([0.5, -0.5, 0.5, 0.5]), translation=np.array([0.6, 0, -0.8]), reason="", matches=50,
                  iterations=123, chance=1e-9, milliseconds=0.25)
    values.update(keywords)
    return TwoView(**values)


def refused(first, second, configuration=None, reason="too few inliers"):
    none = dict.fromkeys(("F", "E", "H", "quaternion", "translation"))
    return found(first, second, 0, configuration=Configuration.DEGENERATE if configuration is None else configuration,
                 reason=reason, **none)


def lastRunOf(path):
    with contextlib.closing(connect(path)) as connection:
        return lastRun(connection)


@once
@package
class SinkCase(DatabaseCase):

    def sink(self, settings=None, **keywords):
        sink = DatabaseSink(self.path, {"threshold": 2.0} if settings is None else settings, **keywords)
        self.addCleanup(self.closed, sink)
        return sink

    def closed(self, sink):
        with contextlib.suppress(CollectionError):  # raised if another sink of the test has started a later run
            sink.close()

    def row(self, first, second):
        """Returns the row of a pair as {column name: value}; None if there is no row."""
        with contextlib.closing(connect(self.path)) as connection:
            cursor = connection.execute("SELECT * FROM {} WHERE pair_id = ?".format(TABLE), (pairId(first, second),))
            names = [column[0] for column in cursor.description]
            stored = cursor.fetchall()
        return dict(zip(names, stored[0])) if stored else None


class RowTest(SinkCase):

    def test_found(self):
        """Unknown matrices and poses must be stored as NULL, as COLMAP 4 does. COLMAP 4 would read
        zeros as a known pose."""
        for schema in SCHEMAS:
            self.path = os.path.join(self.folder, schema)
            smallDatabase(self.path, schema=schema)
            before = dump(self.path, *INPUT)
            result = found(2, 5)._replace(H=np.asfortranarray(found(2, 5).H))
            self.sink().commit([result, found(1, 2, E=None, quaternion=None, translation=None, chance=float("nan"))])
            row, other = self.row(2, 5), self.row(1, 2)
            self.assertEqual((row["rows"], row["cols"], row["config"]), (30, 2, 2))
            np.testing.assert_array_equal(np.frombuffer(row["data"], "<u4").reshape(30, 2), result.inliers)
            for name, value in (("F", result.F), ("E", result.E), ("H", result.H), ("qvec", result.quaternion),
                                ("tvec", result.translation)):
                np.testing.assert_array_equal(np.frombuffer(row[name], "<f8").reshape(value.shape), value)
            self.assertEqual(dump(self.path, *INPUT), before)
            self.assertEqual([name for name in ("F", "E", "H", "qvec", "tvec") if other[name] is None], ["E", "qvec", "tvec"])
            self.assertEqual([row[name] for name in row if name.startswith("camera")], [None, None] if schema == "4.2" else [])
            self.assertEqual(rows(self.path, "SELECT pair_id, configuration, reason, matches, inliers, iterations, chance, "
                                             "milliseconds FROM usacv20_pairs ORDER BY pair_id"),
                             [(pairId(1, 2), 2, "", 50, 30, 123, None, 0.25), (pairId(2, 5), 2, "", 50, 30, 123, 1e-9, 0.25)])
            last = lastRunOf(self.path)
            self.assertEqual((last["settings"], last["state"], last["version"]), ({"threshold": 2.0}, "running", VERSION))
            self.assertLessEqual(last["started"], last["updated"])

    def test_motion_that_is_not_known(self):
        """A planar pair is compatible with two motions, and the motion of a watermark is not that of the
        cameras, so these motions must not be written. The motion of a panoramic pair must be written."""
        smallDatabase(self.path)
        self.sink().commit([found(1, 2, configuration=Configuration.PLANAR), found(1, 3, configuration=Configuration.PANORAMIC),
                            found(1, 4, configuration=Configuration.WATERMARK)])
        for other in (2, 4):
            self.assertEqual([self.row(1, other)[name] for name in ("qvec", "tvec")], [None, None])
            self.assertEqual(len(self.row(1, other)["E"]), 72)
        self.assertEqual([len(self.row(1, 3)[name]) for name in ("qvec", "tvec")], [32, 24])

    def test_refused(self):
        """A refused pair must have the same row that COLMAP 3.8 writes for a pair without a
        geometry."""
        smallDatabase(self.path)
        self.sink().commit([refused(1, 2)])
        self.assertEqual(rows(self.path, "SELECT * FROM " + TABLE), [(pairId(1, 2), 0, 2, None, 1) + (None,) * 5])

    def test_tables_that_differ(self):
        """A missing table two_view_geometries must be created with the same columns as COLMAP's.
        Missing or additional columns, as in other versions of COLMAP, must be accepted; only the
        lack of a required column (here config) must be refused."""
        smallDatabase(self.path)
        made = [row[1:3] for row in rows(self.path, "PRAGMA table_info({})".format(TABLE))]
        change(self.path, "DROP TABLE " + TABLE)
        self.sink().commit([found(1, 2)])
        self.assertEqual([row[1:3] for row in rows(self.path, "PRAGMA table_info({})".format(TABLE))], made)
        change(self.path, "ALTER TABLE {} DROP COLUMN qvec".format(TABLE))
        change(self.path, "ALTER TABLE {} DROP COLUMN tvec".format(TABLE))
        change(self.path, "ALTER TABLE {} ADD COLUMN added REAL DEFAULT 5".format(TABLE))
        self.sink().commit([found(1, 3)])
        row = self.row(1, 3)
        self.assertEqual((row["rows"], row["added"], len(row["H"])), (30, 5, 72))
        change(self.path, "ALTER TABLE {} DROP COLUMN config".format(TABLE))
        self.refused([TABLE, "config"], self.sink)

    def test_journal_mode(self):
        for wal in (True, False):
            smallDatabase(self.path, wal=wal)
            sink = self.sink()
            sink.commit([found(1, 2)])
            sink.close()
            self.assertEqual(rows(self.path, "PRAGMA journal_mode"), [("wal" if wal else "delete",)])
            self.assertEqual(os.listdir(self.folder), ["a.db"])
            os.remove(self.path)


class RunTest(SinkCase):

    def setUp(self):
        super().setUp()
        smallDatabase(self.path)

    def pairs(self):
        return [row[0] for row in rows(self.path, "SELECT pair_id FROM {} ORDER BY 1".format(TABLE))]

    def test_rows_of_others(self):
        """Rows that another program has written must stay, even those of faults, until a result replaces them."""
        other = [pairId(1, 2), pairId(3, 4), pairId(5, 6)]
        for key in other:
            change(self.path, "INSERT INTO {} (pair_id, rows, cols, config) VALUES (?, 0, 2, 3)".format(TABLE), key)
        self.sink().close(finished=False)
        self.assertEqual(self.pairs(), other)
        sink = self.sink()
        sink.commit([found(1, 2), refused(3, 4, Configuration.UNDEFINED, "broken"), found(1, 3)])
        self.assertEqual((self.pairs(), sink.replaced), (sorted(other + [pairId(1, 3)]), 1))
        self.assertEqual([self.row(*pair)["config"] for pair in ((1, 2), (3, 4), (5, 6))], [2, 3, 3])

    def test_fault_in_a_row_of_colmap(self):
        """A fault must not count as done if COLMAP has stored a row without a geometry for this pair."""
        self.sink().commit(self.hashed(refused(1, 2, Configuration.UNDEFINED, "broken")))
        change(self.path, "INSERT INTO {} (pair_id, rows, cols, config) VALUES (?, 0, 2, 0)".format(TABLE), pairId(1, 2))
        self.assertFalse(self.sink(resume=True).done(pairId(1, 2)))

    def test_two_at_once(self):
        """A run begins with the first commit of its sink. Other sinks that were opened before must then
        raise an error when they commit or close, so that results of two runs are not mixed."""
        for resume in (False, True):
            with self.subTest(resume=resume):
                first = self.sink(resume=resume)
                first.commit([found(1, 2)])
                second = self.sink(resume=resume)
                late = self.sink(resume=resume)
                second.commit([found(1, 3)])
                before = dump(self.path, TABLE, "usacv20_pairs", "usacv20_runs")
                for sink in (first, late):
                    self.refused(["a.db", "another run", "has begun"], sink.commit, [found(1, 4)])
                    self.refused(["another run"], sink.close)
                self.assertEqual(dump(self.path, TABLE, "usacv20_pairs", "usacv20_runs"), before)
                second.commit([found(1, 5)])
                second.close()
                self.assertEqual(self.pairs(), [pairId(1, i) for i in (2, 3, 5)])
                self.assertEqual(lastRunOf(self.path)["state"], "finished")
                change(self.path, "DELETE FROM " + TABLE)
                change(self.path, "DROP TABLE usacv20_runs")

    def test_graph_of_some_pairs(self):
        """With keep=True, the edges for the loop check must include the accepted pairs of all earlier runs
        with the same settings, whether a run is resumed or not. Otherwise they must include only those
        of the new run."""
        one = np.array([[1.0, 0, 0, 0]])
        for settings, second in (({"threshold": 2.0}, 2), ({"threshold": 3.0}, 3), ({"threshold": 2.0}, 4)):
            sink = self.sink(settings, keep=True)
            sink.commit([found(1, second, rotations=one)])
            sink.close()
        for keywords, others in ((dict(keep=True), [2, 4]), (dict(keep=True, resume=True), [2, 4]), ({}, [])):
            sink = self.sink(**keywords)
            self.assertEqual([edge.second for edge in sink.edges()], others)
            self.assertEqual(sink.resumed, "resume" in keywords)
            self.assertFalse(sink.done(pairId(1, 9)))
            sink.close(finished=False)
        sink = self.sink(keep=True)
        sink.commit([found(1, 5, rotations=one)])
        self.assertEqual([edge.second for edge in sink.edges()], [2, 4, 5])
        change(self.path, "UPDATE usacv20_runs SET version = version - 1 WHERE run_id = 1")
        self.assertEqual([edge.second for edge in self.sink(keep=True).edges()], [4, 5])

    def test_all_or_nothing(self):
        """A commit that fails must not change the database."""
        change(self.path, "INSERT INTO {} (pair_id, rows, cols, config) VALUES (5, 0, 2, 3)".format(TABLE))
        sink = self.sink()
        wrong = found(1, 3)._replace(F=np.eye(2))
        for _ in range(2):
            with self.assertRaises(ValueError):
                sink.commit([found(1, 2), wrong])
            self.assertEqual((self.pairs(), sink.replaced), ([5], 0))
        self.assertIsNone(lastRun(sink._connection))
        sink.commit([found(1, 2)])
        with self.assertRaises(ValueError):
            sink.commit([found(1, 4), wrong])
        self.assertEqual((self.pairs(), sink.replaced), ([5, pairId(1, 2)], 0))
        self.assertEqual(rows(self.path, "SELECT pair_id FROM usacv20_pairs"), [(pairId(1, 2),)])


@once
@package
class CopyTest(DatabaseCase):

    def test_copy(self):
        target = os.path.join(self.folder, "b.db")
        for wal in (True, False):
            smallDatabase(self.path, wal=wal)
            with contextlib.closing(sqlite3.connect(self.path)) as other:
                other.execute("UPDATE images SET name = 'new.jpg' WHERE image_id = 1")
                other.commit()  # in WAL mode, this change is only in SQLite's additional file, not in the database file
                _sqlite.copyDatabase(self.path, target)
                self.assertEqual(dump(target, *INPUT), dump(self.path, *INPUT))
                self.assertIn("new.jpg", [row[1] for row in dump(target, "images")["images"]])
            self.assertEqual(rows(target, "PRAGMA journal_mode"), [("wal" if wal else "delete",)])
            self.assertEqual(sorted(os.listdir(self.folder)), ["a.db", "b.db"])
            os.remove(self.path)
            os.remove(target)

    def test_refused(self):
        smallDatabase(self.path)
        target = os.path.join(self.folder, "b.db")
        with open(target, "w") as file:
            file.write("something")
        self.refused(["b.db", "already"], _sqlite.copyDatabase, self.path, target)
        with open(target) as file:
            self.assertEqual(file.read(), "something")
        self.refused(["already"], _sqlite.copyDatabase, self.path, self.path)
        self.refused(["none"], _sqlite.copyDatabase, self.path, os.path.join(self.folder, "none", "b.db"))


if __name__ == "__main__":
    unittest.main()
