# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads and writes views of object points, the data of usac_benchmark for the problem P;
doc/benchmark.md describes the format.

Lists of views are written with pairs.write_list(pairs.list_file(folder, dataset, "P"), paths)."""

import numpy as np

from pairs import PairError, read_description, read_scored_rows, require, to_array, write_rows

_DISTORTION = (0, 4, 5, 8, 12, 14)


class View:
    """Object points, their image points and the pose of the camera.

    object_points: N x 3. points: N x 2, pixels; the center of the first pixel is at (0, 0). scores: N,
    lower is better. K: camera matrix. R, t: pose, x ~ K (R X + t). dist_coeffs: lens distortion as in
    OpenCV's calib3d; empty: no distortion. right: indices of the right matches, None if unknown.
    extra: further members of the description (.json)."""

    def __init__(self, object_points, points, scores, K, R, t, dist_coeffs=(), right=None, extra=None):
        self.object_points, self.points = to_array(object_points, (-1, 3), "object_points"), to_array(points, (-1, 2), "points")
        self.scores = to_array(scores, (-1,), "scores")
        self.K, self.R, self.t = to_array(K, (3, 3), "K"), to_array(R, (3, 3), "R"), to_array(t, (3,), "t")
        self.dist_coeffs = to_array(dist_coeffs, (-1,), "dist_coeffs")
        self.right = None if right is None else [int(i) for i in right]
        self.extra = dict(extra or {})

    def depths(self):
        """Returns the depths of the object points along the optical axis."""
        return self.object_points @ self.R[2] + self.t[2]

    def check(self):
        """Raises PairError if usac_benchmark could not use the view or would measure meaningless
        errors."""
        count = len(self.points)
        require(count > 0, "no correspondences")
        require(len(self.object_points) == count == len(self.scores), "points and scores differ in number")
        for name in ("object_points", "points", "scores", "K", "R", "t", "dist_coeffs"):
            value = getattr(self, name)
            require(value is not None, name + ": missing")
            require(np.isfinite(value).all(), name + ": not finite")
        require(abs(np.linalg.det(self.K)) > 0, "K: singular")
        require(np.abs(self.R @ self.R.T - np.eye(3)).max() < 1e-3 and np.linalg.det(self.R) > 0, "R: no rotation")
        require(len(self.dist_coeffs) in _DISTORTION, "distCoeffs: expected 4, 5, 8, 12 or 14 coefficients")
        require(self.right is None or all(0 <= i < count for i in self.right),
                "gt_mask: expected numbers of matches, counted from 0")
        require(np.median(self.depths()[self.right or slice(None)]) > 0, "t: the scene is behind the camera")


def write_view(path, view):
    """Writes <path>.txt, <path>.score and <path>.json; creates the folder."""
    try:
        view.check()
    except PairError as error:
        raise PairError("%s: not written: %s" % (path, error)) from None
    description = {"problem": ["P"], "K": view.K.tolist(), "R": view.R.tolist(), "t": view.t.tolist()}
    if len(view.dist_coeffs):
        description["distCoeffs"] = view.dist_coeffs.tolist()
    if view.right is not None:
        description["gt_mask"] = view.right
    description.update(view.extra)
    write_rows(path, np.hstack((view.object_points, view.points)), "%.6f %.6f %.6f %.4f %.4f", view.scores, description)


def read_view(path):
    """Reads the view of <path>.txt, <path>.score (if missing, all scores are 1) and <path>.json and
    checks it."""
    rows, scores = read_scored_rows(path, 5, "'X Y Z u v'")
    file = path + ".json"
    known = read_description(file)
    try:
        problems = known.pop("problem", None) or "P"
        require("P" in problems, "problem: the pair is not one for P")
        near = known.pop("gt_inliers_3px", None)
        view = View(rows[:, :3], rows[:, 3:], scores, known.pop("K", None), known.pop("R", None), known.pop("t", None),
                    known.pop("distCoeffs", None) or [], known.pop("gt_mask", None) or near, known)
        view.check()
    except PairError as error:
        raise PairError("%s: %s" % (file, error)) from None
    return view
