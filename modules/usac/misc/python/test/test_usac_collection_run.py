#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of collections that grow, of runs with selected pairs, and of verify(), the function that
other programs call."""

from __future__ import annotations

import contextlib
import io
import json
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from typing import Any, Dict, List
from unittest import mock

import numpy as np

from usac_collection import Collection, Recipe
from usac_collection_database import change, dump, rows
from usac_common import IN_TREE, once, package

if not IN_TREE:
    from usacv20.collection import CollectionError, _sqlite, verify
    from usacv20.collection._command import main
    from usacv20.collection._report import report
    from usacv20.collection._scores import ColumnScores

PAIRS, LATER = 234, 66  # numbers of pairs that are verified first and that are added later; together all pairs of 25 images
TABLE = "two_view_geometries"
INTERRUPTING = """
import os, signal, sys


class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == os.environ.get("AT"):
            os.kill(os.getpid(), signal.SIGINT)

signal.signal(signal.SIGINT, signal.default_int_handler)
sys.meta_path.insert(0, Finder())
"""  # a sitecustomize.py that sends Ctrl-C when a module is imported
FEW = 100  # maximum number of samples for a model; most matches are right, so few samples suffice


class RunCase(unittest.TestCase):

    folder = ""

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.collection = Collection(Recipe(images=25, lonePairs=1.0, wrong=(0.2, 0.4)))
        cls.whole = os.path.join(cls.folder, "whole.db")
        cls.collection.write(cls.whole)

    def setUp(self) -> None:
        self.path = os.path.join(self.folder, self.id().rsplit(".", 1)[1] + ".db")
        shutil.copy(self.whole, self.path)

    def verify(self, path: str = "", **options: Any) -> List[str]:
        """Runs the verification; returns the lines that the command would print."""
        said: List[str] = []
        options.setdefault("maxIterations", FEW)
        self.summary = verify(path or self.path, threads=1, say=said.append, **options)
        return said

    def list(self, keys: List[int], *more: str) -> str:
        path = self.path + ".txt"
        names = dict(rows(self.path, "SELECT image_id, name FROM images"))
        with open(path, "w") as file:
            file.write("# a comment\n\n" + "".join("{} {}\n".format(names[key % 2147483647], names[key // 2147483647]) for key in keys))
            file.writelines(line + "\n" for line in more)
        return path


@once
@package
class GrowthTest(RunCase):

    def test_new_images(self) -> None:
        later = [key for key, in rows(self.path, "SELECT pair_id FROM matches ORDER BY pair_id")][PAIRS:]
        self.assertEqual(len(later), LATER)
        change(self.path, "CREATE TABLE kept AS SELECT * FROM matches WHERE pair_id >= {}".format(later[0]))
        change(self.path, "DELETE FROM matches WHERE pair_id >= {}".format(later[0]))
        self.verify()
        threshold = self.summary.threshold
        self.assertEqual((self.summary.pairs, self.summary.skipped), (PAIRS, 0))
        before = dump(self.path, TABLE)
        change(self.path, "INSERT INTO matches SELECT * FROM kept")
        said = self.verify(resume=True)
        self.assertEqual(said[0], "threshold: {:g} px, that of the run that is continued".format(threshold))
        self.assertEqual((self.summary.pairs, self.summary.skipped, self.summary.threshold), (LATER, PAIRS, threshold))
        after = dump(self.path, TABLE)[TABLE]
        self.assertEqual(after[:PAIRS], before[TABLE])
        at_once = self.path + ".copy"
        self.verify(output=at_once, threshold=threshold)
        self.assertEqual(after, dump(at_once, TABLE)[TABLE])

    def test_matches_of_another_run(self) -> None:
        """If COLMAP has matched or verified some pairs again, --resume must verify these pairs again: the
        table must be that of a run that begins with the changed database."""
        self.verify(threshold=4.0)
        inliers = rows(self.path, "SELECT pair_id, rows, data FROM {} WHERE rows > 20 ORDER BY 1 LIMIT 4".format(TABLE))
        empty, fewer, mixed, verified = (key for key, _, _ in inliers)
        change(self.path, "UPDATE matches SET rows = 0, data = NULL WHERE pair_id = ?", empty)
        change(self.path, "UPDATE matches SET rows = ?, data = ? WHERE pair_id = ?", *inliers[1][1:], fewer)
        change(self.path, "UPDATE matches SET data = CAST(substr(data, 9) || substr(data, 1, 8) AS BLOB) WHERE pair_id = ?",
               mixed)
        change(self.path, "UPDATE {} SET rows = 1, data = zeroblob(8), config = 3 WHERE pair_id = ?".format(TABLE), verified)
        whole = self.path + ".copy"
        self.verify(output=whole, threshold=4.0)
        self.verify(threshold=4.0, resume=True)
        self.assertEqual((self.summary.pairs, self.summary.skipped), (4, PAIRS + LATER - 4))
        self.assertEqual(rows(self.path, "SELECT rows, data, config FROM {} WHERE pair_id = ?".format(TABLE), empty),
                         [(0, None, 1)])
        self.assertEqual(dump(self.path, TABLE), dump(whole, TABLE))

    def test_budget_of_a_number(self) -> None:
        """A threshold that is given as a number must have the same settings, and so the same numbers of
        samples, as the same threshold from --threshold auto."""
        self.verify()
        self.verify(threshold=self.summary.threshold)
        settings = rows(self.path, "SELECT settings FROM usacv20_runs ORDER BY run_id")
        self.assertEqual(settings[0], settings[1])
        self.assertGreater(len(json.loads(settings[0][0])["ratios"]), 50)
        self.verify(threshold=self.summary.threshold, resume=True)
        self.assertEqual(self.summary.skipped, PAIRS + LATER)

    def test_unknown_focal_lengths(self) -> None:
        shown = io.StringIO()
        change(self.path, "UPDATE cameras SET prior_focal_length = 0")
        count = rows(self.path, "SELECT count(*) FROM cameras")[0][0]
        note = "0 of {} cameras {} a known focal length: only F and H".format(count, "has" if count == 1 else "have")
        self.assertEqual(self.verify(threshold=4.0)[0], note)
        report(self.path, stream=shown)
        self.assertIn("\n  {}\n".format(note), shown.getvalue())
        for numbers, expected in (((0, 2), "0 of 2 cameras have a known focal length: only F and H"),
                                  ((1, 2), "1 of 2 cameras has a known focal length: only F and H for pairs with one of the others"),
                                  ((2, 2), ""), ((0, 0), "")):
            self.assertEqual(_sqlite.focalNote(*numbers), expected)

    def test_copy_of_another_state(self) -> None:
        """A run on a copy must not be resumed if the database has changed since the copy was made."""
        copy = self.path + ".copy"
        keys = [key for key, in rows(self.path, "SELECT pair_id FROM matches ORDER BY pair_id")]
        self.verify(output=copy, threshold=4.0, chunk=7)
        self.verify(output=copy, threshold=4.0, resume=True)
        self.assertEqual((self.summary.pairs, self.summary.skipped), (0, PAIRS + LATER))
        before = dump(copy, TABLE)
        for statement, what in (("INSERT INTO images SELECT 99, 'new.png', 1{}".format(", NULL" * 7), "images"),
                                ("UPDATE keypoints SET rows = rows - 1 WHERE image_id = 9", "keypoints"),
                                ("DELETE FROM matches WHERE pair_id = {}".format(keys[100]), "matches"),
                                ("UPDATE cameras SET prior_focal_length = 1 - prior_focal_length", "contents")):
            shutil.copy(self.whole, self.path)
            change(self.path, statement)
            with self.assertRaisesRegex(CollectionError, r"\.copy: --resume: the {} of this copy.*another file".format(what)):
                self.verify(output=copy, threshold=4.0, resume=True)
        self.assertEqual(dump(copy, TABLE), before)
        self.verify(copy, threshold=4.0, resume=True)
        self.assertEqual(self.summary.skipped, PAIRS + LATER)

    def test_copy_of_a_run(self) -> None:
        """--resume with a new copy must continue the run of the database, with its threshold."""
        copy = self.path + ".copy"
        self.verify(threshold=3.0)
        before = dump(self.path, TABLE, "usacv20_pairs", "usacv20_runs")
        change(self.path, "DELETE FROM {} WHERE pair_id = ?".format(TABLE), before[TABLE][7][0])
        said = self.verify(output=copy, resume=True)
        self.assertEqual(said[0], "threshold: 3 px, that of the run that is continued")
        self.assertEqual((self.summary.pairs, self.summary.skipped), (1, PAIRS + LATER - 1))
        self.assertEqual(dump(copy, TABLE)[TABLE], before[TABLE])
        self.assertEqual(len(dump(self.path, TABLE)[TABLE]), PAIRS + LATER - 1)

    def test_copy_that_cannot_be_used(self) -> None:
        """If a run cannot start, no copy must remain. A column that does not exist must be found before the
        database is copied."""
        copy = self.path + ".copy"
        self.verify(threshold=3.0)
        with self.assertRaisesRegex(CollectionError, "the settings are not those of the last run: threshold is 2.0 and was 3.0"):
            self.verify(output=copy, threshold=2.0, resume=True)
        self.assertFalse(os.path.exists(copy))
        change(self.path, "CREATE TABLE usacv20_trial (a)")  # the sink cannot create its table of the same name
        with self.assertRaisesRegex(CollectionError, "usacv20_trial"):
            self.verify(output=copy, threshold=2.0)
        self.assertFalse(os.path.exists(copy))
        for threshold in (None, 2.0):
            with mock.patch.object(_sqlite, "copyDatabase", side_effect=AssertionError), self.assertRaisesRegex(
                    CollectionError, r"^--scores-column: the table matches of .*\.db has no column nothing$"):
                self.verify(output=copy, threshold=threshold, scores=ColumnScores("nothing", True))

    def test_own_threshold_of_each_pair(self) -> None:
        self.verify(threshold=4.0)
        verified = self.summary.verified
        said = self.verify(method="USACV20_AUTO")
        self.assertEqual(said[0], "threshold: of each pair from its own matches, at most 12 px")
        self.assertEqual((self.summary.pairs, self.summary.faults), (PAIRS + LATER, 0))
        self.assertGreaterEqual(self.summary.verified, verified - 2)

    def test_some_pairs(self) -> None:
        self.verify(threshold=4.0)
        all_ = dump(self.path, TABLE)[TABLE]
        chosen = [row[0] for row in all_[5:200:7]]
        change(self.path, "DELETE FROM {} WHERE pair_id IN ({})".format(TABLE, ", ".join(map(str, chosen[:4]))))
        self.verify(threshold=4.0, pairs=self.list(chosen))
        self.assertEqual((self.summary.pairs, dump(self.path, TABLE)[TABLE]), (len(chosen), all_))
        change(self.path, "DELETE FROM {} WHERE pair_id IN ({})".format(TABLE, ", ".join(map(str, chosen[:4]))))
        self.verify(threshold=4.0, pairs=self.list(chosen), resume=True)
        self.assertEqual((self.summary.pairs, self.summary.skipped), (4, len(chosen) - 4))
        self.assertEqual(dump(self.path, TABLE)[TABLE], all_)

    def test_mistakes_in_the_list(self) -> None:
        for line, said in (("nobody.jpg ring00.png", "line 4: there is no image nobody.jpg"), ("ring00.png", "line 4: two names"),
                           ("ring00.png ring00.png", "line 4: an image has no pair with itself")):
            with self.assertRaisesRegex(CollectionError, said):
                self.verify(threshold=4.0, pairs=self.list(rows(self.path, "SELECT pair_id FROM matches")[0][:1], line))
        with self.assertRaisesRegex(CollectionError, "nothing.txt: the list of pairs cannot be read"):
            self.verify(threshold=4.0, pairs=os.path.join(self.folder, "nothing.txt"))

    def test_pairs_without_matches(self) -> None:
        keys = [key for key, in rows(self.path, "SELECT pair_id FROM matches ORDER BY pair_id")]
        change(self.path, "DELETE FROM matches WHERE pair_id IN ({}, {})".format(*keys[:2]))
        said = self.verify(threshold=4.0, pairs=self.list(keys[:3]))
        self.assertRegex(said[0], "^2 pairs of .* have no matches in the database$")
        self.assertEqual(self.summary.pairs, 1)
        with self.assertRaisesRegex(CollectionError, "none of its pairs has matches in the database: run a matcher first"):
            self.verify(threshold=4.0, pairs=self.list(keys[:2]))

    def test_names_with_blanks(self) -> None:
        change(self.path, "UPDATE images SET name = 'a b c.png' WHERE image_id = 1")
        keys = [key for key, in rows(self.path, "SELECT pair_id FROM matches ORDER BY pair_id")][:3]
        self.verify(threshold=4.0, pairs=self.list(keys))
        self.assertEqual([row[0] for row in dump(self.path, TABLE)[TABLE]], keys)

    def test_no_matches(self) -> None:
        for statement in ("UPDATE matches SET rows = 0, data = NULL", "DELETE FROM matches"):
            change(self.path, statement)
            for threshold in (None, 4.0):
                with self.assertRaisesRegex(CollectionError, "no pair has matches: run a matcher first"):
                    self.verify(threshold=threshold)


@once
@package
class FunctionTest(RunCase):

    def test_as_the_command(self) -> None:
        self.verify(threshold=3.0, minInliers=20, seed=3)
        other = os.path.join(self.folder, "by_command.db")
        shutil.copy(self.whole, other)
        with open(os.devnull, "w") as nowhere, contextlib.redirect_stdout(nowhere):
            self.assertEqual(main(["verify", other, "--threshold", "3", "--min-inliers", "20", "--seed", "3", "--threads", "1",
                                   "--max-iterations", str(FEW)]), 0)
        self.assertEqual(dump(self.path, TABLE), dump(other, TABLE))
        counts: Dict[bool, int] = dict(rows(self.path, "SELECT rows > 0, COUNT(*) FROM {} GROUP BY 1".format(TABLE)))
        self.assertEqual((self.summary.verified, self.summary.refused, self.summary.faults), (counts[1], counts[0], 0))

    def test_numbers_of_numpy(self) -> None:
        self.verify(threshold=np.float32(3), minInliers=np.int64(20), watermarks=np.bool_(True), loops=np.bool_(True),
                    seed=np.uint8(3))
        self.verify(threshold=3.0, minInliers=20, watermarks=True, loops=True, seed=3, resume=True)
        self.assertEqual(self.summary.skipped, PAIRS + LATER)

    def test_numbers(self) -> None:
        self.verify(threshold=4.0)
        with open(self.path, "rb") as file:
            before = file.read()
        for options, said in ((dict(thresholds=3), "thresholds: there is no such setting"),
                              (dict(chunk=0), "chunk: a positive number is expected"), (dict(chunk=-3), "chunk"),
                              (dict(chunk=2.5), "chunk"), (dict(threads=-1), "threads: an integer of at least 0"),
                              (dict(workers=-1), "workers"), (dict(chunk=0, output=self.path + ".copy"), "chunk")):
            with self.assertRaisesRegex(CollectionError, said):
                verify(self.path, threshold=4.0, **options)
        with open(self.path, "rb") as file:
            self.assertEqual(file.read(), before)
        self.assertFalse(os.path.exists(self.path + ".copy"))

    def test_interrupted(self) -> None:
        timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            for _ in range(50):
                self.verify(threshold=4.0, chunk=1)
        timer.join()


@once
@package
class OutputTest(RunCase):

    def process(self, *arguments: str, **options: Any) -> "subprocess.Popen[bytes]":
        return subprocess.Popen([sys.executable, "-m", "usacv20.collection", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                **options)

    def test_nobody_reads(self) -> None:
        """If the reader of the output has ended (as with `| head -1`), the command must still do its
        work, without an error message about the broken pipe."""
        for arguments in (("verify", self.path, "--threshold", "4", "--max-iterations", str(FEW)), ("report", self.path)):
            reader, writer = os.pipe()
            os.close(reader)
            with subprocess.Popen([sys.executable, "-m", "usacv20.collection", *arguments], stdout=writer,
                                  stderr=subprocess.PIPE) as run:
                os.close(writer)
                error = run.communicate()[1]
            self.assertEqual((run.returncode, error), (0, b""))
        self.assertEqual(rows(self.path, "SELECT state FROM usacv20_runs"), [("finished",)])

    def test_full_disk(self) -> None:
        """A copy that does not fit on the disk must be removed. A limit of the file size simulates a
        full disk."""
        import resource
        target = os.path.join(self.folder, "copies", "copy.db")
        os.mkdir(os.path.dirname(target))
        most = os.path.getsize(self.whole) // 2

        def limit() -> None:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

        with self.process("verify", self.path, "--threshold", "4", "--output", target, preexec_fn=limit) as run:
            error = run.communicate()[1].decode()
        self.assertEqual((run.returncode, error.count("\n")), (2, 1), error)
        self.assertIn("copy.db", error)
        self.assertEqual(os.listdir(os.path.dirname(target)), [])

    def test_interrupted_imports(self) -> None:
        """Ctrl-C while modules are being imported must end the command silently, and raise
        KeyboardInterrupt in a program that imports the package."""
        with open(os.path.join(self.folder, "sitecustomize.py"), "w") as file:
            file.write(INTERRUPTING)
        for name in ("numpy", "numpy.core._multiarray_umath", "usacv20._native", "usacv20._params", "usacv20.collection._command", "sqlite3"):
            path = os.pathsep.join([self.folder] + sys.path)
            with self.process("verify", self.path, env=dict(os.environ, AT=name, PYTHONPATH=path)) as run:
                output = run.communicate()
            self.assertEqual((output, run.returncode), ((b"", b""), -signal.SIGINT), name)
        with subprocess.Popen([sys.executable, "-c", "import usacv20"], stderr=subprocess.PIPE,
                              env=dict(os.environ, AT="numpy.core._multiarray_umath", PYTHONPATH=path)) as run:
            error = run.communicate()[1].decode()
        self.assertTrue(error.rstrip().endswith("KeyboardInterrupt"), error)
        self.assertNotIn("ImportError:", error)

    def test_interrupted_early(self) -> None:
        """Ctrl-C during the start of the program must stop it without damage to the database. On a fast
        machine, a run can end before the signal comes, and a library that is being imported can
        swallow the signal. So it suffices that one of the three runs ends with a code other than 0."""
        codes = []
        for seconds in (0.15, 0.3, 0.45):
            # Resets the handler, because background jobs of a shell and their children ignore SIGINT.
            with self.process("verify", self.path, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as run:
                time.sleep(seconds)
                run.send_signal(signal.SIGINT)
                error = run.communicate()[1].decode()
            codes.append(run.returncode)
            if not error:  # otherwise Python itself was still starting, and other exit codes are possible
                self.assertIn(run.returncode, (0, 130, -signal.SIGINT))
            self.assertNotIn("_command.py", error)  # a traceback is allowed only from Python's own start, not from this program
            with contextlib.closing(sqlite3.connect(self.path)) as connection:
                self.assertEqual(connection.execute("PRAGMA integrity_check").fetchall(), [("ok",)])
        self.assertTrue(any(codes), codes)


if __name__ == "__main__":
    unittest.main()
