#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of estimateTwoViewGeometry and estimateTwoViewGeometries: configurations, many pairs in one
call, wrong arguments, and the number of samples that TwoViewRules determines."""

import os
import pickle
import subprocess
import sys
import unittest

import numpy as np

from usac_camera import rotation
from usac_common import ERRORS, bits, package, usac

K = np.array([[900., 0, 640], [0, 900, 480], [0, 0, 1]])
SIZE = (1280, 960)
PROGRAM = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "benchmark", "collection",
                                        "configurations.py"))


def scene(seed, kind="general", right=150, wrong=60):
    """Returns (points1, points2, R, t) of two cameras with the matrix K. The first `right` matches
    are right, with noise of standard deviation 0.4 pixels; the other `wrong` matches are random."""
    rng = np.random.RandomState(seed)
    R, t = rotation(rng.normal(0, 0.1, 3)), np.array([1, 0.2, 0.1]) * (kind != "rotation")
    X = rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (right, 3))
    if kind == "plane":
        X[:, 2] = 6 + 0.3 * X[:, 0]
    first, second = X, X @ R.T + t
    images = []
    for points in (first, second):
        x = points @ K.T
        images.append(np.concatenate([x[:, :2] / x[:, 2:] + rng.normal(0, 0.4, (right, 2)), rng.uniform(0, SIZE, (wrong, 2))]))
    return images[0], images[1], R, t


def values(geometry):
    """Returns the parts of a result that must be equal in each run, without the times."""
    return (geometry.configuration, geometry.inliers, geometry.iterations, geometry.reason, geometry.report.chance,
            bits(tuple(getattr(geometry, name) for name in ("mask", "F", "E", "H", "R", "t", "rotations"))))


class TwoViewTest(unittest.TestCase):

    def test_calibrated(self):
        a, b, R, t = scene(1)
        found = usac.estimateTwoViewGeometry(a, b, K, K, params=usac.Params(threshold=1.5))
        self.assertIs(found.configuration, usac.TWO_VIEW_CALIBRATED)
        self.assertEqual((found.R.shape, found.t.shape, found.mask.shape), ((3, 3), (3, 1), (210, 1)))
        np.testing.assert_allclose(found.R, R, atol=0.01)
        np.testing.assert_allclose(found.t.ravel(), t / np.linalg.norm(t), atol=0.05)
        self.assertGreater(found.mask[:150].sum(), 140)
        np.testing.assert_array_equal(found.rotations, found.R[None])
        self.assertEqual((found.reason, found.report.inliers, found.inliers), ("", found.inliers, found.mask.sum()))
        F = np.linalg.inv(K).T @ found.E @ np.linalg.inv(K)
        np.testing.assert_allclose(found.F, F / np.linalg.norm(F), atol=1e-12)

    def test_sigmas(self):
        a, b, _, _ = scene(1)
        sigmas = np.where(np.arange(len(a)) % 2, 2., 0.4)
        found, = usac.estimateTwoViewGeometries([usac.TwoViewPair(a, b, K, K, sigmas=sigmas)], usac.Params(threshold=3))
        shared = usac.estimateTwoViewGeometry(a, b, K, K, params=usac.Params(threshold=3, sigmas=sigmas))
        np.testing.assert_array_equal(shared.mask, found.mask)
        plain = usac.estimateTwoViewGeometry(a, b, K, K, params=usac.Params(threshold=3))
        self.assertTrue((plain.mask != found.mask).any())

    def test_other_configurations(self):
        for kind, cameras, expected in (("general", (None, None), usac.TWO_VIEW_UNCALIBRATED),
                                        ("general", (K, None), usac.TWO_VIEW_UNCALIBRATED),
                                        ("plane", (K, K), usac.TWO_VIEW_PLANAR), ("plane", (None, None), usac.TWO_VIEW_PLANAR_OR_PANORAMIC),
                                        ("rotation", (K, K), usac.TWO_VIEW_PANORAMIC)):
            a, b, R, _ = scene(1, kind)
            found = usac.estimateTwoViewGeometry(a, b, *cameras)
            self.assertIs(found.configuration, expected)
            if cameras[1] is None:
                self.assertEqual((found.E, found.rotations), (None, None))
            else:
                self.assertLess(min(np.abs(other - R).max() for other in found.rotations), 0.02)
        found = usac.estimateTwoViewGeometry(*scene(1, right=0)[:2], K, K)
        self.assertEqual((found.configuration, found.inliers, found.mask.sum(), found.F), (usac.TWO_VIEW_DEGENERATE, 0, 0, None))
        self.assertRegex(found.reason, "^[EFH]: ")
        few = usac.estimateTwoViewGeometry(np.zeros((3, 2)), np.zeros((3, 2)))
        self.assertEqual(few.reason, "3 matches, 15 are needed")

    def test_rules(self):
        params = usac.Params(confidence=0.999)
        plain, known = usac.TwoViewRules(), usac.TwoViewRules(ratios=(0.5,) * 30)
        self.assertLess(known.samples(params, 5, 75), plain.samples(params, 5, 75))
        self.assertLess(plain.reached(params.replace(maxIterations=100), 5, 75), 0.999)
        self.assertEqual(pickle.loads(pickle.dumps(known)), known)

    def test_watermark(self):
        rng = np.random.RandomState(1)
        a = rng.uniform([10, 900], [300, 950], (60, 2))
        b = a + [2, 0] + rng.normal(0, 0.3, a.shape)
        self.assertIsNot(usac.estimateTwoViewGeometry(a, b).configuration, usac.TWO_VIEW_WATERMARK)
        found = usac.estimateTwoViewGeometry(a, b, imageSize1=SIZE, imageSize2=SIZE)
        self.assertIs(found.configuration, usac.TWO_VIEW_WATERMARK)
        moved = usac.TwoViewPair(a, b, imageSize1=SIZE, imageSize2=SIZE, taken2=b - [0, 400])
        self.assertIsNot(usac.estimateTwoViewGeometries([moved])[0].configuration, usac.TWO_VIEW_WATERMARK)

    def test_same_as_one_by_one(self):
        pairs = [usac.TwoViewPair(*scene(seed, kind, wrong=40 * seed)[:2], *cameras)
                 for seed in range(4) for kind in ("general", "plane", "rotation") for cameras in ((), (K, K))]
        expected = [values(usac.estimateTwoViewGeometry(*pair[:4])) for pair in pairs]
        for threads in (0, 1, 2, 3):
            self.assertEqual([values(found) for found in usac.estimateTwoViewGeometries(pairs, threads=threads)], expected)
        self.assertEqual(usac.estimateTwoViewGeometries([]), [])

    def test_scores(self):
        a, b, _, _ = scene(1, right=40, wrong=960)
        scores = np.where(np.arange(1000) < 40, 0.1, 0.9) + np.random.RandomState(1).uniform(-.05, .05, 1000)
        params = usac.Params(maxIterations=60, threshold=1.5)
        plain, ranked = usac.estimateTwoViewGeometries([usac.TwoViewPair(a, b, K, K),
                                                        usac.TwoViewPair(a, b, K, K, scores=scores)], params)
        self.assertIs(plain.configuration, usac.TWO_VIEW_DEGENERATE)
        self.assertIs(ranked.configuration, usac.TWO_VIEW_CALIBRATED)

    def test_mistakes(self):
        a, b, _, _ = scene(1)
        for arguments, named in (((a, b[1:]), "points1 and points2"), ((a, b, np.zeros((3, 3))), "cameraMatrix1"),
                                 ((a, b, None, K, [0.1, 0, 0, 0]), "distCoeffs1")):
            with self.assertRaisesRegex(ERRORS, named):
                usac.estimateTwoViewGeometry(*arguments)
        for rules, named in ((usac.TwoViewRules(minInliers=0), "minInliers"), (usac.TwoViewRules(ratios=(2.,)), "ratios"),
                             (15, "rules")):
            with self.assertRaisesRegex(ERRORS, named):
                usac.estimateTwoViewGeometry(a, b, rules=rules)
        with self.assertRaisesRegex(ERRORS, "imageSize1"):
            usac.estimateTwoViewGeometry(a, b, imageSize1=640)
        with self.assertRaisesRegex(ERRORS, "initialModel"):
            usac.estimateTwoViewGeometry(a, b, params=usac.Params(initialModel=np.eye(3)))
        with self.assertRaisesRegex(ERRORS, "quality"):
            usac.estimateTwoViewGeometry(a, b, params=usac.Params.lmeds())
        with self.assertRaisesRegex(ERRORS, "initialModel"):  # the call itself must fail, not each pair
            usac.estimateTwoViewGeometries([usac.TwoViewPair(a, b)], usac.Params(initialModel=np.eye(3)), returnExceptions=True)
        for wrong in (np.ones(len(a) - 1), np.zeros(len(a))):
            with self.assertRaisesRegex(ERRORS, "sigmas"):
                usac.estimateTwoViewGeometries([usac.TwoViewPair(a, b, sigmas=wrong)])
        for scores, sigmas in ((np.ones((len(a) // 3, 3)), None), (None, np.ones((len(a) // 3, 3))),
                               (None, np.ones((len(a) // 6, 6)))):
            pair = usac.TwoViewPair(a, b, scores=scores, sigmas=sigmas)
            with self.assertRaisesRegex(ERRORS, r"pairs\[0\]\.{}".format("scores" if sigmas is None else "sigmas")):
                usac.estimateTwoViewGeometries([pair])
        params = usac.Params(sigmas=np.ones((len(a) // 3, 3)))
        with self.assertRaisesRegex(ERRORS, "^sigmas"):
            usac.estimateTwoViewGeometry(a, b, params=params)
        pairs = [usac.TwoViewPair(a, b, sigmas=np.ones((len(a), 1))), usac.TwoViewPair(a, b), usac.TwoViewPair(a, b, sigmas=[])]
        found = usac.estimateTwoViewGeometries(pairs, params, returnExceptions=True)
        self.assertIs(found[0].configuration, usac.TWO_VIEW_UNCALIBRATED)
        for i in (1, 2):
            self.assertRegex(str(found[i]), r"^pairs\[{}\]: sigmas".format(i))
        confident = np.hstack([a, np.linspace(0.2, 0.9, len(a))[:, None]])
        for wrong, named in ((dict(taken1=confident), r"pairs\[0\]\.taken1.*confidence"),
                             (dict(taken2=np.stack([b, b])), r"pairs\[0\]\.taken2.*one list")):
            with self.assertRaisesRegex(ERRORS, named):
                usac.estimateTwoViewGeometries([usac.TwoViewPair(a, b, **wrong)])
        pairs = [usac.TwoViewPair(a, b), usac.TwoViewPair(a, b[1:]), usac.TwoViewPair("no", b)]
        found = usac.estimateTwoViewGeometries(pairs, returnExceptions=True)
        self.assertIs(found[0].configuration, usac.TWO_VIEW_UNCALIBRATED)
        self.assertRegex(str(found[1]), r"pairs\[1\]: points1 and points2")
        self.assertRegex(str(found[2]), r"pairs\[2\]\.points1")
        with self.assertRaisesRegex(ERRORS, r"pairs\[1\]"):
            usac.estimateTwoViewGeometries(pairs[:2])

    def test_no_lists(self):
        a, b, _, _ = scene(1)
        for pairs, words in ((5, "pairs: a list"), (None, "pairs: a list"), ([(a, b), 5], r"pairs\[1\]: a TwoViewPair"),
                             ([(a,)], r"pairs\[0\]: a TwoViewPair"), ([(a, b) + (None,) * 11], r"pairs\[0\]: a TwoViewPair")):
            with self.assertRaisesRegex(ERRORS, words):
                usac.estimateTwoViewGeometries(pairs)
        found = usac.estimateTwoViewGeometries(iter([(a, b), 5]), returnExceptions=True)
        self.assertIs(found[0].configuration, usac.TWO_VIEW_UNCALIBRATED)
        self.assertRegex(str(found[1]), r"pairs\[1\]: a TwoViewPair")
        for wrong in (0.5, None, [[0.5]], "ab"):
            with self.assertRaisesRegex(ERRORS, "ratios: "):
                usac.TwoViewRules(ratios=wrong).check()


@package
@unittest.skipUnless(os.path.exists(PROGRAM), "the programs of the benchmark are not here")
class ConfigurationsTest(unittest.TestCase):
    """Tests of the benchmark program that counts the configurations of synthetic pairs."""

    def test_options(self):
        done = subprocess.run([sys.executable, PROGRAM, "--scenes", "1", "--kinds", "repeated", "--motions", "forward", "short",
                               "--threshold", "2", "--samples", "1000", "--cells"], stdout=subprocess.PIPE, universal_newlines=True,
                              check=True)
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()]
        rows = {tuple(line[:2]): dict(zip(lines[0][2:], map(int, line[2:]))) for line in lines[2:]}
        self.assertEqual(rows["repeated", "forward"]["pairs"], 81)
        self.assertEqual(len(rows), 2 * (1 + 81))
        for (kind, motion), row in rows.items():
            self.assertEqual(row["pairs"], sum(row[name] for name in row if name not in ("pairs", "changed")), kind)
            self.assertEqual(row["pairs"], 81 if kind == "repeated" else 1)


if __name__ == "__main__":
    unittest.main()
