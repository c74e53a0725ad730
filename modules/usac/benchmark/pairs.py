# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads and writes the pairs and lists that usac_benchmark reads; doc/benchmark.md describes the format."""

import json
import os

import numpy as np

PROBLEMS = ("H", "F", "E", "A", "S", "T")  # problems of image pairs
LISTS = PROBLEMS + ("P", "R", "M")  # problems that have lists; views.py reads the files of P, spaces.py those of R and M
KINDS = ("annotated", "labels", "homography", "pose", "exact")
_MATRICES = ("H", "K1", "K2", "R")


class PairError(ValueError):
    """Raised if a pair or a list breaks the rules of the format. The message names the file and the
    line if these are known."""


class Pair:
    """Tentative correspondences of two images with their ground truth.

    points1, points2: N x 2, pixels; the center of the first pixel is at (0, 0). scores: N, lower is
    better. size1, size2: width and height in pixels. H: maps image 1 to image 2. K1, K2: camera
    matrices. R, t: x2 = R x1 + t in camera coordinates. gt_points: M x 4, true correspondences.
    gt_kind: origin of the ground truth, one of KINDS. extra: further members of the description
    (.json). H, K1, K2, R and t are None if unknown."""

    def __init__(self, problems, points1, points2, scores, size1, size2, gt_points, gt_kind,
                 H=None, K1=None, K2=None, R=None, t=None, extra=None):
        self.problems = list(problems)
        self.points1, self.points2 = to_array(points1, (-1, 2), "points1"), to_array(points2, (-1, 2), "points2")
        self.scores = to_array(scores, (-1,), "scores")
        self.size1, self.size2 = to_array(size1, (2,), "size1"), to_array(size2, (2,), "size2")
        self.gt_points, self.gt_kind = to_array(gt_points, (-1, 4), "gt_points"), gt_kind
        self.H, self.K1, self.K2 = to_array(H, (3, 3), "H"), to_array(K1, (3, 3), "K1"), to_array(K2, (3, 3), "K2")
        self.R, self.t = to_array(R, (3, 3), "R"), to_array(t, (3,), "t")
        self.extra = dict(extra or {})

    def check(self):
        """Raises PairError if usac_benchmark could not use the pair or would measure meaningless
        errors."""
        require(self.problems and set(self.problems) <= set(PROBLEMS), "problem: expected some of " + ", ".join(PROBLEMS))
        require(len(self.points1) > 0, "no correspondences")
        require(len(self.points1) == len(self.points2) == len(self.scores), "points and scores differ in number")
        for name in ("points1", "points2", "scores", "size1", "size2", "gt_points", "H", "K1", "K2", "R", "t"):
            value = getattr(self, name)
            require(value is None or np.isfinite(value).all(), name + ": not finite")
        require((self.size1 > 0).all() and (self.size2 > 0).all(), "size1, size2: expected positive numbers")
        require(self.gt_kind in KINDS, "gt_kind: expected one of " + ", ".join(KINDS))
        require(len(self.gt_points) > 0, "gt_points: none, the error cannot be measured")
        self._check_models()

    def _check_models(self):
        require("E" not in self.problems or (self.K1 is not None and self.K2 is not None), "K1, K2: needed for E")
        require(self.gt_kind != "homography" or self.H is not None, "H: needed where gt_kind is homography")
        require((self.R is None) == (self.t is None), "R and t come together, but only one is given")
        for name in ("H", "K1", "K2"):
            value = getattr(self, name)
            require(value is None or abs(np.linalg.det(value)) > 0, name + ": singular")
        if self.R is not None:
            require(np.abs(self.R @ self.R.T - np.eye(3)).max() < 1e-3 and np.linalg.det(self.R) > 0, "R: no rotation")
            require(np.linalg.norm(self.t) > 0, "t: zero, so there is no epipolar geometry")


def require(condition, what):
    """Raises PairError with the text `what` if the condition does not hold."""
    if not condition:
        raise PairError(what)


def to_array(value, shape, name):
    """Converts a value to an array of doubles of this shape; None stays None. Raises PairError, with
    the name of the value, if the conversion is not possible."""
    if value is None:
        return None
    try:
        return np.asarray(value, np.float64).reshape(shape)
    except (ValueError, TypeError):
        raise PairError("%s: expected %s numbers" % (name, " x ".join("N" if n < 0 else str(n) for n in shape))) from None


def write_pair(path, pair):
    """Checks the pair, and writes <path>.corr and <path>.json; creates the folder."""
    try:
        pair.check()
    except PairError as error:
        raise PairError("%s: not written: %s" % (path, error)) from None
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    description = {"problem": pair.problems, "size1": _sizes(pair.size1), "size2": _sizes(pair.size2)}
    for name in _MATRICES + ("t",):
        value = getattr(pair, name)
        description[name] = None if value is None else value.tolist()
    description["gt_points"] = np.round(pair.gt_points, 3).tolist()
    description["gt_kind"] = pair.gt_kind
    description.update(pair.extra)
    text = json.dumps(description, separators=(",", ":"), allow_nan=False)
    rows = np.column_stack((pair.points1, pair.points2))
    with open(path + ".corr", "w") as out:
        for row, score in zip(rows, pair.scores):
            out.write(" ".join("%.3f" % v for v in row) + " %.4f\n" % score)
    with open(path + ".json", "w") as out:
        out.write(text + "\n")


