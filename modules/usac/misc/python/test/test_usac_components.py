#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of components written in Python: usacv20.Usac with a user-defined Sampler and Score."""

import copy
import doctest
import gc
import pickle
import threading
import unittest
import weakref

import numpy as np

from usac_common import ERRORS, GENERAL, IN_TREE, PLANE, THRESHOLD, ErrorCase, bits, estimate, package, usac
from usac_pose import POSE

Sampler, Score = (object, object) if IN_TREE else (usac.Sampler, usac.Score)


class Uniform(Sampler):
    """A uniform sampler that counts its calls."""

    def __init__(self):
        self.calls, self.starts = 0, 0

    def start(self, points):
        self.points = points
        self.starts += 1

    def sample(self, rng, iteration):
        self.calls += 1
        return rng.distinct(len(self.points.data), self.points.sampleSize)


class Msac(Score):
    """Computes the same score as QUALITY_MSAC."""

    def __init__(self):
        self.threads = set()

    def accumulate(self, squaredErrors, squaredThreshold):
        self.threads.add(threading.get_ident())
        ratios = squaredErrors / np.float32(squaredThreshold)
        with np.errstate(invalid="ignore"):
            inliers = ratios <= 1
        return float(np.where(inliers, ratios, 1).sum()), int(inliers.sum())


def create(problem, scene, **fields):
    params = usac.Params(threshold=THRESHOLD, **fields)
    args = (scene.K1,) if problem == usac.ESSENTIAL else ()
    return usac.Usac.create(problem, scene.points1, scene.points2, params, *args)


