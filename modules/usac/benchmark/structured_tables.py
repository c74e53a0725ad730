# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Replaces tables of a document with the output of the commands that precede them.

A section of the document begins with a heading "## ". A section can have a line that begins with
"Commit `...`" and blocks of shell commands that begin with usac_structured. The tables between a block
and the next text are the output of the block's commands."""

import re
import shlex

PROGRAM = "usac_structured"
BLOCK = re.compile(r"^```sh\n(" + PROGRAM + r" .*?)^```\n", re.M | re.S)
COMMIT = re.compile(r"^Commit `[^`]+`(, of an earlier state)?", re.M)


def sections(body):
    """Returns the sections as [(heading, text with the heading)]. The text before the first heading is
    a section with the heading ""."""
    parts = re.split(r"^(?=## )", body, flags=re.M)
    return [(part[3:part.index("\n")] if part.startswith("## ") else "", part) for part in parts]


def commands(block):
    """Returns [[argument, ...]], the commands of a block without the program's name."""
    lines = [line for line in block.replace("\\\n", " ").splitlines() if line.strip()]
    return [shlex.split(line)[1:] for line in lines]


def tables_of(output):
    """Returns the tables in the output of a command, separated by blank lines."""
    return "\n\n".join(table.strip() for table in re.findall(r"(?:^\|.*\n)+", output + "\n", re.M))


def measured(section, commit, run):
    """Returns the text of a section with new tables and the commit `commit`. run(arguments) must return
    the output of the program."""
    result, end = "", 0
    for match in BLOCK.finditer(section):
        result += section[end:match.end()]
        old = re.match(r"\n*(?:\|.*\n+)*", section[match.end():])
        end = match.end() + old.end()
        result += "\n%s\n\n" % "\n\n".join(tables_of(run(arguments)) for arguments in commands(match.group(1)))
    return COMMIT.sub("Commit `%s`" % commit, result + section[end:], count=1)


def renewed(body, names, commit, run):
    """Returns the document with new tables in the sections whose headings begin with one of `names`; in
    all sections if there are no names. Raises ValueError if a name fits no section with commands."""
    known = [heading for heading, text in sections(body) if BLOCK.search(text)]
    unknown = [name for name in names if not any(heading.startswith(name) for heading in known)]
    if unknown:
        raise ValueError("no section with commands of %s begins with: %s" % (PROGRAM, ", ".join(unknown)))
    return "".join(measured(text, commit, run) if heading in known and (not names or heading.startswith(tuple(names))) else text
                   for heading, text in sections(body))
