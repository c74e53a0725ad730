#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of measure.py and of the modules with which it writes figures into documents. They test blocks,
stamps, digests of stored hashes, tables, and the reading of logs of the test scripts.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark. If this program is in
a build folder, a test makes a measurement with it."""

import contextlib
import datetime
import io
import math
import os
import re
import shutil
import unittest

import figure_tables
import figures
import gate_logs
import measure
import phases
import structured_tables
from figures import FiguresError, Measurement, Project, Rows
from test_benchmark import FolderTest

HASHES = """# made by test_hashes.cpp: set:parameters, iterations, inliers, robust hash, exact hash
kernels avx512
platform 18cd5d42b4945af8
graf:usacV20 238 244 aed00f58e1fda308 9c5d9f194028e261
graf:fast 65 244 3f179ea088cd6187 44007e1f3f7748f7
rigid3D:usacV20 128 198 ca922bba76e3eb3c 08193782a756f7d8
"""
STAMP = {"command": "`program --x`", "commit": "1234567", "date": "2026-01-02", "machine": "one", "OpenCV": "4.6.0", "repeats": "5"}


class BlocksTest(unittest.TestCase):

    TEXT = "A <!-- figures: a/n -->12<!-- figures: end --> tests.\n\n<!-- figures: b/t -->\n\n| x |\n|---|\n\n<!-- figures: end -->\nend\n"

    def test_blocks(self):
        self.assertEqual(figures.blocks_of(self.TEXT, "f"), {"a/n": "12", "b/t": "| x |\n|---|"})
        self.assertEqual(figures.blocks_of("`<!-- figures: a/n -->` marks one", "f"), {})

    def test_filled(self):
        filled = figures.filled(self.TEXT, "f", {"a/n": "3456", "b/t": "| y |\n|---|\n| 1 |", "c": "-"})
        self.assertEqual(filled, self.TEXT.replace("12", "3456").replace("| x |\n|---|", "| y |\n|---|\n| 1 |"))
        self.assertEqual(figures.filled(filled, "f", {"a/n": "12", "b/t": "| x |\n|---|"}), self.TEXT)
        self.assertEqual(figures.filled(self.TEXT, "f", {}), self.TEXT)

    def test_broken_marks(self):
        for text, complaint in (("<!-- figures: a -->1", "a has no end"), ("1<!-- figures: end -->", "without a beginning"),
                                ("<!-- figures: a -->1<!-- figures: b -->2<!-- figures: end -->", "a has no end"),
                                (self.TEXT + "<!-- figures: end -->", "without a beginning")):
            with self.assertRaisesRegex(FiguresError, "f: .*" + complaint):
                figures.find_blocks(text, "f")


class RowsTest(unittest.TestCase):

    def test_only_rows_that_belong_to_it_count(self):
        graf, fast = Rows(("graf",), ("usacV20",)), Rows((), ("fast",))
        before = graf.digest(HASHES), fast.digest(HASHES)
        for old, new, changed in (("9c5d9f194028e261", "0c5d9f194028e261", (True, False)), ("238 244", "239 244", (True, False)),
                                  ("44007e1f3f7748f7", "44007e1f3f7748f8", (False, True)), ("ca922bba", "ca922bbb", (False, False)),
                                  ("platform 18cd", "platform 28cd", (False, False)), ("avx512", "avx2", (False, False)),
                                  ("rigid3D:usacV20", "rigid3D:fast", (False, True))):
            text = HASHES.replace(old, new)
            self.assertNotEqual(text, HASHES)
            self.assertEqual((graf.digest(text) != before[0], fast.digest(text) != before[1]), changed, (old, new))

    def test_order_of_the_file_does_not_count(self):
        lines = HASHES.splitlines()
        self.assertEqual(Rows().digest("\n".join(lines[::-1])), Rows().digest(HASHES))

    def test_no_row(self):
        with self.assertRaisesRegex(FiguresError, "no row"):
            Rows(("aloe",)).digest(HASHES)

    def test_every_measurement_has_rows(self):
        hashes = figures.read_text(os.path.join(measure.ROOT, figures.HASHES))
        for kind in measure.KINDS.values():
            for name in kind.rows.sets:
                Rows((name,)).digest(hashes)
            for name in kind.rows.params:
                Rows(kind.rows.sets, (name,)).digest(hashes)


class ProjectTest(FolderTest):
    """Tests with a small project of two measurements, "lists" and "rigid". README.md quotes "lists",
    which must therefore not be older than the last change of results."""

    ROWS = {"lists": Rows(("graf",)), "rigid": Rows(("rigid3D",))}
    README = "\n".join(figures.inline_block(name, "?") for name in ("hashes/cpp", "hashes/python", "lists/a")) + "\n"

    def setUp(self):
        super().setUp()
        self.put("README.md", self.README)
        self.put("doc/benchmark.md", "<!-- figures: rigid/b -->\n\n?\n\n<!-- figures: end -->\n")
        self.put(figures.INDEX, "<!-- figures: index -->\n?\n<!-- figures: end -->\n")
        self.put("doc/other.md", "no block\n")
        self.put(figures.HASHES, HASHES)
        self.put(figures.PYTHON_HASHES, '{"a": "1", "b": "2"}')
        self.write("lists", "lists/a", "0.98 px")
        self.write("rigid", "rigid/b", "| t |\n|---|\n| 1 |")
        self.assertEqual(self.project().fill(), ["README.md", "doc/benchmark.md", figures.INDEX])

    def write(self, name, block, text):
        stamp = dict(STAMP, results=self.ROWS[name].digest(figures.read_text(self.path(figures.HASHES))))
        Measurement(name, "Title of " + name, stamp, "Text\n\n" + figures.block(block, text)).write(self.folder)

    def project(self):
        return Project(self.folder, self.ROWS, ["lists"])

    def change(self, file, old, new):
        text = figures.read_text(self.path(file))
        self.assertIn(old, text)
        self.put(file, text.replace(old, new))

    def complaints(self, *expected):
        mistakes = self.project().check()
        self.assertEqual(len(mistakes), len(expected), mistakes)
        for mistake, pattern in zip(mistakes, expected):
            self.assertRegex(mistake, pattern)

    def test_fresh(self):
        self.complaints()
        self.assertEqual(self.project().fill(), [])
        self.assertEqual(figures.read_text(self.path("README.md")),
                         "<!-- figures: hashes/cpp -->3<!-- figures: end -->\n<!-- figures: hashes/python -->2<!-- figures: end -->\n"
                         "<!-- figures: lists/a -->0.98 px<!-- figures: end -->\n")
        self.assertIn("| [rigid](rigid.md) | Title of rigid | 4.6.0 | 1234567 | 2026-01-02 | current |",
                      figures.read_text(self.path(figures.INDEX)))

    def test_stamp_and_body_are_read_as_written(self):
        m = Measurement.read(self.folder, "rigid")
        self.assertEqual((m.title, m.blocks()), ("Title of rigid", {"rigid/b": "| t |\n|---|\n| 1 |"}))
        self.assertEqual({key: m.stamp[key] for key in STAMP}, STAMP)
        self.assertTrue(m.as_written())

    def test_results_have_changed(self):
        self.change(figures.HASHES, "graf:fast 65", "graf:fast 66")
        self.complaints("README.md: its figures of lists are older than the last change", figures.INDEX + ": the block index is not")
        self.assertEqual(self.project().older(), ["lists"])
        self.write("lists", "lists/a", "0.97 px")  # the measurement is new, but README.md still quotes the old one
        self.complaints("README.md: the block lists/a is not what was measured")
        self.project().fill()
        self.complaints()
        self.assertIn("0.97 px", figures.read_text(self.path("README.md")))

    def test_older_results_of_what_readme_does_not_quote_are_told_only(self):
        self.change(figures.HASHES, "rigid3D:usacV20 128", "rigid3D:usacV20 129")
        self.complaints(figures.INDEX + ": the block index is not")
        self.project().fill()
        self.complaints()
        self.assertEqual(self.project().older(), ["rigid"])
        self.assertRegex(figures.read_text(self.path(figures.INDEX)), r"\[rigid\].* \| older \|")

    def test_another_number_of_hashes(self):
        self.change(figures.HASHES, "rigid3D", "aloe:fast 1 2 aed00f58e1fda308 aed00f58e1fda308\nrigid3D")
        self.complaints("README.md: the block hashes/cpp")

    def test_changed_by_hand(self):
        self.change("README.md", "0.98", "0.89")
        self.complaints("README.md: the block lists/a is not what was measured")
        self.change("README.md", "0.89", "0.98")
        self.change(figures.FOLDER + "/lists.md", "0.98", "0.89")
        self.complaints("lists.md: changed by hand")
        self.change(figures.FOLDER + "/lists.md", "0.89", "0.98")
        self.change(figures.FOLDER + "/rigid.md", "| commit | 1234567 |\n", "")
        self.complaints("rigid.md: no commit in the stamp")

    def test_unknown_and_broken(self):
        self.change("README.md", "lists/a", "lists/z")
        self.complaints("README.md: no measurement has the block lists/z")
        self.change("README.md", "px<!-- figures: end -->", "px")
        self.complaints("README.md: the block lists/z has no end")
        self.write("lists", "rigid/a", "1")
        self.complaints("lists.md: blocks of another measurement")
        os.rename(self.path(figures.FOLDER, "lists.md"), self.path(figures.FOLDER, "none.md"))
        self.complaints("none.md: no stamp")

    def test_a_measurement_that_nobody_makes(self):
        self.ROWS = {"lists": Rows(("graf",))}
        self.complaints("rigid.md: measure.py has no such measurement")


class CopiedTest(FolderTest):

    def test_a_table_that_was_copied(self):
        stamp = dict(STAMP, results="abc")
        self.put(figures.FOLDER + "/structured_tables.md")
        Measurement("structured_tables", "Scenes", stamp, "| t |\n|---|\n| 1 |").write(self.folder)
        file = self.path(figures.FOLDER, "structured_tables.md")
        self.put(file, figures.read_text(file).replace("| 1 |", "| 2 |"))
        self.assertFalse(Measurement.read(self.folder, "structured_tables").as_written())
        measure.take_copied(self.folder, "structured_tables")
        m = Measurement.read(self.folder, "structured_tables")
        self.assertTrue(m.as_written())
        self.assertIn("| 2 |", m.body)
        self.assertEqual((m.stamp["date"], m.stamp["results"], m.stamp["commit"]), (measure.today(), "abc", STAMP["commit"]))

    def test_only_those_that_no_function_makes(self):
        for name in ("lists", "tests", "none"):
            with self.assertRaisesRegex(FiguresError, name + " is none of constants_tables, "):
                measure.take_copied(self.folder, name)


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
        body = Measurement.read(measure.ROOT, "structured_tables").body
        found = [c for _, text in structured_tables.sections(body) for block in structured_tables.BLOCK.findall(text)
                 for c in structured_tables.commands(block)]
        self.assertGreater(len(found), 12)
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


class PhasesTest(unittest.TestCase):
    COUNTS = """version: 1
