#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of measure.py: stamps, tables, and the replacement of tables in documents.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark. If this program is in
a build folder, a test makes a measurement with it."""

import contextlib
import io
import os
import re
import shutil
import unittest

import figure_tables
import measure
import structured_tables
from measure import Measurement, MeasureError
from test_benchmark import FolderTest


class StructuredTablesTest(unittest.TestCase):

    BODY = ("Text.\n\n## First\n\nCommit `0123456`, of an earlier state. Words.\n\n```sh\nusac_structured --a=1 \\\n    --b=2\n"
            "usac_structured --c=3\n```\n\n| old |\n|---|\n\n| old, too |\n\nLast words.\n\n## Second\n\nCommit `0123456`. From a test.\n\n| kept |\n")

    def test_commands_and_tables(self):
        calls = []

        def run(arguments):
            calls.append(arguments)
            return "# Title\n\nwords\n\n| %s |\n|---|\n| 1 |\n" % arguments[0]

        new = structured_tables.renewed(self.BODY, [], "abcdef0", run)
        self.assertEqual(calls, [["--a=1", "--b=2"], ["--c=3"]])
        self.assertEqual(new, self.BODY.replace("`0123456`, of an earlier state", "`abcdef0`").replace(
            "| old |\n|---|\n\n| old, too |", "| --a=1 |\n|---|\n| 1 |\n\n| --c=3 |\n|---|\n| 1 |"))
        self.assertEqual(structured_tables.renewed(new, ["Fir"], "abcdef0", run), new, "a second run must change nothing")

    def test_unknown_sections(self):
        for name in ("Second", "Third"):  # the section "Second" has no command
            with self.assertRaisesRegex(ValueError, name):
                structured_tables.renewed(self.BODY, [name], "abcdef0", None)

    def test_document(self):
        """All arguments of the commands in structured_tables.md must have the form --option=value."""
        body = Measurement.read("structured_tables").body
        found = [c for _, text in structured_tables.sections(body) for block in structured_tables.BLOCK.findall(text)
                 for c in structured_tables.commands(block)]
        self.assertGreater(len(found), 10)
        for arguments in found:
            for argument in arguments:
                self.assertRegex(argument, "^--[a-zA-Z]+=")


class TablesTest(FolderTest):

    HEAD = "list,problem,pairs,method,median_error,failures_percent,median_cpu_ms,auc10\n"

    def tables(self, rows):
        return figure_tables.read_tables(self.put("t.csv", self.HEAD + rows))

    def test_averages(self):
        found = self.tables('"a",H,2,"X",1,0,2,\n"a",H,2,"Y",2,50,4,\n"b",H,3,"X",4,10,8,\n"b",H,3,"Y",8,0,4,\n"c",E,1,"X",0.5,0,1,90\n'
                            '"d",E,1,"X",0.5,0,1,95\n"average",,5,"X",9,9,9,9\n"average.H",H,5,"X",9,9,9,9\n')
        self.assertEqual(list(found), [("H", "a"), ("H", "b"), ("E", "c"), ("E", "d")])
        self.assertEqual(figure_tables.averages(found, ["X", "Y"], {"X": "own"}), "\n".join((
            "| method | H (2 lists) | E (2 lists) |", "|---|---|---|", "| own | 2.00 / 5.0 / 4.00 | 0.50 / 0.0 / 1.00 / 92 |",
            "| `Y` | 4.00 / 25.0 / 4.00 | - |")))
        self.assertIn("| `X` | 2.00 / 5.0 / 4.00 | 0.50 / 0.0 / 1.00 / 92 | 1.00 |",
                      figure_tables.averages(found, ["X", "Y"], None, "X"))

    def test_a_list_that_is_lost_by_one_counts_for_no_error(self):
        found = self.tables('"a",F,2,"X",1,0,2,70\n"a",F,2,"Y",inf,60,4,7\n"b",F,3,"X",3,10,8,71\n"b",F,3,"Y",8,0,4,72\n')
        table = figure_tables.averages(found, ["X", "Y"])
        self.assertIn("F (2 lists, errors of 1)", table)
        self.assertIn("| `X` | 3.00 / 5.0 / 4.00 |", table)
        self.assertIn("| `X` | 1.73 / 5.0 / 4.00 |\n| `Y` | inf / ", figure_tables.averages(found, ["X", "Y"], hopeless=["Y"]))
        self.assertIn("F (2 lists) |\n|---|---|\n| `X` | 1.73 / 5.0 / 4.00 |", figure_tables.averages(found, ["X"]))

    def test_losses(self):
        found = self.tables('"a",H,2,"X",1.01,0,2,\n"a",H,2,"cv:USAC_FAST",1,0,4,\n"b",H,3,"X",1.05,0,1,\n"b",H,3,"cv:USAC_FAST",1,0,4,\n'
                            '"c",H,4,"X",1,5,5,\n"c",H,4,"cv:USAC_FAST",1,0,4,\n')
        rows = figure_tables.losses(found, "X", ["cv:USAC_FAST"], "cv:USAC_FAST").splitlines()
        self.assertEqual(rows[2:], ["| H b | 3 | **1.050, 1.000 (FAST)** | 0.0, 0.0 | 1.00, 4.00 |",
                                    "| H c | 4 | 1.000, 1.000 (FAST) | **5.0, 0.0** | **5.00, 4.00** |"])

    def test_single_lists_and_against(self):
        found = self.tables('"a",E,2,"X",1,0,2,80\n"a",E,2,"cv:USAC_FAST",2,1,4,70\n"a",E,2,"cv:USAC_MAGSAC",1.5,3,4,70\n')
        self.assertIn("| E a | 1.000 / 0.0 / 2.00 / 80 | 1.500 (MAGSAC) | 1.0 |",
                      figure_tables.single_lists(found, ["X"], ["cv:USAC_FAST", "cv:USAC_MAGSAC"]))
        self.assertIn("| a | 1.000 / 0.0 | 2.000 / 1.0 | 4.00 | 0.50 |", figure_tables.against(found, ["X"], "cv:USAC_FAST"))

    def test_tracking(self):
        file = self.put("t.csv", "problem,ratio,initial_model,limit,frames,median_error,failures_percent,mean_samples,mean_cpu_ms,cpu_ratio,"
                                 "recovery\nP,0.2,no,8,9,inf,95.55,8,0.2,0.31,30.6\nP,0.2,yes or again,8,9,0.03,0,12.2,0.2,0.204,0\n")
        self.assertIn("| P, 20 % | 8 | inf / 95.5 / 8 / 0.31 / 30.6 |  | 0.030 / 0.0 / 12 / 0.20 / 0.0 |", figure_tables.tracking(file))


class MeasureTest(FolderTest):

    STAMP = {"command": "`program --x`", "commit": "1234567", "date": "2026-01-02", "machine": "one", "OpenCV": "4.6.0", "repeats": "5"}

    def use_folder(self):
        """Makes the temporary folder the root of the project for measure.py until the test ends."""
        self.addCleanup(setattr, measure, "ROOT", measure.ROOT)
        measure.ROOT = self.folder
        os.makedirs(self.path(measure.FOLDER))

    def test_busy(self):
        cores = os.cpu_count()
        self.assertEqual(measure.busy_words((0, 0), (10 * cores, 6 * cores), 10), "")
        self.assertIn("other programs took %.1f" % (0.8 * cores), measure.busy_words((5, 1), (5 + 10 * cores, 1 + 2 * cores), 10))
        self.assertEqual(measure.busy_words(None, None, 10), "")

    def test_stamp_and_body_are_read_as_written(self):
        self.use_folder()
        Measurement("rigid", "Title", self.STAMP, "\n| t |\n|---|\n| 1 |\n\n").write()
        m = Measurement.read("rigid")
        self.assertEqual((m.title, m.stamp, m.body), ("Title", self.STAMP, "| t |\n|---|\n| 1 |\n"))
        self.put("doc/measurements/none.md", "# Title\n\ntext\n")
        with self.assertRaisesRegex(MeasureError, "none.md: no stamp"):
            Measurement.read("none")

    def test_pages_have_a_stamp(self):
        for name in list(measure.KINDS) + [measure.STRUCTURED, "collections_tables"]:
            stamp = Measurement.read(name).stamp
            self.assertEqual(tuple(stamp), measure.STAMP, name)

    def test_mistakes(self):
        with contextlib.redirect_stderr(io.StringIO()) as err:
            self.assertEqual(measure.main(["--build=.", "x"]), 1)
        self.assertEqual(err.getvalue(), "no measurement x\n")

    @unittest.skipUnless(os.path.isfile(os.path.join(os.path.dirname(os.environ.get("USAC_BENCHMARK", "")), "..", "CMakeCache.txt")) and
                         shutil.which("cmake"), "USAC_BENCHMARK is in no build folder")
    def test_measurement(self):
        """Makes the measurement "affine", which needs no data, with one repeat. Its file must have a
        complete stamp and tables with plausible errors."""
        build = os.path.dirname(os.path.dirname(os.path.abspath(os.environ["USAC_BENCHMARK"])))
        self.use_folder()
        with contextlib.redirect_stderr(io.StringIO()):
            measure.measure("affine", build, None, 1)
        with open(Measurement.file("affine")) as file:
            self.assertNotIn(build, file.read())
        measured = Measurement.read("affine")
        self.assertEqual((measured.stamp["repeats"], measured.stamp["date"]), ("1", measure.today()))
        self.assertRegex(measured.stamp["OpenCV"], r"^\d+\.\d+\.\d+")
        self.assertIn("--scene=affinity", measured.stamp["command"])
        rows = re.findall(r"^\| (?:affinity|similarity)_0\.\d \| ([\d.]+) / ([\d.]+) \|", measured.body, re.M)
        self.assertEqual(len(rows), 4)
        for error, failures in rows:
            self.assertTrue(0 < float(error) < 1 and float(failures) == 0, rows)


if __name__ == "__main__":
    unittest.main()