def _sizes(size):
    return [int(v) if v == int(v) else float(v) for v in size]


def read_rows_of_numbers(file, counts, expected):
    """Returns the numbers of each nonempty line of a text file. Raises PairError with file and line
    if a line has something other than numbers, or a count of numbers that is not in `counts`."""
    rows = []
    with open(file) as lines:
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            try:
                values = [float(v) for v in line.split()]
            except ValueError:
                values = []
            if len(values) not in counts:
                raise PairError("%s:%d: expected %s" % (file, number, expected))
            rows.append(values)
    return rows


def _read_correspondences(file):
    rows = read_rows_of_numbers(file, (4, 5), "'x1 y1 x2 y2 score'")
    if not rows:
        raise PairError(file + ":1: no correspondences")
    return np.array([row if len(row) == 5 else row + [1.0] for row in rows])


def write_rows(path, rows, digits, scores, description):
    """Writes `rows` to <path>.txt, `scores` to <path>.score and `description` to <path>.json; creates
    the folder. `digits` is the format of a number, or of a whole row, as in numpy.savetxt."""
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    text = json.dumps(description, separators=(",", ":"), allow_nan=False)
    np.savetxt(path + ".txt", rows, digits)
    np.savetxt(path + ".score", scores, "%.6g")
    with open(path + ".json", "w") as out:
        out.write(text + "\n")


def read_scored_rows(path, count, expected):
    """Returns the rows of <path>.txt, each of `count` numbers, and the scores of <path>.score; all
    scores are 1 if there is no <path>.score."""
    rows = np.array(read_rows_of_numbers(path + ".txt", (count,), expected)).reshape(-1, count)
    if os.path.exists(path + ".score"):
        return rows, read_rows_of_numbers(path + ".score", (1,), "a score")
    return rows, np.ones(len(rows))


def read_description(file):
    """Returns the object in a JSON file. Raises PairError with file and line if the file is not valid
    JSON or contains something other than an object."""
    with open(file) as text:
        try:
            description = json.load(text)
        except json.JSONDecodeError as error:
            raise PairError("%s:%d: %s" % (file, error.lineno, error.msg)) from None
    if not isinstance(description, dict):
        raise PairError(file + ":1: expected an object")
    return description


def read_pair(path):
    """Reads the pair of <path>.corr and <path>.json and checks it."""
    rows = _read_correspondences(path + ".corr")
    file = path + ".json"
    known = read_description(file)
    try:
        problems = known.pop("problem", None)
        models = {name: known.pop(name, None) for name in _MATRICES + ("t",)}
        sizes = [known.pop(name, None) for name in ("size1", "size2")]
        require(None not in sizes, "size1, size2: missing")
        if problems is None:  # as in usac_benchmark: all problems that the data allow
            problems = [p for p in PROBLEMS if p != "E" or (models["K1"] and models["K2"])]
        problems = [problems] if isinstance(problems, str) else problems
        pair = Pair(problems, rows[:, :2], rows[:, 2:4], rows[:, 4], sizes[0], sizes[1],
                    known.pop("gt_points", None) or [], known.pop("gt_kind", None), extra=known, **models)
        pair.check()
    except PairError as error:
        raise PairError("%s: %s" % (file, error)) from None
    return pair


def list_file(folder, dataset, problem):
    """Returns the path of the list of a data set for a problem."""
    require(problem in LISTS, "problem: expected one of " + ", ".join(LISTS))
    return os.path.join(folder, "lists", "%s.%s.list" % (dataset, problem))


def write_list(file, paths):
    """Writes a list of pairs; `paths` are without extension. The stored paths are relative to the
    folder of the list, or to the parent of this folder if it is called `lists`, as usac_benchmark
    expects."""
    split_name(file)
    base = _base(file)
    os.makedirs(os.path.dirname(file) or ".", exist_ok=True)
    with open(file, "w") as out:
        for path in paths:
            out.write(os.path.relpath(path, base).replace(os.sep, "/") + "\n")


def read_list(file):
    """Returns the paths of the pairs in a list, without extension."""
    split_name(file)
    paths = []
    with open(file) as lines:
        for line in lines:
            line = line.strip()
            if line and not line.startswith("#"):
                paths.append(os.path.join(_base(file), line))
    return paths


def split_name(file):
    """Splits "lists/homogr.H.list" into ("homogr", "H"). Raises PairError for other names."""
    parts = os.path.basename(file).rsplit(".", 2)
    if len(parts) != 3 or parts[2] != "list" or parts[1] not in LISTS or not parts[0]:
        raise PairError(file + ": expected a name that ends in .H.list, .F.list and so on")
    return parts[0], parts[1]


def _base(file):
    folder = os.path.dirname(os.path.abspath(file))
    return os.path.dirname(folder) if os.path.basename(folder) == "lists" else folder
