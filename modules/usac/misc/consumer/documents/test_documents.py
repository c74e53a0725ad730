#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of documents.py, which checks the code in the documents: wrong commands, wrong code and blocks
without a rule must be reported as failures."""

import os
import shutil
import tempfile
import unittest

from actions import UNUSED, Cpp, Place, Python, Shell, Skipped, Wrong
from blocks import DocumentError, blocksOf, commandsOf
from documents import matched

PROJECT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[".."] * 5))
TEXT = """# Title

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
"""


class DocumentsTest(unittest.TestCase):

    def block(self, code, language="sh"):
        block, = blocksOf("a.md", "# T\n```{}\n{}\n```\n".format(language, code))
        return block

    def test_blocks(self):
        self.assertEqual([(b.line, b.heading, b.language, b.number, b.text) for b in blocksOf("a.md", TEXT)], [
            (4, "Title", "sh", 1, "echo one\n"), (13, "Part", "python", 1, "x = 1\n  # indented\n"),
            (18, "Part", "cpp", 1, "int a;\n"), (22, "Part", "sh", 1, "echo two\n")])
        for text, words in (("```sh\necho\n", "a.md:1: a block without an end"), ("```perl\n```\n", "perl")):
            with self.assertRaisesRegex(DocumentError, words):
                list(blocksOf("a.md", text))
        self.assertEqual(commandsOf("# all\na \\\n    --b  # c\n\nd '#e' f\n"), ["a --b", "d '#e' f"])

    def test_table(self):
        blocks = list(blocksOf("a.md", TEXT))
        table = [("a.md", block.heading, "{} {}".format(block.language, block.number), Skipped("x")) for block in blocks]
        self.assertEqual([len(part) for part in matched(blocks, table)], [4, 0])
        self.assertIn("a.md:4: the table has no rule for a.md | Title | sh 1", matched(blocks, table[1:])[1])
        self.assertIn("the table has a rule for what is not there: a.md | Title | sh 1", matched(blocks[1:], table)[1])

    def test_actions(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        place = Place(PROJECT, folder)
        os.makedirs(place.folder("clone", "env", "bin"))
        os.symlink("/usr/bin/python3", place.folder("clone", "env", "bin", "python3"))
        Shell(always="[ -f file ]").run(place, self.block("echo b\ntouch file"))
        Python(before="b = 2").run(place, self.block("a = b + 1", "python"))
        for words, action, code in (
                ("exit code 1", Shell(), "false\ntrue"), ("does not know", Shell(), "echo '{}'".format(UNUSED)),
                ("exit code 1", Shell(always="[ -f none ]"), "true"),
                ("no-such-package is not installed", Shell(), "apt install cmake no-such-package"),
                ("not in the block", Shell(without=("false",)), "true"), ('File "a.md", line 4', Python(), "a = 1\nnothing(a)")):
            with self.assertRaisesRegex(Wrong, words):
                action.run(place, self.block(code))

    def test_lines_of_a_frame(self):
        source = Cpp(top='#include "x.hpp"', within={"int a;": "a = 2;"}).source(self.block("#include <y>\nint a;  // b\nint c;", "cpp"))
        self.assertIn('#include "x.hpp"\n#include <y>\n', source)
        self.assertIn('#line 3 "a.md"\n\nint a;   a = 2;\nint c;\n', source)
        with self.assertRaisesRegex(Wrong, "has no line"):
            Cpp(within={"int b;": "b = 2;"}).source(self.block("int a;", "cpp"))


if __name__ == "__main__":
    unittest.main()
