#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of scale.py, of its plots (plot_scale.py), and of threshold.py, which measures the sensitivity of
errors to the threshold.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_synthetic is
taken from the same folder. Tests that need matplotlib are skipped if it is missing."""

import contextlib
import io
import math
import os
import sys
import unittest

import scale
from test_benchmark import FolderTest
import threshold

try:
    import plot_scale
except ImportError:
    plot_scale = None

BENCHMARK = os.environ.get("USAC_BENCHMARK", "")
HEAD = "sweep,problem,size,inliers,method,runs,median_cpu_ms,median_wall_ms,median_error,failures_percent,median_iterations\n"

# A program that replaces usac_benchmark in the tests of threshold.py. The errors that it writes are
# known functions of threshold, method and list, so the expected tables can be computed by hand.
PROGRAM = """#!%s
import sys
options = dict(a.lstrip("-").split("=", 1) for a in sys.argv[1:])
lists = [a.split("=", 1)[1] for a in sys.argv[1:] if a.startswith("--list=")]
with open(options["csv"], "w") as out:
    out.write("list,problem,pairs,method,median_error,failures_percent,mean_cpu_ms,auc10\\n")
    for file in lists:
        name, problem = file.split("/")[-1].split(".")[:2]
        factor = float(options["threshold"]) / {"H": 2, "F": 1, "S": 3, "P": 4}[problem]
        for power, method in enumerate(options["methods"].split(",")):
            fails = power and name == "hard" and factor > 2
            error = 0.5 * max(factor, 1 / factor) if method == "USACV20" else "inf" if fails else 0.5 * factor ** power
            auto = method == "USACV20_AUTO"
            out.write('"%%s",%%s,3,"%%s",%%s,%%s,%%s,%%s\\n' %% (
                name, problem, method, 0.6 if auto and name == "hard" else error, 1.5, 3 if auto else 2, 90 if problem == "F" else ""))
    out.write('"average",,3,"a",1\\n"average.H",H,3,"a",1\\n')
