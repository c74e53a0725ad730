#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes pairs for usac_benchmark from the images and the ground truth of public data sets.

The matches are between RootSIFT features. A feature of image 1 is matched with its nearest neighbor in
image 2 if the ratio of the distances to the nearest and the second nearest neighbor is below a limit.
This ratio is the score of the match. The ground truth consists of points annotated by hand, if the
data set has them, otherwise of those matches that agree with the published homography, epipolar
geometry or poses. No robust estimator is used.
"""

import argparse
import functools
import os
import random
import sys

import cv2
import numpy as np

import geometry
import ground_truth
import pairs

READERS = {"homogr": ground_truth.homogr, "evd": ground_truth.evd, "kusvod2": ground_truth.kusvod2,
           "strecha": ground_truth.strecha, "kitti": ground_truth.kitti, "tum": ground_truth.tum,
           "tanks_and_temples": ground_truth.tanks_and_temples, "cpc": ground_truth.cpc, "1dsfm": ground_truth.one_dsfm}
VIDEOS = ("kitti", "tum")
# Default upper limits of the distance of a right match from the ground truth in pixels: transfer error
# for H, Sampson distance for F and E.
TOLERANCE_H, TOLERANCE_F = 3.0, 1.0


class NoPair(Exception):
    """Raised if two images give no usable pair; the message says why."""


def detect(image, features):
    """Returns the points (N x 2, pixels) and RootSIFT descriptors of at most `features` features.
    RootSIFT descriptors are square roots of L1-normalized SIFT descriptors. OpenCV doubles the image
    for the finest scale. Without the option enable_precise_upscale, which older versions lack, the
    doubling shifts all points by a quarter of a pixel. The shift is undone here, so that the center
    of the first pixel is at (0, 0)."""
    precise = "enable_precise_upscale" in cv2.SIFT_create.__doc__
    sift = cv2.SIFT_create(features, enable_precise_upscale=True) if precise else cv2.SIFT_create(features)
    keypoints, descriptors = sift.detectAndCompute(image, None)
    if descriptors is None:
        return np.empty((0, 2)), np.empty((0, 128), np.float32)
    points = np.array([k.pt for k in keypoints]) - (0 if precise else 0.25)
    return points, np.sqrt(descriptors / np.maximum(descriptors.sum(axis=1, keepdims=True), 1e-9))


@functools.lru_cache(maxsize=64)
def _features_of(file, features):
    """Returns size, points and descriptors of an image file. The results are cached, because most
    images belong to several pairs."""
    # Cameras and poses refer to the image as it is stored, so the orientation in the EXIF data is
    # ignored.
    image = cv2.imread(file, cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)
    if image is None:
        raise NoPair(file + ": no image")
    return (image.shape[1], image.shape[0]), *detect(image, features)


def match(features1, features2, ratio, most):
    """Returns the matched points of both images and the scores, in the order of the features of image
    1. Only matches with a score below `ratio` are kept; if `most` is not 0, only the `most` best of
    these."""
    (points1, descriptors1), (points2, descriptors2) = features1, features2
    if len(descriptors2) < 2 or not len(descriptors1):
        return np.empty((0, 2)), np.empty((0, 2)), np.empty(0)
    found = cv2.BFMatcher(cv2.NORM_L2).knnMatch(descriptors1, descriptors2, 2)
    rows = [(m.queryIdx, m.trainIdx, m.distance / max(n.distance, 1e-9)) for m, n in found]
    rows = np.array([row for row in rows if row[2] < ratio]).reshape(-1, 3)
    if most and len(rows) > most:
        rows = rows[np.sort(np.argsort(rows[:, 2], kind="stable")[:most])]
    return points1[rows[:, 0].astype(int)], points2[rows[:, 1].astype(int)], rows[:, 2]


def _undistort(points, K, distortion):
    """Returns the pixels at which a camera with the same K, but without distortion, would see the
    points. `distortion` is None if the camera has no distortion."""
    if distortion is None or not len(points):
        return points
    return cv2.undistortPoints(points.reshape(-1, 1, 2), K, np.array(distortion, float), P=K).reshape(-1, 2)


def _true_points(truth, points1, points2, known, tolerance):
    """Returns the ground truth of a pair: gt_points and gt_kind, see pairs.Pair. `known` has K1, K2, R
    and t, if the data set has cameras; otherwise it is empty."""
    if truth.points is not None:
        return truth.points, "annotated"
    if truth.H is not None:
        right = geometry.transfer_error(truth.H, points1, points2) < (tolerance or TOLERANCE_H)
        return np.hstack((points1, points2))[right], "homography"
    F = geometry.fundamental(*known.values()) if known else truth.F
    right = geometry.sampson_distance(F, points1, points2) < (tolerance or TOLERANCE_F)
    if known:
        right &= geometry.in_front(*known.values(), points1, points2)
    return np.hstack((points1, points2))[right], "pose"


def build(truth, args):
    """Returns the pair for a Truth. Raises NoPair if an image cannot be read, or if there are too few
    matches or true points."""
    size1, *features1 = _features_of(truth.image1, args.features)
    size2, *features2 = _features_of(truth.image2, args.features)
    points1, points2, scores = match(features1, features2, args.ratio, args.max)
    if len(scores) < max(args.least, 1):
        raise NoPair("%d matches" % len(scores))
    known = {}
    if truth.cameras:
        a, b = truth.cameras
        known = dict(zip(("K1", "K2", "R", "t"), (a.matrix(size1), b.matrix(size2)) + geometry.relative_pose(a, b)))
        points1, points2 = _undistort(points1, known["K1"], a.distortion), _undistort(points2, known["K2"], b.distortion)
    gt_points, kind = _true_points(truth, points1, points2, known, args.tolerance)
    if len(gt_points) < max(args.right, 1):
        raise NoPair("%d of %d matches are right" % (len(gt_points), len(scores)))
    extra = {} if kind == "annotated" else {"gt_thresh_px": args.tolerance or (TOLERANCE_H if truth.H is not None else TOLERANCE_F)}
    return pairs.Pair(truth.problems, points1, points2, scores, size1, size2, gt_points, kind, H=truth.H, extra=extra, **known)


def build_all(dataset, truths, args):
    """Writes the pairs and the lists of a data set; returns the names of the pairs."""
    order = list(range(len(truths)))
    if args.pairs:
        random.Random(args.seed).shuffle(order)
    chosen = []
    for i in order:
        if args.pairs and len(chosen) == args.pairs:
            break
        path = os.path.join(args.out, "pairs", dataset, truths[i].name)
        try:
            pair = build(truths[i], args)
            pairs.write_pair(path, pair)
        except (NoPair, pairs.PairError) as error:
            print("%s: left out: %s" % (truths[i].name, error), file=sys.stderr)
            continue
        print("%s: %d matches, %d points of ground truth" % (truths[i].name, len(pair.scores), len(pair.gt_points)))
        chosen.append(i)
    for problem in pairs.PROBLEMS:
        names = [truths[i].name for i in sorted(chosen) if problem in truths[i].problems]
        if names:
            file = pairs.list_file(args.out, dataset, problem)
            pairs.write_list(file, [os.path.join(args.out, "pairs", dataset, name) for name in names])
            print("%s: %d pairs" % (file, len(names)))
    return [truths[i].name for i in sorted(chosen)]


class _Help(argparse.ArgumentDefaultsHelpFormatter, argparse.RawDescriptionHelpFormatter):
    """Shows default values of options and keeps the line breaks of descriptions."""


def parse(arguments):
    common = argparse.ArgumentParser(add_help=False)
    add = common.add_argument
    for name, what in (("--images", "the data set as it was published"), ("--out", "pairs go to DIR/pairs, lists to DIR/lists")):
        add(name, required=True, default=argparse.SUPPRESS, metavar="DIR", help=what)
    add("--pairs", type=int, default=0, metavar="N", help="number of pairs, chosen at random; 0: all pairs")
    add("--seed", type=int, default=1, help="seed of the random choice of --pairs")
    add("--ratio", type=float, default=0.85,
        help="upper limit of the ratio of the distances to the nearest and the second nearest descriptor")
    add("--max", type=int, default=0, metavar="N",
        help="largest number of matches of a pair; those with the smallest ratios are kept; 0: no limit")
    add("--features", type=int, default=8000, metavar="N", help="largest number of features of an image")
    add("--least", type=int, default=20, metavar="N", help="smallest number of matches; pairs with fewer are left out")
    add("--right", type=int, default=8, metavar="N",
        help="smallest number of points of ground truth; pairs with fewer are left out")
    add("--tolerance", type=float, default=0, metavar="PX",
        help="upper limit of the distance of a right match from the ground truth in pixels; 0: %g for H, %g for F and E" %
        (TOLERANCE_H, TOLERANCE_F))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="dataset", required=True, metavar="DATASET")
    for name, reader in READERS.items():
        command = commands.add_parser(name, parents=[common], description=reader.__doc__, formatter_class=_Help,
                                      help=reader.__doc__.split("\n\n")[0].split(":")[0])
        if name in VIDEOS:
            command.add_argument("--step", type=int, default=1, metavar="N", help="number of frames from image 1 to image 2")
    args = parser.parse_args(arguments)
    if getattr(args, "step", 1) < 1 or min(args.pairs, args.max, args.tolerance) < 0 or args.ratio <= 0:
        parser.error("numbers must not be negative, --step and --ratio not zero")
    return args


def main(arguments=None):
    args = parse(arguments)
    try:
        truths = READERS[args.dataset](args.images, **({"step": args.step} if args.dataset in VIDEOS else {}))
        names = build_all(args.dataset, truths, args)
    except (ground_truth.DataError, pairs.PairError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0 if names else 1


if __name__ == "__main__":
    sys.exit(main())
