# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Prints the output of the commands."""

from __future__ import annotations

import os
import sys
import typing


def write(text: str, stream: typing.Optional[typing.TextIO] = None) -> None:
    """Writes to stdout, or to another stream. If nobody reads it any more (`| head -1`) what follows goes nowhere, and the work goes
    on."""
    out = sys.stdout if stream is None else stream
    try:
        out.write(text)
        out.flush()
    except BrokenPipeError:
        # The descriptor is replaced, as Python flushes the stream once more when it ends.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, out.fileno())
        os.close(nowhere)


def say(line: str) -> None:
    write(line + "\n")
