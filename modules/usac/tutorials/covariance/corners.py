#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Draws the picture of the tutorial: the 95 % confidence ellipses of an object's corners from one
estimate, and the corners from many estimates.

usage: corners.py images/corners.png"""

import sys

import numpy as np
from matplotlib import patches
from matplotlib.figure import Figure

import usacv20

SIZE = np.array([400, 300])  # pixels, of the object's image
CORNERS = SIZE * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
TRUTH = np.array([[0.8, -0.2, 170], [0.15, 0.75, 60], [3e-4, -1e-4, 1]])
NOISE = 1.0  # pixels, standard deviation of each coordinate
RIGHT, WRONG = 60, 40
ESTIMATES = 300
NAMES = ("top left", "top right", "bottom right", "bottom left")


def mapped(H, points):
    places = np.c_[points, np.ones(len(points))] @ H.T
    return places[:, :2] / places[:, 2:]


def estimate(points1, rng):
    """Estimates the homography from the right matches with new noise and new wrong matches. Returns
    the homography and the report."""
    others = rng.uniform(0, SIZE, (WRONG, 2))
    points2 = np.r_[mapped(TRUTH, points1) + rng.normal(0, NOISE, points1.shape), rng.uniform(0, [640, 480], (WRONG, 2))]
    H, _, report = usacv20.estimateHomography(np.r_[points1, others], points2, usacv20.Params(threshold=3, covariance=1))
    return H, report


def ellipse(center, C, **style):
    values, directions = np.linalg.eigh(C)
    small, large = 2 * np.sqrt(5.991 * values)
    return patches.Ellipse(center, large, small, angle=np.degrees(np.arctan2(directions[1, 1], directions[0, 1])), fill=False, **style)


def main(path):
    rng = np.random.default_rng(0)
    points1 = SIZE * np.c_[rng.beta(1, 2.5, RIGHT), rng.uniform(0.1, 0.9, RIGHT)]  # most points are on the left
    H, report = estimate(points1, rng)
    shapes = usacv20.pointCovariance("homography", H, report.covariance, CORNERS)
    centers, truth = mapped(H, CORNERS), mapped(TRUTH, CORNERS)
    many = np.array([mapped(estimate(points1, rng)[0], CORNERS) for _ in range(ESTIMATES)])

    figure = Figure(figsize=(10, 4.6), dpi=100, layout="constrained")
    grid = figure.add_gridspec(2, 4)
    scene = figure.add_subplot(grid[:, :2])
    scene.plot(*truth[[0, 1, 2, 3, 0]].T, color="0.6", linewidth=1)
    scene.plot(*mapped(TRUTH, points1).T, ".", color="0.4", markersize=4)
    scene.plot(*many.reshape(-1, 2).T, ".", color="tab:blue", markersize=1.5)
    for center, C in zip(centers, shapes):
        scene.add_patch(ellipse(center, C, color="tab:red"))
    scene.set(title="the object in image 2, its right matches gray", aspect="equal")
    scene.invert_yaxis()
    for i, cell in enumerate((grid[0, 2], grid[0, 3], grid[1, 3], grid[1, 2])):
        zoom = figure.add_subplot(cell)
        zoom.plot(*many[:, i].T, ".", color="tab:blue", markersize=2.5)
        zoom.plot(*truth[i], "+", color="black", markersize=9)
        zoom.add_patch(ellipse(centers[i], shapes[i], color="tab:red", linewidth=1.5))
        zoom.add_patch(ellipse(truth[i], shapes[i], color="tab:red", linestyle="--"))
        zoom.set(title=NAMES[i], aspect="equal")
        zoom.autoscale_view()
        zoom.invert_yaxis()
        zoom.tick_params(labelsize=7)
    figure.savefig(path)
    inside = [np.mean([e @ np.linalg.solve(C, e) < 5.991 for e in many[:, i] - truth[i]]) for i, C in enumerate(shapes)]
    print("noise {:.2f} px; estimated corners within the ellipses, if these are centered at the true corners: {}".format(
        report.sigma, ", ".join("{:.0f} %".format(100 * part) for part in inside)))


if __name__ == "__main__":
    main(*sys.argv[1:])
