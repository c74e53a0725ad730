#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the collection tool on a synthetic collection of images: the tool's results for the
pairs, and the reconstruction that COLMAP makes from the tool's table two_view_geometries."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from typing import Dict, List, Tuple

import numpy as np

import usac_colmap
from usac_collection import MODELS, Collection, Kind, Recipe
from usac_common import once, package

PROGRAM = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "benchmark", "collection",
                                        "compare_colmap.py"))
DEGENERATE, CALIBRATED, UNCALIBRATED, PLANAR, PANORAMIC, PLANAR_OR_PANORAMIC, WATERMARK = range(1, 8)
KNOWN = Recipe(images=20, lonePairs=0.15)
UNKNOWN = KNOWN._replace(cameras=(("SIMPLE_RADIAL", False),))
# Pairs of Kind.GENERAL with at least this fraction of the right matches in one plane can reasonably
# be classified as planar, so their configuration is not tested.
CLEAR = 0.7


def verify(database: str, threshold: str = "4") -> None:
    """Runs the tool's command verify on a database. threshold -- pixels, by default COLMAP's value, or
    "auto"."""
    usac_colmap.runProgram([sys.executable, "-m", "usacv20.collection", "verify", "--threads", "1", "--threshold", threshold,
                            "--no-progress", database])


class Case(unittest.TestCase):

    folder = ""

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    def write(self, collection: Collection, name: str) -> str:
        path = os.path.join(self.folder, name + ".db")
        collection.write(path)
        return path


class Found:
    """The results of a verified database, together with the ground truth of its collection."""

    def __init__(self, collection: Collection, database: str) -> None:
        self.collection = collection
        self.table = usac_colmap.verified(database)

    def configurations(self, kind: Kind) -> List[int]:
        """Returns the configurations that were found for the pairs whose true kind is `kind`. General
        pairs that can also be classified as planar (see CLEAR) are left out."""
        return [self.table[pair.pairId].configuration for pair in self.collection.pairs if pair.kind is kind
                and (kind is not Kind.GENERAL or pair.flatShare < CLEAR)]

    def share(self, kind: Kind, configuration: int) -> float:
        return float(np.mean(np.array(self.configurations(kind)) == configuration))

    def inliers(self) -> Tuple[float, float]:
        """Returns two fractions over all pairs with overlap: the fraction of the right matches that are
        inliers, and the fraction of the inliers that are wrong matches."""
        right = found = both = 0
        for pair in self.collection.pairs:
            if pair.kind in (Kind.GENERAL, Kind.PLANAR, Kind.ROTATION):
                truth = {tuple(row) for row in pair.matches[pair.right].tolist()}
                rows = {tuple(row) for row in self.table[pair.pairId].inliers.tolist()}
                right, found, both = right + len(truth), found + len(rows), both + len(truth & rows)
        return both / right, 1 - both / found


@once
@package
class VerifyTest(Case):

    def found(self, recipe: Recipe, threshold: str = "4") -> Found:
        collection = Collection(recipe)
        path = self.write(collection, self.id())
        verify(path, threshold)
        found = Found(collection, path)
        os.remove(path)
        return found

    def test_known_focal_lengths(self) -> None:
        self.check(self.found(KNOWN), 0.98)

    def test_threshold_of_the_collection(self) -> None:
        """The noise is 1.5 pixels, and the threshold is estimated from the matches ("auto"). Such a
        threshold excludes about 5 % of the right matches at any noise level, so the fraction of
        them that must be found is smaller than in other tests."""
        self.check(self.found(KNOWN._replace(noise=1.5), "auto"), 0.92)

    def check(self, found: Found, least: float) -> None:
        self.assertGreaterEqual(found.share(Kind.GENERAL, CALIBRATED), 0.95)
        self.assertEqual(set(found.configurations(Kind.PLANAR)), {PLANAR})
        self.assertEqual(set(found.configurations(Kind.ROTATION)), {PANORAMIC})
        self.assertEqual(found.configurations(Kind.WATERMARK), [WATERMARK])
        self.assertEqual(set(found.configurations(Kind.NONE)), {DEGENERATE})
        complete, wrong = found.inliers()
        self.assertGreater(complete, least)
        self.assertLess(wrong, 0.08)

    def test_unknown_focal_lengths(self) -> None:
        found = self.found(UNKNOWN)
        self.assertGreaterEqual(found.share(Kind.GENERAL, UNCALIBRATED), 0.95)
        for kind in (Kind.PLANAR, Kind.ROTATION):
            self.assertEqual(set(found.configurations(kind)), {PLANAR_OR_PANORAMIC})
        self.assertEqual(found.configurations(Kind.WATERMARK), [WATERMARK])
        self.assertEqual(set(found.configurations(Kind.NONE)), {DEGENERATE})
        complete, wrong = found.inliers()
        self.assertGreater(complete, 0.95)
        self.assertLess(wrong, 0.11)

    def test_camera_models(self) -> None:
        for model in MODELS:
            with self.subTest(model=model):
                columns = 2 if model == "PINHOLE" else 4
                found = self.found(Recipe(images=12, lonePairs=0, cameras=((model, True),), columns=columns))
                self.assertGreaterEqual(found.share(Kind.GENERAL, CALIBRATED), 0.9)
                self.assertGreater(found.inliers()[0], 0.97)


