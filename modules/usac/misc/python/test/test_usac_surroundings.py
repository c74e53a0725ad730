#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of estimations together with other threads, signals and child processes, and of memory
leaks."""

import concurrent.futures
import gc
import importlib.util
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

from usac_common import DISTORTED, GENERAL, IN_TREE, MOVED, PLANE, SANITIZED, THRESHOLD, bits, estimate, package, usac
from usac_pose import POSE

# Number of calls of each function in the tests for memory leaks; 100000 for a long test.
CALLS = int(os.environ.get("USAC_TEST_CALLS", "2000"))


def slow(seconds=0.4):
    """Returns a function that makes an estimation of about `seconds` seconds; nearly all of this time
    is spent in the search."""
    params = usac.Params(termination=0, maxIterations=1000, threads=1, threshold=THRESHOLD)
    start = time.perf_counter()
    estimate("Essential", GENERAL, params)
    params.maxIterations = int(1000 * seconds / max(time.perf_counter() - start, 1e-4)) + 1
    return lambda: estimate("Essential", GENERAL, params)


class ThreadTest(unittest.TestCase):

    def test_the_lock_is_released(self):
        run = slow()
        thread = threading.Thread(target=run)
        steps = 0
        thread.start()
        while thread.is_alive():
            time.sleep(0.001)
            steps += 1
        self.assertGreater(steps, 20)  # if the estimation held the interpreter's lock, there would be one or two steps

    def test_many_at_once(self):
        params = usac.Params(threshold=THRESHOLD)

        def work(k):
            problem, scene = (("Homography", PLANE), ("Fundamental", GENERAL), ("Essential", DISTORTED), ("Affinity2D", MOVED))[k % 4]
            own = usac.Params(threshold=THRESHOLD, threads=1 + k % 3)
            return k % 4, bits(estimate(problem, scene, own if k % 2 else params)[:2])

        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            results = list(pool.map(work, range(200)))
        self.assertEqual(len(set(results)), 4)

    def test_params_that_others_change(self):
        """Another thread changes Params during the estimations. Each estimation must use either the
        old or the new values; there must be no crash."""
        params, done = usac.Params(threshold=THRESHOLD), threading.Event()

        def change():
            while not done.is_set():
                params.scores = np.arange(len(PLANE.points1))
                params.threshold = 3.0
                params.scores = None
                params.threshold = THRESHOLD

        thread = threading.Thread(target=change)
        thread.start()
        try:
            for _ in range(200):
                model = usac.estimateHomography(PLANE.points1, PLANE.points2, params)[0]
                self.assertLess(PLANE.error("Homography", model), 1.0)
        finally:
            done.set()
            thread.join()

    def test_arrays_that_others_change(self):
        a, b = PLANE.points1.copy(), PLANE.points2.copy()
        states = [b.copy(), np.rint(b) + 7]
        expected = {bits(usac.estimateHomography(a, state)[:2]) for state in states}
        texts, written, done = [state.tobytes() for state in states], memoryview(b).cast("B"), threading.Event()

        def change():
            k = 0
            while not done.is_set():
                k += 1
                # This assignment holds the interpreter's lock, unlike an assignment to a NumPy array. So
                # other code that holds the lock never sees a mixture of both states.
                written[:] = texts[k % 2]

        thread = threading.Thread(target=change)
        thread.start()
        try:
            found = {bits(usac.estimateHomography(a, b)[:2]) for _ in range(300)}
        finally:
            done.set()
            thread.join()
        if not IN_TREE:  # in cv2.usacv20, OpenCV reads the points without the lock and can see a mixture of both states
            self.assertLessEqual(found, expected)

    def test_interrupt(self):
        """If a signal arrives during an estimation, its handler must be called before or
        immediately after the end of the estimation."""
        run = slow()
        handler = signal.signal(signal.SIGALRM, lambda *args: (_ for _ in ()).throw(KeyboardInterrupt))
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            with self.assertRaises(KeyboardInterrupt):
                run()
                time.sleep(5)
        finally:
            signal.signal(signal.SIGALRM, handler)


DAEMON = """
import threading, time
import numpy as np, usacv20

class First(usacv20.Sampler):
    def sample(self, rng, iteration):
        return rng.distinct(1000, 4)

def search(own, forever=True):
    usac = usacv20.Usac.create(usacv20.HOMOGRAPHY, a, b, usacv20.Params(maxIterations=2**31 - 1 if forever else 20, termination=0))
    if own:
        usac.components.sampler = First()
    usac.run()

def repeat():
    while True:
        search(True, False)