events: Ir
fn=(1) cv::usacv20::(anonymous namespace)::UsacImpl::run(cv::_OutputArray const&)
+3 50
cfn=(2) cv::usacv20::SampleBatch::draw()
calls=4 100
+1 100
cfn=(3) cv::usacv20::(anonymous namespace)::GraphCutOptimizer::optimize(cv::usacv20::Context const&)
calls=1 7
+2 400
cfn=(5) cv::usacv20::Restarts::improve(cv::usacv20::Model&)
calls=1 7
+2 200
fn=(3)
+1 100
cfn=(4) cv::usacv20::Labeling::cut(cv::usacv20::Context const&)
calls=2 9
* 300
fn=(5)
* 50
cfn=(6) cv::usacv20::(anonymous namespace)::RobustPolisher::polish(cv::usacv20::Context const&)
calls=2 9
* 150
fn=(1)
+1 100
cfn=(6)
calls=1 9
* 150
totals: 1000
"""

    def test_shares(self):
        total, calls = phases.read_calls(io.StringIO(self.COUNTS))
        self.assertEqual(total, 1000)
        found = {phase: round(share, 3) for phase, share in phases.shares(total, calls).items()}
        self.assertEqual(found, {"samples": 0.1, "their models": 0, "test, score": 0, "degeneracy": 0, "graph cut": 0.3, "local fits": 0.1,
                                 "polishing": 0.35, "rest": 0.15})


class GateLogsTest(FolderTest):

    COVERAGE = "[  PASSED  ] 1500 tests.\nlines: 99.9% (3463 out of 3464)\nbranches: 98.4% (2844 out of 2889)\n"

    def rows(self, **logs):
        for name, text in logs.items():
            self.put(name + ".log", text)
        found = {name: gate_logs.read_row(self.folder, name, lambda time, commit: (commit or "1234567", "abc")) for name in gate_logs.PARTS}
        return {name: row for name, row in found.items() if row}

    def test_counts(self):
        for log, counts in (("x\n1694 passed, 0 failed\n", (1694, 0)), ("[  PASSED  ] 119 tests.\n", (119, 0)), ("[  PASSED  ] 1 test.\n", (1, 0)),
                            ("1 passed, 1 failed\n5 passed, 2 failed\n", (5, 2)),
                            ("[  PASSED  ] 9 tests.\n[  FAILED  ] 2 tests, listed below:\n", (9, 2))):
            self.assertEqual(gate_logs.read_counts(log), counts)
        with self.assertRaisesRegex(gate_logs.GateError, "no count"):
            gate_logs.read_counts("error: 3 passed, perhaps\n")

    def test_seconds(self):
        self.assertEqual(gate_logs.read_seconds("0m0.00s 0m0.00s\n17m3.97s 1m51.60s\n", "0m0.00s 0m0.01s\n18m25.67s 1m54.02s\n"), "84")

    def test_rows(self):
        self.put("tsan.before", "0m0s 0m0s\n0m1s 0m0s\n")
        self.put("tsan.after", "0m0s 0m0s\n1m0s 0m2s\n")
        self.put("tsan.commit", "7654321\n")
        rows = self.rows(tsan="10 passed, 0 failed\n", coverage=self.COVERAGE, fuzz="Done 54900 runs in 3605 second(s)\n1 passed, 0 failed\n")
        self.assertEqual({name: row["more"] for name, row in rows.items()},
                         {"tsan": "-", "coverage": "lines 3463 of 3464; branches 2844 of 2889", "fuzz": "54900 inputs in 60 minutes"})
        self.assertEqual((rows["tsan"]["processor s"], rows["fuzz"]["processor s"]), ("61", "-"))
        self.assertEqual(gate_logs.parse_table("text\n\n" + gate_logs.table(rows) + "\n"), rows)
        today = datetime.datetime.now(datetime.timezone.utc).date()
        self.assertEqual(gate_logs.sentences(rows), {
            "tsan": "10 tests, none failed (%s, 7654321)" % today,
            "coverage": "3463 of 3464 lines of `src/` and 98.4 %% of the branches (2844 of 2889; %s, 1234567)" % today,
            "fuzz": "54900 inputs in 60 minutes, no finding (%s, 1234567)" % today})

    def test_gate(self):
        rows = self.rows(**{name: "%d passed, 0 failed\n" % (i + 1) for i, name in enumerate(gate_logs.GATE)})
        self.assertRegex(gate_logs.sentences(rows)["gate"], r"^1 C\+\+, 2 performance, .*, 9 C\+\+ with sanitizers; none failed \(20")
        rows["perf"]["failed"] = "2"
        self.assertIn("; 2 failed (", gate_logs.sentences(rows)["gate"])
        del rows["perf"]
        self.assertNotIn("gate", gate_logs.sentences(rows))

    def test_log_without_count_is_named(self):
        with self.assertRaisesRegex(gate_logs.GateError, r"cpp\.log: no count of tests"):
            self.rows(cpp="ninja: error\n")


class MeasureTest(FolderTest):

    def test_busy(self):
        cores = os.cpu_count()
        self.assertEqual(measure.busy_words((0, 0), (10 * cores, 6 * cores), 10), "")
        self.assertIn("other programs took %.1f" % (0.8 * cores), measure.busy_words((5, 1), (5 + 10 * cores, 1 + 2 * cores), 10))
        self.assertEqual(measure.busy_words(None, None, 10), "")

    def test_project_is_consistent_in_itself(self):
        """The documents of this project must have no mistakes in their figures. Figures in README.md
        that are older than the results are ignored here, because check_sources.sh checks these."""
        mistakes = [m for m in measure.project().check() if "older than the last change" not in m]
        self.assertEqual(mistakes, [])

    def call(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = measure.main(arguments)
        return code, out.getvalue(), err.getvalue()

    def copy(self):
        """Copies the files with figures to the temporary folder, which is the root of the project for
        measure.py until the test ends."""
        measurements = os.listdir(os.path.join(measure.ROOT, figures.FOLDER))
        for path in [figures.HASHES, figures.PYTHON_HASHES] + figures.documents(measure.ROOT) + \
                [os.path.join(figures.FOLDER, name) for name in measurements if name.endswith(".md")]:
            source = os.path.join(measure.ROOT, path)
            os.makedirs(os.path.dirname(self.path(path)), exist_ok=True)
            shutil.copy(source, self.path(path))
        root = measure.ROOT
        self.addCleanup(setattr, measure, "ROOT", root)
        measure.ROOT = self.folder

    def test_check_fails_after_a_change_of_results(self):
        self.copy()
        hashes = figures.read_text(self.path(figures.HASHES))
        row = next(line for line in hashes.splitlines() if line.startswith("graf:usacV20 "))
        self.put(figures.HASHES, hashes.replace(row, row[:-1] + ("0" if row[-1] != "0" else "1")))
        self.assertEqual(self.call("--fill")[0], 0)
        code, out, err = self.call("--check")
        self.assertEqual((code, out.count("\n")), (1, 1), out)
        self.assertIn("README.md: its figures of lists are older", out)
        self.assertRegex(err, "of older results: .*threshold")
        self.assertNotRegex(err, r"\brigid\b.*\brigid\b")

    def test_logs(self):
        self.copy()
        logs, before = self.path("logs"), Measurement.read(self.folder, "tests").blocks()
        self.put("logs/valgrind.log", "4321 passed, 0 failed\n")
        self.assertEqual(self.call("--logs=" + logs)[0], 0)
        tests = Measurement.read(self.folder, "tests")
        self.assertRegex(tests.blocks()["tests/valgrind"], "^4321 tests, none failed")
        self.assertEqual(tests.blocks()["tests/tsan"], before["tests/tsan"])
        self.assertEqual(self.call("--logs=" + self.folder), (1, "", "%s: no log of run_tests.sh or sanitize.sh\n" % self.folder))

    def test_mistakes(self):
        self.assertIn("no measurement x", self.call("--build=.", "x")[2])
        self.assertIn("--build is missing", self.call("rigid")[2])

    @unittest.skipUnless(os.path.isfile(os.path.join(os.path.dirname(os.environ.get("USAC_BENCHMARK", "")), "..", "CMakeCache.txt")) and
                         shutil.which("cmake"), "USAC_BENCHMARK is in no build folder")
    def test_measurement(self):
        """Makes the measurement "affine", which needs no data, with one repeat. Its file must have a
        complete stamp and tables with plausible errors."""
        self.copy()
        build = os.path.dirname(os.path.dirname(os.path.abspath(os.environ["USAC_BENCHMARK"])))
        with contextlib.redirect_stderr(io.StringIO()):
            measure.measure("affine", build, None, 1)
        measured = Measurement.read(self.folder, "affine")
        self.assertTrue(measured.as_written())
        self.assertEqual((measured.stamp["repeats"], measured.stamp["date"]), ("1", measure.today()))
        self.assertRegex(measured.stamp["OpenCV"], r"^\d+\.\d+\.\d+")
        self.assertNotIn(build, figures.read_text(Measurement.file(self.folder, "affine")))
        self.assertIn("--scene=affinity", measured.stamp["command"])
        for block in ("affine/affinity", "affine/similarity"):
            rows = measured.blocks()[block].splitlines()[2:]
            self.assertEqual(len(rows), 2)
            for row in rows:
                error, failures = [float(n) for n in re.match(r"\| \w+_0\.\d \| ([\d.]+) / ([\d.]+) \|", row).groups()]
                self.assertTrue(0 < error < 1 and failures == 0 and math.isfinite(error), row)
        self.assertIn(measured.stamp["date"], measured.blocks()["affine/stamp"])


if __name__ == "__main__":
    unittest.main()
