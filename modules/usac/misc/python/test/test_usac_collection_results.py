#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the result files (SQLite, NPZ, HDF5) of the command `pairs`: writing and reading, and
interrupted and resumed runs."""

import contextlib
import gc
import io
import os
import signal
import sqlite3
import subprocess
import sys
import tracemalloc
import unittest
from unittest import mock

import numpy as np

from usac_collection_lists import Files, h5py, matchesOf, needsH5py
from usac_common import Scene, once, package

try:
    from usacv20.collection import _list_columns
    from usacv20.collection._engine import run
    from usacv20.collection._geometry import verifyPairs
    from usacv20.collection._list_results import TABLE, openResults, readResults
    from usacv20.collection._pair import CollectionError, Configuration, TwoView
    from usacv20.collection._settings import Settings
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass

FORMATS = (".sqlite", ".npz") + ((".h5",) if h5py is not None else ())

# A program that stores four pairs in each commit and kills itself just before its fourth commit, so
# that only the results of three commits, 12 pairs, are stored.
KILLED = """
import os, signal, sys
from usacv20.collection._geometry import verifyPairs
from usacv20.collection._list_results import openResults
from usacv20.collection._lists import ListSource
from usacv20.collection._settings import Settings
source, settings, commits = ListSource(sys.argv[1]), Settings(threshold=2.0), []
sink = openResults(sys.argv[2], source, settings.asDict(), len(sys.argv) > 3)
def trace(statement):
    if statement.startswith("COMMIT"):
        commits.append(statement)
        if len(commits) == 4:
            os.kill(os.getpid(), signal.SIGKILL)
getattr(sink, "_rows", sink)._connection.set_trace_callback(trace)
keys = [key for key in source.keys() if not sink.done(key)]
for start in range(0, len(keys), 4):
    sink.commit(verifyPairs(source.load(keys[start:start + 4]), settings))