"""


@unittest.skipUnless(plot_scale, "matplotlib is missing")
class ScaleTest(FolderTest):

    def table(self):
        rows = [HEAD]
        for problem in "HE":
            for i, method in enumerate(("USACV20", "cv:USAC_FAST")):
                rows += ['size,%s,%d,0.5,"%s",9,%g,%g,0.3,0,50\n' % (problem, n, method, n * 1e-3 * (i + 1), n * 2e-3)
                         for n in (50, 500, 5000)]
                rows += ['inliers,%s,2000,%g,"%s",9,%g,%g,%s,%g,\n' % (problem, p, method, 1 / p, 2 / p, "inf" if p < 0.3 else 0.4,
                                                                     60 if p < 0.6 else 0) for p in (0.9, 0.5, 0.2)]
        return self.put("scale.csv", "".join(rows))

    def test_reads_and_selects(self):
        results = plot_scale.read_scale(self.table())
        self.assertEqual(list(results), [("size", "H"), ("inliers", "H"), ("size", "E"), ("inliers", "E")])
        self.assertEqual([p["median_cpu_ms"] for p in results["size", "H"]["cv:USAC_FAST"]], [0.1, 1, 10])
        results = plot_scale.read_scale(self.table(), ["cv:USAC_FAST", "USACV20"])
        self.assertEqual(list(results["inliers", "E"]), ["cv:USAC_FAST", "USACV20"])

    def test_failures_are_crosses(self):
        points = plot_scale.read_scale(self.table())["inliers", "H"]["USACV20"]
        curve, failed = plot_scale.split_failed(points, "inliers", "median_error")
        self.assertEqual((curve, failed), ([(0.9, 0.4), (0.5, 0.4)], [(0.5, 0.4)]))
        curve, failed = plot_scale.split_failed(points, "inliers", "median_cpu_ms")
        self.assertEqual(([x for x, _ in curve], [x for x, _ in failed]), ([0.9, 0.5, 0.2], [0.5, 0.2]))

    def test_pictures(self):
        table = self.table()
        for name in "ab":
            with contextlib.redirect_stdout(io.StringIO()) as out:
                self.assertEqual(plot_scale.main([table, "--out", self.path(name), "--format", "svg"]), 0)
            self.assertEqual(out.getvalue().split(), [self.path(name, "scale_%s.svg" % what) for what in ("time", "error")])
        for what in ("time", "error"):
            pictures = []
            for name in "ab":
                with open(self.path(name, "scale_%s.svg" % what)) as picture:
                    pictures.append(picture.read())
            self.assertIn("<svg", pictures[0])
            self.assertEqual(pictures[0], pictures[1])

    def test_mistakes(self):
        for contents, arguments, complaint in (
                ("sweep,problem\n", [], "scale.csv:1: no column size"),
                (HEAD + 'size,H,many,0.5,"a",9,1,1,1,0,5\n', [], "scale.csv:2: not a line"),
                (HEAD + 'depth,H,50,0.5,"a",9,1,1,1,0,5\n', [], "scale.csv:2: not a line"),
                (HEAD, [], "scale.csv: no results"), (None, ["--method=c"], "no results of the methods asked for")):
            file = self.table() if contents is None else self.put("scale.csv", contents)
            with contextlib.redirect_stderr(io.StringIO()) as err:
                self.assertEqual(plot_scale.main([file, "--out", self.path("none")] + arguments), 1)
            self.assertIn(complaint, err.getvalue())
        self.assertFalse(os.path.exists(self.path("none")))

    @unittest.skipUnless(os.path.isfile(BENCHMARK), "USAC_BENCHMARK is not set")
    def test_program_writes_what_is_read(self):
        table = self.path("scale.csv")
        arguments = ["--program=" + BENCHMARK, "--problems=HF", "--methods", "USACV20", "cv:RANSAC", "--sizes", "50", "200", "--parts", "0.5",
                     "0.9", "--size=200", "--repeats=2", "--csv=" + table]
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(scale.main(arguments), 0)
        self.assertRegex(out.getvalue(), r"\n\| 200 \| [\d.e-]+ / [\d.]+ / 0 \| [\d.e-]+ / [\d.]+ / 0 \|\n")
        results = plot_scale.read_scale(table)
        self.assertEqual(list(results), [("size", "H"), ("inliers", "H"), ("size", "F"), ("inliers", "F")])
        for (sweep, _), runs in results.items():
            self.assertEqual(list(runs), ["USACV20", "cv:RANSAC"])
            for points in runs.values():
                self.assertEqual([p[sweep] for p in points], [50, 200] if sweep == "size" else [0.9, 0.5])
            self.assertTrue(all(0 < p["median_error"] < 1.5 for p in runs["USACV20"]), runs)


class LimitTest(FolderTest):

    def test_slow_methods_are_left_out(self):
        """A method whose median call takes longer than the limit must not run on harder scenes."""
        calls = []

        def measured(args, problem, size, part, methods):
            calls.append((size, list(methods)))
            return {m: dict({f: "1" for f in scale.FIGURES}, median_cpu_ms="%d" % (size * (2 if m == "b" else 1))) for m in methods}

        self.addCleanup(setattr, scale, "measure", scale.measure)
        scale.measure = measured
        table = self.path("scale.csv")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(scale.main(["--problems=H", "--methods", "a", "b", "--sizes", "300", "10", "100", "--parts=1", "--limit=150",
                                         "--csv=" + table]), 0)
        self.assertEqual(calls[:3], [(10, ["a", "b"]), (100, ["a", "b"]), (300, ["a"])])
        self.assertIn("| 300 | 300 / 1 / 1 | - |\n", out.getvalue())
        with open(table) as lines:
            self.assertEqual(lines.read().count("\nsize,H,"), 5)
        with contextlib.redirect_stderr(io.StringIO()) as err:
            self.assertEqual(scale.main(["--parts", "1.5"]), 1)
        self.assertIn("--parts", err.getvalue())


class ThresholdTest(FolderTest):

    def program(self):
        file = self.put("program", PROGRAM % sys.executable)
        os.chmod(file, 0o755)
        return file

    def test_ratios(self):
        ratios = threshold.Ratios([1, 2, math.inf, 3], [2, 16, 1, math.inf])
        self.assertEqual((ratios.values, ratios.broken), ([2, 8], 1))
        self.assertAlmostEqual(ratios.mean(), 4)
        self.assertEqual(str(ratios), "4.000 (2, 1 broken)")
        self.assertTrue(math.isnan(threshold.Ratios([math.inf], [1]).mean()))

    def test_right_thresholds(self):
        """The output must name the right thresholds of H, F and E and of the other problems in the
        lists, and the unit of the errors if this unit is not pixels."""
        for names, more in ((["easy.F"], ""), (["easy.S"], ", A, S and T 3 px"), (["easy.P"], ", P 4 px (errors in degrees)")):
            lists = ["--list=" + self.put("lists/%s.list" % name) for name in names]
            with contextlib.redirect_stdout(io.StringIO()) as out:
                self.assertEqual(threshold.main(["--program", self.program(), "--methods=a"] + lists), 0)
            self.assertIn("; right thresholds: H 2 px, F and E 1 px%s.\n" % more, out.getvalue())
            self.assertIn("| %s easy | 0.500 / 0.500 / 0.500 |\n" % names[0][-1], out.getvalue())

    def test_table(self):
        for name in ("easy.H", "hard.H", "easy.F"):
            self.put("lists/%s.list" % name)
        self.put("lists/notes.list")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(threshold.main(["--program", self.program(), "--data", self.folder, "--methods=a,b"]), 0)
        text = out.getvalue()
        self.assertIn("| H hard | 0.500 / 0.500 / 0.500 | 0.500 / 1.000 / inf |\n", text)
        self.assertIn("| x 2 | H, F | 1.000 (3) | 2.000 (3) |\n", text)
        self.assertIn("| x 4 | H | 1.000 (2) | 4.000 (1, 1 broken) |\n", text)
        self.assertIn("| x 4 | F | 1.000 (1) | 4.000 (1) |\n", text)

    def test_estimated(self):
        for name in ("easy.H", "hard.H", "easy.F"):
            self.put("lists/%s.list" % name)
        picture = self.path("picture.png")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(threshold.main(["--program", self.program(), "--data", self.folder, "--estimated=USACV20_AUTO"] +
                                            (["--plot=" + picture] if plot_scale else [])), 0)
        text = out.getvalue()
        self.assertIn("| H | given, x 0.25 | 4.000 | 2 | 1.5 | - | 1.00 |\n", text)
        self.assertIn("| H | given, x 1 | 1.000 | 0 | 1.5 | - | 1.00 |\n", text)
        self.assertIn("| H | estimated, at most x 3 | %.3f | 1 | 1.5 | - | 1.50 |\n" % math.sqrt(1.2), text)
        self.assertIn("| F | estimated, at most x 10 | 1.000 | 0 | 1.5 | 90.0 | 1.50 |\n", text)
        self.assertEqual(os.path.isfile(picture), plot_scale is not None)

    def test_mistakes(self):
        self.put("lists/a.H.list")
        for arguments, complaint in ((["--data", self.path("none")], "no lists"), (["--list", self.path("a.list")], "expected a name"),
                                     (["--data", self.folder, "--factors=4"], "--factors"),
                                     (["--data", self.folder, "--program=" + self.path("none")], "none")):
            with contextlib.redirect_stderr(io.StringIO()) as err:
                self.assertEqual(threshold.main(arguments), 1)
            self.assertIn(complaint, err.getvalue())


if __name__ == "__main__":
    unittest.main()
