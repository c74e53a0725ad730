#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of documents.py, which checks the code in the documents: wrong commands, wrong code and blocks
without a rule must be reported as failures.

The environment variable USAC_DOCUMENTS_CHECKS names the working directory of check.sh with the
library's build. Without it, tests that compile C++ code are skipped."""

import contextlib
import io
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from actions import UNUSED, CMake, Cpp, Elsewhere, Impossible, Numbers, Place, Printed, Python, Shell, Wrong
from blocks import DocumentError, blocksOf, commandsOf
from documents import keyOf, matched, run
from table import DOCUMENTS, TABLE

CHECKS = os.environ.get("USAC_DOCUMENTS_CHECKS", "")
PROJECT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[".."] * 5))
TEXT = """# Title

Text with `cmake --version` and a `word`, and `python3 -m
unittest` over two lines.

```sh
echo one
```

Part {#part}
----

-   A list:

    ```python
    x = 1
      # indented
    ```

@code{.cpp}
int a;
@endcode

```sh
echo two
```
```sh
echo three
```
"""


class BlocksTest(unittest.TestCase):

    def test_blocks(self):
        blocks = list(blocksOf("a.md", TEXT))
        self.assertEqual([(b.line, b.heading, b.language, b.number, b.text) for b in blocks], [
            (3, "Title", "inline", 1, "cmake --version"), (3, "Title", "inline", 2, "python3 -m unittest"), (7, "Title", "sh", 1, "echo one\n"),
            (16, "Part", "python", 1, "x = 1\n  # indented\n"), (21, "Part", "cpp", 1, "int a;\n"), (25, "Part", "sh", 1, "echo two\n"),
            (28, "Part", "sh", 2, "echo three\n")])
        self.assertEqual(len({block.name for block in blocks}), len(blocks))
        lines = TEXT.split("\n")
        for block in blocks[2:]:
            self.assertEqual(lines[block.line - 1].strip(), block.text.split("\n")[0].strip())

    def test_faults(self):
        for text, words in (("```sh\necho\n", "a.md:1: a block without an end"), ("\n@code{.cpp}\n", "a.md:2"), ("```perl\n```\n", "perl")):
            with self.assertRaisesRegex(DocumentError, words):
                list(blocksOf("a.md", text))

    def test_commands(self):
        self.assertEqual(commandsOf("# all\na \\\n    --b  # c\n\nd '#e' f\n"), ["a --b", "d '#e' f"])

    def test_every_document_has_rules(self):
        self.assertEqual(sorted({rule[0] for rule in TABLE}), sorted(name for name in DOCUMENTS if name != "modules/usac/tutorials/usac.markdown"))


class TableTest(unittest.TestCase):

    def setUp(self):
        self.blocks = list(blocksOf("a.md", "# T\n```sh\ntrue\n```\n`sh -c true`\n"))
        self.table = [("a.md", "T", "sh -c true", Impossible("x")), ("a.md", "T", "sh 1", Impossible("y"))]

    def test_right(self):
        tasks, mistakes = matched(self.blocks, self.table)
        self.assertEqual(([(block.text, action.reason) for block, action in tasks], mistakes), ([("sh -c true", "x"), ("true\n", "y")], []))

    def test_block_without_rule(self):
        for missing, place in ((0, "a.md:5"), (1, "a.md:3")):
            table = self.table[:missing] + self.table[missing + 1:]
            mistake, = matched(self.blocks, table)[1]
            self.assertTrue(mistake.startswith(place + ": the table has no rule for a.md | T | "), mistake)

    def test_rule_without_block(self):
        for k in range(2):
            mistake, = matched(self.blocks[:k] + self.blocks[k + 1:], self.table)[1]
            self.assertIn("a rule for what is not there: " + self.blocks[k].key.replace("`", ""), mistake)

    def test_two_rules(self):
        mistake, = matched(self.blocks, self.table + self.table[:1])[1]
        self.assertIn("more than one rule for " + keyOf(self.table[0]), mistake)


