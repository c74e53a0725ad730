#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of absolute pose: views that usac_synthetic and views.py write, and the measures of
usac_benchmark on them.

The environment variable USAC_BENCHMARK is the path of the program usac_benchmark; usac_synthetic and
usac_test_methods are taken from the same folder."""

import os
import unittest

import numpy as np

import pairs
from test_benchmark import K, FolderTest, rotation
from test_problems import ProgramTest, program
import views

RIVALS = ["cv:PNP_ITERATIVE", "cv:PNP_P3P", "cv:PNP_AP3P", "cv:PNP_EPNP", "cv:PNP_SQPNP", "cv:USAC_DEFAULT", "cv:USAC_FAST",
          "cv:USAC_ACCURATE", "cv:USAC_MAGSAC", "cv:USAC_PROSAC+scores"]
OWN = ["USACV20", "USACV20_FAST", "USACV20_MAGSAC", "USACV20+scores", "preset:msac{maxIterations=500}"]


def project(view, R, t):
    """Returns the pixels and the depths of the object points for the pose R, t. Only the first
    coefficient (k1) of the distortion is applied."""
    x = view.object_points @ R.T + t
    normalized = x[:, :2] / x[:, 2:]
    k1 = view.dist_coeffs[0] if len(view.dist_coeffs) else 0
    normalized *= 1 + k1 * (normalized ** 2).sum(1, keepdims=True)
    return normalized * np.diag(view.K)[:2] + view.K[:2, 2], x[:, 2]


def distances(view, R, t):
    """Returns the reprojection errors for the pose R, t in pixels; infinity for points behind the
    camera."""
    pixels, depths = project(view, R, t)
    return np.where(depths > 0, np.linalg.norm(pixels - view.points, axis=1), np.inf)


def angle(R):
    return np.degrees(np.arccos((np.trace(R) - 1) / 2))


def near_view(count=30, **changes):
    """Returns a view of `count` points without noise whose pose is close to the identity unless
    `changes` has another one. The first five matches are not marked as right."""
    points = np.random.RandomState(4).uniform((-2, -1.5, 4), (2, 1.5, 9), (count, 3))
    values = dict(object_points=points, points=np.zeros((count, 2)), scores=np.linspace(0, 1, count), K=K,
                  R=rotation((1, 2, 0.5), 0.4), t=(0.02, -0.01, 0.03), dist_coeffs=(-0.1, 0, 0, 0), right=range(5, count))
    values.update(changes)
    view = views.View(**values)
    view.points = project(view, view.R, view.t)[0]
    return view


class ViewsTest(FolderTest):

    def test_round_trip(self):
        view = near_view(extra={"size": [640, 480]})
        views.write_view(self.path("pairs", "set", "a"), view)
        again = views.read_view(self.path("pairs", "set", "a"))
        for name, tolerance in (("object_points", 6e-7), ("points", 6e-5), ("scores", 1e-6), ("K", 0), ("R", 0), ("t", 0),
                                ("dist_coeffs", 0)):
            np.testing.assert_allclose(getattr(again, name), getattr(view, name), rtol=0, atol=tolerance, err_msg=name)
        self.assertEqual((again.right, again.extra), (list(range(5, 30)), {"size": [640, 480]}))
        os.remove(self.path("pairs", "set", "a.score"))
        self.assertEqual(set(views.read_view(self.path("pairs", "set", "a")).scores), {1.0})

    def test_nonsense_is_not_written(self):
        for changes, complaint in (({"scores": [1]}, "differ in number"), ({"R": 2 * np.eye(3)}, "no rotation"),
                                   ({"K": np.zeros((3, 3))}, "K: singular"), ({"dist_coeffs": (1, 2)}, "distCoeffs"),
                                   ({"right": [30]}, "gt_mask"), ({"t": (0, 0, -20)}, "behind the camera"),
                                   ({"t": None}, "t: missing"), ({"t": (0, 0, np.nan)}, "t: not finite")):
            view = near_view()
            for name, value in changes.items():
                setattr(view, name, value if value is None or name == "right" else np.asarray(value, float))
            with self.assertRaisesRegex(pairs.PairError, complaint):
                views.write_view(self.path("bad"), view)
        with self.assertRaisesRegex(pairs.PairError, "K: expected 3 x 3 numbers"):
            near_view(K=[1, 2])
        self.assertEqual(os.listdir(self.folder), [])

    def test_messages_name_file_and_line(self):
        path = self.path("a")
        for ending, contents, complaint in ((".txt", "1 2 3 4 5\n\n1 2 3 4\n", r"a\.txt:3: expected 'X Y Z u v'"),
                                            (".score", "0.5\n0.5 0.5\n", r"a\.score:2: expected a score"),
                                            (".json", '{"problem": ["E"]}', r"a\.json: problem: the pair is not one for P"),
                                            (".json", '{"K": [1]}', r"a\.json: K: expected 3 x 3 numbers")):
            views.write_view(path, near_view())
            self.put("a" + ending, contents)
            with self.assertRaisesRegex(pairs.PairError, complaint):
                views.read_view(path)


@unittest.skipUnless(os.path.isfile(program("usac_synthetic")), "there is no usac_synthetic beside USAC_BENCHMARK")
class SyntheticViewTest(ProgramTest):

    def view(self, scene, *options):
        self.write_scenes(scene, "--pairs=1", "--noise=0", *options)
        paths = pairs.read_list(pairs.list_file(self.folder, scene, "P"))
        self.assertEqual([os.path.basename(path) for path in paths], ["0000"])
        return views.read_view(paths[0])

    def test_scene(self):
        for distortion in (0, -0.3, 0.2):
            view = self.view("view", "--size=100", "--inliers=0.3", "--scores=1", "--distortion=%g" % distortion)
            self.assertEqual((len(view.points), len(view.right), len(view.dist_coeffs)), (100, 30, 4 if distortion else 0))
            errors, depths = distances(view, view.R, view.t), project(view, view.R, view.t)[1]
            self.assertLess(errors[view.right].max(), 1e-3)
            self.assertGreater(np.median(np.delete(errors, view.right)), 50)
            self.assertTrue(4 - 1e-5 < depths.min() < 5 and 8 < depths.max() < 9 + 1e-5, depths)
            self.assertLess(view.scores[view.right].max(), np.delete(view.scores, view.right).min(),
                            "with --scores=1, each right match must have a better score than all wrong ones")
            self.assertTrue((view.points > 0).all() and (view.points < (640, 480)).all())

    def test_plane(self):
        for thickness in (0, 0.02):
            view = self.view("viewPlane", "--size=2000", "--thickness=%g" % thickness)
            centered = view.object_points - view.object_points.mean(0)
            flatness = np.linalg.svd(centered, compute_uv=False)[2] / np.sqrt(2000)
            normal = np.linalg.svd(centered)[2][2]
            distance = abs(normal @ (view.object_points.mean(0) + view.R.T @ view.t))
            self.assertAlmostEqual(flatness / distance, thickness, delta=1e-6 if thickness == 0 else 0.002)
            self.assertLess(distances(view, view.R, view.t)[view.right].max(), 1e-3)

    def test_outliers(self):
        view = self.view("view", "--size=200", "--outliers=clustered")
        wrong = np.delete(np.arange(200), view.right)
        self.assertEqual(len(wrong), 100)
        self.assertLess(np.ptp(view.points[wrong], axis=0).max(), 80)
        self.assertLess(np.ptp(project(view, view.R, view.t)[0][wrong], axis=0).max(), 80)
        self.assertGreater(np.median(distances(view, view.R, view.t)[wrong]), 5)

    def test_second_pose(self):
        """Half of the 100 wrong matches agree with a second pose. From the wrong matches alone, an
        estimator must find this pose. The result must count as failed, because the second pose differs
        from the true one."""
        view = self.view("view", "--size=200", "--outliers=second")
        wrong = np.delete(np.arange(200), view.right)
        alone = views.View(view.object_points[wrong], view.points[wrong], view.scores[wrong], view.K, view.R, view.t)
        views.write_view(self.path("pairs", "view", "0000"), alone)
        row = self.benchmark(["cv:USAC_DEFAULT"], "--threshold=1")[0]["cv:USAC_DEFAULT"][0]
        self.assertTrue(50 <= int(row["inliers"]) <= 52, row)
        self.assertEqual(row["failed"], "1", "the second pose is not the right one")

    def test_same_options_write_the_same(self):
        texts = []
        for seed in (1, 1, 2):
            self.write_scenes("view", "--pairs=1", "--size=30", "--duplicates=0.5", "--seed=%d" % seed)
            texts.append([self.text("view", "0000" + ending) for ending in (".txt", ".score", ".json")])
        self.assertEqual(texts[0], texts[1])
        for one, other in zip(texts[0], texts[2]):
            self.assertNotEqual(one, other)
        self.assertEqual(len(set(texts[0][0].split("\n")[:-1])), 30 - 7)

    def test_methods(self):
        self.write_scenes("view", "--pairs=2", "--size=300", "--inliers=0.7", "--scores=0.9", "--noise=0.3", "--distortion=-0.2")
        self.write_scenes("viewPlane", "--pairs=2", "--size=300", "--inliers=0.8", "--noise=0.3")
        self.write_scenes("planar", "--pairs=1", "--size=100")
        runs, tables, text = self.benchmark(OWN + RIVALS + ["cv:RANSAC"])
        self.assertIn("## view (P, 2 pairs, threshold 4, 1000 iterations, confidence 0.99)", text)
        self.assertIn("P, R, M: the error is that of the rotation in degrees", text)
        for method in OWN + RIVALS:
            rows = [row for row in runs[method] if row["problem"] == "P"]
            self.assertEqual(len(rows), 4, method)
            for row in rows:
                self.assertEqual((row["failed"], row["pose_error"]), ("0", row["error"]), method)
                self.assertEqual(row["iterations"] != "", method in OWN)
                self.assertLess(float(row["error"]), 0.5)
                self.assertLess(float(row["center_error"]), 1)
                # The mask of OpenCV's PnP methods can be that of a minimal sample's model, so their
                # number of inliers can differ more from the number of right matches than that of other methods.
                self.assertLess(abs(int(row["inliers"]) - (210 if row["list"] == "view" else 240)),
                                40 if method.startswith("cv:PNP") else 10, method)
                self.assertLess(float(row["cost"]), 0.35)
            rotations = [float(row["error"]) for row in rows if row["list"] == "view"]
            table = tables["view", method]
            self.assertAlmostEqual(float(table["auc1"]), 100 * (1 - np.mean(rotations)), delta=1e-2)
            self.assertAlmostEqual(float(table["median_error"]), np.median(rotations), delta=1e-5)
            self.assertEqual((table["auc5"], table["auc10"], table["auc20"]), ("", "", ""))
        self.assertEqual({row["problem"] for row in runs["cv:RANSAC"]}, {"H"})
        self.assertEqual(tables["average", "cv:USAC_FAST"]["median_error"], tables["planar", "cv:USAC_FAST"]["median_error"],
                         "errors in degrees must not be averaged with errors in pixels")
        self.assertNotEqual(tables["average.P", "cv:USAC_FAST"]["median_error"], "")

    def test_threshold_is_in_pixels_of_the_image(self):
        """The lens has a strong distortion. The number of inliers must be close to the number of
        matches whose reprojection error, in pixels of the distorted image, is below the threshold."""
        self.write_scenes("view", "--pairs=1", "--size=200", "--inliers=0.8", "--noise=1", "--distortion=-0.4")
        view = views.read_view(self.path("pairs", "view", "0000"))
        errors = distances(view, view.R, view.t)
        for threshold in (1, 2, 4):
            row = self.benchmark(["USACV20_ACCURATE"], "--threshold=%g" % threshold)[0]["USACV20_ACCURATE"][0]
            self.assertLess(abs(int(row["inliers"]) - np.sum(errors < threshold)), 12)

    def test_columns_without_views(self):
        """Files without results of P, R or M must not have the columns that only these problems need."""
        self.write_scenes("planar", "--pairs=1", "--size=50")
        runs, tables, text = self.benchmark(["cv:RANSAC"])
        self.assertEqual(list(runs["cv:RANSAC"][0])[-1], "cost")
        self.assertFalse({"auc1", "median_center_percent"} & set(tables["planar", "cv:RANSAC"]))
        self.assertNotIn("R, M:", text)


@unittest.skipUnless(os.path.isfile(program("usac_test_methods")), "there is no usac_test_methods beside USAC_BENCHMARK")
class MeasuredViewTest(ProgramTest):

    def measure(self, view):
        views.write_view(self.path("pairs", "set", "a"), view)
        pairs.write_list(pairs.list_file(self.folder, "set", "P"), [self.path("pairs", "set", "a")])
        return self.benchmark(["custom:identity"], name="usac_test_methods")[0]["custom:identity"][0]

    def test_measures(self):
        """The measures of the identity as a model must agree with values computed with numpy."""
        for t in ((0.02, -0.01, 0.03), (0.3, 0.2, -0.1), (0.02, 0.01, -4.5)):
            view = near_view(t=t)
            if t[2] < -4:
                view = near_view(t=t, right=np.flatnonzero(near_view().object_points[:, 2] > 6))
            row = self.measure(view)
            center = 100 * np.linalg.norm(view.R.T @ view.t) / np.sort(view.depths()[view.right])[len(view.right) // 2]
            self.assertAlmostEqual(float(row["error"]), angle(view.R), delta=1e-5)
            self.assertAlmostEqual(float(row["center_error"]) / center, 1, delta=1e-5)
            cost = np.mean(np.minimum(1, (distances(view, np.eye(3), np.zeros(3)) / 4) ** 2))
            self.assertAlmostEqual(float(row["cost"]), cost, delta=1e-4)
            self.assertEqual((row["failed"], row["inliers"]), (str(int(center > 5)), "30"))
        self.assertEqual(self.measure(near_view(R=rotation((0, 0, 1), 4.9)))["failed"], "0")
        self.assertEqual(self.measure(near_view(R=rotation((0, 0, 1), 5.1)))["failed"], "1")

    def test_points_behind_the_camera(self):
        """With the identity as the pose, a third of the points is behind the camera. Without a check of
        depths their projections agree with the image points, but each must get the full cost of 1."""
        view = near_view(dist_coeffs=(), t=(0, 0, 20), R=np.eye(3))
        view.object_points[:10] *= -1
        view.points = project(view, np.eye(3), np.zeros(3))[0]
        self.assertAlmostEqual(float(self.measure(view)["cost"]), 1 / 3, delta=1e-5)

    def test_mistakes(self):
        view, path = near_view(), self.path("pairs", "set", "a")
        pairs.write_list(pairs.list_file(self.folder, "set", "P"), [path])
        for ending, contents, complaint in (
                (".txt", "1 2 3 4 5\n1 2 3\n", "a.txt:2: expected 'X Y Z u v'"), (".txt", "\n", "a.txt:1: no correspondences"),
                (".score", "1\n1\n", "a.score:2: 2 scores, but 30 correspondences"),
                (".score", "1 2\n", "a.score:1: expected a score"), (".json", '{"problem": "H"}', "the pair is not one for P"),
                (".json", '{"R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "t": [0, 0, 1]}', "a.json:1: K: needed"),
                (".json", '{"gt_mask": [30]}', "gt_mask: expected numbers of matches"),
                (".json", '{"distCoeffs": [1]}', "distCoeffs: expected 4, 5, 8, 12 or 14 coefficients")):
            views.write_view(path, view)
            self.put("pairs/set/a" + ending, contents)
            done = self.call("usac_benchmark", "--data=" + self.folder, "--methods=cv:PNP_P3P")
            self.assertEqual(done.returncode, 2, contents)
            self.assertIn(complaint, done.stderr)
        views.write_view(path, view)
        description = self.text("set", "a.json")
        self.put("pairs/set/a.json", description.replace('"t":[0.02,-0.01,0.03]', '"t":[0,0,-20]'))
        done = self.call("usac_benchmark", "--data=" + self.folder, "--methods=cv:PNP_P3P")
        self.assertIn("t: the scene is behind the camera", done.stderr)
        for scene, option, complaint in (("view", "--outliers=local", "for pairs of images only"),
                                         ("view", "--angle=3", "--angle"), ("view", "--thickness=0.1", "--thickness"),
                                         ("planar", "--distortion=0.1", "--distortion"), ("view", "--distortion=1", "--distortion"),
                                         ("viewPlane", "--thickness=2", "--thickness")):
            done = self.call("usac_synthetic", "--out=" + self.path("none"), "--scene=" + scene, option)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(complaint, done.stderr)


if __name__ == "__main__":
    unittest.main()