@package
class UsacTest(ErrorCase):

    def test_is_the_function(self):
        for problem, name, scene in ((usac.HOMOGRAPHY, "Homography", PLANE), (usac.FUNDAMENTAL, "Fundamental", GENERAL)):
            usac_ = create(problem, scene)
            expected = bits(estimate(name, scene, usac.Params(threshold=THRESHOLD))[:2])
            self.assertEqual(bits(usac_.run()[:2]), expected)
            mask = np.zeros((len(scene.points1), 1), np.uint8)
            self.assertIs(usac_.run(mask)[1], mask)
            usac_.setPoints(scene.points2, scene.points1)
            self.assertNotEqual(bits(usac_.run()[0]), expected[0])
            usac_.setPoints(scene.points1, scene.points2)
            self.assertEqual(bits(usac_.run()[:2]), expected)
        pose = usac.Usac.create(usac.ABSOLUTE_POSE, POSE.X, POSE.x, None, POSE.K, distCoeffs1=POSE.d)
        self.assertEqual(bits(pose.run()[:2]), bits(usac.estimateAbsolutePose(POSE.X, POSE.x, POSE.K, POSE.d)[:2]))
        self.assertEqual(usac.Usac.create(usac.HOMOGRAPHY, np.zeros((0, 2)), np.zeros((0, 2))).run()[1].shape, (0, 1))

    def test_mistakes(self):
        usac_ = create(usac.HOMOGRAPHY, PLANE)
        for word, function in (("problem", lambda: usac.Usac.create(99, PLANE.points1, PLANE.points2)),
                               ("points1", lambda: usac.Usac.create(usac.HOMOGRAPHY, "a", PLANE.points2)),
                               ("cameraMatrix", lambda: usac.Usac.create(usac.ESSENTIAL, PLANE.points1, PLANE.points2)),
                               ("sampler", lambda: setattr(usac_.components, "sampler", 3)),
                               ("score", lambda: setattr(usac_.components, "score", Uniform())),
                               ("points", lambda: usac_.setPoints(PLANE.points1, PLANE.points2[1:]))):
            with self.assertRaisesRegex(usac.error, word):
                function()
        usac_.params = usac_.params  # creates the estimator anew, with the last points that were valid
        self.assertEqual(bits(usac_.run()[:2]), bits(create(usac.HOMOGRAPHY, PLANE).run()[:2]))
        for wrong in ("x", None, [1], True):
            score = Msac()
            score.inlierPart = wrong
            with self.assertRaisesRegex(usac.error, "score.inlierPart: a number"):
                usac_.components.score = score
            self.assertIsNone(usac_.components.score)
        self.assertRaises(TypeError, usac.Sampler)
        self.assertRaises(TypeError, usac.Score)

    def test_components_that_python_cannot_replace(self):
        usac_ = create(usac.HOMOGRAPHY, PLANE)
        for name in ("residual", "localOptimizer", "verifier", "sampelr"):
            self.refused(AttributeError, (name, "sampler", "score", "C++"), setattr, usac_.components, name, None)
            self.refused(AttributeError, (name, "C++"), getattr, usac_.components, name)
        for name in ("sampler", "score"):
            self.refused(AttributeError, (name, "components." + name), setattr, usac_, name, None)
        self.refused(AttributeError, ("scores",), setattr, usac_, "scores", [1])
        self.refused(ERRORS, ("problem",), usac.Usac.create, usac.QUALITY_MSAC, PLANE.points1, PLANE.points2)

    def test_params(self):
        given = usac.Params(threshold=THRESHOLD, seed=3)
        usac_ = usac.Usac.create(usac.HOMOGRAPHY, PLANE.points1, PLANE.points2, given)
        self.assertEqual(usac_.params, given)
        given.threshold = 9
        self.assertEqual(usac_.params.threshold, THRESHOLD)
        self.refused(AttributeError, ("threshold", "replace"), setattr, usac_.params, "threshold", 3)
        for copied in (copy.copy(usac_.params), pickle.loads(pickle.dumps(usac_.params)), usac_.params.replace()):
            copied.threshold = 3
        usac_.params = usac_.params.replace(threshold=1.0, scores=PLANE.inliers.astype(float), scoreOrder="higher_is_better")
        self.refused(ValueError, ("read-only",), usac_.params.scores.__setitem__, 0, 1)
        self.assertEqual(bits(usac_.run()[:2]), bits(estimate("Homography", PLANE, usac_.params)[:2]))
        self.refused(ERRORS, ("threshold",), setattr, usac_, "params", usac.Params(threshold=-1))
        self.refused(ERRORS, ("params",), setattr, usac_, "params", None)
        self.assertEqual(usac_.params.threshold, 1.0)
        self.assertEqual(usac.Usac.create(usac.HOMOGRAPHY, PLANE.points1, PLANE.points2).params, usac.Params())

    def test_scores(self):
        scores = np.where(PLANE.inliers, 0.25, 0.75)
        usac_ = create(usac.HOMOGRAPHY, PLANE)
        usac_.setScores(scores)
        params = usac.Params(threshold=THRESHOLD, scores=scores)
        self.assertEqual(usac_.params, params)
        self.assertEqual(bits(usac_.run()[:2]), bits(estimate("Homography", PLANE, params)[:2]))
        self.refused(ERRORS, ("scores", "300"), usac_.setScores, scores[1:])
        self.assertEqual(usac_.params, params)
        usac_.setPoints(PLANE.points1[:200], PLANE.points2[:200], scores[:200])
        expected = usac.estimateHomography(PLANE.points1[:200], PLANE.points2[:200], params.replace(scores=scores[:200]))
        self.assertEqual(bits(usac_.run()[:2]), bits(expected[:2]))
        usac_.setScores(None)
        self.assertIsNone(usac_.points.scores)

    def test_a_sampler_sees_the_scores_of_the_caller(self):
        scores = np.random.RandomState(2).uniform(0, 1, len(PLANE.points1)).astype(np.float32)
        scores[5] = np.nan
        points1 = PLANE.points1.copy()
        points1[7] = np.nan
        for order in ("higher_is_better", "lower_is_better"):
            params, sampler = usac.Params(threshold=THRESHOLD, scores=scores, scoreOrder=order), Uniform()
            usac_ = usac.Usac.create(usac.HOMOGRAPHY, points1, PLANE.points2, params)
            usac_.components.sampler = sampler
            usac_.run()
            for points in (sampler.points, usac_.points):
                np.testing.assert_array_equal(points.scores, scores[points.inputIndex])
                self.assertEqual((points.data.shape, points.sampleSize), ((299, 4), 4))
                self.assertEqual(sorted(points.inputIndex), sorted(set(range(300)) - {7}))
                for k, array in ((0, points1), (2, PLANE.points2)):
                    scale = np.polyfit(array[points.inputIndex, 0], points.data[:, k], 1)
                    np.testing.assert_allclose(np.polyval(scale, array[points.inputIndex, 0]), points.data[:, k], atol=1e-6)
            usac_.setScores(scores + 1)  # new scores must not remove the sampler
            self.assertIs(usac_.components.sampler, sampler)
            usac_.run()
            np.testing.assert_array_equal(sampler.points.scores, (scores + 1)[sampler.points.inputIndex])

    def test_names_of_an_absolute_pose(self):
        X, x, K = POSE.X, POSE.x, POSE.K
        pose = usac.Usac.create(usac.ABSOLUTE_POSE, X, x, None, K)
        for word, function in (("points1 and points2", lambda: usac.Usac.create(usac.ABSOLUTE_POSE, X, x[1:], None, K)),
                               ("points1", lambda: usac.Usac.create(usac.ABSOLUTE_POSE, x, x, None, K)),
                               ("cameraMatrix1", lambda: usac.Usac.create(usac.ABSOLUTE_POSE, X, x, None, K[:2])),
                               ("distCoeffs1", lambda: usac.Usac.create(usac.ABSOLUTE_POSE, X, x, None, K, distCoeffs1=[1, 2])),
                               ("points1 and points2", lambda: pose.setPoints(X, x[1:]))):
            with self.assertRaises(usac.error) as context:
                function()
            self.assertEqual(context.exception.err.partition(":")[0], word)

    def test_references_in_a_circle(self):
        """The garbage collector frees an estimator whose component refers to it."""
        for name, kind, used in (("sampler", Uniform, False), ("sampler", Uniform, True), ("score", Msac, True)):
            component = kind()
            usac_ = component.usac = create(usac.HOMOGRAPHY, PLANE)
            setattr(usac_.components, name, component)
            if used:
                usac_.run()
            references = weakref.ref(usac_), weakref.ref(component)
            del usac_, component
            gc.collect()
            self.assertEqual([reference() for reference in references], [None, None], name)

    def test_only_the_run_holds_a_reference(self):
        class Dropping(Uniform):
            def sample(self, rng, iteration):
                holder.clear()
                gc.collect(0)
                return super().sample(rng, iteration)

        holder = [create(usac.HOMOGRAPHY, PLANE, maxIterations=50)]
        holder[0].components.sampler = Dropping()
        model, _, _ = holder[0].run()
        self.assertEqual(holder, [])
        self.assertLess(PLANE.error("Homography", model), 1.0)


