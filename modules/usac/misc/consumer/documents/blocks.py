# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds blocks of code in a Markdown document (between ``` or @code and @endcode), and commands within
its text."""

import re
from typing import Iterator, List, NamedTuple

LANGUAGES = {"": "text", "txt": "text", "py": "python", "sh": "sh", "cpp": "cpp", "cmake": "cmake", "python": "python"}
# Code within the text (`...`) counts as a command if it begins like this. Most of these programs must
# have at least one argument, because their name alone is not a command to run.
COMMAND = re.compile(r"(?:\S*/)?(?:cmake|python3|pip3?|pkg-config|apt|sudo|sh|bash|colmap|dask-\w+|(?:example_)?usac_\w+) \S"
                     r"|(?:pairs|verify|report) \S|\S*\.ci/run$|dask-scheduler$")


class DocumentError(Exception):
    """Raised if a document has a block that cannot be read."""


class Block(NamedTuple):
    """A block of code, or a command within the text; the language of a command is "inline"."""

    document: str
    line: int  # number of the first line of the code, counted from 1
    heading: str  # the last heading before the block
    language: str
    number: int  # number of the block among those of the same language below the heading, counted from 1
    text: str

    @property
    def place(self) -> str:
        return "{}:{}".format(self.document, self.line)

    @property
    def key(self) -> str:
        """The key by which the table of rules names the block. The key of a block (not of a command)
        does not change when its code changes."""
        if self.language == "inline":
            return "{} | {} | `{}`".format(self.document, self.heading, self.text)
        return "{} | {} | {} {}".format(self.document, self.heading, self.language, self.number)

    @property
    def name(self) -> str:
        """The key in a form that can be a file name."""
        return re.sub(r"[^a-z0-9]+", "_", self.key.replace("|", "_").lower()).strip("_")


def blocksOf(document: str, text: str) -> Iterator[Block]:
    """Yields all blocks and the commands within the text in the order of the document."""
    lines = text.split("\n")
    counts = {}
    heading, prose, start = "", [], 0

    def numbered(heading: str, language: str, line: int, code: str) -> Block:
        counts[heading, language] = counts.get((heading, language), 0) + 1
        return Block(document, line, heading, language, counts[heading, language], code)

    def commands(heading: str, prose: List[str], start: int) -> Iterator[Block]:
        text = "\n".join(prose)
        for span in re.finditer(r"(?<!`)`([^`]+)`(?!`)", text):
            command = " ".join(span.group(1).split())
            if COMMAND.match(command):
                yield numbered(heading, "inline", start + 1 + text[:span.start()].count("\n"), command)

    k = 0
    while k < len(lines):
        line = lines[k]
        fence = re.match(r"\s*(```+|~~~+)\s*(\w*)\s*$|\s*@code(?:\{\.(\w+)\})?\s*$", line)
        title = re.match(r"#+ +(.*?)(?: *\{#.*\})?$", line)
        if not title and k + 1 < len(lines) and line.strip() and re.match(r"(=+|-+)$", lines[k + 1]) and "|" not in line:
            title = re.match(r"(.*?)(?: *\{#.*\})?$", line)
        if fence or title:
            yield from commands(heading, prose, start)
            prose, start = [], k + 1
        if title:
            heading = title.group(1)
        if not fence:
            prose.append(line if not title else "")
            start = k if title else start
            k += 1
            continue
        language = fence.group(2) or fence.group(3) or ""
        if language not in LANGUAGES:
            raise DocumentError("{}:{}: a block in {!r}".format(document, k + 1, language))
        indent = len(line) - len(line.lstrip())
        end = re.compile(r"\s*{}\s*$".format(fence.group(1) or "@endcode"))
        code, first = [], k + 1
        k = first
        while k < len(lines) and not end.match(lines[k]):
            code.append(lines[k][indent:])
            k += 1
        if k == len(lines):
            raise DocumentError("{}:{}: a block without an end".format(document, first))
        yield numbered(heading, LANGUAGES[language], first + 1, "\n".join(code) + "\n")
        k += 1
        start = k
    yield from commands(heading, prose, start)


def commandsOf(text: str) -> List[str]:
    """Returns the commands of a shell block. Continued lines are joined, and comments are removed.
    """
    joined = re.sub(r"\\\n\s*", "", text)
    lines = (re.sub(r"(^|\s+)#.*$", "", line).strip() for line in joined.split("\n"))
    return [line for line in lines if line]
