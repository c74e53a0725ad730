#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates the fundamental matrix between two images, and compares flags of OpenCV with a flag of
this module."""

import sys
from typing import Any, Tuple

import cv2
import numpy as np

import tools
from tools import Array, usacv20


def read_truth(name: str) -> Tuple[Array, Array]:
    """Reads true correspondences of a rectified stereo pair from its disparities: x2 = x1 -
    disparity; a disparity of 0 is unknown. Disparities are rounded to a pixel. The rounding moves
    points along the epipolar lines, which are the rows, and does not change the distance of a point
    from its epipolar line."""
    disparity = cv2.imread(tools.find_file(name), cv2.IMREAD_GRAYSCALE)
    y, x = (places.ravel() for places in np.mgrid[0:disparity.shape[0]:10, 0:disparity.shape[1]:10])
    d = disparity[y, x].astype(int)
    known = (d > 0) & (x >= d)
    x, y, d = x[known], y[known], d[known]
    ones = np.ones(len(x))
    return np.column_stack((x, y, ones)), np.column_stack((x - d, y, ones))


def mean_distance(F: Array, truth: Any) -> float:
    """Returns the mean Sampson distance of the true correspondences in pixels."""
    lines2, lines1 = truth[0] @ F.T, truth[1] @ F
    squares = (lines2[:, :2] ** 2).sum(axis=1) + (lines1[:, :2] ** 2).sum(axis=1)
    return float((np.abs((truth[1] * lines2).sum(axis=1)) / np.sqrt(squares)).mean())


def main() -> int:
    parser = tools.arguments(__doc__, "aloeL.jpg", "aloeR.jpg", "fundamental_py.jpg", 1.0)
    parser.add_argument("--truth", default="aloeGT.png", help="true disparities of a rectified pair, or none")
    parser.add_argument("--iterations", type=int, default=1000, help="largest number of samples")
    args = parser.parse_args()
    image1, image2 = tools.read_image(args.image1), tools.read_image(args.image2)
    truth = read_truth(args.truth) if args.truth != "none" else None
    points1, points2 = tools.match(image1, image2, args)

    results = []
    for name in ("RANSAC", "USAC_DEFAULT", "USACV20"):
        result = tools.measure(name, args.runs, lambda: usacv20.findFundamentalMat(
            points1, points2, tools.flag_of(name), args.threshold, args.confidence, args.iterations))
        if truth is not None and result.model is not None:
            error = result.error = mean_distance(result.model, truth)
            result.errorText = "%.3f px" % error
        results.append(result)

    # Repeats the estimation to get the report, which a call with a flag does not return.
    ours = results[-1]
    _, _, report = usacv20.estimateFundamental(points1, points2, tools.usacv20_params(args, args.iterations))
    ours.iterations = report.iterations
    tools.print_table(len(points1), results, args.runs)
    print("USACV20: " + report.describe())
    if ours.model is not None:
        picture = tools.draw_epipolar_lines(image1, image2, points1, points2, ours.mask, ours.model)
        tools.write_picture(args.output, picture, ours, "; some of them with their epipolar lines")
    return tools.exit_code(ours, tools.failure_limit(image2))


if __name__ == "__main__":
    sys.exit(main())