class ActionCase(unittest.TestCase):

    def setUp(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        os.makedirs(os.path.join(folder, "build", "bin"))
        self.place = Place(PROJECT, folder)
        self.addCleanup(self.place.close)

    def block(self, code, language="sh", document="a.md"):
        block, = blocksOf(document, "# T\n```{}\n{}\n```\n".format(language, code))
        return block

    def good(self, action, code, language="sh"):
        return action.run(self.place, self.block(code, language))

    def bad(self, words, action, code, language="sh"):
        with self.assertRaisesRegex(Wrong, words):
            action.run(self.place, self.block(code, language))


class ShellTest(ActionCase):

    def test_commands(self):
        self.assertIn("two\n", self.good(Shell(), "echo one | grep one\necho two"))
        self.bad("exit code 1", Shell(), "false\ntrue")
        self.bad("nonsense", Shell(), "nonsense --option")
        self.bad("exit code", Shell(), "sh samples/quickstart.sh --unknown")
        self.bad("does not know", Shell(), "echo '{}'".format(UNUSED))
        self.bad("parameter not set|unbound", Shell(variables={}), "set -u\necho $nothing_of_that_name")

    def test_expectations(self):
        self.good(Shell(prints=("^a$",), leaves=("file",), after="[ -f file ]"), "echo a\ntouch file")
        self.bad("is without", Shell(prints=("^b$",)), "echo a")
        self.bad("leaves no none", Shell(leaves=("none",)), "echo a")
        self.bad("exit code", Shell(after="[ -f none ]"), "echo a")
        self.bad("exit code", Shell(before="false"), "echo a")
        self.bad("exit code", Shell(always="touch always"), "false")
        self.assertTrue(os.path.exists(self.place.folder("clone", "always")))

    def test_names(self):
        self.assertIn(self.place.folder("prefix"), self.good(Shell(names={"<prefix>": "{work}/prefix"}), "echo <prefix>"))
        self.bad("is not in the block", Shell(names={"<prefix>": "/"}), "echo <Prefix>")

    def test_elsewhere(self):
        other = Elsewhere("modules/usac/misc/consumer/check.sh", "documentation")
        self.assertNotIn("false", self.good(Shell(elsewhere={"false --x": other}), "echo a\nfalse \\\n    --x  # why"))
        self.bad("not in the block: false", Shell(elsewhere={"false": other}), "echo a")
        self.bad("no check or test nothing", Shell(elsewhere={"false": other._replace(name="nothing")}), "false")

    def test_service(self):
        self.good(Shell(service=True, more=" 100"), "sleep")
        self.assertIsNone(self.place.services[0].poll())
        self.bad("no such option", Shell(service=True), "sh -c 'echo no such option; exit 1'")
        self.place.close()
        self.assertIsNotNone(self.place.services[0].poll())

    def test_packages(self):
        self.good(Shell(), "apt install cmake \\\n    python3-numpy\nsudo apt install g++")
        self.bad("no-such-package is not installed", Shell(), "apt install cmake no-such-package")
        self.bad("exit code", Shell(), "touch none.deb; sudo apt install ./none.deb")
        self.bad("not a command for a document: sudo touch", Shell(), "sudo touch file")
        self.bad("a package is missing", Shell(), "apt-get install cmake")
        self.bad("nothing to install", Shell(), "apt install")


class OtherActionsTest(ActionCase):

    def test_elsewhere(self):
        check = Elsewhere("modules/usac/misc/consumer/check.sh", "documentation", ("--target usac_docs",))
        self.good(check, "cmake --build build --target usac_docs")
        self.bad("is not in both", check, "cmake --build build --target usac_pages")
        self.bad("is not in both", check._replace(words=("--pages",)), "cmake --pages")
        self.bad("is not there", check._replace(file="check.sh"), "cmake --target usac_docs")
        self.bad("no reason", Impossible(""), "true")

    def test_printed(self):
        self.place.printed["T | sh 1"] = "\n12 pairs in 0.5 s: good\n"
        self.good(Printed("T | sh 1", free=("in .* s",)), "12 pairs in 9.5 s: good", "")
        self.good(Printed("T | sh 1", tolerance=0.2), "11 pairs in 0.45 s: good", "")
        self.bad("has no line as", Printed("T | sh 1"), "11 pairs in 0.5 s: good", "")
        self.bad("has no line as", Printed("T | sh 1", free=(".*",)), "12 pairs in 0.5 s: bad", "")
        self.bad("has not run", Printed("T | sh 2"), "12 pairs in 0.5 s: good", "")
        self.good(Printed("", before="echo 3 pairs"), "3 pairs", "")

    def test_numbers(self):
        block = self.block("echo row: 1.004; echo row: 0.55", document="doc/contributing.md")
        action = Numbers(r"C\+\+(\d+), `\.clang", r"\nrow: ([\d.]+)", 1)
        with self.assertRaisesRegex(Wrong, "has .*1.004.*, the document"):
            action.run(self.place, block)
        with self.assertRaisesRegex(Wrong, "the document has no"):
            action._replace(text="nothing of (.*) that kind").run(self.place, block)
        block = block._replace(text="echo row: 10.5\n")
        self.assertIn("10.5", action._replace(text=r"C\+\+(\d+), `\.clang").run(self.place, block))
        with self.assertRaises(Wrong):
            action._replace(text=r"C\+\+(\d+), `\.clang", tolerance=0.1).run(self.place, block)

    def test_python(self):
        os.makedirs(self.place.folder("clone", "env", "bin"))
        os.symlink("/usr/bin/python3", self.place.folder("clone", "env", "bin", "python3"))
        self.good(Python(before="b = 2", after="require(a == 3)"), "a = b + 1", "python")
        self.bad('File "a.md", line 4', Python(), "a = 1\nnothing(a)", "python")
        self.bad("require.a == 2", Python(after="require(a == 2)"), "a = 1", "python")
        self.bad("SyntaxError", Python(), "a = ", "python")
        self.bad("exit code 3", Python(), "import sys; sys.exit(3)", "python")

    def test_cmake(self):
        self.good(CMake(build=False), "target_link_libraries(program m)", "cmake")
        self.bad("no_such_package", CMake(build=False), "find_package(no_such_package REQUIRED)", "cmake")
        self.bad("does not know", CMake(("-DNO_SUCH_OPTION=ON",), build=False), "target_link_libraries(program m)", "cmake")

    def test_lines_of_a_frame(self):
        source = Cpp(top='#include "x.hpp"', within={"int a;": "a = 2;"}).source(self.block("#include <y>\nint a;  // b\nint c;", "cpp"))
        self.assertIn('#include "x.hpp"\n#include <y>\n', source)
        self.assertIn('#line 3 "a.md"\n\nint a;   a = 2;\nint c;\n', source)
        with self.assertRaisesRegex(Wrong, "has no line"):
            Cpp(within={"int b;": "b = 2;"}).source(self.block("int a;", "cpp"))


@unittest.skipUnless(CHECKS, "USAC_DOCUMENTS_CHECKS is not set")
class ProgramsTest(unittest.TestCase):
    """Tests with C++ code and with whole documents: which blocks are reported as passed and failed."""

    def test_code(self):
        folder = os.path.join(CHECKS, "documents_test")
        os.makedirs(folder, exist_ok=True)
        if not os.path.islink(os.path.join(folder, "build")):
            os.symlink(os.path.join(os.path.abspath(CHECKS), "build"), os.path.join(folder, "build"))
        place = Place(PROJECT, folder)
        place.build = os.path.realpath(place.build)
        blocks = list(blocksOf("a.md", "# T\n```cpp\nint a = 1;\n```\n```cpp\nint unused = 1;\n```\n```cpp\nint a = 2;\n```\n```sh\nfalse\n```\n"))
        actions = [Cpp(after="REQUIRE(a == 1);"), Cpp(), Cpp(after="REQUIRE(a == 1);"), Shell()]
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            failed = run(place, list(zip(blocks, actions)))
        self.assertEqual(failed, 3, out.getvalue())
        self.assertIn("PASSED a.md:3: a.md | T | cpp 1", out.getvalue())
        self.assertRegex(out.getvalue(), "a.md:6:5: error: unused variable")
        for place in ("a.md:6", "a.md:9", "a.md:12"):
            self.assertIn("FAILED " + place + ": ", out.getvalue())

    def test_main(self):
        """In a copy of the project, README.md gets a new block without a rule. documents.py must fail
        and name this block."""
        with tempfile.TemporaryDirectory() as folder:
            for name in os.listdir(PROJECT):
                if name not in (".git", "README.md"):
                    os.symlink(os.path.join(PROJECT, name), os.path.join(folder, name))
            with open(os.path.join(PROJECT, "README.md"), encoding="utf-8") as file:
                text = file.read()
            with open(os.path.join(folder, "README.md"), "w", encoding="utf-8") as file:
                file.write(text + "\n```sh\necho new\n```\n")
            os.makedirs(os.path.join(folder, "work", "build"))
            program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "documents.py")
            run = subprocess.run([sys.executable, program, folder, os.path.join(folder, "work"), "", "| pkg-config "],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertRegex(run.stdout, r"FAILED README.md:\d+: the table has no rule for README.md \| Documents and license \| sh 1\n")


if __name__ == "__main__":
    unittest.main()
