#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs the collection tool's engine on all pairs of a database, with threads and with Dask. The
table of results must be the same each time, even if a run is stopped or killed and then resumed,
or if a worker dies."""

import contextlib
import importlib.util
import io
import os
import pickle
import shutil
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

from usac_collection_database import DatabaseCase, change, dump, pairId, rows, smallDatabase
from usac_common import IN_TREE, once, package

if not IN_TREE:
    import usac_collection_verify as stand
    from usacv20.collection import _dask, _engine, _work
    from usacv20.collection._database import DatabaseSource
    from usacv20.collection._database_sink import DatabaseSink
    from usacv20.collection._pair import CollectionError
    from usacv20.collection._selection import Selection

FOLDER = os.path.dirname(os.path.abspath(__file__))
PAIRS = 190  # number of pairs of 20 images


class Rows(object):
    """Passes results to another sink. Counts commits and results, and calls `before(self)` before each
    commit, if `before` is not None."""

    def __init__(self, sink, before=None):
        self.sink, self.before, self.commits, self.results = sink, before, 0, 0

    def done(self, key):
        return self.sink.done(key)

    def commit(self, results):
        self.commits += 1
        if self.before is not None:
            self.before(self)
        self.results += len(results)
        self.sink.commit(results)


class EngineCase(DatabaseCase):

    def setUp(self):
        super().setUp()
        self.count = 0
        smallDatabase(self.path, images=20, points=30)

    def run_engine(self, path=None, resume=False, before=None, settings=None, verify=None, progress=False, **keywords):
        """Runs the engine; returns (summary, table of results, output on stderr)."""
        path = path or self.fresh()
        source, sink = self.source(path), DatabaseSink(path, settings or {}, resume)
        told = io.StringIO()
        with contextlib.redirect_stderr(told), contextlib.closing(sink):
            summary = _engine.run(source, Rows(sink, before), settings or {}, verify or stand.verify, progress=progress,
                                  **keywords)
        source.close()
        return summary, self.table(path), told.getvalue()

    def fresh(self):
        self.count += 1
        path = os.path.join(self.folder, "copy{}.db".format(self.count))
        shutil.copy(self.path, path)
        return path

    @staticmethod
    def table(path):
        return dump(path, "two_view_geometries")

    def reference(self):
        return self.run_engine(threads=1)[1]


@once
@package
class ThreadsTest(EngineCase):

    def test_the_same_table(self):
        summary, expected, told = self.run_engine(threads=1)
        self.assertEqual(len(expected["two_view_geometries"]), PAIRS)
        self.assertEqual(told, "")
        self.assertEqual((summary.pairs, summary.skipped, summary.faults, summary.interrupted), (PAIRS, 0, 0, False))
        short = sum(len(row[3] or b"") == 0 for row in expected["two_view_geometries"])
        self.assertEqual(summary.refused, short)
        self.assertTrue(0 < short < PAIRS)
        self.assertTrue(min(summary.reading, summary.estimating, summary.writing) > 0)
        self.assertIn("{} pairs".format(PAIRS), summary.line())
        for keywords in (dict(threads=2), dict(threads=2, chunk=1), dict(threads=3, chunk=7), dict(chunk=1000), dict()):
            found, table, _ = self.run_engine(**keywords)
            self.assertEqual(table, expected, keywords)
            self.assertEqual((found.pairs, found.refused), (PAIRS, short))
        self.assertNotEqual(self.run_engine(settings={"seed": 1})[1], expected)

    def test_bounded(self):
        """The number of pairs whose keys were read but whose results are not stored yet must not
        depend on the total number of pairs. With two threads it is at most 20: four chunks of 5."""
        drawn = []

        class Counted(DatabaseSource):
            def keys(self):
                for key in super().keys():
                    drawn.append(key)
                    yield key

        ahead = []
        path = self.fresh()
        source = Counted(path)
        with contextlib.closing(DatabaseSink(path, {})) as sink:
            _engine.run(source, Rows(sink, lambda counted: ahead.append(len(drawn) - counted.results)), {}, stand.verify,
                        threads=2, chunk=5)
        source.close()
        self.assertEqual(len(drawn), PAIRS)
        self.assertLessEqual(max(ahead), 4 * 5)

    def test_faults(self):
        expected = self.reference()["two_view_geometries"]
        for key in ((1, 2), (3, 7)):
            change(self.path, "UPDATE matches SET rows = 5 WHERE pair_id = ?", pairId(*key))
        summary, table, told = self.run_engine()
        self.assertEqual((summary.pairs, summary.faults), (PAIRS, 2))
        self.assertIn("2 cannot be read", summary.line())
        bad = [pairId(1, 2), pairId(3, 7)]
        self.assertEqual(table["two_view_geometries"], [row for row in expected if row[0] not in bad])
        self.assertEqual([line.split(":")[1] for line in sorted(told.splitlines())],
                         [" image1.jpg - image2.jpg", " image3.jpg - image7.jpg"])
        change(self.path, "UPDATE matches SET rows = 5")
        told = self.run_engine()[2].splitlines()
        self.assertEqual((len(told), told[-1]), (21, "more pairs cannot be read; the report lists them"))

    def test_a_mistake_in_a_worker(self):
        path = self.fresh()
        for verify, words in ((stand.fails, "a mistake in image"), (stand.forgets, "other pairs")):
            with self.assertRaisesRegex(RuntimeError, words):
                self.run_engine(path, verify=verify, threads=2, chunk=5)
        with self.assertRaisesRegex(CollectionError, "full"):
            self.run_engine(before=mock.Mock(side_effect=CollectionError("the disk is full")), threads=2, chunk=5)
        self.assertEqual(rows(path, "PRAGMA integrity_check"), [("ok",)])

    def test_mistake_keeps_the_others(self):
        """A chunk fails with an error. The results of all earlier pairs must be stored, even if they
        become ready during the same commit as the error. Slow commits make this likely."""
        expected = self.reference()["two_view_geometries"]
        # Number of pairs whose first image is one of the images 1 to 9. All chunk sizes divide this
        # number, so that the next chunk begins with image 10 and fails.
        before = sum(20 - i for i in range(1, 10))
        for chunk in (5, 9, 15, 27, 45):
            path = self.fresh()
            with self.assertRaises(RuntimeError):
                self.run_engine(path, verify=stand.failsLate, before=lambda _: time.sleep(0.03), threads=3, chunk=chunk)
            stored = self.table(path)["two_view_geometries"]
            self.assertEqual(stored[:before], expected[:before])
            self.assertLess(len(stored), PAIRS)

    def test_interrupted_while_pairs_are_skipped(self):
        """The first Ctrl-C must also stop a resumed run that is still skipping finished pairs. Unfinished
        pairs that the run has found so far must not be processed."""
        path = self.fresh()
        self.run_engine(path)
        change(path, "DELETE FROM two_view_geometries WHERE pair_id = ?", pairId(1, 4))
        source, asked = self.source(path), []

        class Asked(DatabaseSink):
            def done(self, key):
                asked.append(key)
                if len(asked) == 10:
                    os.kill(os.getpid(), signal.SIGINT)
                return super().done(key)

        before = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
        with contextlib.closing(Asked(path, {}, True)) as sink:
            summary = _engine.run(source, sink, {}, stand.fails, threads=1)
        self.assertEqual((signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)), before)
        self.assertEqual((len(asked), summary.skipped, summary.pairs, summary.interrupted), (10, 9, 0, True))


@once
@package
class ProgressTest(EngineCase):

    def test_bar(self):
        if importlib.util.find_spec("tqdm") is None:
            self.skipTest("tqdm was not found")
        change(self.path, "UPDATE matches SET rows = 5 WHERE pair_id = ?", pairId(1, 2))
        summary, _, told = self.run_engine(progress=True)
        self.assertIn("{0}/{0}".format(PAIRS), told)
        self.assertIn("pairs/s", told)
        self.assertIn("cannot be read: image1.jpg - image2.jpg", told)
        self.assertNotIn("pairs/s", self.run_engine(progress=None)[2])  # no bar, because stderr is not a terminal
        with mock.patch.dict(sys.modules, tqdm=None), self.assertRaisesRegex(CollectionError, "tqdm"):
            self.run_engine(progress=True)


class ProcessCase(EngineCase):
    """Base class of tests that start a run in a separate process and stop it before its end."""

    def start(self, path, *options):
        command = [sys.executable, os.path.join(FOLDER, "usac_collection_verify.py"), path] + list(options)
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                                   start_new_session=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def wait(self, path, process, count=20):
        """Waits until the run has stored at least `count` pairs."""
        for _ in range(600):
            time.sleep(0.05)
            self.assertIsNone(process.poll(), "the run ended too early")
            with contextlib.suppress(Exception):
                if rows(path, "SELECT count(*) FROM usacv20_pairs")[0][0] >= count:
                    return
        self.fail("the run has stored too few pairs within about 30 seconds")

    def stopped(self, path, number, group, *options):
        """Starts a run and stops it with the signal `number`. If `group` is true, child processes of
        the run get the signal, too. Returns (exit code, stdout, stderr)."""
        process = self.start(path, *options)
        self.wait(path, process)
        (os.killpg if group else os.kill)(process.pid, number)
        out, error = process.communicate(timeout=60)
        return process.returncode, out, error

    def resumed(self, path):
        """Resumes a stopped run. The table must then equal that of a run that was not stopped."""
        self.assertEqual(rows(path, "PRAGMA integrity_check"), [("ok",)])
        before = rows(path, "SELECT count(*) FROM two_view_geometries")[0][0]
        self.assertTrue(20 <= before < PAIRS)
        self.assertEqual(rows(path, "SELECT count(*) FROM usacv20_pairs"), [(before,)])
        summary, table, _ = self.run_engine(path, resume=True)
        self.assertEqual(summary.skipped, before)
        self.assertEqual(table, self.reference())


@once
@package
class KillTest(ProcessCase):

    def test_killed(self):
        path = self.fresh()
        code, _, error = self.stopped(path, signal.SIGKILL, True)
        self.assertEqual((code, error), (-signal.SIGKILL, ""))
        self.assertEqual(rows(path, "SELECT state FROM usacv20_runs"), [("running",)])
        self.resumed(path)

    def test_interrupted(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            path = self.fresh()
            code, out, error = self.stopped(path, number, True)
            self.assertEqual((code, error), (130, ""))
            self.assertIn("interrupted", out)
            self.assertEqual(rows(path, "SELECT state FROM usacv20_runs"), [("interrupted",)])
            self.assertFalse([name for name in os.listdir(self.folder) if name.endswith(("-wal", "-shm", "-journal"))])
            self.resumed(path)


@once
@package
class DaskTest(ProcessCase):

    @classmethod
    def setUpClass(cls):
        try:
            import distributed
        except ImportError:
            raise unittest.SkipTest("distributed was not found")
        cls.cluster = _dask.localCluster(distributed, 2)
        cls.addClassCleanup(cls.cluster.close)
        cls.address = cls.cluster.scheduler_address

    def killer(self, killed):
        """Returns a function that kills a worker before the third commit and appends the worker's
        process id to the list `killed`."""
        def kill(counted):
            if counted.commits == 3:
                process = list(self.cluster.workers.values())[0].pid
                os.kill(process, signal.SIGKILL)
                killed.append(process)
        return kill

    def test_shared_files(self):
        killed = []
        reference = self.reference()
        change(self.path, "UPDATE matches SET rows = 5 WHERE pair_id = ?", pairId(1, 2))
        summary, table, told = self.run_engine(scheduler=self.address, chunk=5, settings={"sleep": 0.005},
                                               before=self.killer(killed))
        self.assertEqual(len(killed), 1)
        self.assertEqual(table["two_view_geometries"], reference["two_view_geometries"][1:])
        self.assertEqual((summary.pairs, summary.faults), (PAIRS, 1))
        self.assertIn("image1.jpg - image2.jpg", told)
        self.assertNotIn("do not see the same files", told)

    def test_selected_pairs(self):
        """The keys of a selection must not be sent to the workers: the source is sent with each chunk."""
        path, expected = self.fresh(), self.reference()["two_view_geometries"]
        listed = os.path.join(self.folder, "pairs.txt")
        with open(listed, "w") as file:
            file.writelines("image{}.jpg image{}.jpg\n".format(i, j) for i in range(1, 21) for j in range(i + 1, 21, 2))
        source = Selection(self.source(path), listed)
        chosen = set(source.keys())
        self.assertEqual(len(chosen), 100)
        self.assertLess(len(pickle.dumps(source)), len(pickle.dumps(source.source)) + 500)
        told = io.StringIO()
        with contextlib.closing(DatabaseSink(path, {})) as sink, contextlib.redirect_stderr(told):
            summary = _engine.run(source, sink, {}, stand.verify, scheduler=self.address, chunk=5, progress=False)
        self.assertEqual((summary.pairs, len(source), told.getvalue()), (100, 100, ""))
        self.assertEqual(self.table(path)["two_view_geometries"], [row for row in expected if row[0] in chosen])

    def test_files_that_are_not_shared(self):
        killed = []
        with mock.patch.object(sys.modules[__name__], "DatabaseSource", stand.Here), \
                mock.patch("usac_collection_database.DatabaseSource", stand.Here):
            summary, table, told = self.run_engine(scheduler=self.address, chunk=5, settings={"sleep": 0.005},
                                                   before=self.killer(killed))
        self.assertEqual(len(killed), 1)
        self.assertEqual(table, self.reference())
        self.assertGreater(summary.reading, 0)
        self.assertIn("do not see the same files", told)

    def test_chunks_in_progress(self):
        """After an interruption or an error of a worker, chunks that a worker has begun must be finished and
        stored, and the others must be canceled."""
        def stop(counted):
            if counted.commits == 1:
                os.kill(os.getpid(), signal.SIGTERM)

        for verify, before in ((stand.logged, stop), (stand.loggedOrFails, None)):
            path, log = self.fresh(), os.path.join(self.folder, verify.__name__ + ".txt")
            call = dict(verify=verify, before=before, settings={"log": log, "sleep": 0.08}, chunk=5, scheduler=self.address)
            if before is None:
                with self.assertRaisesRegex(RuntimeError, "a mistake"):
                    self.run_engine(path, **call)
            else:
                self.assertTrue(self.run_engine(path, **call)[0].interrupted)
            with open(log) as file:
                begun = {int(line) for line in file}
            stored = {row[0] for row in self.table(path)["two_view_geometries"]}
            self.assertLessEqual(begun, stored)
            self.assertTrue(5 * len(begun) == len(stored) < PAIRS, (begun, len(stored)))

    def test_own_workers(self):
        """Ctrl-C in a terminal also reaches the Dask workers that the run has started. The run must
        nevertheless end without a traceback, and it must be possible to resume the run."""
        path = self.fresh()
        code, out, error = self.stopped(path, signal.SIGINT, True, "workers")
        self.assertEqual(code, 130, error)  # stderr is not always empty: some Dask versions log closed workers
        self.assertNotIn("Traceback", error)
        self.assertIn("interrupted", out)
        self.resumed(path)

    def test_workers_that_differ(self):
        """A worker that joins later and sees other files than the main process must raise an error. If
        several workers die while they process the same chunk, the error message must say so."""
        source = self.source(self.fresh())
        packed, keys = pickle.dumps(source), list(source.keys())
        for fingerprint in (source.fingerprint(), "another"):
            with contextlib.ExitStack() as stack:
                if fingerprint == "another":
                    stack.enter_context(self.assertRaisesRegex(CollectionError, "other files"))
                    _work._checked.clear()
                found = _work.processRemotely(packed, fingerprint, keys, None, 0, stand.verify, {})
                self.assertEqual([result.key for result in found.results], keys)
        killed = type("KilledWorker", (Exception,), {})("task 5")
        self.assertRegex(str(_dask.Cluster.explain(None, killed)), "several workers died.*task 5")

    def test_mistakes_of_the_call(self):
        with self.assertRaisesRegex(CollectionError, "not both"):
            self.run_engine(scheduler=self.address, workers=2)
        with mock.patch.object(_dask, "_CONNECT", 0.5):
            for address in ("tcp://127.0.0.1:9", "nothing://x", "tcp://nowhere.invalid:80"):
                with self.assertRaisesRegex(CollectionError, address):
                    self.run_engine(scheduler=address)
        with mock.patch.dict(sys.modules, distributed=None):
            with self.assertRaisesRegex(CollectionError, "python3-distributed"):
                self.run_engine(workers=2)


if __name__ == "__main__":
    unittest.main()
