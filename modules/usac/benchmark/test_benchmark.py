#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of pairs.py (pairs and lists), plot.py (pictures) and compare.py (comparisons pair by pair) on
tiny files that the tests write, and helpers for the other tests in this folder.

The environment variable USAC_BENCHMARK is the path of the C++ program usac_benchmark. If it is set, a
test checks that the program reads the files that pairs.py writes. Tests of plot.py are skipped if
matplotlib is missing."""

import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import compare
import pairs

try:
    import plot
except ImportError:
    plot = None

K = np.array([[700.0, 0, 320], [0, 690, 240], [0, 0, 1]])
SIZE = (640, 480)


def rotation(axis, degrees):
    """Returns a rotation matrix, computed with Rodrigues' formula."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


# Two views of random points. Rotations map world to camera; all points are in front of both
# cameras.
R1, R2 = rotation((1, 2, 0.5), 10), rotation((-0.3, 1, 0.2), -12)
C1, C2 = np.array([0.1, -0.2, 0.3]), np.array([1.2, 0.1, -0.2])
POINTS = np.random.RandomState(1).uniform((-2, -1.5, 5), (2, 1.5, 9), (40, 3))


def project(R, center, matrix=K):
    x = (POINTS - center) @ R.T @ matrix.T
    return x[:, :2] / x[:, 2:]


def text(*rows):
    return "".join(" ".join("%.17g" % v for v in np.ravel(row)) + "\n" for row in rows)


