#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the command line of the collection tool from end to end, and of the options that read
scores of matches."""

import contextlib
import io
import json
import os
import sqlite3
import tempfile
import unittest

import numpy as np

from test_usac_collection_geometry import K, Scene
from usac_collection_database import PINHOLE, pairId, writeDatabase
from usac_collection_lists import h5py, needsH5py
from usac_common import once, package

try:
    from usacv20.collection._command import main
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass

NAMES = {1: "day/a.jpg", 2: "day/b.jpg", 3: "night/c.jpg", 4: "d.jpg"}
WRONG = 0.96  # fraction of wrong matches, so high that 40 samples find a model only if the scores guide them


def scenes(wrong):
    """Returns the scenes of two image pairs that have no image in common."""
    return {(1, 2): Scene(7, wrong=wrong, count=2500), (3, 4): Scene(8, wrong=wrong, count=2500)}


def collection(path, wrong=WRONG):
    keypoints, matches, right = {}, {}, {}
    for pair, scene in scenes(wrong).items():
        for image, view, side in zip(pair, (scene.pair.first, scene.pair.second), (0, 1)):
            keypoints[image] = np.empty((len(view.points), 2), np.float32)
            keypoints[image][scene.matches[:, side]] = view.points
        matches[pair], right[pair] = scene.matches, scene.right
    cameras = {1: (PINHOLE, 1000, 800, [K[0, 0], K[1, 1], K[0, 2], K[1, 2]], True)}
    writeDatabase(path, cameras, {image: (name, 1) for image, name in NAMES.items()}, keypoints, matches)
    return matches, right


def content(path):
    with open(path, "rb") as file:
        return file.read()


def scoresOf(right):
    return np.where(right, 0.9, 0.1) + np.random.RandomState(1).uniform(-.05, .05, len(right))


@once
@package
class CommandTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = self.file("scene.db")

    def file(self, name):
        return os.path.join(self.folder, name)

    def run_main(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main(list(arguments))
        return code, out.getvalue(), err.getvalue()

    def verify(self, *more):
        return self.run_main("verify", self.path, "--threshold", "2", "--max-iterations", "40", "--threads", "1", *more)

    def configurations(self, path=None):
        with contextlib.closing(sqlite3.connect(path or self.path)) as connection:
            return dict(connection.execute("SELECT pair_id, config FROM two_view_geometries"))

    def found(self, expected):
        self.assertEqual(self.configurations(), {pairId(1, 2): expected, pairId(3, 4): expected})

    def test_whole_run(self):
        collection(self.path, wrong=0.4)
        copy, json = self.file("copy.db"), self.file("report.json")
        before = content(self.path)
        code, out, err = self.run_main("verify", self.path, "--output", copy)
        self.assertEqual((code, err), (0, ""))
        self.assertRegex(out, r"^threshold: [0-9.]+ px.*\n2 pairs in .*: 2 verified, 0 refused\nseconds of all workers: ")
        self.assertEqual(content(self.path), before)
        self.assertEqual(set(self.configurations(copy).values()), {2})
        code, out, err = self.run_main("verify", self.path, "--output", copy)
        self.assertEqual(code, 2)
        self.assertIn(copy, err)
        code, out, err = self.run_main("verify", self.path, "--output", copy, "--resume")
        self.assertEqual((code, err), (0, ""))
        self.assertIn("2 were done before", out)
        code, out, err = self.run_main("report", copy, "--json", json)
        self.assertEqual((code, err, os.path.exists(json)), (0, "", True))
        self.assertIn("CALIBRATED", out)

    def test_scores_of_a_column(self):
        matches, right = collection(self.path)
        self.assertEqual(self.verify()[0], 0)
        self.found(1)
        for dtype, better in ((np.float32, "higher"), (np.float64, "lower")):
            with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
                connection.execute("ALTER TABLE matches ADD COLUMN {}_scores BLOB".format(better))
                for pair, marked in right.items():
                    connection.execute("UPDATE matches SET {}_scores = ? WHERE pair_id = ?".format(better), (
                        scoresOf(marked == (better == "higher")).astype(dtype).tobytes(), pairId(*pair)))
            options = ["--lower-is-better"] if better == "lower" else []
            self.assertEqual(self.verify("--scores-column", better + "_scores", *options)[0], 0)
            self.found(2)
        self.assertEqual(self.verify("--scores-column", "lower_scores")[0], 0)
        self.found(1)

    def test_mistakes_of_a_column(self):
        collection(self.path)
        code, _, err = self.verify("--scores-column", "nothing")
        self.assertEqual(code, 2)
        self.assertIn("nothing", err)
        with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
            connection.execute("ALTER TABLE matches ADD COLUMN scores BLOB")
            connection.execute("UPDATE matches SET scores = ? WHERE pair_id = ?", (b"12345", pairId(1, 2)))
        code, _, err = self.verify("--scores-column", "scores")
        self.assertEqual(code, 1)
        self.assertRegex(err, "day/a.jpg.*day/b.jpg.*column scores has 5 bytes, not 4 or 8 for each of 2500 matches")
        self.assertRegex(err, "night/c.jpg.*d.jpg.*column scores has 0 bytes")

    def test_names_that_are_not_utf_8(self):
        """COLMAP stores the names of files as they are, so names in Latin-1 must be usable: bytes that are
        not UTF-8 become escapes, in the output and in the stored reasons."""
        collection(self.path, wrong=0.4)
        with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
            for image, name in ((1, "\u00e9.jpg"), (3, "\u00e8 1.jpg"), (4, "\u00ea 1.jpg")):
                connection.execute("UPDATE images SET name = CAST(? AS TEXT) WHERE image_id = ?", (name.encode("latin-1"), image))
            connection.execute("UPDATE matches SET rows = 5 WHERE pair_id = ?", (pairId(3, 4),))
        self.assertEqual(self.verify()[::2], (1, "cannot be read: \\xe8 1.jpg - \\xea 1.jpg: 5 rows of 2 numbers do not fit into "
                                                 "20000 bytes of matches\n"))
        self.assertEqual(self.verify("--resume")[0], 1)
        code, out, err = self.run_main("report", self.path, "--json", self.file("a.json"), "--csv", self.file("a.csv"))
        self.assertEqual((code, err), (0, ""))
        # The reason is listed without the names of the images, so that equal reasons are counted together.
        self.assertRegex(out, r"\n +1  N rows of N numbers do not fit into N bytes of matches +"
                              r"for example \\xe8 1.jpg - \\xea 1.jpg\n")
        with open(self.file("a.csv"), encoding="utf-8") as file:
            self.assertRegex(file.read(), r"\n\\xe9.jpg - day/b.jpg,CALIBRATED,")
        with open(self.file("list"), "wb") as file:
            file.write("\u00e9.jpg day/b.jpg\n".encode("latin-1") + b"\\xe8 1.jpg \\xea 1.jpg\n")
        self.assertEqual(self.verify("--pairs", self.file("list"))[0], 1)
        self.assertEqual(self.configurations(), {pairId(1, 2): 2})

    def test_column_of_a_pair_without_matches(self):
        """COLMAP stores a row with 0 matches for a pair without matches. An added column is NULL there
        (or 0 if this is its default). The pair must be refused like others with too few matches."""
        matches, right = collection(self.path)
        with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
            connection.execute("UPDATE matches SET rows = 0, data = NULL WHERE pair_id = ?", (pairId(3, 4),))
            for column, null in (("scores BLOB", "NULL"), ("zeros BLOB DEFAULT 0", "0")):
                connection.execute("ALTER TABLE matches ADD COLUMN " + column)
                connection.execute("UPDATE matches SET {} = ? WHERE pair_id = ?".format(column.split()[0]),
                                   (scoresOf(right[1, 2]).tobytes(), pairId(1, 2)))
        options = [("--scores-column", "scores"), ("--scores-column", "zeros")]
        if h5py is not None:
            options.append(("--scores", self.hloc({(1, 2): matches[1, 2]}, right)))
        for option in options:
            code, _, err = self.verify(*option)
            self.assertEqual((code, err), (0, ""))
            self.assertEqual(self.configurations(), {pairId(1, 2): 2, pairId(3, 4): 1})
            with contextlib.closing(sqlite3.connect(self.path)) as connection:
                found = connection.execute("SELECT reason FROM usacv20_pairs WHERE pair_id = ?", (pairId(3, 4),)).fetchall()
            self.assertEqual(found, [("0 matches, 15 are needed",)])

    def hloc(self, matches, right, joint="/", swapped=False):
        path = self.file("matches.h5")
        with h5py.File(path, "w") as file:
            for pair, rows in matches.items():
                first, second = (NAMES[image].replace("/", "-") for image in (pair[::-1] if swapped else pair))
                a, b = rows.T[::-1] if swapped else rows.T
                partners, scores = np.full(2600, -1, np.int32), np.zeros(2600, np.float16)
                partners[a], scores[a] = b, scoresOf(right[pair])
                group = file.create_group(first + joint + second)
                group["matches0"], group["matching_scores0"] = partners, scores
        return path

    @needsH5py
    def test_scores_of_hloc(self):
        matches, right = collection(self.path)
        for joint, swapped in (("/", False), ("_", False), ("/", True)):
            code, _, err = self.verify("--scores", self.hloc(matches, right, joint, swapped))
            self.assertEqual((code, err), (0, ""))
            self.found(2)

    @needsH5py
    def test_resume_with_scores_of_hloc(self):
        """A file of scores can be moved and can grow between two runs, but the scores must be those of
        the run that is continued."""
        matches, right = collection(self.path)
        path = self.hloc(matches, right)
        self.assertEqual(self.verify("--scores", path)[0], 0)
        os.mkdir(self.file("other"))
        moved = self.file("other/matches.h5")
        os.rename(path, moved)
        with h5py.File(moved, "a") as file:
            file["a new.jpg/day-a.jpg/matches0"] = np.zeros(3, int)
        code, out, err = self.verify("--scores", moved, "--resume")
        self.assertEqual((code, err), (0, ""))
        self.assertIn("2 were done before", out)
        another = self.hloc(matches, {pair: ~marked for pair, marked in right.items()})
        code, out, err = self.verify("--scores", another, "--resume")
        self.assertEqual(code, 2)
        self.assertRegex(err, "the settings are not those of the last run: scores is .*matches.h5.* and was .*matches.h5")
        with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
            (text,), = connection.execute("SELECT settings FROM usacv20_runs WHERE run_id = 1").fetchall()
            old = json.dumps(dict(json.loads(text), scores="matches.h5"), sort_keys=True)  # as earlier versions stored it
            connection.execute("UPDATE usacv20_runs SET settings = ?", (old,))
        self.assertIn("2 were done before", self.verify("--scores", moved, "--resume")[1])

    @needsH5py
    def test_mistakes_of_hloc(self):
        matches, right = collection(self.path)
        path = self.hloc({(1, 2): matches[1, 2]}, right)
        code, _, err = self.verify("--scores", path)
        self.assertEqual(code, 1)
        self.assertRegex(err, "night/c.jpg.*d.jpg.*has no scores of this pair")
        other = {pair: np.c_[rows[:, 0], np.roll(rows[:, 1], 1)] for pair, rows in matches.items()}
        code, _, err = self.verify("--scores", self.hloc(other, right))
        self.assertEqual(code, 1)
        self.assertRegex(err, "has other matches of this pair than the database")
        for number, wrong in enumerate((h5py.Empty("f4"), "text", np.array([b"a"] * 2600), 3)):
            path, member = self.hloc(matches, right), "day-a.jpg/day-b.jpg/" + ("matches0", "matching_scores0")[number % 2]
            with h5py.File(path, "a") as file:
                del file[member]
                file[member] = wrong
            code, _, err = self.verify("--scores", path)
            self.assertEqual(code, 1)
            self.assertRegex(err, "^cannot be read: day/a.jpg - day/b.jpg: .*no arrays of numbers, or damaged\n$")
        for path in (self.file("missing.h5"), self.path):
            code, _, err = self.verify("--scores", path)
            self.assertEqual(code, 2)
            self.assertIn(path, err)

    @needsH5py
    def test_damaged_groups_of_hloc(self):
        """A damaged group, or another object in its place, must make only its own pair unreadable."""
        matches, right = collection(self.path)
        day, night = ("day-a.jpg/day-b.jpg", "day/a.jpg - day/b.jpg"), ("night-c.jpg/d.jpg", "night/c.jpg - d.jpg")
        for name, (pair, images) in (("day-a.jpg", day), (night[0], night)):
            for wrong in (None, 5):
                path = self.hloc(matches, right)
                if wrong is None:
                    with h5py.File(path, "r") as file:
                        place = h5py.h5o.get_info(file[name].id).addr
                    with open(path, "r+b") as file:
                        file.seek(place)
                        file.write(b"\xee" * 40)
                    said = "the group {} is damaged".format(pair)
                else:
                    with h5py.File(path, "a") as file:
                        del file[name]
                        file[name] = wrong
                    said = "has no scores of this pair" if name == "day-a.jpg" else "expected in " + pair
                with contextlib.closing(sqlite3.connect(self.path)) as connection, connection:
                    connection.execute("DELETE FROM two_view_geometries")
                with self.subTest(name=name, wrong=wrong):
                    code, _, err = self.verify("--scores", path)
                    self.assertEqual(code, 1)
                    self.assertRegex(err, "^cannot be read: {}: .*matches.h5:? .*{}.*\n$".format(images, said))
                    self.assertEqual(list(self.configurations().values()), [2])
                    self.assertEqual(self.verify("--scores", path, "--resume")[0], 1)

    def test_mistakes(self):
        collection(self.path)
        for arguments, said in ((["verify", self.file("missing.db")], "there is no such file"),
                                (["verify", __file__], "not a database of sqlite"),
                                (["verify", self.path, "--threshold", "-1"], "threshold"),
                                (["verify", self.path, "--confidence", "2", "--threshold", "2"], "confidence"),
                                (["verify", self.path, "--significance", "0", "--threshold", "2"],
                                 "significance: a number above 0"),
                                (["verify", self.path, "--chunk", "0", "--threshold", "2"], "chunk"),
                                (["verify", self.path, "--threshold", "2", "--lower-is-better"], "--lower-is-better: goes with"),
                                (["verify", self.path, "--scores", self.path, "--lower-is-better"], "--lower-is-better: goes with"),
                                (["pairs", self.folder, "--output", self.file("a.parquet")], "parquet"),
                                (["report", self.file("missing.db")], "missing.db")):
            code, _, err = self.run_main(*arguments)
            self.assertEqual((code, err.count("\n")), (2, 1), err)
            self.assertIn(said, err.lower(), arguments)
        for arguments in (["verify", self.path, "--threshold", "x"], ["verify"], [], ["verify", self.path, "--threads", "-1"],
                          ["verify", self.path, "--workers", "2", "--threads", "2"]):
            with self.assertRaises(SystemExit) as caught:
                self.run_main(*arguments)
            self.assertEqual(caught.exception.code, 2)

    def test_pairs(self):
        for number in range(3):
            scene = Scene(number, wrong=0.4)
            np.savez(self.file("{}.npz".format(number)), points1=scene.pair.first.points, points2=scene.pair.second.points, K=K)
        code, out, err = self.run_main("pairs", self.folder, "--output", self.file("results.npz"), "--threshold", "2")
        self.assertEqual((code, err), (0, ""))
        from usacv20.collection import Configuration, readResults
        found = list(readResults(self.file("results.npz")))
        self.assertEqual([(pair.key, pair.configuration) for pair in found],
                         [(str(number), Configuration.CALIBRATED) for number in range(3)])


if __name__ == "__main__":
    unittest.main()
