# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Shows the progress of a run on stderr."""

from __future__ import annotations

import sys
from typing import Any, Optional

from ._optional import need
from ._output import write
from ._pair import CollectionError

_LINES = 20  # maximum number of faults that are shown


class Progress:
    """A progress bar with the number of pairs per second and the remaining time; lines of text are
    printed above the bar.

    total -- number of pairs
    wanted -- True: shows a bar, and raises CollectionError if tqdm is missing; None: shows a bar if
    stderr is a terminal and tqdm is installed; False: prints lines only"""

    def __init__(self, total: int, wanted: Optional[bool] = None) -> None:
        self._bar: Any = None
        self._lines = 0
        if wanted is False or wanted is None and not sys.stderr.isatty():
            return
        try:
            tqdm = need("tqdm", "for a progress bar")
        except CollectionError:
            if wanted:
                raise
            return
        self._bar = tqdm.tqdm(total=total, unit=" pairs", file=sys.stderr, dynamic_ncols=True, smoothing=0.05)

    def skip(self, pairs: int) -> None:
        """Counts pairs of an earlier run; they do not affect the estimate of the remaining time."""
        if self._bar is not None:
            self._bar.initial += pairs
            self._bar.update(pairs)

    def advance(self, pairs: int) -> None:
        if self._bar is not None:
            self._bar.update(pairs)

    def say(self, line: str) -> None:
        if self._bar is None:
            write(line + "\n", sys.stderr)
        else:
            self._bar.write(line, file=sys.stderr)

    def complain(self, reason: str) -> None:
        """Shows a line about a fault; only the first _LINES faults are shown."""
        self._lines += 1
        if self._lines <= _LINES:
            self.say("cannot be read: " + reason)
        elif self._lines == _LINES + 1:
            self.say("more pairs cannot be read; the report lists them")

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
