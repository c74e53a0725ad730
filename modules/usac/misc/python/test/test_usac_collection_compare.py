#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of compare_colmap.py, the benchmark program that compares COLMAP's verification of image
pairs with that of the collection tool, on a small synthetic collection."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from typing import List

import numpy as np

import usac_colmap
from usac_collection import Collection, Recipe
from usac_common import once, package

FOLDER = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.normpath(os.path.join(FOLDER, "..", "..", "..", "benchmark", "collection", "compare_colmap.py"))


@once
@package
@unittest.skipUnless(os.path.exists(PROGRAM), "the programs of the benchmark are not here")
class CompareTest(unittest.TestCase):

    folder = ""

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)

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
