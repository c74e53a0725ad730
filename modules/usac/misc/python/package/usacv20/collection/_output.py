# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Output of the commands."""

from __future__ import annotations

import os
import sys
import typing


def write(text: str, stream: typing.Optional[typing.TextIO] = None) -> None:
    """Writes a text to stdout, or to another stream. If the program that reads the stream has ended
    (`| head -1`), further output is discarded, and the run continues."""
    out = sys.stdout if stream is None else stream
    try:
        out.write(text)
        out.flush()
    except BrokenPipeError:
        # The descriptor is redirected to the null device, because Python flushes the stream again at
        # exit.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, out.fileno())
        os.close(nowhere)


def say(line: str) -> None:
    write(line + "\n")
