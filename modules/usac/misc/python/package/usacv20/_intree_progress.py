# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""usacv20.progress in a cv2 that was built with the module.

OpenCV's generator of bindings does not support functions as arguments. Therefore a second thread
runs the estimation, while the calling thread waits for it, calls the progress function and handles
Ctrl-C."""

from __future__ import annotations

import threading
from typing import Any, Callable, Dict, List, Optional, Tuple

_PERIOD = 0.005  # seconds between two calls of the progress function, as in C++
_STOP_CANCELLED = 13


class _Here(threading.local):
    def __init__(self) -> None:
        self.scopes: List[Progress] = []
        self.warning = ""  # of the last run in a second thread


_here = _Here()


class Progress:
    """Like Progress in _native.pyi: a progress function and the scope in which it is called."""

    def __init__(self, function: Callable[[Any], bool]) -> None:
        self.function = function

    def enter(self) -> None:
        _here.scopes.append(self)

    def leave(self) -> None:
        if self in _here.scopes:
            _here.scopes.remove(self)


class Runs:
    """Calls functions of cv2._native.usacv20. A run is stopped when a progress function of the
    calling thread returns False or raises an exception."""

    def __init__(self, functions: Any) -> None:
        self._functions = functions

    def __getattr__(self, name: str) -> Any:
        function = getattr(self._functions, name)

        def run(*args: Any, **kwargs: Any) -> Any:
            if not _here.scopes:
                return function(*args, **kwargs)
            return self.watched(lambda control: self.entered(control, lambda: function(*args, **kwargs)))

        return run

    @staticmethod
    def entered(control: Any, call: Callable[[], Any]) -> Any:
        """Calls a function that the RunControl `control` can stop. If `control` is None, the call
        cannot be stopped."""
        if control is None:
            return call()
        control.enter()
        try:
            return call()
        finally:
            control.leave()

    def watched(self, call: Callable[[Any], Any]) -> Any:
        """Returns the result of call(control), which runs in a second thread with a RunControl. If there is no progress
        function, call(None) runs in this thread."""
        scopes = _here.scopes[::-1]  # the innermost first
        if not scopes:
            return call(None)
        control = self._functions.RunControl()
        outcome: Dict[str, Any] = {}
        done = threading.Event()  # join() is not enough: if Ctrl-C interrupts it, CPython 3.11 marks the thread as ended

        def work() -> None:
            try:
                outcome["result"] = call(control)
                outcome["warning"] = self._functions.lastWarning()
            except BaseException as failure:
                outcome["failure"] = failure
            finally:
                done.set()

        thread = threading.Thread(target=work)
        thread.start()
        try:
            while not done.wait(_PERIOD):
                if not control.cancelled() and not all(scope.function(control.report()) for scope in scopes):
                    control.cancel()
        finally:  # also if the progress function or Ctrl-C raises an exception
            control.cancel()
            done.wait()
            thread.join()
        if "failure" in outcome:
            raise outcome["failure"]
        _here.warning = outcome["warning"]
        return outcome["result"]

    def lastWarning(self) -> str:
        """Returns the warning of the last run that this thread has begun."""
        return _here.warning if _here.scopes else str(self._functions.lastWarning())

    def notBegun(self) -> Tuple[Optional[Any], Optional[Any], Any, str]:
        """Returns the result of an estimation that was canceled before it started."""
        report = self._functions.Report()
        report.stop = _STOP_CANCELLED
        return None, None, report, ""
