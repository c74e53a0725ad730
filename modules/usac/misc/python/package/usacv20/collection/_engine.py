# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates all pairs of a source in parallel and in limited memory, and stores the results in a
sink. A run can be interrupted.

The calling thread distributes chunks of keys and stores results in the order in which they arrive.
Each result depends only on its pair, so the stored table does not depend on this order."""

from __future__ import annotations

import contextlib
import itertools
import os
import queue
import signal
import threading
import time
import typing
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Dict, List, Optional

from .._arguments import INT_MAX, isInteger, shown
from ._pair import CollectionError, Configuration, Key, Sink, Source
from ._progress import Progress
from ._work import Future, Outcome, Verify, Workers, process

CHUNK = 64  # number of pairs in a chunk
_PER_THREAD = 2  # number of chunks for each thread: one in progress, one waiting
_POLL = 0.2  # seconds between two checks for Ctrl-C


def checkNumbers(threads: Any = 0, chunk: Any = CHUNK, workers: Any = 0, **_: Any) -> None:
    """Raises CollectionError if one of these arguments of run() is invalid. Other arguments are
    ignored."""
    if not isInteger(chunk) or not 1 <= chunk <= INT_MAX:
        raise CollectionError("chunk: a positive number is expected")
    for name, value in (("threads", threads), ("workers", workers)):
        if not isInteger(value) or not 0 <= value <= INT_MAX:
            raise CollectionError("{}: an integer of at least 0 is expected, not {}".format(name, shown(value)))


class Summary:
    """Statistics of a run. Times are in seconds; those of reading and estimating are sums over all
    workers."""

    def __init__(self) -> None:
        self.pairs = 0  # number of results stored by this run, including faults
        self.skipped = 0  # number of pairs stored by an earlier run
        self.refused = 0  # number of refused pairs: no model was accepted, or the pair contradicts other pairs
        # Number of pairs in the whole table that were refused because they contradict other pairs; with
        # --pairs, only selected pairs can be refused.
        self.contradicted = 0
        self.faults = 0  # number of pairs that cannot be read, or whose estimation raised an exception
        self.interrupted = False
        self.threshold = float("nan")  # pixels
        self.reading = self.estimating = self.writing = self.elapsed = 0.0

    def add(self, outcome: Outcome) -> None:
        self.pairs += len(outcome.results)
        self.faults += sum(result.configuration == Configuration.UNDEFINED for result in outcome.results)
        self.refused += sum(bool(result.reason) and result.configuration != Configuration.UNDEFINED for result in outcome.results)
        self.reading += outcome.reading
        self.estimating += outcome.estimating

    @property
    def verified(self) -> int:
        return self.pairs - self.refused - self.faults

    def __repr__(self) -> str:
        return "<Summary: {}>".format(self.line())

    def line(self) -> str:
        text = "{} pairs in {:.1f} s ({:.0f} a second): {} verified, {} refused".format(
            self.pairs, self.elapsed, self.pairs / max(self.elapsed, 1e-9), self.verified, self.refused)
        if self.faults:
            text += ", {} cannot be read".format(self.faults)
        if self.contradicted:
            text += "; {} pairs are refused because pairs with more inliers contradict them".format(self.contradicted)
        if self.skipped:
            text += "; {} were done before".format(self.skipped)
        return text + ("; interrupted" if self.interrupted else "")

    def times(self) -> str:
        return "seconds of all workers: reading {:.2f}, estimating {:.2f}; writing {:.2f}".format(
            self.reading, self.estimating, self.writing)


class _Threads:
    """Workers that are threads of the calling process."""

    def __init__(self, source: Source, settings: Any, verify: Verify, threads: int) -> None:
        self._job = source, settings, verify
        self._threads = threads or _cores()
        self._pool = ThreadPoolExecutor(self._threads, "usacv20")

    def capacity(self) -> int:
        return _PER_THREAD * self._threads

    def submit(self, keys: typing.Sequence[Key]) -> Future:
        source, settings, verify = self._job
        return self._pool.submit(process, source, keys, verify, settings)

    def drop(self, futures: typing.Sequence[Future]) -> None:
        for future in futures:
            future.cancel()  # has no effect on a future in progress

    def explain(self, error: BaseException) -> BaseException:
        return error

    def close(self) -> None:
        self._pool.shutdown()


class _Interrupts:
    """Handles Ctrl-C and SIGTERM: the first signal asks the run to stop, the second signal stops it
    at once. Has an effect in the main thread only."""

    def __init__(self) -> None:
        self.asked = False
        self._before: Dict[signal.Signals, Any] = {}

    def __enter__(self) -> _Interrupts:
        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGINT, signal.SIGTERM):
                self._before[number] = signal.signal(number, self._handle)
        return self

    def __exit__(self, *_: Any) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _handle(self, *_: Any) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True


class _Run:
    """A run with its pending chunks; it stores the results of finished chunks."""

    def __init__(self, sink: Sink, workers: Workers, progress: Progress, interrupts: _Interrupts) -> None:
        self.sink = sink
        self.workers = workers
        self.progress = progress
        self.interrupts = interrupts
        self.summary = Summary()
        self.done: queue.SimpleQueue[Future] = queue.SimpleQueue()
        self.pending: Dict[int, Future] = {}
        self.failure: Optional[BaseException] = None

    def go(self, chunks: typing.Iterator[List[Key]]) -> None:
        more = True
        while more or self.pending:
            if self.interrupts.asked or self.failure is not None:
                more = False
                self.workers.drop([future for future in self.pending.values() if not future.done()])
            while more and len(self.pending) < self.workers.capacity() and not self.interrupts.asked:
                chunk = next(chunks, None)
                if chunk is None or self.interrupts.asked:
                    more = False
                else:
                    future = self.workers.submit(chunk)
                    self.pending[id(future)] = future
                    future.add_done_callback(self.done.put)
            self._store(self._finished())
        self.summary.interrupted = self.interrupts.asked
        if self.failure is not None:
            raise self.failure

    def cancel(self) -> None:
        """Cancels all chunks. The results of chunks in progress are lost if Dask's workers process them."""
        for future in self.pending.values():
            if not future.done():
                future.cancel()

    def _finished(self) -> List[Future]:
        """Waits up to _POLL seconds for a finished chunk and returns all finished chunks, because a
        single commit is cheaper than many commits."""
        futures: List[Future] = []
        with contextlib.suppress(queue.Empty):
            while len(futures) < len(self.pending):
                futures.append(self.done.get(timeout=0 if futures else _POLL))
        return futures

    def _store(self, futures: typing.Sequence[Future]) -> None:
        outcomes = []
        for future in futures:
            del self.pending[id(future)]
            if future.cancelled():
                continue
            try:
                outcomes.append(future.result())
            except BaseException as error:  # raised after the results of the other chunks are stored
                self.failure = self.failure or self.workers.explain(error)
        if not outcomes:
            return
        start = time.perf_counter()
        self.sink.commit([result for outcome in outcomes for result in outcome.results])
        self.summary.writing += time.perf_counter() - start
        for outcome in outcomes:
            self.summary.add(outcome)
            for result in outcome.results:
                if result.configuration == Configuration.UNDEFINED:
                    self.progress.complain(result.reason)
            self.progress.advance(len(outcome.results))

    def remaining(self, keys: typing.Iterator[Key]) -> typing.Iterator[Key]:
        """Yields the keys of the pairs that are not done. Checks for an interruption at each key, because
        many pairs can be skipped before a chunk is full."""
        for key in keys:
            if self.interrupts.asked:
                return
            if self.sink.done(key):
                self.summary.skipped += 1
                self.progress.skip(1)
            else:
                yield key


