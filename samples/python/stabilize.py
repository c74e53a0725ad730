#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Stabilizes a sequence of images: estimates the similarity from each frame to the next, and moves
the frames onto a smooth path.

The frames are the images of a folder or of a video. Without an argument, the frames are windows of
an image along a shaky path, with an independently moving patch in front, and the true motions are
known.
"""

import argparse
import os
import sys
import time
from typing import Any, List, Tuple

import cv2
import numpy as np

import tools
from tools import Array, Image, usacv20


def square(motion: Array) -> Array:
    return np.vstack((motion, (0, 0, 1)))


def read_frames(path: str) -> List[Image]:
    if os.path.isdir(path):
        read = [cv2.imread(os.path.join(path, name)) for name in sorted(os.listdir(path))]
        images = [image for image in read if image is not None]
        return [image for image in images if image.shape == images[0].shape]
    video = cv2.VideoCapture(path)
    frames: List[Image] = []
    while True:
        found, frame = video.read()
        if not found:
            return frames
        frames.append(frame)


def shaken(image: Image, count: int) -> Tuple[List[Image], List[Array]]:
    """Simulates a hand-held camera: frames are windows of the image, with a patch in front that
    moves independently. Returns the frames and the true motions between them."""
    height, width = image.shape[0] * 5 // 8, image.shape[1] * 5 // 8
    patch = image[:height // 2, -(width * 2 // 5):]
    middle, rng = (image.shape[1] / 2, image.shape[0] / 2), np.random.RandomState(1)
    frames, windows = [], []
    for k in range(count):
        window = cv2.getRotationMatrix2D(middle, rng.normal(0, 1.5), 1 + rng.normal(0, 0.01))
        window[:, 2] += rng.normal(0, 6, 2) - (np.array([image.shape[1], image.shape[0]]) * 3 / 16)
        frame = cv2.warpAffine(image, window, (width, height), borderMode=cv2.BORDER_REFLECT)
        x, y = k * (width - patch.shape[1]) // max(count - 1, 1), height // 4
        frame[y:y + patch.shape[0], x:x + patch.shape[1]] = patch
        frames.append(frame)
        windows.append(square(window))
    return frames, [b.dot(np.linalg.inv(a))[:2] for a, b in zip(windows, windows[1:])]


def distance(a: Array, b: Array, shape: Tuple[int, ...]) -> float:
    """Returns the mean distance, in pixels, between the points to which two motions move the corners of a frame."""
    corners = np.array([[x, y, 1] for x in (0, shape[1]) for y in (0, shape[0])], float)
    return float(np.linalg.norm(corners.dot((a - b).T), axis=1).mean())


def estimate(name: str, matches: List[Tuple[Array, Array]], truth: Any, shape: Tuple[int, ...],
             args: argparse.Namespace) -> Tuple[List[Array], float, bool]:
    """Estimates all motions with one method and prints a line of the table. Returns the motions, the
    mean error in pixels (0 if the true motions are unknown), and whether all motions were found."""
    motions, errors, inliers, lost, start = [], [], 0, 0, time.perf_counter()
    for points1, points2 in matches:
        motion, mask = usacv20.estimateAffinePartial2D(points1, points2, None, tools.flag_of(name), args.threshold,
                                                       confidence=args.confidence)
        lost += motion is None
        motions.append(np.eye(2, 3) if motion is None else motion)
        inliers += 0 if mask is None else int(np.count_nonzero(mask))
    elapsed = 1e3 * (time.perf_counter() - start) / len(matches)
    if truth:
        errors = [distance(a, b, shape) for a, b in zip(motions, truth)]
    text = "%.3f, %.3f px" % (np.mean(errors), max(errors)) if truth else "unknown"
    everything = max(sum(len(points1) for points1, _ in matches), 1)
    print("%-10s %-18s %11.1f %6d %11.3f" % (name, text, 100. * inliers / everything, lost, elapsed))
    return motions, float(np.mean(errors)) if truth else 0.0, lost == 0


def corrections(motions: List[Array], shape: Tuple[int, ...], radius: int) -> List[Array]:
    """Returns the transformations that move each frame onto the smooth path, which consists of moving
    averages of the position of the frame's middle (x, y), the angle and the log scale, each over the frame
    itself and `radius` frames before and after it."""
    middle = np.array([shape[1] / 2, shape[0] / 2, 1])
    path, to_first = [np.zeros(4)], np.eye(3)
    for motion in motions:
        to_first = to_first.dot(np.linalg.inv(square(motion)))
        x, y, _ = to_first.dot(middle) - middle
        path.append(np.array([x, y, np.arctan2(to_first[1, 0], to_first[0, 0]), 0.5 * np.log(np.linalg.det(to_first))]))

    def position(x: float, y: float, angle: float, log_scale: float) -> Array:
        result = square(cv2.getRotationMatrix2D((middle[0], middle[1]), np.degrees(-angle), np.exp(log_scale)))
        result[:2, 2] += x, y
        return result

    smooth = [np.mean(path[max(k - radius, 0):k + radius + 1], axis=0) for k in range(len(path))]
    return [np.linalg.inv(position(*b)).dot(position(*a))[:2] for a, b in zip(path, smooth)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("input", nargs="?", help="folder of images, frames in the order of their names, or a video")
    parser.add_argument("--image", default="graf1.png", help="image from which a sequence is made")
    parser.add_argument("--radius", type=int, default=15, help="frames before and after a frame over which the path is averaged")
    parser.add_argument("--threshold", type=float, default=2.0, help="inlier threshold in pixels")
    parser.add_argument("--confidence", type=float, default=0.99, help="probability of finding the best model")
    parser.add_argument("--ratio", type=float, default=0.8, help="largest ratio of the best and second best descriptor distance")
    parser.add_argument("--features", type=int, default=1000, help="largest number of features per frame")
    parser.add_argument("--output", default="stabilize_py.jpg", help="picture to write")
    args = parser.parse_args()
    truth = None
    if args.input:
        frames = read_frames(args.input)
    else:
        frames, truth = shaken(tools.read_image(args.image), 30)
    if len(frames) < 2:
        sys.exit("%s: two images or more are expected" % args.input)
    matches = [tools.match(a, b, args) for a, b in zip(frames, frames[1:])]

    print("%d frames\n\n%-10s %-18s %11s %6s %11s" % (len(frames), "method", "mean, worst error", "inliers %", "lost", "ms/frame"))
    for name in ("RANSAC", "LMEDS", "USACV20"):
        motions, error, found = estimate(name, matches, truth, frames[0].shape, args)
    moves = corrections(motions, frames[0].shape, args.radius)
    size = frames[0].shape[1::-1]
    stable = [cv2.warpAffine(frame, move, size, borderMode=cv2.BORDER_REFLECT) for frame, move in zip(frames, moves)]
    picture = np.hstack([np.mean(frames, axis=0), np.mean(stable, axis=0)]).astype(np.uint8)
    if not cv2.imwrite(args.output, picture):
        sys.exit(args.output + ": cannot be written")
    print("\npicture: %s (mean of all frames: original on the left, stabilized on the right)" % args.output)
    if found and error < 1:
        return 0
    print("USACV20: " + ("the error is too large" if found else "a motion has not been found"), file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
