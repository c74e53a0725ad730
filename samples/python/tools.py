# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Functions that the samples share: they match two images, print a table and draw pictures."""

import argparse
import os
import random
import sys
import time
from typing import Any, Callable, List, Optional, Tuple

import cv2
import numpy as np
import numpy.typing as npt

try:
    import usacv20 as usacv20  # the package, which works with any cv2
except ImportError:
    try:
        from cv2 import usacv20 as usacv20  # type: ignore[no-redef]  # the package of an OpenCV that was built with the module
    except ImportError:
        sys.exit("the package usacv20 is needed: env/bin/pip install --no-build-isolation ./modules/usac, and then env/bin/python3 " + sys.argv[0])

Array = npt.NDArray[Any]
Image = npt.NDArray[Any]  # height x width x 3 uint8

DATA_FOLDERS = (os.environ.get("OPENCV_SAMPLES_DATA_PATH", ""), ".", "/usr/share/doc/opencv-doc/examples/data")


class Result:
    """The result of one method."""

    def __init__(self, method: str, model: Optional[Array], mask: Array, milliseconds: float) -> None:
        self.method, self.model, self.mask, self.milliseconds = method, model, mask, milliseconds
        self.iterations: Any = "-"
        self.error: Optional[float] = None
        self.errorText = "unknown"


def find_file(name: str) -> str:
    """Returns the path of a file. `name` is a path, or the name of a file in OpenCV's sample data.
    Exits the program if there is no such file."""
    for path in [name] + [os.path.join(folder, name) for folder in DATA_FOLDERS]:
        if os.path.isfile(path):
            return path
    sys.exit(name + ": not found; OPENCV_SAMPLES_DATA_PATH can name the folder of OpenCV's sample data")


def read_image(name: str) -> Image:
    image: Optional[Image] = cv2.imread(find_file(name))
    if image is None:
        sys.exit(name + ": not a readable image")
    return image