@package
class SamplerTest(unittest.TestCase):

    def test_draws_the_samples(self):
        fields = dict(sampler=usac.SAMPLER_UNIFORM, degeneracy=0)
        usac_, sampler = create(usac.HOMOGRAPHY, PLANE, **fields), Uniform()
        usac_.components.sampler = sampler
        self.assertIs(usac_.components.sampler, sampler)
        model, mask, report = usac_.run()
        *expected, other = create(usac.HOMOGRAPHY, PLANE, **fields).run()
        self.assertEqual(bits((model, mask)), bits(expected))  # the same samples as in C++
        self.assertEqual(report.iterations, other.iterations)
        self.assertGreaterEqual(sampler.calls, report.iterations)  # samples are drawn in batches; the last batch is not always used up
        self.assertEqual((sampler.starts, sampler.points.sampleSize), (1, 4))
        again = usac_.run()
        self.assertEqual(bits(again[:2]), bits((model, mask)))  # the random numbers of a sampler are the same in each run
        usac_.components.sampler = None
        calls = sampler.calls
        self.assertEqual(bits(usac_.run()[:2]), bits(expected))
        self.assertEqual(sampler.calls, calls)

    def test_samples_that_do_not_count(self):
        class Good(Uniform):
            counts = False

        # Fewer than half of the matches are right, and no sample counts. So only maxIterations can end the
        # search; it would end after about 5000 samples if all counted.
        points2 = PLANE.points2.copy()
        points2[::2] = points2[::2][::-1]
        points2[1::4] = points2[1::4][::-1]
        usac_ = create(usac.HOMOGRAPHY, PLANE, maxIterations=20000, termination=usac.TERMINATION_STANDARD, significance=1)
        usac_.setPoints(PLANE.points1, points2)
        usac_.components.sampler = Good()
        self.assertEqual(usac_.run()[2].stop, usac.STOP_MAX_ITERATIONS)

    def test_sigmas_for_another_number_of_points(self):
        a, b, rows = PLANE.points1, PLANE.points2, np.tile([4., 1, 3], (20, 1))
        wrong = usac.Params(sigmas=rows)  # the standard deviations of 60 points, if the shape is ignored
        with self.assertRaisesRegex(usac.error, "sigmas"):
            usac.Usac.create(usac.HOMOGRAPHY, a[:60], b[:60], wrong)
        usac_ = usac.Usac.create(usac.HOMOGRAPHY, a[:60], b[:60])
        with self.assertRaisesRegex(usac.error, "sigmas"):
            usac_.params = wrong
        usac_.setPoints(a[:20], b[:20])
        usac_.params = wrong
        for scores in (None, np.ones(60)):
            with self.assertRaisesRegex(usac.error, "sigmas"):
                usac_.setPoints(a[:60], b[:60], scores)
        usac_.setScores(np.ones(20))
        self.assertEqual(len(usac_.run()[1]), 20)

    def test_wrong_samples(self):
        class Wrong(Uniform):
            def sample(self, rng, iteration):
                return self.wrong

        usac_, sampler = create(usac.HOMOGRAPHY, PLANE), Wrong()
        usac_.components.sampler = sampler
        for wrong in ([1, 2, 3], [1, 2, 3, 4, 5], [1, 2, 3, 300], [-1, 2, 3, 4], [1, 1, 2, 3], None, "abcd", [1.5, 2, 3, 4], 7,
                      np.zeros((4, 1), int), [[1, 2], [3, 4]], [1, 2, 3, 2**32 + 4], np.uint64([1, 2, 3, 2**64 - 1])):
            sampler.wrong = wrong
            with self.assertRaises(usac.error, msg=wrong) as context:
                usac_.run()
            self.assertIn("sampler", str(context.exception))
        for right in ([1, 2, 3, 4], (1, 2, 3, 4), np.array([1, 2, 3, 4]), np.uint8([1, 2, 3, 4])):
            sampler.wrong = right
            usac_.run()

    def test_exceptions_end_the_run(self):
        class Failing(Uniform):
            def sample(self, rng, iteration):
                if iteration == 2:
                    raise KeyError("mine")
                return super().sample(rng, iteration)

        for threads in (1, 4):
            usac_ = create(usac.HOMOGRAPHY, PLANE, threads=threads)
            usac_.components.sampler = Failing()
            with self.assertRaisesRegex(KeyError, "mine"):
                usac_.run()
            usac_.components.sampler = None
            self.assertEqual(bits(usac_.run()[:2]), bits(create(usac.HOMOGRAPHY, PLANE).run()[:2]))

    def test_is_for_one_thread_at_a_time(self):
        test = self

        class Nosy(Uniform):
            def sample(self, rng, iteration):
                for function in (usac_.run, lambda: usac_.setPoints(PLANE.points1, PLANE.points2),
                                 lambda: setattr(usac_.components, "sampler", None)):
                    with test.assertRaisesRegex(usac.error, "running"):
                        function()
                return super().sample(rng, iteration)

        usac_ = create(usac.HOMOGRAPHY, PLANE, maxIterations=10)
        usac_.components.sampler = Nosy()
        usac_.run()


