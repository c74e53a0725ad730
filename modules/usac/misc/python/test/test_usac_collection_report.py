#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the command `report`: its numbers must equal the numbers that the tests count in the
results. Also tests of its pictures, and of invalid files."""

import collections
import csv
import io
import json
import os
import re
import sqlite3
import sys
import tracemalloc
import unittest
from unittest import mock

import numpy as np

from usac_collection_database import change, pairId, smallDatabase, writeDatabase
from usac_collection_lists import Files
from usac_common import once, package

try:
    from usacv20.collection._database_sink import DatabaseSink
    from usacv20.collection._list_results import openResults
    from usacv20.collection._pair import CollectionError, Configuration, TwoView
    from usacv20.collection._report import report, summarize
    from usacv20.collection._report_graph import graphOf, indexed, matrixOf
    from usacv20.collection._report_table import COLMAP, OURS, PAIRS, VERIFIED, Results, withoutNumbers
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass
try:
    from matplotlib.image import imread
except ImportError:
    imread = None
needsMatplotlib = unittest.skipIf(imread is None, "there is no matplotlib")

IMAGES = 20
KINDS = ("CALIBRATED", "UNCALIBRATED", "PLANAR", "PANORAMIC", "WATERMARK")


def results(links, seed=1, name=pairId):
    """Returns {(first image, second image): TwoView}, made-up results of all pairs of images. A pair
    is accepted if links(first, second) is true. About one in ten of the other pairs cannot be read
    (UNDEFINED); the rest are refused."""
    rng = np.random.RandomState(seed)
    found = {}
    for first in range(1, IMAGES + 1):
        for second in range(first + 1, IMAGES + 1):
            matches, key = int(rng.randint(100, 1000)), name(first, second)
            inliers, configuration, reason = 0, "DEGENERATE", "F: {} inliers, 15 are needed".format(rng.randint(9, 15))
            if links(first, second):
                inliers, configuration, reason = int(rng.randint(15, matches + 1)), KINDS[rng.randint(5)], ""
            elif rng.rand() < 0.1:
                configuration = "UNDEFINED"
                reason = "{}: keypoint {} is not finite".format("{:02d}.jpg - {:02d}.jpg".format(first, second), rng.randint(99))
            elif rng.rand() < 0.5:
                reason = "H: model 1.5e-3 is as good as random ones"
            chance = float(10.0 ** rng.uniform(-30, -4)) if inliers else 1.0
            found[first, second] = TwoView(
                key, Configuration[configuration], np.zeros((inliers, 2), np.uint32), np.eye(3), None, None, None, None, reason,
                matches, int(rng.randint(10, 12000)), chance, float(rng.uniform(0, 30)))
    return found


def neighbors(first, second):
    return second - first <= 3


class Reports(Files):

    def database(self, found, images=IMAGES):
        path = self.path("a.db")
        writeDatabase(path, {1: (0, 640, 480, [500, 320, 240], True)},
                      {i: ("{:02d}.jpg".format(i), 1) for i in range(1, images + 1)}, {},
                      {key: np.zeros((result.matches, 2)) for key, result in found.items()})
        return path

    def verified(self, found, images=IMAGES, **settings):
        path = self.database(found, images)
        sink = DatabaseSink(path, settings)
        sink.commit(list(found.values()))
        sink.close()
        return path

    def text(self, path, **options):
        stream = io.StringIO()
        self.assertEqual(report(path, stream=stream, **options), 0)
        return stream.getvalue()

    def assertMistake(self, pattern, *args, **options):
        with self.assertRaisesRegex(CollectionError, pattern) as caught:
            report(*args, stream=io.StringIO(), **options)
        self.assertNotIn("\n", str(caught.exception))


@once
@package
class FiguresTest(Reports):

    def counted(self, text, title):
        """Returns {label: number of pairs} for the lines below a title of the report."""
        block = text.split("\n" + title, 1)[1].split("\n\n")[0].splitlines()[1:]
        return {m.group(1): int(m.group(2)) for m in (re.match(r"  (\S.*?) +(\d+)  +[\d.]+ %", line) for line in block) if m}

    def check(self, text, found):
        values = list(found.values())
        names = collections.Counter(r.configuration.name for r in values)
        states = {"verified": sum(not r.reason for r in values), "refused": names["DEGENERATE"],
                  "cannot be read": names["UNDEFINED"]}
        self.assertIn(": {} pairs\n".format(len(values)), text)
        for name, count in states.items():
            self.assertRegex(text, r"(?m)^  {} +{}  +{:.1f} %$".format(name, count, 100 * count / len(values)))
        self.assertEqual(self.counted(text, "Configurations"), dict(names))
        good = [r for r in values if not r.reason]
        ratios = sorted(len(r.inliers) / r.matches for r in good)
        expected = collections.Counter(min(int(10 * ratio + 1e-9), 9) for ratio in ratios)
        shown = self.counted(text, "Inlier ratio")
        self.assertEqual({k: v for k, v in shown.items() if v},
                         {"{:g} to {:g}".format(i / 10, (i + 1) / 10): expected[i] for i in expected})
        self.assertIn("Inlier ratio of verified pairs: median {:.3g}, 90 % below {:.3g}, largest {:.3g}\n".format(
            ratios[len(ratios) // 2], ratios[int(0.9 * len(ratios))], ratios[-1]), text)
        return values

    def test_verify(self):
        found = results(neighbors)
        path = self.verified(found)
        before = self.read("a.db")
        text = self.text(path)
        self.assertEqual(self.read("a.db"), before)
        values = self.check(text, found)
        readable = [r for r in values if r.configuration]
        for title, numbers in (("Samples", [r.iterations for r in readable]),
                               ("Milliseconds", [r.milliseconds for r in readable])):
            shown = self.counted(text, title)
            self.assertEqual(sum(shown.values()), len(readable))
            for label, count in shown.items():
                low, high = map(float, label.split(" to "))
                self.assertEqual(count, sum(low <= n < high for n in numbers), label)
        self.assertIn("In total, {} samples and {:.3g} s".format(
            sum(r.iterations for r in values), sum(r.milliseconds for r in values) / 1000), text)
        reasons = collections.Counter(withoutNumbers(r.reason.split(".jpg: ")[-1]) for r in values if r.reason)
        self.assertEqual(len(reasons), 3)
        for reason, count in reasons.items():
            self.assertRegex(text, r"(?m)^ +{}  {}  +for example \d\d.jpg - \d\d.jpg$".format(count, re.escape(reason)))
        self.assertIn("  20 images, 0 of them without a verified pair\n", text)
        self.assertIn("  1 connected components of at least two images; images in the largest components: 20\n", text)
        self.assertIn("  0 verified pairs are the only link", text)
        self.assertNotIn("not looked at", text)
        self.assertNotIn("another program", text)

    def test_json_and_csv(self):
        found = results(neighbors)
        self.text(self.verified(found), jsonFile=self.path("o/a.json"), csvFile=self.path("o/a.csv"))
        summary = json.loads(self.read("o/a.json"))
        self.assertEqual((summary["pairs"], summary["verified"], summary["images"], summary["source"]),
                         (len(found), sum(not r.reason for r in found.values()), IMAGES, OURS))
        self.assertEqual(summary["iterations"], sum(r.iterations for r in found.values()))
        table = list(csv.DictReader(io.StringIO(self.read("o/a.csv").decode())))
        self.assertEqual([row["pair"] for row in table], ["{:02d}.jpg - {:02d}.jpg".format(*key) for key in sorted(found)])
        for row, key in zip(table, sorted(found)):
            r = found[key]
            self.assertEqual((row["configuration"], row["reason"]), (r.configuration.name, r.reason))
            self.assertEqual([float(row[name]) for name in ("matches", "inliers", "iterations", "chance", "milliseconds")],
                             [r.matches, len(r.inliers), r.iterations, r.chance, r.milliseconds])

    def test_pairs(self):
        """Tests reports on a database in the format of the command `pairs`, with and without the names
        of the images."""
        found = results(neighbors, name=lambda a, b: "{:02d}.jpg - {:02d}.jpg".format(a, b))
        np.savez(self.path("l/a.npz"), points1=np.zeros((3, 2)), points2=np.zeros((3, 2)))
        source = self.source(os.path.dirname(self.path("l/")))
        for known in (False, True):
            source.images = lambda key: tuple(key.split(" - ")) if known else None  # noqa: B023
            path = self.path("o{}.sqlite".format(known))
            sink = openResults(path, source, {"significance": 1e-4})
            sink.commit(list(found.values()))
            sink.close()
            text = self.text(path)
            self.check(text, found)
            self.assertEqual("20 images, 0 of them" in text, known)
            with Results(path) as opened:
                self.assertEqual((opened.kind, opened.settings()), (PAIRS, {"significance": 1e-4}))
            if imread is not None:
                self.text(path, pictures=self.path("p{}".format(known)))
                self.assertEqual("pairs.png" in os.listdir(self.path("p{}".format(known))), known)

    def test_colmap(self):
        found = results(neighbors)
        path = self.database(found)
        for (a, b), r in found.items():
            change(path, "INSERT INTO two_view_geometries (pair_id, rows, cols, config) VALUES (?, ?, 2, ?)", pairId(a, b),
                   len(r.inliers), int(r.configuration if len(r.inliers) else Configuration.DEGENERATE))
        plain = {key: r._replace(configuration=r.configuration or Configuration.DEGENERATE) for key, r in found.items()}
        text = self.text(path)
        self.check(text, plain)
        for missing in ("Samples", "Milliseconds", "Reasons", "chance"):
            self.assertNotIn(missing, text)
        with Results(path) as opened:
            self.assertEqual(opened.kind, COLMAP)

    def test_configurations_of_later_versions(self):
        path = self.database(results(neighbors))
        for number, pair in ((8, (1, 2)), (9, (2, 3))):
            change(path, "INSERT INTO two_view_geometries (pair_id, rows, cols, config) VALUES (?, 20, 2, ?)", pairId(*pair), number)
        text = self.text(path)
        self.assertEqual(self.counted(text, "Configurations"), {"MULTIPLE": 1, "CALIBRATED_RIG": 1})

    def test_left_and_changed(self):
        found = results(neighbors)
        path = self.verified(found)
        change(path, "DELETE FROM usacv20_pairs WHERE pair_id = ?", pairId(1, 20))
        self.assertIn("1 more pairs have not been processed yet", self.text(path))
        good = [r for r in found.values() if not r.reason]
        change(path, "UPDATE two_view_geometries SET rows = rows + 1 WHERE pair_id = ?", good[0].key)
        # The other row belongs to the pair that was deleted from usacv20_pairs above.
        self.assertIn("2 rows of two_view_geometries are not of this run", self.text(path))


@once
@package
class LookTest(Reports):

    def kinds(self, found, most=5, images=IMAGES, **settings):
        with Results(self.verified(found, images, **settings)) as opened:
            summary = summarize(opened, most)
        return summary, {kind: [pair["pair"] for pair in summary["look"] if pair["kind"].startswith(kind)]
                         for kind in ("refused", "verified, with a chance", "verified, many", "the only")}

    @staticmethod
    def name(key):
        return "{:02d}.jpg - {:02d}.jpg".format(*key)

    def test_order(self):
        found = results(neighbors)
        for limit in (1e-4, 1e-9):
            _, kinds = self.kinds(found, estimation={"significance": limit})
            refused = sorted((key for key in found if found[key].configuration == Configuration.DEGENERATE),
                             key=lambda key: -found[key].matches)
            self.assertEqual(kinds["refused"], [self.name(key) for key in refused[:5]])
            near = sorted((key for key, r in found.items() if not r.reason and r.chance >= limit / 100),
                          key=lambda key: -found[key].chance)
            self.assertTrue(near)
            self.assertEqual(kinds["verified, with a chance"], [self.name(key) for key in near[:5]])
            few = sorted((key for key, r in found.items() if not r.reason and len(r.inliers) < 0.2 * r.matches),
                         key=lambda key: -len(found[key].inliers))
            self.assertTrue(few)
            self.assertEqual(kinds["verified, many"], [self.name(key) for key in few[:5]])
            self.assertEqual(kinds["the only"], [])
            os.remove(self.path("a.db"))

    def test_bridges(self):
        """The bridges of random graphs must equal the links whose removal, one at a time, increases
        the number of connected components."""
        for seed in range(40):
            rng = np.random.RandomState(seed)
            count = rng.randint(1, 15)
            links = {tuple(sorted(int(n) for n in rng.randint(0, count, 2))) for _ in range(rng.randint(0, 2 * count))}
            plain = sorted(link for link in links if link[0] != link[1])
            graph = graphOf(count, plain)
            found = {tuple(sorted(bridge[:2])): bridge.images for bridge in graph.bridges}
            for i, link in enumerate(plain):
                rest = graphOf(count, plain[:i] + plain[i + 1:])
                self.assertEqual(link in found, len(rest.components) > len(graph.components))
                if link in found:
                    changed = collections.Counter(rest.components) - collections.Counter(graph.components)
                    self.assertEqual(found[link], min(changed.elements()))
            self.assertEqual(sum(graph.components), count)

    def test_only_link(self):
        """Only the pair 3 - 12 connects images 1 to 8 with images 9 to 17, so it must be listed. The
        pairs 16 - 17 and 18 - 19 are also bridges, but each connects only a single image, so they
        must not be listed. Image 20 has no verified pair."""
        def links(a, b):
            return b <= 8 or (9 <= a and b <= 16) or (a, b) in ((3, 12), (16, 17), (18, 19))
        summary, kinds = self.kinds(results(links))
        self.assertEqual(kinds["the only"], ["03.jpg - 12.jpg"])
        self.assertEqual(summary["look"][-1]["images"], 8)
        self.assertEqual(summary["components"], {"all": 3, "largest": [17, 2, 1], "single": 1})
        self.assertEqual(summary["bridges"], 3)
        self.assertIn("smaller part: 8 images", self.text(self.path("a.db")))


@once
@package
@needsMatplotlib
class PicturesTest(Reports):

    def test_files(self):
        found = results(neighbors)
        self.text(self.verified(found), pictures=self.path("p/q"))
        names = ["inlierRatio.png", "iterations.png", "milliseconds.png", "pairs.png"]
        self.assertEqual(sorted(os.listdir(self.path("p/q"))), names)
        for name in names:
            pixels = imread(self.path("p/q/" + name))
            self.assertGreater(min(pixels.shape[:2]), 400)
            self.assertGreater(pixels[..., :3].std(), 0.05)

    def test_matrix(self):
        """The rows of the matrix must be in the order of the image names, which need not be UTF-8, no
        matter which numbers the images have."""
        found = results(neighbors)
        path = self.verified(found)
        change(path, "UPDATE images SET name = CAST(CAST('x' || (100 - image_id) AS BLOB) || X'E9' AS TEXT)")
        self.assertIn(r"\xe9", self.text(path, pictures=self.path("p")))
        with Results(path) as opened:
            images = opened.images()
            names, ranks = opened.names(images)
            whole = matrixOf(len(images), indexed(images, opened.links()), VERIFIED, 100)
            binned = matrixOf(len(images), indexed(images, opened.links()), VERIFIED, 7)
        self.assertEqual((names, ranks.tolist()), (sorted(names), list(range(IMAGES))[::-1]))
        expected = np.full((IMAGES, IMAGES), -2)
        for (a, b), r in found.items():
            expected[a - 1, b - 1] = expected[b - 1, a - 1] = -1 if r.reason else len(r.inliers)
        np.testing.assert_array_equal(whole, expected)
        groups = np.arange(IMAGES) * 7 // IMAGES
        np.testing.assert_array_equal(binned, [[expected[np.ix_(groups == i, groups == j)].max() for j in range(7)] for i in range(7)])

    def test_a_file_in_place_of_the_folder(self):
        path = self.verified(results(neighbors))
        for folder in (self.write("file", "text"), os.path.join(self.path("file"), "p")):
            self.assertMistake("--pictures {}: this folder cannot be created".format(re.escape(folder)), path, pictures=folder)
        self.assertEqual(self.read("file"), b"text")

    def test_without_matplotlib(self):
        path = self.verified(results(neighbors))
        names = [name for name in sys.modules if name.startswith("matplotlib")] + ["matplotlib", "matplotlib.figure"]
        modules = {name: None for name in names}
        with mock.patch.dict(sys.modules, modules):
            self.assertMistake("matplotlib is needed for --pictures .*python3-matplotlib", path, pictures=self.path("p"))
            self.text(path)


@once
@package
class MistakesTest(Reports):

    def test_files(self):
        self.assertMistake("no such file", self.path("none.db"))
        self.assertMistake("not a database", self.write("text.db", "text " * 100))
        np.savez(self.path("a.npz"), a=[1])
        self.assertMistake("not in NPZ or HDF5", self.path("a.npz"))
        smallDatabase(self.path("a.db"))
        self.assertMistake("no pair has been verified", self.path("a.db"))
        change(self.path("a.db"), "DROP TABLE two_view_geometries")
        self.assertMistake("no pair has been verified", self.path("a.db"))
        os.remove(self.path("a.db"))
        sqlite3.connect(self.path("empty.db")).close()
        self.assertMistake("empty.db: neither|empty", self.path("empty.db"))
        path = self.verified(results(neighbors))
        for option in ("jsonFile", "csvFile"):
            self.assertMistake("No such file or directory", path, **{option: os.path.join(self.folder, "none", "x")})

    def test_truncated(self):
        self.verified(results(neighbors))
        self.write("b.db", self.read("a.db")[:20000])
        self.assertMistake("damaged", self.path("b.db"))

    def test_memory(self):
        """The memory needed to compute the report must not grow with the number of pairs."""
        peaks = []
        self.text(self.verified(results(neighbors)))  # loads modules before the memory is measured
        for repeats in (10, 60):
            change(self.path("a.db"), "DELETE FROM usacv20_pairs")
            change(self.path("a.db"), """WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < ?)
INSERT INTO usacv20_pairs (pair_id, run_id, configuration, reason, matches, inliers, iterations, chance,
milliseconds) SELECT {} + i, 1, 2, '', 100, 50, i, 0, i / 100.0 FROM n""".format(pairId(1, 1)), 1000 * repeats)
            tracemalloc.start()
            with Results(self.path("a.db")) as opened:
                self.assertEqual(summarize(opened)["verified"], 1000 * repeats)
            peaks.append(tracemalloc.get_traced_memory()[1])
            tracemalloc.stop()
        self.assertLess(peaks[1], 1.1 * peaks[0] + 100000)


if __name__ == "__main__":
    unittest.main()
