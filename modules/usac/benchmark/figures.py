# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Checks and fills in the figures (numbers and tables) that documents quote from measurements.

A measurement is a file doc/measurements/NAME.md: a stamp (command, commit, date, machine and so on)
and a body. In the body and in the documents that quote it, a block is the text between a comment
`figures: NAME/PART` and a comment `figures: end`. The text of a block in a document must equal that in
the file of the measurement; measure.py writes both.

test_data/hashes.txt has hashes of the results of the estimator. The stamp of a measurement has a digest
of those rows of hashes.txt that belong to the presets and data sets of the measurement. If this digest
differs from that of the current rows, results have changed since the measurement, which then counts
as older."""

import glob
import hashlib
import json
import os
import re

FOLDER = "doc/measurements"
HASHES = "test_data/hashes.txt"
PYTHON_HASHES = "modules/usac/misc/python/test/hashes.json"
INDEX = FOLDER + "/all.md"  # the list of all measurements
DOCUMENTS = ("README.md", "doc/*.md", INDEX, "modules/usac/README.md", "modules/usac/tutorials/**/*.markdown")
BEGIN = re.compile(r"(?<!`)<!-- figures: (\S+) -->")
END = "<!-- figures: end -->"
STAMP = ("command", "commit", "date", "machine", "OpenCV", "repeats", "results", "text")


class FiguresError(ValueError):
    pass


def short_hash(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def read_text(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write_text(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


class Rows:
    """The rows of hashes.txt that a measurement depends on: those of the given data sets (`sets`) and
    presets (`params`). An empty tuple selects all data sets or presets. Lines about the machine that
    made the file are never included."""

    def __init__(self, sets=(), params=()):
        self.sets, self.params = sets, params

    def __contains__(self, name):
        a, _, b = name.partition(":")
        return (not self.sets or a in self.sets) and (not self.params or b in self.params)

    def digest(self, hashes):
        """Returns the digest of these rows, given the text of hashes.txt. Raises FiguresError if there
        is no such row."""
        rows = [line for line in hash_rows(hashes) if line.split()[0] in self]
        if not rows:
            raise FiguresError("%s: no row of the sets %s with the parameters %s" % (HASHES, self.sets, self.params))
        return short_hash("\n".join(rows))


def hash_rows(hashes):
    """Returns the rows `set:parameters iterations inliers hash hash` of hashes.txt, sorted by name."""
    return sorted(line for line in hashes.splitlines() if re.fullmatch(r"[^\s:#]+:\S+( \S+){4}", line))


def find_blocks(text, file):
    """Returns [(name, start, end), ...] of all blocks: start and end of the text between the marks."""
    found, position = [], 0
    for begin in BEGIN.finditer(text):
        if begin.group(1) == "end":
            if not found or found[-1][2] != begin.start():
                raise FiguresError("%s: `figures: end` without a beginning" % file)
            continue
        end = text.find(END, begin.end())
        following = BEGIN.search(text, begin.end())
        if end < 0 or following.start() != end:
            raise FiguresError("%s: the block %s has no end" % (file, begin.group(1)))
        found.append((begin.group(1), begin.end(), end))
    return found


def blocks_of(text, file):
    """Returns {name: text} of the blocks."""
    return {name: text[start:end].strip() for name, start, end in find_blocks(text, file)}


def block(name, text):
    """Returns a block with its marks, as it appears in the body of a measurement."""
    return "<!-- figures: %s -->\n\n%s\n\n%s\n" % (name, text.strip(), END)


def inline_block(name, text):
    return "<!-- figures: %s -->%s%s" % (name, text, END)


def filled(text, file, contents):
    """Returns the text of a document in which the blocks named in `contents` have their new text. A
    block within a line stays within this line unless its new text has several lines."""
    for name, start, end in reversed(find_blocks(text, file)):
        if name in contents:
            new = contents[name].strip()
            if "\n" in text[start:end] or "\n" in new:
                new = "\n\n%s\n\n" % new
            text = text[:start] + new + text[end:]
    return text


class Measurement:
    """A file of doc/measurements. `stamp` is {key of STAMP: text}."""

    def __init__(self, name, title, stamp, body):
        self.name, self.title, self.stamp, self.body = name, title, stamp, body.strip() + "\n"

    @staticmethod
    def file(root, name):
        return os.path.join(root, FOLDER, name + ".md")

    @classmethod
    def read(cls, root, name):
        text = read_text(cls.file(root, name))
        head = re.match(r"# (.*)\n\n\| measurement \| (\S+) \|\n\|---\|---\|\n((?:\| [^|\n]+ \| [^|\n]+ \|\n)+)\n", text)
        if not head or head.group(2) != name:
            raise FiguresError("%s/%s.md: no stamp" % (FOLDER, name))
        stamp = dict(line.strip("| ").split(" | ", 1) for line in head.group(3).splitlines())
        missing = [key for key in STAMP if key not in stamp]
        if missing:
            raise FiguresError("%s/%s.md: no %s in the stamp" % (FOLDER, name, ", ".join(missing)))
        return cls(name, head.group(1), stamp, text[head.end():])

    def write(self, root):
        self.stamp["text"] = short_hash(self.body)
        rows = "".join("| %s | %s |\n" % (key, self.stamp[key]) for key in STAMP)
        write_text(self.file(root, self.name),
                   "# %s\n\n| measurement | %s |\n|---|---|\n%s\n%s" % (self.title, self.name, rows, self.body))

    def as_written(self):
        return self.stamp["text"] == short_hash(self.body)

    def blocks(self):
        return blocks_of(self.body, "%s/%s.md" % (FOLDER, self.name))


def documents(root):
    """Returns the paths, relative to the root, of the documents that have blocks."""
    paths = [path for pattern in DOCUMENTS for path in sorted(glob.glob(os.path.join(root, pattern), recursive=True))]
    return [os.path.relpath(path, root) for path in paths if BEGIN.search(read_text(path))]


class Project:
    """All measurements of the project, and the documents that quote them. `rows` is {name of a
    measurement: its Rows}. `current` has the names of measurements that must not be older than the
    last change of results if README.md quotes them."""

    def __init__(self, root, rows, current):
        self.root, self.rows, self.current = root, rows, current
        self.hashes = read_text(os.path.join(root, HASHES))
        self.mistakes, self.measurements = [], {}
        for path in sorted(glob.glob(os.path.join(root, FOLDER, "*.md"))):
            name = os.path.splitext(os.path.basename(path))[0]
            if name == "all":
                continue
            try:
                self.measurements[name] = Measurement.read(root, name)
                if any(block.split("/")[0] != name for block in self.measurements[name].blocks()):
                    raise FiguresError("%s/%s.md: blocks of another measurement" % (FOLDER, name))
                if name not in rows:
                    raise FiguresError("%s/%s.md: measure.py has no such measurement" % (FOLDER, name))
                if not self.measurements[name].as_written():
                    raise FiguresError("%s/%s.md: changed by hand" % (FOLDER, name))
            except FiguresError as error:
                self.mistakes.append(str(error))

    def is_older(self, name):
        """Returns whether results have changed since the measurement."""
        return name in self.rows and self.measurements[name].stamp["results"] != self.rows[name].digest(self.hashes)

    def older(self):
        return [name for name in self.measurements if self.is_older(name)]

    def index(self):
        """Returns a table of all measurements, for the file INDEX."""
        lines = ["| measurement | what | OpenCV | commit | date | results |", "|---|---|---|---|---|---|"]
        for name, m in self.measurements.items():
            lines.append("| [%s](%s.md) | %s | %s | %s | %s | %s |" % (
                name, name, m.title, m.stamp["OpenCV"], m.stamp["commit"], m.stamp["date"],
                "older" if self.is_older(name) else "current"))
        return "\n".join(lines)

    def contents(self):
        """Returns {name: text} of all blocks that a document can quote."""
        found = {"hashes/cpp": str(len(hash_rows(self.hashes))),
                 "hashes/python": str(len(json.loads(read_text(os.path.join(self.root, PYTHON_HASHES))))),
                 "index": self.index()}
        for m in self.measurements.values():
            found.update(m.blocks())
        return found

    def fill(self):
        """Writes the blocks of all documents; returns the names of the changed documents."""
        contents, changed = self.contents(), []
        for document in documents(self.root):
            path = os.path.join(self.root, document)
            before = read_text(path)
            after = filled(before, document, contents)
            if after != before:
                write_text(path, after)
                changed.append(document)
        return changed

    def check(self):
        """Returns a message for each mistake: damaged or unknown files of measurements or, if there
        are none, quotations that differ from the measurement, and quotations in README.md of
        measurements in `current` that are older than the results."""
        if self.mistakes:
            return self.mistakes
        contents, mistakes = self.contents(), []
        for document in documents(self.root):
            try:
                text = read_text(os.path.join(self.root, document))
                quoted = [(name, text[start:end].strip()) for name, start, end in find_blocks(text, document)]
            except FiguresError as error:
                mistakes.append(str(error))
                continue
            for name, text in quoted:
                if name not in contents:
                    mistakes.append("%s: no measurement has the block %s" % (document, name))
                elif text != contents[name].strip():
                    mistakes.append("%s: the block %s is not what was measured (measure.py --fill)" % (document, name))
            names = {name.split("/")[0] for name, _ in quoted}
            for name in sorted(names & set(self.current) & set(self.measurements)) if document == "README.md" else ():
                if self.is_older(name):
                    mistakes.append("%s: its figures of %s are older than the last change of %s (measure.py %s)" %
                                    (document, name, HASHES, name))
        return mistakes