def arguments(about: Optional[str], image1: Optional[str], image2: str, output: str,
              threshold: float) -> argparse.ArgumentParser:
    """Returns a parser with the options that most samples share."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("image1", nargs="?", default=image1, help="a path or the name of one of OpenCV's sample images")
    parser.add_argument("image2", nargs="?", default=image2)
    parser.add_argument("--ratio", type=float, default=0.8, help="largest ratio of the best and second best descriptor distance")
    parser.add_argument("--features", type=int, default=8000, help="largest number of features per image")
    parser.add_argument("--threshold", type=float, default=threshold, help="inlier threshold in pixels")
    parser.add_argument("--confidence", type=float, default=0.99, help="probability of finding the best model")
    parser.add_argument("--runs", type=int, default=11, help="number of runs; the median time is printed")
    parser.add_argument("--output", default=output, help="picture to write")
    return parser


def _detect(image: Image, features: int) -> Tuple[Any, Array]:
    """Returns keypoints and RootSIFT descriptors, which are square roots of L1-normalized SIFT
    descriptors, so that their Euclidean distance is the Hellinger distance."""
    keypoints, descriptors = cv2.SIFT_create(features).detectAndCompute(image, None)
    if descriptors is None:
        return keypoints, np.empty((0, 128), np.float32)
    return keypoints, np.sqrt(descriptors / np.maximum(descriptors.sum(axis=1, keepdims=True), 1e-9))


def match_with_ratios(image1: Image, image2: Image, args: argparse.Namespace) -> Tuple[Array, Array, Array]:
    """Returns the matched points of both images, N x 2 each, and for each match the ratio of the
    descriptor distances of the best and the second best match, which is below args.ratio."""
    keypoints1, descriptors1 = _detect(image1, args.features)
    keypoints2, descriptors2 = _detect(image2, args.features)
    pairs = cv2.BFMatcher(cv2.NORM_L2).knnMatch(descriptors1, descriptors2, 2)
    good = [pair for pair in pairs if len(pair) == 2 and pair[0].distance < args.ratio * pair[1].distance]
    return (np.array([keypoints1[best.queryIdx].pt for best, _ in good], np.float32).reshape(-1, 2),
            np.array([keypoints2[best.trainIdx].pt for best, _ in good], np.float32).reshape(-1, 2),
            np.array([best.distance / second.distance for best, second in good], np.float32))


def match(image1: Image, image2: Image, args: argparse.Namespace) -> Tuple[Array, Array]:
    """Returns the points of match_with_ratios()."""
    return match_with_ratios(image1, image2, args)[:2]


def flag_of(name: str) -> int:
    """Returns the flag of this name. The functions of usacv20 accept flags of this module and of
    OpenCV."""
    return int(getattr(usacv20 if name.startswith("USACV20") else cv2, name))


def measure(method: str, runs: int, estimate: Callable[[], Any]) -> Result:
    """Runs estimate(), which returns model and mask, `runs` times. Returns the result of the last run,
    with the median time of all runs."""
    times = []
    for _ in range(max(runs, 1)):
        start = time.perf_counter()
        model, mask = estimate()
        times.append(time.perf_counter() - start)
    return Result(method, model, mask, 1e3 * sorted(times)[len(times) // 2])


def usacv20_params(args: argparse.Namespace, iterations: int) -> usacv20.Params:
    """Returns the options that correspond to the flag USACV20 with the same settings."""
    return usacv20.Params(threshold=args.threshold, confidence=args.confidence, maxIterations=iterations)


def print_table(count: int, results: List[Result], runs: int) -> None:
    print("%d matches; time: median of %d runs\n" % (count, runs))
    print("%-14s %-22s %8s %11s %9s" % ("method", "error", "inliers", "iterations", "ms"))
    for r in results:
        inliers = 0 if r.model is None else np.count_nonzero(r.mask)
        error = "no model" if r.model is None else r.errorText
        print("%-14s %-22s %8d %11s %9.2f" % (r.method, error, inliers, r.iterations, r.milliseconds))
    print()


def exit_code(result: Result, limit: float) -> int:
    """Returns 0 if there is a model and its error, if known, is at most the limit; otherwise 1."""
    if result.model is not None and (result.error is None or result.error <= limit):
        return 0
    print("%s: %s" % (result.method, "no model" if result.model is None else "the error is too large"), file=sys.stderr)
    return 1


def failure_limit(image: Image) -> float:
    """Returns the largest error, in pixels, of an estimation that the paper on USACv20 counts as
    successful: 1 % of the diagonal of the image."""
    return 0.01 * float(np.hypot(image.shape[0], image.shape[1]))


def _side_by_side(image1: Image, image2: Image) -> Image:
    canvas = np.full((max(image1.shape[0], image2.shape[0]), image1.shape[1] + image2.shape[1], 3), 255, np.uint8)
    canvas[:image1.shape[0], :image1.shape[1]] = image1
    canvas[:image2.shape[0], image1.shape[1]:] = image2
    gray = cv2.convertScaleAbs(cv2.cvtColor(canvas, cv2.COLOR_BGR2GRAY), alpha=0.7, beta=76)
    result: Image = cv2.cvtColor(gray, cv2.COLOR_GRAY2BGR)
    return result


def _color(k: int) -> Tuple[int, ...]:
    hsv = np.array([[[k * 67 % 180, 255, 220]]], np.uint8)
    return tuple(int(v) for v in cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)[0, 0])


def _place(point: Any) -> Tuple[int, ...]:
    return tuple(int(round(float(v))) for v in point)


def _some_inliers(mask: Array, count: int) -> List[int]:
    inliers = [int(i) for i in np.flatnonzero(mask)]
    random.Random(1).shuffle(inliers)
    return inliers[:count]


def draw_inliers(image1: Image, image2: Image, points1: Array, points2: Array, mask: Array, lines: int = 60) -> Image:
    """Draws the images side by side. All points are dots, green for inliers and red for outliers.
    Lines join the two points of some inliers."""
    canvas = _side_by_side(image1, image2)
    shifted = points2 + np.array([image1.shape[1], 0], np.float32)
    for p, q, inlier in zip(points1, shifted, mask.ravel()):
        for point in (p, q):
            cv2.circle(canvas, _place(point), 2, (0, 150, 0) if inlier else (0, 0, 230), cv2.FILLED, cv2.LINE_AA)
    for k, i in enumerate(_some_inliers(mask, lines)):
        cv2.line(canvas, _place(points1[i]), _place(shifted[i]), _color(k), 1, cv2.LINE_AA)
    return canvas


def _draw_line(image: Image, line: Array, color: Tuple[int, ...]) -> None:
    """Draws the line a x + b y + c = 0 from one border of the image to the opposite border. Draws
    nothing if an end is far outside the image."""
    height, width = image.shape[:2]
    a, b, c = line
    if abs(b) > abs(a):
        ends = [(x, -(c + a * x) / b) for x in (0, width - 1)]
    else:
        ends = [(-(c + b * y) / a, y) for y in (0, height - 1)]
    if np.abs(ends).max() < 1e4:
        cv2.line(image, _place(ends[0]), _place(ends[1]), color, max(1, width // 600), cv2.LINE_AA)


def draw_epipolar_lines(image1: Image, image2: Image, points1: Array, points2: Array, mask: Array, F: Array,
                        lines: int = 24) -> Image:
    """Draws the images side by side with some inliers and their epipolar lines under F."""
    canvas = _side_by_side(image1, image2)
    left = canvas[:image1.shape[0], :image1.shape[1]]
    right = canvas[:image2.shape[0], image1.shape[1]:]
    radius = max(3, image1.shape[1] // 200)
    for k, i in enumerate(_some_inliers(mask, lines)):
        p, q = np.append(points1[i], 1), np.append(points2[i], 1)
        for image, line, point in ((left, F.T @ q, p), (right, F @ p, q)):
            _draw_line(image, line, _color(k))
            cv2.circle(image, _place(point[:2]), radius, _color(k), cv2.FILLED, cv2.LINE_AA)
            cv2.circle(image, _place(point[:2]), radius, (0, 0, 0), 1, cv2.LINE_AA)
    return canvas


def write_picture(file: str, picture: Image, result: Result, what: str) -> None:
    """Writes the picture, at most 1400 pixels wide, with a line of text below it."""
    scale = min(1, 1400 / picture.shape[1])
    picture = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    picture = cv2.copyMakeBorder(picture, 0, 32, 0, 0, cv2.BORDER_CONSTANT, value=(255, 255, 255))
    text = "%s: %d of %d matches are inliers%s" % (result.method, np.count_nonzero(result.mask), len(result.mask), what)
    cv2.putText(picture, text, (8, picture.shape[0] - 11), cv2.FONT_HERSHEY_SIMPLEX, 0.55, (0, 0, 0), 1, cv2.LINE_AA)
    if not cv2.imwrite(file, picture):
        sys.exit(file + ": cannot be written")
    print("picture: " + file)