class FolderTest(unittest.TestCase):
    """Base class of tests that need a temporary folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def put(self, name, contents=""):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w") as out:
            out.write(contents)
        return self.path(name)


class PairsTest(FolderTest):

    def pair(self, **changes):
        x1, x2 = project(R1, C1), project(R2, C2)
        R = R2 @ R1.T
        values = dict(problems=["E", "F"], points1=x1, points2=x2, scores=np.linspace(0.1, 0.9, len(x1)), size1=SIZE,
                      size2=SIZE, gt_points=np.hstack((x1, x2))[:10], gt_kind="pose", K1=K, K2=K, R=R, t=R2 @ (C1 - C2),
                      extra={"gt_thresh_px": 1.0})
        values.update(changes)
        return pairs.Pair(**values)

    def test_round_trip(self):
        pair, path = self.pair(), self.path("pairs", "set", "a")
        pairs.write_pair(path, pair)
        again = pairs.read_pair(path)
        for name, tolerance in (("points1", 6e-4), ("points2", 6e-4), ("scores", 6e-5), ("gt_points", 6e-4), ("R", 0),
                                ("t", 0), ("K1", 0), ("K2", 0), ("size1", 0), ("size2", 0)):
            np.testing.assert_allclose(getattr(again, name), getattr(pair, name), rtol=0, atol=tolerance, err_msg=name)
        self.assertEqual((again.problems, again.gt_kind, again.H, again.extra),
                         (["E", "F"], "pose", None, {"gt_thresh_px": 1.0}))

    def test_nonsense_is_not_written(self):
        zeros = np.zeros((3, 3))
        for changes, complaint in (({"problems": ["X"]}, "problem"), ({"scores": [1, 2]}, "differ in number"),
                                   ({"gt_kind": "guess"}, "gt_kind"), ({"gt_points": []}, "gt_points"),
                                   ({"K1": None}, "K1, K2"), ({"R": 2 * np.eye(3)}, "no rotation"), ({"t": zeros[0]}, "t: zero"),
                                   ({"t": None}, "come together"), ({"gt_kind": "homography"}, "H: needed"),
                                   ({"K2": zeros}, "K2: singular"), ({"size1": (0, 5)}, "size1"),
                                   ({"scores": np.full(40, np.nan)}, "scores: not finite")):
            with self.assertRaisesRegex(pairs.PairError, complaint):
                pairs.write_pair(self.path("bad"), self.pair(**changes))
        with self.assertRaisesRegex(pairs.PairError, "K1: expected 3 x 3 numbers"):
            self.pair(K1=[1, 2])
        self.assertEqual(os.listdir(self.folder), [])

    def test_messages_name_file_and_line(self):
        path = self.path("a")
        pairs.write_pair(path, self.pair())
        self.put("a.corr", "1 2 3 4 0.5\n\n1 2 three 4\n")
        with self.assertRaisesRegex(pairs.PairError, r"a\.corr:3: expected 'x1 y1 x2 y2 score'"):
            pairs.read_pair(path)
        self.put("a.corr", "1 2 3 4\n5 6 7 8 0.5\n")
        self.assertEqual(pairs.read_pair(path).scores.tolist(), [1, 0.5])
        self.put("a.json", '{"problem": ["E"],\n"size1" 5}')
        with self.assertRaisesRegex(pairs.PairError, r"a\.json:2: "):
            pairs.read_pair(path)
        self.put("a.json", '{"problem": "H", "size1": [6, 4], "size2": [6, 4], "gt_kind": "annotated", "gt_points": []}')
        with self.assertRaisesRegex(pairs.PairError, r"a\.json: gt_points: none"):
            pairs.read_pair(path)

    def test_lists(self):
        file = pairs.list_file(self.folder, "set", "F")
        paths = [self.path("pairs", "set", name) for name in "ab"]
        pairs.write_list(file, paths)
        with open(file) as lines:
            self.assertEqual(lines.read(), "pairs/set/a\npairs/set/b\n")
        with open(file, "a") as lines:
            lines.write("\n# not this\n  pairs/set/c \n")
        self.assertEqual([os.path.realpath(p) for p in pairs.read_list(file)],
                         [os.path.realpath(p) for p in paths + [self.path("pairs", "set", "c")]])
        self.assertEqual(pairs.split_name(file), ("set", "F"))
        with self.assertRaisesRegex(pairs.PairError, "expected a name"):
            pairs.read_list(self.put("lists/set.list"))

    @unittest.skipUnless(os.environ.get("USAC_BENCHMARK"), "USAC_BENCHMARK names no program")
    def test_program_reads_what_is_written(self):
        pairs.write_pair(self.path("pairs", "set", "a"), self.pair())
        for problem in "FE":
            pairs.write_list(pairs.list_file(self.folder, "set", problem), [self.path("pairs", "set", "a")])
        for options in ([], ["--cold=1"]):
            runs = self.path("runs.csv")
            done = subprocess.run([os.environ["USAC_BENCHMARK"], "--data=" + self.folder, "--repeats=1", "--runs=" + runs,
                                   "--methods=USACV20", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            with open(runs) as lines:
                rows = [line.rstrip("\n").split(",") for line in lines]
            self.assertEqual([row[:4] for row in rows[1:]], [['"set"', p, '"a"', "40"] for p in "FE"])
            for row in rows[1:]:
                self.assertLess(float(row[6]), 0.1)  # pixels; the points of the file are rounded to a thousandth of a pixel
                self.assertLess(float(row[8]), 0.5)


@unittest.skipUnless(plot, "matplotlib is missing")
class PlotTest(FolderTest):

    def runs(self):
        rows = ["list,problem,pair,correspondences,method,repeat,error,failed,pose_error,cpu_ms,wall_ms,iterations,inliers"]
        noise = np.random.RandomState(3)
        for problem in "HE":
            for pair in range(4):
                for repeat in range(3):
                    for i, method in enumerate(("USACV20", "cv:RANSAC", "USACV20{sampler=1,localIterations=3}")):
                        failed = pair == 0 and i == 1
                        rows.append('"set",%s,"p%d",100,"%s",%d,%s,%d,,%g,%g,5,9' % (
                            problem, pair, method, repeat, "inf" if failed else noise.uniform(0.2, 3), failed,
                            2.0 + 10 * pair + i, 3.0 + pair))
        return self.put("runs.csv", "\n".join(rows) + "\n")

    def test_reads_runs(self):
        results = plot.read_runs([self.runs()], "cpu", [])
        self.assertEqual(list(results), [("set", "H"), ("set", "E")])
        runs = results["set", "H"]
        self.assertEqual(list(runs), ["USACV20", "cv:RANSAC", "USACV20{sampler=1,localIterations=3}"])
        self.assertEqual([r.failures() for r in runs.values()], [0, 0.25, 0])
        self.assertEqual(runs["USACV20"].median_time(), 17)
        self.assertEqual(plot.read_runs([self.runs()], "wall", ["cv:RANSAC"])["set", "E"]["cv:RANSAC"].median_time(), 4.5)

    def test_curves_end_at_the_share_of_successes(self):
        x, y = plot.cumulative([3, np.inf, 1, 2])
        self.assertEqual((x.tolist(), y.tolist()), ([1, 2, 3], [0.25, 0.5, 0.75]))
        x, y = plot.cumulative([2, 1], [0.8, 0.2])
        self.assertEqual((x.tolist(), y.tolist()), ([1, 2], [0.2, 1]))

    def test_pictures(self):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(plot.main([self.runs(), "--out", self.path("out")]), 0)
        names = ["set.H", "set.E", "accuracy_over_time", "summary"]
        self.assertEqual(out.getvalue().split(), [self.path("out", name + ".png") for name in names])
        for name in names:
            with open(self.path("out", name + ".png"), "rb") as picture:
                self.assertTrue(picture.read().startswith(b"\x89PNG"), name)

    def test_errors_of_poses_are_angles(self):
        with open(self.runs()) as lines:
            rows = lines.read()
        self.put("runs.csv", rows.replace('"set",E', '"set",P'))
        results = plot.read_runs([self.path("runs.csv")], "cpu", [])
        self.assertEqual(list(results), [("set", "H"), ("set", "P")])
        look = plot.Look(results)
        angle, pixels = "error of the rotation, degrees", "error, pixels"
        for problem, label in (("H", pixels), ("P", angle)):
            figure = plot.draw_list("set", problem, results["set", problem], look, "cpu")
            self.assertEqual(figure.axes[0].get_xlabel(), label)
        self.assertEqual([axes.get_ylabel() for axes in plot.draw_scatter(results, look, "cpu").axes],
                         ["median " + pixels, "median " + angle])
        self.assertEqual([axes.get_xlabel() for axes in plot.draw_summary(results, look, "cpu").axes[:2]], [pixels, angle])
        plot.plt.close("all")

    def test_same_runs_make_the_same_picture(self):
        results = plot.read_runs([self.runs()], "cpu", [])
        pictures = []
        for name in "ab":
            with plot.plt.rc_context(plot.STYLE):
                figure = plot.draw_list("set", "H", results["set", "H"], plot.Look(results), "cpu")
                with open(plot.save(figure, self.folder, name, "svg")) as picture:
                    pictures.append(picture.read())
        self.assertIn("<svg", pictures[0])
        self.assertEqual(pictures[0], pictures[1])

    def test_mistakes(self):
        file = self.runs()
        for contents, complaint in (("list,problem\n", "runs.csv:1: no column pair"),
                                    (None, "runs.csv:74: not a line of usac_benchmark --runs")):
            if contents is None:
                self.runs()
                with open(file, "a") as out:
                    out.write('"set",H,"p",100\n')
            else:
                self.put("runs.csv", contents)
            with contextlib.redirect_stderr(io.StringIO()) as err:
                self.assertEqual(plot.main([file, "--out", self.path("none")]), 1)
            self.assertIn(complaint, err.getvalue())
        self.assertFalse(os.path.exists(self.path("none")))


class CompareTest(FolderTest):

    HEAD = "list,problem,pair,correspondences,method,repeat,error,failed,pose_error,cpu_ms,wall_ms,iterations,inliers,cost\n"

    def runs(self, *pairs):
        """Writes a file of runs of two methods, a and b, with one run of each method on each pair.
        Each of `pairs` is (error of a, cost of a, error of b, cost of b)."""
        rows = []
        for i, (error_a, cost_a, error_b, cost_b) in enumerate(pairs):
            for method, error, cost in (("a", error_a, cost_a), ("b", error_b, cost_b)):
                rows.append('"set",H,"p%d",9,"%s",0,%s,%d,,1,1,,5,%s' % (i, method, error, error == "inf", cost))
        return self.put("runs.csv", self.HEAD + "\n".join(rows) + "\n")

    def comparison(self, *pairs):
        results = compare.read_pairs([self.runs(*pairs)])
        self.assertEqual(list(results), [("H", "set")])
        return compare.Comparison(results["H", "set"], "a", "b")

    def test_ratios(self):
        c = self.comparison((1, 0.5, 2, 0.5), (4, 0.2, 2, 0.3), (4, 0.3, 2, 0.2), (1, 0.3, 1.01, 0.3))
        self.assertAlmostEqual(c.ratio(), (2 / 1.01) ** 0.25)
        self.assertEqual((c.pairs, c.better, c.worse, c.cheaper), (4, 1, 2, 1))
        low, high = c.interval()
        self.assertTrue(0.5 <= low < c.ratio() < high <= 2, (low, high))
        self.assertEqual((low, high), c.interval())

    def test_failures_count_but_have_no_ratio(self):
        c = self.comparison(("inf", 1, 2, 0.5), (1, 0.5, "inf", 0.6), ("inf", 0.4, "inf", 0.6), (1, 0.5, 2, 0.6))
        self.assertEqual((c.pairs, c.better, c.worse, c.cheaper), (4, 2, 1, 0))
        self.assertAlmostEqual(c.ratio(), 0.5)
        self.assertTrue(all(np.isnan(x) for x in c.interval()))

    def test_interval_holds_the_truth(self):
        noise = np.random.RandomState(5)
        held = 0
        for _ in range(60):
            c = self.comparison(*[(np.exp(noise.normal(0.3, 0.4)), 0, 1, 0) for _ in range(25)])
            low, high = c.interval(400)
            held += low < np.exp(0.3) < high
        self.assertGreaterEqual(held, 50)

    def test_table(self):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(compare.main([self.runs((1, 0.5, 2, 0.5), (2, 0.5, 4, 0.5)), "--method=a"]), 0)
        self.assertIn("| H set | 2 | 0.50 (0.50 .. 0.50), 2 : 0, 0 |\n", out.getvalue())

    def test_mistakes(self):
        old = self.put("old.csv", self.HEAD.replace(",cost", "") + "set,H,p,9,a,0,1,0,,1,1,,5\n")
        for arguments, complaint in (([self.path("none")], "none"), ([old], "no column cost"), ([self.runs((1, 1, 1, 1))], "USACV20"),
                                     ([self.runs((1, 1, 1, 1)), "--method=a", "--other=c"], "no runs of c")):
            with contextlib.redirect_stderr(io.StringIO()) as err:
                self.assertEqual(compare.main(arguments), 1)
            self.assertIn(complaint, err.getvalue())


if __name__ == "__main__":
    unittest.main()
