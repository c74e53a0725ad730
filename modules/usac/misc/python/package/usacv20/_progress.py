# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reports the progress of estimations to a function, which can stop them."""

from __future__ import annotations

import typing
from typing import Any, Optional

import numpy as np

from ._arguments import shown
from ._backend import native
from ._errors import fail
from ._report import Report


class progress:
    """While this context is active, all estimations that its thread begins call a function every 5
    milliseconds. The function decides whether to continue.

        with usacv20.progress(lambda report: report.iterations < 10**6 and not canceled.is_set()):
            H, mask = usacv20.findHomography(points1, points2, usacv20.USACV20, 3.0)

    function -- gets a Report on the state of the search and returns True or None to continue. In this
    Report, `stop` is STOP_NOT_RUN, and `searchMs` is the time since the run began. `inliers`,
    `inlierRatio` and `cost` are those of the best model before polishing (0, 0 and 1 if there is
    none); with more than 32768 points, they refer to the random part of the points that is
    searched. If the function returns False, the run ends with the best model so far, and the `stop`
    of its final Report is STOP_CANCELLED

    This applies to all functions of the package that estimate a model, including those for many
    pairs, and to Usac.run. An exception in the function ends the run and is passed on to the
    caller. Runs shorter than 5 milliseconds do not call the function. If the function always
    returns True, it does not change the result. Another thread can cancel the run through an object
    that the function reads, such as a threading.Event.

    In the package usacv20, Ctrl-C raises KeyboardInterrupt during an estimation even without this
    context. In cv2.usacv20, it does so only within the context, for example progress(lambda report:
    True); each estimation then runs in a thread of its own."""

    def __init__(self, function: typing.Callable[[Report], Optional[bool]]) -> None:
        if not callable(function):
            raise fail("function: a function or another callable is expected, not {}".format(shown(function)))
        self._function = function
        self._native: Optional[native.Progress] = None

    def _ask(self, report: Any) -> bool:
        answer = self._function(Report._of(report))
        if answer is not None and not isinstance(answer, (bool, np.bool_)):
            raise fail("function: it must return True or None to continue or False to stop, not {}".format(shown(answer)))
        return answer is None or bool(answer)

    def __enter__(self) -> progress:
        if self._native is not None:
            raise fail("progress: this object is already in use")
        entered = native.Progress(self._ask)
        entered.enter()
        self._native = entered
        return self

    def __exit__(self, *failure: object) -> None:
        if self._native is not None:
            self._native.leave()
            self._native = None

progress.__module__ = __name__.rpartition(".")[0]
