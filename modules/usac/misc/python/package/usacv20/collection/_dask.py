# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Processes chunks of pairs as Dask tasks, on a cluster started on this machine or on an existing
cluster."""

from __future__ import annotations

import importlib
import pickle
import time
import typing
import warnings
from typing import Any, Callable, Dict, Optional

from ._optional import need
from ._pair import CollectionError, Key, Source
from ._work import Future, Verify, fingerprintOf, processRemotely

_PER_THREAD = 2  # number of chunks for each thread: one in progress, one waiting
_RETRIES = 1  # maximum number of repetitions of a task that raised an exception; Dask also repeats the tasks of a dead worker
_CONNECT = 10.0  # maximum number of seconds to connect to a scheduler
_JOIN = 60.0  # maximum number of seconds to wait for the first worker
_IDLE = 1.0  # drop() cancels a task that no worker has had for this number of seconds
_COUNT = 5.0  # minimum number of seconds between two counts of the workers' threads


class Cluster:
    """A cluster of Dask worker processes.

    workers -- number of processes to start on this machine; 0: `scheduler` is the address of a
    running cluster
    say -- function that prints a line for the user

    If all workers see the same files of the source as this process, they read the pairs themselves;
    otherwise this process reads the pairs and sends them to the workers."""

    def __init__(self, source: Source, settings: Any, verify: Verify, workers: int, scheduler: str,
                 say: Callable[[str], None]) -> None:
        distributed = need("distributed", "for --workers and --scheduler")
        if workers and scheduler:
            raise CollectionError("--workers starts processes on this machine, --scheduler uses a running cluster: give one, not "
                                  "both")
        self._source, self._settings, self._verify, self._say = source, settings, verify, say
        self._packed = pickle.dumps(source)
        self._cluster: Any = None
        self._client: Any = None
        self._counted, self._threads = 0.0, 0
        self._idle: Dict[str, float] = {}  # by key of a task: when drop() first found that no worker had the task
        try:
            if workers:
                self._cluster = localCluster(distributed, workers)
            self._client = self._connect(distributed, self._cluster or scheduler, scheduler)
            self._expected = self._shared()
        except BaseException:
            self.close()
            raise

    @staticmethod
    def _connect(distributed: Any, target: Any, scheduler: str) -> Any:
        try:
            client = distributed.Client(target, timeout=_CONNECT, set_as_default=False)
        except (OSError, ValueError) as error:  # TimeoutError is an OSError; ValueError is raised for an invalid address
            raise CollectionError("--scheduler {}: no scheduler answers at this address: {}".format(
                scheduler, " ".join(str(error).split()))) from error
        try:
            client.wait_for_workers(1, timeout=_JOIN)
        except Exception as error:
            client.close()
            raise CollectionError("{}: no worker was available within {:.0f} seconds".format(
                "--scheduler " + scheduler if scheduler else "--workers", _JOIN)) from error
        return client

    def _shared(self) -> Optional[str]:
        """Returns the fingerprint of the source if all workers see the same files as this process;
        otherwise None."""
        own = self._source.fingerprint()
        try:
            found = self._client.run(fingerprintOf, self._packed)
        except Exception as error:
            raise CollectionError("the workers cannot run this version of usacv20: {}: {}".format(
                type(error).__name__, " ".join(str(error).split()))) from error
        others = sorted(address for address, value in found.items() if value != own)
        if not others:
            return own
        self._say("{} of {} workers do not see the same files ({}: {}): this process reads the pairs and sends them".format(
            len(others), len(found), others[0], found[others[0]]))
        return None

    def capacity(self) -> int:
        if time.monotonic() - self._counted > _COUNT:
            before, self._threads = self._threads, sum(self._client.nthreads().values())
            self._counted = time.monotonic()
            if before and not self._threads:
                self._say("all workers have ended; waiting for new ones")
        return _PER_THREAD * max(1, self._threads)

    def submit(self, keys: typing.Sequence[Key]) -> Future:
        items: Optional[bytes] = None
        reading = 0.0
        if self._expected is None:
            start = time.perf_counter()
            items = pickle.dumps(self._source.load(keys), pickle.HIGHEST_PROTOCOL)
            reading = time.perf_counter() - start
        with warnings.catch_warnings():
            # Dask warns that the pairs are a large argument of a task. They are nevertheless passed
            # in this way, so that the scheduler keeps them until the task is done; data stored on a
            # worker would be lost if the worker died.
            warnings.filterwarnings("ignore", message="Large object")
            future: Future = self._client.submit(processRemotely, self._packed, self._expected, list(keys), items, reading,
                                                 self._verify, self._settings, pure=False, retries=_RETRIES)
        return future

    def drop(self, futures: typing.Sequence[Any]) -> None:
        """Cancels the tasks that no worker has. Canceling a task in progress would discard its result, so
        a task is canceled only if no worker has had it for _IDLE seconds: for a moment, tasks that were
        just submitted or have just ended are not assigned to a worker either."""
        try:
            begun = {key for keys in self._client.processing().values() for key in keys}
        except OSError:  # the scheduler does not answer
            begun = set()
        now = time.monotonic()
        self._idle = {future.key: self._idle.get(future.key, now) for future in futures if future.key not in begun}
        for future in futures:
            if now - self._idle.get(future.key, now) >= _IDLE:
                future.cancel()

    def explain(self, error: BaseException) -> BaseException:
        if type(error).__name__ == "KilledWorker":
            return CollectionError("several workers died while they processed the same chunk of pairs; is there enough memory? "
                                   "({})".format(
                " ".join(str(error).split())))
        return error

    def close(self) -> None:
        for part in (self._client, self._cluster):
            if part is not None:
                part.close()


def localCluster(distributed: Any, workers: int) -> Any:
    dask = importlib.import_module("dask")
    name = "distributed.nanny.pre-spawn-environ"
    quiet = {**dask.config.get(name, {}), "DASK_LOGGING__DISTRIBUTED": "warning"}
    with dask.config.set({name: quiet}):
        return distributed.LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0",
                                        preload=__package__ + "._dask_worker")