@once
@package
@unittest.skipUnless(usac_colmap.find(), "there is no program colmap")
class MapperTest(Case):
    """Tests the reconstruction that COLMAP makes from the tool's table two_view_geometries, mostly by
    comparison with the reconstruction from COLMAP's own table for the same matches."""

    def mapped(self, database: str, collection: Collection) -> Dict[str, float]:
        model, _ = usac_colmap.mapper(database)
        truth = {name: (R, t) for name, R, t in zip(collection.names, collection.rotations, collection.translations)}
        errors = usac_colmap.relativeErrors(model.poses, truth)
        return dict(registered=len(model.poses), reprojection=model.reprojectionError, median=float(np.median(errors)),
                    auc1=usac_colmap.areaUnderCurve(errors, 1))

    def test_as_good_as_colmap(self) -> None:
        collection = Collection(KNOWN)
        ours, theirs = self.write(collection, "ours"), self.write(collection, "theirs")
        verify(ours)
        usac_colmap.verifyByColmap(theirs)
        a, b = self.mapped(ours, collection), self.mapped(theirs, collection)
        print("ours: {}\nCOLMAP: {}".format(a, b))
        self.assertEqual(a["registered"], KNOWN.images)
        self.assertGreaterEqual(a["registered"], b["registered"])
        self.assertLess(a["reprojection"], max(b["reprojection"], KNOWN.noise) + 0.05)
        self.assertLess(a["median"], b["median"] + 0.02)
        self.assertGreater(a["auc1"], b["auc1"] - 0.02)
        self.assertGreater(a["auc1"], 0.92)
        verdicts = [Found(collection, path).share(Kind.GENERAL, CALIBRATED) for path in (ours, theirs)]
        self.assertGreaterEqual(verdicts[0], verdicts[1])

    def test_unknown_focal_lengths(self) -> None:
        collection = Collection(UNKNOWN)
        path = self.write(collection, "unknown")
        verify(path)
        found = self.mapped(path, collection)
        print("unknown focal lengths: {}".format(found))
        self.assertEqual(found["registered"], UNKNOWN.images)
        self.assertLess(found["reprojection"], UNKNOWN.noise + 0.15)
        self.assertGreater(found["auc1"], 0.85)


@once
@package
@unittest.skipUnless(os.path.exists(PROGRAM), "the programs of the benchmark are not here")
class CompareTest(Case):
    """Tests of compare_colmap.py, the benchmark program that compares COLMAP's verification of image
    pairs with that of the collection tool."""

    def compare(self, *arguments: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run([sys.executable, PROGRAM, os.path.join(self.folder, "work"), *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)

    @unittest.skipUnless(usac_colmap.find(), "there is no program colmap")
    def test_table(self) -> None:
        collection = Collection(Recipe(images=20, lonePairs=0, wrong=(0.3, 0.5), cameras=(("SIMPLE_PINHOLE", True),)))
        # In cameras.json the center of the first pixel is at (0, 0), in COLMAP at (0.5, 0.5).
        half = np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
        cameras = {name: dict(K=(collection.lens(i).split()[0] - half).tolist(), R=collection.rotations[i].tolist(),
                              t=collection.translations[i].tolist()) for i, name in enumerate(collection.names)}
        folder = tempfile.mkdtemp(dir=self.folder)
        paths = [os.path.join(folder, name) for name in ("matches.db", "cameras.json")]
        collection.write(paths[0])
        with open(paths[1], "w") as file:
            json.dump(cameras, file)
        run = self.compare("--database", paths[0], "--cameras", paths[1], "--focal", "known", "--repeats", "1", "--seeds", "1",
                           "--pairs")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        for name in ("COLMAP", "USACV20 4"):
            row = self.numbers(run.stdout, name)
            cpu, pairs, registered, reprojection, auc = row[0], row[3], row[4], row[5], row[6:9]
            self.assertGreater(cpu, 0.05)
            self.assertGreater(pairs, 30)
            self.assertEqual(registered, 20)
            self.assertTrue(0.2 < reprojection < 0.8, row)
            self.assertTrue(0.8 < auc[0] < auc[1] < auc[2] <= 1, row)
        self.assertIn("pairs with other configurations", run.stdout)

    def numbers(self, text: str, name: str) -> List[float]:
        line, = (line for line in text.splitlines() if line.startswith(name))
        return [float(word) for word in line[len(name):].split()]

    def test_mistakes(self) -> None:
        nothing = os.path.join(self.folder, "nothing")
        for arguments, word in (((), "--images or --database"), (("--database", nothing, "--focal", "known"), "--cameras"),
                                (("--database", nothing, "--cameras", nothing), "nothing"),
                                (("--database", nothing, "--focal", "given"), "nothing")):
            run = self.compare(*arguments)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn(word, run.stderr)
            self.assertNotIn("Traceback", run.stderr)


if __name__ == "__main__":
    unittest.main()
