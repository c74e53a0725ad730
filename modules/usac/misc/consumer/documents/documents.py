#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs the blocks of commands and of code that the documents show. Each block is run in a folder with
the files that the text assumes. A table (table.py) has a rule for each block, with the action to run. A
block without a rule, or a rule without a block, is a failure.

usage: documents.py PROJECT CHECKS [OPENCV [WORD...]]

PROJECT is the checkout. CHECKS is the working directory of check.sh with the library's build and
installation. OPENCV is a build tree of OpenCV with the module, or an empty text. With WORDs, only
blocks whose keys contain all these words run. The last line of the output is "<N> passed, <M> failed"."""

import os
import sys
import time
from typing import Any, List, Sequence, Tuple

from actions import Cpp, Place, Skipped, Wrong, preparePrograms
from blocks import Block, DocumentError, blocksOf
from table import DOCUMENTS, TABLE

Rule = Tuple[str, str, str, Any]


def keyOf(rule: Rule) -> str:
    document, heading, what, _ = rule
    return "{} | {} | {}".format(document, heading, what)


def matched(blocks: Sequence[Block], table: Sequence[Rule]) -> Tuple[List[Tuple[Block, Any]], List[str]]:
    """Returns the blocks with their actions in the order of the table, and a list of the mistakes
    in the table."""
    known, keys = {block.key: block for block in blocks}, [keyOf(rule) for rule in table]
    mistakes = ["{}: the table has no rule for {}".format(block.place, block.key) for block in blocks if block.key not in keys]
    mistakes += ["the table has a rule for what is not there: " + key for key in keys if key not in known]
    return [(known[key], rule[3]) for rule, key in zip(table, keys) if key in known], mistakes


def read(project: str, documents: Sequence[str]) -> List[Block]:
    blocks = []
    for document in documents:
        with open(os.path.join(project, document), encoding="utf-8") as file:
            blocks += blocksOf(document, file.read())
    return blocks


def run(place: Place, tasks: Sequence[Tuple[Block, Any]]) -> int:
    """Runs the actions; returns the number of failures."""
    failed = 0
    programs = [task for task in tasks if isinstance(task[1], Cpp)]
    if programs:
        preparePrograms(place, programs)
    for block, action in tasks:
        start = time.time()
        try:
            action.run(place, block)
            how = action.reason if isinstance(action, Skipped) else "{:.1f} s".format(time.time() - start)
            print("PASSED {}: {} ({})".format(block.place, block.key, how), flush=True)
        except Wrong as error:
            failed += 1
            print("{}\nFAILED {}: {}".format(error, block.place, block.key), flush=True)
    return failed


def main(project: str, checks: str, opencv: str = "", *words: str) -> int:
    try:
        tasks, mistakes = matched(read(project, DOCUMENTS), TABLE)
    except DocumentError as error:
        tasks, mistakes = [], [str(error)]
    tasks = [task for task in tasks if all(word in task[0].key for word in words)]
    for mistake in mistakes:
        print("FAILED " + mistake)
    failed = len(mistakes)
    try:
        failed += run(Place(project, checks, opencv), tasks)
    except Wrong as error:
        print(error)
        failed += 1
    print("{} passed, {} failed".format(len(tasks) + len(mistakes) - failed, failed))
    return 1 if failed or not tasks else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
