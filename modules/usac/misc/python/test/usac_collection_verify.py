# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Fast replacements for the verification of pairs, for tests of the other parts of the collection
tool. The results of verify() depend on the names, points and matches of a pair, so that a test
notices wrong input."""

import hashlib
import os
import sys
import time

import numpy as np

from usacv20.collection._database import DatabaseSource
from usacv20.collection._database_sink import DatabaseSink
from usacv20.collection._engine import run
from usacv20.collection._pair import CollectionError, Configuration, TwoView


def verify(pairs, settings):
    """Returns a made-up result for each pair; it depends only on the pair and the seed.

    settings -- {"sleep": seconds to wait for each pair, "seed": number}; both are 0 by default"""
    return [_one(pair, settings) for pair in pairs]


def _one(pair, settings):
    time.sleep(settings.get("sleep", 0))
    digest = hashlib.sha256(repr((pair.key, pair.first.name, pair.second.name, settings.get("seed", 0))).encode())
    for array in (pair.first.points, pair.second.points, pair.matches):
        digest.update(array.tobytes())
    numbers = np.frombuffer(digest.digest(), np.uint8).astype(float)
    refused = len(pair.matches) < 15
    inliers = np.empty((0, 2), np.uint32) if refused else pair.matches[:: 1 + int(numbers[0]) % 3]
    matrix = None if refused else numbers[:9].reshape(3, 3) - 128
    return TwoView(pair.key, Configuration.DEGENERATE if refused else Configuration.UNCALIBRATED, inliers, matrix, None, None,
                   None, None, "too few matches" if refused else "", len(pair.matches), int(numbers[10]), 0.5, 1.5)


def fails(pairs, settings):
    raise RuntimeError("a mistake in " + pairs[0].first.name)


def failsLate(pairs, settings):
    if pairs[0].first.name == "image10.jpg":
        fails(pairs, settings)
    return verify(pairs, settings)


def logged(pairs, settings):
    """Does the same as verify, but first appends the key of the first pair to the file settings["log"]."""
    with open(settings["log"], "a") as log:
        log.write("{}\n".format(pairs[0].key))
    return verify(pairs, settings)


def loggedOrFails(pairs, settings):
    if pairs[0].first.name == "image2.jpg":
        fails(pairs, settings)
    return logged(pairs, settings)


def forgets(pairs, settings):
    return verify(pairs, settings)[1:]


class Here(DatabaseSource):
    """A database that can be opened only in the process that created this object, as if other
    processes did not have the file."""

    def __init__(self, *args, **keywords):
        super().__init__(*args, **keywords)
        self.process = os.getpid()

    def __getstate__(self):
        return dict(super().__getstate__(), process=self.process)

    def connection(self):
        if os.getpid() != self.process:
            raise CollectionError("there is no such file")
        return super().connection()


def main(path, *options):
    """Runs the engine on a database, with a wait of 0.02 seconds for each pair, so that a test can stop
    the run. options -- "workers": uses two Dask workers instead of two threads"""
    source, sink = DatabaseSource(path), DatabaseSink(path, {})
    summary = run(source, sink, {"sleep": 0.02}, sys.modules["usac_collection_verify"].verify, threads=2, chunk=5,
                  workers=2 * ("workers" in options))
    sink.close(finished=not summary.interrupted)
    print(summary.line())
    return 130 if summary.interrupted else 0


if __name__ == "__main__":
    import usac_collection_verify  # noqa: F401, workers can import functions of this module, but not of __main__
    sys.exit(main(*sys.argv[1:]))
