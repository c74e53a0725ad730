# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs the parts of Python programs that the documents show: frame.py TASKS.json. TASKS.json
contains a list of {key, document, line, code, before, after}.

The points and other variables that a part uses are defined here, with a known true model, as in
frame.hpp. `before` and `after` are code of the table that runs before and after the part; `after`
checks the results with `require(...)`. Tracebacks have the line numbers of the document."""

import json
import sys
import traceback

import numpy as np

K = np.array([[700.0, 0, 320], [0, 700, 240], [0, 0, 1]])
R = np.array([[np.cos(0.1), -np.sin(0.1), 0], [np.sin(0.1), np.cos(0.1), 0], [0, 0, 1]])
T = np.array([1, 0.2, 0])
DEPTH = 10.0  # distance of the plane z = DEPTH from camera 1; T has the same unit
H = K @ (R + np.outer(T, [0, 0, 1 / DEPTH])) @ np.linalg.inv(K)
E = np.array([[0, -T[2], T[1]], [T[2], 0, -T[0]], [-T[1], T[0], 0]]) @ R
F = np.linalg.inv(K).T @ E @ np.linalg.inv(K)
TRUTH = dict(H=H, A=H[:2], E=E, F=F, R=R, t=T)


def project(X):
    x = X @ K.T
    return x[:, :2] / x[:, 2:]


def near(a, b, error=1e-3):
    """Returns whether two arrays are equal up to scale and sign. `error` is the largest relative
    difference."""
    if a is None or np.size(a) != np.size(b):
        return False
    a, b = np.ravel(a) / np.linalg.norm(a), np.ravel(b) / np.linalg.norm(b)
    return min(np.linalg.norm(a - b), np.linalg.norm(a + b)) < error


def pose(rvec, tvec):
    return near(rvec, [0, 0, 0.1]) and near(tvec, T)


def require(condition):
    if not condition:
        raise AssertionError("not true after the code of the document")


def given():
    """Returns new copies of the variables that a part can use. A third of the 3-D points lies in a
    plane; a fifth of the correspondences is wrong."""
    rng = np.random.RandomState(1)
    i = np.arange(300)
    z = np.where(i % 3 == 0, DEPTH, rng.uniform(4, 8, 300))
    X = np.c_[rng.uniform(-0.4, 0.4, 300) * z, rng.uniform(-0.3, 0.3, 300) * z, z]
    Y = X @ R.T + T
    right = i % 5 != 0
    Y[~right] = X[~right] + np.c_[rng.uniform(-2, 2, (60, 2)), np.ones(60)]
    points1, points2 = project(X), project(Y)
    image = np.zeros((480, 640, 3), np.uint8)
    return dict(np=np, TRUTH=TRUTH, require=require, near=near, pose_near=pose, right=right, K=K.copy(), K1=K.copy(), K2=K.copy(),
                points1=points1, points2=points2, objectPoints=X, imagePoints=points2.copy(), distortion=None, distCoeffs=None,
                d1=None, d2=None, ratios=np.where(right, 0.4, 0.8), scores=np.where(right, 0.8, 0.3), quality=right.astype(float),
                image1=image, image2=image.copy(), matches=[(points1, points2)] * 2, lists1=[points1] * 2, lists2=[points2] * 2)


def run(task):
    space = given()
    exec(compile(task["before"], "before", "exec"), space)
    exec(compile("\n" * (task["line"] - 1) + task["code"], task["document"], "exec"), space)
    exec(compile(task["after"], "after", "exec"), space)


def main(tasks):
    failed = 0
    with open(tasks, encoding="utf-8") as file:
        for task in json.load(file):
            try:
                run(task)
                print("\nDONE " + task["key"], flush=True)
            except Exception:
                print(traceback.format_exc() + "\n" + task["after"], flush=True)
                failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
