#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates the homography between two images of a plane, and compares flags of OpenCV with a flag
of this module."""

import sys
from typing import Any, Tuple

import cv2
import numpy as np

import tools
from tools import Array, Image, usacv20


def mean_distance(H: Array, truth: Any, shape: Tuple[int, ...]) -> float:
    """Returns the mean distance in image 2, in pixels, between the points to which the two
    homographies map a grid of points of image 1."""
    x, y = np.meshgrid(np.linspace(0, shape[1] - 1, 21), np.linspace(0, shape[0] - 1, 21))
    grid = np.dstack((x, y)).reshape(-1, 1, 2)
    difference = cv2.perspectiveTransform(grid, H) - cv2.perspectiveTransform(grid, truth)
    return float(np.linalg.norm(difference, axis=2).mean())


def draw_outline(canvas: Image, H: Array, shape: Tuple[int, ...]) -> None:
    corners = np.array([[[0, 0]], [[shape[1], 0]], [[shape[1], shape[0]]], [[0, shape[0]]]], float)
    outline = cv2.perspectiveTransform(corners, H).round().astype(np.int32)
    right = np.ascontiguousarray(canvas[:, shape[1]:])
    cv2.polylines(right, [outline], True, (0, 140, 255), 3, cv2.LINE_AA)
    canvas[:, shape[1]:] = right


def draw_corners(canvas: Image, H: Array, covariance: Array, shape: Tuple[int, ...]) -> None:
    """Prints the corners of image 1 mapped to image 2 with their standard deviations, and draws
    their 95 % confidence ellipses, enlarged ten times."""
    corners = np.array([[0, 0], [shape[1], 0], [shape[1], shape[0]], [0, shape[0]]], float)
    mapped = cv2.perspectiveTransform(corners.reshape(-1, 1, 2), H).reshape(-1, 2)
    right = np.ascontiguousarray(canvas[:, shape[1]:])
    for place, C in zip(mapped, usacv20.pointCovariance(usacv20.HOMOGRAPHY, H, covariance, corners)):
        if not np.isfinite(C).all():
            continue
        print("corner ({:.1f}, {:.1f}) +- ({:.2f}, {:.2f}) px".format(*place, *np.sqrt(np.diag(C))))
        variances, axes = np.linalg.eigh(C)  # in ascending order
        diameters = 2 * 10 * np.sqrt(5.99 * variances[::-1])  # 5.99: 0.95 quantile of chi-square, two degrees of freedom
        angle = np.degrees(np.arctan2(axes[1, 1], axes[0, 1]))
        cv2.ellipse(right, (tuple(map(float, place)), tuple(map(float, diameters)), float(angle)), (255, 80, 0), 2, cv2.LINE_AA)
    canvas[:, shape[1]:] = right


def main() -> int:
    parser = tools.arguments(__doc__, "graf1.png", "graf3.png", "homography_py.jpg", 2.0)
    parser.add_argument("--truth", default="H1to3p.xml", help="file with the true homography, or none")
    parser.add_argument("--iterations", type=int, default=10000, help="largest number of samples")
    args = parser.parse_args()
    image1, image2 = tools.read_image(args.image1), tools.read_image(args.image2)
    truth = None
    if args.truth != "none":
        storage = cv2.FileStorage(tools.find_file(args.truth), cv2.FILE_STORAGE_READ)
        truth = storage.getFirstTopLevelNode().mat()
    points1, points2 = tools.match(image1, image2, args)

    results = []
    for name in ("RANSAC", "USAC_DEFAULT", "USACV20"):
        result = tools.measure(name, args.runs, lambda: usacv20.findHomography(
            points1, points2, tools.flag_of(name), args.threshold, maxIters=args.iterations, confidence=args.confidence))
        if truth is not None and result.model is not None:
            error = result.error = mean_distance(result.model, truth, image1.shape)
            result.errorText = "%.2f px" % error
        results.append(result)

    # Repeats the estimation to get the report and the covariance, which a call with a flag does not
    # return.
    ours = results[-1]
    _, _, report = usacv20.estimateHomography(points1, points2, tools.usacv20_params(args, args.iterations).replace(covariance=1))
    ours.iterations = report.iterations
    tools.print_table(len(points1), results, args.runs)
    print("USACV20: " + report.describe())
    if ours.model is not None:
        picture = tools.draw_inliers(image1, image2, points1, points2, ours.mask)
        draw_outline(picture, ours.model, image1.shape)
        if report.covariance is not None:
            draw_corners(picture, ours.model, report.covariance, image1.shape)
        tools.write_picture(args.output, picture, ours, " (green, some joined); orange: image 1; blue: 10 x 95 % ellipses")
    return tools.exit_code(ours, tools.failure_limit(image2))


if __name__ == "__main__":
    sys.exit(main())
