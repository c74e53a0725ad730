# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Processes a chunk of pairs from its keys to its results; used by threads and by Dask workers."""

from __future__ import annotations

import hashlib
import pickle
import threading
import time
import typing
from typing import Any, Callable, Dict, List, Optional, Union

import numpy as np

from ._pair import CollectionError, Configuration, Fault, Key, Pair, Source, TwoView

Verify = Callable[[typing.Sequence[Pair], Any], List[TwoView]]


class Future(typing.Protocol):
    """The common methods of Python's and Dask's futures."""

    def result(self) -> Outcome: ...

    def cancel(self) -> Any: ...

    def cancelled(self) -> bool: ...

    def done(self) -> bool: ...

    def add_done_callback(self, fn: Any) -> Any: ...


class Workers(typing.Protocol):
    """Interface of the workers, which process chunks."""

    def capacity(self) -> int:
        """Returns the maximum number of chunks that are submitted, but not finished, at the same time.
        """

    def submit(self, keys: typing.Sequence[Key]) -> Future: ...

    def drop(self, futures: typing.Sequence[Future]) -> None:
        """Cancels those of the unfinished futures that no worker has begun. It is called repeatedly until
        all futures are finished or canceled."""

    def explain(self, error: BaseException) -> BaseException:
        """Returns the exception to raise in place of an exception of a future."""

    def close(self) -> None: ...


class Outcome(typing.NamedTuple):
    """The results of a chunk."""

    results: List[TwoView]  # in the order of the keys
    reading: float  # seconds
    estimating: float  # seconds


def faulty(fault: Fault) -> TwoView:
    return TwoView(fault.key, Configuration.UNDEFINED, np.empty((0, 2), np.uint32), None, None, None, None, None, fault.reason,
                   0, 0, float("nan"), 0.0)


def process(source: Source, keys: typing.Sequence[Key], verify: Verify, settings: Any) -> Outcome:
    start = time.perf_counter()
    items = source.load(keys)
    return finish(items, verify, settings, time.perf_counter() - start)


def finish(items: typing.Sequence[Union[Pair, Fault]], verify: Verify, settings: Any, reading: float) -> Outcome:
    """Estimates the geometry of the pairs among the loaded items. Faults become results without models. `reading`
    is the number of seconds that loading took."""
    start = time.perf_counter()
    pairs = [item for item in items if isinstance(item, Pair)]
    found = verify(pairs, settings) if pairs else []
    if [result.key for result in found] != [pair.key for pair in pairs]:
        raise RuntimeError("the results belong to other pairs than the given ones")
    results = (_named(result, pair)._replace(matchesHash=pair.matchesHash) for result, pair in zip(found, pairs))
    return Outcome([next(results) if isinstance(item, Pair) else faulty(item) for item in items], reading,
                   time.perf_counter() - start)


def _named(result: TwoView, pair: Pair) -> TwoView:
    """Adds the names of the images to the reason of a fault, because the reason is useless without
    these names."""
    if result.configuration != Configuration.UNDEFINED:
        return result
    return result._replace(reason="{} - {}: {}".format(pair.first.name, pair.second.name, result.reason))


_kept: Dict[str, Source] = {}
_checked: List[Source] = []  # the source in _kept if its fingerprint was found to be correct, otherwise empty
_lock = threading.Lock()


def unpickled(source: bytes) -> Source:
    """Unpickles a source in a process of a cluster. The last source is kept, so that the
    files of a source are opened only once during a run."""
    digest = hashlib.sha256(source).hexdigest()
    with _lock:
        if digest not in _kept:
            _kept.clear()  # a process works for only one run at a time
            _kept[digest] = pickle.loads(source)
        return _kept[digest]


def processRemotely(source: bytes, fingerprint: Optional[str], keys: typing.Sequence[Key], items: Optional[bytes], reading: float,
                    verify: Verify, settings: Any) -> Outcome:
    """Processes a chunk in another process.

    source -- the pickled source
    fingerprint -- fingerprint of the source, which must be the same in this process; None: the pairs
    are in `items`
    items, reading -- the pickled pairs, and the number of seconds that reading them took; items
    None: this process reads the pairs itself"""
    if items is not None:
        return finish(pickle.loads(items), verify, settings, reading)
    shared = unpickled(source)
    if shared not in _checked:
        if shared.fingerprint() != fingerprint:
            raise CollectionError("this worker sees other files than the process that started the run")
        _checked.clear()
        _checked.append(shared)
    return process(shared, keys, verify, settings)


def fingerprintOf(source: bytes) -> str:
    """Returns the fingerprint of a pickled source as this process (a worker) sees it, or the error message if the fingerprint
    cannot be computed."""
    try:
        return unpickled(source).fingerprint()
    except Exception as error:
        return "{}: {}".format(type(error).__name__, error)
