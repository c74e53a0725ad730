#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests that cv2.usacv20 and the package usacv20 give identical results: the results of each must
have the hashes in hashes.json.

After a change of the algorithms, `python3 test_usac_hashes.py --write` stores the new hashes, from
the results of the module under test."""

import hashlib
import json
import os
import sys
import unittest

import numpy as np

from usac_camera import project
from usac_common import usac

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "hashes.json")
K = np.array([[800., 0, 320], [0, 780., 240], [0, 0, 1]])
DISTORTION = np.array([-0.1, 0.02, 0.001, -0.001, 0])
PRESETS = ("usacV20", "fast", "accurate", "sorted", "parallel", "ransac", "msac", "lmeds", "mlesac", "prosac", "loRansac", "floRansac",
           "gcRansac", "usac2013", "magsac", "magsacPlusPlus", "automatic", "paper")


def scene(seed, count):
    """Returns seven arrays of corresponding points, in which a third of the rows are outliers: 3-D
    points; their pixels in camera 1, in camera 2, and in camera 2 with lens distortion; the 3-D points
    moved by a similarity; the pixels of camera 1 moved by a similarity; and the pixels of camera 1
    moved by a translation. All are rounded to multiples of 1/64, so that rounding errors of NumPy's
    functions do not change them."""
    rng = np.random.RandomState(seed)
    X = np.rint(rng.uniform([-2, -1.5, 4], [2, 1.5, 8], (count, 3)) * 64) / 64
    r, t = [0.03, -0.1, 0.05], [-0.8, 0.1, 0.1]
    views = [project(X, np.zeros(3), np.zeros(3), K), project(X, r, t, K), project(X, r, t, K, DISTORTION)]
    views = [view + rng.normal(0, 0.4, view.shape) for view in views]
    bad = rng.permutation(count)[:count // 3]
    for view in views[1:]:
        view[bad] = rng.uniform(0, [640, 480], (len(bad), 2))
    moved = 2 * X[:, [1, 2, 0]] + [1, 2, 3] + rng.normal(0, 0.01, X.shape)
    moved[bad] = rng.uniform(-5, 5, (len(bad), 3))
    plane = views[0].dot([[0.9, -0.2], [0.2, 0.9]]) + [40, -25] + rng.normal(0, 0.4, views[0].shape)
    plane[bad] = views[1][bad]
    # This array was added later. It is drawn last, so that it does not change the random numbers of the
    # others.
    shifted = views[0] + [37.25, -12.5] + rng.normal(0, 0.4, views[0].shape)
    shifted[bad] = views[1][bad]
    return [np.rint(points * 64) / 64 for points in (X, *views, moved, plane, shifted)]


def calls(seed, count):
    """Returns [(name of the problem, function of Params that estimates the model)]."""
    X, a, b, distorted, moved, plane, shifted = scene(seed, count)
    none = (None, None, None)
    return [("Homography", lambda p: usac.estimateHomography(a, plane, p)),
            ("Affinity2D", lambda p: usac.estimateAffinity2D(a, plane, p)),
            ("Similarity2D", lambda p: usac.estimateSimilarity2D(a, plane, p)),
            ("Fundamental", lambda p: usac.estimateFundamental(a, b, p)),
            ("Essential", lambda p: usac.estimateEssential(a, b, K, *none, p)),
            ("Essential, distorted", lambda p: usac.estimateEssential(a, distorted, K, K, None, DISTORTION, p)),
            ("AbsolutePose", lambda p: usac.estimateAbsolutePose(X, distorted, K, DISTORTION, p)),
            ("Rigid3D", lambda p: usac.estimateRigid3D(2 * X, moved, p)),
            ("Similarity3D", lambda p: usac.estimateSimilarity3D(X, moved, p)),
            ("Translation2D", lambda p: usac.estimateTranslation2D(a, shifted, p))]


def digest(result):
    model, mask, report = result
    numbers = b"none" if model is None else model.astype("<f8").tobytes()
    text = "{} {} {} {!r}".format(int(report.stop), report.iterations, report.inliers, report.cost)
    return hashlib.sha256(numbers + mask.tobytes() + text.encode()).hexdigest()[:16]


def results():
    found = {}
    for seed, count in ((1, 300), (2, 90)):
        for name, function in calls(seed, count):
            for preset in PRESETS:
                params = getattr(usac.Params, preset)()
                params.threshold, params.maxIterations = (0.04 if name.endswith("3D") else 2.0), 500
                if params.degeneracy == usac.DEGENERACY_ORIENTATION | usac.DEGENERACY_DEGENSAC and name in (
                        "Affinity2D", "Similarity2D", "AbsolutePose", "Rigid3D", "Similarity3D", "Translation2D"):
                    continue  # these problems refuse DEGENERACY_DEGENSAC, see DegeneracyFlags
                found["{} {} {}".format(name, preset, count)] = digest(function(params))
    return found


class HashTest(unittest.TestCase):

    def test_stored(self):
        with open(FILE) as file:
            expected = json.load(file)
        found = results()
        self.assertEqual(sorted(found), sorted(expected))
        self.assertEqual([name for name in found if found[name] != expected[name]], [])
        self.assertGreater(len(set(found.values())), 200)  # makes sure that not all results are failures


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        with open(FILE, "w") as file:
            json.dump(results(), file, indent=0, sort_keys=True)
            file.write("\n")
    else:
        unittest.main()
