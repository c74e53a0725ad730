# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Lets Ctrl-C end the collection tool without a traceback while its modules are being imported, which takes 0.2 seconds. The
package imports this module first."""

import os
import signal
import sys
from typing import List


def _isTool() -> bool:
    given: List[str] = getattr(sys, "orig_argv", None) or getattr(sys, "argv", [])  # argv does not tell the module after -m
    module = given[given.index("-m") + 1:][:1] if "-m" in given else []
    return module == [__name__.rpartition(".")[0] + ".collection"] or any(os.path.basename(word) == "usacv20-collection" for word in given[:2])


_silent = _isTool() and signal.getsignal(signal.SIGINT) is signal.default_int_handler
if _silent:
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def listen() -> None:
    """Makes Ctrl-C raise KeyboardInterrupt again; called when the tool begins its work."""
    if _silent:
        signal.signal(signal.SIGINT, signal.default_int_handler)
