# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""usacv20.progress in a cv2 that was built with the module.

OpenCV's generator binds no function as an argument. So the run is in a thread of its own, and the one that called waits for it and
asks the function meanwhile: it is called where it would be by the package, and there Ctrl-C comes, too."""

from __future__ import annotations

import threading
from typing import Any, Callable, Dict, List, Optional, Tuple

_PERIOD = 0.005  # seconds between two questions, as in C++
_STOP_CANCELLED = 13


class _Here(threading.local):
    def __init__(self) -> None:
        self.scopes: List[Progress] = []


_here = _Here()


class Progress:
    """As that of _native.pyi: the scope of a function, from the thread that enters it."""

    def __init__(self, function: Callable[[Any], bool]) -> None:
        self.function = function

    def enter(self) -> None:
        _here.scopes.append(self)

    def leave(self) -> None:
        if self in _here.scopes:
            _here.scopes.remove(self)


class Runs:
    """Calls functions of cv2._native.usacv20, which run as long as the functions of the scopes of the thread say yes."""

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
        """A call in a thread that `control` can stop; null: nothing stops it."""
        if control is None:
            return call()
        control.enter()
        try:
            return call()
        finally:
            control.leave()

    def watched(self, call: Callable[[Any], Any]) -> Any:
        """A call of a function of `control`; null: nobody wants to be asked."""
        scopes = _here.scopes[::-1]  # the innermost first
        if not scopes:
            return call(None)
        control = self._functions.RunControl()
        outcome: Dict[str, Any] = {}
        done = threading.Event()  # join() takes the thread for ended when Ctrl-C comes meanwhile (CPython 3.11)

        def work() -> None:
            try:
                outcome["result"] = call(control)
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
        finally:  # an exception of the function, or KeyboardInterrupt
            control.cancel()
            done.wait()
            thread.join()
        if "failure" in outcome:
            raise outcome["failure"]
        return outcome["result"]

    def notBegun(self) -> Tuple[Optional[Any], Optional[Any], Any, str]:
        """The result of one of many estimations that was stopped before it began."""
        report = self._functions.Report()
        report.stop = _STOP_CANCELLED
        return None, None, report, ""
