# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds blocks of code in a Markdown document (between ``` or @code and @endcode)."""

import re
from typing import Dict, Iterator, List, NamedTuple, Tuple

LANGUAGES = {"": "text", "txt": "text", "py": "python", "sh": "sh", "cpp": "cpp", "cmake": "cmake", "python": "python"}


class DocumentError(Exception):
    """Raised if a document has a block that cannot be read."""


class Block(NamedTuple):
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
        """The key by which the table of rules names the block. It does not change when the code changes."""
        return "{} | {} | {} {}".format(self.document, self.heading, self.language, self.number)

    @property
    def name(self) -> str:
        """The key in a form that can be a file name."""
        return re.sub(r"[^a-z0-9]+", "_", self.key.replace("|", "_").lower()).strip("_")


def blocksOf(document: str, text: str) -> Iterator[Block]:
    """Yields all blocks in the order of the document, except those of plain text."""
    lines = text.split("\n")
    counts: Dict[Tuple[str, str], int] = {}
    heading, k = "", 0
    while k < len(lines):
        line = lines[k]
        fence = re.match(r"\s*(```+|~~~+)\s*(\w*)\s*$|\s*@code(?:\{\.(\w+)\})?\s*$", line)
        title = re.match(r"#+ +(.*?)(?: *\{#.*\})?$", line)
        if not title and k + 1 < len(lines) and line.strip() and re.match(r"(=+|-+)$", lines[k + 1]) and "|" not in line:
            title = re.match(r"(.*?)(?: *\{#.*\})?$", line)
        if title:
            heading = title.group(1)
        k += 1
        if not fence:
            continue
        language = fence.group(2) or fence.group(3) or ""
        if language not in LANGUAGES:
            raise DocumentError("{}:{}: a block in {!r}".format(document, k, language))
        language, first, indent = LANGUAGES[language], k, len(line) - len(line.lstrip())
        end = re.compile(r"\s*{}\s*$".format(fence.group(1) or "@endcode"))
        while k < len(lines) and not end.match(lines[k]):
            k += 1
        if k == len(lines):
            raise DocumentError("{}:{}: a block without an end".format(document, first))
        code = "".join(line[indent:] + "\n" for line in lines[first:k])
        k += 1
        if language != "text":
            counts[heading, language] = counts.get((heading, language), 0) + 1
            yield Block(document, first + 1, heading, language, counts[heading, language], code)


def commandsOf(text: str) -> List[str]:
    """Returns the commands of a shell block. Continued lines are joined, and comments are removed."""
    joined = re.sub(r"\\\n\s*", "", text)
    lines = (re.sub(r"(^|\s+)#.*$", "", line).strip() for line in joined.split("\n"))
    return [line for line in lines if line]