@package
class ScoreTest(unittest.TestCase):

    def test_is_that_of_cpp(self):
        fields = dict(termination=0, maxIterations=400, verification=usac.VERIFICATION_NONE)
        expected = create(usac.ESSENTIAL, GENERAL, **fields).run()
        for threads in (1, 2, 4):
            usac_, score = create(usac.ESSENTIAL, GENERAL, threads=threads, **fields), Msac()
            usac_.components.score = score
            self.assertIs(usac_.components.score, score)
            model, mask, report = usac_.run()
            self.assertGreater(len(score.threads), 0)
            np.testing.assert_array_equal(mask, expected[1])
            self.assertLess(GENERAL.error("Essential", model), 1.0)
            self.assertAlmostEqual(report.cost, expected[2].cost, 5)
            self.assertEqual(bits(usac_.run()[:2]), bits((model, mask)))

    def test_part_of_the_threshold(self):
        class Wide(Msac):
            inlierPart = 0.5

            def accumulate(self, squaredErrors, squaredThreshold):
                return super().accumulate(squaredErrors, squaredThreshold)[0], int((squaredErrors * 4 <= squaredThreshold).sum())

        usac_ = create(usac.HOMOGRAPHY, PLANE)
        usac_.components.score = Wide()
        self.assertLess(PLANE.error("Homography", usac_.run()[0]), 1.0)
        Wide.inlierPart = 1.5
        usac_.components.score = Wide()
        self.assertRaisesRegex(usac.error, "inlierPart", usac_.run)

    def test_whole_model(self):
        test = self

        class Median(Msac):
            wholeModel = True

            def accumulate(self, squaredErrors, squaredThreshold):
                # errors of all 300 points, or the 16 made-up errors of the check before the search
                test.assertIn(len(squaredErrors), (16, 300))
                return super().accumulate(squaredErrors, squaredThreshold)

        usac_ = create(usac.HOMOGRAPHY, PLANE)
        usac_.components.score = Median()
        self.assertLess(PLANE.error("Homography", usac_.run()[0]), 1.0)

    def test_exceptions_end_the_run(self):
        class Failing(Msac):
            def accumulate(self, squaredErrors, squaredThreshold):
                if len(squaredErrors) != 16:
                    raise ZeroDivisionError("mine")
                return super().accumulate(squaredErrors, squaredThreshold)

        for threads in (1, 4):
            usac_ = create(usac.FUNDAMENTAL, GENERAL, threads=threads)
            usac_.components.score = Failing()
            for _ in range(20):
                with self.assertRaisesRegex(ZeroDivisionError, "mine"):
                    usac_.run()

    def test_wrong_results(self):
        class Wrong(Msac):
            def accumulate(self, squaredErrors, squaredThreshold):
                return self.wrong

        usac_, score = create(usac.HOMOGRAPHY, PLANE), Wrong()
        usac_.components.score = score
        for wrong in (None, 3, "ab", (1.0,), (1, 2, 3), (-1.0, 16), (float("nan"), 16), (1e9, 16), (0.0, 0)):
            score.wrong = wrong
            with self.assertRaises(usac.error, msg=wrong) as context:
                usac_.run()
            self.assertIn("score", str(context.exception))


@package
class DocumentTest(unittest.TestCase):

    def test_examples(self):
        runner = doctest.DocTestRunner()
        for type_ in (usac.Sampler, usac.Score):
            for test in doctest.DocTestFinder(recurse=False).find(type_, type_.__name__, module=False, globs={}):
                runner.run(test)
        self.assertEqual((runner.failures, runner.tries > 10), (0, True))

    def test_rng(self):
        rng = usac.Rng(1, 2)
        self.assertEqual(rng.next(), usac.Rng(1, 2).next())
        self.assertEqual(sorted(set(rng.distinct(8, 8))), list(range(8)))
        self.assertTrue(all(0 <= rng.uniform(3) < 3 for _ in range(100)))
        for wrong in ((3, 4), (100, 9), (10, -1)):
            self.assertRaises(usac.error, rng.distinct, *wrong)
        self.assertRaises(usac.error, rng.uniform, 0)


if __name__ == "__main__":
    unittest.main()