a, b = np.random.RandomState(1).uniform(0, 640, (2, 1000, 2))
for function, args in ((search, (False,)), (search, (True,)), (repeat, ())):
    threading.Thread(target=function, args=args, daemon=True).start()
time.sleep(0.2)
"""
# In a child process, there are no other threads to wait for. What is registered first is called last.
FORKED = """
import atexit
atexit.register(lambda: print(time.monotonic() - ended > 4))
""", """
import os, sys
if os.fork() == 0:
    ended = time.monotonic()
    sys.exit()
os.wait()
ended = time.monotonic()
"""
SUB_INTERPRETER = """
import sys
import {0} as interpreters
failures = "import sys; sys.path[:] = {{!r}}\\ntry:\\n    import usacv20\\nexcept ImportError as failure:\\n    print(failure)"
interpreters.run_string(interpreters.create(), failures.format(sys.path))
"""


@package
class ProcessTest(unittest.TestCase):
    """Tests in other processes, which would crash or never end."""

    def output(self, code):
        return subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60,
                              universal_newlines=True, check=True).stdout

    def test_end_with_daemon_threads(self):
        for _ in range(3):
            self.assertEqual(self.output(DAEMON), "")
        if hasattr(os, "fork"):
            self.assertEqual(self.output(FORKED[0] + DAEMON + FORKED[1]), "False\nFalse\n")

    @unittest.skipIf(SANITIZED, "the interpreters of the sanitizer's process are not checked")
    def test_sub_interpreter(self):
        name = next((name for name in ("_interpreters", "_xxsubinterpreters") if importlib.util.find_spec(name)), None)
        if name is None:
            self.skipTest("this Python has no module for sub-interpreters")
        self.assertIn("not in a sub-interpreter", self.output(SUB_INTERPRETER.format(name)))


@unittest.skipUnless(hasattr(os, "fork"), "no fork")
class ForkTest(unittest.TestCase):

    def test_child(self):
        params = usac.Params(threshold=THRESHOLD)
        expected = bits(estimate("Fundamental", GENERAL, params)[:2])
        child = os.fork()
        if child == 0:
            same = bits(estimate("Fundamental", GENERAL, params)[:2]) == expected
            os._exit(0 if same else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


def residentBytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@unittest.skipIf(SANITIZED, "a sanitizer keeps freed memory")
@unittest.skipUnless(os.path.exists("/proc/self/statm"), "Linux only")
class MemoryTest(unittest.TestCase):

    def check(self, function, calls=CALLS):
        for _ in range(min(calls, 300)):
            function()
        gc.collect()
        before = residentBytes()
        for _ in range(calls):
            function()
        gc.collect()
        # The limit is a fixed amount, plus a third of the size of a mask (300 bytes) for each call. So
        # a long test (see CALLS) detects that each call leaks a mask.
        self.assertLess(residentBytes() - before, 2**19 + 100 * calls)

    def test_estimations(self):
        params = usac.Params(threshold=THRESHOLD, scores=np.arange(len(PLANE.points1)), maxIterations=20)
        a, b = PLANE.points1.astype(">f4"), np.asfortranarray(PLANE.points2)
        mask = np.zeros((len(a), 1), np.uint8)
        self.check(lambda: usac.estimateHomography(a, b, params, mask))
        self.check(lambda: usac.solvePnPRansac(POSE.X, POSE.x, POSE.K, POSE.d, flags=usac.USACV20, iterationsCount=5), CALLS // 4)
        self.check(lambda: usac.Params(threshold=2, scores=PLANE.points1[:, 0]) == usac.Params.magsac())
        self.check(lambda: usac.findEssentialMat(a, b, GENERAL.focal, GENERAL.pp, usac.USACV20_FAST, maxIters=5), CALLS // 4)

    @unittest.skipIf(IN_TREE, "tests the package usacv20 only: OpenCV's own code loses 400 bytes with each exception")
    def test_mistakes(self):
        def wrong():
            for args in ((PLANE.points1, PLANE.points2[1:]), ("a", "b"), (PLANE.points1, PLANE.points2, usac.USACV20, -1.0)):
                try:
                    usac.findHomography(*args)
                except usac.error:
                    continue
                raise AssertionError

        self.check(wrong)

    @unittest.skipIf(IN_TREE, "tests the package usacv20 only")
    def test_components(self):
        class First(usac.Sampler):
            def sample(self, rng, iteration):
                return rng.distinct(300, 4)

        def run():
            usac_ = usac.Usac.create(usac.HOMOGRAPHY, PLANE.points1, PLANE.points2, usac.Params(maxIterations=3))
            usac_.components.sampler = First()
            usac_.run()

        self.check(run)


if __name__ == "__main__":
    unittest.main()
