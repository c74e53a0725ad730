# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs a part of a Python program that a document shows: frame.py TASK.json. TASK.json contains
{document, line, code, before}.

The points and other variables that the part uses are defined here, with a known true model, as in
frame.hpp. `before` is code of the table that runs before the part. Tracebacks have the line numbers of
the document."""

import json
import sys

import numpy as np

K = np.array([[700.0, 0, 320], [0, 700, 240], [0, 0, 1]])
R = np.array([[np.cos(0.1), -np.sin(0.1), 0], [np.sin(0.1), np.cos(0.1), 0], [0, 0, 1]])
T = np.array([1, 0.2, 0])
DEPTH = 10.0  # distance of the plane z = DEPTH from camera 1; T has the same unit


def project(X):
    x = X @ K.T
    return x[:, :2] / x[:, 2:]


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
    return dict(np=np, right=right, K=K.copy(), K1=K.copy(), K2=K.copy(),
                points1=points1, points2=points2, objectPoints=X, imagePoints=points2.copy(), distortion=None, distCoeffs=None,
                d1=None, d2=None, ratios=np.where(right, 0.4, 0.8), scores=np.where(right, 0.8, 0.3), quality=right.astype(float),
                image1=image, image2=image.copy(), matches=[(points1, points2)] * 2, lists1=[points1] * 2, lists2=[points2] * 2)


def main(path):
    with open(path, encoding="utf-8") as file:
        task = json.load(file)
    space = given()
    exec(compile(task["before"], "before", "exec"), space)
    exec(compile("\n" * (task["line"] - 1) + task["code"], task["document"], "exec"), space)
    print("\nDONE")  # so that a part that ends the program early fails


if __name__ == "__main__":
    main(sys.argv[1])