def run(source: Source, sink: Sink, settings: Any, verify: Verify, threads: int = 0, chunk: int = CHUNK, workers: int = 0,
        scheduler: str = "", progress: Optional[bool] = None) -> Summary:
    """Estimates all pairs of the source that the sink does not have yet.

    verify -- function of (pairs, settings) that returns a result for each pair. It must be
    defined at the top level of a module, so that it can be pickled
    threads -- number of threads of this process; 0: one for each core
    chunk -- number of pairs that are estimated and stored together; at least 1
    workers, scheduler -- for Dask: number of processes to start on this machine, or the address of
    a running scheduler, tcp://HOST:PORT. If neither is given, threads of this process do the work
    progress -- whether a progress bar is shown: True, False or None, see Progress

    Returns the summary. If Ctrl-C or SIGTERM interrupts the run, the chunks in progress are first
    finished and stored; a second signal ends the run at once. The sink is not closed. An exception of a
    worker is raised after the results of the other workers are stored."""
    checkNumbers(threads, chunk, workers)
    bar = Progress(len(source), progress)
    try:
        with _Interrupts() as interrupts:
            made = _workers(source, settings, verify, threads, workers, scheduler, bar)
            state = _Run(sink, made, bar, interrupts)
            start = time.perf_counter()
            try:
                state.go(_chunks(state.remaining(source.keys()), chunk))
            except BaseException:
                state.cancel()
                raise
            finally:
                state.summary.elapsed = time.perf_counter() - start
                made.close()
    finally:
        bar.close()
        _close(source)  # an open reader would keep the sink from removing SQLite's additional files
    return state.summary


def _workers(source: Source, settings: Any, verify: Verify, threads: int, workers: int, scheduler: str, bar: Progress) -> Workers:
    if not workers and not scheduler:
        return _Threads(source, settings, verify, threads)
    from ._dask import Cluster
    return Cluster(source, settings, verify, workers, scheduler, bar.say)


def _chunks(keys: typing.Iterator[Key], size: int) -> typing.Iterator[List[Key]]:
    while True:
        chunk = list(itertools.islice(keys, size))
        if not chunk:
            return
        yield chunk


def _cores() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _close(source: Source) -> None:
    """Closes the open files of a source, if there are any. The source opens them again at its next
    use."""
    close = getattr(source, "close", None)
    if close is not None:
        close()