"""


def result(number, name=None):
    """Returns a made-up result, which depends only on `number` and `name`. Each optional part (models,
    quaternion, translation) is None for some numbers."""
    rng = np.random.RandomState(number)
    inliers = rng.randint(0, 2**32, (number % 5, 2), np.int64).astype(np.uint32)
    models = [None if number % (i + 2) == 0 else rng.normal(size=shape) for i, shape in enumerate(((3, 3),) * 3 + (4, 3))]
    return TwoView(name or "pair {:03d}".format(number), Configuration(number % 8), inliers, *models,
                   "" if number % 4 else "\u00e4 reason {}".format(number % 12), 5 + number, number * 7, rng.rand(), rng.rand())


def same(first, second, times=True):
    return len(first) == len(second) and all(
        type(a) is type(b) and np.array_equal(a, b) and getattr(a, "dtype", 0) == getattr(b, "dtype", 0)
        for field, a, b in zip(first._fields, first, second) if times or field != "milliseconds")


@once
@package
class ResultsTest(Files):

    def setUp(self):
        super().setUp()
        self.list = os.path.dirname(self.path("list/"))
        rows, general = np.arange(300), Scene(False)
        for i in range(26):
            part = np.random.RandomState(i).permutation(rows)[:120 if i else 5]
            np.savez(self.path("list/p{:02d}.npz".format(i)), points1=general.points1[part], points2=general.points2[part],
                     K1=general.K1, K2=general.K2)
        self.pairs = self.source(self.list)
        self.settings = Settings(threshold=2.0)

    def open(self, name, resume=False, **changed):
        sink = openResults(self.path(name), self.pairs, dict(self.settings.asDict(), **changed), resume)
        self.addCleanup(sink.close, False)
        return sink

    def assertResults(self, name, expected, times=True):
        found = list(readResults(self.path(name)))
        self.assertEqual([r.key for r in found], sorted(r.key for r in expected))
        for a, b in zip(found, sorted(expected, key=lambda r: r.key)):
            self.assertTrue(same(a, b, times), (a, b))

    def assertMistake(self, pattern, function, *args, **kwargs):
        with self.assertRaisesRegex(CollectionError, pattern) as caught:
            function(*args, **kwargs)
        self.assertNotIn("\n", str(caught.exception))

    def test_round_trip(self):
        results = [result(i) for i in range(60)]
        for extension in FORMATS:
            for block in (7, 4096):
                with self.subTest(extension), mock.patch.object(_list_columns, "_BLOCK", block):
                    name = "o{}{}".format(block, extension)
                    sink = self.open(name)
                    for start in range(0, 60, 13):
                        sink.commit(results[::-1][start:start + 13])
                    sink.close()
                    self.assertResults(name, results)
                    self.assertFalse(os.path.exists(self.path(name + ".part")))
        self.open("none.npz").close()
        self.assertEqual(list(readResults(self.path("none.npz"))), [])

    def test_arrays(self):
        """The arrays of an NPZ file must be readable with NumPy alone, without the package."""
        results = [result(i) for i in range(20)]
        sink = self.open("o.npz")
        sink.commit(results)
        sink.close()
        with np.load(self.path("o.npz")) as arrays:
            for i, r in enumerate(results):
                offsets = arrays["offsets"]
                np.testing.assert_array_equal(arrays["inliers"][offsets[i]:offsets[i + 1]], r.inliers)
                np.testing.assert_array_equal(arrays["E"][i], np.full((3, 3), np.nan) if r.E is None else r.E)
                self.assertEqual((arrays["names"][i], arrays["configurations"][i], arrays["reasons"][arrays["reason"][i]]),
                                 (r.key, int(r.configuration), r.reason))
            self.assertNotIn("images", arrays.files)

    @needsH5py
    def test_images(self):
        a, b, _ = matchesOf(0)
        self.h5("f.h5", **{"x/one.jpg/keypoints": a, "two.jpg/keypoints": b})
        self.h5("m.h5", **{"x-one.jpg/two.jpg/matches0": np.arange(12)})
        self.pairs = self.source(self.path("m.h5"), self.path("f.h5"))
        for extension in (".sqlite", ".npz"):
            sink = self.open("o" + extension)
            sink.commit([result(1, "x-one.jpg/two.jpg")])
            sink.close()
        with np.load(self.path("o.npz")) as arrays:
            self.assertEqual(arrays["images"].tolist(), [["x/one.jpg", "two.jpg"]])
        with sqlite3.connect(self.path("o.sqlite")) as connection:
            self.assertEqual(connection.execute("SELECT image1, image2 FROM " + TABLE).fetchall(), [("x/one.jpg", "two.jpg")])
        connection.close()

    def run_all(self, name, resume=False):
        sink = self.open(name, resume)
        keys = [key for key in self.pairs.keys() if sink.done(key)]
        with contextlib.redirect_stderr(io.StringIO()):  # pairs that cannot be read are named on stderr
            summary = run(self.pairs, sink, self.settings, verifyPairs, threads=2, chunk=5, progress=False)
        sink.close(not summary.interrupted)
        return keys

    def test_killed(self):
        self.run_all("whole.npz")
        whole = list(readResults(self.path("whole.npz")))
        counts = [sum(r.configuration == c for r in whole) for c in (Configuration.CALIBRATED, Configuration.DEGENERATE)]
        self.assertEqual(counts, [25, 1])
        for extension in FORMATS:
            with self.subTest(extension):
                name = "o" + extension
                for times in (1, 2):
                    killed = subprocess.run([sys.executable, "-c", KILLED, self.list, self.path(name)] + ["resume"] * (times - 1))
                    self.assertEqual(killed.returncode, -signal.SIGKILL)
                    partial = name if extension == ".sqlite" else name + ".part"
                    self.assertResults(partial, whole[:12 * times], times=False)
                self.assertEqual(self.run_all(name, resume=True), [r.key for r in whole[:24]])
                self.assertResults(name, whole, times=False)
                self.assertEqual(self.run_all(name, resume=True), [r.key for r in whole])  # no pair is left to process
                self.assertResults(name, whole, times=False)

    def test_grown(self):
        """File p03 is damaged during the first run and repaired before the second run, which has
        resume=True. The second run must take all other results from the complete file of the first
        run and process only p03."""
        with open(self.path("list/p03.npz"), "rb+") as file:
            whole = file.read()
            file.truncate(100)
        for extension in FORMATS:
            with self.subTest(extension):
                self.write("list/p03.npz", whole[:100])
                self.pairs = self.source(self.list)
                self.run_all("o" + extension)
                found = {r.key: r for r in readResults(self.path("o" + extension))}
                self.assertEqual((len(found), found["p03"].configuration), (26, Configuration.UNDEFINED))
                self.assertIn("p03: no NPZ", found["p03"].reason)
                self.write("list/p03.npz", whole)
                done = self.run_all("o" + extension, resume=True)
                self.assertEqual(sorted(set(found) - set(done)), ["p03"])
                again = {r.key: r for r in readResults(self.path("o" + extension))}
                self.assertEqual(again["p03"].configuration, Configuration.CALIBRATED)
                self.assertTrue(all(same(again[key], found[key]) for key in found if key != "p03"))

    def test_interrupted(self):
        """An interrupted run must leave the file OUTPUT.part for --resume. A complete file OUTPUT of
        an earlier run must stay until the resumed run has ended and replaces it."""
        sink = self.open("o.npz")
        sink.commit([result(i) for i in range(1, 8)])
        sink.close(False)
        self.assertFalse(os.path.exists(self.path("o.npz")))
        sink = self.open("o.npz", True)
        self.assertTrue(sink.done("pair 007") and not sink.done("pair 008"))
        sink.close()
        sink = self.open("o.npz", True)
        sink.commit([result(9)])
        sink.close(False)
        self.assertResults("o.npz", [result(i) for i in range(1, 8)])
        sink = self.open("o.npz", True)
        self.assertTrue(sink.done("pair 009"))
        sink.close()
        self.assertResults("o.npz", [result(i) for i in (1, 2, 3, 4, 5, 6, 7, 9)])

    def test_all_or_nothing(self):
        sink = self.open("o.sqlite")
        sink.commit([result(1)])
        with self.assertRaises((CollectionError, TypeError)):
            sink.commit([result(2), result(3)._replace(reason=None)])
        sink.commit([result(4)])
        sink.close()
        self.assertResults("o.sqlite", [result(1), result(4)])
        self.assertMistake("closed", sink.commit, [result(5)])

    def test_mistakes(self):
        self.assertMistake("go to files .sqlite.*Parquet", self.open, "o.parquet")
        self.assertMistake("go to files .sqlite, .sqlite3, .db, .npz, .h5 or .hdf5$", self.open, "o.txt")
        self.assertMistake("cannot be opened", openResults, os.path.join(self.folder, "none", "o.db"), self.pairs, {})
        for extension in FORMATS:
            sink = self.open("o" + extension)
            sink.commit([result(1)])
            sink.close(False)
            self.assertMistake("--resume", self.open, "o" + extension)
            self.assertMistake("other settings", self.open, "o" + extension, True, threshold=3.0)
            self.open("o" + extension, True).close()
            self.assertMistake("--resume", self.open, "o" + extension)
            self.assertMistake("other settings", self.open, "o" + extension, True, threshold=3.0)
            self.assertResults("o" + extension, [result(1)])
            self.write("bad" + extension, self.read("o" + extension)[:700])
            self.assertMistake("damaged", list, readResults(self.path("bad" + extension)))
            self.write("text" + extension, "text")
            self.assertMistake("text" + extension, list, readResults(self.path("text" + extension)))
            self.assertMistake("text" + extension, self.open, "text" + extension, True)
        with mock.patch.dict(sys.modules, {"h5py": None}):  # the message must be about the file, not about h5py
            self.assertMistake("text.sqlite: no results", list, readResults(self.path("text.sqlite")))
        with sqlite3.connect(self.path("other.db")) as connection:
            connection.execute("CREATE TABLE images (a)")
        connection.close()
        self.assertMistake("not of this command", self.open, "other.db", True)
        self.assertMistake("no results", list, readResults(self.path("other.db")))
        np.savez(self.path("other.npz"), a=[1])
        self.assertMistake("no results", list, readResults(self.path("other.npz")))
        self.assertMistake("No such file", list, readResults(self.path("none")))

    def test_locked(self):
        sink = self.open("o.sqlite")
        other = sqlite3.connect(self.path("o.sqlite"), isolation_level=None)
        self.addCleanup(other.close)
        other.execute("BEGIN IMMEDIATE")
        sink._connection.execute("PRAGMA busy_timeout = 10")
        self.assertMistake("locked", sink.commit, [result(1)])
        other.execute("COMMIT")
        sink.commit([result(1)])
        sink.close()
        self.assertResults("o.sqlite", [result(1)])

    def test_without_h5py(self):
        with mock.patch.dict(sys.modules, {"h5py": None}):
            self.assertMistake("h5py is needed", self.open, "o.h5")
        self.assertFalse(os.path.exists(self.path("o.h5.part")))

    def test_memory(self):
        """Results are written and read in blocks, so the memory must not depend on the number of
        pairs."""
        peaks, some = [], [result(i) for i in range(1, 98)]
        with mock.patch.object(_list_columns, "_BLOCK", 64):
            for count in (200, 1000, 2500):  # the first run also loads modules, so only the others are compared
                sink = self.open("o{}.npz".format(count))
                tracemalloc.start()
                for start in range(0, count, 100):
                    sink.commit([some[i % 97]._replace(key="pair {:06d}".format(i)) for i in range(start, start + 100)])
                    gc.collect()  # objects in reference cycles must not count
                sink.close()
                self.assertEqual(sum(1 for _ in readResults(self.path("o{}.npz".format(count)))), count)
                peaks.append(tracemalloc.get_traced_memory()[1])
                tracemalloc.stop()
        self.assertLess(peaks[2], peaks[1] + 100000)  # bytes; the results of the largest file need about a megabyte


if __name__ == "__main__":
    unittest.main()
