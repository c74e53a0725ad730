#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of stopping a run: Params.maxTime, usacv20.progress, Ctrl-C."""

import asyncio
import os
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

from usac_common import ERRORS, IN_TREE, package, usac

SLACK = 0.5  # maximum delay of a run by other processes on the machine, in seconds
ENDLESS = dict(maxIterations=2**31 - 1, termination=0)


def hard(count=2000):
    """Returns points of two images with an inlier ratio of 5 %; the inliers obey an affinity without
    noise."""
    rng = np.random.RandomState(3)
    points1, points2 = rng.uniform(0, 640, (count, 2)), rng.uniform(0, 640, (count, 2))
    points2[:count // 20] = points1[:count // 20] * [0.9, 1.1] + [20, -10]
    return points1, points2


def without_times(text):
    return re.sub(r"\w+Ms=[^,)]*", "", text)


class StopTest(unittest.TestCase):
    def test_maxTime(self):
        for estimate in (usac.estimateHomography, usac.estimateFundamental):
            for threads in (1, 2):
                start = time.monotonic()
                _, mask, report = estimate(*hard(), usac.Params(maxTime=50, threads=threads, **ENDLESS))
                self.assertLess(time.monotonic() - start, 0.05 + SLACK)
                self.assertEqual(report.stop, usac.STOP_TIME)
                self.assertEqual(report.inliers, np.count_nonzero(mask))
                self.assertIn("maxTime", report.describe())
        with self.assertRaisesRegex(ERRORS, "maxTime"):
            usac.estimateHomography(*hard(), usac.Params(maxTime=-1))
        self.assertIn("maxTime=50", repr(usac.Params(maxTime=50)))

    def test_without_a_search(self):
        """Fits and refinements of a million points end early, too."""
        points1 = np.random.RandomState(1).uniform(0, 640, (10**6, 2))
        points2 = points1 * [0.9, 1.1] + [20, -10] + np.random.RandomState(2).normal(0, 50, points1.shape)
        for call in (lambda params: usac.fitModel(usac.FUNDAMENTAL, points1, points2, params=params),
                     lambda params: usac.refineModel(usac.HOMOGRAPHY, np.eye(3), points1, points2, np.ones(len(points1)), params),
                     lambda params: usac.refineModel(usac.HOMOGRAPHY, np.diag([0.9, 1.1, 1]), points1, points2, None, params)):
            model, mask, report = call(usac.Params(maxTime=1, threshold=100))
            self.assertEqual((report.stop, report.inliers), (usac.STOP_TIME, np.count_nonzero(mask)))
            self.assertIsNotNone(model)
            with usac.progress(lambda report: False):
                self.assertEqual(call(usac.Params(threshold=100))[2].stop, usac.STOP_CANCELLED)

    def test_function_sees_the_search_go_on(self):
        seen = []

        def ask(report):
            seen.append(report)
            return len(seen) < 5

        with usac.progress(ask):
            _, _, report = usac.estimateHomography(*hard(), usac.Params(**ENDLESS))
        self.assertEqual(report.stop, usac.STOP_CANCELLED)
        self.assertEqual(len(seen), 5)
        self.assertTrue(all(isinstance(one, usac.Report) and one.stop == usac.STOP_NOT_RUN for one in seen))
        self.assertTrue(all(np.isfinite([one.cost, one.inlierRatio, one.searchMs]).all() for one in seen))
        iterations = [one.iterations for one in seen]
        self.assertEqual(iterations, sorted(iterations))
        self.assertGreater(iterations[-1], iterations[0])
        _, _, report = usac.estimateHomography(*hard(), usac.Params(maxIterations=100))
        self.assertNotEqual(report.stop, usac.STOP_CANCELLED)  # the function must not be called after the with block
        self.assertEqual(len(seen), 5)

    def test_flags_batches_and_objects(self):
        params = usac.Params(**ENDLESS)
        with usac.progress(lambda report: False):
            start = time.monotonic()
            H, mask = usac.findHomography(*hard(), params)
            found = usac.estimateHomographies([hard()[0]] * 4, [hard()[1]] * 4, params)
            few = usac.estimateHomographies([hard()[0]] * 4, [hard()[1]] * 4, params, threads=1)
            self.assertLess(time.monotonic() - start, 1 + SLACK)
        self.assertEqual([one[2].stop for one in found + few], [usac.STOP_CANCELLED] * 8)
        self.assertEqual(mask.shape, (2000, 1))

    def test_arguments_and_errors_are_as_without(self):
        K = np.array([[600, 0, 320], [0, 600, 240], [0, 0, 1.]])
        points1, points2 = hard(200)
        space = np.hstack([points1 / 100, np.arange(200).reshape(-1, 1) % 7 + 4.0])
        calls = (lambda: usac.findHomography(points1, points2, usac.USACV20, 3.0), lambda: usac.estimateAffine2D(points1, points2),
                 lambda: usac.findEssentialMat(points1, points2, K), lambda: usac.solvePnPRansac(space, points2, K, None),
                 lambda: usac.estimateHomographies([points1] * 3, [points2] * 3),
                 lambda: usac.estimateRelativePose(points1, points2, K, None, K, None), lambda: usac.fitModel(usac.HOMOGRAPHY, points1, points2))
        for call in calls:
            expected = call()
            with usac.progress(lambda report: True):
                found = call()
            self.assertEqual(without_times(repr(found)), without_times(repr(expected)))
        with usac.progress(lambda report: True), self.assertRaisesRegex(ERRORS, "ransacReprojThreshold"):
            usac.findHomography(points1, points2, usac.USACV20, -1.0)

    def test_exceptions_come_out(self):
        class Enough(Exception):
            pass

        def ask(report):
            raise Enough

        runs = [lambda: usac.estimateHomography(*hard(), usac.Params(**ENDLESS)),
                lambda: usac.estimateHomographies([hard()[0]] * 4, [hard()[1]] * 4, usac.Params(**ENDLESS))]
        if not IN_TREE:
            estimator = usac.Usac.create(usac.HOMOGRAPHY, *hard(), usac.Params(**ENDLESS))
            runs += [estimator.run, estimator.run]
        for run in runs:
            with usac.progress(ask), self.assertRaises(Enough):
                run()
        if not IN_TREE:
            with usac.progress(lambda report: False):
                self.assertEqual(estimator.run()[2].stop, usac.STOP_CANCELLED)

    def test_mistakes(self):
        with self.assertRaisesRegex(ERRORS, "function"):
            usac.progress(1)
        with usac.progress(lambda report: 1), self.assertRaisesRegex(ERRORS, "function"):
            usac.estimateHomography(*hard(), usac.Params(**ENDLESS))
        scope = usac.progress(lambda report: True)
        with scope, self.assertRaisesRegex(ERRORS, "progress"), scope:
            pass
        with scope:  # the object must be usable again after the block
            pass

    def test_left_in_any_order(self):
        called = []

        def scope(name):
            return usac.progress(lambda report: called.append(name) or True)

        def calls():
            called.clear()
            usac.estimateHomography(*hard(), usac.Params(maxTime=30, **ENDLESS))
            return set(called)

        first, second, third = (scope(k) for k in range(3))
        for one in (first, second, third):
            one.__enter__()
        self.assertEqual(calls(), {0, 1, 2})
        first.__exit__(None, None, None)
        self.assertEqual(calls(), {1, 2})
        third.__exit__(None, None, None)
        self.assertEqual(calls(), {1})
        second.__exit__(None, None, None)
        self.assertEqual(calls(), set())

    def test_two_tasks_of_asyncio(self):
        async def task(name, begin, end):
            await asyncio.sleep(begin)
            with usac.progress(lambda report: called.append(name) or True):
                await asyncio.sleep(end)

        async def both():
            await asyncio.gather(task("first", 0, 0.02), task("second", 0.01, 0.03))

        called = []
        asyncio.run(both())
        usac.estimateHomography(*hard(), usac.Params(maxTime=30, **ENDLESS))
        self.assertEqual(called, [])

    @package
    def test_left_by_a_component(self):
        """A sampler leaves the context of its own run, also in another thread."""
        class Leaving(usac.Sampler):
            def sample(self, rng, iteration):
                scope.__exit__(None, None, None)
                return rng.distinct(2000, 4)

        def run():
            with scope:
                estimator = usac.Usac.create(usac.HOMOGRAPHY, *hard(), usac.Params(maxTime=50, **ENDLESS))
                estimator.components.sampler = Leaving()
                stops.append(estimator.run()[2].stop)

        scope, stops = usac.progress(lambda report: False), []
        run()
        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
        self.assertEqual(stops, [usac.STOP_TIME] * 2)

    @package
    def test_not_left_by_its_own_function(self):
        def leave(report):
            scope.__exit__(None, None, None)

        scope = usac.progress(leave)
        with scope:
            with self.assertRaisesRegex(ERRORS, "progress"):
                usac.estimateHomography(*hard(), usac.Params(**ENDLESS))

        calls = []

        def nested(report):
            calls.append(report)
            if len(calls) > 1:  # the estimation below calls this function, too
                return True
            with usac.progress(lambda report: True):  # a function may leave a scope that it has entered itself
                usac.estimateHomography(*hard(), usac.Params(maxTime=20, **ENDLESS))
            return False

        with usac.progress(nested):
            _, _, report = usac.estimateHomography(*hard(), usac.Params(**ENDLESS))
        self.assertEqual(report.stop, usac.STOP_CANCELLED)

MODULE = "import cv2; usacv20 = cv2.usacv20" if IN_TREE else "import usacv20"
CHILD = """
import signal, sys
import numpy as np
{module}
signal.signal(signal.SIGINT, signal.default_int_handler)  # background jobs of a shell ignore SIGINT
rng = np.random.RandomState(3)
a, b = rng.uniform(0, 640, (2000, 2)), rng.uniform(0, 640, (2000, 2))
params = usacv20.Params(maxIterations=2**31 - 1, termination=0)
threads = usacv20.Params(maxIterations=2**31 - 1, termination=0, threads=0)
print("ready", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    F, mask, report = usacv20.estimateHomography(a, a + 1)
    print("usable", report.inliers, "cv2" in sys.modules)
"""


class InterruptTest(unittest.TestCase):
    def check(self, call):
        if IN_TREE:  # cv2.usacv20 can be interrupted only within usacv20.progress
            call = "with usacv20.progress(lambda report: True): " + call
        child = subprocess.Popen([sys.executable, "-c", CHILD.format(call=call, module=MODULE)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 universal_newlines=True, env=dict(os.environ))
        try:
            self.assertEqual(child.stdout.readline(), "ready\n")
            time.sleep(0.3)
            start = time.monotonic()
            child.send_signal(signal.SIGINT)
            self.assertEqual(child.stdout.readline(), "interrupted\n")
            self.assertLess(time.monotonic() - start, 1)
            # The first use of usacv20.error imports cv2. An interrupt must not use this class, so cv2
            # must not be loaded, unless cv2.usacv20 is tested.
            self.assertEqual(child.stdout.readline(), "usable 2000 {}\n".format(IN_TREE))
            self.assertEqual(child.wait(), 0)
        finally:
            child.kill()
            child.wait()
            child.stdout.close()

    def test_single(self):
        self.check("usacv20.estimateFundamental(a, b, params)")
        self.check("usacv20.estimateFundamental(a, b, threads)")
        self.check("usacv20.findHomography(a, b, params)")
        if not IN_TREE:
            self.check("usacv20.Usac.create(usacv20.HOMOGRAPHY, a, b, params).run()")

    def test_batch(self):
        self.check("usacv20.estimateHomographies([a] * 100, [b] * 100, params)")
        self.check("usacv20.estimateHomographies([a] * 2, [b] * 2, params)")


if __name__ == "__main__":
    unittest.main()
