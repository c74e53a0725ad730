# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads and writes motions of space, the data of usac_benchmark for the problems R and M;
doc/benchmark.md describes the format.

Lists of motions are written with pairs.write_list(pairs.list_file(folder, dataset, "R"), paths)."""

import numpy as np

from pairs import PairError, read_description, read_scored_rows, require, to_array, write_rows


class Motion:
    """Matched points of two spaces and the motion between them, X2 = scale R X1 + t.

    points1, points2: N x 3. scores: N, lower is better. R, t: rotation and translation. scale: must be
    1 for the problem R (rigid motion). right: indices of the right matches, None if unknown. extra:
    further members of the description (.json)."""

    def __init__(self, points1, points2, scores, R, t, scale=1.0, right=None, extra=None):
        self.points1, self.points2 = to_array(points1, (-1, 3), "points1"), to_array(points2, (-1, 3), "points2")
        self.scores = to_array(scores, (-1,), "scores")
        self.R, self.t, self.scale = to_array(R, (3, 3), "R"), to_array(t, (3,), "t"), float(scale)
        self.right = None if right is None else [int(i) for i in right]
        self.extra = dict(extra or {})

    @property
    def problem(self):
        """The letter of the problem: R (rigid motion) if the scale is 1, otherwise M."""
        return "R" if self.scale == 1 else "M"

    def moved(self):
        """Returns points1 moved to space 2 by the motion."""
        return self.scale * self.points1 @ self.R.T + self.t

    def size(self):
        """Returns the size of the scene: the root mean square distance of the right points of space 2
        (of all if it is unknown which are right) from their mean."""
        points = self.points2[slice(None) if self.right is None else self.right]
        return np.sqrt(((points - points.mean(0)) ** 2).sum(1).mean())

    def check(self):
        """Raises PairError if usac_benchmark could not use the motion or would measure meaningless
        errors."""
        count = len(self.points1)
        require(count > 0, "no correspondences")
        require(len(self.points2) == count == len(self.scores), "points and scores differ in number")
        for name in ("points1", "points2", "scores", "R", "t"):
            value = getattr(self, name)
            require(value is not None, name + ": missing")
            require(np.isfinite(value).all(), name + ": not finite")
        require(np.isfinite(self.scale) and self.scale > 0, "s: expected a number above 0")
        require(np.abs(self.R @ self.R.T - np.eye(3)).max() < 1e-3 and np.linalg.det(self.R) > 0, "R: no rotation")
        require(self.right is None or all(0 <= i < count for i in self.right),
                "gt_mask: expected numbers of matches, counted from 0")
        require(self.size() > 0, "gt_mask: the scene is one point, because all right points of space 2 are equal")


def write_motion(path, motion, problem=None):
    """Writes <path>.txt, <path>.score and <path>.json; creates the folder. `problem` is "R" or "M"; with
    None it is "R" if the scale is 1, otherwise "M"."""
    try:
        motion.check()
        problem = problem or motion.problem
        require(problem == "M" or motion.scale == 1, "s: expected 1 for R")
    except PairError as error:
        raise PairError("%s: not written: %s" % (path, error)) from None
    description = {"problem": [problem], "s": motion.scale, "R": motion.R.tolist(), "t": motion.t.tolist()}
    if motion.right is not None:
        description["gt_mask"] = motion.right
    description.update(motion.extra)
    write_rows(path, np.hstack((motion.points1, motion.points2)), "%.5f", motion.scores, description)


def read_motion(path):
    """Reads the motion of <path>.txt, <path>.score (if missing, all scores are 1) and <path>.json
    and checks it."""
    rows, scores = read_scored_rows(path, 6, "'X1 Y1 Z1 X2 Y2 Z2'")
    file = path + ".json"
    known = read_description(file)
    try:
        problems = known.pop("problem", None) or "M"
        scale = known.pop("s", None)
        require("M" in problems or "R" in problems, "problem: the pair is not one for R or M")
        require("M" in problems or scale in (None, 1), "s: expected 1 for R")
        motion = Motion(rows[:, :3], rows[:, 3:], scores, known.pop("R", None), known.pop("t", None),
                        1 if scale is None else scale, known.pop("gt_mask", None), known)
        motion.check()
    except PairError as error:
        raise PairError("%s: %s" % (file, error)) from None
    return motion
