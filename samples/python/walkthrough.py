#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""From two images to verified matches, step by step, with the package usacv20 and any cv2, or with
cv2.usacv20.

This script consists of cells: run it as a whole, or cell by cell in an editor that supports `# %%`.
It needs the package (pip install modules/usac) or an OpenCV that was built with the module, and cv2
and matplotlib (Debian: python3-opencv, python3-matplotlib). All pictures are written to one file."""

# %% Two images, by default two of OpenCV's sample images, and the matches of their features.
import cv2
import matplotlib
import numpy as np

import tools
from tools import usacv20

parser = tools.arguments(__doc__, "aloeL.jpg", "aloeR.jpg", "walkthrough.png", 1.0)
args = parser.parse_args()
image1, image2 = tools.read_image(args.image1), tools.read_image(args.image2)
points1, points2, ratios = tools.match_with_ratios(image1, image2, args)
print("%d matches; the first: %s and %s" % (len(points1), points1[0], points2[0]))

# %% The fundamental matrix from the same matches, with a flag of OpenCV and with one of this module.
theirs = tools.measure("USAC_MAGSAC", args.runs, lambda: cv2.findFundamentalMat(
    points1, points2, cv2.USAC_MAGSAC, args.threshold, args.confidence, 5000))
ours = tools.measure("USACV20", args.runs, lambda: usacv20.findFundamentalMat(
    points1, points2, usacv20.USACV20, args.threshold, args.confidence, 5000))
tools.print_table(len(points1), [theirs, ours], args.runs)

# %% Params with an option that a flag does not have (scores, here the ratios), and a report.
params = usacv20.Params(threshold=args.threshold, confidence=args.confidence, scores=ratios)
F, mask, report = usacv20.estimateFundamental(points1, points2, params)
print(params)
print(report.describe())
print("stopped by %s; random matches would give as good a model with a probability of at most %.2g" % (
    report.stop.name, report.chance))

# %% A batch: the same pair of images with each of these thresholds, in parallel.
thresholds = [0.5, 1.0, 2.0, 4.0]
found = usacv20.estimateFundamentals([points1] * 4, [points2] * 4, [usacv20.Params(threshold=t) for t in thresholds])
for threshold, result in zip(thresholds, found):
    assert not isinstance(result, Exception)
    print("threshold %.1f: %d inliers" % (threshold, np.count_nonzero(result[1])))

# %% The pictures: the inliers, and the epipolar lines of some inliers.
matplotlib.use("agg")  # draws to a file; without this line, matplotlib draws in a window or in the notebook
from matplotlib import pyplot as plt  # noqa: E402

if F is not None:
    figure, axes = plt.subplots(3, 1, figsize=(10, 12))
    drawings = (("inliers", tools.draw_inliers(image1, image2, points1, points2, mask)),
                ("inliers and their epipolar lines", tools.draw_epipolar_lines(image1, image2, points1, points2, mask, F)))
    for axis, (title, drawing) in zip(axes, drawings):
        axis.imshow(drawing[:, :, ::-1])
        axis.set_title(title)
        axis.axis("off")
    good = mask.ravel() != 0
    axes[2].hist([ratios[good], ratios[~good]], bins=40, label=["inliers", "outliers"], stacked=True)
    axes[2].set_xlabel("ratio of the best and the second best descriptor distance")
    axes[2].legend()
    figure.tight_layout()
    figure.savefig(args.output)
    print("picture: " + args.output)
else:
    raise SystemExit("no model: " + report.describe())
