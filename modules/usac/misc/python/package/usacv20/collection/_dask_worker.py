# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Loaded by the workers of a local Dask cluster, which then ignore Ctrl-C: in a terminal, Ctrl-C
reaches all processes, but only the main process must handle it."""

from __future__ import annotations

import signal
from typing import Any


def dask_setup(worker: Any) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
