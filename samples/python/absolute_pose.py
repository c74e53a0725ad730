#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds the pose of a camera from images of a flat object.

Points of the object's own image become 3-D points (Z = 0), and their matches in the scene are the image
points. usacv20.solvePnPRansac finds the pose, and the axes of the object are drawn into the scene.
The pose of the first scene is the initial model for the second scene. Without images, a synthetic
board and its photographs are made, and the true poses are known.
"""

import argparse
import sys
from typing import Any, List, Optional, Tuple

import cv2
import numpy as np

import tools
from tools import Array, Image, usacv20


def places_in_space(pixels: Array, shape: Tuple[int, ...]) -> Array:
    """Converts pixels of the object's image to 3-D points. The origin is the middle of the object,
    X points to the right, Y up, Z toward the viewer; the width of the object is 1."""
    height, width = shape[:2]
    return np.array([((x - 0.5 * width) / width, (0.5 * height - y) / width, 0) for x, y in pixels], float).reshape(-1, 3)


def corners_of(shape: Tuple[int, ...]) -> Array:
    height, width = shape[:2]
    return np.array([(0, 0), (width, 0), (width, height), (0, height)], np.float32)


def read_camera(args: argparse.Namespace, shape: Tuple[int, ...]) -> Tuple[Array, Optional[Array]]:
    """Returns the camera matrix and the distortion from a file of OpenCV's calibration sample.
    Without a file, the focal length is that of the option --focal or a typical one, and there is no
    distortion."""
    if args.camera:
        storage = cv2.FileStorage(tools.find_file(args.camera), cv2.FILE_STORAGE_READ)
        return storage.getNode("camera_matrix").mat(), storage.getNode("distortion_coefficients").mat()
    focal = args.focal or 1.2 * max(shape[:2])
    return np.array([[focal, 0, (shape[1] - 1) / 2], [0, focal, (shape[0] - 1) / 2], [0, 0, 1]]), None


def pose_of(rvec: Any, tvec: Any) -> Array:
    return np.hstack((cv2.Rodrigues(rvec)[0], np.reshape(tvec, (3, 1))))


def texture(width: int, height: int, seed: int) -> Image:
    """Returns an image with features everywhere: the sum of smooth noise of three scales."""
    rng, image = np.random.RandomState(seed), np.zeros((height, width, 3))
    for step in (4, 12, 36):
        noise = rng.uniform(-1, 1, (height // step + 2, width // step + 2, 3))
        image += cv2.resize(noise, (width, height), interpolation=cv2.INTER_CUBIC)
    result: Image = cv2.normalize(image, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)
    return result


def distort(image: Image, matrix: Array, distortion: Optional[Array]) -> Image:
    """Adds the lens distortion to the image of a pinhole camera."""
    if distortion is None:
        return image
    height, width = image.shape[:2]
    pixels = np.dstack(np.meshgrid(np.arange(width), np.arange(height))).reshape(-1, 1, 2).astype(np.float32)
    places = cv2.undistortPoints(pixels, matrix, distortion, P=matrix).reshape(height, width, 2)
    result: Image = cv2.remap(image, places, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT)
    return result


def photograph(board: Image, rvec: Any, tvec: Any, seed: int, args: argparse.Namespace) -> Tuple[Image, Array]:
    """Renders the board as seen from a pose, partly occluded and in front of a background. Returns
    the image and the true pose."""
    image = texture(640, 480, seed)
    matrix, distortion = read_camera(args, image.shape)
    rvec, tvec = np.float64(rvec), np.float64(tvec)
    corners = corners_of(board.shape)
    seen = cv2.projectPoints(places_in_space(corners, board.shape), rvec, tvec, matrix, None)[0]
    homography = cv2.getPerspectiveTransform(corners, seen.reshape(4, 2).astype(np.float32))
    image = cv2.warpPerspective(board, homography, (640, 480), image, borderMode=cv2.BORDER_TRANSPARENT)
    image = distort(image, matrix, distortion)
    image[300:460, 20:140] = board[:160, :120]  # causes wrong, but consistent matches
    image[150:290, 260:420] = texture(160, 140, seed + 1)
    return image, pose_of(rvec, tvec)


def angle_between(a: Array, b: Array) -> float:
    """Returns the angle of the rotation between two poses in degrees."""
    return float(np.degrees(np.linalg.norm(cv2.Rodrigues(a[:, :3].T.dot(b[:, :3]))[0])))


def estimate(name: str, flag: int, places: Array, pixels: Array, camera: Tuple[Array, Optional[Array]],
             args: argparse.Namespace) -> tools.Result:
    """Estimates the pose with a flag of OpenCV or of this module."""
    def call() -> Tuple[Optional[Array], Array]:
        found, rvec, tvec, inliers = usacv20.solvePnPRansac(
            places, pixels, camera[0], camera[1], iterationsCount=args.iterations, reprojectionError=args.threshold,
            confidence=args.confidence, flags=flag)
        mask = np.zeros((len(pixels), 1), np.uint8)
        if inliers is not None:
            mask[inliers.ravel()] = 1
        return (pose_of(rvec, tvec) if found else None), mask
    return tools.measure(name, args.runs, call)


def estimate_with(name: str, places: Array, pixels: Array, ratios: Array, camera: Tuple[Array, Optional[Array]],
                  before: Optional[Array], args: argparse.Namespace) -> tools.Result:
    """Estimates the pose with options that a flag does not have: the scores of the matches and,
    unless `before` is None, the pose of the previous scene as the initial model."""
    params = tools.usacv20_params(args, args.iterations)
    params.scores = ratios
    if before is not None:
        params.setInitialModel(before)
    result = tools.measure(name, args.runs, lambda: usacv20.estimateAbsolutePose(
        places, pixels, camera[0], camera[1], params)[:2])
    report = usacv20.estimateAbsolutePose(places, pixels, camera[0], camera[1], params)[2]
    result.iterations = report.iterations
    print("%s: %s" % (name, report.describe()))
    return result


def draw(board: Image, image: Image, points: Array, pixels: Array, result: tools.Result,
         camera: Tuple[Array, Optional[Array]]) -> Image:
    """Draws the matches, and the axes and the outline of the object."""
    assert result.model is not None
    canvas = tools.draw_inliers(board, image, points, pixels, result.mask, 30)
    right = np.ascontiguousarray(canvas[:image.shape[0], board.shape[1]:])
    rvec, tvec = cv2.Rodrigues(result.model[:, :3])[0], np.ascontiguousarray(result.model[:, 3:])
    places = places_in_space(corners_of(board.shape), board.shape)
    outline = cv2.projectPoints(places, rvec, tvec, camera[0], camera[1])[0]
    cv2.polylines(right, [outline.round().astype(np.int32)], True, (0, 140, 255), 2, cv2.LINE_AA)
    cv2.drawFrameAxes(right, camera[0], camera[1], rvec, tvec, 0.4, 3)
    canvas[:image.shape[0], board.shape[1]:] = right
    return canvas


def find_pose(board: Image, image: Image, truth: Any, before: Optional[Array],
              args: argparse.Namespace) -> Tuple[tools.Result, Optional[Image]]:
    """Estimates the pose in a scene with several methods and prints a table of the results. Returns
    the result of the last method and its picture, which is None if there is no pose."""
    points, pixels, ratios = tools.match_with_ratios(board, image, args)
    places, camera = places_in_space(points, board.shape), read_camera(args, image.shape)
    results = [estimate(name, flag, places, pixels, camera, args)
               for name, flag in (("ITERATIVE", cv2.SOLVEPNP_ITERATIVE), ("USAC_DEFAULT", cv2.USAC_DEFAULT),
                                  ("USACV20", usacv20.USACV20))]
    results.append(estimate_with("with scores", places, pixels, ratios, camera, None, args))
    if before is not None:
        results.append(estimate_with("with the last", places, pixels, ratios, camera, before, args))
    for result in results:
        if truth is not None and result.model is not None:
            error = result.error = angle_between(result.model, truth)
            result.errorText = "%.2f deg, %.4f" % (error, np.linalg.norm(result.model[:, 3] - truth[:, 3]))
    print("error: angle between the rotations; |t - true t|, in widths of the object")
    tools.print_table(len(pixels), results, args.runs)
    ours = results[-1]
    if ours.model is None:
        return ours, None
    print("[R t] =\n%s\n" % ours.model)
    return ours, draw(board, image, points, pixels, ours, camera)


def main() -> int:
    parser = tools.arguments(__doc__, None, "box_in_scene.png", "absolute_pose_py.jpg", 2.0)
    parser.add_argument("next", nargs="?", help="image of the scene a moment later; the pose in the first scene is its initial model")
    parser.add_argument("--camera", help="file with camera_matrix and distortion_coefficients; none: no distortion; for the focal length, see --focal")
    parser.add_argument("--focal", type=float, help="focal length in pixels, without --camera; none: 1.2 times the longer side")
    parser.add_argument("--iterations", type=int, default=2000, help="largest number of samples")
    args = parser.parse_args()
    if args.image1:
        board = tools.read_image(args.image1)
        scenes: List[Tuple[Image, Optional[Array]]] = [(tools.read_image(name), None) for name in (args.image2, args.next) if name]
    else:
        board = texture(400, 300, 1)
        scenes = [photograph(board, (2.7, 0.3, -0.5), (0.1, 0.02, 2), 2, args),
                  photograph(board, (2.68, 0.34, -0.47), (0.13, 0, 2.05), 4, args)]
    before, code, pictures = None, 0, []
    for image, truth in scenes:
        ours, picture = find_pose(board, image, truth, before, args)
        before = ours.model
        pictures += [] if picture is None else [picture]
        code |= tools.exit_code(ours, 1)
    if pictures:
        width = max(picture.shape[1] for picture in pictures)
        pictures = [cv2.copyMakeBorder(p, 0, 0, 0, width - p.shape[1], cv2.BORDER_CONSTANT, value=(255, 255, 255))
                    for p in pictures]
        tools.write_picture(args.output, np.vstack(pictures), ours, " in the last scene (green); axes: X red, Y green, Z blue")
    return code


if __name__ == "__main__":
    sys.exit(main())
