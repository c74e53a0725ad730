#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of programs that register their own methods and run the benchmark with them.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark. The other programs
(usac_custom_benchmark, usac_test_methods, example_usac_custom_quality) are taken from the same folder.
"""

import csv
import os
import re
import subprocess
import unittest

import numpy as np

import pairs
from test_benchmark import C1, C2, K, R1, R2, SIZE, FolderTest, project, text

PROGRAMS = os.path.dirname(os.environ.get("USAC_BENCHMARK", ""))
TEST_DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "test_data")
PARAMS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "include", "opencv2", "usac", "params.hpp")
REPEATS = 5
#: The columns of a run (file of --runs) that do not depend on time, so that runs can be compared exactly.
FIGURES = ("pair", "repeat", "error", "failed", "pose_error", "iterations", "inliers", "cost")


def program(name):
    return os.path.join(PROGRAMS, name)


def read_test_data(name, size, noise=0.0):
    """Reads a data set of test_data/ as a pair. Noise with the standard deviation `noise`, in pixels,
    is added, and coordinates are rounded to eighths of a pixel, which every program reads without
    rounding errors."""
    rows = np.loadtxt(os.path.join(TEST_DATA, name + ".txt"))
    rows[:, :4] = np.round(8 * (rows[:, :4] + np.random.RandomState(2).normal(0, noise, (len(rows), 4)))) / 8
    with open(os.path.join(TEST_DATA, name + ".yml")) as lines:
        truth = lines.read()
    problem = re.search(r"problem: (\w)", truth).group(1)

    def matrix(key):
        data = re.search(key + r": !!opencv-matrix.*?data: \[(.*?)\]", truth, re.DOTALL).group(1)
        return np.array([float(number) for number in data.split(",")])

    homography = problem == "H"
    return pairs.Pair([problem], rows[:, :2], rows[:, 2:4], rows[:, 4], size, size, matrix("check").reshape(-1, 4),
                      "homography" if homography else "annotated", H=matrix("model").reshape(3, 3) if homography else None)


def figures(row):
    return [row[key] for key in FIGURES]


@unittest.skipUnless(os.path.isfile(program("usac_test_methods")), "there is no usac_test_methods beside USAC_BENCHMARK")
class CustomTest(FolderTest):

    def setUp(self):
        super().setUp()
        x1, x2, R = project(R1, C1), project(R2, C2), R2 @ R1.T
        scene = pairs.Pair(["E"], x1, x2, np.linspace(0.1, 0.9, len(x1)), SIZE, SIZE, np.hstack((x1, x2)), "pose", K1=K, K2=K,
                           R=R, t=R2 @ (C1 - C2))
        for name, pair in (("graf", read_test_data("graf", (800, 640))), ("office01_F", read_test_data("office01_F", (640, 480))),
                           ("scene", scene)):
            path = self.path("pairs", "set", name)
            pairs.write_pair(path, pair)
            pairs.write_list(pairs.list_file(self.folder, "set", pair.problems[0]), [path])

    def run_program(self, name, *arguments):
        return subprocess.run([program(name)] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True)

    def runs(self, name, methods, stderr="", *arguments):
        """Runs a program; returns the rows of its file --runs as {problem: {method: [row]}}, and its
        output with the tables. `stderr` is a regular expression for the expected messages."""
        file = self.path("runs.csv")
        done = self.run_program(name, "--data=" + self.folder, "--runs=" + file, "--repeats=%d" % REPEATS,
                                "--methods=" + ",".join(methods), *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "^%s$" % stderr)
        rows = {}
        with open(file, newline="") as lines:
            for row in csv.DictReader(lines):
                rows.setdefault(row["problem"], {}).setdefault(row["method"], []).append(row)
        return rows, done.stdout

    def check_mistake(self, name, method, complaint):
        done = self.run_program(name, "--data=" + self.folder, "--methods=USACV20," + method)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(complaint, done.stderr)

    def test_sample_beside_the_presets(self):
        methods = ["USACV20", "custom:spread", "custom:tukey", "custom:tukey+scores", "custom:ransac", "cv:RANSAC"]
        rows, tables = self.runs("usac_custom_benchmark", methods)
        for problem in "HFE":
            expected = [m for m in methods if problem != "E" or m != "custom:ransac"]
            self.assertEqual(sorted(rows[problem]), sorted(expected))
            table = tables[tables.index("## set (%s" % problem):].split("\n## ")[0]
            self.assertEqual(re.findall(r"^\| ([\w:+]+) \|", table, re.MULTILINE), ["method"] + expected)
            for method in expected:
                self.assertEqual([row["failed"] for row in rows[problem][method]], ["0"] * REPEATS, method)
        # for one problem alone, another score can lead to the same models
        for method, other in (("custom:spread", "USACV20"), ("custom:tukey", "USACV20"),
                              ("custom:tukey+scores", "custom:tukey")):
            self.assertNotEqual([figures(row) for problem in "HF" for row in rows[problem][method]],
                                [figures(row) for problem in "HF" for row in rows[problem][other]], method)
        for problem in "HF":
            self.assertEqual([figures(row) for row in rows[problem]["custom:ransac"]],
                             [figures(row) for row in rows[problem]["cv:RANSAC"]])

    def test_same_component_as_the_built_in_one(self):
        for suffix in ("", "+scores", "{threshold=4,localOptimization=1,seed=7}", "+scores{maxIterations=40}"):
            base, custom = "preset:ransac" + suffix, "custom:same" + suffix
            rows, _ = self.runs("usac_test_methods", [base, custom])
            for problem in "HF":
                self.assertEqual([figures(row) for row in rows[problem][custom]], [figures(row) for row in rows[problem][base]])
            self.assertEqual(list(rows["E"]), [base], "custom:same is registered for H and F only")

    @unittest.skipUnless(os.path.isfile(program("example_usac_custom_quality")), "there is no such sample beside USAC_BENCHMARK")
    def test_same_quality_as_the_program_beside(self):
        """The sample custom_quality runs the same two estimators as the benchmark, with MSAC and with a
        custom quality function (Tukey), on the matches of a text file. Its numbers of inliers and
        iterations must agree with those of the benchmark. Because of the noise of 1 pixel, the two
        estimators find different inliers, so that a confusion of the two is noticed."""
        noisy, path = read_test_data("graf", (800, 640), 1.0), self.path("pairs", "noisy", "graf")
        pairs.write_pair(path, noisy)
        pairs.write_list(pairs.list_file(self.folder, "set", "H"), [path])
        file = self.put("graf.txt", text(*np.hstack((noisy.points1, noisy.points2))))
        told, measured = {"MSAC": [], "Tukey": []}, {"MSAC": [], "Tukey": []}
        for threshold in (1, 2, 4, 8):
            done = self.run_program("example_usac_custom_quality", file, "--threshold=%d" % threshold)
            self.assertEqual(done.returncode, 0, done.stderr)
            for name, inliers, iterations in re.findall(r"^(\w+)\s+(\d+) inliers.* (\d+) iterations", done.stdout, re.MULTILINE):
                told[name].append((inliers, iterations))
            suffix = "{threshold=%d,maxIterations=5000,seed=0}" % threshold
            rows, _ = self.runs("usac_custom_benchmark", ["USACV20" + suffix, "custom:tukey" + suffix], "", "--problem=H")
            for name, method in (("MSAC", "USACV20"), ("Tukey", "custom:tukey")):
                row = rows["H"][method + suffix][0]
                measured[name].append((row["inliers"], row["iterations"]))
        self.assertEqual(measured, told)
        self.assertNotEqual(told["MSAC"], told["Tukey"])

    def test_fields_and_scores(self):
        """Fields {...} and +scores in the name of a method must have an effect on methods of the module
        (custom:same) and on other estimators (custom:echo, which encodes its input in its number of
        iterations)."""
        limited, plain = "custom:same{maxIterations=7}", "custom:same"
        echo, scored = "custom:echo{maxIterations=5}", "custom:echo+scores{number=8,seed=2,maxIterations=6}"
        rows, _ = self.runs("usac_test_methods", [limited, plain, echo, scored])
        for problem in "HF":
            self.assertEqual([row["iterations"] for row in rows[problem][limited]], ["7"] * REPEATS)
            self.assertTrue(all(int(row["iterations"]) > 7 for row in rows[problem][plain]))
        for problem, cameras in (("H", 0), ("E", 200000)):
            self.assertEqual([int(row["iterations"]) for row in rows[problem][echo]],
                             [cameras + 5000 + 10 * (1 + repeat) + 3 for repeat in range(REPEATS)])
            self.assertEqual([int(row["iterations"]) for row in rows[problem][scored]],
                             [cameras + 100000 + 6000 + 20 + 8] * REPEATS)
        self.assertNotIn(echo, rows["F"])
        self.check_mistake("usac_test_methods", "custom:same{number=1}",
                           "'number=1': cv::usacv20::Params has no such numeric field")
        self.check_mistake("usac_test_methods", "custom:echo{sampler=1}",
                           "'sampler=1': custom:echo{sampler=1} has no such field; "
                           "there are threshold, confidence, maxIterations, seed, number")
        self.check_mistake("usac_test_methods", "custom:echo{seed=1.5}", "'seed=1.5': expected an integer")
        self.check_mistake("usac_test_methods", "custom:echo{confidence=1}", "custom:echo{confidence=1}: confidence: expected")
        self.check_mistake("usac_custom_benchmark", "custom:ransac+scores", "custom:ransac+scores: takes no scores")

    def test_options_by_their_names(self):
        """The names that fields accept as values must be the enumerators of params.hpp, without their
        common prefix, in the same order. They must have the same effect as the enumerators' numbers."""
        with open(PARAMS) as lines:
            header = re.sub(r"//.*", "", lines.read())
        for field, enumeration in (("sampler", "SamplerType"), ("ordering", "OrderingType"), ("scoreOrder", "ScoreOrder"),
                                   ("neighborhood", "NeighborhoodType"), ("thresholdType", "ThresholdType"), ("residual", "ResidualType"), ("quality", "QualityType"),
                                   ("verification", "VerificationType"), ("localOptimization", "LocalOptimizationType"),
                                   ("termination", "TerminationFlags"), ("degeneracy", "DegeneracyFlags"), ("polishing", "PolishingType")):
            body = re.search(r"enum %s(?:: int)? \{(.*?)\}" % enumeration, header, re.DOTALL).group(1)
            found = re.findall(r"(\w+)\s*=\s*(\d+)", body)
            prefix = os.path.commonprefix([name for name, _ in found]).rpartition("_")[0] + "_"
            flags = enumeration.endswith("Flags")
            self.assertEqual([int(value) for _, value in found], [1 << i if flags else i for i in range(len(found))], field)
            names = ", ".join(name[len(prefix):] for name, _ in found)
            self.check_mistake("usac_benchmark", "USACV20{%s=nothing}" % field, "expected a number or one of " + names)
        pairs_of_methods = [("USACV20{sampler=prosac}", "USACV20{sampler=1}"), ("USACV20{quality=msac}", "USACV20{quality=1}"),
                            ("USACV20{termination=sprt|Standard}", "USACV20{termination=3}"),
                            ("USACV20{localOptimization=lo-ransac}", "USACV20{localOptimization=2}")]
        rows, _ = self.runs("usac_benchmark", [method for pair in pairs_of_methods for method in pair])
        for named, numbered in pairs_of_methods:
            for problem in "HF":
                self.assertEqual([figures(row) for row in rows[problem][named]], [figures(row) for row in rows[problem][numbered]], named)
        self.check_mistake("usac_benchmark", "USACV20{sampler=prosac|uniform}", "expected a number or one of UNIFORM")

    def test_unknown_names(self):
        self.check_mistake("usac_custom_benchmark", "custom:nope{seed=1}",
                           "custom:nope{seed=1}: no such method is registered; "
                           "registered methods: custom:ransac, custom:spread, custom:tukey\n")
        self.check_mistake("usac_benchmark", "custom:spread",
                           "custom:spread: no such method is registered; this program registers none\n")
        self.check_mistake("usac_custom_benchmark", "nope", "nope: no such method; there are USACV20, ")
        self.check_mistake("usac_custom_benchmark", "nope", ", custom:ransac, custom:spread, custom:tukey\n")
        self.check_mistake("usac_test_methods", "custom:nothing", "custom:nothing: its factory returned null\n")

    def test_help_in_alphabetical_order(self):
        for name, custom in (("usac_custom_benchmark", ", custom:ransac, custom:spread, custom:tukey."), ("usac_benchmark", ".")):
            done = self.run_program(name, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("cv:AFFINE3D_REFIT" + custom + "\n", done.stdout)

    def test_refused_registrations(self):
        done = self.run_program("usac_test_methods", "mistakes")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        form = "registerMethod: '%s': expected custom: and letters, digits, '_', '-' or '.'"
        names = ("mine", "custom:", "custom:a,b", "custom:a{b", "custom:a+scores", "Custom:a")
        problems = "'%s': expected problems, some of the letters HFEASPRMT"
        self.assertEqual(done.stdout.splitlines(), [
            "registerMethod: custom:same is registered already"] + [form % name for name in names] + [
            "registerMethod: custom:empty: the factory is empty", "withComponents: the change is empty",
            "wholeEstimator: the function is empty", problems % "HX", problems % ""])

    def test_what_an_estimator_does_wrong(self):
        """An exception of a method, or a mask or model of the wrong size, must count as a failure and
        must be reported only once."""
        for method, what in (("custom:complain", "not today"), ("custom:shortMask", "expected a mask with a byte for each"),
                             ("custom:smallModel", "expected a model of 3 x 3 doubles"), ("custom:noSampler", "components().sampler")):
            message = r"%s threw on graf \(H\), which counts as a failure \(reported only once\): .*%s.*\n" % (method, re.escape(what))
            rows, _ = self.runs("usac_test_methods", [method], message, "--problem=H")
            self.assertEqual([(row["failed"], row["error"]) for row in rows["H"][method]], [("1", "inf")] * REPEATS)


if __name__ == "__main__":
    unittest.main()
